package org.mechservice.solver.closure.model;

/**
 * Follows the positions of closed loops along a path from one state to another, in parts short
 * enough that Newton's method cannot leave the assembly that the motion is in. Both the integration
 * in independent coordinates and the kinematic analysis find their branch with it.
 *
 * <p>The path is straight in time and in the given coordinates; the others follow. A part is
 * accepted from one of two guesses:
 *
 * <ul>
 *   <li>the straight continuation, by the rates at first and by the secant then, if all its
 *       corrections together are at most a quarter of the predicted move, the estimate of the
 *       prediction's own error;
 *   <li>where that finds nothing, the last positions, if each correction is at most a quarter of
 *       the one before: then the solution is the only one within reach (Deuflhard 2011, Newton
 *       Methods for Nonlinear Problems, theorem 2.1 and section 5.1). This one passes corners of
 *       drives.
 * </ul>
 *
 * <p>Positions a turn apart close the loops alike. A part in which something moves far is therefore
 * accepted only if the straight continuation needs no correction.
 *
 * <p>The sign of the determinant of the equations must not change: it is zero in a change point, in
 * which two branches cross. A free motion goes straight through it, if the loops close in the
 * change point as far as rounding tells. Where they do not close, the branches only come near to
 * each other, and the positions straight ahead belong to the other one. Workspace of one thread;
 * nothing allocates after construction.
 */
public final class LoopContinuation {
  /** The equations of the loops, solved for the positions that are not given. */
  public interface Equations {
    /** Returns the number of positions. */
    int positionCount();

    /** Returns whether a position is given along the path. */
    boolean isGiven(int position);

    /** Returns what a position is divided by to be compared with others, 1 or m. */
    double unit(int position);

    /**
     * Corrects the positions that are not given by one iteration of Newton's method.
     *
     * @param q positions; overwritten
     * @return the largest change in its unit; NaN if the equations are singular or have no value
     */
    double correct(double t, double[] q);

    /** Returns the sign of the determinant of the equations in the last correction. */
    int orientation();

    /**
     * Returns whether the motion goes straight through a change point: it is free, and the loops
     * close there as far as rounding tells.
     *
     * @param q positions halfway between the last ones and those last corrected, which are on
     *     either side of the change point; not modified
     */
    boolean crosses(double t, double[] q);
  }

  /** Why a path was not followed to its end. */
  public enum End {
    /** It was followed to its end. */
    REACHED,
    /** Positions exist beyond, but the branches cross there. */
    CHANGE_POINT,
    /** No positions beyond continue those before. */
    LIMIT
  }

  /** Correction at which Newton's method has converged: the next would be below round-off. */
  public static final double CONVERGED = 1e-8;

  /** Largest ratio of a correction to the one before, and of a correction to a predicted move. */
  private static final double CONTRACTION = 0.25;

  private static final int ITERATIONS = 12;

  /**
   * Longest predicted move in a part that needs corrections, in the units of positions. The largest
   * error accepted of a prediction is then a fiftieth of a turn.
   */
  private static final double FARTHEST = 0.5;

  /** Shortest part of a path. */
  private static final double SHORTEST = 1e-12;

  /**
   * Shortest move, in the units of positions, in which a path is followed, and longest in which it
   * may cross a change point. Positions this far from one carry an error of 1e-9, for rounding
   * closes loops to 1e-15 and the smallest pivot is as large as the distance.
   */
  private static final double CLOSEST = 1e-6;

  private final Equations equations;
  private final double[] last;
  private final double[] rate;
  private final double[] trial;
  private final double[] middle;
  private double reached;
  private double timeReached;
  private boolean crossed;

  /** Whether the part tried ends where the determinant has the other sign, and its largest move. */
  private boolean turned;

  private double tried;
  private int orientation;

  public LoopContinuation(Equations equations) {
    this.equations = equations;
    int n = equations.positionCount();
    last = new double[n];
    rate = new double[n];
    trial = new double[n];
    middle = new double[n];
  }

  /**
   * Follows the positions.
   *
   * @param t0 time at the beginning, s
   * @param from positions there, which close the loops; not modified
   * @param rates of the positions there, 1/s; not modified
   * @param sign sign of the determinant there
   * @param t1 time at the end, s
   * @param to given positions at the end; the others are overwritten if it is reached
   */
  public End follow(double t0, double[] from, double[] rates, int sign, double t1, double[] to) {
    int n = last.length;
    for (int i = 0; i < n; i++) {
      last[i] = from[i];
      rate[i] = rates[i] * (t1 - t0);
    }
    orientation = sign;
    crossed = false;
    reached = 0;
    timeReached = t0;
    double part = 1;
    while (reached < 1) {
      double end = reached + part >= 1 ? 1 : reached + part;
      double t = end == 1 ? t1 : t0 + end * (t1 - t0);
      turned = false;
      tried = 0;
      if (continues(end, t, from, to) || (!turned && begins(end, t, from, to))) {
        for (int i = 0; i < n; i++) {
          rate[i] = (trial[i] - last[i]) / (end - reached);
          last[i] = trial[i];
        }
        reached = end;
        timeReached = t;
        part *= 2;
      } else {
        part /= 2;
        if (part < SHORTEST || tried <= CLOSEST) {
          return turned ? End.CHANGE_POINT : End.LIMIT;
        }
      }
    }
    System.arraycopy(last, 0, to, 0, n);
    return End.REACHED;
  }

  /** Tries a part from the continuation of the secant. */
  private boolean continues(double end, double t, double[] from, double[] to) {
    double move = place(end, end - reached, from, to);
    tried = move;
    double largest = move <= FARTHEST ? Math.max(CONTRACTION * move, CONVERGED) : CONVERGED;
    if (!close(t, 1, largest)) {
      return false;
    }
    if (equations.orientation() == orientation) {
      return true;
    }
    turned = true;
    if (move <= CLOSEST && crosses(t)) {
      orientation = -orientation;
      crossed = true;
      return true;
    }
    return false;
  }

  private boolean crosses(double t) {
    for (int i = 0; i < middle.length; i++) {
      middle[i] = 0.5 * (last[i] + trial[i]);
    }
    return equations.crosses(0.5 * (timeReached + t), middle);
  }

  /** Tries a part from the last positions. */
  private boolean begins(double end, double t, double[] from, double[] to) {
    tried = Math.max(tried, place(end, 0, from, to));
    if (!(tried <= FARTHEST && close(t, CONTRACTION, FARTHEST))) {
      return false;
    }
    boolean same = equations.orientation() == orientation;
    turned |= !same;
    return same;
  }

  /** Places the given positions of an end, and the others ahead; returns the largest move. */
  private double place(double end, double ahead, double[] from, double[] to) {
    double move = 0;
    for (int i = 0; i < trial.length; i++) {
      trial[i] =
          !equations.isGiven(i)
              ? last[i] + rate[i] * ahead
              : end == 1 ? to[i] : from[i] + end * (to[i] - from[i]);
      if (ahead == 0 && !equations.isGiven(i)) {
        trial[i] = last[i];
      }
      move = Math.max(move, Math.abs(trial[i] - last[i]) / equations.unit(i));
    }
    return move;
  }

  /**
   * Newton's method.
   *
   * @param contraction largest ratio of a correction to the one before
   * @param farthest largest sum of the corrections
   * @return whether it has converged within them
   */
  private boolean close(double t, double contraction, double farthest) {
    double before = equations.correct(t, trial);
    tried = Math.max(tried, before);
    double sum = before;
    for (int i = 1; i < ITERATIONS && before > CONVERGED && sum <= farthest; i++) {
      double next = equations.correct(t, trial);
      if (!(next <= Math.max(contraction * before, CONVERGED))) {
        return false;
      }
      before = next;
      sum += next;
    }
    return before <= CONVERGED && sum <= farthest;
  }

  /** Returns the part of the last path that was followed, 1 if all of it was. */
  public double reached() {
    return reached;
  }

  /** Returns the last positions of the last path; not to be modified. */
  public double[] positions() {
    return last;
  }

  /** Returns the sign of the determinant at the end of the last path. */
  public int orientation() {
    return orientation;
  }

  /** Returns whether the last path crossed a change point. */
  public boolean crossed() {
    return crossed;
  }
}
