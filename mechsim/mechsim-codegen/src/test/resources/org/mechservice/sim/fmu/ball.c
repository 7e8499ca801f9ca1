/* A ball that bounces: height and speed. */
#include "ball.h"

void ball_init(ball_t *m) {
  m->p[0] = 0.7;
  m->u[0] = 0;
}
int ball_start(ball_t *m, double t0, double *x) {
  (void)m;
  (void)t0;
  x[0] = 1;
  x[1] = 0;
  return 0;
}
int ball_derivatives(ball_t *m, double t, const double *x, double *dx) {
  (void)m;
  (void)t;
  dx[0] = x[1];
  dx[1] = -9.81;
  return 0;
}
int ball_outputs(ball_t *m, double t, const double *x, double *y) {
  (void)m;
  (void)t;
  y[0] = x[0];
  y[1] = 9.81 * x[0] + 0.5 * x[1] * x[1];
  return 0;
}
int ball_event_values(ball_t *m, double t, const double *x, double *g) {
  (void)m;
  (void)t;
  g[0] = x[0];
  return 0;
}
int ball_event(ball_t *m, const signed char *occurred, double t, double *x) {
  (void)t;
  if (occurred[0] > 0) {
    return 0;
  }
  x[1] = -m->p[0] * x[1];
  return 1;
}
int ball_project(ball_t *m, double t, double *x) {
  (void)m;
  (void)t;
  (void)x;
  return 0;
}
int ball_directional(ball_t *m, double t, const double *x, const double *seed, double *dx) {
  (void)m;
  (void)t;
  (void)x;
  dx[0] = seed[1];
  dx[1] = 0;
  return 0;
}
const char *ball_failure(const ball_t *m) {
  (void)m;
  return "";
}
