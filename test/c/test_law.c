/* Values of the law: against an independent quadrature, and exact identities. */
#include "check.h"

#include <math.h>
#include <stddef.h>

enum { n = 22 };

/* Separations from -3 to 7.5 sigma, in a mixed order. */
static void separations(double sigma, double *d)
{
   int i;
   for (i = 0; i < n; i++)
      d[i] = sigma * (-3.0 + 0.5 * (i * 5 % n));
}

/* Direct evaluation is good to 1e-12, the compiled law to 1e-10, Simpson's sums to 2e-13. */
static void against_quadrature(const asperity_properties *p, double tolerance)
{
   asperity_law *law;
   asperity_error error;
   double d[n], pressure[n], stiffness[n], area[n], density[n], energy[n], only_p[n], only_s[n];
   int validity[n], i;

   CHECK_CODE(asperity_law_new(&law, p, &error), ASPERITY_OK);
   separations(p->sigma, d);
   CHECK_CODE(asperity_law_evaluate(law, n, d, pressure, stiffness, area, density, energy,
                                    validity, &error), ASPERITY_OK);
   CHECK_CODE(asperity_law_evaluate(law, n, d, only_p, only_s, NULL, NULL, NULL, NULL, &error),
              ASPERITY_OK);
   for (i = 0; i < n; i++) {
      reference r = reference_law(p, d[i]);
      CHECK_NEAR(pressure[i], r.pressure, tolerance, 0.0);
      CHECK_NEAR(stiffness[i], r.stiffness, tolerance, 0.0);
      CHECK_NEAR(area[i], r.area_fraction, tolerance, 0.0);
      CHECK_NEAR(density[i], r.contact_density, tolerance, 0.0);
      CHECK_NEAR(energy[i], r.energy, tolerance, 0.0);
      /* scalar and batch forms may round differently */
      CHECK_NEAR(only_p[i], pressure[i], 1e-14, 0.0);
      CHECK_NEAR(only_s[i], stiffness[i], 1e-14, 0.0);
      CHECK(((validity[i] & ASPERITY_AREA_ABOVE_NOMINAL) != 0) == (r.area_fraction > 1.0));
      CHECK(((validity[i] & ASPERITY_PRESSURE_ABOVE_HARDNESS) != 0)
            == (r.pressure > p->hardness));
   }
   CHECK_CODE(asperity_law_free(&law, &error), ASPERITY_OK);
   CHECK(law == NULL);
}

/* Each optional array alone holds what it holds beside the others. */
static void optional_arrays(int compiled)
{
   asperity_law *law = wood_law(compiled);
   asperity_error error;
   double d[n], p[n], s[n], area[n], density[n], energy[n], alone[3][n];
   int validity[n], alone_validity[n], i;

   separations(wood(0).sigma, d);
   CHECK_CODE(asperity_law_evaluate(law, n, d, p, s, area, density, energy, validity, &error), 0);
   CHECK_CODE(asperity_law_evaluate(law, n, d, p, s, alone[0], NULL, NULL, NULL, &error), 0);
   CHECK_CODE(asperity_law_evaluate(law, n, d, p, s, NULL, alone[1], NULL, NULL, &error), 0);
   CHECK_CODE(asperity_law_evaluate(law, n, d, p, s, NULL, NULL, alone[2], NULL, &error), 0);
   CHECK_CODE(asperity_law_evaluate(law, n, d, p, s, NULL, NULL, NULL, alone_validity, &error), 0);
   for (i = 0; i < n; i++) {
      CHECK_NEAR(alone[0][i], area[i], 1e-14, 0.0);
      CHECK_NEAR(alone[1][i], density[i], 1e-14, 0.0);
      CHECK_NEAR(alone[2][i], energy[i], 1e-14, 0.0);
      CHECK(alone_validity[i] == validity[i]);
   }
   asperity_law_free(&law, NULL);
}

/* Stiffness is -dp/dd and pressure is -de/dd: differences of fourth order with a step of 0.003
 * sigma, whose error is some (0.003)^4 = 8e-11 of the value's size, and round-off, 1e-13/0.003. */
static void differences(int compiled)
{
   asperity_law *law = wood_law(compiled);
   asperity_error error;
   double sigma = wood(0).sigma, step = 0.003 * sigma, h;

   for (h = -2.0; h < 5.0; h += 0.37) {
      double d[5], p[5], s[5], e[5];
      int i;
      for (i = 0; i < 5; i++)
         d[i] = h * sigma + (i - 2) * step;
      CHECK_CODE(asperity_law_evaluate(law, 5, d, p, s, NULL, NULL, e, NULL, &error), 0);
      CHECK_NEAR(-(p[0] - 8.0 * p[1] + 8.0 * p[3] - p[4]) / (12.0 * step), s[2], 2e-8, 0.0);
      CHECK_NEAR(-(e[0] - 8.0 * e[1] + 8.0 * e[3] - e[4]) / (12.0 * step), p[2], 2e-8, 0.0);
   }
   asperity_law_free(&law, NULL);
}

/* The pressure at the separation for a pressure is that pressure. */
static void inverse(int compiled, double tolerance)
{
   asperity_law *law = wood_law(compiled);
   asperity_error error;
   double pressure, d, p, s;

   for (pressure = 1e-8; pressure < 100.0; pressure *= 7.0) {
      CHECK_CODE(asperity_law_separation(law, pressure, &d, &error), 0);
      CHECK_CODE(asperity_law_evaluate(law, 1, &d, &p, &s, NULL, NULL, NULL, NULL, &error), 0);
      CHECK_NEAR(p, pressure, tolerance, 0.0);
   }
   asperity_law_free(&law, NULL);
}

void test_law(void)
{
   asperity_properties p = wood(0), second = p;

   second.eta = 134.0;
   second.modulus = 263.0;
   second.radius = 0.1142;
   second.hardness = 12.14;
   second.sigma = 0.0416;
   against_quadrature(&p, 2e-12);
   against_quadrature(&second, 2e-12);
   second.yield_factor = 0.9;
   against_quadrature(&second, 2e-12);
   p.compiled = 1;
   second.compiled = 1;
   against_quadrature(&p, 1.1e-10);
   against_quadrature(&second, 1.1e-10);
   optional_arrays(0);
   optional_arrays(1);
   differences(0);
   differences(1);
   /* 4 eps of the separation times the logarithmic slope, which is below 10 per sigma here */
   inverse(0, 2e-13 * 10.0);
   inverse(1, 1.1e-10);
}
