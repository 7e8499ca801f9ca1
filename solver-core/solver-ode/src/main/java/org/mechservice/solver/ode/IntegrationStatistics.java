package org.mechservice.solver.ode;

import java.util.List;

/**
 * Counts of the work of an integration so far.
 *
 * @param steps accepted steps
 * @param rejectedSteps steps that failed the error test, met values that are not finite, or whose
 *     equations could not be solved
 * @param evaluations evaluations of the right-hand side, those for Jacobians by differences
 *     included
 * @param jacobians Jacobians formed; 0, like the next two, for methods that solve no equations
 * @param factorisations matrices factored
 * @param solutions systems of linear equations solved
 * @param stiffnessSuspected whether the steps look as if stability, not accuracy, limited them: an
 *     implicit method might take far fewer
 * @param toleranceFactor what the tolerances asked for were multiplied by in every error test
 * @param limits components that made steps be rejected, most often first
 */
public record IntegrationStatistics(
    long steps,
    long rejectedSteps,
    long evaluations,
    long jacobians,
    long factorisations,
    long solutions,
    boolean stiffnessSuspected,
    double toleranceFactor,
    List<Limit> limits) {

  public IntegrationStatistics {
    limits = List.copyOf(limits);
  }

  /**
   * Number of steps rejected because of one component.
   *
   * @param component its index
   * @param inaccurate how often its error was the largest, relative to what is allowed
   * @param unsolved how often it was the worst when the equations of a step could not be solved, or
   *     was not finite
   */
  public record Limit(int component, long inaccurate, long unsolved) {}
}
