#include "mech_fmu.h"

#include <float.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The model was printed for these numbers. */
typedef char mech_check_states[MODEL_CHECK ? 1 : -1];

static const unsigned long INSTANCE = 0x4d454348UL, SAVED = 0x53415645UL;

/* Steps tried in one communication step, and events in it, before the run ends. */
enum { MOST_TRIES = 1000000, MOST_EVENTS = 1000 };

/* The tolerance of a run is meant for its results; errors of steps add up and grow, so that the
 * method works at a part of it. Closed loops, whose dependent coordinates run through dead points
 * many times as fast as the others, need a smaller part. docs/reports/export.md has the errors.
 * Below the last number round-off outweighs what it gains. */
static const double SAFETY = MODEL_LOOPS ? 300 : 100, FINEST = 1e-13;

/* Events in a row that come ever closer or at once before they are said to accumulate, the distance
 * that is hardly more than their uncertainty, relative to t, and how close ahead the point at which
 * they would meet is, relative to the time elapsed: as in a run of Java. */
enum { IN_A_ROW = 20 };
static const double CHATTER = 1e-10, CLOSE_AHEAD = 1e-6;

#ifdef MODEL_WATCHES
/* Rows of steps at one jump that may be left of a run. */
static const double MOST_ROWS = 1000;
#endif

/* Parts of a step at whose ends the event functions are looked at. */
enum { LOOKS = 4 };

typedef struct {
  unsigned long magic;
  mech_state s;
} saved_state;

static int finite_number(double x) { return fabs(x) <= DBL_MAX; }

mech_status mech_say(const mech_instance *c, mech_status status, const char *format, ...) {
  char text[512];
  va_list arguments;
  if (c == NULL || c->log == NULL || (status < MECH_FAILED && !c->logging)) {
    return status;
  }
  va_start(arguments, format);
  vsnprintf(text, sizeof text, format, arguments);
  va_end(arguments);
  c->log(c, status,
         status == MECH_OK        ? "logAll"
         : status == MECH_WARNING ? "logStatusWarning"
         : status == MECH_DISCARD ? "logStatusDiscard"
                                  : "logStatusError",
         text);
  return status;
}

static const char *mode_name(mech_mode mode) {
  switch (mode) {
    case MECH_INSTANTIATED:
      return "instantiated";
    case MECH_INITIALIZATION:
      return "initialization mode";
    case MECH_EVENT:
      return "event mode";
    case MECH_CONTINUOUS:
      return "continuous-time mode";
    case MECH_STEPPING:
      return "step mode";
    case MECH_STEP_FAILED:
      return "the state after a step that failed";
    case MECH_TERMINATED:
      return "the state after terminate";
    case MECH_ERROR:
      return "the state after an error";
  }
  return "an unknown state";
}

int mech_may(mech_instance *c, const char *function, int modes) {
  if (c == NULL || c->magic != INSTANCE) {
    return 0;
  }
  if ((c->s.mode & modes) == 0) {
    mech_say(c, MECH_FAILED, "%s: not allowed in %s.", function, mode_name(c->s.mode));
    return 0;
  }
  return 1;
}

static void forget(mech_instance *c) { c->derivatives_known = c->outputs_known = 0; }

static mech_status model_failed(mech_instance *c, mech_status status, const char *what) {
  const char *why = MODEL_failure(&c->s.model);
  if (MODEL_LOST(&c->s.model)) {
    status = MECH_FAILED; /* no shorter step leads on */
  } else if (MODEL_IS_LOSING(&c->s.model) && status < MECH_FAILED) {
    /* importers that do not take shorter steps end here: their log has the reason */
    int logging = c->logging;
    c->logging = 1;
    mech_say(c, status, "%s at t = %.17g: %s", what, c->s.t, why);
    c->logging = logging;
    return status;
  }
  return mech_say(c, status, "%s at t = %.17g: %s", what, c->s.t,
                  why != NULL && why[0] != 0 ? why : "a value is not finite.");
}

mech_instance *mech_create(void *(*allocate)(size_t, size_t), void (*release)(void *),
                           const char *name) {
  mech_instance *c = allocate(1, sizeof *c);
  if (c == NULL) {
    return NULL;
  }
  memset(c, 0, sizeof *c);
  c->name = allocate(1, strlen(name) + 1);
  if (c->name == NULL) {
    release(c);
    return NULL;
  }
  strcpy(c->name, name);
  c->magic = INSTANCE;
  c->release = release;
  mech_reset(c);
  return c;
}

void mech_free(mech_instance *c) {
  if (c != NULL && c->magic == INSTANCE) {
    void (*release)(void *) = c->release;
    c->magic = 0;
    release(c->name);
    release(c);
  }
}

void mech_reset(mech_instance *c) {
  memset(&c->s, 0, sizeof c->s);
  MODEL_init(&c->s.model);
  c->s.mode = MECH_INSTANTIATED;
  c->s.start = c->s.t = MODEL_START;
  c->s.rtol = MODEL_RTOL;
#ifdef MODEL_WATCHES
  mech_watch_init(&c->s.watch);
#endif
  forget(c);
}

mech_status mech_set_up(mech_instance *c, int tolerance_defined, double tolerance, double start,
                        int stop_defined, double stop) {
  if (!finite_number(start) || (stop_defined && !(finite_number(stop) && stop >= start))) {
    return mech_say(c, MECH_FAILED, "The run from t = %g to %g is not an interval of time.", start,
                    stop);
  }
  if (tolerance_defined && !(tolerance > 0 && tolerance < 1)) {
    return mech_say(c, MECH_FAILED, "The relative tolerance %g is not between 0 and 1.", tolerance);
  }
  c->s.start = c->s.t = start;
  c->s.stop = stop;
  c->s.stop_defined = stop_defined;
  c->s.rtol = tolerance_defined ? (tolerance > 2.3e-14 ? tolerance : 2.3e-14) : MODEL_RTOL;
  c->s.start_known = 0;
  forget(c);
  return MECH_OK;
}

/* Start values that follow from the parameters, but for those that were set. */
static mech_status know_start(mech_instance *c) {
  double x[MECH_N] = {0};
  int i;
  if (c->s.start_known || (c->s.mode & (MECH_INSTANTIATED | MECH_INITIALIZATION)) == 0) {
    return MECH_OK;
  }
  if (MODEL_start(&c->s.model, c->s.t, x) < 0) {
    return model_failed(c, MECH_FAILED, "No start state");
  }
  for (i = 0; i < MODEL_NX; i++) {
    if (!c->s.set[i]) {
      c->s.x[i] = x[i];
    }
  }
  c->s.start_known = 1;
  forget(c);
  return MECH_OK;
}

mech_status mech_initialised(mech_instance *c) {
  mech_status status = know_start(c);
  if (status != MECH_OK) {
    return status;
  }
  if (MODEL_close(&c->s.model, c->s.t, c->s.x, c->s.set) < 0) {
    return model_failed(c, MECH_FAILED, "The start state cannot be moved onto the constraints");
  }
  if (MODEL_begin(&c->s.model, c->s.t, c->s.x) < 0) {
    return model_failed(c, MECH_FAILED, "The samples at the start cannot be applied");
  }
  MODEL_accepted(&c->s.model, c->s.t, c->s.x);
  forget(c);
  return mech_begin_continuous(c);
}

static mech_status know_derivatives(mech_instance *c) {
  mech_status status = know_start(c);
  int i;
  if (status != MECH_OK || c->derivatives_known) {
    return status;
  }
  memset(c->dx, 0, sizeof c->dx);
  if (MODEL_derivatives(&c->s.model, c->s.t, c->s.x, c->dx) < 0) {
    return model_failed(c, MECH_DISCARD, "The derivatives cannot be formed");
  }
  for (i = 0; i < MODEL_NX; i++) {
    if (!finite_number(c->dx[i])) {
      return mech_say(c, MECH_DISCARD, "The derivative of state %d is not finite at t = %.17g.", i,
                      c->s.t);
    }
  }
  c->derivatives_known = 1;
  return MECH_OK;
}

#if MODEL_NY > 0
static mech_status know_outputs(mech_instance *c) {
  mech_status status = know_start(c);
  if (status != MECH_OK || c->outputs_known) {
    return status;
  }
  if (MODEL_outputs(&c->s.model, c->s.t, c->s.x, c->y) < 0) {
    return model_failed(c, MECH_DISCARD, "The outputs cannot be formed");
  }
  c->outputs_known = 1;
  return MECH_OK;
}
#endif

mech_status mech_get(mech_instance *c, const char *function, unsigned reference, double *value) {
  mech_status status = MECH_OK;
  if (reference == MECH_TIME) {
    *value = c->s.t;
  } else if (reference < MECH_DERIVATIVE) {
    status = know_start(c);
    *value = c->s.x[reference - MECH_STATE];
  } else if (reference < MECH_PARAMETER) {
    status = know_derivatives(c);
    *value = c->dx[reference - MECH_DERIVATIVE];
#if MODEL_NP > 0
  } else if (reference < MECH_INPUT) {
    *value = MODEL_P(&c->s.model)[reference - MECH_PARAMETER];
#endif
#if MODEL_NU > 0
  } else if (reference < MECH_OUTPUT) {
    *value = MODEL_U(&c->s.model)[reference - MECH_INPUT];
#endif
#if MODEL_NY > 0
  } else if (reference < MECH_INDICATOR) {
    status = know_outputs(c);
    *value = c->y[reference - MECH_OUTPUT];
#endif
#if MODEL_NG > 0
  } else if (reference < MECH_END) {
    double g[MECH_NG];
    status = mech_get_indicators(c, function, g, MODEL_NG);
    *value = g[reference - MECH_INDICATOR];
#endif
  } else {
    status = mech_say(c, MECH_FAILED, "%s: no variable has the value reference %u.", function,
                      reference);
  }
  return status;
}

#if MODEL_NP > 0 || MODEL_NU > 0
/* Integration begins anew at this place, with what was set. */
static void changed_here(mech_instance *c) {
  c->s.begun = 0;
  forget(c);
}
#endif

mech_status mech_set(mech_instance *c, const char *function, unsigned reference, double value) {
  int before = (c->s.mode & (MECH_INSTANTIATED | MECH_INITIALIZATION)) != 0;
  if (!finite_number(value)) {
    return mech_say(c, MECH_FAILED, "%s: the value for the reference %u is not finite.", function,
                    reference);
  }
  if (reference >= MECH_STATE && reference < MECH_DERIVATIVE && before) {
    c->s.x[reference - MECH_STATE] = value;
    c->s.set[reference - MECH_STATE] = 1;
    forget(c);
    return MECH_OK;
  }
#if MODEL_NP > 0
  if (reference >= MECH_PARAMETER && reference < MECH_INPUT) {
    if (c->s.mode == MECH_CONTINUOUS) {
      return mech_say(c, MECH_FAILED,
                      "%s: parameter %u cannot be set in continuous-time mode; enter event mode.",
                      function, reference);
    }
    if (MODEL_P(&c->s.model)[reference - MECH_PARAMETER] != value) {
      MODEL_P(&c->s.model)[reference - MECH_PARAMETER] = value;
      c->s.start_known = 0;
      changed_here(c);
    }
    return MECH_OK;
  }
#endif
#if MODEL_NU > 0
  if (reference >= MECH_INPUT && reference < MECH_OUTPUT) {
    if (MODEL_U(&c->s.model)[reference - MECH_INPUT] != value) {
      MODEL_U(&c->s.model)[reference - MECH_INPUT] = value;
      changed_here(c);
    }
    return MECH_OK;
  }
#endif
  return mech_say(c, MECH_FAILED, "%s: %s %u cannot be set in %s.", function,
                  reference < MECH_END ? "the variable with the value reference"
                                       : "no variable has the value reference",
                  reference, mode_name(c->s.mode));
}

mech_status mech_set_time(mech_instance *c, const char *function, double t) {
  if (!finite_number(t)) {
    return mech_say(c, MECH_FAILED, "%s: the time is not finite.", function);
  }
  c->s.t = t;
  forget(c);
  return MECH_OK;
}

static mech_status right_count(mech_instance *c, const char *function, const void *values, size_t n,
                               int expected) {
  if (n != (size_t)expected || (n > 0 && values == NULL)) {
    return mech_say(c, MECH_FAILED, "%s: %lu values where the model has %d.", function,
                    (unsigned long)n, expected);
  }
  return MECH_OK;
}

mech_status mech_set_states(mech_instance *c, const char *function, const double *x, size_t n) {
  size_t i;
  if (right_count(c, function, x, n, MODEL_NX) != MECH_OK) {
    return MECH_FAILED;
  }
  for (i = 0; i < n; i++) {
    if (!finite_number(x[i])) {
      return mech_say(c, MECH_FAILED, "%s: state %lu is not finite.", function, (unsigned long)i);
    }
  }
  memmove(c->s.x, x, n * sizeof(double));
  forget(c);
  return MECH_OK;
}

mech_status mech_get_states(mech_instance *c, const char *function, double *x, size_t n) {
  mech_status status = right_count(c, function, x, n, MODEL_NX);
  if (status == MECH_OK) {
    status = know_start(c);
    memmove(x, c->s.x, n * sizeof(double));
  }
  return status;
}

mech_status mech_get_derivatives(mech_instance *c, const char *function, double *dx, size_t n) {
  mech_status status = right_count(c, function, dx, n, MODEL_NX);
  if (status == MECH_OK && (status = know_derivatives(c)) == MECH_OK) {
    memmove(dx, c->dx, n * sizeof(double));
  }
  return status;
}

static mech_status events_at(mech_instance *c, double t, const double *x, double *g) {
  int i;
  memset(g, 0, MECH_NG * sizeof(double));
  if (MODEL_NG > 0 && MODEL_event_values(&c->s.model, t, x, g) < 0) {
    return model_failed(c, MECH_DISCARD, "The event functions cannot be formed");
  }
  for (i = 0; i < MODEL_NG; i++) {
    if (!finite_number(g[i])) {
      return mech_say(c, MECH_DISCARD, "Event function %d is not finite at t = %.17g.", i, t);
    }
  }
  return MECH_OK;
}

mech_status mech_get_indicators(mech_instance *c, const char *function, double *g, size_t n) {
  double values[MECH_NG];
  mech_status status = right_count(c, function, g, n, MODEL_NG);
  if (status == MECH_OK && (status = know_start(c)) == MECH_OK &&
      (status = events_at(c, c->s.t, c->s.x, values)) == MECH_OK && n > 0) {
    memmove(g, values, n * sizeof(double));
  }
  return status;
}

/* Event functions a little later, by the derivative: the direction in which they leave a zero. */
static mech_status events_ahead(mech_instance *c, double *ahead) {
  double x[MECH_N];
  double interval = c->s.stop_defined ? c->s.stop - c->s.start : MODEL_INTERVAL;
  double e = 1e-6 * (interval > 0 ? interval : 1);
  mech_status status = know_derivatives(c);
  int i;
  for (i = 0; i < MODEL_NX; i++) {
    x[i] = c->s.x[i] + e * c->dx[i];
  }
  return status == MECH_OK ? events_at(c, c->s.t + e, x, ahead) : status;
}

/* Signs from here on. Where a jump has just happened at a zero, the direction in which the function
 * leaves it counts: its value there is round-off. */
static mech_status take_signs(mech_instance *c, const unsigned char *fired) {
  double g[MECH_NG], ahead[MECH_NG];
  mech_status status = events_at(c, c->s.t, c->s.x, g);
  int i;
  if (MODEL_NG == 0 || status != MECH_OK || (status = know_derivatives(c)) != MECH_OK) {
    return status;
  }
  status = events_ahead(c, ahead);
  for (i = 0; i < MODEL_NG; i++) {
    double value = g[i];
    if (status == MECH_OK && (value == 0 || (fired != NULL && fired[i] &&
                                             fabs(value) <= 1e-3 * fabs(ahead[i] - value)))) {
      value = ahead[i] - value;
    }
    c->s.sign[i] = (signed char)((value > 0) - (value < 0));
  }
  return MECH_OK;
}

mech_status mech_begin_continuous(mech_instance *c) {
  double g[MECH_NG];
  int i;
  mech_status status;
  for (i = 0; i < MODEL_NG; i++) {
    if (c->s.sign[i] == 0) {
      return take_signs(c, NULL);
    }
  }
  status = events_at(c, c->s.t, c->s.x, g);
  return status;
}

/* Whether an event function has another sign than before. */
static int crossed(const mech_instance *c, const double *g, int i) {
  return c->s.sign[i] != 0 && g[i] * c->s.sign[i] < 0;
}

/* Applies events at (t, x). Where an importer stops right on a zero, it counts as crossed if the
 * function goes on to the other side; one that begins at a zero has crossed none. */
static mech_status apply_events(mech_instance *c, int zero_counts, int *changed) {
  double g[MECH_NG], ahead[MECH_NG] = {0};
  unsigned char fired[MECH_NG] = {0};
  signed char occurred[MECH_NG] = {0};
  int i, some = 0, zeros = 0;
  mech_status status = events_at(c, c->s.t, c->s.x, g);
  *changed = 0;
  if (status != MECH_OK) {
    return status;
  }
  for (i = 0; i < MODEL_NG; i++) {
    zeros |= zero_counts && g[i] == 0;
  }
  if (zeros && (status = events_ahead(c, ahead)) != MECH_OK) {
    return status;
  }
  for (i = 0; i < MODEL_NG; i++) {
    if (crossed(c, g, i) || (zero_counts && g[i] == 0 && ahead[i] * c->s.sign[i] < 0)) {
      occurred[i] = (signed char)-c->s.sign[i];
      c->s.sign[i] = occurred[i];
      fired[i] = 1;
      some = 1;
      if (c->noted != NULL) {
        c->noted(c, i);
      }
    }
  }
  if (some) {
    int result = MODEL_event(&c->s.model, occurred, c->s.t, c->s.x);
    if (result < 0) {
      return model_failed(c, MECH_FAILED, "The change of an event cannot be formed");
    }
    *changed = result & 1;
    c->s.terminate |= result >> 1;
  }
  if (some) {
    forget(c);
  }
  return *changed ? take_signs(c, fired) : MECH_OK;
}

mech_status mech_step_completed(mech_instance *c, int *event_needed) {
  double x[MECH_N];
  int i, result;
  memcpy(x, c->s.x, sizeof x);
  *event_needed = 0;
  result = MODEL_project(&c->s.model, c->s.t, x);
  if (result < 0) {
    return model_failed(c, MECH_FAILED, "The state cannot be moved onto the constraints");
  }
  MODEL_accepted(&c->s.model, c->s.t, c->s.x);
  for (i = 0; result > 0 && i < MODEL_NX; i++) {
    double size = fabs(x[i]) > 1 ? fabs(x[i]) : 1;
    *event_needed |= fabs(x[i] - c->s.x[i]) > c->s.rtol * size;
  }
  return MECH_OK;
}

/* Goes on behind a jump of the equations, which may change the state. */
static mech_status go_on(mech_instance *c, double t, int *changed) {
  int result = MODEL_go_on(&c->s.model, t, c->s.x);
  if (result < 0) {
    return model_failed(c, MECH_FAILED, "The change at a given time cannot be formed");
  }
  *changed |= result > 0;
  forget(c);
  return MECH_OK;
}

mech_status mech_update(mech_instance *c, int *changed) {
  int result;
  mech_status status = apply_events(c, 1, changed);
  if (status != MECH_OK) {
    return status;
  }
  if (mech_next_jump(c) <= c->s.t + 4 * DBL_EPSILON * fabs(c->s.t)) {
    if ((status = go_on(c, mech_next_jump(c), changed)) != MECH_OK) {
      return status;
    }
  }
  result = MODEL_project(&c->s.model, c->s.t, c->s.x);
  if (result < 0) {
    return model_failed(c, MECH_FAILED, "The state cannot be moved onto the constraints");
  }
  *changed |= result > 0;
  if (result > 0) {
    forget(c);
  }
  return MECH_OK;
}

double mech_next_jump(const mech_instance *c) {
  (void)c;
  return MODEL_next_jump(&c->s.model, c->s.t - 4 * DBL_EPSILON * fabs(c->s.t));
}

static mech_status step_failed(mech_instance *c, mech_step_result result) {
  const mech_method *a = &c->s.method;
  const char *why = MODEL_failure(&c->s.model);
  const char *stiff =
      a->stiff ? " The equations are stiff: stability, not accuracy, limits the steps of this"
                 " method. Build the unit with --integrator ode15s, or use Model Exchange with an"
                 " implicit method."
               : "";
  c->s.mode = MECH_STEP_FAILED;
  switch (result) {
    case MECH_STEP_NOT_FINITE:
      if (MODEL_LOST(&c->s.model)) {
        return mech_say(c, MECH_FAILED, "No step can be made at t = %.17g: %s.", a->t, why);
      }
      return mech_say(c, MECH_FAILED, "No step can be made at t = %.17g: %s%s", a->t,
                      why != NULL && why[0] != 0 ? why : "a value is not finite.", stiff);
    case MECH_STEP_TOO_SMALL:
      if (MODEL_LOST(&c->s.model)) {
        return mech_say(c, MECH_FAILED, "No step can be made at t = %.17g: %s.", a->t, why);
      }
      return mech_say(c, MECH_FAILED,
                      "The steps at t = %.17g are smaller than the arithmetic can hold.%s", a->t,
                      stiff);
    case MECH_STEP_TOO_ACCURATE:
      return mech_say(c, MECH_FAILED,
                      "The tolerance %g asks at t = %.17g for more digits than numbers have.",
                      a->rtol, a->t);
    default:
      return mech_say(c, MECH_FAILED, "%d steps in one communication step, at t = %.17g.%s",
                      (int)MOST_TRIES, a->t, stiff);
  }
}

/* Begins a step without history at the present place, its first step at most as long. */
static mech_status begin_integration(mech_instance *c, double first_step) {
  mech_method *a = &c->s.method;
  double longest, interval = c->s.stop_defined ? c->s.stop - c->s.start : MODEL_INTERVAL;
  mech_step_result result;
  a->rtol = c->s.rtol / SAFETY;
  if (a->rtol < FINEST) {
    a->rtol = c->s.rtol < FINEST ? c->s.rtol : FINEST;
  }
  a->atol = MODEL_ATOL * (a->rtol < MODEL_RTOL ? a->rtol / MODEL_RTOL : 1);
  longest = 0.1 * (interval > 0 ? interval : 1);
  longest = MODEL_LONGEST < longest ? MODEL_LONGEST : longest;
  if (!c->s.begun) {
    c->s.last_event = c->s.t;
    c->s.event_distance = HUGE_VAL;
    c->s.shrinking = c->s.chattering = 0;
  }
#ifdef MODEL_WATCHES
  mech_watch_begin(&c->s.watch);
#endif
  c->s.jump = mech_next_jump(c);
  a->stop = c->s.stop_defined && c->s.stop < c->s.jump ? c->s.stop : c->s.jump;
  a->longest = first_step < longest ? first_step : longest;
  result = mech_method_begin(a, &c->s.model, c->s.t, c->s.x);
  a->longest = longest;
  if (result != MECH_STEP_DONE) {
    return step_failed(c, result);
  }
  memcpy(c->s.x, a->x, sizeof c->s.x);
  c->s.begun = 1;
  c->s.waiting = 0;
  c->s.horizon = c->s.until = c->s.t;
#ifdef MODEL_WATCHES
  c->s.cut = c->s.joined = 0;
  c->s.first = 1;
#endif
  forget(c);
  return MECH_OK;
}

/* The solution at a place in the last step. That of the first one behind a restart need not begin in
 * the very state, and so may begin on the other side of a change of the equations: it is moved there,
 * by less towards the end of the step. */
static void solution_at(const mech_instance *c, double t, double *x) {
  const mech_method *a = &c->s.method;
  mech_method_interpolate(a, t, x);
#ifdef MODEL_WATCHES
  if (c->s.joined) {
    double share = (a->t - t) / (a->t - c->s.beginning);
    int i;
    for (i = 0; i < MODEL_NX; i++) {
      x[i] += share * c->s.offset[i];
    }
  }
#endif
}

#ifdef MODEL_WATCHES
/* Takes note of a step that has just been made. */
static void join_step(mech_instance *c) {
  double x[MECH_N];
  int i;
  c->s.joined = 0;
  if (c->s.first && c->s.t == c->s.method.previous) {
    c->s.beginning = c->s.t;
    mech_method_interpolate(&c->s.method, c->s.t, x);
    for (i = 0; i < MODEL_NX; i++) {
      c->s.offset[i] = c->s.x[i] - x[i];
    }
    c->s.joined = 1;
  }
}

/* The quantities that are watched at a place in the last step. */
static int watched_at(void *run, double t, double *quantities) {
  mech_instance *c = run;
  double x[MECH_N];
  solution_at(c, t, x);
  return MODEL_watched(&c->s.model, t, x, quantities) >= 0;
}

/* Tells once of each contact whose shapes are inside each other further than its law means. */
static void look_at_overlaps(mech_instance *c, double t) {
  double x[MECH_N], depth[2 * WATCH_ROOM(WATCH_OVERLAPS)];
  int i;
  mech_method_interpolate(&c->s.method, t, x);
  if (MODEL_overlaps(&c->s.model, t, x, depth) < 0) {
    return;
  }
  for (i = 0; i < WATCH_OVERLAPS; i++) {
    if (depth[2 * i + 1] > 0 && depth[2 * i] > depth[2 * i + 1] && !c->s.told_overlap[i]) {
      c->s.told_overlap[i] = 1;
      mech_say(c, MECH_WARNING,
               "At t = %.17g the shapes of contact \"%s\" are inside each other by more than %g m,"
               " where one is behind the other: the contact no longer pushes them apart the way"
               " they came. Make it stiffer, or begin where they are apart.",
               t, WATCH_CONTACT[i], depth[2 * i + 1]);
    }
  }
}

/* The same of the state at the end of the last step, moved along its derivative. */
static int watched_behind(void *run, double ahead, double *quantities) {
  mech_instance *c = run;
  const mech_method *a = &c->s.method;
  double x[MECH_N];
  int i;
  for (i = 0; i < MODEL_NX; i++) {
    x[i] = a->x[i] + ahead * c->dx[i];
  }
  return MODEL_watched(&c->s.model, a->t, x, quantities) >= 0;
}

/* After steps have become too short: goes on from the state behind a change of the equations that
 * lies within rounding, if there is one. */
static int goes_on_across(mech_instance *c) {
  const mech_method *a = &c->s.method;
  double ahead;
  int i;
  if (a->previous == a->t ||
      MODEL_derivatives(&c->s.model, a->t, a->x, c->dx) < 0) {
    return 0;
  }
  ahead = mech_watch_across(&c->s.watch, &c->watch_work, watched_behind, c, a->t);
  for (i = 0; i < MODEL_NX; i++) {
    c->s.x[i] = a->x[i] + ahead * c->dx[i];
  }
  c->s.t = a->t;
  forget(c);
  return ahead > 0;
}

/* Whether the solution slides along a jump of the equations and would take millions of steps. */
static int slides(const mech_instance *c) {
  double t = c->s.until, end = c->s.stop_defined ? c->s.stop : MODEL_START + MODEL_INTERVAL;
  return end - t > MOST_ROWS * (t - c->s.watch.sliding_since);
}

/* Ends the last step where something would go unseen in it. */
static void search_step(mech_instance *c) {
  const mech_method *a = &c->s.method;
  double seen;
  if (WATCH_OVERLAPS > 0) {
    look_at_overlaps(c, a->previous);
  }
  seen = mech_watch_search(&c->s.watch, &c->watch_work, watched_at, c, a->previous, a->t);
  c->s.cut = seen == seen;
  c->s.until = c->s.cut ? seen : a->t;
  if (c->s.watch.unsearched > 0 && !c->s.told_unsearched) {
    c->s.told_unsearched = 1;
    mech_say(c, MECH_WARNING,
             "From t = %.17g on steps are accepted in which something may have happened unseen: a"
             " choice in the formulas changes too often to be followed. Build the unit from a model"
             " with a maxStep.",
             a->previous);
  }
}

/* Whether the equations change inside the first step after a restart. That step knows them at its
 * two ends alone, the second beyond the change: it is taken again, no longer than up to there. */
static int ends_too_late(mech_instance *c) {
  int too_late = c->s.first && !c->s.bounded && c->s.cut && c->s.until < c->s.method.t;
  c->s.first = 0;
  c->s.bounded = too_late;
  return too_late;
}
#endif

/* Looks for the first change of sign between a place in the last step and where it ends. */
static mech_status look_for_events(mech_instance *c, double from) {
  double low = from, x[MECH_N], g[MECH_NG];
  int look, i;
  c->s.waiting = 0;
  c->s.horizon = c->s.until;
  for (look = 1; MODEL_NG > 0 && look <= LOOKS; look++) {
    double high = look == LOOKS ? c->s.until : from + (c->s.until - from) * look / LOOKS;
    int some = 0;
    solution_at(c, high, x);
    if (events_at(c, high, x, g) != MECH_OK) {
      return MECH_DISCARD;
    }
    for (i = 0; i < MODEL_NG; i++) {
      some |= crossed(c, g, i);
    }
    while (some) {
      double middle = low + 0.5 * (high - low);
      int before = 1;
      if (high - low <= 2 * DBL_EPSILON * fabs(high) || middle <= low || middle >= high) {
        c->s.waiting = 1;
        c->s.horizon = high;
        return MECH_OK;
      }
      solution_at(c, middle, x);
      if (events_at(c, middle, x, g) != MECH_OK) {
        return MECH_DISCARD;
      }
      for (i = 0; i < MODEL_NG; i++) {
        before &= !crossed(c, g, i);
      }
      if (before) {
        low = middle;
      } else {
        high = middle;
      }
    }
    low = high;
  }
  return MECH_OK;
}

/* Takes note of an event that changed the state; returns whether events accumulate: at distances
 * that shrink towards a point close ahead, as the bounces of a ball do, or that are round-off. */
static int accumulates(mech_state *s) {
  double distance = s->t - s->last_event;
  double ahead = distance * distance / (s->event_distance - distance);
  double size = fabs(s->t) > fabs(s->start) ? fabs(s->t) : fabs(s->start);
  s->shrinking = distance < s->event_distance ? s->shrinking + 1 : 0;
  s->chattering = distance <= CHATTER * size ? s->chattering + 1 : 0;
  s->last_event = s->t;
  s->event_distance = distance;
  return s->chattering >= IN_A_ROW ||
         (s->shrinking >= IN_A_ROW && ahead <= CLOSE_AHEAD * (s->t - s->start));
}

/* Brings the state to a place inside the last step. */
static void place(mech_instance *c, double t) {
  solution_at(c, t, c->s.x);
  c->s.t = t;
  forget(c);
}

/* Goes on behind the jump at this time. */
static mech_status pass_jump(mech_instance *c) {
  int changed = 0;
  mech_status status = go_on(c, c->s.jump, &changed);
  if (status != MECH_OK) {
    c->s.mode = MECH_STEP_FAILED;
    return status;
  }
  return begin_integration(c, HUGE_VAL);
}

mech_status mech_do_step(mech_instance *c, const char *function, double from, double size) {
  double end = from + size;
  long events = 0;
  double tries = c->s.method.tries;
  if (!finite_number(from) || !finite_number(size) || !(size >= 0) || !finite_number(end)) {
    return mech_say(c, MECH_FAILED, "%s: a step of %g from t = %g is none.", function, size, from);
  }
  if (fabs(from - c->s.t) > 1e-9 * (fabs(c->s.t) + size)) {
    return mech_say(c, MECH_FAILED, "%s: a step from t = %.17g, but the model is at t = %.17g.",
                    function, from, c->s.t);
  }
  if (c->s.terminate) {
    return mech_say(c, MECH_DISCARD, "%s: the run has ended at t = %.17g by an event.", function,
                    c->s.t);
  }
  if (c->s.stop_defined && end > c->s.stop) {
    if (end - c->s.stop > 1e-9 * (fabs(end) + size)) {
      return mech_say(c, MECH_FAILED, "%s: a step to t = %.17g passes the stop time %.17g.",
                      function, end, c->s.stop);
    }
    end = c->s.stop;
  }
  if (!c->s.begun) {
    mech_status status = begin_integration(c, HUGE_VAL);
    if (status != MECH_OK) {
      return status;
    }
  }
  while (c->s.t < end) {
    /* A jump at the end, but for rounding, belongs to the next step. */
    int ends_there = !c->s.waiting && c->s.horizon == c->s.jump &&
                     end - c->s.jump <= 4 * DBL_EPSILON * fabs(end);
    if (ends_there || (end <= c->s.horizon && !(c->s.waiting && end == c->s.horizon))) {
      place(c, end);
    } else if (c->s.waiting) {
      double te = c->s.horizon;
      int changed;
      mech_status status;
      place(c, te);
      if ((status = apply_events(c, 0, &changed)) != MECH_OK) {
        c->s.mode = MECH_STEP_FAILED;
        return status == MECH_DISCARD ? MECH_FAILED : status;
      }
      if (++events > MOST_EVENTS) {
        c->s.mode = MECH_STEP_FAILED;
        return mech_say(c, MECH_FAILED,
                        "Events follow each other without end at t = %.17g: %d in one step. Let an"
                        " event end the run, or give a jump that leaves the zero.",
                        te, (int)MOST_EVENTS);
      }
      if (changed && !c->s.terminate && accumulates(&c->s)) {
        c->s.mode = MECH_STEP_FAILED;
        return mech_say(c, MECH_FAILED,
                        "The intervals between events become ever shorter at t = %.17g. End the run"
                        " before, or stop the changes of the state: a bounce below a certain speed.",
                        te);
      }
      if (changed && (status = begin_integration(c, HUGE_VAL)) != MECH_OK) {
        return status;
      }
      if (c->s.terminate) {
        return MECH_DISCARD;
      }
      if (!changed && (status = look_for_events(c, te)) != MECH_OK) {
        c->s.mode = MECH_STEP_FAILED;
        return MECH_FAILED;
      }
    } else if (c->s.horizon == c->s.jump) {
      mech_status status;
      place(c, c->s.jump);
      if ((status = pass_jump(c)) != MECH_OK) {
        return status;
      }
#ifdef MODEL_WATCHES
    } else if (c->s.cut && c->s.horizon == c->s.until) {
      mech_status status;
      place(c, c->s.until);
      status = begin_integration(c, c->s.watch.longest_first_step);
      if (status != MECH_OK) {
        return status;
      }
#endif
    } else {
      mech_step_result result;
      long left = (long)(MOST_TRIES - (c->s.method.tries - tries));
      result = mech_method_step(&c->s.method, &c->s.model, left);
#ifdef MODEL_WATCHES
      if (result == MECH_STEP_TOO_SMALL && goes_on_across(c)) {
        mech_status status = begin_integration(c, HUGE_VAL);
        if (status != MECH_OK) {
          return status;
        }
        continue;
      }
#endif
      if (result != MECH_STEP_DONE) {
        return step_failed(c, result);
      }
      MODEL_accepted(&c->s.model, c->s.method.t, c->s.method.x);
      c->s.until = c->s.method.t;
#ifdef MODEL_WATCHES
      join_step(c);
      search_step(c);
      if (ends_too_late(c)) {
        mech_status status = begin_integration(c, c->s.until - c->s.t);
        if (status != MECH_OK) {
          return status;
        }
        continue;
      }
      if (slides(c)) {
        c->s.mode = MECH_STEP_FAILED;
        return mech_say(c, MECH_FAILED,
                        "At t = %.17g the solution slides along a jump of its formulas: steps cross"
                        " it again and again, and the run would take millions of them. Give the"
                        " jump a slope, such as tanh in place of signum.",
                        c->s.until);
      }
#endif
      if (c->s.method.stiff && !c->s.told_stiff) {
        c->s.told_stiff = 1;
        mech_say(c, MECH_WARNING,
                 "From t = %.17g stability, not accuracy, limits the steps: the equations are"
                 " stiff for this method.",
                 c->s.method.t);
      }
      if (look_for_events(c, c->s.method.previous) != MECH_OK) {
        c->s.mode = MECH_STEP_FAILED;
        return MECH_FAILED;
      }
    }
  }
  return MECH_OK;
}

/* Values of derivatives, outputs and indicators after a small change of the knowns. */
static mech_status shifted(mech_instance *c, const char *function, const unsigned *unknown,
                           size_t unknowns, const unsigned *known, size_t knowns,
                           const double *seed, double e, double *values) {
  mech_status status = MECH_OK;
  size_t i;
  double x[MECH_N], t = c->s.t;
  MODEL_T model = c->s.model;
  memcpy(x, c->s.x, sizeof x);
  for (i = 0; i < knowns; i++) {
    unsigned r = known[i];
    if (r == MECH_TIME) {
      c->s.t += e * seed[i];
    } else if (r >= MECH_STATE && r < MECH_DERIVATIVE) {
      c->s.x[r - MECH_STATE] += e * seed[i];
#if MODEL_NP > 0
    } else if (r >= MECH_PARAMETER && r < MECH_INPUT) {
      MODEL_P(&c->s.model)[r - MECH_PARAMETER] += e * seed[i];
#endif
#if MODEL_NU > 0
    } else if (r >= MECH_INPUT && r < MECH_OUTPUT) {
      MODEL_U(&c->s.model)[r - MECH_INPUT] += e * seed[i];
#endif
    } else {
      status = mech_say(c, MECH_FAILED, "%s: %u is not the reference of a known.", function, r);
      break;
    }
  }
  forget(c);
  for (i = 0; status == MECH_OK && i < unknowns; i++) {
    if (unknown[i] < MECH_STATE || (unknown[i] >= MECH_PARAMETER && unknown[i] < MECH_OUTPUT)) {
      status = mech_say(c, MECH_FAILED, "%s: %u is not the reference of an unknown.", function,
                        unknown[i]);
    } else {
      status = mech_get(c, function, unknown[i], &values[i]);
    }
  }
  c->s.model = model;
  c->s.t = t;
  memcpy(c->s.x, x, sizeof x);
  forget(c);
  return status;
}

mech_status mech_directional(mech_instance *c, const char *function, const unsigned *unknown,
                             size_t unknowns, const unsigned *known, size_t knowns,
                             const double *seed, size_t seeds, double *sensitivity,
                             size_t sensitivities) {
  double largest = 0, size = 0, e;
  size_t i;
  mech_status status = know_start(c);
  int exact = 1;
  if (status != MECH_OK) {
    return status;
  }
  if (seeds != knowns || sensitivities != unknowns ||
      (unknowns > 0 && (unknown == NULL || sensitivity == NULL)) ||
      (knowns > 0 && (known == NULL || seed == NULL))) {
    return mech_say(c, MECH_FAILED, "%s: wrong number of seeds or sensitivities.", function);
  }
  for (i = 0; i < knowns; i++) {
    if (!finite_number(seed[i])) {
      return mech_say(c, MECH_FAILED, "%s: a seed is not finite.", function);
    }
    largest = fabs(seed[i]) > largest ? fabs(seed[i]) : largest;
    exact &= (known[i] >= MECH_STATE && known[i] < MECH_DERIVATIVE) ||
             (known[i] >= MECH_PARAMETER && known[i] < MECH_OUTPUT);
  }
  for (i = 0; i < unknowns; i++) {
    exact &= unknown[i] >= MECH_DERIVATIVE && unknown[i] < MECH_PARAMETER;
  }
  if (exact) {
    double seeds[MECH_N + MODEL_NP + MODEL_NU] = {0}, rates[MECH_N];
    for (i = 0; i < knowns; i++) {
      unsigned r = known[i];
      seeds[r < MECH_DERIVATIVE ? r - MECH_STATE : MODEL_NX + (r - MECH_PARAMETER)] += seed[i];
    }
    if (MODEL_directional(&c->s.model, c->s.t, c->s.x, seeds, rates) >= 0) {
      for (i = 0; i < unknowns; i++) {
        sensitivity[i] = rates[unknown[i] - MECH_DERIVATIVE];
      }
      return MECH_OK;
    }
  }
  for (i = 0; i < MODEL_NX; i++) {
    size = fabs(c->s.x[i]) > size ? fabs(c->s.x[i]) : size;
  }
  e = 6e-6 * (size > 1 ? size : 1) / (largest > 0 ? largest : 1);
  status = shifted(c, function, unknown, unknowns, known, knowns, seed, e, sensitivity);
  for (i = 0; status == MECH_OK && i < unknowns; i++) {
    double above = sensitivity[i], below;
    status = shifted(c, function, &unknown[i], 1, known, knowns, seed, -e, &below);
    sensitivity[i] = (above - below) / (2 * e);
  }
  return status;
}

mech_status mech_save(mech_instance *c, const char *function, void **state) {
  saved_state *saved;
  if (state == NULL) {
    return mech_say(c, MECH_FAILED, "%s: no place for the state.", function);
  }
  saved = *state;
  if (saved == NULL) {
    saved = calloc(1, sizeof *saved);
    if (saved == NULL) {
      return mech_say(c, MECH_FAILED, "%s: no memory.", function);
    }
    saved->magic = SAVED;
  } else if (saved->magic != SAVED) {
    return mech_say(c, MECH_FAILED, "%s: not a state of this model.", function);
  }
  saved->s = c->s;
  *state = saved;
  return MECH_OK;
}

mech_status mech_restore(mech_instance *c, const char *function, const void *state) {
  const saved_state *saved = state;
  if (saved == NULL || saved->magic != SAVED) {
    return mech_say(c, MECH_FAILED, "%s: not a state of this model.", function);
  }
  c->s = saved->s;
  forget(c);
  return MECH_OK;
}

mech_status mech_discard(mech_instance *c, const char *function, void **state) {
  saved_state *saved = state == NULL ? NULL : *state;
  if (saved == NULL) {
    return MECH_OK;
  }
  if (saved->magic != SAVED) {
    return mech_say(c, MECH_FAILED, "%s: not a state of this model.", function);
  }
  saved->magic = 0;
  free(saved);
  *state = NULL;
  return MECH_OK;
}

/* Serialised: the token of the model, then the bytes of the state. */
enum { TOKEN = sizeof MODEL_TOKEN };

size_t mech_saved_size(void) { return TOKEN + sizeof(mech_state); }

mech_status mech_serialize(mech_instance *c, const char *function, const void *state, void *bytes,
                           size_t size) {
  const saved_state *saved = state;
  if (saved == NULL || saved->magic != SAVED || bytes == NULL || size < mech_saved_size()) {
    return mech_say(c, MECH_FAILED, "%s: not a state of this model, or too little room.", function);
  }
  memcpy(bytes, MODEL_TOKEN, TOKEN);
  memcpy((char *)bytes + TOKEN, &saved->s, sizeof saved->s);
  return MECH_OK;
}

mech_status mech_deserialize(mech_instance *c, const char *function, const void *bytes, size_t size,
                             void **state) {
  saved_state *saved;
  if (state == NULL || bytes == NULL || size != mech_saved_size() ||
      memcmp(bytes, MODEL_TOKEN, TOKEN) != 0) {
    return mech_say(c, MECH_FAILED, "%s: the bytes are not a state of this model.", function);
  }
  saved = calloc(1, sizeof *saved);
  if (saved == NULL) {
    return mech_say(c, MECH_FAILED, "%s: no memory.", function);
  }
  saved->magic = SAVED;
  memcpy(&saved->s, (const char *)bytes + TOKEN, sizeof saved->s);
  *state = saved;
  return MECH_OK;
}
