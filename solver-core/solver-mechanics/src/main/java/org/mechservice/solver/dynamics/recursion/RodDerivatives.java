package org.mechservice.solver.dynamics.recursion;

import static org.mechservice.solver.spatial.Blocks.addCross;
import static org.mechservice.solver.spatial.Blocks.apply;
import static org.mechservice.solver.spatial.Blocks.applyTransposed;
import static org.mechservice.solver.spatial.Blocks.cross;

import java.util.Arrays;
import org.mechservice.solver.kinematics.TreeGeometry;
import org.mechservice.solver.kinematics.TreeMotion;

/**
 * Derivatives of the inertia force at a rod's end by the motion of the links at both ends.
 * Workspace of one thread.
 *
 * <p>The acceleration of the end at r minus gravity, in the axes of its link, is p = u' + ω' × r +
 * ω × (u + ω × r) − g. The wrench on the link of one end is −(m/6) [r × f; f] with f = 2 p + R p_o,
 * where p_o belongs to the other end and R transforms from the other link's axes to this one's.
 */
public final class RodDerivatives {
  private static final int SIZE = 36;

  private final TreeGeometry tree;
  private final TreeMotion motion;
  private final NewtonEuler newtonEuler;
  private final double[] byPlace = new double[SIZE];
  private final double[] byVelocity = new double[SIZE];
  private final double[] byAcceleration = new double[SIZE];

  /** Acceleration of the other end in its own axes, and in those of this end's link. */
  private final double[] p = new double[3];

  private final double[] turned = new double[3];
  private final double[] twist = new double[6];
  private final double[] change = new double[6];
  private final double[] f = new double[3];
  private final double[] work = new double[3];
  private final double[] world = new double[3];

  public RodDerivatives(TreeMotion motion, NewtonEuler newtonEuler) {
    this.motion = motion;
    this.newtonEuler = newtonEuler;
    tree = motion.tree();
  }

  /**
   * Adds a rod's contribution at one end to the derivatives of M a + b.
   *
   * @param sixth m/6, kg
   * @param link this end's link
   * @param r this end from the reference point, in link axes, m
   * @param other the other end's link
   * @param s the other end from the reference point, in link axes, m
   */
  void add(
      LinkDerivatives target,
      double sixth,
      int link,
      double[] r,
      int rAt,
      int other,
      double[] s,
      int sAt) {
    if (link == TreeGeometry.ROOT) {
      return;
    }
    formOtherEnd(link, other, s, sAt);
    formByOwnLink(link, r, rAt);
    target.add(link, link, sixth, byPlace, byVelocity, byAcceleration);
    if (other != TreeGeometry.ROOT) {
      formByOtherLink(link, r, rAt, other, s, sAt);
      target.add(link, other, sixth, byPlace, byVelocity, byAcceleration);
    }
  }

  private void formOtherEnd(int link, int other, double[] s, int sAt) {
    if (other == TreeGeometry.ROOT) {
      for (int i = 0; i < 3; i++) {
        p[i] = -tree.gravityInRoot[i];
      }
    } else {
      endAcceleration(other, s, sAt, p);
    }
    motion.toWorld(other, p, 0, world, 0);
    motion.fromWorld(link, world, 0, turned, 0);
  }

  private void endAcceleration(int link, double[] r, int rAt, double[] out) {
    int at = 3 * link;
    System.arraycopy(motion.linearVelocity, at, work, 0, 3);
    addCross(motion.angularVelocity, at, r, rAt, work, 0);
    cross(motion.angularVelocity, at, work, 0, out, 0);
    addCross(motion.angularAcceleration, at, r, rAt, out, 0);
    for (int i = 0; i < 3; i++) {
      out[i] += motion.linearAcceleration[at + i] - newtonEuler.gravity[at + i];
    }
  }

  /**
   * Forms the derivative of f = 2 p + R p_o by this link: p by velocity and acceleration, R p_o by
   * rotation.
   */
  private void formByOwnLink(int link, double[] r, int rAt) {
    for (int column = 0; column < 6; column++) {
      unitTwist(column);
      cross(turned, 0, twist, 0, f, 0);
      store(byPlace, column, r, rAt, 1);
      changeByVelocity(link, r, rAt);
      store(byVelocity, column, r, rAt, 2);
      changeByAcceleration(r, rAt);
      store(byAcceleration, column, r, rAt, 2);
    }
  }

  /**
   * Forms the derivative of f by the other link: R p_o by rotation, p_o by velocity and
   * acceleration.
   */
  private void formByOtherLink(int link, double[] r, int rAt, int other, double[] s, int sAt) {
    for (int column = 0; column < 6; column++) {
      unitTwist(column);
      cross(twist, 0, p, 0, f, 0);
      turn(link, other);
      store(byPlace, column, r, rAt, 1);
      changeByVelocity(other, s, sAt);
      turn(link, other);
      store(byVelocity, column, r, rAt, 1);
      changeByAcceleration(s, sAt);
      turn(link, other);
      store(byAcceleration, column, r, rAt, 1);
    }
  }

  private void unitTwist(int column) {
    Arrays.fill(twist, 0);
    twist[column] = 1;
  }

  /** δp for a velocity δV, with the δA = −V × δV that comes with it. */
  private void changeByVelocity(int link, double[] r, int rAt) {
    double[] omega = motion.angularVelocity;
    double[] u = motion.linearVelocity;
    int at = 3 * link;
    // −V × δV = δV × V
    cross(twist, 0, omega, at, change, 0);
    cross(twist, 0, u, at, change, 3);
    addCross(twist, 3, omega, at, change, 3);
    System.arraycopy(change, 3, f, 0, 3);
    addCross(change, 0, r, rAt, f, 0);
    // δω × (u + ω × r) + ω × (δu + δω × r)
    System.arraycopy(u, at, work, 0, 3);
    addCross(omega, at, r, rAt, work, 0);
    addCross(twist, 0, work, 0, f, 0);
    System.arraycopy(twist, 3, work, 0, 3);
    addCross(twist, 0, r, rAt, work, 0);
    addCross(omega, at, work, 0, f, 0);
  }

  private void changeByAcceleration(double[] r, int rAt) {
    System.arraycopy(twist, 3, f, 0, 3);
    addCross(twist, 0, r, rAt, f, 0);
  }

  /** Turns f from the other link's axes to the own. */
  private void turn(int link, int other) {
    apply(motion.worldRotation, 9 * other, f, 0, world, 0);
    applyTransposed(motion.worldRotation, 9 * link, world, 0, f, 0);
  }

  /** Writes factor · [r × f; f] into a column. */
  private void store(double[] block, int column, double[] r, int rAt, double factor) {
    cross(r, rAt, f, 0, work, 0);
    for (int i = 0; i < 3; i++) {
      block[6 * i + column] = factor * work[i];
      block[6 * (3 + i) + column] = factor * f[i];
    }
  }
}
