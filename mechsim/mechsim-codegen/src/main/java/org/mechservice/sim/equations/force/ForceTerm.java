package org.mechservice.sim.equations.force;

import java.util.List;
import java.util.Optional;
import org.mechservice.sim.equations.recursion.Loads;
import org.mechservice.sim.symbolic.Scalar;

/** An applied force as equations. */
interface ForceTerm {
  /** Adds its wrenches on links and its joint forces. */
  void apply(Loads loads);

  /** Returns the check that fails where the force has no direction, if there is such a state. */
  default Optional<Direction> direction() {
    return Optional.empty();
  }

  /**
   * A force has a direction where {@code size > least}.
   *
   * @param size what is checked
   * @param least number at or below which there is none
   */
  record Direction(Scalar size, double least) {}

  /** Returns its potential energy, J; zero if it has none. */
  Scalar potential();

  /** Returns the power of the part without potential energy, W, positive into the mechanism. */
  Scalar power();

  /** Returns the values it can put out, in the order in which the description names them. */
  List<Scalar> values();
}
