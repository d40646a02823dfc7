/* Friction beyond one coefficient, summits that stick each for itself, the law's own numbers: bit by
 * bit what the library gives in Fortran, a restart in the middle, and what is refused. */
#include "check.h"

#include <math.h>
#include <stddef.h>
#include <string.h>

enum { kinds = 6, steps = 60 };

void advance_in_fortran(int kind, int count, const double *overclosure, const double *slip,
                        const double *rotation, const double *time_increment, double *traction);

/* Each member by its name; fortran_twin.f90 has the same kinds. */
static asperity_law *law_of(int kind)
{
   asperity_properties p = wood(0), q;
   asperity_law *law;
   asperity_error error;

   p.friction_rule = ASPERITY_RULE_DISSIPATIVE;
   switch (kind) {
   case 0:
      p.plastic_ratio = 54.0;
      p.height_distribution = ASPERITY_HEIGHTS_JOHNSON;
      p.skewness = 0.3;
      p.kurtosis = 3.61;
      break;
   case 1:
      p.static_friction_coefficient = 0.75;
      p.decay_slip = 0.125;
      p.decay_slip_rate = 2.0;
      break;
   case 2:
      p.friction_coefficient_across = 0.25;
      p.grain_angle = 30.0;
      p.slip_direction = ASPERITY_SLIP_OF_STRESS;
      break;
   case 3:
      p.pressure_exponent = -0.25;
      p.reference_pressure = 2.0;
      p.shear_limit = 0.5;
      break;
   case 4:
      p.friction_points = 2;
      p.friction_pressures[0] = 0.125;
      p.friction_pressures[1] = 1.5;
      p.friction_factors[0] = 1.25;
      p.friction_factors[1] = 0.5;
      break;
   default:
      p.stick = ASPERITY_STICK_SUMMITS;
      p.stick_elements = 6;
      p.shear_modulus = 31.6;
   }
   CHECK_CODE(asperity_law_new(&law, &p, &error), ASPERITY_OK);
   /* each member comes back */
   CHECK_CODE(asperity_law_properties(law, &q, sizeof q, &error), ASPERITY_OK);
   CHECK(q.plastic_ratio == p.plastic_ratio && q.height_distribution == p.height_distribution);
   CHECK(q.skewness == p.skewness && q.kurtosis == p.kurtosis);
   CHECK(q.static_friction_coefficient == p.static_friction_coefficient);
   CHECK(q.decay_slip == p.decay_slip && q.decay_slip_rate == p.decay_slip_rate);
   CHECK(q.friction_coefficient_across == p.friction_coefficient_across);
   CHECK(q.grain_angle == p.grain_angle && q.slip_direction == p.slip_direction);
   CHECK(q.pressure_exponent == p.pressure_exponent && q.shear_limit == p.shear_limit);
   CHECK(q.reference_pressure == p.reference_pressure && q.stick == p.stick);
   CHECK(q.stick_elements == p.stick_elements && q.shear_modulus == p.shear_modulus);
   CHECK(q.friction_points == p.friction_points);
   CHECK(memcmp(q.friction_pressures, p.friction_pressures, sizeof p.friction_pressures) == 0);
   CHECK(memcmp(q.friction_factors, p.friction_factors, sizeof p.friction_factors) == 0);
   return law;
}

static void twin(int kind)
{
   asperity_law *law = law_of(kind);
   asperity_states *states = fresh_states(1), *other = fresh_states(1), *third = fresh_states(1);
   asperity_state state, again;
   asperity_error error;
   double closure[steps], slip[steps][2], rotation[steps][2][2], time[steps], expected[steps][3];
   double t[3], r[2][2];
   int i, differ = 0, sheared = 0;

   for (i = 0; i < steps; i++) {
      double angle = 0.1 * (i % 5 - 2);
      closure[i] = 0.02 + 0.013 * (i * 7 % 10);
      slip[i][0] = 0.08 * (i % 7 - 3);
      slip[i][1] = 0.05 * (i % 4 - 1);
      rotation[i][0][0] = rotation[i][1][1] = cos(angle);
      rotation[i][0][1] = sin(angle);
      rotation[i][1][0] = -sin(angle);
      time[i] = i % 6 == 0 ? 0.0 : 0.02 * (i % 6);
   }
   advance_in_fortran(kind, steps, closure, slip[0], rotation[0][0], time, expected[0]);
   for (i = 0; i < steps; i++) {
      memcpy(r, rotation[i], sizeof r);
      CHECK_CODE(asperity_states_update(law, states, 1, &closure[i], slip[i], r[0], time[i], t, NULL,
                                        NULL, NULL, NULL, NULL, NULL, &error), ASPERITY_OK);
      differ += memcmp(t, expected[i], sizeof t) != 0;
      sheared += t[1] != 0.0;
      /* half of the way a restart from the struct, then one from a copy */
      CHECK_CODE(asperity_states_get(states, 0, 1, &state, &error), ASPERITY_OK);
      if (i == steps / 2) {
         CHECK_CODE(asperity_states_set(other, 0, 1, &state, &error), ASPERITY_OK);
         CHECK_CODE(asperity_states_copy(states, third, &error), ASPERITY_OK);
      } else if (i > steps / 2) {
         CHECK_CODE(asperity_states_update(law, other, 1, &closure[i], slip[i], r[0], time[i], t,
                                           NULL, NULL, NULL, NULL, NULL, NULL, &error),
                    ASPERITY_OK);
         differ += memcmp(t, expected[i], sizeof t) != 0;
         CHECK_CODE(asperity_states_update(law, third, 1, &closure[i], slip[i], r[0], time[i], t,
                                           NULL, NULL, NULL, NULL, NULL, NULL, &error),
                    ASPERITY_OK);
         differ += memcmp(t, expected[i], sizeof t) != 0;
         asperity_states_get(other, 0, 1, &again, NULL);
         differ += memcmp(&state, &again, sizeof state) != 0;
      }
   }
   CHECK(differ == 0);
   CHECK(sheared > steps / 2);
   CHECK((state.motion_share != 0.0) == (kind == 1));
   CHECK((state.summit_slip[5][0] != 0.0) == (kind == 5) && state.summit_slip[6][0] == 0.0);
   /* a fresh state copied over it forgets */
   asperity_states_free(&third, NULL);
   third = fresh_states(1);
   CHECK_CODE(asperity_states_copy(third, states, &error), ASPERITY_OK);
   asperity_states_get(states, 0, 1, &state, NULL);
   asperity_states_get(third, 0, 1, &again, NULL);
   CHECK(memcmp(&state, &again, sizeof state) == 0);
   asperity_states_free(&states, NULL);
   asperity_states_free(&other, NULL);
   asperity_states_free(&third, NULL);
   asperity_law_free(&law, NULL);
}

/* Decay by rate at steady slip: mu p + (mu_s - mu) p exp(-rate/decay_slip_rate); without a time
 * nothing decays. */
static void rate(void)
{
   asperity_properties p = wood(0);
   asperity_law *law;
   asperity_states *states = fresh_states(1);
   asperity_error error;
   double closure = 0.1, slip[2] = {2.0, 0.0}, t[3];
   const double bad[3] = {-1e-300, NAN, 1e31};
   int i;

   p.static_friction_coefficient = 0.8;
   p.decay_slip_rate = 10.0;
   CHECK_CODE(asperity_law_new(&law, &p, &error), ASPERITY_OK);
#define UPDATE(time) \
   asperity_states_update(law, states, 1, &closure, slip, NULL, time, t, NULL, NULL, NULL, NULL, \
                          NULL, NULL, &error)
   CHECK_CODE(UPDATE(0.1), ASPERITY_OK);
   CHECK_NEAR(t[1], (0.5 + 0.3 * exp(-2.0)) * t[0], 1e-14, 0.0);
   CHECK_CODE(UPDATE(0.0), ASPERITY_OK);
   CHECK_NEAR(t[1], 0.8 * t[0], 1e-14, 0.0);
   for (i = 0; i < 3; i++) {
      t[0] = 9.0;
      CHECK_CODE(UPDATE(bad[i]), ASPERITY_BAD_INPUT);
      CHECK_MESSAGE("time_increment = ");
      CHECK(t[0] == 9.0);
   }
   asperity_states_free(&states, NULL);
   asperity_law_free(&law, NULL);
}

static void refused(void)
{
   asperity_properties p = wood(0);
   asperity_law *law;
   asperity_state state;
   asperity_states *states = fresh_states(1);
   asperity_error error;

#define REFUSED(member, value, text) \
   p = wood(0); \
   p.member = value; \
   CHECK_CODE(asperity_law_new(&law, &p, &error), ASPERITY_BAD_INPUT); \
   CHECK(law == NULL); \
   CHECK_MESSAGE(text)
   REFUSED(plastic_ratio, 9.0, "plastic_ratio = 9");
   REFUSED(plastic_ratio, NAN, "plastic_ratio = NaN");
   REFUSED(height_distribution, 2, "height_distribution = 2 is unknown");
   REFUSED(static_friction_coefficient, 0.4, "static_friction_coefficient = 0.4");
   REFUSED(decay_slip, -1.0, "decay_slip = -1");
   REFUSED(decay_slip_rate, NAN, "decay_slip_rate = NaN");
   REFUSED(friction_coefficient_across, -0.1, "friction_coefficient_across = -0.1");
   REFUSED(grain_angle, 400.0, "grain_angle = 400");
   REFUSED(slip_direction, 2, "slip_direction = 2 is unknown");
   REFUSED(pressure_exponent, -1.0, "pressure_exponent = -1");
   REFUSED(pressure_exponent, 0.5, "reference_pressure");
   REFUSED(shear_limit, -1.0, "shear_limit = -1");
   REFUSED(stick, 2, "stick = 2 is unknown");
   REFUSED(stick, ASPERITY_STICK_SUMMITS, "needs shear_modulus");
   REFUSED(friction_points, 9, "friction_points = 9");
   REFUSED(friction_points, -1, "friction_points = -1");
   REFUSED(friction_points, 1, "of friction_points");

   memset(&state, 0, sizeof state);
   state.motion_share = 1.5;
   CHECK_CODE(asperity_states_set(states, 0, 1, &state, &error), ASPERITY_BAD_INPUT);
   CHECK_MESSAGE("motion_share = 1.5");
   state.motion_share = -0.5;
   CHECK_CODE(asperity_states_set(states, 0, 1, &state, &error), ASPERITY_BAD_INPUT);
   CHECK_MESSAGE("motion_share = -0.5");
   state.motion_share = 0.5;
   state.summit_slip[3][1] = NAN;
   CHECK_CODE(asperity_states_set(states, 0, 1, &state, &error), ASPERITY_BAD_INPUT);
   CHECK_MESSAGE("summit_slip[3][1] = NaN");
   state.summit_slip[3][1] = 0.0;
   state.grain_turn = INFINITY;
   CHECK_CODE(asperity_states_set(states, 0, 1, &state, &error), ASPERITY_BAD_INPUT);
   CHECK_MESSAGE("grain_turn = Inf");
   asperity_states_free(&states, NULL);
}

void test_friction(void)
{
   int kind;

   for (kind = 0; kind < kinds; kind++)
      twin(kind);
   rate();
   refused();
}
