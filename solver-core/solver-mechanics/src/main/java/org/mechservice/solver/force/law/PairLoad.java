package org.mechservice.solver.force.law;

import java.util.List;
import java.util.Optional;
import org.mechservice.solver.symbol.Scalar;
import org.mechservice.solver.symbol.ScalarVector;

/** What two bodies exert on each other, as formulas of the relative motion of frames on them. */
public interface PairLoad {
  /** Returns the force on body 2, in the axes of the relative motion, N. */
  ScalarVector force();

  /** Returns the moment on body 2 at the origin of frame 2, likewise, N·m. */
  ScalarVector moment();

  /** Returns the potential energy, J; zero if it has none. */
  Scalar potential();

  /** Returns the power of the part without potential energy, W, positive into the mechanism. */
  Scalar power();

  /** Returns its output values, in the order of the element's description. */
  List<Scalar> values();

  /** Returns the condition for a direction; empty if there is one in every state. */
  default Optional<Direction> direction() {
    return Optional.empty();
  }

  /**
   * Condition {@code size > least} for a load to have a direction.
   *
   * @param size checked value
   * @param least largest value without a direction
   */
  record Direction(Scalar size, double least) {}
}
