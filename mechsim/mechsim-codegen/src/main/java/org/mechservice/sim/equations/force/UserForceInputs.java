package org.mechservice.sim.equations.force;

import org.mechservice.sim.equations.coordinates.JointLinks;
import org.mechservice.sim.equations.kinematics.BodyPoints;
import org.mechservice.sim.equations.recursion.Loads;
import org.mechservice.solver.expression.BodyPoint;
import org.mechservice.solver.expression.JointCoordinate;
import org.mechservice.solver.kinematics.TreeGeometry;
import org.mechservice.solver.links.Links;
import org.mechservice.solver.spatial.Rotation;
import org.mechservice.solver.spatial.Vector3;
import org.mechservice.solver.symbol.Expressions;
import org.mechservice.solver.symbol.Program;
import org.mechservice.solver.symbol.Scalar;
import org.mechservice.solver.symbol.ScalarMatrix;
import org.mechservice.solver.symbol.ScalarVector;

/**
 * Loads of user forces: inputs after the parameters of the model, in the order of {@link
 * org.mechservice.solver.dynamics.UserLoads}. Their bodies and joints are known only when the
 * classes are loaded, so every body and joint has an input.
 */
final class UserForceInputs {
  private final Expressions expressions;
  private final BodyPoints points;
  private final JointLinks joints;
  private final TreeGeometry tree;
  private final int first;

  UserForceInputs(Expressions expressions, Links mechanism, BodyPoints points, JointLinks joints) {
    this.expressions = expressions;
    this.points = points;
    this.joints = joints;
    tree = new TreeGeometry(mechanism.mechanism());
    first = Program.PARAMETER + mechanism.mechanism().parameters().size();
  }

  /** Adds all loads. */
  void apply(Loads loads) {
    for (int body = 0; body < tree.linkOfBody.length; body++) {
      addWrench(body, loads);
    }
    for (int k = 0; k < tree.velocityCount; k++) {
      addForce(k, loads);
    }
  }

  /**
   * Adds a wrench, which is [moment; force] in the body's axes at the reference point of its link.
   */
  private void addWrench(int body, Loads loads) {
    int link = tree.linkOfBody[body];
    int at = first + 6 * link;
    double[] origin = tree.bodyOrigin;
    Vector3 reference =
        new Vector3(origin[3 * link], origin[3 * link + 1], origin[3 * link + 2]).negated();
    ScalarMatrix axes = points.axes(body, Rotation.IDENTITY);
    loads.add(
        points.link(body),
        points.inLink(new BodyPoint(body, reference)),
        axes.times(inputs(at + 3)),
        axes.times(inputs(at)));
  }

  private ScalarVector inputs(int at) {
    return new ScalarVector(
        expressions.input(at), expressions.input(at + 1), expressions.input(at + 2));
  }

  /**
   * Adds a joint force; the extended velocities of a joint are contiguous, in the order of its
   * components.
   */
  private void addForce(int velocity, Loads loads) {
    int joint = tree.joint[tree.linkOfVelocity[velocity]];
    int firstOfJoint = velocity;
    while (firstOfJoint > 0 && tree.joint[tree.linkOfVelocity[firstOfJoint - 1]] == joint) {
      firstOfJoint--;
    }
    JointCoordinate coordinate = new JointCoordinate(joint, velocity - firstOfJoint);
    Scalar force = expressions.input(first + 6 * tree.linkCount + velocity);
    joints.addForce(coordinate, force, loads);
  }
}
