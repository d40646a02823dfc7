/* The contact-point update: layout of the arrays, friction, energies and the tangent. */
#include "check.h"

#include <math.h>
#include <stddef.h>
#include <string.h>

enum { points = 3 };

typedef struct result {
   double traction[3][points], tangent[3][3][points];
   double energy[points], dissipation[points], plastic[points], coupling[points];
   int validity[points];
} result;

static int update(const asperity_law *law, asperity_states *states, double closure[points],
                  double slip[2][points], const double *rotation, result *r, asperity_error *error)
{
   return asperity_states_update(law, states, points, closure, slip[0], rotation, 0.0,
                                 r->traction[0], r->tangent[0][0], r->energy, r->dissipation,
                                 r->plastic, r->coupling, r->validity, error);
}

/* Three different points in one call give, bit by bit, what each gives alone. */
static void layout(int compiled)
{
   asperity_law *law = wood_law(compiled);
   asperity_states *all = fresh_states(points);
   asperity_error error;
   double closure[points] = {0.11, 0.14, -0.2};
   double slip[2][points] = {{0.05, 0.4, 0.3}, {-0.02, 0.7, 0.1}};
   double turn[2][2][points] = {{{0.8, 0.6, 1.0}, {0.6, -0.8, 0.0}},
                                {{-0.6, 0.8, 0.0}, {0.8, 0.6, 1.0}}};
   result r;
   int step, i, row, column;

   for (step = 0; step < 3; step++) {
      asperity_states *before = fresh_states(points);
      CHECK_CODE(asperity_states_copy(all, before, &error), ASPERITY_OK);
      CHECK_CODE(update(law, all, closure, slip, turn[0][0], &r, &error), ASPERITY_OK);
      for (i = 0; i < points; i++) {
         asperity_states *one = fresh_states(1);
         asperity_state state, expected;
         double s[2], t[3], k[3][3], q[2][2], e, d, f, c;
         int v;
         for (row = 0; row < 2; row++) {
            s[row] = slip[row][i];
            for (column = 0; column < 2; column++)
               q[column][row] = turn[column][row][i];
         }
         asperity_states_get(before, i, 1, &state, NULL);
         asperity_states_set(one, 0, 1, &state, NULL);
         CHECK_CODE(asperity_states_update(law, one, 1, &closure[i], s, q[0], 0.0, t, k[0], &e, &d,
                                           &f, &c, &v, &error), ASPERITY_OK);
         asperity_states_get(one, 0, 1, &expected, NULL);
         asperity_states_get(all, i, 1, &state, NULL);
         CHECK(memcmp(&state, &expected, sizeof state) == 0);
         CHECK(e == r.energy[i] && d == r.dissipation[i] && c == r.coupling[i]);
         CHECK(f == r.plastic[i]);
         CHECK(v == r.validity[i]);
         for (row = 0; row < 3; row++) {
            CHECK(t[row] == r.traction[row][i]);
            for (column = 0; column < 3; column++)
               CHECK(k[column][row] == r.tangent[column][row][i]);
         }
         asperity_states_free(&one, NULL);
      }
      asperity_states_free(&before, NULL);
   }
   asperity_states_free(&all, NULL);
   asperity_law_free(&law, NULL);
}

/* The pressure is the law's, slip far past gcrit gives mu p in its direction, and a point without
 * opposite surface bears nothing. */
static void plateau(int compiled)
{
   asperity_law *law = wood_law(compiled);
   asperity_states *states = fresh_states(points);
   asperity_error error;
   double closure[points] = {0.1, 0.13, ASPERITY_NO_OPPOSITE_SURFACE};
   double slip[2][points] = {{3.0, 0.0, 1.0}, {4.0, -9.0, 0.0}};
   double d[2], p[2], s[2];
   asperity_state state;
   result r;
   int i;

   for (i = 0; i < 2; i++)
      d[i] = 4.0 * 0.0593 - closure[i];
   CHECK_CODE(asperity_law_evaluate(law, 2, d, p, s, NULL, NULL, NULL, NULL, &error), 0);
   CHECK_CODE(update(law, states, closure, slip, NULL, &r, &error), ASPERITY_OK);
   for (i = 0; i < 2; i++) {
      CHECK_NEAR(r.traction[0][i], p[i], 1e-14, 0.0);
      CHECK_NEAR(r.tangent[0][0][i], s[i], 1e-14, 0.0);
   }
   /* some roundings: 1e-14 */
   CHECK_NEAR(r.traction[1][0], 0.5 * p[0] * 0.6, 1e-14, 0.0);
   CHECK_NEAR(r.traction[2][0], 0.5 * p[0] * 0.8, 1e-14, 0.0);
   CHECK_NEAR(r.traction[1][1], 0.0, 1e-14, 1.0);
   CHECK_NEAR(r.traction[2][1], -0.5 * p[1], 1e-14, 0.0);
   CHECK(r.traction[0][2] == 0.0 && r.traction[1][2] == 0.0 && r.traction[2][2] == 0.0);
   asperity_states_get(states, 0, 1, &state, NULL);
   CHECK(state.status == ASPERITY_SLIP);
   CHECK_NEAR(hypot(state.elastic_slip[0], state.elastic_slip[1]), 0.31, 1e-14, 0.0);
   /* all motion but the elastic slip dissipates: mu p (5 - gcrit) */
   CHECK_NEAR(r.dissipation[0], 0.5 * p[0] * (5.0 - 0.31), 1e-13, 0.0);
   CHECK_NEAR(r.energy[0], 0.5 * 0.5 * p[0] * 0.31, 1e-14, 0.0);
   asperity_states_get(states, 2, 1, &state, NULL);
   CHECK(state.status == ASPERITY_OPEN);
   CHECK(state.overclosure == ASPERITY_NO_OPPOSITE_SURFACE);
   asperity_states_free(&states, NULL);
   asperity_law_free(&law, NULL);
}

/* Two half increments of slip equal one, at constant pressure and exact integration; with backward
 * Euler they do not, which shows that the member of the struct arrives. */
static void halves(void)
{
   int integration;
   for (integration = 1; integration <= 2; integration++) {
      asperity_properties p = wood(0);
      asperity_law *law;
      asperity_states *one = fresh_states(points), *two = fresh_states(points);
      asperity_error error;
      double closure[points] = {0.1, 0.12, 0.14};
      double first[2][points] = {{0.2, 0.3, -0.1}, {0.1, 0.0, 0.2}};
      double whole[2][points] = {{-0.3, 0.1, 0.4}, {0.5, 0.4, -0.4}}, half[2][points];
      result r, s;
      double apart = 0.0, off;
      int i, c;

      p.slip_integration = integration;
      CHECK_CODE(asperity_law_new(&law, &p, &error), ASPERITY_OK);
      for (c = 0; c < 2; c++)
         for (i = 0; i < points; i++)
            half[c][i] = 0.5 * whole[c][i];
      CHECK_CODE(update(law, one, closure, first, NULL, &r, &error), ASPERITY_OK);
      CHECK_CODE(asperity_states_copy(one, two, &error), ASPERITY_OK);
      CHECK_CODE(update(law, one, closure, whole, NULL, &r, &error), ASPERITY_OK);
      CHECK_CODE(update(law, two, closure, half, NULL, &s, &error), ASPERITY_OK);
      CHECK_CODE(update(law, two, closure, half, NULL, &s, &error), ASPERITY_OK);
      for (c = 0; c < 3; c++)
         for (i = 0; i < points; i++) {
            off = fabs(r.traction[c][i] - s.traction[c][i]) / r.traction[0][i];
            /* what is no number stays, where fmax would drop it */
            if (apart == apart && !(off <= apart)) apart = off;
         }
      CHECK(integration == ASPERITY_SLIP_EXACT ? apart < 1e-13 : apart > 1e-3);
      asperity_states_free(&one, NULL);
      asperity_states_free(&two, NULL);
      asperity_law_free(&law, NULL);
   }
}

/* A rotation turns the elastic slip by w = R v, and NULL is none. */
static void rotation(void)
{
   asperity_law *law = wood_law(0);
   asperity_states *states = fresh_states(points), *still = fresh_states(points);
   asperity_error error;
   double closure[points] = {0.1, 0.1, 0.1};
   double slip[2][points] = {{0.1, 0.1, 0.1}, {0.05, 0.05, 0.05}};
   double none[2][points] = {{0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}};
   double turn[2][2][points];
   asperity_state state;
   result r;
   int i;

   for (i = 0; i < points; i++) {
      double angle = 0.3 * (i + 1);
      turn[0][0][i] = cos(angle);
      turn[0][1][i] = sin(angle);
      turn[1][0][i] = -sin(angle);
      turn[1][1][i] = cos(angle);
   }
   CHECK_CODE(update(law, states, closure, slip, NULL, &r, &error), ASPERITY_OK);
   CHECK_CODE(asperity_states_copy(states, still, &error), ASPERITY_OK);
   CHECK_CODE(update(law, states, closure, none, turn[0][0], &r, &error), ASPERITY_OK);
   CHECK_CODE(update(law, still, closure, none, NULL, &r, &error), ASPERITY_OK);
   for (i = 0; i < points; i++) {
      double angle = 0.3 * (i + 1);
      asperity_states_get(states, i, 1, &state, NULL);
      CHECK_NEAR(state.elastic_slip[0], 0.1 * cos(angle) - 0.05 * sin(angle), 1e-15, 1.0);
      CHECK_NEAR(state.elastic_slip[1], 0.1 * sin(angle) + 0.05 * cos(angle), 1e-15, 1.0);
      asperity_states_get(still, i, 1, &state, NULL);
      CHECK(state.elastic_slip[0] == 0.1 && state.elastic_slip[1] == 0.05);
   }
   asperity_states_free(&states, NULL);
   asperity_states_free(&still, NULL);
   asperity_law_free(&law, NULL);
}

/* Each column of the tangent is the difference of the tractions by one motion: sticking, slipping
 * and turning points. Central differences with a step of 1e-5 mm: truncation (1e-5/0.06)^2 = 3e-8,
 * round-off 1e-16/1e-5 of the tractions, 1e-11. */
static void tangent(int compiled)
{
   asperity_law *law = wood_law(compiled);
   asperity_states *start = fresh_states(points), *trial = fresh_states(points);
   asperity_error error;
   double first[points] = {0.1, 0.12, 0.13}, closure[points] = {0.11, 0.12, 0.14};
   double before[2][points] = {{0.1, 0.3, 0.2}, {0.05, 0.0, -0.25}};
   double slip[2][points] = {{0.05, 0.3, 0.2}, {-0.1, 0.1, 0.3}};
   const double step = 1e-5;
   result at, up, down;
   int i, row, column;

   CHECK_CODE(update(law, start, first, before, NULL, &at, &error), ASPERITY_OK);
   asperity_states_copy(start, trial, NULL);
   CHECK_CODE(update(law, trial, closure, slip, NULL, &at, &error), ASPERITY_OK);
   for (column = 0; column < 3; column++) {
      double *motion = column == 0 ? closure : slip[column - 1];
      for (i = 0; i < points; i++)
         motion[i] += step;
      asperity_states_copy(start, trial, NULL);
      CHECK_CODE(update(law, trial, closure, slip, NULL, &up, &error), ASPERITY_OK);
      for (i = 0; i < points; i++)
         motion[i] -= 2.0 * step;
      asperity_states_copy(start, trial, NULL);
      CHECK_CODE(update(law, trial, closure, slip, NULL, &down, &error), ASPERITY_OK);
      for (i = 0; i < points; i++)
         motion[i] += step;
      for (row = 0; row < 3; row++)
         for (i = 0; i < points; i++)
            CHECK_NEAR((up.traction[row][i] - down.traction[row][i]) / (2.0 * step),
                       at.tangent[column][row][i], 1e-6, at.tangent[0][0][i]);
   }
   /* row and column are told apart: pressure does not depend on slip, shear does on closure */
   CHECK(at.tangent[1][0][0] == 0.0 && at.tangent[0][1][0] > 1.0);
   asperity_states_free(&start, NULL);
   asperity_states_free(&trial, NULL);
   asperity_law_free(&law, NULL);
}

/* Work equals the change of stored energies, plus dissipation, less pressure coupling: a path of
 * many small steps, the work by the trapezoidal rule. Within an increment the pressure changes
 * first, at the elastic slip of the start or, where the dissipative rule says so, at its shear
 * stress; then the point slips. */
static void energies(int rule)
{
   enum { steps = 20000 };
   asperity_properties p = wood(0);
   asperity_law *law;
   asperity_states *states = fresh_states(1);
   asperity_error error;
   asperity_state state;
   double closure = 0.06, slip[2], t[3], last[3] = {0.0, 0.0, 0.0}, work = 0.0, stored = 0.0;
   double tangential = 0.0, spent = 0.0, coupled = 0.0, first = 0.0, e, d, c;
   int i;

   p.friction_rule = rule;
   CHECK_CODE(asperity_law_new(&law, &p, &error), ASPERITY_OK);
   for (i = 0; i <= steps; i++) {
      double angle = 6.283185307179586 * i / steps, last_closure = closure;
      closure = 0.09 + 0.03 * sin(3.0 * angle);
      slip[0] = i == 0 ? 0.0 : 1e-4 * cos(angle);
      slip[1] = i == 0 ? 0.0 : 2e-4 * sin(2.0 * angle);
      if (asperity_states_update(law, states, 1, &closure, slip, NULL, 0.0, t, NULL, &e, &d, NULL,
                                 &c, NULL, &error) != ASPERITY_OK)
         break;
      asperity_states_get(states, 0, 1, &state, NULL);
      if (i == 0) {
         first = state.normal_energy;
      } else {
         double kept = rule == ASPERITY_RULE_DISSIPATIVE && t[0] > last[0] ? 1.0 : t[0] / last[0];
         work += 0.5 * (t[0] + last[0]) * (closure - last_closure)
                 + 0.5 * (t[1] + kept * last[1]) * slip[0]
                 + 0.5 * (t[2] + kept * last[2]) * slip[1];
         spent += d;
         coupled += c;
      }
      stored = state.normal_energy;
      tangential = e;
      memcpy(last, t, sizeof last);
   }
   CHECK(i == steps + 1);
   /* the trapezoidal rule is of second order: 1e3/steps^2 is 2.5e-6 */
   CHECK_NEAR(work, stored - first + tangential + spent - coupled, 1e3 / steps / steps, spent);
   CHECK_NEAR(state.dissipation, spent, 1e-11, 0.0);
   CHECK_NEAR(state.pressure_coupling, coupled, 1e-11, spent);
   CHECK(spent > 0.01);
   CHECK(rule == ASPERITY_RULE_ABAQUS ? fabs(coupled) > 1e-6 : coupled == 0.0);
   asperity_states_free(&states, NULL);
   asperity_law_free(&law, NULL);
}

void test_update(void)
{
   layout(0);
   layout(1);
   plateau(0);
   plateau(1);
   halves();
   rotation();
   tangent(0);
   tangent(1);
   energies(ASPERITY_RULE_ABAQUS);
   energies(ASPERITY_RULE_DISSIPATIVE);
}
