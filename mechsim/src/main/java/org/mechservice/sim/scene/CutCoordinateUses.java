package org.mechservice.sim.scene;

import java.util.ArrayList;
import java.util.List;
import org.mechservice.solver.expression.ClosureCoordinate;
import org.mechservice.solver.expression.Coordinate;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.expression.Tape;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.closure.CoordinateClosure;
import org.mechservice.solver.mechanism.force.ForceElement;
import org.mechservice.solver.mechanism.force.ForceTorque;
import org.mechservice.solver.mechanism.force.JointForce;
import org.mechservice.solver.mechanism.force.JointFriction;
import org.mechservice.solver.mechanism.force.JointSpringDamper;

/**
 * What depends on coordinates of cut joints: those are no states, and their angles count whole
 * turns from one accepted step to the next, which straight-line code cannot.
 */
final class CutCoordinateUses {
  private CutCoordinateUses() {}

  /** Returns the names of the relations and forces that depend on such coordinates. */
  static List<String> names(Mechanism mechanism) {
    List<String> names = new ArrayList<>();
    mechanism.closures().stream()
        .filter(closure -> closure instanceof CoordinateClosure c && uses(List.of(c.relation())))
        .forEach(closure -> names.add(closure.name()));
    mechanism.forces().stream()
        .filter(CutCoordinateUses::uses)
        .forEach(force -> names.add(force.name()));
    return names;
  }

  private static boolean uses(ForceElement force) {
    if (force instanceof JointForce joint) {
      return isCut(joint.coordinate()) || uses(List.of(joint.force()));
    } else if (force instanceof ForceTorque given) {
      return uses(given.components());
    } else if (force instanceof JointSpringDamper spring) {
      return isCut(spring.coordinate());
    }
    return force instanceof JointFriction friction && isCut(friction.coordinate());
  }

  private static boolean uses(List<Expression> formulas) {
    return new Tape(formulas).leaves().stream().anyMatch(CutCoordinateUses::isCut);
  }

  private static boolean isCut(Expression leaf) {
    return (leaf instanceof Expression.CoordinatePosition position && isCut(position.coordinate()))
        || (leaf instanceof Expression.CoordinateVelocity velocity && isCut(velocity.coordinate()));
  }

  private static boolean isCut(Coordinate coordinate) {
    return coordinate instanceof ClosureCoordinate;
  }
}
