/* An instance of the model as both versions of FMI see it: variables by value reference, events,
 * projection, Co-Simulation, saved states. The files mech_fmi2.c and mech_fmi3.c are the two
 * interfaces.
 *
 * Value references: 0 time; then in this order the states, their derivatives, the tunable
 * parameters, the inputs, the outputs and the event indicators. */
#ifndef MECH_FMU_H
#define MECH_FMU_H

#include <stddef.h>

#include "mech_adams.h"
#include "mech_backward.h"
#ifdef MODEL_WATCHES
#include "mech_watch.h"
#endif

/* The method of Co-Simulation: for stiff models the backward formulas, else the Adams method. */
#if MODEL_STIFF
typedef mech_backward mech_method;
#define mech_method_begin mech_backward_begin
#define mech_method_step mech_backward_step
#define mech_method_interpolate mech_backward_interpolate
#else
typedef mech_adams mech_method;
#define mech_method_begin mech_adams_begin
#define mech_method_step mech_adams_step
#define mech_method_interpolate mech_adams_interpolate
#endif

enum {
  MECH_TIME = 0,
  MECH_STATE = 1,
  MECH_DERIVATIVE = MECH_STATE + MODEL_NX,
  MECH_PARAMETER = MECH_DERIVATIVE + MODEL_NX,
  MECH_INPUT = MECH_PARAMETER + MODEL_NP,
  MECH_OUTPUT = MECH_INPUT + MODEL_NU,
  MECH_INDICATOR = MECH_OUTPUT + MODEL_NY,
  MECH_END = MECH_INDICATOR + MODEL_NG
};

#define MECH_NY (MODEL_NY > 0 ? MODEL_NY : 1)
#define MECH_NG (MODEL_NG > 0 ? MODEL_NG : 1)

/* Modes of an instance; a bit each, so that a function names all those it may be called in. */
typedef enum {
  MECH_INSTANTIATED = 1,
  MECH_INITIALIZATION = 2,
  MECH_EVENT = 4,
  MECH_CONTINUOUS = 8,
  MECH_STEPPING = 16,
  MECH_STEP_FAILED = 32,
  MECH_TERMINATED = 64,
  MECH_ERROR = 128
} mech_mode;

/* Results: the values of fmi2Status and fmi3Status. */
typedef enum { MECH_OK, MECH_WARNING, MECH_DISCARD, MECH_FAILED, MECH_FATAL } mech_status;

/* All that changes; saved, restored and serialised by copying. */
typedef struct {
  MODEL_T model;
  mech_mode mode;
  double t, start, stop, rtol;
  int stop_defined;
  double x[MECH_N];
  /* States set by the importer before the run begins; the others follow from the parameters. */
  unsigned char set[MECH_N];
  int start_known;
  /* Sign of each event function: +1, -1, 0 not known. */
  signed char sign[MECH_NG];
  int terminate;
  /* Co-Simulation: the polynomial of the last step holds until the horizon; an event may wait
   * there. */
  mech_method method;
  int begun, waiting, told_stiff;
  /* Where the last step ends: before its end, if something would go unseen in it. */
  double until;
#ifdef MODEL_WATCHES
  /* Whether the last step is cut there, is the first behind a restart, and is one taken again. */
  int cut, first, bounded;
  /* Whether the last step is the first one behind a restart, where that was, and by what its
   * solution is moved there. */
  int joined;
  double beginning, offset[MECH_N];
  mech_watch watch;
  int told_unsearched;
  unsigned char told_overlap[WATCH_ROOM(WATCH_OVERLAPS)];
#endif
  /* The next time at which the equations jump. */
  double horizon, jump;
  /* The last event that changed the state, its distance from the one before, and how many in a row
   * came ever closer, or at once. */
  double last_event, event_distance;
  int shrinking, chattering;
} mech_state;

typedef struct mech_instance mech_instance;

struct mech_instance {
  unsigned long magic;
  int co_simulation, logging;
  char *name;
  /* Writes a message: status, category, text. */
  void (*log)(const mech_instance *, mech_status, const char *, const char *);
  void *logger, *environment;
  /* Told of each event as it happens, by its number; NULL if nobody asks. */
  void (*noted)(const mech_instance *, int);
  void (*release)(void *);
  mech_state s;
#ifdef MODEL_WATCHES
  mech_watch_work watch_work;
#endif
  /* Values at (t, x), formed when asked for. */
  int derivatives_known, outputs_known;
  double dx[MECH_N], y[MECH_NY];
};

/* Writes a message in the manner of printf. */
mech_status mech_say(const mech_instance *, mech_status, const char *format, ...);
/* Whether c is an instance that may call the function now; says why not. */
int mech_may(mech_instance *c, const char *function, int modes);

mech_instance *mech_create(void *(*allocate)(size_t, size_t), void (*release)(void *),
                           const char *name);
void mech_free(mech_instance *c);
void mech_reset(mech_instance *c);

mech_status mech_set_up(mech_instance *c, int tolerance_defined, double tolerance, double start,
                        int stop_defined, double stop);
/* Leaves initialisation: the start state stands, on the constraints. */
mech_status mech_initialised(mech_instance *c);

mech_status mech_get(mech_instance *c, const char *function, unsigned reference, double *value);
mech_status mech_set(mech_instance *c, const char *function, unsigned reference, double value);
mech_status mech_set_time(mech_instance *c, const char *function, double t);
mech_status mech_set_states(mech_instance *c, const char *function, const double *x, size_t n);
mech_status mech_get_states(mech_instance *c, const char *function, double *x, size_t n);
mech_status mech_get_derivatives(mech_instance *c, const char *function, double *dx, size_t n);
mech_status mech_get_indicators(mech_instance *c, const char *function, double *g, size_t n);

/* Whether the state has left the constraints by more than the tolerance. */
mech_status mech_step_completed(mech_instance *c, int *event_needed);
/* Applies the events whose sign changed and goes on behind a jump at this time, then projects. */
mech_status mech_update(mech_instance *c, int *changed);
/* The next time at which the equations jump; HUGE_VAL if there is none. */
double mech_next_jump(const mech_instance *c);
/* Takes the signs of the event functions for those of the continuous phase that begins. */
mech_status mech_begin_continuous(mech_instance *c);

/* Integrates over a communication step; MECH_DISCARD if an event ends the run in it. */
mech_status mech_do_step(mech_instance *c, const char *function, double from, double size);

/* J v of the unknowns by the knowns. */
mech_status mech_directional(mech_instance *c, const char *function, const unsigned *unknown,
                             size_t unknowns, const unsigned *known, size_t knowns,
                             const double *seed, size_t seeds, double *sensitivity,
                             size_t sensitivities);

/* Saved states. */
mech_status mech_save(mech_instance *c, const char *function, void **state);
mech_status mech_restore(mech_instance *c, const char *function, const void *state);
mech_status mech_discard(mech_instance *c, const char *function, void **state);
size_t mech_saved_size(void);
mech_status mech_serialize(mech_instance *c, const char *function, const void *state, void *bytes,
                           size_t size);
mech_status mech_deserialize(mech_instance *c, const char *function, const void *bytes, size_t size,
                             void **state);

#endif
