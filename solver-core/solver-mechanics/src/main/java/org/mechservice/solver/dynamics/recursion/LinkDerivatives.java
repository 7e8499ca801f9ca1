package org.mechservice.solver.dynamics.recursion;

import static org.mechservice.solver.spatial.Blocks.dot;

import org.mechservice.solver.dynamics.tree.TreeSquare;
import org.mechservice.solver.kinematics.LinkKind;
import org.mechservice.solver.kinematics.TreeGeometry;
import org.mechservice.solver.kinematics.TreeMotion;

/**
 * Transforms derivatives of wrenches on links by motions of links into derivatives of joint forces
 * by joint coordinates. Workspace of one thread.
 *
 * <p>A displacement δ of an ancestor joint j moves a link by the twist S_j δ, changes its velocity
 * by ψ'_j δ and its acceleration by (ψ''_j − V × ψ'_j) δ; a change of v_j changes its velocity by
 * S_j and its acceleration by ψ'_j + S'_j − V × S_j, all in link axes (the columns are those of
 * {@code ResidualJacobian}). A wrench w on a link acts on its ancestor joints as Sᵀ w.
 */
public final class LinkDerivatives {
  private final TreeGeometry tree;
  private final TreeMotion motion;
  private final TreeSquare byPosition;
  private final TreeSquare byVelocity;

  /** ψ', ψ'' and ψ' + S', 6 per extended velocity. */
  private final double[] first;

  private final double[] second;
  private final double[] both;

  private final double[] place = new double[36];
  private final double[] velocity = new double[36];
  private final double[] acceleration = new double[36];
  private final double[] positionWrench = new double[6];
  private final double[] velocityWrench = new double[6];

  public LinkDerivatives(
      TreeMotion motion,
      TreeSquare byPosition,
      TreeSquare byVelocity,
      double[] first,
      double[] second,
      double[] both) {
    this.motion = motion;
    this.byPosition = byPosition;
    this.byVelocity = byVelocity;
    this.first = first;
    this.second = second;
    this.both = both;
    tree = motion.tree();
  }

  /**
   * Adds factor · Jᵀ_on (∂w by the place, velocity and acceleration of a link).
   *
   * @param byPlace 6 × 6 row by row, per twist of the link; not modified
   * @param byRate 6 × 6, per velocity, what the acceleration's −V × adds included; not modified
   * @param byAcceleration 6 × 6, or empty for none; not modified
   */
  public void add(
      int on, int by, double factor, double[] byPlace, double[] byRate, double[] byAcceleration) {
    System.arraycopy(byPlace, 0, place, 0, 36);
    System.arraycopy(byRate, 0, velocity, 0, 36);
    System.arraycopy(byAcceleration, 0, acceleration, 0, byAcceleration.length);
    boolean accelerated = byAcceleration.length > 0;
    for (int i = by; i != TreeGeometry.ROOT; i = tree.parent[i]) {
      int end = tree.velocityAt[i] + tree.kind[i].velocityCount();
      for (int j = tree.velocityAt[i]; j < end && !tree.driven[i]; j++) {
        formColumn(j, factor, accelerated);
        addColumn(on, j);
      }
      toParent(i, accelerated);
    }
  }

  private void formColumn(int j, double factor, boolean accelerated) {
    for (int r = 0; r < 6; r++) {
      double k = dot6(place, 6 * r, motion.subspace, 6 * j) + dot6(velocity, 6 * r, first, 6 * j);
      double c = dot6(velocity, 6 * r, motion.subspace, 6 * j);
      if (accelerated) {
        k += dot6(acceleration, 6 * r, second, 6 * j);
        c += dot6(acceleration, 6 * r, both, 6 * j);
      }
      positionWrench[r] = factor * k;
      velocityWrench[r] = factor * c;
    }
  }

  /** Adds Jᵀ of the two wrenches to column j; overwrites the wrenches. */
  private void addColumn(int on, int j) {
    for (int i = on; i != TreeGeometry.ROOT; i = tree.parent[i]) {
      int end = tree.velocityAt[i] + tree.kind[i].velocityCount();
      for (int k = tree.velocityAt[i]; k < end && !tree.driven[i]; k++) {
        byPosition.add(k, j, dot6(motion.subspace, 6 * k, positionWrench, 0));
        byVelocity.add(k, j, dot6(motion.subspace, 6 * k, velocityWrench, 0));
      }
      motion.wrenches.toParent(i, positionWrench, 0);
      motion.wrenches.toParent(i, velocityWrench, 0);
    }
  }

  /**
   * Transforms a row that multiplies a twist of the link into one that multiplies a twist of its
   * parent.
   */
  private void toParent(int link, boolean accelerated) {
    for (int r = 0; r < 36; r += 6) {
      motion.wrenches.toParent(link, place, r);
      motion.wrenches.toParent(link, velocity, r);
      if (accelerated) {
        motion.wrenches.toParent(link, acceleration, r);
      }
    }
  }

  /**
   * Adds factor · the derivative of a joint force by the pose and velocity of a link.
   *
   * @param on velocity of the state the force belongs to
   * @param byPlace 6 numbers; not modified
   * @param byRate 6 numbers; not modified
   */
  public void addToForce(int on, int by, double factor, double[] byPlace, double[] byRate) {
    for (int i = 0; i < 6; i++) {
      positionWrench[i] = factor * byPlace[i];
      velocityWrench[i] = factor * byRate[i];
    }
    for (int i = by; i != TreeGeometry.ROOT; i = tree.parent[i]) {
      int end = tree.velocityAt[i] + tree.kind[i].velocityCount();
      for (int j = tree.velocityAt[i]; j < end && !tree.driven[i]; j++) {
        double k =
            dot6(motion.subspace, 6 * j, positionWrench, 0) + dot6(first, 6 * j, velocityWrench, 0);
        byPosition.add(on, j, k);
        byVelocity.add(on, j, dot6(motion.subspace, 6 * j, velocityWrench, 0));
      }
      motion.wrenches.toParent(i, positionWrench, 0);
      motion.wrenches.toParent(i, velocityWrench, 0);
    }
  }

  /**
   * Adds factor · the derivative of a wrench by a coordinate, with all links held fixed.
   *
   * @param by velocity of the state
   * @param byPlace 6 numbers; not modified
   * @param byRate 6 numbers; not modified
   */
  public void addByCoordinate(int on, int by, double factor, double[] byPlace, double[] byRate) {
    for (int i = 0; i < 6; i++) {
      positionWrench[i] = factor * byPlace[i];
      velocityWrench[i] = factor * byRate[i];
    }
    for (int i = on; i != TreeGeometry.ROOT; i = tree.parent[i]) {
      int end = tree.velocityAt[i] + tree.kind[i].velocityCount();
      for (int k = tree.velocityAt[i]; k < end && !tree.driven[i]; k++) {
        addDirect(
            k,
            by,
            dot6(motion.subspace, 6 * k, positionWrench, 0),
            dot6(motion.subspace, 6 * k, velocityWrench, 0));
      }
      motion.wrenches.toParent(i, positionWrench, 0);
      motion.wrenches.toParent(i, velocityWrench, 0);
    }
  }

  /**
   * Adds the derivative of a joint force by a coordinate, with all links held fixed. The velocities
   * of a ball are in axes that do not turn with it, so this method subtracts in advance what {@code
   * ResidualJacobian.finish} adds for turning axes.
   *
   * @param on velocity of the state
   * @param by velocity of the state
   */
  public void addDirect(int on, int by, double byPlace, double byRate) {
    byPosition.add(on, by, byPlace);
    byVelocity.add(on, by, byRate);
    int link = tree.linkOfVelocity[by];
    if (tree.kind[link] == LinkKind.BALL && !tree.inverse[link] && byRate != 0) {
      int ball = tree.velocityAt[link];
      int c = by - ball;
      int next = ball + (c + 1) % 3;
      int last = ball + (c + 2) % 3;
      byPosition.add(on, last, -byRate * motion.v[next]);
      byPosition.add(on, next, byRate * motion.v[last]);
    }
  }

  private static double dot6(double[] a, int ia, double[] b, int ib) {
    return dot(a, ia, b, ib) + dot(a, ia + 3, b, ib + 3);
  }
}
