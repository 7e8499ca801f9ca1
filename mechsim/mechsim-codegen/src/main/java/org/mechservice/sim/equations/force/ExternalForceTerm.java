package org.mechservice.sim.equations.force;

import java.util.ArrayList;
import java.util.List;
import org.mechservice.sim.equations.kinematics.LinkKinematics;
import org.mechservice.sim.equations.recursion.Loads;
import org.mechservice.solver.symbol.Scalar;
import org.mechservice.solver.symbol.ScalarVector;

/** A force at a point and a torque, given by expressions in world or body axes. */
final class ExternalForceTerm implements ForceTerm {
  private final LinkKinematics kinematics;
  private final int link;
  private final ScalarVector point;
  private final ScalarVector force;
  private final ScalarVector torque;
  private final List<Scalar> given;

  /**
   * @param point in the link's axes
   * @param force in the link's axes
   * @param torque in the link's axes
   * @param given components in the axes of the expressions
   */
  ExternalForceTerm(
      LinkKinematics kinematics,
      int link,
      ScalarVector point,
      ScalarVector force,
      ScalarVector torque,
      List<Scalar> given) {
    this.kinematics = kinematics;
    this.link = link;
    this.point = point;
    this.force = force;
    this.torque = torque;
    this.given = new ArrayList<>(given);
  }

  @Override
  public void apply(Loads loads) {
    loads.add(link, point, force, torque);
  }

  @Override
  public Scalar potential() {
    return given.get(0).expressions().zero();
  }

  @Override
  public Scalar power() {
    return force.dot(kinematics.velocityAt(link, point)).plus(torque.dot(kinematics.omega(link)));
  }

  @Override
  public List<Scalar> values() {
    return given;
  }
}
