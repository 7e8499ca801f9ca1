package org.mechservice.sim.equations.force;

import java.util.List;
import org.mechservice.sim.equations.coordinates.JointCoordinates;
import org.mechservice.sim.equations.recursion.Loads;
import org.mechservice.solver.expression.Coordinate;
import org.mechservice.solver.force.law.CoordinateLoad;
import org.mechservice.solver.symbol.Scalar;

/**
 * A force on one coordinate of a joint.
 *
 * @param joints coordinates of all joints
 * @param coordinate component among velocities
 * @param load force on it
 */
record CoordinateTerm(JointCoordinates joints, Coordinate coordinate, CoordinateLoad load)
    implements ForceTerm {

  @Override
  public void apply(Loads loads) {
    joints.addForce(coordinate, load.force(), loads);
  }

  @Override
  public Scalar potential() {
    return load.potential();
  }

  @Override
  public Scalar power() {
    return load.power();
  }

  @Override
  public List<Scalar> values() {
    return List.of(load.force());
  }
}
