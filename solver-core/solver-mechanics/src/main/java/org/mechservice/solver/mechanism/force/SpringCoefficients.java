package org.mechservice.solver.mechanism.force;

import java.util.List;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.force.law.Condition;
import org.mechservice.solver.force.law.Side;

/** The coefficients of springs, in the order of their law. */
final class SpringCoefficients {
  private SpringCoefficients() {}

  static List<Coefficient> of(
      Side side,
      Expression stiffness,
      Expression damping,
      Expression rest,
      Expression preload,
      Expression smoothing,
      Expression dissipation) {
    Condition ofPush = side == Side.BOTH ? Condition.FINITE : Condition.NOT_NEGATIVE;
    Condition ofPreload = side == Side.BOTH ? Condition.FINITE : Condition.ZERO_ON_ONE_SIDE;
    return List.of(
        new Coefficient("stiffness", stiffness, ofPush),
        new Coefficient("damping", damping, ofPush),
        new Coefficient("rest position", rest, Condition.FINITE),
        new Coefficient("preload", preload, ofPreload),
        new Coefficient("smoothing", smoothing, Condition.NOT_NEGATIVE),
        new Coefficient("dissipation", dissipation, ofPush));
  }
}
