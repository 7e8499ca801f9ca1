package org.mechservice.solver.links;

import java.util.ArrayList;
import java.util.List;
import org.mechservice.solver.kinematics.TreeGeometry;
import org.mechservice.solver.spatial.InertiaTensor;
import org.mechservice.solver.spatial.Rotation;
import org.mechservice.solver.spatial.Vector3;

/**
 * Chooses the computing axes of a link: z along its joint, x and y such that the program has the
 * fewest operations.
 *
 * <p>A permutation of axes costs nothing. The costs here are those of a constant rotation between
 * parent and child, and of a body or child joint that is not aligned with the axes.
 */
public final class ComputingAxes {
  /**
   * Operations of one constant rotation about a coordinate axis in all sweeps: three vectors and
   * three matrices, twice.
   */
  private static final int TURN_COST = 110;

  /** Operations of any other constant rotation. */
  private static final int ROTATION_COST = 300;

  /** Operations of one more component in the offset of a child joint. */
  private static final int OFFSET_COST = 25;

  /** Operations of one more component of the centre of mass. */
  private static final int CENTER_COST = 6;

  /** Operations of one more product of inertia. */
  private static final int PRODUCT_COST = 8;

  private final RigidGroups.MassProperties mass;
  private final Vector3 axis;
  private final List<Vector3> offsets;

  /**
   * @param offsets of the links that move on this one, from its carrier's point
   */
  ComputingAxes(TreeGeometry tree, RigidGroups groups, int link, List<Vector3> offsets) {
    this.mass = groups.massOf(link);
    this.axis = RigidGroups.vector(tree.axisInLink, 3 * link);
    this.offsets = offsets;
  }

  /**
   * Returns the rotation from the link's axes to computing axes.
   *
   * @param inParent from the link's axes at q = 0 to the parent's computing axes
   */
  Rotation choose(Rotation inParent) {
    Rotation best = Rotation.IDENTITY;
    int least = Integer.MAX_VALUE;
    for (Rotation candidate : candidates(inParent)) {
      AxesChange change = AxesChange.of(inParent.times(candidate.transposed()));
      int cost = cost(change) + cost(candidate);
      if (cost < least) {
        least = cost;
        best = candidate;
      }
    }
    return best;
  }

  /**
   * Returns the candidates: the link's own axes and the parent's, each with the joint's axis
   * rotated to z.
   */
  private List<Rotation> candidates(Rotation inParent) {
    List<Rotation> candidates = new ArrayList<>();
    for (Rotation start : List.of(Rotation.IDENTITY, inParent)) {
      for (Rotation permutation : Axes.cyclicPermutations()) {
        Rotation turned = permutation.times(start);
        candidates.add(Axes.snapped(Axes.toZ(turned.apply(axis)).times(turned)));
      }
    }
    return candidates;
  }

  private static int cost(AxesChange change) {
    if (change.isPermutation()) {
      return 0;
    }
    return change.turn().isPresent() ? TURN_COST : ROTATION_COST;
  }

  private int cost(Rotation frame) {
    InertiaTensor inertia = inFrame(frame, mass.inertia());
    int cost = PRODUCT_COST * nonZeros(new Vector3(inertia.xy(), inertia.xz(), inertia.yz()));
    cost += mass.mass() == 0 ? 0 : CENTER_COST * nonZeros(inFrame(frame, mass.center()));
    for (Vector3 offset : offsets) {
      cost += OFFSET_COST * nonZeros(inFrame(frame, offset));
    }
    return cost;
  }

  private static int nonZeros(Vector3 v) {
    return (v.x() == 0 ? 0 : 1) + (v.y() == 0 ? 0 : 1) + (v.z() == 0 ? 0 : 1);
  }

  /** Returns a vector in rotated axes; components that are rounding only become 0. */
  public static Vector3 inFrame(Rotation frame, Vector3 v) {
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
  public static InertiaTensor inFrame(Rotation frame, InertiaTensor inertia) {
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
