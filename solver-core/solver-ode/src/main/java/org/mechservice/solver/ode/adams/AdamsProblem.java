package org.mechservice.solver.ode.adams;

import org.mechservice.solver.ode.step.Manifold;
import org.mechservice.solver.ode.step.RightHandSide;

/**
 * A problem that an Adams method is at work on, and how far its solution is known.
 *
 * @param equations y' = f(t, y)
 * @param manifold what is known of its states
 * @param history state and differences
 * @param end of the problem
 */
record AdamsProblem(RightHandSide equations, Manifold manifold, AdamsHistory history, double end) {
  /** Stands in until a problem is given. */
  static AdamsProblem none() {
    RightHandSide nothing = RightHandSide.none();
    return new AdamsProblem(nothing, new Manifold(nothing.system()), new AdamsHistory(0, false), 0);
  }

  /** Returns n. */
  int dimension() {
    return history.state().length;
  }
}
