/* States: counting, copying, and a restart that goes on bit by bit. */
#include "check.h"

#include <stddef.h>
#include <string.h>

enum { n = 5 };

static void step(const asperity_law *law, asperity_states *states, int i, double t[3][n])
{
   double closure[n], slip[2][n];
   asperity_error error;
   int k;

   for (k = 0; k < n; k++) {
      closure[k] = 0.05 + 0.01 * ((i * 3 + k) % 9);
      slip[0][k] = 0.02 * (k + 1) - 0.05 * (i % 3);
      slip[1][k] = 0.03 * (i % 4) - 0.01 * k;
   }
   CHECK_CODE(asperity_states_update(law, states, n, closure, slip[0], NULL, 0.0, t[0], NULL, NULL,
                                     NULL, NULL, NULL, NULL, &error), ASPERITY_OK);
}

void test_restart(void)
{
   asperity_law *law = wood_law(1);
   asperity_states *states = fresh_states(n), *other = fresh_states(n), *more = fresh_states(n + 1);
   asperity_states *none = fresh_states(0);
   asperity_state saved[n], range[n], state, fresh;
   asperity_error error;
   double a[3][n], b[3][n];
   int i, k, count = -1;

   CHECK_CODE(asperity_states_count(states, &count, &error), ASPERITY_OK);
   CHECK(count == n);
   CHECK_CODE(asperity_states_count(none, &count, &error), ASPERITY_OK);
   CHECK(count == 0);
   memset(&fresh, 0, sizeof fresh);
   for (k = 0; k < n; k++) {
      CHECK_CODE(asperity_states_get(states, k, 1, &state, &error), ASPERITY_OK);
      CHECK(memcmp(&state, &fresh, sizeof state) == 0);
   }

   for (i = 0; i < 20; i++)
      step(law, states, i, a);
   for (k = 0; k < n; k++)
      CHECK_CODE(asperity_states_get(states, k, 1, &saved[k], &error), ASPERITY_OK);
   for (k = 0; k < n; k++)
      CHECK_CODE(asperity_states_set(other, k, 1, &saved[k], &error), ASPERITY_OK);
   for (i = 20; i < 40; i++) {
      step(law, states, i, a);
      step(law, other, i, b);
      CHECK(memcmp(a, b, sizeof a) == 0);
   }

   /* several at once; where one is refused, none is set */
   CHECK_CODE(asperity_states_get(states, 0, n, range, &error), ASPERITY_OK);
   CHECK_CODE(asperity_states_get(states, 1, 3, saved, &error), ASPERITY_OK);
   CHECK(memcmp(saved, range + 1, 3 * sizeof state) == 0);
   memset(range, 0, sizeof range);
   range[2].status = 4;
   CHECK_CODE(asperity_states_set(states, 1, 3, range, &error), ASPERITY_BAD_INPUT);
   CHECK_MESSAGE("status = 4 of state[2] is not allowed");
   CHECK_CODE(asperity_states_get(states, 1, 3, range, &error), ASPERITY_OK);
   CHECK(memcmp(saved, range, 3 * sizeof state) == 0);
   CHECK_CODE(asperity_states_set(other, 1, 3, saved, &error), ASPERITY_OK);
   CHECK_CODE(asperity_states_get(other, 0, n, range, &error), ASPERITY_OK);
   CHECK(memcmp(saved, range + 1, 3 * sizeof state) == 0);

   CHECK_CODE(asperity_states_copy(states, states, &error), ASPERITY_OK);
   CHECK_CODE(asperity_states_copy(states, more, &error), ASPERITY_WRONG_LENGTH);
   CHECK_MESSAGE("from has 5 points, to has 6");
   CHECK_CODE(asperity_states_copy(none, none, &error), ASPERITY_OK);
   /* a copy is a copy: going on with one leaves the other */
   for (k = 0; k < n; k++)
      asperity_states_set(other, k, 1, &fresh, NULL);
   CHECK_CODE(asperity_states_copy(states, other, &error), ASPERITY_OK);
   for (k = 0; k < n; k++) {
      asperity_states_get(states, k, 1, &saved[k], NULL);
      asperity_states_get(other, k, 1, &state, NULL);
      CHECK(memcmp(&state, &saved[k], sizeof state) == 0);
   }
   asperity_states_get(other, 2, 1, &saved[2], NULL);
   step(law, states, 40, a);
   asperity_states_get(other, 2, 1, &state, NULL);
   CHECK(memcmp(&state, &saved[2], sizeof state) == 0);
   asperity_states_get(states, 2, 1, &state, NULL);
   CHECK(memcmp(&state, &saved[2], sizeof state) != 0);

   asperity_states_free(&states, NULL);
   asperity_states_free(&other, NULL);
   asperity_states_free(&more, NULL);
   asperity_states_free(&none, NULL);
   CHECK(states == NULL && other == NULL && more == NULL && none == NULL);
   asperity_law_free(&law, NULL);
}
