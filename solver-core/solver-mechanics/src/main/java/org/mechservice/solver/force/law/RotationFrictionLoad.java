package org.mechservice.solver.force.law;

import java.util.List;
import java.util.Optional;
import org.mechservice.solver.api.result.Variable;
import org.mechservice.solver.symbol.Expressions;
import org.mechservice.solver.symbol.Scalar;
import org.mechservice.solver.symbol.ScalarVector;

/**
 * Viscous and dry friction against the rotation of two bodies relative to each other, as of a ball
 * in its socket: with the relative angular velocity ω the moment on body 2 is −(c + f/√(ω² + s²))
 * ω, whatever the axis. The dry part is smooth, as that of a joint with one coordinate, so that it
 * does not hold a load at rest. It has no energy; the power lost is (c + f/√(ω² + s²)) ω².
 */
final class RotationFrictionLoad implements PairLoad {
  static final ForceRow ROW =
      new ForceRow(
          "rotationFriction",
          "between two bodies, against their relative angular velocity ω",
          "torque (damping + friction/√(ω² + speed²))·ω, whatever the axis",
          "work",
          List.of(
              new ForceRow.Attribute(
                  "damping",
                  "N*m*s/rad",
                  Optional.of(0.0),
                  Condition.NOT_NEGATIVE,
                  "viscous friction",
                  0.5),
              new ForceRow.Attribute(
                  "friction",
                  "N*m",
                  Optional.of(0.0),
                  Condition.NOT_NEGATIVE,
                  "dry friction far above the speed",
                  0.2),
              new ForceRow.Attribute(
                  "speed",
                  "rad/s",
                  Optional.of(0.01),
                  Condition.POSITIVE,
                  "angular velocity at which dry friction has 0.7 of its full torque",
                  0.1)),
          List.of(new Variable("loss", "W")),
          new ForceRow.Example(ForceRow.Trial.BALL, "turn.v[2] = 0.142153"));

  private final ScalarVector omega;
  private final Scalar share;

  /**
   * @param coefficients c, N·m·s/rad, f, N·m, and s, rad/s
   */
  RotationFrictionLoad(Frames x, List<Scalar> coefficients) {
    omega = x.omega();
    Scalar speed = omega.dot(omega).plus(coefficients.get(2).squared()).squareRoot();
    share = coefficients.get(0).plus(coefficients.get(1).over(speed));
  }

  @Override
  public ScalarVector force() {
    return ScalarVector.zero(expressions());
  }

  @Override
  public ScalarVector moment() {
    return omega.times(share.negated());
  }

  private Expressions expressions() {
    return share.expressions();
  }

  @Override
  public Scalar potential() {
    return expressions().zero();
  }

  private Scalar loss() {
    return omega.dot(omega).times(share);
  }

  @Override
  public Scalar power() {
    return loss().negated();
  }

  @Override
  public List<Scalar> values() {
    return List.of(loss());
  }
}
