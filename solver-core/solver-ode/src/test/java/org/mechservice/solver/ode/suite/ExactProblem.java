package org.mechservice.solver.ode.suite;

/** A problem whose solution is known everywhere. */
public interface ExactProblem extends SuiteProblem {
  /** Returns the solution at {@code t}, to a few units of round-off. */
  double[] exact(double t);
}
