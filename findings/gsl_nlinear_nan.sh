#!/usr/bin/env bash
# GSL 2.7.1: nonlinear least squares takes a step to where the model is no number, and calls it success.
#
# A good guess: gsl_multifit_nlinear_driver never accepts a step that does not lower the sum of squares, and
# returns an error where it can go no further. Seen, for y = a exp(-sqrt(b) x) from a = 1, b = 4, with GSL's
# own differences: the first step goes to b below zero, residuals are NaN, and the end is `success` by the
# test of the gradient, as no comparison with NaN is true. The minimum is a = 2, b = 2.25, and is found from
# b = 1. So the sum of squares has to be looked at.
source "$(dirname "$0")/lib/setup.sh"
debian_package libgsl-dev=2.7.1+dfsg-5+deb12u1
debian_package libgsl27=2.7.1+dfsg-5+deb12u1
debian_package libgslcblas0=2.7.1+dfsg-5+deb12u1
cat >fit.c <<'C'
#include <math.h>
#include <stdio.h>
#include <gsl/gsl_blas.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_multifit_nlinear.h>
#include <gsl/gsl_version.h>

static int residuals(const gsl_vector *p, void *data, gsl_vector *r)
{
   (void)data;
   for (int i = 0; i < 10; i++) {
      double x = 0.3*i, model = gsl_vector_get(p, 0)*exp(-sqrt(gsl_vector_get(p, 1))*x);
      gsl_vector_set(r, i, model - 2*exp(-1.5*x));
   }
   return GSL_SUCCESS;
}

static void fit(double a, double b)
{
   gsl_multifit_nlinear_parameters settings = gsl_multifit_nlinear_default_parameters();
   gsl_multifit_nlinear_workspace *work =
      gsl_multifit_nlinear_alloc(gsl_multifit_nlinear_trust, &settings, 10, 2);
   gsl_multifit_nlinear_fdf problem = {.f = residuals, .n = 10, .p = 2};
   double start[2] = {a, b}, sum;
   gsl_vector_view view = gsl_vector_view_array(start, 2);
   int reason, status;

   gsl_multifit_nlinear_winit(&view.vector, NULL, &problem, work);
   status = gsl_multifit_nlinear_driver(100, 1e-8, 1e-8, 0, NULL, NULL, &reason, work);
   gsl_blas_ddot(work->f, work->f, &sum);
   printf("GSL %s from b = %g: %s, b %s 0, sum of squares %s\n", gsl_version, b, gsl_strerror(status),
          gsl_vector_get(work->x, 1) < 0 ? "<" : ">", isnan(sum) ? "NaN" : "small");
   gsl_multifit_nlinear_free(work);
}

int main(void)
{
   gsl_set_error_handler_off();
   fit(1, 1);
   fit(1, 4);
   return 0;
}
C
library=$(dirname "$(find debian -name libgsl.so.27)")
cc -std=c99 -Wall -I debian/usr/include fit.c -o fit -L "$library" -Wl,-rpath,"$folder/$library" -lgsl -lgslcblas -lm
expect 'GSL 2.7.1 from b = 1: success, b > 0, sum of squares small
GSL 2.7.1 from b = 4: success, b < 0, sum of squares NaN' "$(./fit)"
