package org.mechservice.solver.ode.step;

import java.util.Optional;

/**
 * The step that a method is at work on, with the problem it belongs to: what a {@link StepWatch} is
 * shown. One object for all steps of a problem. Arrays have the length n of the problem, are those
 * of the method and are not to be modified.
 */
public interface TriedStep {
  /** Returns f, counted; empty if the problem is in residual form. */
  Optional<RightHandSide> rightHandSide();

  /** Returns what is known of the states. */
  Manifold manifold();

  /** Returns the norm that errors are judged by. */
  ErrorNorm norm();

  /** Returns where the integration is; a step begins there until it is accepted. */
  IntegrationProgress progress();

  /** Returns the end of the problem. */
  double problemEnd();

  /** Returns the size of the step, signed. */
  double size();

  /** Returns where it ends. */
  double end();

  /** Returns the order of its formula. */
  int order();

  /** Returns its estimated error over the tolerance. */
  double error();

  /** Returns the norm of the difference of y' at its end from its extrapolation. */
  double discrepancy();

  /** Returns y at its beginning. */
  double[] state();

  /** Returns y at its end, where it has passed its tests. */
  double[] stateAtEnd();

  /**
   * Returns y' at its end; of a formula that is one straight line from end to end, which says
   * nothing, that of its prediction.
   */
  double[] slopeAtEnd();
}
