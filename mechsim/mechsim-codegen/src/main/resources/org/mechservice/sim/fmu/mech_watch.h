/* Searches an accepted step for what its ends do not show: a choice in the formulas that is taken
 * otherwise inside the step, or a formula that is larger there than its values at the ends tell.
 * The same decisions as in a run of Java, from the same tape of formulas; docs/theory/events.md
 * describes them.
 *
 * The formulas are evaluated on the interpolated solution. Everything lies in the structures: no
 * allocation, no globals. */
#ifndef MECH_WATCH_H
#define MECH_WATCH_H

#include "mech_watch_tape.h"

typedef enum {
  WATCH_ADD,
  WATCH_SUBTRACT,
  WATCH_MULTIPLY,
  WATCH_DIVIDE,
  WATCH_NEGATE,
  WATCH_SQUARE,
  WATCH_SQRT,
  WATCH_ABS,
  WATCH_SIN,
  WATCH_COS,
  WATCH_ASIN,
  WATCH_ACOS,
  WATCH_ATAN,
  WATCH_ATAN2,
  WATCH_EXP,
  WATCH_LOG,
  WATCH_MIN,
  WATCH_MAX,
  WATCH_SINH,
  WATCH_COSH,
  WATCH_TANH,
  WATCH_SIGNUM,
  WATCH_HYPOT,
  WATCH_FLOOR,
  WATCH_STEP,
  WATCH_SMOOTH_STEP,
  WATCH_WHERE,
  WATCH_ELSEWHERE,
  WATCH_POWER,
  WATCH_CURVE,
  WATCH_MAP
} mech_watch_operation;

/* A step of the tape: slot written, slots read (one operand is both), number of its table, and of
 * the choice of the state that it is, -1 if it is none. */
typedef struct {
  mech_watch_operation operation;
  int target, first, second, table, choice;
} mech_watch_step;

/* A table: whether it has straight lines and no values outside, its numbers of points along both
 * arguments, and where its numbers begin. Those of a curve are its points, then origin, c0, c1, c2
 * and c3 of each interval and of both sides; those of a map are the points along both arguments,
 * the origins of cells along both, and 16 coefficients of each cell. */
typedef struct {
  int straight, bounded, points, further_points, at;
} mech_watch_table;

/* A choice: its step, and whether its piece alone counts, as for the sign of an event function. */
typedef struct {
  int step, sign;
} mech_watch_choice;

extern const mech_watch_step WATCH_STEP_OF[];
extern const mech_watch_table WATCH_TABLE_OF[];
extern const mech_watch_choice WATCH_CHOICE_OF[];
extern const double WATCH_NUMBER[], WATCH_INITIAL[];
/* Slots of the leaves and of the formulas. */
extern const int WATCH_LEAF_SLOT[], WATCH_RESULT_SLOT[];
/* Ends of the groups of rates, and the rates, as places among the quantities. */
extern const int WATCH_TURN_END[], WATCH_TURN_RATE[];
/* Names of the contacts whose overlap is looked at. */
extern const char *const WATCH_CONTACT[];

#define WATCH_ROOM(n) ((n) > 0 ? (n) : 1)

enum { WATCH_DEPTH = 44 };

/* What later searches depend on; saved by copying. */
typedef struct {
  double before[WATCH_ROOM(WATCH_FORMULAS)], largest[WATCH_ROOM(WATCH_FORMULAS)];
  double sizes[WATCH_ROOM(WATCH_CHOICES)];
  double since_change[WATCH_ROOM(WATCH_CHOICES)], close_changes[WATCH_ROOM(WATCH_CHOICES)];
  /* Of each choice, the piece it took before its last change. */
  double left[WATCH_ROOM(WATCH_CHOICES)];
  /* Of each choice in the row of steps: largest distance from its boundary, and changes. */
  double farthest[WATCH_ROOM(WATCH_CHOICES)], changes[WATCH_ROOM(WATCH_CHOICES)];
  /* Steps in the row, and when it began. */
  double steps_in_row, row_began;
  double box_low[WATCH_ROOM(WATCH_LEAVES)], box_high[WATCH_ROOM(WATCH_LEAVES)];
  /* Steps for which no box is sought, and how many are left of them. */
  double pause, pause_left;
  /* Longest first step from where the last search has ended a step; HUGE_VAL: any. */
  double longest_first_step;
  /* When the row of steps began that ended with the last at one jump, else NaN. */
  double sliding_since;
  /* Steps accepted without being searched to their ends. */
  double unsearched;
  /* Whether there are values before, and whether nothing changes its form in the box. */
  int begun, boxed;
} mech_watch;

/* The solution in a step: writes the quantities at a time; returns 0 where there is none. */
typedef int mech_watch_path(void *run, double t, double *quantities);

/* Scratch of a search. A point is the values of all slots. */
typedef struct {
  mech_watch *kept;
  mech_watch_path *path;
  void *run;
  double here[WATCH_ROOM(WATCH_QUANTITIES)];
  double from[WATCH_SLOTS], middle[WATCH_SLOTS], to[WATCH_SLOTS], moving[WATCH_SLOTS];
  double narrowing[WATCH_SLOTS], between[WATCH_DEPTH + 1][WATCH_SLOTS];
  /* Bounds of the slots, those that matter, and those whose way is no parabola. */
  double low[WATCH_SLOTS], high[WATCH_SLOTS];
  unsigned char matters[WATCH_SLOTS], rough[WATCH_SLOTS];
  int undecided[WATCH_ROOM(WATCH_CHOICES)], undecided_count, even;
  double pieces_from[WATCH_ROOM(WATCH_CHOICES)], pieces_to[WATCH_ROOM(WATCH_CHOICES)];
  double first_seen[WATCH_ROOM(WATCH_CHOICES)];
  double value_from[WATCH_ROOM(WATCH_FORMULAS)], value_to[WATCH_ROOM(WATCH_FORMULAS)];
  /* The fastest turn at the ends of the step, rad/s. */
  double turning, begin, finish;
  long evaluations, allowed;
  int looking, hidden, gave_up;
  /* Whether the points hold the constants, and down to which depth those between do. */
  int ready, depths, middle_known;
} mech_watch_work;

/* Makes all ready for a run. */
void mech_watch_init(mech_watch *kept);
/* Begins at a state without history. */
void mech_watch_begin(mech_watch *kept);
/* Searches a step; returns where it has to end, behind from and at most to; NaN if it may stand. */
double mech_watch_search(mech_watch *kept, mech_watch_work *work, mech_watch_path *path, void *run,
                         double from, double to);
/* How far behind t the next change of a choice that matters lies, if that is within rounding and a
 * state there is behind it by more than rounding; else 0. The path gives the quantities of the state
 * at t, moved along its derivative for a time. */
double mech_watch_across(mech_watch *kept, mech_watch_work *work, mech_watch_path *path, void *run,
                         double t);

#endif
