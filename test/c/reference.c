/* The normal law once more, in C and by plain Simpson sums: independent of the library's rules.
 *
 * A summit of height z is deformed by w = z - d. Its force N, area A, and work W:
 *    elastic, w < w1            N1 (w/w1)^1.5     pi R w              2/5 N1 w1 (w/w1)^2.5
 *    elasto-plastic, w < w2     N1 (w/w1)^b3      pi R w1 (w/w1)^b2   the integral of N
 *    plastic                    2 pi R H w        2 pi R w            the integral of N
 * Each range is summed in a variable in which the integrand is smooth: the root of w, its
 * logarithm, and w itself.
 */
#include "check.h"

#include <math.h>

static const double pi = 3.14159265358979323846;

/* Steps of one range; even. With it the sums are good to 2e-13, as halving it shows. */
enum { steps = 20000 };

typedef struct constants {
   double w1, w2, n1, b2, b3, work_1, work_2;
} constants;

static constants derive(const asperity_properties *p)
{
   constants c;
   c.w1 = pow(3.0 * pi * p->yield_factor * p->hardness / (4.0 * p->modulus), 2) * p->radius;
   c.w2 = 110.0 * c.w1;
   c.n1 = pi * p->yield_factor * p->hardness * p->radius * c.w1;
   c.b2 = 1.0 + log(2.0) / log(110.0);
   c.b3 = 1.0 + log(2.0 / p->yield_factor) / log(110.0);
   c.work_1 = 0.4 * c.n1 * c.w1;
   c.work_2 = c.work_1 + c.n1 * c.w1 * (pow(110.0, c.b3 + 1.0) - 1.0) / (c.b3 + 1.0);
   return c;
}

/* Add what summits deformed by w carry, times a weight. */
static void add(reference *sum, const asperity_properties *p, const constants *c, double separation,
                double w, double weight)
{
   double z = (separation + w) / p->sigma;
   double r = w / c->w1;
   double force, slope, area, work;

   weight *= p->eta * exp(-0.5 * z * z) / (sqrt(2.0 * pi) * p->sigma);
   if (w < c->w1) {
      force = c->n1 * r * sqrt(r);
      slope = 1.5 * c->n1 * sqrt(r) / c->w1;
      area = pi * p->radius * w;
      work = 0.4 * force * w;
   } else if (w < c->w2) {
      force = c->n1 * pow(r, c->b3);
      slope = c->b3 * force / w;
      area = pi * p->radius * c->w1 * pow(r, c->b2);
      work = c->work_1 + (force * w - c->n1 * c->w1) / (c->b3 + 1.0);
   } else {
      slope = 2.0 * pi * p->radius * p->hardness;
      force = slope * w;
      area = 2.0 * pi * p->radius * w;
      work = c->work_2 + 0.5 * slope * (w - c->w2) * (w + c->w2);
   }
   sum->pressure += weight * force;
   sum->stiffness += weight * slope;
   sum->area_fraction += weight * area;
   sum->energy += weight * work;
}

/* Weight of Simpson's rule at point i, for a range of length 1. */
static double simpson(int i)
{
   double weight = i == 0 || i == steps ? 1.0 : i % 2 == 1 ? 4.0 : 2.0;
   return weight / (3.0 * steps);
}

reference reference_law(const asperity_properties *p, double separation)
{
   constants c = derive(p);
   reference sum = {0.0, 0.0, 0.0, 0.0, 0.0};
   double start = fmax(c.w2, -separation - 12.0 * p->sigma);
   double length = fmax(c.w2, -separation) + 12.0 * p->sigma - start;
   int i;

   for (i = 0; i <= steps; i++) {
      double u = (double)i / steps;
      double elastic = c.w1 * u * u * (1.0 - 1e-15);
      double middle = c.w1 * exp(u * log(110.0));
      double plastic = start + length * u;
      add(&sum, p, &c, separation, elastic, simpson(i) * 2.0 * c.w1 * u);
      add(&sum, p, &c, separation, fmin(fmax(middle, c.w1), c.w2 * (1.0 - 1e-15)),
          simpson(i) * middle * log(110.0));
      add(&sum, p, &c, separation, fmax(plastic, c.w2), simpson(i) * length);
   }
   sum.contact_density = 0.5 * p->eta * erfc(separation / (p->sigma * sqrt(2.0)));
   return sum;
}
