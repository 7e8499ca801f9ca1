#include "mech_backward.h"

#include <float.h>
#include <math.h>
#include <string.h>

#include "mech_math.h"

enum { ITERATIONS = 4 };

static const double G[] = {0, 1, 1.5, 11.0 / 6, 25.0 / 12, 137.0 / 60};
/* kappa of each order, and the constants of the error that follow from it. */
static const double KAPPA[] = {0, -0.1850, -1.0 / 9, -0.0823, -0.0415, 0};

static double greater(double a, double b) { return a > b ? a : b; }
static double smaller(double a, double b) { return a < b ? a : b; }

static double gamma_of(int k) { return 1 / (G[k] * (1 - KAPPA[k])); }
static double error_constant(int k) { return KAPPA[k] * G[k] + 1.0 / (k + 1); }

static int is_finite(const double *x) {
  int l;
  for (l = 0; l < MODEL_NX; l++) {
    if (!(fabs(x[l]) <= DBL_MAX)) {
      return 0;
    }
  }
  return 1;
}

/* Largest weighted component, relative; NaN if any is. */
static double norm(const mech_backward *b, const double *x) {
  double largest = 0;
  int l;
  for (l = 0; l < MODEL_NX; l++) {
    double size = fabs(x[l]) * b->weight[l];
    if (!(size <= largest)) {
      largest = size;
    }
    if (size != size) {
      return size;
    }
  }
  return largest;
}

static double power(double x, double exponent) {
  return x > 0 ? mech_exp(exponent * mech_log(x)) : 0;
}

static void weigh(mech_backward *b, const double *other) {
  double threshold = b->atol / b->rtol;
  int l;
  for (l = 0; l < MODEL_NX; l++) {
    b->weight[l] = 1 / greater(greater(fabs(b->x[l]), fabs(other[l])), threshold);
  }
}

static double smallest(double t) { return 16 * greater(DBL_EPSILON * fabs(t), DBL_MIN); }

static int evaluate(MODEL_T *m, double t, const double *x, double *f) {
  memset(f, 0, MECH_N * sizeof(double));
  return MODEL_derivatives(m, t, x, f) >= 0 && is_finite(f);
}

mech_step_result mech_backward_begin(mech_backward *b, MODEL_T *m, double t, const double *x) {
  double slope;
  int l;
  memmove(b->x, x, MODEL_NX * sizeof(double));
  b->t = b->previous = t;
  b->order = 1;
  b->equal = 0;
  b->jacobian_current = b->jacobian_known = b->rate_known = 0;
  b->rate = 0;
  b->of_factors = 0;
  b->of_order = 0;
  b->stiff = 0;
  memset(b->d, 0, sizeof b->d);
  if (MODEL_project(m, t, b->x) < 0 || !evaluate(m, t, b->x, b->f)) {
    return MECH_STEP_NOT_FINITE;
  }
  weigh(b, b->x);
  slope = 1.25 * norm(b, b->f) / sqrt(b->rtol);
  b->h = slope * b->longest > 1 ? 1 / slope : b->longest;
  b->of_differences = b->h;
  for (l = 0; l < MODEL_NX; l++) {
    b->d[1][l] = b->h * b->f[l];
  }
  return MECH_STEP_DONE;
}

/* Differences of another step size: of the polynomial through them. */
static void rescale(mech_backward *b, double h) {
  double r = h / b->of_differences, ru[MECH_ORDERS + 1][MECH_ORDERS + 1];
  double u[MECH_ORDERS + 1][MECH_ORDERS + 1], w[MECH_ORDERS + 1][MECH_ORDERS + 1];
  double row[MECH_ORDERS + 1];
  int i, j, l, q, k = b->order;
  if (h == b->of_differences) {
    return;
  }
  for (j = 1; j <= k; j++) {
    double with_r = 1, with_one = 1;
    for (i = 1; i <= k; i++) {
      with_r *= (i - 1 - j * r) / i;
      with_one *= (double)(i - 1 - j) / i;
      ru[i][j] = with_r;
      u[i][j] = with_one;
    }
  }
  for (i = 1; i <= k; i++) {
    for (j = 1; j <= k; j++) {
      w[i][j] = 0;
      for (q = 1; q <= k; q++) {
        w[i][j] += ru[i][q] * u[q][j];
      }
    }
  }
  for (l = 0; l < MODEL_NX; l++) {
    for (j = 1; j <= k; j++) {
      row[j] = 0;
      for (i = 1; i <= k; i++) {
        row[j] += b->d[i][l] * w[i][j];
      }
    }
    for (j = 1; j <= k; j++) {
      b->d[j][l] = row[j];
    }
  }
  b->of_differences = h;
  b->equal = 0;
}

/* Jacobian by forward differences at the last accepted state. */
static int differentiate(mech_backward *b, MODEL_T *m) {
  double x[MECH_N], f[MECH_N], moved[MECH_N];
  int i, j;
  memcpy(x, b->x, MODEL_NX * sizeof(double));
  if (!evaluate(m, b->t, x, f)) {
    return 0;
  }
  for (j = 0; j < MODEL_NX; j++) {
    double size = greater(fabs(x[j]), b->atol / b->rtol), e;
    x[j] = b->x[j] + 1.5e-8 * size;
    e = x[j] - b->x[j];
    if (!evaluate(m, b->t, x, moved)) {
      return 0;
    }
    x[j] = b->x[j];
    for (i = 0; i < MODEL_NX; i++) {
      b->jacobian[i][j] = (moved[i] - f[i]) / e;
    }
  }
  b->jacobian_current = b->jacobian_known = 1;
  b->of_factors = 0;
  return 1;
}

/* L U of 1 - h gamma J with partial pivoting; returns 0 if it is singular. */
static int factorise(mech_backward *b, double weight) {
  int i, j, k;
  for (i = 0; i < MODEL_NX; i++) {
    for (j = 0; j < MODEL_NX; j++) {
      b->factors[i][j] = (i == j) - weight * b->jacobian[i][j];
    }
  }
  for (k = 0; k < MODEL_NX; k++) {
    int p = k;
    for (i = k + 1; i < MODEL_NX; i++) {
      if (fabs(b->factors[i][k]) > fabs(b->factors[p][k])) {
        p = i;
      }
    }
    if (!(fabs(b->factors[p][k]) > 0)) {
      return 0;
    }
    b->row[k] = p;
    for (j = 0; j < MODEL_NX && p != k; j++) {
      double kept = b->factors[k][j];
      b->factors[k][j] = b->factors[p][j];
      b->factors[p][j] = kept;
    }
    for (i = k + 1; i < MODEL_NX; i++) {
      double part = b->factors[i][k] / b->factors[k][k];
      b->factors[i][k] = part;
      for (j = k + 1; part != 0 && j < MODEL_NX; j++) {
        b->factors[i][j] -= part * b->factors[k][j];
      }
    }
  }
  return 1;
}

static void substitute(const mech_backward *b, double *x) {
  int i, j;
  for (i = 0; i < MODEL_NX; i++) {
    double kept = x[b->row[i]];
    x[b->row[i]] = x[i];
    x[i] = kept;
  }
  for (i = 0; i < MODEL_NX; i++) {
    for (j = 0; j < i; j++) {
      x[i] -= b->factors[i][j] * x[j];
    }
  }
  for (i = MODEL_NX - 1; i >= 0; i--) {
    for (j = i + 1; j < MODEL_NX; j++) {
      x[i] -= b->factors[i][j] * x[j];
    }
    x[i] /= b->factors[i][i];
  }
}

/* Simplified Newton iteration for the correction; returns whether it converged. */
static int iterate(mech_backward *b, MODEL_T *m, double end) {
  int k = b->order, i, j, l;
  double weight = b->h * gamma_of(k), before = 0, least;
  for (l = 0; l < MODEL_NX; l++) {
    double sum = 0, moved = 0;
    for (j = 1; j <= k; j++) {
      sum += b->d[j][l];
      moved += G[j] * gamma_of(k) * b->d[j][l];
    }
    b->predicted[l] = b->tried[l] = b->x[l] + sum;
    b->psi[l] = moved;
    b->correction[l] = 0;
  }
  if (!is_finite(b->predicted)) {
    return 0;
  }
  weigh(b, b->predicted);
  least = 100 * DBL_EPSILON * norm(b, b->predicted);
  for (i = 1; i <= ITERATIONS; i++) {
    double change[MECH_N], size, left;
    if (!evaluate(m, end, b->tried, b->f)) {
      return 0;
    }
    for (l = 0; l < MODEL_NX; l++) {
      change[l] = weight * b->f[l] - (b->psi[l] + b->correction[l]);
    }
    substitute(b, change);
    size = norm(b, change);
    if (!(size <= DBL_MAX)) {
      return 0;
    }
    for (l = 0; l < MODEL_NX; l++) {
      b->correction[l] += change[l];
      b->tried[l] = b->predicted[l] + b->correction[l];
    }
    if (size <= least) {
      return 1;
    }
    if (i == 1) {
      if (b->rate_known && size * b->rate / (1 - b->rate) <= 0.05 * b->rtol) {
        return 1;
      }
      if (!b->rate_known) {
        b->rate = 0;
      }
    } else {
      if (size > 0.9 * before) {
        return 0;
      }
      b->rate = greater(0.9 * b->rate, size / before);
      b->rate_known = 1;
      left = size * b->rate / (1 - b->rate);
      if (left <= 0.5 * b->rtol) {
        return 1;
      }
      if (0.5 * b->rtol < left * power(b->rate, ITERATIONS - i)) {
        return 0;
      }
    }
    before = size;
  }
  return 0;
}

static double grown(double h, double safety, double error, const mech_backward *b, int order) {
  double factor = safety * power(error / b->rtol, 1.0 / (order + 1));
  return factor > 0.1 ? h / factor : 10 * h;
}

static void accept(mech_backward *b, double end, double error) {
  int k = b->order, j, l;
  for (l = 0; l < MODEL_NX; l++) {
    b->correction[l] = b->tried[l] - b->predicted[l];
    b->d[k + 2][l] = b->correction[l] - b->d[k + 1][l];
    b->d[k + 1][l] = b->correction[l];
    for (j = k; j >= 1; j--) {
      b->d[j][l] += b->d[j + 1][l];
    }
  }
  memcpy(b->x, b->tried, sizeof b->x);
  b->previous = b->t;
  b->t = end;
  b->jacobian_current = 0;
  b->of_differences = b->h;
  b->of_order = k;
  if (++b->equal >= k + 2) {
    double best = grown(b->h, 1.2, error, b, k);
    int order = k;
    if (k > 1) {
      double other = grown(b->h, 1.3, norm(b, b->d[k]) * error_constant(k - 1), b, k - 1);
      if (other > best) {
        best = other;
        order = k - 1;
      }
    }
    if (k < MECH_ORDERS) {
      double other = grown(b->h, 1.4, norm(b, b->d[k + 2]) * error_constant(k + 1), b, k + 1);
      if (other > best) {
        best = other;
        order = k + 1;
      }
    }
    if (best > b->h) {
      b->order = order;
      b->h = smaller(best, b->longest);
      b->equal = 0;
    } else if (b->equal > MECH_ORDERS + 2) {
      b->equal = MECH_ORDERS + 2;
    }
  }
}

mech_step_result mech_backward_step(mech_backward *b, MODEL_T *m, long tries) {
  int failures = 0, not_finite = 0;
  double remaining = b->stop - b->t;
  if (b->rtol < 100 * DBL_EPSILON) {
    return MECH_STEP_TOO_ACCURATE;
  }
  b->h = greater(smaller(b->h, b->longest), smallest(b->t));
  if (1.1 * b->h >= remaining) {
    b->h = remaining;
  }
  for (;;) {
    double error, end, weight;
    int l, k;
    if (tries-- <= 0) {
      return MECH_STEP_TOO_MANY;
    }
    b->tries++;
    rescale(b, b->h);
    end = b->h == b->stop - b->t ? b->stop : b->t + b->h;
    if (!b->jacobian_known && !differentiate(b, m)) {
      return MECH_STEP_NOT_FINITE;
    }
    weight = b->h * gamma_of(b->order);
    if (b->of_factors != weight) {
      b->rate_known = 0;
      b->of_factors = factorise(b, weight) ? weight : 0;
    }
    if (b->of_factors == 0 || !iterate(b, m, end)) {
      if (b->h <= smallest(b->t) || ++not_finite > 60) {
        return MECH_STEP_NOT_FINITE;
      }
      b->rate_known = 0;
      if (!b->jacobian_current) {
        if (!differentiate(b, m)) {
          return MECH_STEP_NOT_FINITE;
        }
      } else {
        b->h = greater(0.3 * b->h, smallest(b->t));
      }
      continue;
    }
    k = b->order;
    error = norm(b, b->correction) * error_constant(k);
    if (error <= b->rtol && MODEL_project(m, end, b->tried) >= 0 && is_finite(b->tried)) {
      accept(b, end, error);
      return MECH_STEP_DONE;
    }
    if (b->h <= smallest(b->t)) {
      return MECH_STEP_TOO_SMALL;
    }
    if (failures++ == 0 && error > b->rtol) {
      double best = b->h * greater(0.1, 0.833 * power(b->rtol / error, 1.0 / (k + 1)));
      if (k > 1) {
        double lower[MECH_N], of_lower, other;
        for (l = 0; l < MODEL_NX; l++) {
          lower[l] = b->d[k][l] + b->correction[l];
        }
        of_lower = norm(b, lower) * error_constant(k - 1);
        other = b->h * greater(0.1, 0.769 * power(b->rtol / of_lower, 1.0 / k));
        if (other > best) {
          best = smaller(b->h, other);
          b->order = k - 1;
        }
      }
      b->h = greater(best, smallest(b->t));
    } else {
      b->h = greater(0.5 * b->h, smallest(b->t));
    }
    b->equal = 0;
  }
}

void mech_backward_interpolate(const mech_backward *b, double t, double *x) {
  double s = b->of_differences > 0 ? (t - b->t) / b->of_differences : 0, part = 1;
  int j, l;
  memcpy(x, b->x, MODEL_NX * sizeof(double));
  for (j = 1; j <= b->of_order; j++) {
    part *= (s + j - 1) / j;
    for (l = 0; l < MODEL_NX; l++) {
      x[l] += part * b->d[j][l];
    }
  }
}
