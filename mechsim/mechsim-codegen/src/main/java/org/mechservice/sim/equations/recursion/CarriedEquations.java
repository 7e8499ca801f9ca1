package org.mechservice.sim.equations.recursion;

import org.mechservice.solver.links.Link;
import org.mechservice.solver.step.DegreeOfFreedom;
import org.mechservice.solver.step.LinkStep.Elimination;
import org.mechservice.solver.symbol.Scalar;
import org.mechservice.solver.symbol.ScalarVector;

/**
 * Equations with multipliers that the inward sweep of articulated bodies carries along and
 * eliminates, and whose multipliers the outward sweep finds. An open chain has none.
 */
public interface CarriedEquations {
  /** No equations. */
  CarriedEquations NONE =
      new CarriedEquations() {
        @Override
        public void enter(int link, InertiaSweep sweep) {}

        @Override
        public void eliminate(int link, DegreeOfFreedom freedom, Elimination of) {}

        @Override
        public void pass(int index, Link link) {}

        @Override
        public void solve() {}

        @Override
        public Scalar push(int link, int freedom, Scalar rate) {
          return rate;
        }

        @Override
        public void moved(int link, ScalarVector alpha, ScalarVector acceleration) {}
      };

  /** Eliminates the equations whose ways meet in a link, before its joint is eliminated. */
  void enter(int link, InertiaSweep sweep);

  /** Takes the elimination of a degree of freedom into account. */
  void eliminate(int link, DegreeOfFreedom freedom, Elimination of);

  /** Carries the equations from a link to its parent, which is not the root. */
  void pass(int index, Link link);

  /** Eliminates the equations whose ways meet in the root; the multipliers of these are known. */
  void solve();

  /**
   * Returns the acceleration of a degree of freedom with the push of the multipliers.
   *
   * @param freedom its number among those of the link
   * @param rate acceleration without them
   */
  Scalar push(int link, int freedom, Scalar rate);

  /**
   * Finds the multipliers of the equations whose ways meet in a link.
   *
   * @param alpha angular acceleration that joint accelerations add to the link
   * @param acceleration the same of its origin
   */
  void moved(int link, ScalarVector alpha, ScalarVector acceleration);
}
