package org.mechservice.report.solution;

import java.util.Optional;
import java.util.function.DoubleSupplier;
import java.util.function.Predicate;

/**
 * The search for the tightest tolerance that a code can keep in a bounded time.
 *
 * <p>How much longer a tighter tolerance takes is not known before: the steps of a code of order p
 * grow with the p-th root of the tolerance until the rounding of the equations is as large as the
 * tolerance, where they fall to nothing. So the code climbs from a rough solution on, and the last
 * that reached the end stands.
 *
 * @param <S> a solution
 */
final class ToleranceLadder<S> {
  /** The first is rough: it warms the program up and tells what the next will take. */
  private static final double[] TOLERANCES = {1e-6, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12};

  /** The loosest tolerance that tells eight digits. */
  private static final double LOOSEST = 1e-9;

  /** Smallest time of the next tolerance, in times of the one before. */
  private static final double GROWTH = 1.5;

  private final DoubleSupplier clock;
  private final double solutions;

  /**
   * @param clock time now, s
   * @param solutions how many like the last are wanted in the same time, itself counted
   */
  ToleranceLadder(DoubleSupplier clock, double solutions) {
    this.clock = clock;
    this.solutions = solutions;
  }

  /** Solves at a tolerance. */
  interface Code<S> {
    /**
     * Returns a solution, or a part of it if the time does not allow more; empty if there is none.
     *
     * @param seconds of the clock for it
     */
    Optional<S> solve(double tolerance, double seconds);
  }

  /**
   * The last solution.
   *
   * @param seconds that it took
   */
  record Rung<S>(S solution, double tolerance, double seconds) {}

  /**
   * Climbs.
   *
   * @param complete whether a solution reached the end
   * @param seconds of the clock for this and the solutions after it
   * @return the tightest that reached the end; a part of one if none as tight as 1e-9 did; empty if
   *     there is not even that
   */
  Optional<Rung<S>> climb(Code<S> code, Predicate<S> complete, double seconds) {
    double end = clock.getAsDouble() + seconds;
    Optional<Rung<S>> best = Optional.empty();
    boolean late = false;
    for (double tolerance : TOLERANCES) {
      boolean rough = tolerance > LOOSEST;
      double began = clock.getAsDouble();
      double next = best.map(rung -> GROWTH * rung.seconds()).orElse(0.0);
      boolean useful = best.isPresent() && best.get().tolerance() <= LOOSEST;
      if (useful && solutions * next > end - began) {
        break;
      }
      if (late && rough) {
        continue;
      }
      Optional<S> found = code.solve(tolerance, (end - began) / solutions);
      double took = clock.getAsDouble() - began;
      if (found.filter(complete).isPresent()) {
        best = Optional.of(new Rung<>(found.get(), tolerance, took));
      } else if (rough) {
        late = true;
      } else {
        return useful || found.isEmpty()
            ? best
            : Optional.of(new Rung<>(found.get(), tolerance, took));
      }
    }
    return best;
  }
}
