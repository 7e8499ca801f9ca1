/* Numerical differentiation formulas of orders 1 to 5 on backward differences: the method ode15s,
 * for stiff models. Shampine and Reichelt, The MATLAB ODE Suite, SIAM J. Sci. Comput. 18, 1997.
 * Everything lies in the structure, as in mech_adams.h. */
#ifndef MECH_BACKWARD_H
#define MECH_BACKWARD_H

#include "mech_steps.h"

enum { MECH_ORDERS = 5 };

typedef struct {
  double rtol, atol, longest, stop;
  /* The last accepted step: its ends. */
  double t, previous;
  /* The next step, and the size that the differences and factors belong to. */
  double h, of_differences, of_factors;
  int order, of_order, equal, jacobian_current, jacobian_known, rate_known;
  double rate;
  int stiff;
  double tries;
  /* Differences of the state, from 1. */
  double x[MECH_N], d[MECH_ORDERS + 3][MECH_N];
  double jacobian[MECH_N][MECH_N], factors[MECH_N][MECH_N];
  int row[MECH_N];
  double f[MECH_N], predicted[MECH_N], correction[MECH_N], tried[MECH_N], psi[MECH_N];
  double weight[MECH_N];
} mech_backward;

mech_step_result mech_backward_begin(mech_backward *b, MODEL_T *m, double t, const double *x);
mech_step_result mech_backward_step(mech_backward *b, MODEL_T *m, long tries);
void mech_backward_interpolate(const mech_backward *b, double t, double *x);

#endif
