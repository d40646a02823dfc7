/* Handles made and freed over and over, and memory that ends. */
#define _POSIX_C_SOURCE 200809L
#include "check.h"

#include <limits.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/resource.h>

static void again_and_again(void)
{
   asperity_error error;
   int i, bad = 0;

   for (i = 0; i < 300; i++) {
      asperity_properties p = wood(i % 2);
      asperity_law *law;
      asperity_states *states;
      bad += asperity_law_new(&law, &p, &error) != ASPERITY_OK;
      bad += asperity_states_new(&states, i, &error) != ASPERITY_OK;
      bad += asperity_law_free(&law, &error) != ASPERITY_OK || law != NULL;
      bad += asperity_states_free(&states, &error) != ASPERITY_OK || states != NULL;
      /* what fails half-way leaves nothing behind */
      p.sigma = -1.0;
      bad += asperity_law_new(&law, &p, &error) != ASPERITY_BAD_INPUT || law != NULL;
      p = wood(1);
      p.critical_slip = 0.0;
      bad += asperity_law_new(&law, &p, &error) != ASPERITY_BAD_INPUT || law != NULL;
   }
   CHECK(bad == 0);
}

/* Take all memory in ever smaller pieces; each holds the address of the one before. */
static void *take_all(size_t smallest)
{
   void **last = NULL;
   size_t bytes;
   for (bytes = (size_t)1 << 26; bytes >= smallest; bytes /= 2) {
      void **next = malloc(bytes);
      while (next != NULL) {
         *next = last;
         last = next;
         next = malloc(bytes);
      }
   }
   return last;
}

static void give_back(void *last)
{
   while (last != NULL) {
      void *next = *(void **)last;
      free(last);
      last = next;
   }
}

/* The process may take 1 GiB and no more. */
static void without_memory(void)
{
   struct rlimit before, limited;
   asperity_properties p = wood(1);
   asperity_law *law, *summits;
   asperity_states *states, *points;
   asperity_error error;
   double closure[1000], slip[2000], t[3000];
   void *taken;
   int i;

   if (getrlimit(RLIMIT_AS, &before) != 0)
      return;
   limited = before;
   limited.rlim_cur = (rlim_t)1 << 30;
   if (setrlimit(RLIMIT_AS, &limited) != 0)
      return;
   CHECK_CODE(asperity_states_new(&states, INT_MAX, &error), ASPERITY_NO_MEMORY);
   CHECK_MESSAGE("not enough memory");
   CHECK(states == NULL);
   /* some arrays fit, not all */
   CHECK_CODE(asperity_states_new(&states, 40000000, &error), ASPERITY_NO_MEMORY);
   CHECK(states == NULL);
   p.compiled = 0;
   p.stick = ASPERITY_STICK_SUMMITS;
   p.shear_modulus = 31.6;
   CHECK_CODE(asperity_law_new(&summits, &p, &error), ASPERITY_OK);
   CHECK_CODE(asperity_states_new(&points, 1000, &error), ASPERITY_OK);
   for (i = 0; i < 1000; i++)
      closure[i] = slip[i] = slip[1000 + i] = 0.1;
   p = wood(1);
   /* some KiB are left for what a call needs on its way */
   taken = take_all(4096);
   /* the slips of summits need memory when they are first asked for */
   CHECK_CODE(asperity_states_update(summits, points, 1000, closure, slip, NULL, 0.0, t, NULL, NULL,
                                     NULL, NULL, NULL, NULL, &error), ASPERITY_NO_MEMORY);
   law = (asperity_law *)&p;
   CHECK_CODE(asperity_law_new(&law, &p, &error), ASPERITY_NO_MEMORY);
   CHECK(law == NULL);
   CHECK_CODE(asperity_states_new(&states, 1000, &error), ASPERITY_NO_MEMORY);
   CHECK(states == NULL);
   give_back(taken);
   /* and it recovers */
   CHECK_CODE(asperity_law_new(&law, &p, &error), ASPERITY_OK);
   CHECK_CODE(asperity_law_free(&law, &error), ASPERITY_OK);
   CHECK_CODE(asperity_states_new(&states, 1000, &error), ASPERITY_OK);
   CHECK_CODE(asperity_states_free(&states, &error), ASPERITY_OK);
   CHECK_CODE(asperity_states_update(summits, points, 1000, closure, slip, NULL, 0.0, t, NULL, NULL,
                                     NULL, NULL, NULL, NULL, &error), ASPERITY_OK);
   CHECK_CODE(asperity_states_free(&points, &error), ASPERITY_OK);
   CHECK_CODE(asperity_law_free(&summits, &error), ASPERITY_OK);
   setrlimit(RLIMIT_AS, &before);
}

void test_memory(int limit)
{
   again_and_again();
   if (limit)
      without_memory();
}
