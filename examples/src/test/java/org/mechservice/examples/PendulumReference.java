package org.mechservice.examples;

/** The pendulum's reference solution, examples/pendulum/reference.csv. */
final class PendulumReference {
  /** The pendulum is chaotic: an error in the last digit at the start is visible beyond 3 s. */
  static final double COMPARABLE_UNTIL = 3;

  private static final ResultRows TABLE =
      ResultRows.read(WorkingTree.TOP.resolve("examples/pendulum/reference.csv"));

  private PendulumReference() {}

  /** Returns the largest error of q and v, relative where they are large. */
  static double errorOf(ResultRows results) {
    return results.distanceTo(TABLE, COMPARABLE_UNTIL);
  }
}
