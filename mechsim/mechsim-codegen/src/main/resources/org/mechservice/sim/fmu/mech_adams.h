/* Adams method of variable order (1 to 13) and step in PECE form: the method ode113.
 * Shampine and Gordon, Computer Solution of Ordinary Differential Equations, 1975.
 * Everything lies in the structure: no allocation, no globals; a copy of it goes on alike. */
#ifndef MECH_ADAMS_H
#define MECH_ADAMS_H

#include "mech_steps.h"

enum { MECH_HIGHEST_ORDER = 12, MECH_LENGTH = 15, MECH_WINDOW = 50 };

typedef struct {
  /* Problem: tolerances, the longest step, the end that no step passes (HUGE_VAL: none). */
  double rtol, atol, longest, stop;
  /* The last accepted step: its ends, size and order. */
  double t, previous, size;
  int taken;
  /* The next step. */
  double h;
  int order, lower, starting, failures;
  double error, here, below;
  /* Coefficients, counted from 1. */
  double beta[MECH_LENGTH], sigma[MECH_LENGTH], g[MECH_LENGTH], psi[MECH_LENGTH];
  double tried[MECH_LENGTH], alpha[MECH_LENGTH], v[MECH_LENGTH], w[MECH_LENGTH];
  int equal, last_order;
  double last_size;
  /* History: state, modified divided differences of the derivative, round-off carried along. */
  double x[MECH_N], phi[MECH_LENGTH][MECH_N], ahead[MECH_LENGTH][MECH_N];
  double predicted[MECH_N], corrected[MECH_N], f[MECH_N], d[MECH_N], weight[MECH_N];
  double carry[MECH_N], predicted_carry[MECH_N], corrected_carry[MECH_N];
  /* Steps at the limit of stability among the last ones, and the verdict. */
  unsigned char limited[MECH_WINDOW];
  int slot, limited_steps, stiff;
  double tries;
} mech_adams;

/* Begins at order 1 from (t, x), which it moves onto the constraints. */
mech_step_result mech_adams_begin(mech_adams *a, MODEL_T *m, double t, const double *x);
/* Takes one step, accepted, of the size that the error allows; at most so many tries. */
mech_step_result mech_adams_step(mech_adams *a, MODEL_T *m, long tries);
/* The solution inside the last step. */
void mech_adams_interpolate(const mech_adams *a, double t, double *x);

#endif
