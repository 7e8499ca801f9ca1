#ifndef CIRCLE_H
#define CIRCLE_H
enum { circle_NX = 4, circle_NP = 2, circle_NU = 1, circle_NY = 2, circle_NG = 0 };
typedef struct {
  double p[2];
  double u[1];
} circle_t;
void circle_init(circle_t *m);
int circle_start(circle_t *m, double t0, double *x);
int circle_derivatives(circle_t *m, double t, const double *x, double *dx);
int circle_outputs(circle_t *m, double t, const double *x, double *y);
int circle_event_values(circle_t *m, double t, const double *x, double *g);
int circle_event(circle_t *m, const signed char *occurred, double t, double *x);
int circle_project(circle_t *m, double t, double *x);
int circle_directional(circle_t *m, double t, const double *x, const double *seed, double *dx);
const char *circle_failure(const circle_t *m);
#endif
