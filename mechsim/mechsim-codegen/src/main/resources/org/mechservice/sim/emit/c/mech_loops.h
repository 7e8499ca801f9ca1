/*
 * Closed loops: M v' + b + J' lambda = tau with Phi(q, t) = 0. Accelerations by the augmented
 * Lagrangian of index 1 (Garcia de Jalon and Bayo 1994, ch. 5),
 *
 *   (M + J' alpha J) a = tau - b - J' (alpha c + lambda),   c = gamma + 2 Omega mu Phi' + Omega^2 Phi,
 *   lambda <- lambda + alpha (J a + c),
 *
 * iterated until J a + c is round-off; positions and velocities are projected onto the loops in the
 * metric of M. Equations may be redundant. The operations are those of the Java solver in their
 * order, so that the bits are the same.
 */
#ifndef MECH_LOOPS_H
#define MECH_LOOPS_H

/* What does not change: sizes, layout and programs of a model. */
typedef struct {
  /* Positions, velocities, further states, unwrapped angles, equations, pattern of J. */
  int nq, nv, ns, na, m, pattern;
  /* J by the velocities: where each row begins (m + 1 numbers), column of each element. */
  const int *start, *column;
  /* For each position the velocity that is its rate, or -1; for each velocity its position. */
  const int *velocity_of, *position_of;
  /* Sets of Euler parameters: first of four positions, first of three velocities. */
  int balls;
  const int *ball_q, *ball_v;
  /* Unit of each velocity; size and rounding error of places of each equation. */
  const double *unit, *size, *place_rounding;
  double stiffness, frequency, damping;
  /* Programs from t and [q; v; s; angles]; equations returns REGULAR or a force without value. */
  int regular;
  void (*loops)(void *model, double t, const double *y, double *terms);
  int (*equations)(void *model, double t, const double *y, double *terms);
  void (*mass)(void *model, double t, const double *y, double *terms);
  void (*further)(void *model, double t, const double *y, double *rates);
  void (*angles)(void *model, double t, const double *y, double *angles);
  /* Derivatives along a direction, given by the rates of states, of time and of parameters: of
   * M a + b + J' lambda and J a + c at given a and lambda, and of the further rates. */
  void (*along)(void *model, double t, const double *y, const double *given, const double *seed,
                double *rates);
  void (*further_along)(void *model, double t, const double *y, const double *given,
                        const double *seed, double *rates);
} mech_loops;

/* Numbers of a workspace of m equations in n velocities with a pattern of e elements, for k states
 * and twice the number of unwrapped angles. */
#define MECH_LOOPS_WORK(m, n, e, k) \
  (9 * (m) + 2 * (m) * (n) + 2 * ((m) + (n)) + 10 * (n) + 4 * (n) * (n) + 2 * (e) + (k))

/* dx/dt; returns 0, or -1 with *failure set to a force without value or, counted from 1000000, a
 * velocity without inertia. work begins with the unwrapped angles. */
int mech_loops_derivatives(const mech_loops *l, void *model, double *work, double t,
                           const double *x, double *dx, int *failure);
/* Derivative of dx/dt along a direction, on the loops; again: at the state of the last call, whose
 * factors are taken. Returns as mech_loops_derivatives. */
int mech_loops_along(const mech_loops *l, void *model, double *work, double t, const double *x,
                     const double *seed, int again, double *dx, int *failure);
/* Moves a state onto the loops after a step; returns 1, or -1 if it is too far off. */
int mech_loops_project(const mech_loops *l, void *model, double *work, double t, double *x,
                       int *failure);
/* Closes the loops after a jump or at the start, first with the coordinates held that are marked
 * in set (one mark per position and velocity; NULL for none). Returns 1, or -1. */
int mech_loops_close(const mech_loops *l, void *model, double *work, double t, double *x,
                     const unsigned char *set, int *failure);
/* Computes all coordinates from those that are given, one mark per velocity (a ball's three alike),
 * by Newton's method from the values that the others have in x. *pivot is the smallest pivot of the
 * equations for them relative to the largest, 0 where the given ones do not determine them. Returns
 * 1, or -1. */
int mech_loops_complete(const mech_loops *l, void *model, double *work, double t, double *x,
                        const unsigned char *given, double *pivot);
/* Marks the velocities that determine all others best at a state; returns the number of others. */
int mech_loops_choose(const mech_loops *l, void *model, double *work, double t, const double *x,
                      unsigned char *given);
/* Records that a step to a state was accepted: unwrapped angles follow it. */
void mech_loops_accepted(const mech_loops *l, void *model, double *work, double t, const double *x);
/* [q; v; s; angles], valid until the next call. */
const double *mech_loops_state(const mech_loops *l, double *work, const double *x);

#endif
