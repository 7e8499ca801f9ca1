package org.mechservice.solver.kinematics.pair;

import java.util.List;
import org.mechservice.solver.expression.BodyPoint;
import org.mechservice.solver.kinematics.TreeGeometry;
import org.mechservice.solver.kinematics.TreeMotion;
import org.mechservice.solver.mechanism.joint.Attachment;
import org.mechservice.solver.mechanism.joint.Joint;
import org.mechservice.solver.spatial.EulerParameters;
import org.mechservice.solver.spatial.Rotation;

/**
 * A cut joint, which is not in the tree: its constraint functions and its coordinates from the
 * poses of its two bodies. A is the file's body 1, B its body 2. Workspace of one thread.
 */
public final class CutJoint {
  private final Joint joint;
  private final BodyPoint point1;
  private final BodyPoint point2;
  private final RelativeMotion relative;
  private final JointFunctions functions;

  /** Makes a workspace for a joint between bodies of a tree. */
  public CutJoint(TreeGeometry tree, Joint joint) {
    this.joint = joint;
    Attachment at = joint.attachment();
    boolean backwards = joint.fileBody2IsParent();
    BodyPoint parent = new BodyPoint(at.parent(), at.parentPoint());
    BodyPoint child = new BodyPoint(at.child(), at.childPoint());
    point1 = backwards ? child : parent;
    point2 = backwards ? parent : child;
    relative = new RelativeMotion(tree, point1, point2);
    Rotation zero = backwards ? at.zeroRotation().transposed() : at.zeroRotation();
    functions = JointFunctions.of(joint, zero);
  }

  /** Returns the joint. */
  public Joint joint() {
    return joint;
  }

  /** Returns the joint's point on the file's body 1. */
  public BodyPoint point1() {
    return point1;
  }

  /** Returns the joint's point on the file's body 2. */
  public BodyPoint point2() {
    return point2;
  }

  /** Returns the motion of the file's body 2 as seen from its body 1. */
  public RelativeMotion relative() {
    return relative;
  }

  /** Returns the constraint functions, which are zero in every pose that the joint allows. */
  public List<PairFunction> forbidden() {
    return functions.forbidden();
  }

  /**
   * Returns the function whose rate is a velocity of the joint. The function of an angular velocity
   * in a joint with Euler parameters has a rate, a gradient and a curvature, but no value.
   *
   * @param component among the joint's velocities
   */
  public PairFunction coordinate(int component) {
    return functions.coordinates().get(component);
  }

  /**
   * Returns three functions that are zero if body 2 has a given orientation relative to body 1.
   *
   * @param e Euler parameters from {@code at}; not modified
   */
  public List<PairFunction> rotationsFrom(double[] e, int at) {
    double[] r = new double[9];
    EulerParameters.rotation(e, at, r, 0);
    return JointFunctions.rotations(
        new Rotation(r[0], r[1], r[2], r[3], r[4], r[5], r[6], r[7], r[8]));
  }

  /**
   * Writes the joint's positions and velocities in the form of the output: angles from −π to π,
   * Euler parameters with e0 ≥ 0.
   *
   * @param motion after a sweep
   * @param q its positions from {@code qAt}, rad, m; overwritten
   * @param v its velocities from {@code vAt}, rad/s, m/s; overwritten
   */
  public void coordinates(TreeMotion motion, double[] q, int qAt, double[] v, int vAt) {
    relative.place(motion);
    relative.move(motion);
    int euler = 0;
    int velocities = functions.coordinates().size();
    if (joint.type().hasEulerParameters()) {
      EulerParameters.of(relative.rotation, 0, q, qAt);
      euler = 4;
    }
    int surplus = joint.type().positionCount() - velocities;
    for (int k = 0; k < velocities; k++) {
      PairFunction function = functions.coordinates().get(k);
      double value = function.evaluate(relative);
      v[vAt + k] = function.rate(relative);
      if (k + surplus >= euler) {
        q[qAt + k + surplus] = value;
      }
    }
  }
}
