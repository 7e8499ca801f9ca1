package org.mechservice.sim.build.dynamics;

import java.util.ArrayList;
import java.util.List;
import org.mechservice.solver.mechanism.Attachment;
import org.mechservice.solver.mechanism.Body;
import org.mechservice.solver.mechanism.Joint;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.spatial.InertiaTensor;
import org.mechservice.solver.spatial.Rotation;
import org.mechservice.solver.spatial.Vector3;

/**
 * Chooses the axes a body is computed in: z along its joint, and of those the ones that cost least.
 *
 * <p>Axes that change places cost nothing. A constant turn between parent and child, and a body or
 * child joint that no longer lies along its axes, cost the operations weighed here.
 */
final class ComputingAxes {
  /** Operations of one constant turn in all sweeps: three vectors and three matrices, twice. */
  private static final int TURN_COST = 110;

  /** Operations of one more component in the offset of a child joint. */
  private static final int OFFSET_COST = 25;

  /** Operations of one more component of the centre of mass. */
  private static final int CENTER_COST = 6;

  /** Operations of one more product of inertia. */
  private static final int PRODUCT_COST = 8;

  private ComputingAxes() {}

  /**
   * Returns the rotation from body axes to computing axes for the child of a joint.
   *
   * @param fromParentBody the same for its parent
   */
  static Rotation of(Mechanism mechanism, int joint, Rotation fromParentBody) {
    Attachment attachment = mechanism.joints().get(joint).attachment();
    Rotation inParent = fromParentBody.times(attachment.zeroRotation());
    Rotation best = Rotation.IDENTITY;
    int least = Integer.MAX_VALUE;
    for (Rotation candidate : candidates(mechanism.joints().get(joint), inParent)) {
      AxesChange change = AxesChange.of(inParent.times(candidate.transposed()));
      int cost = TURN_COST * change.turns().size() + cost(mechanism, joint, candidate);
      if (cost < least) {
        least = cost;
        best = candidate;
      }
    }
    return best;
  }

  /** Starts from the body's own axes and from the parent's, and takes the joint's axis to z. */
  private static List<Rotation> candidates(Joint joint, Rotation inParent) {
    Vector3 axis = joint.attachment().zeroRotation().transposed().apply(Links.axisOf(joint));
    List<Rotation> candidates = new ArrayList<>();
    for (Rotation start : List.of(Rotation.IDENTITY, inParent)) {
      for (Rotation permutation : Axes.cyclicPermutations()) {
        Rotation turned = permutation.times(start);
        candidates.add(Axes.snapped(Axes.toZ(turned.apply(axis)).times(turned)));
      }
    }
    return candidates;
  }

  private static int cost(Mechanism mechanism, int joint, Rotation frame) {
    Attachment attachment = mechanism.joints().get(joint).attachment();
    Body body = mechanism.bodies().get(attachment.child());
    InertiaTensor inertia = inFrame(frame, body.inertia());
    Vector3 center = inFrame(frame, body.centerOfMass().minus(attachment.childPoint()));
    int cost = PRODUCT_COST * nonZeros(new Vector3(inertia.xy(), inertia.xz(), inertia.yz()));
    cost += body.mass() == 0 ? 0 : CENTER_COST * nonZeros(center);
    for (Joint child : mechanism.joints()) {
      if (child.attachment().parent() == attachment.child()) {
        Vector3 offset = child.attachment().parentPoint().minus(attachment.childPoint());
        cost += OFFSET_COST * nonZeros(inFrame(frame, offset));
      }
    }
    return cost;
  }

  private static int nonZeros(Vector3 v) {
    return (v.x() == 0 ? 0 : 1) + (v.y() == 0 ? 0 : 1) + (v.z() == 0 ? 0 : 1);
  }

  /** Returns a vector in rotated axes; components that are rounding only become 0. */
  static Vector3 inFrame(Rotation frame, Vector3 v) {
    Vector3 rotated = frame.apply(v);
    double rounding = Axes.ROUNDING * v.norm();
    return new Vector3(
        withoutRounding(rotated.x(), rounding),
        withoutRounding(rotated.y(), rounding),
        withoutRounding(rotated.z(), rounding));
  }

  /**
   * Returns a tensor in rotated axes; products of inertia that are rounding only become 0, moments
   * that differ by rounding only become equal.
   */
  static InertiaTensor inFrame(Rotation frame, InertiaTensor inertia) {
    InertiaTensor rotated = inertia.in(frame);
    double rounding = Axes.ROUNDING * Math.abs(inertia.trace());
    double xx = withoutRounding(rotated.xx(), rounding);
    double yy = Math.abs(rotated.yy() - xx) <= rounding ? xx : rotated.yy();
    double zz = Math.abs(rotated.zz() - xx) <= rounding ? xx : rotated.zz();
    zz = Math.abs(zz - yy) <= rounding ? yy : zz;
    return new InertiaTensor(
        xx,
        withoutRounding(yy, rounding),
        withoutRounding(zz, rounding),
        withoutRounding(rotated.xy(), rounding),
        withoutRounding(rotated.xz(), rounding),
        withoutRounding(rotated.yz(), rounding));
  }

  private static double withoutRounding(double value, double rounding) {
    return Math.abs(value) <= rounding ? 0 : value;
  }
}
