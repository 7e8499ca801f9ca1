package org.mechservice.solver.ode.newton;

import org.mechservice.solver.linear.MatrixLayout;
import org.mechservice.solver.ode.SavedState;
import org.mechservice.solver.ode.TrialOutcome;

/** Looks at the columns of a Jacobian by differences once they are formed, and may correct them. */
public interface ColumnTest {
  /** Makes the tests of the matrices that a problem is differenced by: a part of a watch. */
  @FunctionalInterface
  interface Maker {
    /** Returns a test of one of them. */
    ColumnTest of(MatrixLayout layout, ColumnGroups groups);
  }

  /**
   * Tells a part of the next Jacobian that is known.
   *
   * @param slopes by layout; kept, not modified
   */
  void expect(double factor, double[] slopes);

  /** Returns where to write the size of the terms of f that do not depend on x, length n. */
  double[] terms();

  /** Forgets a Jacobian that was stopped half way. */
  void abandon();

  /**
   * Looks at a Jacobian; after {@link TrialOutcome#STOPPED} the next call goes on where this one
   * stopped.
   *
   * @param x the point; moved, and put back
   * @param base f there
   * @param increment over which each column was differenced
   * @param jacobian overwritten where it was no slope at the point
   * @return {@link TrialOutcome#STOPPED} or {@link TrialOutcome#PASSED}
   */
  TrialOutcome look(
      DifferencedFunction function,
      double[] x,
      double[] base,
      double[] increment,
      double[] jacobian);

  /** Returns whether no increment makes a small change in column j of the last Jacobian. */
  boolean jumped(int j);

  /** Carries over what is known of the columns. */
  void transfer(SavedState state);
}
