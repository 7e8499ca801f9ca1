/*
 * Searches steps: reads from and to, then for each state four coefficients of a cubic in the time
 * from the start of the step; writes where the step has to end, and the longest step behind.
 */
#include <stdio.h>

#include "mech_fmu.h"

typedef struct {
  MODEL_T model;
  double given[2 + 4 * MECH_N];
} way;

static int quantities_at(void *run, double t, double *quantities) {
  way *w = run;
  double x[MECH_N], s = t - w->given[0];
  int i;
  for (i = 0; i < MODEL_NX; i++) {
    const double *c = w->given + 2 + 4 * i;
    x[i] = c[0] + s * (c[1] + s * (c[2] + s * c[3]));
  }
  return MODEL_watched(&w->model, t, x, quantities) >= 0;
}

int main(void) {
  static way w;
  static mech_watch kept;
  static mech_watch_work work;
  size_t count = 2 + 4 * MODEL_NX;
  MODEL_init(&w.model);
  mech_watch_init(&kept);
  while (fread(w.given, sizeof(double), count, stdin) == count) {
    double result[2];
    result[0] = mech_watch_search(&kept, &work, quantities_at, &w, w.given[0], w.given[1]);
    result[1] = kept.longest_first_step;
    fwrite(result, sizeof(double), 2, stdout);
  }
  return 0;
}
