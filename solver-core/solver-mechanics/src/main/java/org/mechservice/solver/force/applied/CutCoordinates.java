package org.mechservice.solver.force.applied;

import org.mechservice.solver.expression.BodyFrame;
import org.mechservice.solver.expression.BodyPoint;
import org.mechservice.solver.expression.ClosureCoordinate;
import org.mechservice.solver.kinematics.TreeGeometry;
import org.mechservice.solver.kinematics.TreeMotion;
import org.mechservice.solver.kinematics.pair.CutJoint;
import org.mechservice.solver.mechanism.closure.JointClosure;
import org.mechservice.solver.mechanism.joint.Attachment;
import org.mechservice.solver.mechanism.joint.Joint;
import org.mechservice.solver.spatial.Rotation;

/** Finds cut joints by their closure, and the frames of their coordinates. */
public final class CutCoordinates {
  private CutCoordinates() {}

  /**
   * Returns the cut joint of a coordinate.
   *
   * @throws IllegalArgumentException if the closure is no joint
   */
  public static CutJoint joint(TreeGeometry tree, ClosureCoordinate coordinate) {
    if (coordinate.closure() >= 0
        && coordinate.closure() < tree.mechanism().closures().size()
        && tree.mechanism().closures().get(coordinate.closure()) instanceof JointClosure closure) {
      return new CutJoint(tree, closure.joint());
    }
    throw new IllegalArgumentException(
        "closure " + coordinate.closure() + " is no joint and has no coordinates");
  }

  /**
   * Returns the component among the joint's velocities that is the rate of a position.
   *
   * @throws IllegalArgumentException if it is an Euler parameter, or does not exist
   */
  public static int velocityOfPosition(CutJoint cut, int component) {
    Joint joint = cut.joint();
    int surplus = joint.type().positionCount() - joint.type().velocityCount();
    int velocity = component - surplus;
    boolean euler = surplus > 0 && component < 4;
    if (euler || component < 0 || component >= joint.type().positionCount()) {
      throw new IllegalArgumentException(
          "position " + component + " of the cut joint " + joint.name() + " cannot be used here");
    }
    return velocity;
  }

  /** Returns the position at the start, from which angles are unwrapped. */
  public static double start(CutJoint cut, int position) {
    double[] start = new double[cut.joint().type().positionCount()];
    cut.joint().initialPositions(start, 0);
    return start[position];
  }

  /** Returns the motion between the joint's bodies, in the frames of the coordinates' gradients. */
  public static FrameMotion frames(TreeMotion motion, CutJoint cut) {
    Attachment at = cut.joint().attachment();
    boolean backwards = motion.tree().linkOf(at.parent()) != cut.relative().linkA();
    BodyFrame parent = frame(new BodyPoint(at.parent(), at.parentPoint()));
    BodyFrame child = frame(new BodyPoint(at.child(), at.childPoint()));
    return backwards
        ? new FrameMotion(motion, child, parent)
        : new FrameMotion(motion, parent, child);
  }

  private static BodyFrame frame(BodyPoint point) {
    return new BodyFrame(point.body(), point.position(), Rotation.IDENTITY);
  }
}
