package org.mechservice.sim.equations.force;

import java.util.List;
import java.util.Optional;
import org.mechservice.sim.equations.recursion.Loads;
import org.mechservice.solver.force.law.PairLoad.Direction;
import org.mechservice.solver.symbol.Scalar;

/** An applied force as equations. */
interface ForceTerm {
  /** Adds its wrenches on links and its joint forces. */
  void apply(Loads loads);

  /**
   * Returns the check that fails in states in which the force has no direction, if there are any.
   */
  default Optional<Direction> direction() {
    return Optional.empty();
  }

  /** Returns its potential energy, J; zero if it has none. */
  Scalar potential();

  /** Returns the power of the part without potential energy, W, positive into the mechanism. */
  Scalar power();

  /** Returns its output values, in the order of the description. */
  List<Scalar> values();
}
