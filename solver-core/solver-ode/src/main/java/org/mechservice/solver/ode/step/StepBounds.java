package org.mechservice.solver.ode.step;

/**
 * Where steps may end: the smallest, the largest, and what happens at the end of the problem.
 *
 * <p>Not sealed: a class file names what its type permits, and a JAR of one method would carry all
 * of them.
 */
public interface StepBounds {
  /**
   * Begins a problem.
   *
   * @param maxStep largest step the user allows; infinite: no bound
   */
  void begin(double t0, double tEnd, double maxStep);

  /**
   * Sets a place that no step passes, but one ends at exactly.
   *
   * @param place infinite: none
   */
  void stopAt(double place);

  /** Returns the smallest step size that the arithmetic can hold at {@code t}, positive. */
  double smallest(double t);

  /**
   * Returns the step to try instead of a proposed one, same sign.
   *
   * @param t where the step starts, not yet at the end
   * @param h proposed step, signed
   */
  double bounded(double t, double h);

  /** Returns where a step {@code h} from {@code t} ends. */
  double endOf(double t, double h);

  /** Returns {@code t}, the end of a step, or the problem's end if the step has passed it. */
  default double inProblem(double t) {
    return t;
  }

  /** Returns whether the problem's end is at or before {@code t}. */
  boolean reachedAt(double t);
}
