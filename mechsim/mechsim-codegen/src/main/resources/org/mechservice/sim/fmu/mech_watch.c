#include "mech_watch.h"

#include <math.h>
#include <stdint.h>
#include <string.h>

#include "mech_math.h"

/* Largest turn of a body relative to another in a part of a step, rad. */
static const double TURN = 0.5;
/* Margin of a way beside three points of it, relative to their second difference. */
static const double MARGIN = 0.5;
/* Width to which a change is narrowed down, in units of the last place of time. */
static const double RESOLUTION = 4;
/* Distance from a boundary, relative to the size of the argument, beyond rounding. */
static const double CLEAR = 1e-14;
/* Way beyond a boundary that is a touch, relative to the largest size of the argument. */
static const double TOUCH = 1e-12;
/* Size of a formula, relative to the largest value it has had, that does not matter. */
static const double NOTHING = 1e-10;
/* Growth of a box beside a step, in lengths of the step's way: at most, at least, and between. */
static const double LARGE_BOX = 16, SMALL_BOX = 1, SHRINKAGE = 0.25;
/* Most steps after which a box is sought again where there was none, or one of no use. */
static const double LONGEST_PAUSE = 15;
/* Growth of the box in which a change counts as beside the step: one of those tried. */
static const double BESIDE = 4;
/* Distance from a boundary, relative to the size of the argument, that one keeps that slides. */
static const double HOVERING = 1e-6;
/* Part of the way to a hidden value that the first step behind takes. */
static const double FIRST_STEP = 0.25;
/* Change of an argument within which exponential and hyperbolic functions change evenly. */
static const double EVEN = 0.5;
/* Factor within which a divisor may change for its quotient to change evenly. */
static const double RATIO = 2;
/* Exponent below which an exponential is nothing; twice the argument beyond which tanh is 1. */
static const double NO_POWER = -40;
/* Rounding by which the values of an operation may differ, relative to their size, and of a
 * polynomial, and the smallest number of full precision. */
static const double ROUNDING = 4 * 2.220446049250313e-16;
static const double ROUNDING_OF_TABLE = 64 * 2.220446049250313e-16;
static const double MIN_NORMAL = 2.2250738585072014e-308;
static const double PI_NUMBER = 3.141592653589793;

enum {
  /* Most evaluations in a step beyond its first division, and most parts of that. */
  MOST_EVALUATIONS = 4000,
  MOST_PARTS = 1000000,
  /* Farthest place behind a change at which a step is cut, in the widths that it is narrowed to. */
  FARTHEST = 64,
  /* Roundings of t within which a change lies that steps cannot cross. */
  ACROSS = 16384,
  /* Depth to which the first way to a hidden value is followed. */
  FORMULA_DEPTH = 20,
  /* Steps within which two changes of a choice follow each other closely, and changes in a row
   * after which those that show are left to the error test; the same for those that do not. */
  CLOSE = 10,
  MOST_CLOSE = 8,
  MOST_HIDDEN = 400,
  /* Steps in a row after which it is asked whether the solution slides along a jump, and changes in
   * them, or steps beside one, from which on it may. */
  ROW = 2000,
  CHANGES = 20
};

/* Distance of a number from the next larger one of its size. */
static double last_place(double x) {
  uint64_t bits, exponent;
  double unit;
  memcpy(&bits, &x, sizeof bits);
  exponent = bits >> 52 & 0x7ff;
  if (exponent == 0x7ff) {
    return fabs(x);
  }
  bits = exponent > 52  ? (exponent - 52) << 52
         : exponent > 0 ? (uint64_t)1 << (exponent - 1)
                        : (uint64_t)1;
  memcpy(&unit, &bits, sizeof unit);
  return unit;
}

/* ---- tables ---- */

static int interval(const double *points, int count, double x) {
  return (int)mech_interval(points, count, x);
}

static double cubic(const double *p, double d) {
  return p[1] + d * (p[2] + d * (p[3] + d * p[4]));
}

static double curve_value(const mech_watch_table *table, double x) {
  const double *points = WATCH_NUMBER + table->at;
  const double *p = points + table->points + 5 * interval(points, table->points, x);
  if (table->bounded && !(x >= points[0] && x <= points[table->points - 1])) {
    return NAN;
  }
  return cubic(p, x - p[0]);
}

static double along(const double *c, double d) {
  return c[0] + d * (c[1] + d * (c[2] + d * c[3]));
}

/* The parts of a map's numbers. */
typedef struct {
  const double *x, *y, *origin_x, *origin_y, *cells;
  int nx, ny;
} map_parts;

static map_parts parts_of(const mech_watch_table *table) {
  map_parts map;
  map.nx = table->points;
  map.ny = table->further_points;
  map.x = WATCH_NUMBER + table->at;
  map.y = map.x + map.nx;
  map.origin_x = map.y + map.ny;
  map.origin_y = map.origin_x + map.nx + 1;
  map.cells = map.origin_y + map.ny + 1;
  return map;
}

static double map_value(const mech_watch_table *table, double a, double b) {
  map_parts map = parts_of(table);
  int k = interval(map.x, map.nx, a), l = interval(map.y, map.ny, b);
  const double *c = map.cells + 16 * (k * (map.ny + 1) + l);
  double dx = a - map.origin_x[k], dy = b - map.origin_y[l];
  if (table->bounded && !(a >= map.x[0] && a <= map.x[map.nx - 1] && b >= map.y[0] &&
                          b <= map.y[map.ny - 1])) {
    return NAN;
  }
  return along(c, dy) + dx * (along(c + 4, dy) + dx * (along(c + 8, dy) + dx * along(c + 12, dy)));
}

/* ---- values and pieces ---- */

static double smooth_step(double a) {
  double s = mech_max(0, mech_min(1, a));
  return s * s * (3 - 2 * s);
}

static double value(const mech_watch_step *step, double a, double b) {
  switch (step->operation) {
    case WATCH_ADD:
      return a + b;
    case WATCH_SUBTRACT:
      return a - b;
    case WATCH_MULTIPLY:
      return a * b;
    case WATCH_DIVIDE:
      return a / b;
    case WATCH_NEGATE:
      return -a;
    case WATCH_SQUARE:
      return a * a;
    case WATCH_SQRT:
      return sqrt(a);
    case WATCH_ABS:
      return fabs(a);
    case WATCH_SIN:
      return mech_sine(a);
    case WATCH_COS:
      return mech_cosine(a);
    case WATCH_ASIN:
      return mech_asin(a);
    case WATCH_ACOS:
      return mech_acos(a);
    case WATCH_ATAN:
      return mech_atan(a);
    case WATCH_ATAN2:
      return mech_atan2(a, b);
    case WATCH_EXP:
      return mech_exp(a);
    case WATCH_LOG:
      return mech_log(a);
    case WATCH_MIN:
      return mech_min(a, b);
    case WATCH_MAX:
      return mech_max(a, b);
    case WATCH_SINH:
      return mech_sinh(a);
    case WATCH_COSH:
      return mech_cosh(a);
    case WATCH_TANH:
      return mech_tanh(a);
    case WATCH_SIGNUM:
      return mech_signum(a);
    case WATCH_HYPOT:
      return mech_hypot(a, b);
    case WATCH_FLOOR:
      return mech_floor(a);
    case WATCH_STEP:
      return a < 0 ? 0 : a >= 0 ? 1 : a;
    case WATCH_SMOOTH_STEP:
      return smooth_step(a);
    case WATCH_WHERE:
      return a >= 0 ? b : 0;
    case WATCH_ELSEWHERE:
      return a >= 0 ? 0 : b;
    case WATCH_POWER:
      return mech_power(a, b);
    case WATCH_CURVE:
      return curve_value(&WATCH_TABLE_OF[step->table], a);
    case WATCH_MAP:
      return map_value(&WATCH_TABLE_OF[step->table], a, b);
  }
  return NAN;
}

static int is_table(const mech_watch_step *step) {
  return step->operation == WATCH_CURVE || step->operation == WATCH_MAP;
}

/* Number of the piece that an operation takes; neighbouring pieces of one argument have
 * neighbouring numbers. */
static double piece_of(const mech_watch_step *step, double a, double b) {
  const mech_watch_table *table = &WATCH_TABLE_OF[step->table];
  map_parts map;
  switch (step->operation) {
    case WATCH_ABS:
    case WATCH_STEP:
    case WATCH_WHERE:
    case WATCH_ELSEWHERE:
      return a < 0 ? 0 : 1;
    case WATCH_SIGNUM:
      return mech_signum(a);
    case WATCH_FLOOR:
      return mech_floor(a);
    case WATCH_SMOOTH_STEP:
      return a < 0 ? 0 : a <= 1 ? 1 : 2;
    case WATCH_MIN:
    case WATCH_MAX:
      return a < b ? 0 : 1;
    case WATCH_CURVE:
      return interval(WATCH_NUMBER + table->at, table->points, a);
    case WATCH_MAP:
      map = parts_of(table);
      return interval(map.x, map.nx, a) * (map.ny + 1) + interval(map.y, map.ny, b);
    default:
      return 0;
  }
}

static double piece(int choice, const double *point) {
  const mech_watch_step *step = &WATCH_STEP_OF[WATCH_CHOICE_OF[choice].step];
  return piece_of(step, point[step->first], point[step->second]);
}

/* Distance of an argument from the nearest of ascending points. */
static double distance_from(const double *points, int count, double x) {
  int place = interval(points, count, x);
  return mech_min(place == 0 ? HUGE_VAL : x - points[place - 1],
                  place == count ? HUGE_VAL : points[place] - x);
}

/* How far the argument of a choice is from where its piece ends. */
static double distance(int choice, const double *point) {
  const mech_watch_step *step = &WATCH_STEP_OF[WATCH_CHOICE_OF[choice].step];
  const mech_watch_table *table = &WATCH_TABLE_OF[step->table];
  double a = point[step->first], b = point[step->second];
  map_parts map;
  switch (step->operation) {
    case WATCH_MIN:
    case WATCH_MAX:
      return fabs(a - b);
    case WATCH_FLOOR:
      return fabs(a - rint(a));
    case WATCH_SMOOTH_STEP:
      return mech_min(fabs(a), fabs(a - 1));
    case WATCH_CURVE:
      return distance_from(WATCH_NUMBER + table->at, table->points, a);
    case WATCH_MAP:
      map = parts_of(table);
      return mech_min(distance_from(map.x, map.nx, a), distance_from(map.y, map.ny, b));
    default:
      return fabs(a);
  }
}

/* Whether an operation that is no choice can change much while its argument hardly does. */
static int is_narrow(const mech_watch_step *step) {
  switch (step->operation) {
    case WATCH_DIVIDE:
    case WATCH_ATAN:
    case WATCH_EXP:
    case WATCH_SINH:
    case WATCH_COSH:
    case WATCH_TANH:
    case WATCH_POWER:
      return 1;
    case WATCH_CURVE:
    case WATCH_MAP:
      return !WATCH_TABLE_OF[step->table].straight;
    default:
      return 0;
  }
}

/* ---- bounds: R. E. Moore, Interval Analysis, 1966 ---- */

typedef struct {
  double low, high;
} bounds;

static bounds between(double low, double high) {
  bounds b;
  b.low = low;
  b.high = high;
  return b;
}

static void include(bounds *b, double x) {
  b->low = mech_min(b->low, x);
  b->high = mech_max(b->high, x);
}

static bounds nothing(void) { return between(HUGE_VAL, -HUGE_VAL); }

static bounds all(void) { return between(-HUGE_VAL, HUGE_VAL); }

/* A factor 0 is exactly 0 all over the interval, also where the other has no bound. */
static double times(double a, double b) { return a == 0 || b == 0 ? 0 : a * b; }

static bounds product(bounds a, bounds b) {
  bounds result = nothing();
  include(&result, times(a.low, b.low));
  include(&result, times(a.low, b.high));
  include(&result, times(a.high, b.low));
  include(&result, times(a.high, b.high));
  return result;
}

static bounds quotient(bounds a, bounds b) {
  if (b.low > 0 || b.high < 0) {
    return product(a, between(1 / b.high, 1 / b.low));
  }
  return a.low == 0 && a.high == 0 ? between(0, 0) : all();
}

static bounds absolute(bounds a) {
  return a.low >= 0    ? a
         : a.high <= 0 ? between(-a.high, -a.low)
                       : between(0, mech_max(-a.low, a.high));
}

static bounds square(bounds a) {
  bounds size = absolute(a);
  return between(size.low * size.low, size.high * size.high);
}

static int holds_multiple(double from, double to, double of) {
  return mech_floor(to / of) > mech_floor(from / of) || from / of == mech_floor(from / of);
}

/* Sine or cosine: 1 where a crest lies inside, -1 half a turn further. */
static bounds wave(double first, double last, bounds a, double crest) {
  bounds result;
  if (!(a.high - a.low < 2 * PI_NUMBER)) {
    return between(-1, 1);
  }
  result = between(mech_min(first, last), mech_max(first, last));
  if (holds_multiple(a.low - crest, a.high - crest, 2 * PI_NUMBER)) {
    result.high = 1;
  }
  if (holds_multiple(a.low - crest - PI_NUMBER, a.high - crest - PI_NUMBER, 2 * PI_NUMBER)) {
    result.low = -1;
  }
  return result;
}

static double unit(double a) { return mech_max(-1, mech_min(1, a)); }

/* The angle of a box of points (x, y) = (b, a): at its corners, unless the cut lies in it. */
static bounds angle(bounds a, bounds b) {
  bounds result = nothing();
  if (b.low <= 0 && a.low <= 0 && a.high >= 0) {
    return between(-PI_NUMBER, PI_NUMBER);
  }
  include(&result, mech_atan2(a.low, b.low));
  include(&result, mech_atan2(a.low, b.high));
  include(&result, mech_atan2(a.high, b.low));
  include(&result, mech_atan2(a.high, b.high));
  return result;
}

/* A base that may be negative takes a whole exponent; other parts of it count as undefined. */
static bounds power(bounds a, bounds b) {
  bounds result = nothing();
  double n = b.low, low = mech_max(0, a.low), high = mech_max(0, a.high);
  if (b.low == b.high && n == mech_floor(n) && a.low < 0) {
    double first = mech_power(a.low, n), last = mech_power(a.high, n);
    if (n < 0 && a.high >= 0) {
      return all();
    }
    result = between(mech_min(first, last), mech_max(first, last));
    if (0.5 * n == mech_floor(0.5 * n) && a.high > 0) {
      result.low = 0;
    }
    return result;
  }
  include(&result, mech_power(low, b.low));
  include(&result, mech_power(low, b.high));
  include(&result, mech_power(high, b.low));
  include(&result, mech_power(high, b.high));
  return result;
}

/* Includes the extrema of a cubic between a and b: the zeros of c1 + 2 c2 d + 3 c3 d^2. */
static void include_extrema(bounds *result, const double *p, double a, double b) {
  double c1 = p[2], c2 = p[3], c3 = 3 * p[4], discriminant = c2 * c2 - c1 * c3, sum, one, other;
  if ((c2 == 0 && c3 == 0) || discriminant < 0) {
    return;
  }
  sum = -(c2 + copysign(sqrt(discriminant), c2));
  one = sum / c3;
  other = c1 / sum;
  if (one > a && one < b) {
    include(result, cubic(p, one));
  }
  if (other > a && other < b) {
    include(result, cubic(p, other));
  }
}

static bounds curve_bounds(const mech_watch_table *table, bounds x) {
  const double *points = WATCH_NUMBER + table->at, *p = points + table->points;
  int n = table->points, last = interval(points, n, x.high), place;
  bounds result = nothing();
  for (place = interval(points, n, x.low); place <= last; place++) {
    const double *of = p + 5 * place;
    double a = (place == 0 ? x.low : mech_max(x.low, points[place - 1])) - of[0];
    double b = (place == n ? x.high : mech_min(x.high, points[place])) - of[0];
    include(&result, cubic(of, a));
    include(&result, cubic(of, b));
    include_extrema(&result, of, a, b);
  }
  return result;
}

/* A cell's polynomial by Horner's rule on intervals. */
static bounds cell_bounds(const double *c, bounds a, bounds b) {
  bounds sum = between(0, 0);
  int i, j;
  for (i = 3; i >= 0; i--) {
    bounds row = between(0, 0);
    for (j = 3; j >= 0; j--) {
      row = product(row, b);
      row.low += c[4 * i + j];
      row.high += c[4 * i + j];
    }
    sum = product(sum, a);
    sum.low += row.low;
    sum.high += row.high;
  }
  return sum;
}

static bounds map_bounds(const mech_watch_table *table, bounds a, bounds b) {
  map_parts map = parts_of(table);
  int last_x = interval(map.x, map.nx, a.high), k, l;
  int first_y = interval(map.y, map.ny, b.low), last_y = interval(map.y, map.ny, b.high);
  bounds result = nothing();
  for (k = interval(map.x, map.nx, a.low); k <= last_x; k++) {
    bounds of_a = between((k == 0 ? a.low : mech_max(a.low, map.x[k - 1])) - map.origin_x[k],
                          (k == map.nx ? a.high : mech_min(a.high, map.x[k])) - map.origin_x[k]);
    for (l = first_y; l <= last_y; l++) {
      bounds of_b = between((l == 0 ? b.low : mech_max(b.low, map.y[l - 1])) - map.origin_y[l],
                            (l == map.ny ? b.high : mech_min(b.high, map.y[l])) - map.origin_y[l]);
      bounds cell = cell_bounds(map.cells + 16 * (k * (map.ny + 1) + l), of_a, of_b);
      result.low = mech_min(result.low, cell.low);
      result.high = mech_max(result.high, cell.high);
    }
  }
  return result;
}

/* What counts on one side only; 0 stands on the other. */
static bounds part(int taken, int left, bounds x) {
  if (!taken) {
    return between(0, 0);
  }
  return left ? between(mech_min(0, x.low), mech_max(0, x.high)) : x;
}

static bounds exact_bounds(const mech_watch_step *step, bounds a, bounds b) {
  bounds one, other;
  switch (step->operation) {
    case WATCH_ADD:
      return between(a.low + b.low, a.high + b.high);
    case WATCH_SUBTRACT:
      return between(a.low - b.high, a.high - b.low);
    case WATCH_MULTIPLY:
      return product(a, b);
    case WATCH_DIVIDE:
      return quotient(a, b);
    case WATCH_NEGATE:
      return between(-a.high, -a.low);
    case WATCH_SQUARE:
      return square(a);
    case WATCH_SQRT:
      return between(sqrt(mech_max(0, a.low)), sqrt(mech_max(0, a.high)));
    case WATCH_ABS:
      return absolute(a);
    case WATCH_SIN:
      return wave(mech_sine(a.low), mech_sine(a.high), a, 0.5 * PI_NUMBER);
    case WATCH_COS:
      return wave(mech_cosine(a.low), mech_cosine(a.high), a, 0);
    case WATCH_ASIN:
      return between(mech_asin(unit(a.low)), mech_asin(unit(a.high)));
    case WATCH_ACOS:
      return between(mech_acos(unit(a.high)), mech_acos(unit(a.low)));
    case WATCH_ATAN:
      return between(mech_atan(a.low), mech_atan(a.high));
    case WATCH_ATAN2:
      return angle(a, b);
    case WATCH_EXP:
      return between(mech_exp(a.low), mech_exp(a.high));
    case WATCH_LOG:
      return between(mech_log(mech_max(0, a.low)), mech_log(mech_max(0, a.high)));
    case WATCH_MIN:
      return between(mech_min(a.low, b.low), mech_min(a.high, b.high));
    case WATCH_MAX:
      return between(mech_max(a.low, b.low), mech_max(a.high, b.high));
    case WATCH_SINH:
      return between(mech_sinh(a.low), mech_sinh(a.high));
    case WATCH_COSH:
      one = absolute(a);
      return between(mech_cosh(one.low), mech_cosh(one.high));
    case WATCH_TANH:
      return between(mech_tanh(a.low), mech_tanh(a.high));
    case WATCH_SIGNUM:
      return between(mech_signum(a.low), mech_signum(a.high));
    case WATCH_HYPOT:
      one = square(a);
      other = square(b);
      return between(sqrt(one.low + other.low), sqrt(one.high + other.high));
    case WATCH_FLOOR:
      return between(mech_floor(a.low), mech_floor(a.high));
    case WATCH_STEP:
      return between(a.low < 0 ? 0 : 1, a.high < 0 ? 0 : 1);
    case WATCH_SMOOTH_STEP:
      return between(smooth_step(a.low), smooth_step(a.high));
    case WATCH_WHERE:
      return part(a.high >= 0, a.low < 0, b);
    case WATCH_ELSEWHERE:
      return part(a.low < 0, a.high >= 0, b);
    case WATCH_POWER:
      return power(a, b);
    case WATCH_CURVE:
      return curve_bounds(&WATCH_TABLE_OF[step->table], a);
    case WATCH_MAP:
      return map_bounds(&WATCH_TABLE_OF[step->table], a, b);
  }
  return all();
}

/* Whether an operation rounds; the others give one of a few values, or an operand. */
static int rounds(const mech_watch_step *step) {
  switch (step->operation) {
    case WATCH_NEGATE:
    case WATCH_ABS:
    case WATCH_MIN:
    case WATCH_MAX:
    case WATCH_SIGNUM:
    case WATCH_FLOOR:
    case WATCH_STEP:
    case WATCH_WHERE:
    case WATCH_ELSEWHERE:
      return 0;
    default:
      return 1;
  }
}

/* Bounds the value of a step over those of its operands; what is exactly 0 stays so. */
static void enclose(mech_watch_work *w, const mech_watch_step *step) {
  bounds result = exact_bounds(step, between(w->low[step->first], w->high[step->first]),
                               between(w->low[step->second], w->high[step->second]));
  if (!(result.low <= result.high)) {
    result = all();
  } else if (rounds(step)) {
    double error = (is_table(step) ? ROUNDING_OF_TABLE : ROUNDING) *
                       mech_max(fabs(result.low), fabs(result.high)) +
                   MIN_NORMAL;
    result.low -= result.low == 0 ? 0 : error;
    result.high += result.high == 0 ? 0 : error;
  }
  w->low[step->target] = result.low;
  w->high[step->target] = result.high;
}

/* ---- which choices can change in a box or along a short way ---- */

static double least_of(double a, double b, double c) { return mech_min(a, mech_min(b, c)); }

static double most_of(double a, double b, double c) { return mech_max(a, mech_max(b, c)); }

/* Bounds a slot beside the parabola through three values. */
static void follow(mech_watch_work *w, int slot, const double *start, const double *middle,
                   const double *end) {
  double a = start[slot], m = middle[slot], b = end[slot];
  double bow = MARGIN * fabs(a - 2 * m + b);
  w->low[slot] = least_of(a, m, b) - bow;
  w->high[slot] = most_of(a, m, b) + bow;
}

static int is_zero(const mech_watch_work *w, int slot) {
  return w->low[slot] == 0 && w->high[slot] == 0;
}

static int changes_little(double low, double high, double ratio) {
  return low > 0 ? high <= ratio * low : high < 0 && low >= ratio * high;
}

static int is_decided(const mech_watch_work *w, const mech_watch_step *step) {
  int a = step->first, b = step->second;
  if (step->operation == WATCH_MIN || step->operation == WATCH_MAX) {
    int apart = w->high[a] < w->low[b] || w->low[a] >= w->high[b];
    return apart || (is_zero(w, a) && is_zero(w, b));
  }
  return piece_of(step, w->low[a], w->low[b]) == piece_of(step, w->high[a], w->high[b]);
}

/* Whether an operation that can be narrow changes evenly all over the box. */
static int is_even(const mech_watch_work *w, const mech_watch_step *step) {
  double low = w->low[step->first], high = w->high[step->first];
  double b_low = w->low[step->second], b_high = w->high[step->second];
  const mech_watch_table *table = &WATCH_TABLE_OF[step->table];
  map_parts map;
  switch (step->operation) {
    case WATCH_DIVIDE:
      return changes_little(b_low, b_high, RATIO);
    case WATCH_EXP:
      return high - low <= EVEN || high < NO_POWER;
    case WATCH_TANH:
      return high - low <= EVEN || 2 * high < NO_POWER || 2 * low > -NO_POWER;
    case WATCH_ATAN:
      return high - low <= EVEN || changes_little(low, high, RATIO);
    case WATCH_POWER:
      return w->high[step->target] < mech_exp(NO_POWER) ||
             changes_little(low, high, mech_power(RATIO, 1 / mech_max(1, b_high)));
    case WATCH_CURVE:
      return interval(WATCH_NUMBER + table->at, table->points, high) -
                 interval(WATCH_NUMBER + table->at, table->points, low) <=
             1;
    case WATCH_MAP:
      map = parts_of(table);
      return interval(map.x, map.nx, high) - interval(map.x, map.nx, low) <= 1 &&
             interval(map.y, map.ny, b_high) - interval(map.y, map.ny, b_low) <= 1;
    default:
      return high - low <= EVEN;
  }
}

/* Whether an operation changes evenly within the bounds of its operands. */
static int changes_evenly(mech_watch_work *w, const mech_watch_step *step) {
  double low = w->low[step->first], high = w->high[step->first];
  double b_low = w->low[step->second], b_high = w->high[step->second];
  if (is_narrow(step)) {
    if (step->operation == WATCH_POWER) {
      enclose(w, step);
    }
    return is_even(w, step);
  }
  switch (step->operation) {
    case WATCH_ADD:
    case WATCH_SUBTRACT:
    case WATCH_NEGATE:
      return 1;
    /* curved factors that pass through zero make a corner that no three points show */
    case WATCH_SQUARE:
      return !(low <= 0 && high >= 0);
    case WATCH_MULTIPLY:
      return !(low <= 0 && high >= 0 && b_low <= 0 && b_high >= 0);
    case WATCH_SIN:
    case WATCH_COS:
      return high - low <= EVEN;
    case WATCH_SQRT:
    case WATCH_LOG:
      return changes_little(low, high, RATIO);
    case WATCH_ASIN:
    case WATCH_ACOS:
      return high < EVEN && low > -EVEN;
    case WATCH_HYPOT:
      return changes_little(low, high, RATIO) || changes_little(b_low, b_high, RATIO);
    case WATCH_ATAN2:
      return changes_little(b_low, b_high, RATIO) && b_low > 0;
    default:
      return is_decided(w, step);
  }
}

/* Marks the operands that matter to a step that does, and notes a choice that is open. */
static void pass_on(mech_watch_work *w, const mech_watch_step *step) {
  unsigned char *matters = w->matters;
  int a = step->first, b = step->second, a_is_zero, open;
  w->even &= !is_narrow(step) || is_even(w, step);
  open = step->choice >= 0 && !is_decided(w, step);
  if (open) {
    w->undecided[w->undecided_count++] = step->choice;
  }
  switch (step->operation) {
    case WATCH_MULTIPLY:
      a_is_zero = is_zero(w, a);
      matters[a] |= a_is_zero || !is_zero(w, b);
      matters[b] |= !a_is_zero;
      break;
    case WATCH_DIVIDE:
    case WATCH_POWER:
      matters[a] = 1;
      matters[b] |= !is_zero(w, a);
      break;
    case WATCH_MIN:
      matters[a] |= w->low[a] <= w->high[b];
      matters[b] |= w->low[b] <= w->high[a];
      break;
    case WATCH_MAX:
      matters[a] |= w->high[a] >= w->low[b];
      matters[b] |= w->high[b] >= w->low[a];
      break;
    case WATCH_WHERE:
    case WATCH_ELSEWHERE:
      matters[a] |= open;
      matters[b] |= !is_zero(w, step->target);
      break;
    case WATCH_STEP:
    case WATCH_SIGNUM:
    case WATCH_FLOOR:
      matters[a] |= open;
      break;
    case WATCH_SMOOTH_STEP:
      matters[a] |= w->high[a] >= 0 && w->low[a] <= 1;
      break;
    default:
      matters[a] = 1;
      matters[b] = 1;
  }
}

/* Finds the choices that matter and are not the same all over; returns whether there is none. */
static int find_open(mech_watch_work *w) {
  int i;
  memset(w->matters, 0, sizeof w->matters);
  for (i = 0; i < WATCH_FORMULAS; i++) {
    w->matters[WATCH_RESULT_SLOT[i]] = 1;
  }
  w->undecided_count = 0;
  w->even = 1;
  for (i = WATCH_STEPS - 1; i >= 0; i--) {
    if (w->matters[WATCH_STEP_OF[i].target]) {
      pass_on(w, &WATCH_STEP_OF[i]);
    }
  }
  for (i = 0; i < WATCH_CHOICES; i++) {
    const mech_watch_step *step = &WATCH_STEP_OF[WATCH_CHOICE_OF[i].step];
    if (WATCH_CHOICE_OF[i].sign && !w->matters[step->target] && !is_decided(w, step)) {
      w->undecided[w->undecided_count++] = i;
    }
  }
  return w->undecided_count == 0;
}

/* The same along a short way, by its start, middle and end. */
static int decide(mech_watch_work *w, const double *start, const double *middle,
                  const double *end) {
  int i;
  for (i = 0; i < WATCH_LEAVES; i++) {
    follow(w, WATCH_LEAF_SLOT[i], start, middle, end);
  }
  for (i = 0; i < WATCH_STEPS; i++) {
    const mech_watch_step *step = &WATCH_STEP_OF[i];
    int rough = w->rough[step->first] || w->rough[step->second] || !changes_evenly(w, step);
    w->rough[step->target] = (unsigned char)rough;
    if (rough) {
      enclose(w, step);
    } else {
      follow(w, step->target, start, middle, end);
    }
  }
  return find_open(w);
}

/* How far the argument of an open choice can go beyond the boundary between its pieces. */
static double excursion(const mech_watch_work *w, int choice) {
  const mech_watch_step *step = &WATCH_STEP_OF[WATCH_CHOICE_OF[choice].step];
  int a = step->first, b = step->second;
  switch (step->operation) {
    case WATCH_MIN:
    case WATCH_MAX:
      return mech_min(w->high[a] - w->low[b], w->high[b] - w->low[a]);
    case WATCH_ABS:
      return mech_min(-w->low[a], w->high[a]);
    case WATCH_SMOOTH_STEP:
    case WATCH_CURVE:
    case WATCH_MAP:
      return mech_max(w->high[a] - w->low[a], w->high[b] - w->low[b]);
    default:
      return HUGE_VAL;
  }
}

/* Notes the largest sizes of what decides the choices: of a part the first argument. */
static void note_sizes(mech_watch_work *w) {
  int i;
  for (i = 0; i < WATCH_CHOICES; i++) {
    const mech_watch_step *step = &WATCH_STEP_OF[WATCH_CHOICE_OF[i].step];
    int part = step->operation == WATCH_WHERE || step->operation == WATCH_ELSEWHERE;
    int a = step->first, b = part ? a : step->second;
    double size =
        mech_max(mech_max(-w->low[a], w->high[a]), mech_max(-w->low[b], w->high[b]));
    if (fabs(size) < HUGE_VAL) {
      w->kept->sizes[i] = mech_max(w->kept->sizes[i], size);
    }
  }
}

/* Whether open choices go beyond their boundaries by no more than rounding counts. */
static int open_by_nothing(const mech_watch_work *w) {
  int k;
  for (k = 0; k < w->undecided_count; k++) {
    int choice = w->undecided[k];
    if (excursion(w, choice) > TOUCH * w->kept->sizes[choice]) {
      return 0;
    }
  }
  return 1;
}

/* ---- the search ---- */

/* Evaluates all slots at a time; returns 0 where there is no state. */
static int evaluate(mech_watch_work *w, double t, double *point) {
  int i, rate = 0;
  w->evaluations++;
  if (!w->path(w->run, t, w->here)) {
    return 0;
  }
  for (i = 0; i < WATCH_LEAVES; i++) {
    point[WATCH_LEAF_SLOT[i]] = w->here[i];
  }
  for (i = 0; i < WATCH_STEPS; i++) {
    const mech_watch_step *step = &WATCH_STEP_OF[i];
    point[step->target] = value(step, point[step->first], point[step->second]);
  }
  for (i = 0; i < WATCH_TURNS; i++) {
    double turn = 0;
    for (; rate < WATCH_TURN_END[i]; rate++) {
      turn += fabs(w->here[WATCH_TURN_RATE[rate]]);
    }
    w->turning = mech_max(w->turning, turn);
  }
  return 1;
}

/* Into how many parts a step is divided, so that bodies turn little in each. */
static int parts(const mech_watch_work *w, double h) {
  double count = -mech_floor(-(w->turning * h / TURN));
  return count >= 1 ? (int)mech_min(MOST_PARTS, count) : 1;
}

/* The way of a leaf in a step from its values at both ends and in the middle: bounds and bow. */
static bounds way(const mech_watch_work *w, int leaf, double *bow) {
  int slot = WATCH_LEAF_SLOT[leaf];
  double a = w->from[slot], m = w->middle[slot], b = w->to[slot];
  *bow = MARGIN * fabs(a - 2 * m + b);
  return between(least_of(a, m, b), most_of(a, m, b));
}

static int evaluate_middle(mech_watch_work *w, double from, double to) {
  w->middle_known = w->middle_known || evaluate(w, 0.5 * (from + to), w->middle);
  return w->middle_known;
}

/* Whether the quantities stay in a box in which nothing changes its form. */
static int stays_in_box(mech_watch_work *w, double from, double to) {
  int leaf;
  if (!w->kept->boxed || parts(w, to - from) > 1 || !evaluate_middle(w, from, to)) {
    return 0;
  }
  for (leaf = 0; leaf < WATCH_LEAVES; leaf++) {
    double bow;
    bounds of = way(w, leaf, &bow);
    if (of.low - bow < w->kept->box_low[leaf] || of.high + bow > w->kept->box_high[leaf]) {
      return 0;
    }
  }
  w->kept->pause = 0;
  return 1;
}

/* Finds a box for the steps to come, if nothing changes its form in one about this step. */
static void find_box(mech_watch_work *w, double from, double to) {
  mech_watch *kept = w->kept;
  double growth;
  if (kept->boxed) {
    kept->boxed = 0;
    kept->pause_left = kept->pause;
  }
  if (kept->pause_left > 0) {
    kept->pause_left--;
    return;
  }
  if (parts(w, to - from) > 1 || !evaluate_middle(w, from, to)) {
    return;
  }
  for (growth = LARGE_BOX; !kept->boxed && growth >= SMALL_BOX; growth *= SHRINKAGE) {
    int i;
    for (i = 0; i < WATCH_LEAVES; i++) {
      double bow, beside;
      bounds of = way(w, i, &bow);
      beside = growth * (of.high - of.low) + bow;
      kept->box_low[i] = w->low[WATCH_LEAF_SLOT[i]] = of.low - beside;
      kept->box_high[i] = w->high[WATCH_LEAF_SLOT[i]] = of.high + beside;
    }
    for (i = 0; i < WATCH_STEPS; i++) {
      enclose(w, &WATCH_STEP_OF[i]);
    }
    kept->boxed = find_open(w) && w->even;
    for (i = 0; growth == BESIDE && i < w->undecided_count; i++) {
      kept->changes[w->undecided[i]]++;
    }
  }
  kept->pause = mech_min(LONGEST_PAUSE, 2 * kept->pause + 1);
  kept->pause_left = kept->pause;
}

static void read_point(const double *point, double *pieces, double *values) {
  int i;
  for (i = 0; i < WATCH_CHOICES; i++) {
    pieces[i] = piece(i, point);
  }
  for (i = 0; i < WATCH_FORMULAS; i++) {
    values[i] = point[WATCH_RESULT_SLOT[i]];
  }
}

static void note_unsearched(mech_watch_work *w) {
  if (!w->gave_up) {
    w->gave_up = 1;
    w->kept->unsearched++;
  }
}

/* An open choice that differs at the ends of a part, of several the one that others may follow
 * from; -1 if there is none. */
static int changed(const mech_watch_work *w, const double *start, const double *end) {
  int k, first = -1;
  for (k = 0; k < w->undecided_count; k++) {
    int choice = w->undecided[k];
    if ((first < 0 || choice < first) && piece(choice, start) != piece(choice, end)) {
      first = choice;
    }
  }
  return first;
}

/* A time just behind a change at which the argument of the choice is off its boundary by more than
 * rounding, so that equations that compute it in another order choose the same: at most the end of
 * the step, and FARTHEST widths where the argument stays at the boundary. */
static double clear(mech_watch_work *w, int choice, double behind, double width) {
  double t = behind, beyond;
  for (beyond = width; beyond <= FARTHEST * width; beyond *= 2) {
    if (t >= w->finish || !evaluate(w, t, w->narrowing)) {
      return t < w->finish ? t : w->finish;
    }
    if (distance(choice, w->narrowing) > CLEAR * w->kept->sizes[choice]) {
      return t;
    }
    t = behind + beyond;
  }
  return t < w->finish ? t : w->finish;
}

/* The time just behind the change of a choice in a part. */
static double narrowed(mech_watch_work *w, int choice, double start, const double *at_start,
                       double end) {
  double of = piece(choice, at_start), before = start, behind = end;
  double width = RESOLUTION * last_place(end);
  while (behind - before > width) {
    double middle = 0.5 * (before + behind);
    if (!evaluate(w, middle, w->narrowing)) {
      break;
    }
    if (piece(choice, w->narrowing) == of) {
      before = middle;
    } else {
      behind = middle;
    }
  }
  return clear(w, choice, behind, width);
}

/* Whether the ends of the step show that a choice changes in it. */
static int shows(const mech_watch_work *w, int choice) {
  return fabs(w->pieces_to[choice] - w->pieces_from[choice]) == 1;
}

/* Decides whether a change of a choice ends the step, and counts it if so. A choice that goes on to
 * a third piece does not hover about a boundary. */
static int counts(mech_watch_work *w, int choice, const double *start, const double *end) {
  mech_watch *kept = w->kept;
  double leaving = piece(choice, start);
  int back = leaving == kept->left[choice] || piece(choice, end) == kept->left[choice];
  double row = back && kept->since_change[choice] < CLOSE ? kept->close_changes[choice] + 1 : 1;
  int taken = row <= (shows(w, choice) ? MOST_CLOSE : MOST_HIDDEN);
  if (!taken && !shows(w, choice)) {
    note_unsearched(w);
  }
  if (w->looking) {
    kept->since_change[choice] = 0;
    kept->left[choice] = leaving;
    kept->close_changes[choice] = taken ? row : kept->close_changes[choice];
    kept->changes[choice]++;
  }
  return taken;
}

/* The place of a change if it ends the step, else NaN. */
static double taken(mech_watch_work *w, int choice, const double *start, const double *end,
                    double place) {
  if (w->first_seen[choice] == w->first_seen[choice]) {
    return w->first_seen[choice];
  }
  if (shows(w, choice) && WATCH_CHOICE_OF[choice].sign) {
    w->first_seen[choice] = place;
  } else if (counts(w, choice, start, end)) {
    return place;
  }
  return NAN;
}

/* Whether the formulas stay near their values at the ends of the step all over a part in which
 * they change evenly. */
static int formulas_show(mech_watch_work *w, const double *start, const double *between_them,
                         const double *end) {
  mech_watch *kept = w->kept;
  int r;
  for (r = 0; WATCH_NARROW && r < WATCH_FORMULAS; r++) {
    int slot = WATCH_RESULT_SLOT[r];
    double least = mech_min(w->value_from[r], w->value_to[r]);
    double most = mech_max(w->value_from[r], w->value_to[r]);
    double expected = 2 * (most - least) + 2 * fabs(w->value_from[r] - kept->before[r]) +
                      NOTHING * kept->largest[r];
    double a = start[slot], m = between_them[slot], b = end[slot];
    double bow = MARGIN * fabs(a - 2 * m + b);
    double lowest = least_of(a, m, b) - bow, highest = most_of(a, m, b) + bow;
    if (mech_max(highest - most, least - lowest) > expected) {
      if (!w->looking) {
        return 0;
      }
      w->hidden = 1;
      kept->largest[r] = mech_max(kept->largest[r], mech_max(-lowest, highest));
    }
  }
  return 1;
}

static double search_part(mech_watch_work *w, int depth, double start, const double *at_start,
                          double end, const double *at_end);

/* Where the step has to end within a part of it with a point in its middle; NaN if it may go on. */
static double search_between(mech_watch_work *w, int depth, double start, const double *at_start,
                             const double *at_middle, double end, const double *at_end) {
  double middle = 0.5 * (start + end), found;
  int decided = decide(w, at_start, at_middle, at_end), finest;
  if (depth == 0) {
    note_sizes(w);
  }
  finest = depth >= WATCH_DEPTH || w->evaluations > w->allowed ||
           !(middle > start && middle < end);
  if (!decided && (finest || open_by_nothing(w))) {
    int choice = changed(w, at_start, at_end);
    if (choice < 0) {
      if (depth < WATCH_DEPTH && w->evaluations > w->allowed) {
        note_unsearched(w);
      }
      return NAN;
    }
    if (finest) {
      return taken(w, choice, at_start, at_end, narrowed(w, choice, start, at_start, end));
    }
  } else if (finest) {
    return NAN;
  }
  if (decided && w->even) {
    if (formulas_show(w, at_start, at_middle, at_end) ||
        (start == w->begin && depth >= FORMULA_DEPTH)) {
      return NAN;
    }
    if (start > w->begin) {
      w->kept->longest_first_step = FIRST_STEP * (end - start);
      return start;
    }
  }
  found = search_part(w, depth + 1, start, at_start, middle, at_middle);
  return found == found ? found
                        : search_part(w, depth + 1, middle, at_middle, end, at_end);
}

/* The same of a part whose middle is not known. */
static double search_part(mech_watch_work *w, int depth, double start, const double *at_start,
                          double end, const double *at_end) {
  double *at_middle = w->between[depth];
  for (; w->depths <= depth; w->depths++) {
    memcpy(w->between[w->depths], WATCH_INITIAL, sizeof w->from);
  }
  return evaluate(w, 0.5 * (start + end), at_middle)
             ? search_between(w, depth, start, at_start, at_middle, end, at_end)
             : NAN;
}

static double search_parts(mech_watch_work *w, double from, double to, int count) {
  double start = from;
  int k;
  if (count == 1) {
    return evaluate_middle(w, from, to)
               ? search_between(w, 0, from, w->from, w->middle, to, w->to)
               : NAN;
  }
  w->middle_known = 0;
  memcpy(w->moving, w->from, sizeof w->moving);
  for (k = 1; k <= count; k++) {
    double end = k == count ? to : from + (to - from) * k / count, found;
    if (!evaluate(w, end, w->middle)) {
      return NAN;
    }
    found = search_part(w, 0, start, w->moving, end, w->middle);
    if (found == found) {
      return found;
    }
    memcpy(w->moving, w->middle, sizeof w->moving);
    start = end;
  }
  return NAN;
}

static void forget_first_seen(mech_watch_work *w) {
  int i;
  for (i = 0; i < WATCH_CHOICES; i++) {
    w->first_seen[i] = NAN;
  }
}

/* Where a step has to end; NaN if it may stand. */
static double search_all(mech_watch_work *w, double from, double to) {
  mech_watch *kept = w->kept;
  int r, count;
  double end;
  read_point(w->from, w->pieces_from, w->value_from);
  if (!kept->begun) {
    memcpy(kept->before, w->value_from, sizeof kept->before);
    kept->begun = 1;
  }
  read_point(w->to, w->pieces_to, w->value_to);
  for (r = 0; r < WATCH_FORMULAS; r++) {
    kept->largest[r] =
        mech_max(kept->largest[r], mech_max(fabs(w->value_from[r]), fabs(w->value_to[r])));
  }
  count = parts(w, to - from);
  forget_first_seen(w);
  w->allowed = 2 * (long)count + MOST_EVALUATIONS;
  w->looking = 1;
  w->hidden = 0;
  end = search_parts(w, from, to, count);
  if (w->hidden) {
    /* once more, now that it is known how large the formulas become */
    double last = end == end ? end : to;
    w->looking = 0;
    w->evaluations = 0;
    forget_first_seen(w);
    w->finish = last;
    w->middle_known = 0;
    if (evaluate(w, last, w->to)) {
      double before = search_parts(w, from, last, count);
      end = before == before ? before : end;
    }
  }
  kept->begun = !(end == end);
  if (kept->begun) {
    memcpy(kept->before, w->value_from, sizeof kept->before);
  }
  return end;
}

/* Whether the value of a choice jumps where its piece changes. */
static int jumps(int choice) {
  mech_watch_operation operation = WATCH_STEP_OF[WATCH_CHOICE_OF[choice].step].operation;
  return operation == WATCH_STEP || operation == WATCH_SIGNUM || operation == WATCH_FLOOR ||
         operation == WATCH_WHERE || operation == WATCH_ELSEWHERE;
}

/* Looks, at the end of each row of steps, for a choice that jumps, has changed in them and has
 * stayed at its boundary all the time. */
static void look_for_sliding(mech_watch_work *w) {
  mech_watch *kept = w->kept;
  int i;
  kept->sliding_since = NAN;
  kept->row_began = kept->steps_in_row == 0 ? w->begin : kept->row_began;
  for (i = 0; i < WATCH_CHOICES; i++) {
    if (jumps(i)) {
      kept->farthest[i] = mech_max(kept->farthest[i], distance(i, w->from));
    }
  }
  if (++kept->steps_in_row < ROW) {
    return;
  }
  for (i = 0; i < WATCH_CHOICES; i++) {
    if (jumps(i) && kept->farthest[i] < HOVERING * kept->sizes[i] && kept->changes[i] >= CHANGES) {
      kept->sliding_since = kept->row_began;
    }
  }
  kept->steps_in_row = 0;
  memset(kept->farthest, 0, sizeof kept->farthest);
  memset(kept->changes, 0, sizeof kept->changes);
}

static void pass_step(mech_watch_work *w) {
  mech_watch *kept = w->kept;
  int i;
  look_for_sliding(w);
  for (i = 0; i < WATCH_CHOICES; i++) {
    kept->since_change[i] = mech_min(CLOSE, kept->since_change[i] + 1);
  }
}

void mech_watch_init(mech_watch *kept) {
  int i;
  memset(kept, 0, sizeof *kept);
  for (i = 0; i < WATCH_CHOICES; i++) {
    kept->since_change[i] = CLOSE;
    kept->left[i] = NAN;
  }
  kept->longest_first_step = HUGE_VAL;
  kept->sliding_since = NAN;
}

void mech_watch_begin(mech_watch *kept) { kept->begun = 0; }

/* Constants at their values in points, and as bounds. */
static void prepare(mech_watch_work *w) {
  size_t size = sizeof w->from;
  memcpy(w->from, WATCH_INITIAL, size);
  memcpy(w->middle, WATCH_INITIAL, size);
  memcpy(w->to, WATCH_INITIAL, size);
  memcpy(w->narrowing, WATCH_INITIAL, size);
  memcpy(w->low, WATCH_INITIAL, size);
  memcpy(w->high, WATCH_INITIAL, size);
  memset(w->rough, 0, sizeof w->rough);
  w->ready = 1;
}

static void use(mech_watch_work *w, mech_watch *kept, mech_watch_path *path, void *run) {
  if (!w->ready) {
    prepare(w);
  }
  w->kept = kept;
  w->path = path;
  w->run = run;
}

double mech_watch_across(mech_watch *kept, mech_watch_work *w, mech_watch_path *path, void *run,
                         double t) {
  int crossed = -1;
  long roundings;
  use(w, kept, path, run);
  if (!evaluate(w, 0, w->from)) {
    return 0;
  }
  for (roundings = 1; roundings <= ACROSS; roundings *= 2) {
    double ahead = (double)roundings * last_place(t);
    if (!evaluate(w, ahead, w->to)) {
      return 0;
    }
    if (crossed < 0 && !decide(w, w->from, w->to, w->to)) {
      crossed = changed(w, w->from, w->to);
    }
    if (crossed >= 0 && distance(crossed, w->to) > CLEAR * kept->sizes[crossed]) {
      kept->begun = kept->boxed = 0;
      return ahead;
    }
  }
  return 0;
}

double mech_watch_search(mech_watch *kept, mech_watch_work *w, mech_watch_path *path, void *run,
                         double from, double to) {
  double end;
  use(w, kept, path, run);
  w->begin = from;
  w->finish = to;
  w->gave_up = 0;
  kept->longest_first_step = HUGE_VAL;
  w->evaluations = 0;
  w->turning = 0;
  w->middle_known = 0;
  if (!evaluate(w, from, w->from) || !evaluate(w, to, w->to)) {
    return NAN;
  }
  if (stays_in_box(w, from, to)) {
    kept->begun = 0;
    pass_step(w);
    return NAN;
  }
  end = search_all(w, from, to);
  if (end == end) {
    kept->boxed = 0;
  } else {
    find_box(w, from, to);
  }
  pass_step(w);
  return end;
}
