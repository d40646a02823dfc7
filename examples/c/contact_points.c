/* Press a tilted wood face and slide it: five contact points, as a finite-element code in C calls
 * them.
 *
 * cc contact_points.c $(pkg-config --cflags --libs asperity-c) -o contact_points */
#include <asperity.h>
#include <stdio.h>
#include <stdlib.h>

enum { n = 5 };

/* Say what went wrong and stop. */
static void check(const asperity_error *error)
{
   if (error->code == ASPERITY_OK)
      return;
   fprintf(stderr, "error %d: %s\n", error->code, error->message);
   exit(1);
}

int main(void)
{
   asperity_error error;
   asperity_properties pair; /* N, mm, MPa */
   asperity_law *law;
   asperity_states *states;
   double overclosure[n], slip[2][n], traction[3][n], separation;
   int i, step;

   asperity_properties_from_pair(&pair, sizeof pair, "transverse-tangential", &error);
   check(&error);
   pair.compiled = 1;
   asperity_law_new(&law, &pair, &error);
   check(&error);
   asperity_states_new(&states, n, &error);
   check(&error);

   /* the middle at 0.2 MPa, the ends 0.04 mm nearer and farther; 0.12 mm of slip in each step */
   asperity_law_separation(law, 0.2, &separation, &error);
   check(&error);
   for (i = 0; i < n; i++) {
      overclosure[i] = 4.0 * pair.sigma - separation + 0.02 * (i - 2);
      slip[0][i] = 0.12;
      slip[1][i] = 0.0;
   }
   for (step = 1; step <= 4; step++) {
      asperity_states_update(law, states, n, overclosure, slip[0], NULL, 0.0, traction[0], NULL,
                             NULL, NULL, NULL, NULL, NULL, &error);
      check(&error);
      printf("%.2f mm: shear stress", 0.12 * step);
      for (i = 0; i < n; i++)
         printf(" %.4f", traction[1][i]);
      printf(" MPa\n");
   }

   /* an error is a code and a message, never the end of the program */
   if (asperity_states_update(law, states, n + 1, overclosure, slip[0], NULL, 0.0, traction[0],
                              NULL, NULL, NULL, NULL, NULL, NULL, &error) != ASPERITY_OK)
      printf("error %d: %s\n", error.code, error.message);

   asperity_states_free(&states, &error);
   asperity_law_free(&law, &error);
   return 0;
}
