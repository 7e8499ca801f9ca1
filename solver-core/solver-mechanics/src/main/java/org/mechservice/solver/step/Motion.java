package org.mechservice.solver.step;

import org.mechservice.solver.symbol.Scalar;
import org.mechservice.solver.symbol.ScalarMatrix;
import org.mechservice.solver.symbol.ScalarVector;

/**
 * Motion of a computing frame: angular velocity, angular acceleration, and the classical
 * acceleration of its origin as a point of the body, all in its own axes.
 *
 * @param omega angular velocity, rad/s
 * @param alpha angular acceleration, rad/s²
 * @param acceleration acceleration of the origin, m/s²
 */
public record Motion(ScalarVector omega, ScalarVector alpha, ScalarVector acceleration) {

  /** Returns W = [α]× + [ω]×[ω]×: a point of the body at r has the acceleration a + W r. */
  public ScalarMatrix spread() {
    Scalar xx = omega.x().squared();
    Scalar yy = omega.y().squared();
    Scalar zz = omega.z().squared();
    Scalar xy = omega.x().times(omega.y());
    Scalar xz = omega.x().times(omega.z());
    Scalar yz = omega.y().times(omega.z());
    return new ScalarMatrix(
        java.util.List.of(
            yy.plus(zz).negated(),
            xy.minus(alpha.z()),
            xz.plus(alpha.y()),
            xy.plus(alpha.z()),
            xx.plus(zz).negated(),
            yz.minus(alpha.x()),
            xz.minus(alpha.y()),
            yz.plus(alpha.x()),
            xx.plus(yy).negated()));
  }

  /** Returns the acceleration of the body's point at {@code r}. */
  public ScalarVector accelerationAt(ScalarVector r) {
    return acceleration.plus(spread().times(r));
  }
}
