/* Tests of the C interface.
 *
 * usage: c_tests [--trap] [--no-limit] [--leak]
 *    --trap      invalid, divide by zero and overflow stop the program, as in the strict build
 *    --no-limit  leave out the tests that limit the memory of the process, for valgrind
 *    --leak      forget one handle, so that valgrind must complain
 */
#define _GNU_SOURCE
#include "check.h"

#include <fenv.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int passed, failed;

void check_that(int condition, const char *text, const char *file, int line)
{
   if (condition) {
      passed++;
   } else {
      failed++;
      printf("FAIL %s:%d: %s\n", file, line, text);
   }
}

void check_near(double value, double expected, double tolerance, double floor, const char *text,
                const char *file, int line)
{
   int near = fabs(value - expected) <= tolerance * fmax(fabs(expected), floor);
   if (!near)
      printf("%s is %.17g, not %.17g, %.2g off\n", text, value, expected,
             fabs(value - expected) / fmax(fabs(expected), floor));
   check_that(near, text, file, line);
}

void check_code(int code, int expected, const asperity_error *error, const char *text,
                const char *file, int line)
{
   int as_told = code == expected && error->code == expected
                 && (error->message[0] == '\0') == (expected == ASPERITY_OK);
   if (!as_told)
      printf("code %d, not %d; error %d, '%s'\n", code, expected, error->code, error->message);
   check_that(as_told, text, file, line);
}

void check_message(const asperity_error *error, const char *text, const char *file, int line)
{
   int found = strstr(error->message, text) != NULL;
   if (!found)
      printf("message '%s'\n", error->message);
   check_that(found, text, file, line);
}

asperity_properties wood(int compiled)
{
   asperity_properties p;
   if (asperity_properties_init(&p, sizeof p, NULL) != ASPERITY_OK)
      exit(3);
   p.eta = 206.0;
   p.modulus = 297.0;
   p.radius = 0.1477;
   p.hardness = 24.53;
   p.yield_factor = 0.4;
   p.sigma = 0.0593;
   p.friction_coefficient = 0.5;
   p.critical_slip = 0.31;
   p.compiled = compiled;
   return p;
}

asperity_law *wood_law(int compiled)
{
   asperity_properties p = wood(compiled);
   asperity_law *law;
   if (asperity_law_new(&law, &p, NULL) != ASPERITY_OK)
      exit(3);
   return law;
}

asperity_states *fresh_states(int n)
{
   asperity_states *states;
   if (asperity_states_new(&states, n, NULL) != ASPERITY_OK)
      exit(3);
   return states;
}

int main(int argc, char **argv)
{
   int i, limit = 1;

   for (i = 1; i < argc; i++) {
      if (strcmp(argv[i], "--trap") == 0) {
         feenableexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW);
      } else if (strcmp(argv[i], "--no-limit") == 0) {
         limit = 0;
      } else if (strcmp(argv[i], "--leak") == 0) {
         fresh_states(3);
      } else {
         fprintf(stderr, "unknown argument %s\n", argv[i]);
         return 2;
      }
   }
   test_layout();
   test_law();
   test_update();
   test_unloading();
   test_restart();
   test_friction();
   test_arguments();
   test_values();
   test_faces();
   test_threads();
   test_memory(limit);
   printf("%d passed, %d failed\n", passed, failed);
   return failed > 0;
}
