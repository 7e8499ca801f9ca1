/* Robertson's reaction in the place of a model: three states, rate constants from 0.04 to 3e7. */
#ifndef ROBERTSON_H
#define ROBERTSON_H
#define MODEL_NX 3
typedef struct {
  int evaluations;
} robertson_t;
#define MODEL_T robertson_t
#define MODEL_derivatives robertson_derivatives
#define MODEL_project(m, t, x) ((void)(m), 0)
int robertson_derivatives(robertson_t *m, double t, const double *x, double *dx);
#endif
