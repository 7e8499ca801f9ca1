package org.mechservice.sim.equations.force;

import java.util.List;
import org.mechservice.sim.equations.coordinates.JointCoordinates;
import org.mechservice.sim.equations.recursion.Loads;
import org.mechservice.solver.expression.Coordinate;
import org.mechservice.solver.symbol.Scalar;

/**
 * A force on one coordinate of a joint.
 *
 * @param joints coordinates of all joints
 * @param coordinate component among velocities
 * @param force force, positive if it increases the coordinate, N·m or N
 * @param potential its potential energy, J
 * @param power power of the part without potential energy, W
 */
record CoordinateTerm(
    JointCoordinates joints, Coordinate coordinate, Scalar force, Scalar potential, Scalar power)
    implements ForceTerm {

  @Override
  public void apply(Loads loads) {
    joints.addForce(coordinate, force, loads);
  }

  @Override
  public List<Scalar> values() {
    return List.of(force);
  }
}
