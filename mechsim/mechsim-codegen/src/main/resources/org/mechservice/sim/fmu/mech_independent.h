/* The model in independent coordinates: its states are the coordinates chosen at the build, their
 * velocities, and the further states. Every evaluation computes the other coordinates by Newton's
 * method from those of the last accepted step, and their velocities from linear equations; both lie
 * on the loops but for rounding. The others are outputs behind those of the model. */
#ifndef MECH_INDEPENDENT_H
#define MECH_INDEPENDENT_H

#include "MODEL.h"

enum {
  mech_independent_NX = @NX@,
  mech_independent_NP = MODEL_NP,
  mech_independent_NU = MODEL_NU,
  mech_independent_NY = MODEL_NY + @OTHERS@,
  mech_independent_NG = MODEL_NG,
  MODEL_NV = @NV@
};

/* An instance: a copy of the structure is a copy of the instance. */
typedef struct {
  MODEL_t full;
  /* The whole state of the last accepted step, and the one that belongs to (t, x; p, u)_known. */
  double accepted[MODEL_NX], y[MODEL_NX];
  /* Time and derivative of the accepted one. */
  double t_accepted, rates[MODEL_NX];
  int y_known, rates_known;
  double t_known, x_known[@NX@];
  double p_known[sizeof(((MODEL_t *)0)->p) / sizeof(double)];
  double u_known[sizeof(((MODEL_t *)0)->u) / sizeof(double)];
  /* How well the others are determined: now, at the last accepted step, at the start. */
  double quality, accepted_quality, first_quality;
  /* Whether the coordinates have come to a position in which they do not determine the others, and
   * remain there; evaluations without a state since the last accepted step. */
  int lost, stays_lost, failures;
  char text[400];
} mech_independent_t;

void mech_independent_init(mech_independent_t *m);
int mech_independent_start(mech_independent_t *m, double t0, double *x);
int mech_independent_derivatives(mech_independent_t *m, double t, const double *x, double *dx);
int mech_independent_outputs(mech_independent_t *m, double t, const double *x, double *out);
int mech_independent_event_values(mech_independent_t *m, double t, const double *x, double *g);
int mech_independent_event(mech_independent_t *m, const signed char *occurred, double t, double *x);
int mech_independent_begin(mech_independent_t *m, double t, double *x);
int mech_independent_go_on(mech_independent_t *m, double t, double *x);
int mech_independent_project(mech_independent_t *m, double t, double *x);
int mech_independent_close(mech_independent_t *m, double t, double *x, const unsigned char *set);
void mech_independent_accepted(mech_independent_t *m, double t, const double *x);
double mech_independent_next_jump(const mech_independent_t *m, double t);
const char *mech_independent_failure(const mech_independent_t *m);

#endif
