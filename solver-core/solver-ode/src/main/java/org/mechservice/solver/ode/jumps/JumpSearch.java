package org.mechservice.solver.ode.jumps;

import org.mechservice.solver.ode.SavedState;

/**
 * Narrows down a place at which the right-hand side seems to jump.
 *
 * <p>Left alone, an Adams method meets an undeclared jump again and again: its steps grow on the
 * near side, run into it, and are halved many times over. A jump is told from a smooth solution
 * that moves fast by the error of the next, shorter try after one that has missed the tolerance by
 * far: there the error falls like h^(k+1); across a jump it falls like h, and short of it to
 * nothing.
 *
 * <p>The stretch in which the jump must lie is then halved at every try, whether that is accepted
 * or rejected, until a step of order 1 over all of it would pass; after some failures in a row, at
 * the geometric mean of all of it and of that step. Behind the jump the history is of no use.
 *
 * <p>Two jumps inside one step may leave no trace at its end. So where jumps have followed each
 * other, steps are at most a quarter of the shortest distance between them, until nothing has
 * jumped for twice the longest.
 */
final class JumpSearch {
  /** Error over the tolerance that is worth a second look. */
  private static final double FAR_OFF = 100;

  /** Part of an error that falls as the step does. */
  private static final double AS_THE_STEP = 0.6;

  /** Part of the error expected of a smooth solution that is next to nothing. */
  private static final double NOTHING = 0.05;

  /**
   * Error planned for the step across, over the tolerance. It is the one error of a run that no
   * later step has a part in: so it is small enough that events behind ten jumps are in time by ten
   * tolerances.
   */
  private static final double AIM = 0.15;

  /** Error from which on a step across is not accepted. */
  private static final double MOST_ACROSS = 2 * AIM;

  /** After this many failures in a row the jump is looked for right ahead. */
  private static final int MANY_IN_A_ROW = 4;

  /** Jumps that are too many for any run. */
  static final double MOST = 1e7;

  /** Jumps after which is looked how close they lie. */
  private static final int MANY = 1000;

  /** Jumps after which, and those to come from which on, they tell of a law that is steep. */
  private static final int SOME = 20;

  private static final double OFTEN = 1000;

  /** Longest step after jumps, in shortest distances between them. */
  private static final double PART = 0.25;

  /** The same while only a few distances are known, of which none may be short. */
  private static final double PART_AT_FIRST = 0.1;

  private static final int FEW = 5;

  /** Longest distance over one down to which steps are looked into. */
  private static final double LOOKED = 40;

  /** Distance of looks into steps, in shortest distances, and in the time since the last jump. */
  private static final double PART_OF_DISTANCE = 0.125;

  private static final double PART_OF_QUIET = 0.05;

  /** Part of a try that failed to which steps fall in front of a jump. */
  private static final double NARROW = 0.05;

  /** Distance, over a try that failed, within which a jump is one that was crossed before. */
  private static final double SAME_PLACE = 2;

  /** How long jumps are expected to follow each other, in longest distances between them. */
  private static final double PATIENCE = 2;

  /** Longest distance over one that is not shorter by chance only. */
  private static final double SCATTER = 10;

  private boolean active;
  private boolean crossing;
  private int failuresInARow;

  /** First try since the last jump that failed, and whether steps far shorter followed it. */
  private double firstFailed;

  private double firstBehind;
  private boolean narrow;

  /**
   * The last try that missed by far, 0 if there is none, and whether a shorter one had no error.
   */
  private double failedError;

  private double failedSize;
  private int failedOrder;
  private boolean suspected;

  /** The last try of the present step, which failed; 0 if there is none. */
  private double missedError;

  private double missedSize;
  private int missedOrder;

  /** Jumps crossed since a time. */
  private int crossings;

  private double since;

  /** End of the last step across a jump; NaN before there was one. */
  private double crossed = Double.NaN;

  /**
   * Shortest and longest distance between jumps that followed each other; 0 before there is one.
   */
  private double shortest;

  private double longest;

  /** The shortest one, be it by chance or not, and that of the first jump from the start. */
  private double closest;

  /** Where the problem begins; NaN if it goes on there from another state. */
  private double origin = Double.NaN;

  /** How many distances these are of. */
  private int distances;

  /** A place behind the jump, and the size of the jump in units of the error allowed. */
  private double behind;

  private double jump;

  void clear() {
    missedError = 0;
    crossings = 0;
    crossed = Double.NaN;
    shortest = 0;
    longest = 0;
    closest = 0;
    origin = Double.NaN;
    distances = 0;
    noticed();
    forget();
  }

  /**
   * Says that the solution was straight from a place on: the distance of the first jump from there
   * counts as one between jumps.
   */
  void straightFrom(double start) {
    if (Double.isNaN(crossed)) {
      crossed = start;
    }
  }

  /**
   * Says where the problem begins: steps are looked into behind the first jump as if another one
   * had been there.
   */
  void beginsAt(double start) {
    origin = start;
  }

  private void forget() {
    active = false;
    crossing = false;
    failuresInARow = 0;
    failedError = 0;
    suspected = false;
  }

  /** Returns whether a jump is being narrowed down. */
  boolean active() {
    return active;
  }

  /**
   * Takes note of a step that failed the error test.
   *
   * @param h its size
   * @param k its order
   * @param end where it would have ended
   * @param error over the tolerance
   * @param discrepancy norm of the difference of the right-hand side from its extrapolation
   */
  void rejected(double h, int k, double end, double error, double discrepancy) {
    missedError = error;
    missedSize = Math.abs(h);
    missedOrder = k;
    if (firstFailed == 0) {
      firstFailed = Math.abs(h);
      firstBehind = end;
    }
    active |= suspected ? error >= FAR_OFF : k == failedOrder && error > notSmooth(h);
    if (active) {
      failuresInARow++;
      jump = discrepancy;
    }
    if (active || failedError > 0 || error >= FAR_OFF) {
      crossing = false;
      behind = end;
      failedError = error;
      failedSize = Math.abs(h);
      failedOrder = k;
    }
  }

  /** The mean of what a smooth solution and a jump would have for error; infinite at first. */
  private double notSmooth(double h) {
    double acrossJump = failedError * Math.abs(h) / failedSize;
    return failedError > 0 ? Math.sqrt(acrossJump * smooth(h)) : Double.POSITIVE_INFINITY;
  }

  /** The error of a shorter try that a smooth solution would have. */
  private double smooth(double h) {
    double error = failedError;
    for (int i = 0; i <= failedOrder; i++) {
      error *= Math.abs(h) / failedSize;
    }
    return error;
  }

  /**
   * Returns whether a jump inside a step that passes would make an error that none may make, and is
   * not searched for yet.
   *
   * @param h its size
   * @param discrepancy norm of the difference of the right-hand side from its extrapolation
   */
  boolean wouldMatter(double h, double discrepancy) {
    return !active && errorAcross(h, discrepancy) > MOST_ACROSS;
  }

  /**
   * Returns whether a step that passes, after one that failed, may have crossed a jump unseen: at
   * loose tolerances a jump misses the error test by little, and soon passes it. Its error then
   * falls as the step does.
   *
   * @param h its size
   * @param k its order
   * @param error over the tolerance
   */
  boolean suspects(double h, int k, double error) {
    return missedError > 0
        && k == missedOrder
        && error >= AS_THE_STEP * missedError * Math.abs(h) / missedSize;
  }

  /**
   * Begins to narrow a jump down that was found inside a step that passes.
   *
   * @param h its size
   * @param end where it would end
   */
  void found(double h, int k, double end, double error, double discrepancy) {
    active = true;
    rejected(h, k, end, error, discrepancy);
  }

  /**
   * Returns whether a step that passes the error test has the jump inside all the same: formulas of
   * high order think little of a single value that is off.
   *
   * @param h its size
   */
  boolean inside(double h, double discrepancy) {
    return active && errorAcross(h, discrepancy) > MOST_ACROSS;
  }

  /** Error of a step of order 1 across a jump, over the tolerance. */
  private static double errorAcross(double h, double jump) {
    return 0.5 * Math.abs(h) * jump;
  }

  /**
   * Takes note of an accepted step.
   *
   * @param h its size, signed
   * @param end where it ends
   * @param error over the tolerance
   * @return whether a jump that was narrowed down lies behind it
   */
  boolean accepted(double h, double end, double error) {
    failuresInARow = 0;
    missedError = 0;
    notice(Math.abs(h), end, Math.copySign(1, h));
    if (failedError == 0) {
      return false;
    }
    boolean passed = Math.copySign(1, h) * (end - behind) >= 0;
    boolean across = active && passed;
    suspected |= error < NOTHING * smooth(h);
    if (passed || !(active || suspected)) {
      forget();
    }
    if (across && crossings++ == 0) {
      since = end;
    }
    if (across && end != crossed) {
      measure(end);
      noticed();
    }
    return across;
  }

  /**
   * Notices a jump that the error test alone has narrowed down: where tolerances are loose it is
   * not so far off that it would be searched for.
   */
  private void notice(double size, double end, double forward) {
    if (firstFailed == 0) {
      return;
    }
    narrow |= size < NARROW * firstFailed;
    if (forward * (end - firstBehind) < 0) {
      return;
    }
    if (narrow && !(Math.abs(end - crossed) <= SAME_PLACE * firstFailed)) {
      measure(end);
    }
    noticed();
  }

  private void noticed() {
    firstFailed = 0;
    narrow = false;
  }

  private void measure(double end) {
    boolean first = Double.isNaN(crossed);
    double distance = Math.abs(end - (first ? origin : crossed));
    crossed = end;
    if (distance > 0) {
      closest = closest == 0 ? distance : Math.min(closest, distance);
    }
    if (distance > 0 && !first) {
      distances++;
      longest = Math.max(longest, distance);
      shortest = shortest == 0 ? distance : Math.min(shortest, distance);
      shortest = Math.max(shortest, longest / SCATTER);
    }
  }

  /** Returns whether a jump was crossed. */
  boolean anyKnown() {
    return closest > 0;
  }

  /** Returns the shortest distance known between jumps, 0 before there is one. */
  double shortestDistance() {
    return shortest;
  }

  /** Returns the longest step from {@code t} that does not go over two jumps unawares. */
  double longestStep(double t) {
    boolean expected = distances > 0 && Math.abs(t - crossed) <= PATIENCE * longest;
    double part = distances < FEW ? PART_AT_FIRST : PART;
    return expected ? part * shortest : Double.POSITIVE_INFINITY;
  }

  /**
   * Returns at which distances a step from {@code t} is to be looked into for two jumps that cancel
   * each other; infinite while no jump is known.
   */
  double distanceOfLooks(double t) {
    if (closest == 0) {
      return Double.POSITIVE_INFINITY;
    }
    double byDistance = PART_OF_DISTANCE * Math.max(closest, longest / LOOKED);
    return Math.max(byDistance, PART_OF_QUIET * Math.abs(t - crossed));
  }

  /**
   * Returns how many jumps lie ahead if they follow each other as closely as the last ones, of
   * which there were many since this was told; 0 before there were so many. With more than {@link
   * #MOST} nothing would come of crossing them: the solution slides along a jump of which both
   * sides lead back to it.
   *
   * @param t time reached
   * @param end of the problem
   */
  double ahead(double t, double end) {
    if (crossings < MANY) {
      return 0;
    }
    double ahead = crossings * (end - t) / (t - since);
    crossings = 0;
    return ahead;
  }

  /**
   * Returns whether jumps follow each other so closely that something steep may only look like them
   * and could be had for less by steps that see it as a slope.
   *
   * @param t time reached
   * @param end of the problem
   */
  boolean crossesOften(double t, double end) {
    return crossings >= SOME && Math.abs(end - t) * crossings > OFTEN * Math.abs(t - since);
  }

  /** Returns the step to try from {@code t}, signed; of order 1 if {@link #crossing}. */
  double step(double t) {
    double stretch = behind - t;
    double error = errorAcross(stretch, jump);
    crossing = error <= AIM;
    if (crossing) {
      return stretch;
    }
    return failuresInARow < MANY_IN_A_ROW ? 0.5 * stretch : stretch * Math.sqrt(AIM / error);
  }

  /** Returns whether the step to try goes across the jump. */
  boolean crossing() {
    return crossing;
  }

  /** Carries the state between two steps over. */
  void transfer(SavedState state) {
    active = state.flag(active);
    crossing = state.flag(crossing);
    failuresInARow = state.integer(failuresInARow);
    firstFailed = state.number(firstFailed);
    firstBehind = state.number(firstBehind);
    narrow = state.flag(narrow);
    missedError = state.number(missedError);
    missedSize = state.number(missedSize);
    missedOrder = state.integer(missedOrder);
    failedError = state.number(failedError);
    failedSize = state.number(failedSize);
    failedOrder = state.integer(failedOrder);
    suspected = state.flag(suspected);
    behind = state.number(behind);
    jump = state.number(jump);
    crossings = state.integer(crossings);
    since = state.number(since);
    crossed = state.number(crossed);
    shortest = state.number(shortest);
    longest = state.number(longest);
    closest = state.number(closest);
    origin = state.number(origin);
    distances = state.integer(distances);
  }
}
