package org.mechservice.solver.step;

import org.mechservice.solver.symbol.Scalar;
import org.mechservice.solver.symbol.ScalarMatrix;
import org.mechservice.solver.symbol.ScalarVector;

/**
 * The coordinates of a link's joint as scalars. Only those of its kind are asked for: a turning
 * link has sine and cosine, a sliding one a way, one with Euler parameters a rotation.
 */
public interface JointTerms {
  /** Returns the cosine of the angle. */
  Scalar cosine();

  /** Returns the sine of the angle. */
  Scalar sine();

  /** Returns the displacement along z, m. */
  Scalar way();

  /** Returns its rate, m/s. */
  Scalar wayRate();

  /** Returns the velocity, rad/s or m/s. */
  Scalar velocity();

  /** Returns the known acceleration, rad/s² or m/s²; 0 unless it is driven or an input. */
  Scalar knownAcceleration();

  /** Returns the rotation from link to parent axes by Euler parameters. */
  ScalarMatrix ballRotation();

  /** Returns the angular velocity of the file's body 2 relative to body 1, in body 1's axes. */
  ScalarVector ballVelocity();

  /** Returns its known rate in the same axes, rad/s². */
  ScalarVector knownBallAcceleration();
}
