/* Numbers that are refused: not finite, absurd, out of range. Nothing changes after an error. */
#include "check.h"

#include <float.h>
#include <math.h>
#include <stddef.h>
#include <string.h>

static asperity_error error;

/* What must be refused wherever a finite number is asked for; the first two are no numbers. */
static double bad(int i)
{
   static const double large[3] = {1e301, -1e301, DBL_MAX};
   return i == 0 ? (double)NAN : i == 1 ? (double)INFINITY : i == 2 ? -(double)INFINITY
                                                                     : large[i - 3];
}
enum { n_bad = 6 };

static void refused(asperity_properties p, const char *text)
{
   asperity_law *law;
   CHECK_CODE(asperity_law_new(&law, &p, &error), ASPERITY_BAD_INPUT);
   CHECK_MESSAGE(text);
   CHECK(law == NULL);
}

static void properties(void)
{
   /* Where each real member is, and its name */
   static const struct {
      size_t offset;
      const char *name;
   } reals[] = {
      {offsetof(asperity_properties, eta), "eta = "},
      {offsetof(asperity_properties, modulus), "modulus = "},
      {offsetof(asperity_properties, radius), "radius = "},
      {offsetof(asperity_properties, hardness), "hardness = "},
      {offsetof(asperity_properties, yield_factor), "yield_factor = "},
      {offsetof(asperity_properties, sigma), "sigma = "},
      {offsetof(asperity_properties, friction_coefficient), "friction_coefficient = "},
      {offsetof(asperity_properties, critical_slip), "critical_slip = "},
      {offsetof(asperity_properties, initial_separation), "initial_separation = "},
   };
   asperity_properties p;
   asperity_law *law;
   size_t i;
   int k;

   for (i = 0; i < sizeof reals / sizeof *reals; i++) {
      for (k = 0; k < n_bad; k++) {
         double value = bad(k);
         p = wood(k % 2);
         memcpy((char *)&p + reals[i].offset, &value, sizeof value);
         refused(p, reals[i].name);
      }
      if (i < 8) {
         const double negative = -1.0;
         p = wood(0);
         memcpy((char *)&p + reals[i].offset, &negative, sizeof negative);
         refused(p, reals[i].name);
      }
   }
   /* a property that was forgotten is named */
   asperity_properties_init(&p, sizeof p, NULL);
   refused(p, "eta = NaN");
   p = wood(0);
   p.friction_rule = 0;
   refused(p, "friction_rule = 0");
   p = wood(0);
   p.slip_integration = 3;
   refused(p, "slip_integration = 3");
   p = wood(0);
   p.accept_unphysical = 2;
   refused(p, "accept_unphysical = 2");
   p = wood(0);
   p.compiled = -1;
   refused(p, "compiled = -1");

   /* the longest message of the library is not cut */
   p = wood(0);
   p.eta = 0.00020612345678901234;
   p.sigma = 5.9300000000000123e-20;
   p.radius = 1.4770000000000123e-15;
   refused(p, "set accept_unphysical");
   CHECK(strlen(error.message) < sizeof error.message - 1);
   CHECK(strstr(error.message, "...") == NULL);
   p.accept_unphysical = 1;
   CHECK_CODE(asperity_law_new(&law, &p, &error), ASPERITY_OK);
   asperity_law_free(&law, NULL);

   /* zero, negative and the default datum are let pass */
   for (k = 0; k < 3; k++) {
      p = wood(0);
      p.initial_separation = k == 0 ? 0.0 : k == 1 ? -0.1 : ASPERITY_FOUR_SIGMA;
      CHECK_CODE(asperity_law_new(&law, &p, &error), ASPERITY_OK);
      asperity_law_free(&law, NULL);
   }
}

static void separations(int compiled)
{
   asperity_law *law = wood_law(compiled);
   double d[7] = {0.1, 0.1, 0.1, 0.1, 0.1, 0.1, 0.1}, p[7], s[7], e[7], kept;
   int k, i;

   for (k = 0; k < n_bad; k++) {
      for (i = 0; i < 7; i += 3) {
         char text[40] = "separation of point 0 = ";
         text[20] = (char)('0' + i);
         memset(p, 0, sizeof p);
         kept = d[i];
         d[i] = bad(k);
         CHECK_CODE(asperity_law_evaluate(law, 7, d, p, s, NULL, NULL, e, NULL, &error),
                    ASPERITY_BAD_INPUT);
         CHECK_MESSAGE(text);
         CHECK(p[0] == 0.0);
         CHECK_CODE(asperity_law_evaluate(law, 7, d, p, s, NULL, NULL, NULL, NULL, &error),
                    ASPERITY_BAD_INPUT);
         d[i] = kept;
      }
      /* the last but one is negative; no separation that is searched gives the other two */
      p[0] = 9.0;
      CHECK_CODE(asperity_law_separation(law, bad(k), p, &error), ASPERITY_BAD_INPUT);
      CHECK_MESSAGE("pressure = ");
      CHECK(p[0] == 9.0);
   }
   CHECK_CODE(asperity_law_separation(law, 0.0, p, &error), ASPERITY_BAD_INPUT);
   CHECK_CODE(asperity_law_separation(law, -1.0, p, &error), ASPERITY_BAD_INPUT);
   /* the largest that is let pass gives finite numbers, at both ends */
   for (k = 0; k < 7; k++)
      d[k] = k % 2 == 0 ? 1e36 : -1e36;
   CHECK_CODE(asperity_law_evaluate(law, 7, d, p, s, NULL, NULL, e, NULL, &error), ASPERITY_OK);
   CHECK(p[0] == 0.0 && s[0] == 0.0 && e[0] == 0.0);
   CHECK(isfinite(p[1]) && p[1] > 1e30 && isfinite(s[1]) && isfinite(e[1]));
   d[3] = nextafter(1e36, 2e36);
   CHECK_CODE(asperity_law_evaluate(law, 7, d, p, s, NULL, NULL, e, NULL, &error),
              ASPERITY_BAD_INPUT);
   asperity_law_free(&law, NULL);
}

static void motions(int compiled)
{
   enum { n = 2 };
   asperity_law *law = wood_law(compiled);
   asperity_states *states = fresh_states(n);
   asperity_state state;
   /* overclosure, slip_increment and rotation in one list of numbers */
   static const double good[7 * n] = {0.1, 0.12, 0.1, 0.2, 0.3, 0.4, 1.0, 1.0, 0.0, 0.0, 0.0, 0.0,
                                      1.0, 1.0};
   double motion[7 * n], t[3 * n];
   int k, i;

   for (k = 0; k < n_bad; k++) {
      for (i = 0; i < 7 * n; i++) {
         memcpy(motion, good, sizeof good);
         motion[i] = bad(k);
         t[0] = 9.0;
         CHECK_CODE(asperity_states_update(law, states, n, motion, motion + n, motion + 3 * n, 0.0,
                                           t, NULL, NULL, NULL, NULL, NULL, NULL, &error),
                    ASPERITY_BAD_INPUT);
         CHECK_MESSAGE(i < n ? "overclosure of point" : i < 3 * n ? "slip_increment of point"
                                                                  : "rotation of point");
         CHECK_MESSAGE(i % 2 == 0 ? "point 0" : "point 1");
         CHECK(t[0] == 9.0);
      }
   }
   asperity_states_get(states, 0, 1, &state, NULL);
   CHECK(state.status == ASPERITY_UNSET);
   /* the largest that is let pass, many times over, stays finite */
   for (i = 0; i < 50; i++) {
      memcpy(motion, good, sizeof good);
      motion[0] = i % 3 == 0 ? 1e36 : -1e36;
      motion[1] = i % 2 == 0 ? 1e36 : 0.1;
      motion[2] = 1e30;
      motion[3] = -1e30;
      motion[6] = 1e30;
      CHECK_CODE(asperity_states_update(law, states, n, motion, motion + n, motion + 3 * n, 0.0, t,
                                        NULL, NULL, NULL, NULL, NULL, NULL, &error), ASPERITY_OK);
      CHECK(isfinite(t[0]) && isfinite(t[1]) && isfinite(t[2 * n]) && isfinite(t[2 * n + 1]));
      /* and what an update leaves behind may be set again */
      asperity_states_get(states, i % 2, 1, &state, NULL);
      CHECK_CODE(asperity_states_set(states, i % 2, 1, &state, &error), ASPERITY_OK);
   }
   asperity_states_free(&states, NULL);
   asperity_law_free(&law, NULL);
}

static void states_refused(void)
{
   static const size_t reals[] = {
      offsetof(asperity_state, overclosure), offsetof(asperity_state, pressure),
      offsetof(asperity_state, normal_energy), offsetof(asperity_state, elastic_slip),
      offsetof(asperity_state, elastic_slip) + sizeof(double),
      offsetof(asperity_state, largest_closure), offsetof(asperity_state, dissipation),
      offsetof(asperity_state, pressure_coupling)
   };
   static const char *const names[] = {"overclosure", "pressure", "normal_energy",
                                       "elastic_slip[0]", "elastic_slip[1]", "largest_closure",
                                       "dissipation", "pressure_coupling"};
   static const int wrong_status[] = {-1, 4, 1000000000}, wrong_flags[] = {-1, 256, -2147483647};
   asperity_states *states = fresh_states(1);
   asperity_state zero, state;
   size_t i;
   int k;

   memset(&zero, 0, sizeof zero);
   for (i = 0; i < sizeof reals / sizeof *reals; i++) {
      for (k = 0; k < n_bad; k++) {
         double value = bad(k);
         state = zero;
         memcpy((char *)&state + reals[i], &value, sizeof value);
         CHECK_CODE(asperity_states_set(states, 0, 1, &state, &error), ASPERITY_BAD_INPUT);
         CHECK_MESSAGE(names[i]);
      }
   }
   state = zero;
   state.pressure = -1e-300;
   CHECK_CODE(asperity_states_set(states, 0, 1, &state, &error), ASPERITY_BAD_INPUT);
   CHECK_MESSAGE("pressure = -1.0E-300");
   for (k = 0; k < 3; k++) {
      state = zero;
      state.status = wrong_status[k];
      CHECK_CODE(asperity_states_set(states, 0, 1, &state, &error), ASPERITY_BAD_INPUT);
      CHECK_MESSAGE("status = ");
      state = zero;
      state.validity = wrong_flags[k];
      CHECK_CODE(asperity_states_set(states, 0, 1, &state, &error), ASPERITY_BAD_INPUT);
      CHECK_MESSAGE("validity = ");
   }
   asperity_states_get(states, 0, 1, &state, NULL);
   CHECK(memcmp(&state, &zero, sizeof state) == 0);
   asperity_states_free(&states, NULL);
}

void test_values(void)
{
   properties();
   separations(0);
   separations(1);
   motions(0);
   motions(1);
   states_refused();
}
