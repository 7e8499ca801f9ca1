package org.mechservice.sim.equations.coordinates;

import org.mechservice.sim.equations.recursion.Loads;
import org.mechservice.solver.closure.equations.UnwrappedAngles;
import org.mechservice.solver.expression.ClosureCoordinate;
import org.mechservice.solver.expression.Coordinate;
import org.mechservice.solver.expression.JointCoordinate;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.symbol.Scalar;

/** Coordinates of joints of the tree and of cut joints. */
public final class JointCoordinates {
  private final Mechanism mechanism;
  private final JointLinks joints;
  private final CutCoordinateTerms cuts;

  public JointCoordinates(Mechanism mechanism, JointLinks joints, CutCoordinateTerms cuts) {
    this.mechanism = mechanism;
    this.joints = joints;
    this.cuts = cuts;
  }

  /** Returns a position, rad or m, or an Euler parameter of a joint in the tree. */
  public Scalar position(Coordinate position) {
    return position instanceof ClosureCoordinate cut
        ? cuts.ofPosition(cut).position()
        : joints.position((JointCoordinate) position);
  }

  /** Returns a velocity, rad/s or m/s. */
  public Scalar velocity(Coordinate velocity) {
    return velocity instanceof ClosureCoordinate cut
        ? cuts.ofVelocity(cut).velocity()
        : joints.velocity((JointCoordinate) velocity);
  }

  /** Returns the velocity that is the rate of a position. */
  public Coordinate velocityOf(Coordinate position) {
    return position instanceof ClosureCoordinate cut
        ? UnwrappedAngles.velocityOf(mechanism, cut)
        : joints.velocityOf((JointCoordinate) position);
  }

  /** Adds a force on a velocity coordinate to the loads. */
  public void addForce(Coordinate velocity, Scalar force, Loads loads) {
    if (velocity instanceof ClosureCoordinate cut) {
      cuts.ofVelocity(cut).addForce(force, loads);
    } else {
      joints.addForce((JointCoordinate) velocity, force, loads);
    }
  }
}
