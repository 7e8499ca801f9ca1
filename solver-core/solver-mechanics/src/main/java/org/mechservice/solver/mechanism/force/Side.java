package org.mechservice.solver.mechanism.force;

import java.util.List;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.mechanism.force.Coefficient.Condition;

/** The side of its rest position on which a spring acts. */
public enum Side {
  /** Both sides. */
  BOTH,
  /** Only above the rest value of length or coordinate: a rope, an upper stop. */
  ABOVE,
  /** Only below the rest value: a buffer, a lower stop. */
  BELOW;

  /** Returns the coefficients of a spring on this side, in the order of its law. */
  List<Coefficient> coefficients(
      Expression stiffness,
      Expression damping,
      Expression rest,
      Expression preload,
      Expression smoothing,
      Expression dissipation) {
    Condition ofPush = this == BOTH ? Condition.FINITE : Condition.NOT_NEGATIVE;
    Condition ofPreload = this == BOTH ? Condition.FINITE : Condition.ZERO_ON_ONE_SIDE;
    return List.of(
        new Coefficient("stiffness", stiffness, ofPush),
        new Coefficient("damping", damping, ofPush),
        new Coefficient("rest position", rest, Condition.FINITE),
        new Coefficient("preload", preload, ofPreload),
        new Coefficient("smoothing", smoothing, Condition.NOT_NEGATIVE),
        new Coefficient("dissipation", dissipation, ofPush));
  }
}
