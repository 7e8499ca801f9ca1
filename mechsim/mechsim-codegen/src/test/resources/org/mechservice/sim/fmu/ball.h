#ifndef BALL_H
#define BALL_H
enum { ball_NX = 2, ball_NP = 1, ball_NU = 0, ball_NY = 2, ball_NG = 1 };
typedef struct {
  double p[1];
  double u[1];
} ball_t;
void ball_init(ball_t *m);
int ball_start(ball_t *m, double t0, double *x);
int ball_derivatives(ball_t *m, double t, const double *x, double *dx);
int ball_outputs(ball_t *m, double t, const double *x, double *y);
int ball_event_values(ball_t *m, double t, const double *x, double *g);
int ball_event(ball_t *m, const signed char *occurred, double t, double *x);
int ball_project(ball_t *m, double t, double *x);
int ball_directional(ball_t *m, double t, const double *x, const double *seed, double *dx);
const char *ball_failure(const ball_t *m);
#endif
