/* The law with memory: against the law without, against differences, along a cycle. */
#include "check.h"

#include <math.h>
#include <stddef.h>

static asperity_law *law_with_memory(int compiled)
{
   asperity_properties p = wood(compiled);
   asperity_law *law;
   asperity_error error;

   p.unloading = ASPERITY_UNLOADING_ELASTIC;
   CHECK_CODE(asperity_law_new(&law, &p, &error), ASPERITY_OK);
   return law;
}

/* Closer than ever before, the pressure is that without memory, and the work is what is recoverable
 * and what was dissipated. */
static void virgin(void)
{
   enum { n = 5 };
   asperity_law *law = law_with_memory(0), *reversible = wood_law(0);
   asperity_error error;
   const double closest[n] = {0.3, 0.2, 0.1, 0.0, -0.1}, zero[n] = {0.0, 0.0, 0.0, -0.01, -0.02};
   double d[n], p[n], s[n], a[n], c[n], e[n], f[n], q[n], k[n], b[n], g[n], w[n];
   int v[n], i;

   for (i = 0; i < n; i++)
      d[i] = closest[i] + zero[i];
   CHECK_CODE(asperity_law_evaluate_unloading(law, n, closest, zero, p, s, a, c, e, f, v, &error),
              ASPERITY_OK);
   CHECK_CODE(asperity_law_evaluate(reversible, n, d, q, k, b, g, w, NULL, &error), ASPERITY_OK);
   for (i = 0; i < n; i++) {
      CHECK_NEAR(p[i], q[i], 1e-15, 0.0);
      CHECK_NEAR(s[i], k[i], 1e-15, 0.0);
      CHECK_NEAR(a[i], b[i], 1e-15, 0.0);
      CHECK_NEAR(c[i], g[i], 1e-15, 0.0);
      CHECK_NEAR(e[i] + f[i], w[i], 1e-13, 0.0);
      CHECK(e[i] > 0.0 && f[i] > 0.0 && (v[i] & ASPERITY_MEMORY_BEYOND_DATA) == 0);
   }
   asperity_law_free(&law, NULL);
   asperity_law_free(&reversible, NULL);
}

/* First loading is the same law whatever its unloading, compiled as well: bit for bit. */
static void first_loading(void)
{
   enum { n = 5 };
   asperity_error error;
   const double d[n] = {0.3, 0.2, 0.1, 0.0, -0.1};
   double p[2][n], s[2][n], e[2][n];
   int compiled, with_energy, i;

   for (compiled = 0; compiled <= 1; compiled++) {
      asperity_law *laws[2];
      laws[0] = law_with_memory(compiled);
      laws[1] = wood_law(compiled);
      for (with_energy = 0; with_energy <= 1; with_energy++) {
         for (i = 0; i < 2; i++)
            CHECK_CODE(asperity_law_evaluate(laws[i], n, d, p[i], s[i], NULL, NULL,
                                             with_energy ? e[i] : NULL, NULL, &error), ASPERITY_OK);
         for (i = 0; i < n; i++)
            CHECK(p[0][i] == p[1][i] && s[0][i] == s[1][i] && (!with_energy || e[0][i] == e[1][i]));
      }
      for (i = 0; i < 2; i++)
         asperity_law_free(&laws[i], NULL);
   }
}

/* Stiffness is -dp/du and pressure is -de/du at fixed memory, by differences of fourth order. */
static void differences(void)
{
   asperity_law *law = law_with_memory(0);
   asperity_error error;
   const double step = 1e-6;
   double u;

   for (u = 1e-4; u < 8e-3; u *= 1.7) {
      double d[5], r[5], p[5], s[5], e[5];
      int i;
      for (i = 0; i < 5; i++) {
         d[i] = 0.1;
         r[i] = u + (i - 2) * step;
      }
      CHECK_CODE(asperity_law_evaluate_unloading(law, 5, d, r, p, s, NULL, NULL, e, NULL, NULL,
                                                 &error), ASPERITY_OK);
      CHECK_NEAR(-(p[0] - 8.0 * p[1] + 8.0 * p[3] - p[4]) / (12.0 * step), s[2], 1e-7, 0.0);
      CHECK_NEAR(-(e[0] - 8.0 * e[1] + 8.0 * e[3] - e[4]) / (12.0 * step), p[2], 1e-7, 0.0);
   }
   asperity_law_free(&law, NULL);
}

/* Press, part, press harder, part: the work is the change of what is stored and the plastic
 * dissipation, which the trapezoidal rule finds to second order. */
static void cycle(void)
{
   enum { steps = 4000, legs = 4 };
   const double to[legs] = {0.1, 0.02, 0.13, 0.02};
   asperity_law *law = law_with_memory(0);
   asperity_states *states = fresh_states(1);
   asperity_state state;
   asperity_error error;
   double from = 0.0, closure = 0.0, slip[2] = {0.0, 0.0}, t[3], last, first, f, work = 0.0, flat = 0.0;
   int leg, i;

   CHECK_CODE(asperity_states_update(law, states, 1, &closure, slip, NULL, 0.0, t, NULL, NULL, NULL,
                                     &f, NULL, NULL, &error), ASPERITY_OK);
   last = t[0];
   asperity_states_get(states, 0, 1, &state, NULL);
   first = state.normal_energy;
   for (leg = 0; leg < legs; leg++) {
      for (i = 1; i <= steps; i++) {
         double before = closure;
         closure = from + (to[leg] - from) * i / steps;
         if (asperity_states_update(law, states, 1, &closure, slip, NULL, 0.0, t, NULL, NULL, NULL,
                                    &f, NULL, NULL, &error) != ASPERITY_OK)
            break;
         work += 0.5 * (t[0] + last) * (closure - before);
         flat += f;
         last = t[0];
      }
      from = to[leg];
      asperity_states_get(states, 0, 1, &state, NULL);
      CHECK_NEAR(work, state.normal_energy - first + flat, 2e-5, 0.0);
   }
   CHECK(state.largest_closure == 0.13 && state.normal_energy < 1e-3 * flat);
   asperity_states_free(&states, NULL);
   asperity_law_free(&law, NULL);
}

static void refused(void)
{
   enum { n = 2 };
   asperity_law *law = law_with_memory(0), *reversible = wood_law(0);
   asperity_properties properties = wood(0);
   asperity_state state = {ASPERITY_STICK, 0, 0.1, 1.0, 0.0, {0.0, 0.0}, 0.09, 0.0, 0.0, 0.0, 0.0,
                           {{0.0, 0.0}}};
   asperity_states *states = fresh_states(1);
   asperity_error error;
   double d[n] = {0.1, 0.2}, u[n] = {0.001, NAN}, p[n] = {9.0, 9.0}, s[n] = {9.0, 9.0};

#define EVALUATE(law, n, d, u, p, s) \
   asperity_law_evaluate_unloading(law, n, d, u, p, s, NULL, NULL, NULL, NULL, NULL, &error)
   CHECK_CODE(EVALUATE(law, n, d, u, p, s), ASPERITY_BAD_INPUT);
   CHECK_MESSAGE("retraction of point 1 = NaN");
   u[1] = 1e37;
   CHECK_CODE(EVALUATE(law, n, d, u, p, s), ASPERITY_BAD_INPUT);
   u[1] = 0.001;
   CHECK_CODE(EVALUATE(law, n, NULL, u, p, s), ASPERITY_NULL_ARGUMENT);
   CHECK_MESSAGE("closest_separation is NULL");
   CHECK_CODE(EVALUATE(law, n, d, NULL, p, s), ASPERITY_NULL_ARGUMENT);
   CHECK_CODE(EVALUATE(law, n, d, u, NULL, s), ASPERITY_NULL_ARGUMENT);
   CHECK_CODE(EVALUATE(law, n, d, u, p, NULL), ASPERITY_NULL_ARGUMENT);
   CHECK_CODE(EVALUATE(law, n, d, u, p, u), ASPERITY_BAD_INPUT);
   CHECK_MESSAGE("overlap");
   CHECK_CODE(EVALUATE(NULL, n, d, u, p, s), ASPERITY_NULL_ARGUMENT);
   CHECK_CODE(EVALUATE(law, -1, d, u, p, s), ASPERITY_WRONG_LENGTH);
   CHECK_CODE(EVALUATE(reversible, n, d, u, p, s), ASPERITY_BAD_INPUT);
   CHECK_MESSAGE("unloading of the law is reversible");
   CHECK(p[0] == 9.0 && p[1] == 9.0 && s[0] == 9.0 && s[1] == 9.0);
   CHECK_CODE(EVALUATE(law, 0, NULL, NULL, NULL, NULL), ASPERITY_OK);
   CHECK_CODE(EVALUATE(law, n, d, u, p, s), ASPERITY_OK);
   CHECK(p[0] > p[1] && p[1] > 0.0 && s[0] > s[1]);

   asperity_law_free(&reversible, NULL);
   properties.unloading = 2;
   CHECK_CODE(asperity_law_new(&reversible, &properties, &error), ASPERITY_BAD_INPUT);
   CHECK_MESSAGE("unloading = 2 is unknown");
   properties.unloading = ASPERITY_UNLOADING_ELASTIC;
   properties.yield_factor = 0.19;
   CHECK_CODE(asperity_law_new(&reversible, &properties, &error), ASPERITY_BAD_INPUT);
   CHECK_MESSAGE("yield_factor = 0.19 is not allowed with elastic unloading");

   CHECK_CODE(asperity_states_set(states, 0, 1, &state, &error), ASPERITY_BAD_INPUT);
   CHECK_MESSAGE("largest_closure = 0.09 mm of state[0] is not allowed");
   state.largest_closure = 0.1;
   CHECK_CODE(asperity_states_set(states, 0, 1, &state, &error), ASPERITY_OK);
   asperity_states_free(&states, NULL);
   asperity_law_free(&law, NULL);
}

void test_unloading(void)
{
   virgin();
   first_loading();
   differences();
   cycle();
   refused();
}
