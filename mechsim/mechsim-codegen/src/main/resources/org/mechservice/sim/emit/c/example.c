/*
 * Steps the model with the classical Runge-Kutta method and prints its states.
 * cc -std=c99 -O2 -ffp-contract=off example.c MODEL.c mech_math.c -lm -o example && ./example 1 1e-3
 */
#include <stdio.h>
#include <stdlib.h>

#include "MODEL.h"

static void step(MODEL_t *m, double t, double h, double *x) {
  double k[4][MODEL_NX], stage[MODEL_NX];
  static const double AT[] = {0, 0.5, 0.5, 1};
  for (int s = 0; s < 4; s++) {
    for (int i = 0; i < MODEL_NX; i++) {
      stage[i] = s == 0 ? x[i] : x[i] + AT[s] * h * k[s - 1][i];
    }
    if (MODEL_derivatives(m, t + AT[s] * h, stage, k[s]) != 0) {
      fprintf(stderr, "t = %g: %s\n", t, MODEL_failure(m));
      exit(1);
    }
  }
  for (int i = 0; i < MODEL_NX; i++) {
    x[i] += h / 6 * (k[0][i] + 2 * k[1][i] + 2 * k[2][i] + k[3][i]);
  }
  MODEL_project(m, t + h, x);
}

int main(int count, char **values) {
  double end = count > 1 ? atof(values[1]) : 1;
  double h = count > 2 ? atof(values[2]) : 1e-3;
  MODEL_t m;
  double x[MODEL_NX], t = 0;
  long i = 1;
  MODEL_init(&m);
  MODEL_start(&m, t, x);
  MODEL_begin(&m, t, x);
  while (t < end) {
    double next = (double)i * h < end ? (double)i * h : end, jump = MODEL_next_jump(&m, t);
    if (jump <= next) { /* no step passes a jump of the equations or a sample */
      step(&m, t, jump - t, x);
      MODEL_go_on(&m, t = jump, x);
    } else {
      step(&m, t, next - t, x);
      t = next;
      i++;
    }
  }
  for (int k = 0; k < MODEL_NX; k++) {
    printf("%s = %.15g %s\n", MODEL_states[k].name, x[k], MODEL_states[k].unit);
  }
  return 0;
}
