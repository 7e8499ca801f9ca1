/* A point on a circle of radius 1, in redundant coordinates: x, y and their rates; gravity and the
 * stiffness of a spring that has no effect on the circle as parameters, a tangential force as
 * input. */
#include "circle.h"

#include <math.h>

void circle_init(circle_t *m) {
  m->p[0] = 9.81;
  m->p[1] = 0;
  m->u[0] = 0;
}
int circle_start(circle_t *m, double t0, double *x) {
  (void)m;
  (void)t0;
  x[0] = 1;
  x[1] = x[2] = x[3] = 0;
  return 0;
}
int circle_derivatives(circle_t *m, double t, const double *x, double *dx) {
  double fx = -m->u[0] * x[1], fy = m->u[0] * x[0] - m->p[0];
  double pull = x[0] * fx + x[1] * fy + x[2] * x[2] + x[3] * x[3];
  double size = x[0] * x[0] + x[1] * x[1];
  (void)t;
  if (!(size > 0)) {
    return -1;
  }
  dx[0] = x[2] - m->p[1] * (x[0] - cos(t));
  dx[1] = x[3];
  dx[2] = fx - pull / size * x[0];
  dx[3] = fy - pull / size * x[1];
  return 0;
}
int circle_outputs(circle_t *m, double t, const double *x, double *y) {
  (void)t;
  y[0] = 0.5 * (x[2] * x[2] + x[3] * x[3]) + m->p[0] * x[1];
  y[1] = sqrt(x[0] * x[0] + x[1] * x[1]) - 1;
  return 0;
}
int circle_event_values(circle_t *m, double t, const double *x, double *g) {
  (void)m;
  (void)t;
  (void)x;
  (void)g;
  return 0;
}
int circle_event(circle_t *m, const signed char *occurred, double t, double *x) {
  (void)m;
  (void)occurred;
  (void)t;
  (void)x;
  return 0;
}
int circle_project(circle_t *m, double t, double *x) {
  double size = sqrt(x[0] * x[0] + x[1] * x[1]), along;
  (void)t;
  if (m->p[1] != 0) {
    return 0;
  }
  if (!(size > 0)) {
    return -1;
  }
  x[0] /= size;
  x[1] /= size;
  along = x[0] * x[2] + x[1] * x[3];
  x[2] -= along * x[0];
  x[3] -= along * x[1];
  return 1;
}
int circle_directional(circle_t *m, double t, const double *x, const double *seed, double *dx) {
  (void)m;
  (void)t;
  (void)x;
  (void)seed;
  (void)dx;
  return -1;
}
const char *circle_failure(const circle_t *m) {
  (void)m;
  return "the point is at the centre.";
}
