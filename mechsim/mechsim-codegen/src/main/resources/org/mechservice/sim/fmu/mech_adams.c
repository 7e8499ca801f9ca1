#include "mech_adams.h"

#include <float.h>
#include <math.h>
#include <string.h>

#include "mech_math.h"

static const double GAMMA_STAR[] = {1,      0.5,    0.0833,  0.0417,  0.0264,  0.0188,  0.0143,
                                    0.0114, 0.00936, 0.00789, 0.00679, 0.00592, 0.00524, 0.00468};

/* Below this relative tolerance the round-off of the sums is felt and carried along. */
static const double COMPENSATED_BELOW = 1e-11;

static double greater(double a, double b) { return a > b ? a : b; }
static double smaller(double a, double b) { return a < b ? a : b; }

static int is_finite(const double *x) {
  int l;
  for (l = 0; l < MODEL_NX; l++) {
    if (!(fabs(x[l]) <= DBL_MAX)) {
      return 0;
    }
  }
  return 1;
}

/* Largest weighted component; NaN if any is. */
static double norm(const mech_adams *a, const double *x) {
  double largest = 0;
  int l;
  for (l = 0; l < MODEL_NX; l++) {
    double size = fabs(x[l]) * a->weight[l];
    if (!(size <= largest)) {
      largest = size;
    }
    if (size != size) {
      return size;
    }
  }
  return largest;
}

static double norm_of_sum(const mech_adams *a, const double *x, const double *y) {
  double largest = 0;
  int l;
  for (l = 0; l < MODEL_NX; l++) {
    double size = fabs(x[l] + y[l]) * a->weight[l];
    if (!(size <= largest)) {
      largest = size;
    }
  }
  return largest;
}

static void weigh(mech_adams *a) {
  int l;
  for (l = 0; l < MODEL_NX; l++) {
    a->weight[l] = 1 / greater(a->rtol * fabs(a->x[l]), a->atol);
  }
}

static double smallest(double t) { return 16 * greater(DBL_EPSILON * fabs(t), DBL_MIN); }

static double first_step(const mech_adams *a) {
  double slope = norm(a, a->f);
  double step = 0.25 / (sqrt(a->rtol) * slope);
  return slope > 0 ? smaller(a->longest, step) : a->longest;
}

static int evaluate(mech_adams *a, MODEL_T *m, double t, const double *x) {
  memset(a->f, 0, sizeof a->f);
  return MODEL_derivatives(m, t, x, a->f) >= 0 && is_finite(a->f);
}

mech_step_result mech_adams_begin(mech_adams *a, MODEL_T *m, double t, const double *x) {
  a->t = t;
  a->previous = t;
  a->size = 0;
  a->taken = 0;
  a->order = 1;
  a->lower = 1;
  a->starting = 1;
  a->failures = 0;
  a->equal = 0;
  a->last_order = 0;
  a->last_size = 0;
  a->error = a->here = a->below = 0;
  memset(a->psi, 0, sizeof a->psi);
  memset(a->carry, 0, sizeof a->carry);
  memset(a->predicted_carry, 0, sizeof a->predicted_carry);
  memset(a->corrected_carry, 0, sizeof a->corrected_carry);
  memset(a->limited, 0, sizeof a->limited);
  a->slot = a->limited_steps = 0;
  a->g[1] = a->sigma[1] = a->beta[1] = 1;
  a->g[2] = 0.5;
  memmove(a->x, x, MODEL_NX * sizeof(double));
  if (MODEL_project(m, t, a->x) < 0 || !evaluate(a, m, t, a->x)) {
    return MECH_STEP_NOT_FINITE;
  }
  memcpy(a->phi[1], a->f, sizeof a->f);
  memset(a->phi[2], 0, sizeof a->phi[2]);
  weigh(a);
  a->h = first_step(a);
  return MECH_STEP_DONE;
}

/* psi, alpha, beta, sigma and g of a step of size h and order k. */
static void prepare(mech_adams *a, int k) {
  int i, q, ns;
  if (a->h != a->last_size) {
    a->equal = 0;
  }
  if (a->equal <= a->last_order) {
    a->equal++;
  }
  ns = a->equal;
  for (i = 1; i <= k && i <= ns; i++) {
    a->tried[i] = a->h * i;
  }
  if (k < ns) {
    return;
  }
  a->alpha[ns] = 1.0 / ns;
  a->beta[ns] = 1;
  a->sigma[ns + 1] = 1;
  for (i = ns + 1; i <= k; i++) {
    a->tried[i] = a->psi[i - 1] + a->h;
    a->alpha[i] = a->h / a->tried[i];
    a->beta[i] = a->beta[i - 1] * a->tried[i - 1] / a->psi[i - 1];
    a->sigma[i + 1] = i * a->alpha[i] * a->sigma[i];
  }
  if (ns == 1) {
    for (q = 1; q <= k; q++) {
      a->v[q] = a->w[q] = 1.0 / (q * (q + 1));
    }
  } else {
    if (k > a->last_order) {
      a->v[k] = 1.0 / (k * (k + 1));
      for (i = 1; i <= ns - 2; i++) {
        a->v[k - i] -= a->alpha[i + 1] * a->v[k - i + 1];
      }
    }
    for (q = 1; q <= k + 1 - ns; q++) {
      a->v[q] -= a->alpha[ns] * a->v[q + 1];
      a->w[q] = a->v[q];
    }
    a->g[ns + 1] = a->w[1];
  }
  for (i = ns + 2; i <= k + 1; i++) {
    for (q = 1; q <= k + 2 - i; q++) {
      a->w[q] -= a->alpha[i - 1] * a->w[q + 1];
    }
    a->g[i] = a->w[1];
  }
}

static void predict(mech_adams *a, int k) {
  int i, l, compensated = a->rtol < COMPENSATED_BELOW;
  memcpy(a->ahead[k + 2], a->phi[k + 1], sizeof a->phi[0]);
  memset(a->ahead[k + 1], 0, sizeof a->ahead[0]);
  memset(a->predicted, 0, sizeof a->predicted);
  for (i = k; i >= 1; i--) {
    for (l = 0; l < MODEL_NX; l++) {
      double rescaled = a->beta[i] * a->phi[i][l];
      a->predicted[l] += a->g[i] * rescaled;
      a->ahead[i][l] = a->ahead[i + 1][l] + rescaled;
    }
  }
  for (l = 0; l < MODEL_NX; l++) {
    double increment = a->h * a->predicted[l] - (compensated ? a->carry[l] : 0);
    a->predicted[l] = a->x[l] + increment;
    a->predicted_carry[l] = compensated ? (a->predicted[l] - a->x[l]) - increment : 0;
  }
}

/* Errors of the step at this order and the two below, over the tolerance. */
static void estimate(mech_adams *a, int k) {
  double d = a->h * norm(a, a->d);
  a->error = d * (a->g[k] - a->g[k + 1]);
  a->here = d * a->sigma[k + 1] * GAMMA_STAR[k];
  a->lower = k;
  if (k == 1) {
    return;
  }
  a->below = a->h * a->sigma[k] * GAMMA_STAR[k - 1] * norm_of_sum(a, a->ahead[k], a->d);
  if (k == 2 ? a->below <= 0.5 * a->here
             : a->below <= a->here && a->h * a->sigma[k - 1] * GAMMA_STAR[k - 2] *
                                              norm_of_sum(a, a->ahead[k - 1], a->d) <=
                                          a->here) {
    a->lower = k - 1;
  }
}

static double step_factor(const mech_adams *a) {
  if (ldexp(a->here, a->order + 1) <= 0.5) {
    return 2;
  }
  if (a->here <= 0.5) {
    return 1;
  }
  return greater(0.5, smaller(0.9, mech_exp(mech_log(0.5 / a->here) / (a->order + 1))));
}

/* Order of the next step and the factor for its size. */
static double choose(mech_adams *a, double size) {
  int k = a->order;
  if (a->lower == k - 1 || k == MECH_HIGHEST_ORDER) {
    a->starting = 0;
  }
  if (a->starting) {
    a->order = k + 1;
    return 2;
  }
  if (a->lower == k - 1) {
    a->order--;
    a->here = a->below;
  } else if (k + 1 <= a->equal) {
    double above = size * GAMMA_STAR[k + 1] * norm(a, a->phi[k + 2]);
    if (k > 1 && a->below <= smaller(a->here, above)) {
      a->order--;
      a->here = a->below;
    } else if (k < MECH_HIGHEST_ORDER && above < (k == 1 ? 0.5 : 1) * a->here) {
      a->order++;
      a->here = above;
    }
  }
  return step_factor(a);
}

/* Stiff if 30 of the last 50 steps were at the limit of stability: Shampine 1980. */
static void look_at_stability(mech_adams *a, double g, const double *change) {
  double product = 0, correction = 0, reaction = 0, ratio, cosine;
  double unit = ldexp(1.0, (int)floor(mech_log(a->size) / mech_log(2.0)));
  int l, at_limit;
  for (l = 0; l < MODEL_NX; l++) {
    double weight = unit * a->weight[l];
    double moved = weight * a->d[l];
    double answer = weight * (change[l] - a->d[l]);
    product += moved * answer;
    correction += moved * moved;
    reaction += answer * answer;
  }
  ratio = correction > 0 ? sqrt(reaction / correction) / g : 0;
  cosine = correction > 0 && reaction > 0 ? product / sqrt(reaction * correction) : 0;
  at_limit = ratio >= 0.8 || (ratio >= 0.35 && cosine <= -0.6);
  a->limited_steps += at_limit - a->limited[a->slot];
  a->limited[a->slot] = (unsigned char)at_limit;
  a->slot = (a->slot + 1) % MECH_WINDOW;
  a->stiff |= a->limited_steps >= 30;
}

static void accept(mech_adams *a, double end) {
  int k = a->order, i, l;
  double *change = a->phi[k + 1];
  double g = a->g[k + 1];
  for (l = 0; l < MODEL_NX; l++) {
    change[l] = a->f[l] - a->ahead[1][l];
    a->phi[k + 2][l] = change[l] - a->ahead[k + 2][l];
  }
  for (i = 1; i <= k; i++) {
    for (l = 0; l < MODEL_NX; l++) {
      a->phi[i][l] = a->ahead[i][l] + change[l];
    }
  }
  memcpy(a->x, a->corrected, sizeof a->x);
  memcpy(a->carry, a->corrected_carry, sizeof a->carry);
  memcpy(a->psi, a->tried, (size_t)(k + 1) * sizeof(double));
  a->last_size = a->h;
  a->last_order = k;
  a->previous = a->t;
  a->t = end;
  a->size = a->h;
  a->taken = k;
  look_at_stability(a, g, change);
  a->h *= choose(a, a->h);
}

static double bounded(const mech_adams *a) {
  double size = greater(smaller(a->longest, a->h), smallest(a->t));
  double remaining = a->stop - a->t;
  return 1.1 * size >= remaining ? remaining : size;
}

/* Corrects, projects and evaluates; the round-off of what projection moved is forgotten. */
static int correct(mech_adams *a, MODEL_T *m, double end) {
  double weight = a->h * a->g[a->order + 1];
  int l, compensated = a->rtol < COMPENSATED_BELOW;
  for (l = 0; l < MODEL_NX; l++) {
    a->corrected[l] = a->predicted[l] + (weight * a->d[l] - a->predicted_carry[l]);
  }
  if (!is_finite(a->corrected) || MODEL_project(m, end, a->corrected) < 0) {
    return 0;
  }
  for (l = 0; compensated && l < MODEL_NX; l++) {
    double increment = weight * a->d[l] - a->predicted_carry[l];
    int moved = a->corrected[l] != a->predicted[l] + increment;
    a->corrected_carry[l] = moved ? 0 : (a->corrected[l] - a->predicted[l]) - increment;
  }
  return evaluate(a, m, end, a->corrected) && is_finite(a->corrected);
}

mech_step_result mech_adams_step(mech_adams *a, MODEL_T *m, long tries) {
  int not_finite = 0, l;
  weigh(a);
  a->failures = 0;
  if (2 * DBL_EPSILON * norm(a, a->x) > 0.5) {
    return MECH_STEP_TOO_ACCURATE;
  }
  a->h = bounded(a);
  for (;;) {
    int k = a->order, passed = 0, inaccurate = 0;
    double end = a->h == a->stop - a->t ? a->stop : a->t + a->h;
    if (tries-- <= 0) {
      return MECH_STEP_TOO_MANY;
    }
    a->tries++;
    a->lower = k;
    prepare(a, k);
    predict(a, k);
    if (evaluate(a, m, end, a->predicted)) {
      for (l = 0; l < MODEL_NX; l++) {
        a->d[l] = a->f[l] - a->ahead[1][l];
      }
      estimate(a, k);
      inaccurate = !(a->error <= 1);
      passed = !inaccurate && correct(a, m, end);
    }
    if (passed) {
      accept(a, end);
      return MECH_STEP_DONE;
    }
    if (a->h <= smallest(a->t)) {
      return inaccurate ? MECH_STEP_TOO_SMALL : MECH_STEP_NOT_FINITE;
    }
    if (!inaccurate && ++not_finite >= 10) {
      return MECH_STEP_NOT_FINITE;
    }
    a->failures++;
    a->starting = 0;
    a->order = a->failures >= 3 ? 1 : a->lower;
    if (!inaccurate || !(a->error <= DBL_MAX)) {
      a->h *= 0.25;
    } else {
      a->h *= a->failures > 3 ? smaller(0.5, sqrt(0.5 / a->here)) : 0.5;
    }
    a->h = greater(a->h, smallest(a->t));
  }
}

void mech_adams_interpolate(const mech_adams *a, double t, double *x) {
  double g[MECH_LENGTH], w[MECH_LENGTH], s = t - a->t, before = 0;
  int k = a->taken, i, j, l, q;
  if (k == 0 || s == 0) {
    memcpy(x, a->x, MODEL_NX * sizeof(double));
    return;
  }
  for (q = 1; q <= k + 1; q++) {
    w[q] = 1.0 / q;
  }
  g[1] = 1;
  for (j = 1; j <= k; j++) {
    double gamma = (s + before) / a->psi[j], eta = s / a->psi[j];
    for (q = 1; q <= k + 1 - j; q++) {
      w[q] = gamma * w[q] - eta * w[q + 1];
    }
    g[j + 1] = w[1];
    before = a->psi[j];
  }
  for (l = 0; l < MODEL_NX; l++) {
    double sum = 0;
    for (i = k + 1; i >= 1; i--) {
      sum += g[i] * a->phi[i][l];
    }
    x[l] = a->x[l] + s * sum;
  }
}
