/* Every pointer NULL in turn, every length wrong, wrong handles, n = 0: a code, and no crash.
 * Outputs stay as they were after each error. */
#include "check.h"

#include <limits.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

enum { n = 4 };

/* Arguments of the two functions with many arrays; calls take pointers that a test may replace. */
typedef struct arguments {
   double separation[n], pressure[n], stiffness[n], area[n], density[n], energy[n];
   double closure[n], slip[2][n], rotation[2][2][n], traction[3][n], tangent[3][3][n];
   double tangential[n], dissipation[n], plastic[n], coupling[n];
   int validity[n];
} arguments;

static const arguments fresh = {
   {0.1, 0.2, 0.3, 0.4}, {9, 9, 9, 9}, {9, 9, 9, 9}, {9, 9, 9, 9}, {9, 9, 9, 9}, {9, 9, 9, 9},
   {0.1, 0.11, 0.12, 0.13}, {{0.1, 0.2, 0.3, 0.4}, {0.0, 0.1, 0.0, 0.1}},
   {{{1, 1, 1, 1}, {0, 0, 0, 0}}, {{0, 0, 0, 0}, {1, 1, 1, 1}}},
   {{9, 9, 9, 9}, {9, 9, 9, 9}, {9, 9, 9, 9}},
   {{{9, 9, 9, 9}, {9, 9, 9, 9}, {9, 9, 9, 9}}, {{9, 9, 9, 9}, {9, 9, 9, 9}, {9, 9, 9, 9}},
    {{9, 9, 9, 9}, {9, 9, 9, 9}, {9, 9, 9, 9}}},
   {9, 9, 9, 9}, {9, 9, 9, 9}, {9, 9, 9, 9}, {9, 9, 9, 9}, {9, 9, 9, 9}
};

static asperity_error error;

/* asperity_law_evaluate with arrays[0] to [5] and validity. */
static int evaluate(const asperity_law *law, int points, double **arrays, int *validity)
{
   return asperity_law_evaluate(law, points, arrays[0], arrays[1], arrays[2], arrays[3], arrays[4],
                                arrays[5], validity, &error);
}

static void evaluate_arguments(int compiled)
{
   asperity_law *law = wood_law(compiled);
   asperity_states *states = fresh_states(n);
   arguments a = fresh;
   double *const all[6] = {a.separation, a.pressure, a.stiffness, a.area, a.density, a.energy};
   double *arrays[6];
   static const char *const names[6] = {"separation", "pressure", "stiffness", "area_fraction",
                                        "contact_density", "energy"};
   int i, k;

   for (i = 0; i < 6; i++) {
      memcpy(arrays, all, sizeof arrays);
      arrays[i] = NULL;
      CHECK_CODE(evaluate(law, n, arrays, a.validity),
                 i < 3 ? ASPERITY_NULL_ARGUMENT : ASPERITY_OK);
      if (i < 3) {
         CHECK_MESSAGE(names[i]);
         CHECK_MESSAGE("is NULL");
         CHECK(memcmp(&a, &fresh, sizeof a) == 0);
      }
      a = fresh;
      /* with one byte added no double begins there */
      memcpy(arrays, all, sizeof arrays);
      arrays[i] = (double *)((char *)arrays[i] + 1);
      CHECK_CODE(evaluate(law, n - 1, arrays, a.validity), ASPERITY_BAD_INPUT);
      CHECK_MESSAGE("aligned");
      CHECK(memcmp(&a, &fresh, sizeof a) == 0);
      /* the last element of one array is the first of another */
      for (k = 0; k < 6; k++) {
         if (k == i || (k == 0 && i == 0))
            continue;
         memcpy(arrays, all, sizeof arrays);
         arrays[i] = arrays[k] + n - 1;
         CHECK_CODE(evaluate(law, n, arrays, a.validity), ASPERITY_BAD_INPUT);
         CHECK_MESSAGE("overlap");
         CHECK_MESSAGE(names[i]);
         CHECK_MESSAGE(names[k]);
         CHECK(memcmp(&a, &fresh, sizeof a) == 0);
      }
   }
   memcpy(arrays, all, sizeof arrays);
   CHECK_CODE(evaluate(law, n, arrays, NULL), ASPERITY_OK);
   a = fresh;
   CHECK_CODE(evaluate(law, 1, arrays, (int *)((char *)a.validity + 2)), ASPERITY_BAD_INPUT);
   CHECK_CODE(evaluate(law, n, arrays, (int *)a.energy), ASPERITY_BAD_INPUT);
   CHECK_CODE(evaluate(NULL, n, arrays, a.validity), ASPERITY_NULL_ARGUMENT);
   CHECK_MESSAGE("law is NULL");
   CHECK_CODE(evaluate((asperity_law *)states, n, arrays, a.validity), ASPERITY_WRONG_HANDLE);
   CHECK_CODE(evaluate(law, -1, arrays, a.validity), ASPERITY_WRONG_LENGTH);
   CHECK_MESSAGE("n = -1");
   CHECK_CODE(evaluate(law, INT_MIN, arrays, a.validity), ASPERITY_WRONG_LENGTH);
   CHECK_CODE(evaluate(law, 0, arrays, a.validity), ASPERITY_OK);
   CHECK(memcmp(&a, &fresh, sizeof a) == 0);
   memset(arrays, 0, sizeof arrays);
   CHECK_CODE(evaluate(law, 0, arrays, NULL), ASPERITY_OK);
   CHECK_CODE(evaluate(NULL, 0, arrays, NULL), ASPERITY_NULL_ARGUMENT);
   /* neighbours that touch do not overlap */
   {
      double together[3 * n];
      memcpy(together, fresh.separation, sizeof fresh.separation);
      arrays[0] = together;
      arrays[1] = together + n;
      arrays[2] = together + 2 * n;
      CHECK_CODE(evaluate(law, n, arrays, NULL), ASPERITY_OK);
   }
   CHECK(asperity_law_evaluate(law, -1, NULL, NULL, NULL, NULL, NULL, NULL, NULL, NULL)
         == ASPERITY_WRONG_LENGTH);
   asperity_states_free(&states, NULL);
   asperity_law_free(&law, NULL);
}

/* asperity_states_update with arrays[0] to [8] and validity. */
static int update(const asperity_law *law, asperity_states *states, int points, double **arrays,
                  int *validity)
{
   return asperity_states_update(law, states, points, arrays[0], arrays[1], arrays[2], 0.0,
                                 arrays[3], arrays[4], arrays[5], arrays[6], arrays[7], arrays[8],
                                 validity, &error);
}

/* The states are those of fresh points. */
static int untouched(const asperity_states *states)
{
   asperity_state state, zero;
   int i;
   memset(&zero, 0, sizeof zero);
   for (i = 0; i < n; i++) {
      asperity_states_get(states, i, 1, &state, NULL);
      if (memcmp(&state, &zero, sizeof state) != 0)
         return 0;
   }
   return 1;
}

static void update_arguments(int compiled)
{
   asperity_law *law = wood_law(compiled);
   asperity_states *states = fresh_states(n), *clean = fresh_states(n), *none = fresh_states(0);
   arguments a = fresh;
   double *const all[9] = {a.closure, a.slip[0], a.rotation[0][0], a.traction[0], a.tangent[0][0],
                           a.tangential, a.dissipation, a.plastic, a.coupling};
   static const int required[9] = {1, 1, 0, 1, 0, 0, 0, 0, 0};
   static const int rows[9] = {1, 2, 4, 3, 9, 1, 1, 1, 1};
   static const char *const names[9] = {"overclosure", "slip_increment", "rotation", "traction",
                                        "tangent", "tangential_energy", "dissipation",
                                        "plastic_dissipation", "pressure_coupling"};
   double *arrays[9];
   int i, k;

   for (i = 0; i < 9; i++) {
      memcpy(arrays, all, sizeof arrays);
      arrays[i] = NULL;
      CHECK_CODE(update(law, states, n, arrays, a.validity),
                 required[i] ? ASPERITY_NULL_ARGUMENT : ASPERITY_OK);
      if (required[i]) {
         CHECK_MESSAGE(names[i]);
         CHECK(memcmp(&a, &fresh, sizeof a) == 0);
         CHECK(untouched(states));
      }
      a = fresh;
      CHECK_CODE(asperity_states_copy(clean, states, &error), ASPERITY_OK);
      memcpy(arrays, all, sizeof arrays);
      arrays[i] = (double *)((char *)arrays[i] - 4);
      CHECK_CODE(update(law, states, n, arrays, a.validity), ASPERITY_BAD_INPUT);
      CHECK_MESSAGE("aligned");
      for (k = 0; k < 9; k++) {
         /* two that are only read may be one */
         int shared = k < 3 && i < 3;
         if (k == i)
            continue;
         memcpy(arrays, all, sizeof arrays);
         arrays[i] = arrays[k] + rows[k] * n - 1;
         if (shared)
            arrays[i] = arrays[k];
         if (shared && rows[i] > rows[k])
            continue;
         CHECK_CODE(update(law, states, n, arrays, a.validity),
                    shared ? ASPERITY_OK : ASPERITY_BAD_INPUT);
         if (!shared) {
            CHECK_MESSAGE("overlap");
            CHECK_MESSAGE(names[i]);
            CHECK_MESSAGE(names[k]);
            CHECK(memcmp(&a, &fresh, sizeof a) == 0);
            CHECK(untouched(states));
         }
         a = fresh;
         CHECK_CODE(asperity_states_copy(clean, states, &error), ASPERITY_OK);
      }
   }
   memcpy(arrays, all, sizeof arrays);
   CHECK_CODE(update(law, states, n, arrays, NULL), ASPERITY_OK);
   a = fresh;
   CHECK_CODE(update(NULL, states, n, arrays, a.validity), ASPERITY_NULL_ARGUMENT);
   CHECK_MESSAGE("law is NULL");
   CHECK_CODE(update(law, NULL, n, arrays, a.validity), ASPERITY_NULL_ARGUMENT);
   CHECK_MESSAGE("states is NULL");
   CHECK_CODE(update((asperity_law *)states, states, n, arrays, a.validity), ASPERITY_WRONG_HANDLE);
   CHECK_MESSAGE("law is a handle of another kind");
   CHECK_CODE(update(law, (asperity_states *)law, n, arrays, a.validity), ASPERITY_WRONG_HANDLE);
   CHECK_MESSAGE("states is a handle of another kind");
   CHECK_CODE(update(law, states, n - 1, arrays, a.validity), ASPERITY_WRONG_LENGTH);
   CHECK_MESSAGE("n = 3 does not fit: the states have 4 points");
   CHECK_CODE(update(law, states, n + 1, arrays, a.validity), ASPERITY_WRONG_LENGTH);
   CHECK_CODE(update(law, states, 0, arrays, a.validity), ASPERITY_WRONG_LENGTH);
   CHECK_CODE(update(law, states, -n, arrays, a.validity), ASPERITY_WRONG_LENGTH);
   CHECK_CODE(update(law, states, INT_MIN, arrays, a.validity), ASPERITY_WRONG_LENGTH);
   CHECK_CODE(update(law, states, INT_MAX, arrays, a.validity), ASPERITY_WRONG_LENGTH);
   CHECK_CODE(update(law, none, n, arrays, a.validity), ASPERITY_WRONG_LENGTH);
   CHECK_CODE(update(law, none, 0, arrays, a.validity), ASPERITY_OK);
   CHECK(memcmp(&a, &fresh, sizeof a) == 0);
   memset(arrays, 0, sizeof arrays);
   CHECK_CODE(update(law, none, 0, arrays, NULL), ASPERITY_OK);
   CHECK(asperity_states_update(law, states, n, NULL, NULL, NULL, 0.0, NULL, NULL, NULL, NULL,
                                NULL, NULL, NULL, NULL) == ASPERITY_NULL_ARGUMENT);
   asperity_states_free(&states, NULL);
   asperity_states_free(&clean, NULL);
   asperity_states_free(&none, NULL);
   asperity_law_free(&law, NULL);
}

static void handles(void)
{
   asperity_properties p = wood(0);
   asperity_law *law = wood_law(0), *no_law = NULL, *other = NULL;
   asperity_states *states = fresh_states(n), *no_states = NULL;
   asperity_state state;
   double d = 9.0;
   int count = 9;
   char text[16], long_name[100];
   /* memory of no handle at all */
   uint64_t words[8] = {0, 0, 0, 0, 0, 0, 0, 0};
   asperity_law *false_law = (asperity_law *)words;
   asperity_states *false_states = (asperity_states *)words;

   memset(long_name, 'a', sizeof long_name);
   long_name[sizeof long_name - 1] = 0;
   memset(&state, 0, sizeof state);
   CHECK_CODE(asperity_law_new(NULL, &p, &error), ASPERITY_NULL_ARGUMENT);
   CHECK_CODE(asperity_law_new(&other, NULL, &error), ASPERITY_NULL_ARGUMENT);
   CHECK_MESSAGE("properties is NULL");
   CHECK(other == NULL);
   no_law = law;
   p.eta = -1.0;
   CHECK_CODE(asperity_law_new(&no_law, &p, &error), ASPERITY_BAD_INPUT);
   CHECK(no_law == NULL);
   CHECK_CODE(asperity_law_free(&no_law, &error), ASPERITY_OK);
   CHECK_CODE(asperity_law_free(NULL, &error), ASPERITY_OK);
   CHECK(asperity_law_free(NULL, NULL) == ASPERITY_OK);
   CHECK_CODE(asperity_law_free((asperity_law **)&states, &error), ASPERITY_WRONG_HANDLE);
   CHECK_CODE(asperity_law_free(&false_law, &error), ASPERITY_WRONG_HANDLE);
   CHECK(states != NULL && (void *)false_law == (void *)words);
   CHECK_CODE(asperity_law_properties(NULL, &p, sizeof p, &error), ASPERITY_NULL_ARGUMENT);
   CHECK_CODE(asperity_law_properties(law, NULL, sizeof p, &error), ASPERITY_NULL_ARGUMENT);
   CHECK_CODE(asperity_law_properties(law, &p, sizeof p - 8, &error), ASPERITY_WRONG_LENGTH);
   CHECK_CODE(asperity_law_properties((asperity_law *)states, &p, sizeof p, &error),
              ASPERITY_WRONG_HANDLE);
   CHECK(p.eta == -1.0);
   CHECK_CODE(asperity_law_separation(NULL, 1.0, &d, &error), ASPERITY_NULL_ARGUMENT);
   CHECK_CODE(asperity_law_separation(law, 1.0, NULL, &error), ASPERITY_NULL_ARGUMENT);
   CHECK_CODE(asperity_law_separation(false_law, 1.0, &d, &error), ASPERITY_WRONG_HANDLE);
   CHECK(d == 9.0);
   CHECK_CODE(asperity_properties_init(NULL, sizeof p, &error), ASPERITY_NULL_ARGUMENT);
   CHECK_CODE(asperity_properties_init(&p, sizeof p + 1, &error), ASPERITY_WRONG_LENGTH);
   CHECK_CODE(asperity_properties_init(&p, 0, &error), ASPERITY_WRONG_LENGTH);
   CHECK_CODE(asperity_properties_from_pair(NULL, sizeof p, "transverse-tangential", &error),
              ASPERITY_NULL_ARGUMENT);
   CHECK_CODE(asperity_properties_from_pair(&p, sizeof p + 1, "transverse-tangential", &error),
              ASPERITY_WRONG_LENGTH);
   CHECK_CODE(asperity_properties_from_pair(&p, sizeof p, NULL, &error), ASPERITY_NULL_ARGUMENT);
   CHECK_CODE(asperity_properties_from_pair(&p, sizeof p, "", &error), ASPERITY_BAD_INPUT);
   CHECK_CODE(asperity_properties_from_pair(&p, sizeof p, "radial-radial", &error),
              ASPERITY_BAD_INPUT);
   CHECK_MESSAGE("pair = 'radial-radial' is unknown; known pairs: transverse-tangential, ");
   CHECK_CODE(asperity_properties_from_pair(&p, sizeof p, long_name, &error), ASPERITY_BAD_INPUT);
   CHECK_MESSAGE("is unknown");
   CHECK(p.eta == -1.0);
   /* a struct that was never filled says so */
   p = wood(0);
   p.size = 0;
   CHECK_CODE(asperity_law_new(&no_law, &p, &error), ASPERITY_WRONG_LENGTH);
   CHECK_MESSAGE("asperity_properties_init");

   CHECK_CODE(asperity_states_new(NULL, n, &error), ASPERITY_NULL_ARGUMENT);
   no_states = states;
   CHECK_CODE(asperity_states_new(&no_states, -1, &error), ASPERITY_WRONG_LENGTH);
   CHECK(no_states == NULL);
   CHECK_CODE(asperity_states_new(&no_states, INT_MIN, &error), ASPERITY_WRONG_LENGTH);
   CHECK_CODE(asperity_states_free(&no_states, &error), ASPERITY_OK);
   CHECK_CODE(asperity_states_free(NULL, &error), ASPERITY_OK);
   CHECK_CODE(asperity_states_free((asperity_states **)&law, &error), ASPERITY_WRONG_HANDLE);
   CHECK_CODE(asperity_states_free(&false_states, &error), ASPERITY_WRONG_HANDLE);
   CHECK_CODE(asperity_states_copy(NULL, states, &error), ASPERITY_NULL_ARGUMENT);
   CHECK_CODE(asperity_states_copy(states, NULL, &error), ASPERITY_NULL_ARGUMENT);
   CHECK_CODE(asperity_states_copy(false_states, states, &error), ASPERITY_WRONG_HANDLE);
   CHECK_CODE(asperity_states_copy(states, (asperity_states *)law, &error), ASPERITY_WRONG_HANDLE);
   CHECK_CODE(asperity_states_count(NULL, &count, &error), ASPERITY_NULL_ARGUMENT);
   CHECK_CODE(asperity_states_count(states, NULL, &error), ASPERITY_NULL_ARGUMENT);
   CHECK_CODE(asperity_states_count((asperity_states *)law, &count, &error), ASPERITY_WRONG_HANDLE);
   CHECK(count == 9);
   CHECK_CODE(asperity_states_get(NULL, 0, 1, &state, &error), ASPERITY_NULL_ARGUMENT);
   CHECK_CODE(asperity_states_get(states, 0, 1, NULL, &error), ASPERITY_NULL_ARGUMENT);
   CHECK_CODE(asperity_states_get((asperity_states *)law, 0, 1, &state, &error),
              ASPERITY_WRONG_HANDLE);
   CHECK_CODE(asperity_states_get(states, -1, 1, &state, &error), ASPERITY_WRONG_LENGTH);
   CHECK_CODE(asperity_states_get(states, n, 1, &state, &error), ASPERITY_WRONG_LENGTH);
   CHECK_MESSAGE("first = 4 and n = 1 go beyond the points: the states have 4");
   CHECK_CODE(asperity_states_get(states, 0, -1, &state, &error), ASPERITY_WRONG_LENGTH);
   CHECK_CODE(asperity_states_get(states, 1, INT_MAX, &state, &error), ASPERITY_WRONG_LENGTH);
   CHECK_CODE(asperity_states_get(states, 0, 0, NULL, &error), ASPERITY_OK);
   CHECK_CODE(asperity_states_get(states, INT_MAX, 1, &state, &error), ASPERITY_WRONG_LENGTH);
   CHECK_CODE(asperity_states_set(NULL, 0, 1, &state, &error), ASPERITY_NULL_ARGUMENT);
   CHECK_CODE(asperity_states_set(states, 0, 1, NULL, &error), ASPERITY_NULL_ARGUMENT);
   CHECK_CODE(asperity_states_set((asperity_states *)law, 0, 1, &state, &error),
              ASPERITY_WRONG_HANDLE);
   CHECK_CODE(asperity_states_set(states, -1, 1, &state, &error), ASPERITY_WRONG_LENGTH);
   CHECK_CODE(asperity_states_set(states, n, 1, &state, &error), ASPERITY_WRONG_LENGTH);
   CHECK_CODE(asperity_states_set(states, INT_MAX, 1, &state, &error), ASPERITY_WRONG_LENGTH);
   CHECK_CODE(asperity_states_set(states, INT_MIN, 1, &state, &error), ASPERITY_WRONG_LENGTH);

   /* no int begins at an odd address, and no handle */
   CHECK_CODE(asperity_states_count((asperity_states *)((char *)states + 1), &count, &error),
              ASPERITY_BAD_INPUT);
   CHECK_CODE(asperity_states_count(states, (int *)(text + 1), &error), ASPERITY_BAD_INPUT);

   /* freed handles are NULL, and freeing them again is fine */
   CHECK_CODE(asperity_law_free(&law, &error), ASPERITY_OK);
   CHECK_CODE(asperity_law_free(&law, &error), ASPERITY_OK);
   CHECK_CODE(asperity_states_free(&states, &error), ASPERITY_OK);
   CHECK_CODE(asperity_states_free(&states, &error), ASPERITY_OK);
   CHECK(law == NULL && states == NULL);
   CHECK_CODE(asperity_states_get(states, 0, 1, &state, &error), ASPERITY_NULL_ARGUMENT);
}

static void texts(void)
{
   char text[1024], one;
   int flags, length;

   CHECK_CODE(asperity_library_version(NULL, 16, &error), ASPERITY_NULL_ARGUMENT);
   CHECK_CODE(asperity_library_version(text, 16, &error), ASPERITY_OK);
   CHECK(strcmp(text, ASPERITY_TEST_VERSION) == 0);
   length = (int)strlen(text);
   CHECK_CODE(asperity_library_version(text, length + 1, &error), ASPERITY_OK);
   memset(text, 'x', sizeof text);
   CHECK_CODE(asperity_library_version(text, length, &error), ASPERITY_WRONG_LENGTH);
   CHECK((int)strlen(text) == length - 1 && text[length] == 'x');
   CHECK_CODE(asperity_library_version(text, 0, &error), ASPERITY_WRONG_LENGTH);
   CHECK_CODE(asperity_library_version(text, -5, &error), ASPERITY_WRONG_LENGTH);
   CHECK_CODE(asperity_library_version(&one, 1, &error), ASPERITY_WRONG_LENGTH);
   CHECK(one == '\0');

   CHECK_CODE(asperity_validity_remark(0, text, sizeof text, &error), ASPERITY_OK);
   CHECK(text[0] == '\0');
   flags = ASPERITY_PRESSURE_ABOVE_HARDNESS | ASPERITY_STIFFER_THAN_HERTZ;
   CHECK_CODE(asperity_validity_remark(flags, text, sizeof text, &error), ASPERITY_OK);
   CHECK(strstr(text, "pressure above the hardness") == text);
   CHECK(strstr(text, "; yield_factor below 2/sqrt(plastic_ratio)") != NULL);
   for (flags = 0; flags < 256; flags++)
      CHECK_CODE(asperity_validity_remark(flags, text, sizeof text, &error), ASPERITY_OK);
   CHECK_CODE(asperity_validity_remark(256, text, sizeof text, &error), ASPERITY_BAD_INPUT);
   CHECK_CODE(asperity_validity_remark(-1, text, sizeof text, &error), ASPERITY_BAD_INPUT);
   CHECK_CODE(asperity_validity_remark(1, NULL, sizeof text, &error), ASPERITY_NULL_ARGUMENT);
   CHECK_CODE(asperity_validity_remark(1, text, 20, &error), ASPERITY_WRONG_LENGTH);
   CHECK(strcmp(text, "real area above ...") == 0);
   CHECK_CODE(asperity_validity_remark(1, text, -1, &error), ASPERITY_WRONG_LENGTH);
}

void test_arguments(void)
{
   evaluate_arguments(0);
   evaluate_arguments(1);
   update_arguments(0);
   update_arguments(1);
   handles();
   texts();
}
