/* Prints for four tolerances the error at t = 40 over the tolerance, and the evaluations. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "mech_backward.h"

/* Hairer and Wanner, Solving Ordinary Differential Equations II, 1996, section IV.1. */
static const double RIGHT[] = {0.7158270687194135, 9.185534764557763e-6, 0.2841637457458219};

int robertson_derivatives(robertson_t *m, double t, const double *x, double *dx) {
  (void)t;
  m->evaluations++;
  dx[0] = -0.04 * x[0] + 1e4 * x[1] * x[2];
  dx[2] = 3e7 * x[1] * x[1];
  dx[1] = -dx[0] - dx[2];
  return 0;
}

int main(void) {
  static mech_backward b;
  double rtol;
  for (rtol = 1e-4; rtol > 1e-11; rtol *= 1e-2) {
    robertson_t m = {0};
    double x[3] = {1, 0, 0}, error = 0;
    int i;
    memset(&b, 0, sizeof b);
    b.rtol = rtol;
    b.atol = 1e-6 * rtol;
    b.longest = 40;
    b.stop = 40;
    mech_backward_begin(&b, &m, 0, x);
    while (b.t < 40) {
      if (mech_backward_step(&b, &m, 100000) != MECH_STEP_DONE) {
        printf("no step at %g\n", b.t);
        return 1;
      }
    }
    for (i = 0; i < 3; i++) {
      error = fmax(error, fabs(b.x[i] / RIGHT[i] - 1));
    }
    printf("%g %d\n", error / rtol, m.evaluations);
  }
  return 0;
}
