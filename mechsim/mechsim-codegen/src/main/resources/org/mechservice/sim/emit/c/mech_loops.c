#include "mech_loops.h"

#include <float.h>
#include <math.h>
#include <stdint.h>
#include <string.h>

#include "mech_math.h"

enum { REPETITIONS = 10, ITERATIONS = 12, ITERATIONS_AFTER_JUMP = 60, WITHOUT_INERTIA = 1000000 };

static const double ACCURATE = 1e-11, GAIN = 0.1;
/* Relative residuals that are left alone, and that are accepted if they do not get smaller. */
static const double CLOSED = 1e-13, ACCEPTED = 1e-11;
/* Longest move of a coordinate in one iteration after a jump, and in all of a projection. */
static const double LONGEST_STEP = 0.4, TOO_FAR = 0.5;
/* Relative change of velocities above which they belong to another branch; speed of rounding. */
static const double OTHER_BRANCH = 0.25, SLOWEST = 1e-9;
static const double ROUNDINGS = 4, LEFT_ALONE = 0.5;
/* Smallest pivot, relative to the largest, of coordinates that the others determine: nowhere, and
 * well enough to choose them. */
static const double SINGULAR = 1e-12, CHOSEN = 1e-6;

/* Places of the workspace. */
typedef struct {
  double *y;                                   /* state and unwrapped angles */
  double *value, *rate, *jacobian, *measured;  /* terms, laid out as the programs write them */
  double *gamma, *bias, *mass;
  double *j, *rows;                            /* J; divided by the sizes, then rows that hold */
  double *size, *penalty, *gap, *lambda, *offset; /* one number per row, held ones behind */
  double *force, *right, *change, *a;
  double *full, *augmented, *factors;
  double *columns;                             /* of J, for coordinates that others determine */
  double *given, *along;                       /* a and lambda, and a derivative of their equations */
} parts;

static parts places(const mech_loops *l, double *work) {
  parts p;
  int m = l->m, n = l->nv, all = m + n;
  double *w = work;
  p.y = w + l->na;
  w = p.y + l->nq + l->nv + l->ns + l->na;
  p.value = w;
  p.rate = p.value + m;
  p.jacobian = p.rate + m;
  p.measured = p.jacobian + m * n;
  p.gamma = p.measured + m;
  p.bias = p.gamma + m;
  p.mass = p.bias + n;
  p.full = p.mass + n * n;
  p.factors = p.full + n * n;
  p.augmented = p.factors + n * n;
  p.j = p.augmented + n * n;
  p.rows = p.j + l->pattern;
  p.size = p.rows + l->pattern + n;
  p.penalty = p.size + m;
  p.gap = p.penalty + all;
  p.lambda = p.gap + all;
  p.offset = p.lambda + all;
  p.force = p.offset + all;
  p.right = p.force + n;
  p.change = p.right + n;
  p.a = p.change + n;
  p.columns = p.a + n;
  p.given = p.columns + m * n;
  p.along = p.given + all;
  return p;
}

static double larger(double part, double largest) {
  return part > largest || part != part ? part : largest;
}

/* Distance to the next number of larger size. */
static double ulp(double x) {
  uint64_t bits, unit;
  double result;
  int exponent;
  memcpy(&bits, &x, sizeof bits);
  exponent = (int)(bits >> 52 & 0x7ff);
  if (exponent == 0x7ff) {
    return fabs(x);
  }
  unit = exponent > 52 ? (uint64_t)(exponent - 52) << 52
                       : (uint64_t)1 << (exponent > 0 ? exponent - 1 : 0);
  memcpy(&result, &unit, sizeof result);
  return result;
}

const double *mech_loops_state(const mech_loops *l, double *work, const double *x) {
  int count = l->nq + l->nv + l->ns;
  double *y = work + l->na;
  memcpy(y, x, (size_t)count * sizeof(double));
  memcpy(y + count, work, (size_t)l->na * sizeof(double));
  return y;
}

/* Row e times a vector, and a row times a factor added to a vector. The pattern of a row that
 * holds velocity k is its one element. */
static int row_start(const mech_loops *l, int row) {
  return row <= l->m ? l->start[row] : l->start[l->m] + row - l->m;
}

static int column(const mech_loops *l, int e) {
  return e < l->pattern ? l->column[e] : e - l->pattern;
}

static double product(const mech_loops *l, const double *rows, int row, const double *x) {
  double sum = 0;
  int e, end = row_start(l, row + 1);
  for (e = row_start(l, row); e < end; e++) {
    sum += rows[e] * x[column(l, e)];
  }
  return sum;
}

static void add_row(const mech_loops *l, const double *rows, int row, double factor, double *x) {
  int e, end = row_start(l, row + 1);
  for (e = row_start(l, row); e < end; e++) {
    x[column(l, e)] += factor * rows[e];
  }
}

static void take_jacobian(const mech_loops *l, const parts *p) {
  int row, e;
  for (row = 0; row < l->m; row++) {
    for (e = l->start[row]; e < l->start[row + 1]; e++) {
      p->j[e] = p->jacobian[row * l->nv + l->column[e]];
    }
    p->size[row] = p->measured[row] > 0 ? p->measured[row] : l->size[row];
  }
}

static void place(const mech_loops *l, void *model, double *work, const parts *p, double t,
                  const double *x) {
  l->loops(model, t, mech_loops_state(l, work, x), p->value);
  take_jacobian(l, p);
}

static void complete_mass(const mech_loops *l, const parts *p) {
  int i, j, n = l->nv;
  for (i = 0; i < n; i++) {
    for (j = 0; j <= i; j++) {
      p->full[i * n + j] = p->full[j * n + i] = p->mass[i * n + j];
    }
  }
}

/* L of A = L L'; returns -1, or the row without a pivot. */
static int cholesky(double *low, const double *matrix, int n) {
  int i, j, k;
  for (i = 0; i < n; i++) {
    for (j = 0; j <= i; j++) {
      double sum = matrix[i * n + j];
      for (k = 0; k < j; k++) {
        sum -= low[i * n + k] * low[j * n + k];
      }
      if (j < i) {
        low[i * n + j] = sum / low[j * n + j];
      } else if (!(sum > 64 * DBL_EPSILON * matrix[i * n + i]) || !(sum <= DBL_MAX)) {
        return i;
      } else {
        low[i * n + i] = sqrt(sum);
      }
    }
  }
  return -1;
}

static void substitute(const double *low, int n, double *b) {
  int i, k;
  for (i = 0; i < n; i++) {
    double sum = b[i];
    for (k = 0; k < i; k++) {
      sum -= low[i * n + k] * b[k];
    }
    b[i] = sum / low[i * n + i];
  }
  for (i = n - 1; i >= 0; i--) {
    double sum = b[i];
    for (k = i + 1; k < n; k++) {
      sum -= low[k * n + i] * b[k];
    }
    b[i] = sum / low[i * n + i];
  }
}

/* Factors M + alpha J'J, some velocities held; returns -1, or the velocity without inertia. */
static int factor(const mech_loops *l, const parts *p, const unsigned char *held) {
  int i, row, e, n = l->nv, count = l->m + (held != NULL ? n : 0);
  double largest = 0, penalty;
  for (i = 0; i < n; i++) {
    double inertia = p->full[i * n + i] * l->unit[i] * l->unit[i];
    largest = inertia > largest || inertia != inertia ? inertia : largest;
  }
  penalty = l->stiffness * largest;
  for (row = 0; row < l->m; row++) {
    double per_size = 1 / p->size[row];
    for (e = l->start[row]; e < l->start[row + 1]; e++) {
      p->rows[e] = per_size * p->j[e];
    }
  }
  for (i = 0; held != NULL && i < n; i++) {
    p->rows[l->pattern + i] = held[i] ? 1 / l->unit[i] : 0;
  }
  memcpy(p->augmented, p->full, (size_t)(n * n) * sizeof(double));
  for (row = 0; row < count; row++) {
    double square = 0;
    int end = row_start(l, row + 1);
    for (e = row_start(l, row); e < end; e++) {
      double part = p->rows[e] * l->unit[column(l, e)];
      square += part * part;
    }
    p->penalty[row] = penalty / (square > 1 || square != square ? square : 1);
    for (e = row_start(l, row); e < end; e++) {
      double weighted = p->penalty[row] * p->rows[e];
      if (weighted != 0) {
        add_row(l, p->rows, row, weighted, p->augmented + n * column(l, e));
      }
    }
  }
  return cholesky(p->factors, p->augmented, n);
}

/* Solves M x + J' lambda = right, J x + offset = 0 with the last factors. */
static void solve(const mech_loops *l, const parts *p, int count, double *x) {
  int i, j, k, row, n = l->nv;
  double open = HUGE_VAL;
  memset(x, 0, (size_t)n * sizeof(double));
  memset(p->lambda, 0, (size_t)count * sizeof(double));
  memcpy(p->force, p->right, (size_t)n * sizeof(double));
  memcpy(p->gap, p->offset, (size_t)count * sizeof(double));
  for (i = 0; i < REPETITIONS; i++) {
    double scale = 0, left = 0;
    for (row = 0; row < count; row++) {
      double push = p->penalty[row] * p->gap[row];
      if (push != 0) {
        add_row(l, p->rows, row, -push, p->force);
      }
    }
    substitute(p->factors, n, p->force);
    for (row = 0; row < count; row++) {
      p->gap[row] = p->penalty[row] * (p->gap[row] + product(l, p->rows, row, p->force));
    }
    for (row = 0; row < count; row++) {
      p->lambda[row] += p->gap[row];
    }
    for (j = 0; j < n; j++) {
      x[j] += p->force[j];
    }
    for (j = 0; j < n; j++) {
      double sum = p->right[j];
      for (k = 0; k < n; k++) {
        sum -= p->full[j * n + k] * x[k];
      }
      p->force[j] = sum;
    }
    for (row = 0; row < count; row++) {
      double moved = product(l, p->rows, row, x);
      p->gap[row] = p->offset[row] + moved;
      scale = larger(larger(fabs(moved), fabs(p->offset[row])), scale);
      add_row(l, p->rows, row, -p->lambda[row], p->force);
    }
    for (row = 0; row < count; row++) {
      left = larger(fabs(p->gap[row]), left);
    }
    if (i > 0 && (!(left > ACCURATE * scale) || !(left < GAIN * open))) {
      return;
    }
    open = left;
  }
}

/* Rate of Euler parameters e at an angular velocity. */
static void ball_rate(const double *e, const double *omega, double *rate) {
  double wx = 0.5 * omega[0], wy = 0.5 * omega[1], wz = 0.5 * omega[2];
  rate[0] = -wx * e[1] - wy * e[2] - wz * e[3];
  rate[1] = wx * e[0] + wy * e[3] - wz * e[2];
  rate[2] = wy * e[0] + wz * e[1] - wx * e[3];
  rate[3] = wz * e[0] + wx * e[2] - wy * e[1];
}

int mech_loops_derivatives(const mech_loops *l, void *model, double *work, double t,
                           const double *x, double *dx, int *failure) {
  parts p = places(l, work);
  int i, j, b, singular, result;
  mech_loops_state(l, work, x);
  result = l->equations(model, t, p.y, p.value);
  complete_mass(l, &p);
  take_jacobian(l, &p);
  if (result != l->regular) {
    *failure = result;
    return -1;
  }
  singular = factor(l, &p, NULL);
  if (singular >= 0) {
    *failure = WITHOUT_INERTIA + singular;
    return -1;
  }
  for (j = 0; j < l->nv; j++) {
    p.right[j] = -p.bias[j];
  }
  for (i = 0; i < l->m; i++) {
    double residual = p.gamma[i] + 2 * l->frequency * l->damping * p.rate[i] +
                      l->frequency * l->frequency * p.value[i];
    p.offset[i] = residual / p.size[i];
  }
  for (i = 0; i < l->nq; i++) {
    if (l->velocity_of[i] >= 0) {
      dx[i] = x[l->nq + l->velocity_of[i]];
    }
  }
  for (b = 0; b < l->balls; b++) {
    ball_rate(x + l->ball_q[b], x + l->nq + l->ball_v[b], dx + l->ball_q[b]);
  }
  solve(l, &p, l->m, dx + l->nq);
  if (l->further != NULL) {
    l->further(model, t, p.y, dx + l->nq + l->nv);
  }
  return 0;
}

int mech_loops_along(const mech_loops *l, void *model, double *work, double t, const double *x,
                     const double *seed, int again, double *dx, int *failure) {
  parts p = places(l, work);
  int i, b;
  if (!again) {
    if (mech_loops_derivatives(l, model, work, t, x, dx, failure) < 0) {
      return -1;
    }
    memcpy(p.given, dx + l->nq, (size_t)l->nv * sizeof(double));
    for (i = 0; i < l->m; i++) {
      p.given[l->nv + i] = p.lambda[i] / p.size[i];
    }
  }
  l->along(model, t, p.y, p.given, seed, p.along);
  for (i = 0; i < l->nv; i++) {
    p.right[i] = -p.along[i];
  }
  for (i = 0; i < l->m; i++) {
    p.offset[i] = p.along[l->nv + i] / p.size[i];
  }
  for (i = 0; i < l->nq; i++) {
    if (l->velocity_of[i] >= 0) {
      dx[i] = seed[l->nq + l->velocity_of[i]];
    }
  }
  for (b = 0; b < l->balls; b++) {
    const double *e = x + l->ball_q[b], *omega = x + l->nq + l->ball_v[b];
    double rate[4];
    ball_rate(e, seed + l->nq + l->ball_v[b], rate);
    ball_rate(seed + l->ball_q[b], omega, dx + l->ball_q[b]);
    for (i = 0; i < 4; i++) {
      dx[l->ball_q[b] + i] += rate[i];
    }
  }
  solve(l, &p, l->m, dx + l->nq);
  if (l->further_along != NULL) {
    l->further_along(model, t, p.y, p.given, seed, dx + l->nq + l->nv);
  }
  return 0;
}

/* Relative rounding error of an equation's residual at the positions. */
static double rounding(const mech_loops *l, const parts *p, int row, const double *x) {
  double sum = 0;
  int e;
  for (e = l->start[row]; e < l->start[row + 1]; e++) {
    int position = l->position_of[l->column[e]];
    if (position >= 0) {
      sum += fabs(p->j[e]) * ulp(x[position]);
    }
  }
  for (e = l->start[row]; e < l->start[row + 1] && l->balls > 0; e++) {
    if (l->position_of[l->column[e]] < 0) {
      sum += fabs(p->j[e]) * (2 * DBL_EPSILON);
    }
  }
  return ROUNDINGS * (sum / p->size[row] + l->place_rounding[row]);
}

static double excess(const mech_loops *l, const parts *p, const double *x) {
  double largest = 0;
  int row;
  for (row = 0; row < l->m; row++) {
    largest = larger(fabs(p->value[row]) / p->size[row] - rounding(l, p, row, x), largest);
  }
  return largest;
}

static double beyond(double left_alone, double residual) {
  double rest = fabs(residual) - left_alone;
  return rest <= 0 ? 0 : residual < 0 ? -rest : rest;
}

static double largest_change(const mech_loops *l, const parts *p) {
  double largest = 0;
  int j;
  for (j = 0; j < l->nv; j++) {
    largest = larger(fabs(p->change[j]) / l->unit[j], largest);
  }
  return largest;
}

/* Moves positions along the tangent: q += factor d, e <- exp(factor d / 2) e. */
static void move(const mech_loops *l, double *q, const double *d, double factor) {
  int i, b;
  for (i = 0; i < l->nq; i++) {
    if (l->velocity_of[i] >= 0) {
      q[i] += factor * d[l->velocity_of[i]];
    }
  }
  for (b = 0; b < l->balls; b++) {
    double *e = q + l->ball_q[b];
    const double *turn = d + l->ball_v[b];
    double x = 0.5 * factor * turn[0], y = 0.5 * factor * turn[1], z = 0.5 * factor * turn[2];
    double angle = sqrt(x * x + y * y + z * z);
    double cosine = mech_cos(angle), s = angle == 0 ? 1 : mech_sin(angle) / angle;
    double e0 = e[0], e1 = e[1], e2 = e[2], e3 = e[3];
    e[0] = cosine * e0 - s * (x * e1 + y * e2 + z * e3);
    e[1] = cosine * e1 + s * (x * e0 + y * e3 - z * e2);
    e[2] = cosine * e2 + s * (y * e0 + z * e1 - x * e3);
    e[3] = cosine * e3 + s * (z * e0 + x * e2 - y * e1);
  }
}

static int is_closed(double residual, double before) {
  return residual <= CLOSED || (residual <= ACCEPTED && residual > 0.5 * before);
}

/* Forms M at the placed state and factors; returns whether that could be done. */
static int form_and_factor(const mech_loops *l, void *model, const parts *p, double t,
                           const unsigned char *held, int *failure) {
  int singular;
  l->mass(model, t, p->y, p->value);
  complete_mass(l, p);
  singular = factor(l, p, held);
  if (singular >= 0) {
    *failure = WITHOUT_INERTIA + singular;
  }
  return singular < 0;
}

/* Newton's method; after a jump in steps of limited length, else near the loops only. */
static int close_positions(const mech_loops *l, void *model, double *work, const parts *p, double t,
                           double *x, const unsigned char *held, int after_jump, int *failure) {
  double before = HUGE_VAL;
  int i, row, count = l->m + (held != NULL ? l->nv : 0);
  for (i = 0; i < (after_jump ? ITERATIONS_AFTER_JUMP : ITERATIONS); i++) {
    double residual, largest;
    place(l, model, work, p, t, x);
    residual = excess(l, p, x);
    if (is_closed(residual, before)) {
      return 1;
    }
    if (!after_jump && !(residual < before)) {
      return 0;
    }
    before = residual;
    for (row = 0; row < l->m; row++) {
      p->offset[row] = beyond(LEFT_ALONE * rounding(l, p, row, x), p->value[row] / p->size[row]);
    }
    memset(p->offset + l->m, 0, (size_t)(count - l->m) * sizeof(double));
    if (!form_and_factor(l, model, p, t, held, failure)) {
      return 0;
    }
    memset(p->right, 0, (size_t)l->nv * sizeof(double));
    solve(l, p, count, p->change);
    largest = largest_change(l, p);
    if (!(largest <= (after_jump ? DBL_MAX : TOO_FAR))) {
      return 0;
    }
    move(l, x, p->change, after_jump && largest > LONGEST_STEP ? LONGEST_STEP / largest : 1);
  }
  return 0;
}

/* Changes velocities as an impulse along the constraints does. */
static int close_velocities(const mech_loops *l, void *model, double *work, const parts *p,
                            double t, double *x, const unsigned char *held, double allowed,
                            int *failure) {
  double speed = 0, largest = 0;
  int j, row, count = l->m + (held != NULL ? l->nv : 0);
  place(l, model, work, p, t, x);
  for (j = 0; j < l->nv; j++) {
    speed = larger(fabs(x[l->nq + j]) / l->unit[j], speed);
  }
  speed = larger(SLOWEST, speed);
  for (row = 0; row < l->m; row++) {
    p->offset[row] =
        beyond(LEFT_ALONE * rounding(l, p, row, x) * speed, p->rate[row] / p->size[row]);
    largest = larger(fabs(p->offset[row]), largest);
  }
  memset(p->offset + l->m, 0, (size_t)(count - l->m) * sizeof(double));
  if (!(largest > CLOSED * speed)) {
    return speed <= DBL_MAX;
  }
  if (!form_and_factor(l, model, p, t, held, failure)) {
    return 0;
  }
  memset(p->right, 0, (size_t)l->nv * sizeof(double));
  solve(l, p, count, p->change);
  if (!(largest_change(l, p) <= allowed * speed)) {
    return 0;
  }
  for (j = 0; j < l->nv; j++) {
    x[l->nq + j] += p->change[j];
  }
  return 1;
}

int mech_loops_project(const mech_loops *l, void *model, double *work, double t, double *x,
                       int *failure) {
  parts p = places(l, work);
  return close_positions(l, model, work, &p, t, x, NULL, 0, failure) &&
                 close_velocities(l, model, work, &p, t, x, NULL, OTHER_BRANCH, failure)
             ? 1
             : -1;
}

int mech_loops_close(const mech_loops *l, void *model, double *work, double t, double *x,
                     const unsigned char *set, int *failure) {
  parts p = places(l, work);
  int i, b;
  if (set != NULL) {
    /* marks of the velocities whose positions are held lie behind the numbers in use */
    unsigned char *held = (unsigned char *)p.a;
    memset(held, 0, (size_t)l->nv);
    for (i = 0; i < l->nq; i++) {
      if (l->velocity_of[i] >= 0) {
        held[l->velocity_of[i]] = set[i];
      }
    }
    for (b = 0; b < l->balls; b++) {
      const unsigned char *four = set + l->ball_q[b];
      memset(held + l->ball_v[b], four[0] | four[1] | four[2] | four[3], 3);
    }
    close_positions(l, model, work, &p, t, x, held, 1, failure);
    close_velocities(l, model, work, &p, t, x, set + l->nq, HUGE_VAL, failure);
  }
  return close_positions(l, model, work, &p, t, x, NULL, 1, failure) &&
                 close_velocities(l, model, work, &p, t, x, NULL, HUGE_VAL, failure)
             ? 1
             : -1;
}

static double length_below(const double *a, int m, int n, int k, int of) {
  double sum = 0;
  int i;
  for (i = k; i < m; i++) {
    sum += a[i * n + of] * a[i * n + of];
  }
  return sqrt(sum);
}

/* One step of the QR factors of A (m x n, row after row), in its place: takes a column as column k
 * and reflects the rows from k on so that its elements below k vanish; b, if there is one, with
 * them (Householder 1958). Returns the size of the pivot. */
static double reflect(double *a, int m, int n, int k, int column, double *order, double *b) {
  double length, first, scale, dot, other = order[k];
  int i, j;
  order[k] = order[column];
  order[column] = other;
  for (i = 0; i < m; i++) {
    double element = a[i * n + k];
    a[i * n + k] = a[i * n + column];
    a[i * n + column] = element;
  }
  length = length_below(a, m, n, k, k);
  if (!(length > 0)) {
    return 0;
  }
  first = a[k * n + k];
  scale = 1 / (length * (length + fabs(first)));
  a[k * n + k] += first > 0 ? length : -length;
  for (j = k + 1; j < n; j++) {
    for (i = k, dot = 0; i < m; i++) {
      dot += a[i * n + k] * a[i * n + j];
    }
    for (i = k; i < m; i++) {
      a[i * n + j] -= scale * dot * a[i * n + k];
    }
  }
  if (b != NULL) {
    for (i = k, dot = 0; i < m; i++) {
      dot += a[i * n + k] * b[i];
    }
    for (i = k; i < m; i++) {
      b[i] -= scale * dot * a[i * n + k];
    }
  }
  a[k * n + k] = first > 0 ? -length : length;
  return length;
}

/* Longest of the columns of some group, from row k on; -1 if the group has none left. */
static int longest(const double *a, int m, int n, int k, const double *order, int first, int end) {
  double most = -1;
  int j, found = -1;
  for (j = k; j < n; j++) {
    if (order[j] >= first && order[j] < end) {
      double length = length_below(a, m, n, k, j);
      if (length > most) {
        most = length;
        found = j;
      }
    }
  }
  return found;
}

/* Columns of J, rows per size and columns in units, of the velocities that are not given. */
static int columns_of(const mech_loops *l, const parts *p, const unsigned char *given) {
  double *a = p->columns, *order = p->right;
  int row, e, j, n = 0;
  for (j = 0; j < l->nv; j++) {
    if (given == NULL || !given[j]) {
      order[n] = j;
      p->force[j] = n++;
    } else {
      p->force[j] = -1;
    }
  }
  memset(a, 0, (size_t)(l->m * n) * sizeof(double));
  for (row = 0; row < l->m; row++) {
    for (e = l->start[row]; e < l->start[row + 1]; e++) {
      int place = (int)p->force[l->column[e]];
      if (place >= 0) {
        a[row * n + place] = p->j[e] / p->size[row] * l->unit[l->column[e]];
      }
    }
  }
  return n;
}

/* Changes of the velocities that are not given, by least squares, by which J times them is p->gap;
 * returns the smallest pivot relative to the largest, 0 if the given ones do not determine them. */
static double dependent(const mech_loops *l, const parts *p, const unsigned char *given) {
  double *a = p->columns, *order = p->right, most = 0, least = HUGE_VAL;
  int k, j, n = columns_of(l, p, given);
  memset(p->change, 0, (size_t)l->nv * sizeof(double));
  for (k = 0; k < n; k++) {
    int column = k < l->m ? longest(a, l->m, n, k, order, 0, l->nv) : -1;
    double pivot = column >= 0 ? reflect(a, l->m, n, k, column, order, p->gap) : 0;
    most = larger(pivot, most);
    least = pivot < least ? pivot : least;
    if (!(pivot > SINGULAR * most)) {
      return 0;
    }
  }
  for (k = n - 1; k >= 0; k--) {
    double sum = p->gap[k];
    for (j = k + 1; j < n; j++) {
      sum -= a[k * n + j] * p->force[j];
    }
    p->force[k] = sum / a[k * n + k];
  }
  for (k = 0; k < n; k++) {
    int j_of = (int)order[k];
    p->change[j_of] = p->force[k] * l->unit[j_of];
  }
  return n > 0 ? least / most : 1;
}

int mech_loops_complete(const mech_loops *l, void *model, double *work, double t, double *x,
                        const unsigned char *given, double *pivot) {
  parts p = places(l, work);
  double before = HUGE_VAL;
  int i, j, row;
  for (i = 0; i < ITERATIONS_AFTER_JUMP; i++) {
    double residual, largest;
    place(l, model, work, &p, t, x);
    residual = excess(l, &p, x);
    if (is_closed(residual, before)) {
      for (row = 0; row < l->m; row++) {
        p.gap[row] = -p.rate[row] / p.size[row];
      }
      *pivot = dependent(l, &p, given);
      for (j = 0; j < l->nv; j++) {
        x[l->nq + j] += p.change[j];
      }
      return *pivot > 0 ? 1 : -1;
    }
    before = residual;
    for (row = 0; row < l->m; row++) {
      p.gap[row] = -beyond(LEFT_ALONE * rounding(l, &p, row, x), p.value[row] / p.size[row]);
    }
    *pivot = dependent(l, &p, given);
    largest = largest_change(l, &p);
    if (!(*pivot > 0) || !(largest <= DBL_MAX)) {
      return -1;
    }
    move(l, x, p.change, largest > LONGEST_STEP ? LONGEST_STEP / largest : 1);
  }
  return -1;
}

int mech_loops_choose(const mech_loops *l, void *model, double *work, double t, const double *x,
                      unsigned char *given) {
  parts p = places(l, work);
  double *a = p.columns, *order = p.right, most = 0;
  int b, j, k = 0, n;
  place(l, model, work, &p, t, x);
  n = columns_of(l, &p, NULL);
  for (j = 0; j < n; j++) {
    most = larger(length_below(a, l->m, n, 0, j), most);
    given[j] = 1;
  }
  for (b = 0; b < l->balls; b++) {
    int first = l->ball_v[b], before = k;
    for (j = 0; j < 3; j++) {
      int column = k < l->m ? longest(a, l->m, n, k, order, first, first + 3) : -1;
      if (column < 0 || !(reflect(a, l->m, n, k, column, order, NULL) > CHOSEN * most)) {
        break;
      }
      k++;
    }
    if (j < 3) {
      k = before; /* the rows are only turned; the ball stays among the given ones */
    } else {
      memset(given + first, 0, 3);
    }
  }
  for (; k < l->m && k < n; k++) {
    int column = -1, of;
    double longest_one = CHOSEN * most;
    for (j = k; j < n; j++) {
      of = (int)order[j];
      if (l->position_of[of] >= 0 && length_below(a, l->m, n, k, j) > longest_one) {
        longest_one = length_below(a, l->m, n, k, j);
        column = j;
      }
    }
    if (column < 0) {
      break;
    }
    given[(int)order[column]] = 0;
    reflect(a, l->m, n, k, column, order, NULL);
  }
  return k;
}

void mech_loops_accepted(const mech_loops *l, void *model, double *work, double t,
                         const double *x) {
  if (l->angles != NULL) {
    l->angles(model, t, mech_loops_state(l, work, x), work);
  }
}
