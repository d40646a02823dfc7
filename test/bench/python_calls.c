/* Calls of the C interface from C, timed where they are made: for test/bench/python.py, which hands
 * over the functions of the library that the package has loaded. */
#define _POSIX_C_SOURCE 199309L
#include <asperity.h>
#include <time.h>

typedef int evaluate_function(const asperity_law *, int, const double *, double *, double *, double *,
                              double *, double *, int *, asperity_error *);
typedef int update_function(const asperity_law *, asperity_states *, int, const double *, const double *,
                            const double *, double, double *, double *, double *, double *, double *,
                            double *, int *, asperity_error *);

static double now(void)
{
   struct timespec t;

   clock_gettime(CLOCK_MONOTONIC, &t);
   return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* Seconds of one call; negative after an error */
double time_evaluate(evaluate_function *evaluate, const asperity_law *law, int n, const double *separation,
                     double *pressure, double *stiffness, double *area_fraction, double *contact_density,
                     double *energy, int *validity)
{
   asperity_error error;
   double start = now();

   evaluate(law, n, separation, pressure, stiffness, area_fraction, contact_density, energy, validity,
            &error);
   return error.code == ASPERITY_OK ? now() - start : -1.0;
}

double time_update(update_function *update, const asperity_law *law, asperity_states *states, int n,
                   const double *overclosure, const double *slip_increment, const double *rotation,
                   double time_increment, double *traction, double *tangent, double *tangential_energy,
                   double *dissipation, double *plastic_dissipation, double *pressure_coupling,
                   int *validity)
{
   asperity_error error;
   double start = now();

   update(law, states, n, overclosure, slip_increment, rotation, time_increment, traction, tangent,
          tangential_energy, dissipation, plastic_dissipation, pressure_coupling, validity, &error);
   return error.code == ASPERITY_OK ? now() - start : -1.0;
}
