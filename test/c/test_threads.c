/* Two threads share one law and each have their own states, errors and texts: every one of their
 * numbers is, bit by bit, what one thread alone gets. */
#define _POSIX_C_SOURCE 200809L
#include "check.h"

#include <pthread.h>
#include <stddef.h>
#include <stdio.h>
#include <string.h>

enum { points = 20, increments = 60, rounds = 12 };

typedef struct task {
   const asperity_law *law;
   int number;
   double traction[increments][3][points], pressure[increments][points];
   int errors;
} task;

/* A path of its own for each number. */
static void *run(void *argument)
{
   task *t = argument;
   asperity_states *states = fresh_states(points);
   asperity_error error;
   double closure[points], slip[2][points], d[points], s[points];
   char expected[40];
   int i, k;

   t->errors = 0;
   sprintf(expected, "n = %d is not allowed", -1 - t->number);
   for (i = 0; i < increments; i++) {
      for (k = 0; k < points; k++) {
         closure[k] = 0.02 + 0.005 * ((i * (t->number + 2) + k) % 23);
         slip[0][k] = 0.01 * ((i + t->number + k) % 7) - 0.02;
         slip[1][k] = 0.02 * (i % 3) - 0.01 * (k % 4);
         d[k] = 0.2 - closure[k];
      }
      t->errors += asperity_states_update(t->law, states, points, closure, slip[0], NULL, 0.0,
                                          t->traction[i][0], NULL, NULL, NULL, NULL, NULL, NULL,
                                          &error);
      t->errors += asperity_law_evaluate(t->law, points, d, t->pressure[i], s, NULL, NULL, NULL,
                                         NULL, &error);
      /* errors of one thread do not show in the other */
      t->errors += asperity_states_update(t->law, states, -1 - t->number, closure, slip[0], NULL, 0.0,
                                          t->traction[i][0], NULL, NULL, NULL, NULL, NULL, NULL,
                                          &error)
                   != ASPERITY_WRONG_LENGTH;
      t->errors += strstr(error.message, expected) == NULL;
   }
   asperity_states_free(&states, NULL);
   return NULL;
}

static int same(const task *a, const task *b)
{
   return memcmp(a->traction, b->traction, sizeof a->traction) == 0
          && memcmp(a->pressure, b->pressure, sizeof a->pressure) == 0;
}

static void together(int compiled)
{
   static task alone[2], shared[2];
   asperity_law *law = wood_law(compiled);
   pthread_t threads[2];
   int i, round;

   for (i = 0; i < 2; i++) {
      alone[i].law = shared[i].law = law;
      alone[i].number = shared[i].number = i;
      run(&alone[i]);
      CHECK(alone[i].errors == 0);
   }
   CHECK(!same(&alone[0], &alone[1]));
   for (round = 0; round < rounds; round++) {
      memset(shared[0].traction, 0, sizeof shared[0].traction);
      memset(shared[1].traction, 0, sizeof shared[1].traction);
      for (i = 0; i < 2; i++)
         CHECK(pthread_create(&threads[i], NULL, run, &shared[i]) == 0);
      for (i = 0; i < 2; i++)
         CHECK(pthread_join(threads[i], NULL) == 0);
      for (i = 0; i < 2; i++) {
         CHECK(shared[i].errors == 0);
         CHECK(same(&alone[i], &shared[i]));
      }
   }
   asperity_law_free(&law, NULL);
}

void test_threads(void)
{
   together(0);
   together(1);
}
