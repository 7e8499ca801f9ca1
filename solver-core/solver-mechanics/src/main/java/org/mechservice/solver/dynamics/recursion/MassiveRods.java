package org.mechservice.solver.dynamics.recursion;

import static org.mechservice.solver.spatial.Blocks.addCross;
import static org.mechservice.solver.spatial.Blocks.dot;

import java.util.Arrays;
import java.util.List;
import org.mechservice.solver.dynamics.tree.TreeMatrix;
import org.mechservice.solver.dynamics.tree.TreePattern;
import org.mechservice.solver.kinematics.TreeGeometry;
import org.mechservice.solver.kinematics.TreeMotion;
import org.mechservice.solver.mechanism.closure.DistanceClosure;

/**
 * Uniform slender rods between points of two bodies, without spin about their own axes
 * (docs/theory/motion.md#bodies). With v_A, v_B the velocities of the ends the energy of a rod is
 * (m/6) (v_A·v_A + v_A·v_B + v_B·v_B), exactly, so the load on A is −(m/6) (2 a_A + a_B) + (m/2) g,
 * and correspondingly at B.
 *
 * <p>Workspace of one thread; nothing allocates after construction.
 */
public final class MassiveRods {
  /** Mass of a rod over that of a link at its end up to which at most three digits are lost. */
  private static final double MOST_BESIDE_LINKS = 1e3;

  private final TreeGeometry tree;
  private final DistanceClosure[] rods;
  private final int[] linkA;
  private final int[] linkB;

  /** Ends from the reference points of their links, in link axes, m, 3 per rod. */
  private final double[] endA;

  private final double[] endB;

  /**
   * Rows of the derivatives of the ends' velocities by the extended velocities: A x, y, z, B x, …
   */
  private final double[][] row = new double[6][];

  private final double[] wrench = new double[6];
  private final double[] unit = new double[3];
  private final double[] a = new double[3];
  private final double[] b = new double[3];
  private final double[] force = new double[3];

  /** Finds the rods of a tree's mechanism. */
  public MassiveRods(TreeGeometry tree) {
    this.tree = tree;
    List<DistanceClosure> found =
        tree.mechanism().closures().stream()
            .filter(DistanceClosure.class::isInstance)
            .map(DistanceClosure.class::cast)
            .filter(DistanceClosure::hasRod)
            .toList();
    rods = found.toArray(DistanceClosure[]::new);
    linkA = new int[rods.length];
    linkB = new int[rods.length];
    endA = new double[3 * rods.length];
    endB = new double[3 * rods.length];
    for (int i = 0; i < rods.length; i++) {
      linkA[i] = tree.linkOf(rods[i].point1().body());
      linkB[i] = tree.linkOf(rods[i].point2().body());
      tree.fromReference(rods[i].point1(), endA, 3 * i);
      tree.fromReference(rods[i].point2(), endB, 3 * i);
    }
    for (int i = 0; i < row.length; i++) {
      row[i] = new double[tree.velocityCount];
    }
  }

  /** Returns whether there are none. */
  public boolean isEmpty() {
    return rods.length == 0;
  }

  /**
   * Returns whether no rod is so heavy beside the links at its ends that {@link #compliance} loses
   * the digits of their inertia. Links without mass do not count: others have to move with them.
   */
  public boolean areLight() {
    for (int rod = 0; rod < rods.length; rod++) {
      for (int link : new int[] {linkA[rod], linkB[rod]}) {
        double mass = link == TreeGeometry.ROOT ? 0 : tree.mass[link];
        if (mass > 0 && rods[rod].rodMass() > MOST_BESIDE_LINKS * mass) {
          return false;
        }
      }
    }
    return true;
  }

  /**
   * Returns the number of equations B x = C μ by which the rods act as loads −Bᵀ μ of the links on
   * each other: three for the sum and three for the difference of the ends' accelerations.
   */
  public int equationCount() {
    return 6 * rods.length;
  }

  /** Returns C of an equation, 1/kg: 2/m for a sum, 6/m for a difference. */
  public double compliance(int equation) {
    return (equation % 6 < 3 ? 2 : 6) / rods[equation / 6].rodMass();
  }

  /** Returns the links at the ends of the rod of an equation; one may be the root. */
  public int[] ends(int equation) {
    return new int[] {linkA[equation / 6], linkB[equation / 6]};
  }

  /**
   * Adds the loads Bᵀ of an equation's multiplier: forces of 1/√2 along an axis of the world at
   * both ends, alike for a sum and opposite for a difference.
   *
   * @param motion after a sweep
   * @param onLinks [moment; force], 6 per link, in link axes at the reference points; added to
   */
  public void addLoads(TreeMotion motion, int equation, double[] onLinks) {
    int rod = equation / 6;
    Arrays.fill(force, 0);
    force[equation % 3] = Math.sqrt(0.5);
    motion.wrenches.addForceAtPoint(linkA[rod], endA, 3 * rod, force, 0, onLinks);
    if (equation % 6 >= 3) {
      force[equation % 3] = -force[equation % 3];
    }
    motion.wrenches.addForceAtPoint(linkB[rod], endB, 3 * rod, force, 0, onLinks);
  }

  /** Returns the links that rods couple, two numbers per rod, for {@link TreePattern}. */
  public int[] pairs() {
    int[] pairs = new int[2 * rods.length];
    for (int i = 0; i < rods.length; i++) {
      pairs[2 * i] = linkA[i];
      pairs[2 * i + 1] = linkB[i];
    }
    return pairs;
  }

  /**
   * Adds m/6 (2 J_Aᵀ J_A + J_Aᵀ J_B + J_Bᵀ J_A + 2 J_Bᵀ J_B) of each rod.
   *
   * @param motion after a sweep
   * @param mass of a pattern made with {@link #pairs()}; added to
   */
  public void addMass(TreeMotion motion, TreeMatrix mass) {
    for (int rod = 0; rod < rods.length; rod++) {
      formRows(motion, rod);
      for (int j = 0; j < tree.stateVelocityCount; j++) {
        if (moves(j)) {
          addColumn(j, rods[rod].rodMass() / 6, mass);
        }
      }
    }
  }

  private void formRows(TreeMotion motion, int rod) {
    for (int axis = 0; axis < 3; axis++) {
      Arrays.fill(row[axis], 0);
      Arrays.fill(row[3 + axis], 0);
      Arrays.fill(unit, 0);
      unit[axis] = 1;
      addRow(motion, linkA[rod], endA, 3 * rod, row[axis]);
      addRow(motion, linkB[rod], endB, 3 * rod, row[3 + axis]);
    }
  }

  private void addRow(TreeMotion motion, int link, double[] end, int at, double[] target) {
    motion.fromWorld(link, unit, 0, wrench, 3);
    wrench[0] = end[at + 1] * wrench[5] - end[at + 2] * wrench[4];
    wrench[1] = end[at + 2] * wrench[3] - end[at] * wrench[5];
    wrench[2] = end[at] * wrench[4] - end[at + 1] * wrench[3];
    motion.wrenches.addRow(link, wrench, 0, 1, target);
  }

  private boolean moves(int j) {
    for (double[] component : row) {
      if (component[j] != 0) {
        return true;
      }
    }
    return false;
  }

  private void addColumn(int j, double sixth, TreeMatrix mass) {
    for (int k = 0; k <= j; k++) {
      double sum = 0;
      for (int axis = 0; axis < 3; axis++) {
        double aj = row[axis][j];
        double bj = row[3 + axis][j];
        sum += (2 * aj + bj) * row[axis][k] + (aj + 2 * bj) * row[3 + axis][k];
      }
      if (sum != 0) {
        mass.add(j, k, sixth * sum);
      }
    }
  }

  /**
   * Adds weight and inertia forces for the accelerations of the last acceleration sweep.
   *
   * @param motion after a sweep and an acceleration sweep
   * @param onLinks [moment; force], 6 per link, in link axes at the reference points; added to
   */
  public void addForces(TreeMotion motion, double[] onLinks) {
    for (int rod = 0; rod < rods.length; rod++) {
      motion.points.acceleration(linkA[rod], endA, 3 * rod, a, 0);
      motion.points.acceleration(linkB[rod], endB, 3 * rod, b, 0);
      double sixth = rods[rod].rodMass() / 6;
      for (int i = 0; i < 3; i++) {
        force[i] = sixth * (3 * tree.gravity[i] - 2 * a[i] - b[i]);
      }
      motion.wrenches.addForceAtPoint(linkA[rod], endA, 3 * rod, force, 0, onLinks);
      for (int i = 0; i < 3; i++) {
        force[i] = sixth * (3 * tree.gravity[i] - a[i] - 2 * b[i]);
      }
      motion.wrenches.addForceAtPoint(linkB[rod], endB, 3 * rod, force, 0, onLinks);
    }
  }

  /**
   * Adds the derivatives of the inertia forces and weights, as parts of M a + b.
   *
   * @param target of a pattern made with {@link #pairs()}
   */
  public void addDerivatives(RodDerivatives end, LinkDerivatives target) {
    for (int rod = 0; rod < rods.length; rod++) {
      double sixth = rods[rod].rodMass() / 6;
      end.add(target, sixth, linkA[rod], endA, 3 * rod, linkB[rod], endB, 3 * rod);
      end.add(target, sixth, linkB[rod], endB, 3 * rod, linkA[rod], endA, 3 * rod);
    }
  }

  /** Returns the kinetic energy of all rods after a sweep, J. */
  public double kineticEnergy(TreeMotion motion) {
    double energy = 0;
    for (int rod = 0; rod < rods.length; rod++) {
      motion.points.velocity(linkA[rod], endA, 3 * rod, a, 0);
      motion.points.velocity(linkB[rod], endB, 3 * rod, b, 0);
      for (int i = 0; i < 3; i++) {
        energy += rods[rod].rodMass() / 6 * (a[i] * a[i] + a[i] * b[i] + b[i] * b[i]);
      }
    }
    return energy;
  }

  /** Returns the potential energy of all rods after a sweep, from the world's origin, J. */
  public double potentialEnergy(TreeMotion motion) {
    double energy = 0;
    for (int rod = 0; rod < rods.length; rod++) {
      motion.points.position(linkA[rod], endA, 3 * rod, a, 0);
      motion.points.position(linkB[rod], endB, 3 * rod, b, 0);
      for (int i = 0; i < 3; i++) {
        energy -= rods[rod].rodMass() / 2 * tree.gravity[i] * (a[i] + b[i]);
      }
    }
    return energy;
  }

  /**
   * Adds the momentum of all rods after a sweep: m/2 (v_A + v_B), and m/6 (2 r_A × v_A + r_A × v_B
   * + r_B × v_A + 2 r_B × v_B).
   *
   * @param point reference point of r, m
   * @param sum [linear; angular], world axes, N·s, N·m·s; added to
   * @param sizes sizes of the contributions, linear and angular; added to
   */
  void addMomentum(TreeMotion motion, double[] point, double[] sum, double[] sizes) {
    for (int rod = 0; rod < rods.length; rod++) {
      motion.points.velocity(linkA[rod], endA, 3 * rod, a, 0);
      motion.points.velocity(linkB[rod], endB, 3 * rod, b, 0);
      addShare(motion, rod, point, sum, sizes);
    }
  }

  /** Adds the rates of the momentum, after an acceleration sweep; the sizes include the weights. */
  void addMomentumRate(TreeMotion motion, double[] point, double[] sum, double[] sizes) {
    for (int rod = 0; rod < rods.length; rod++) {
      motion.points.acceleration(linkA[rod], endA, 3 * rod, a, 0);
      motion.points.acceleration(linkB[rod], endB, 3 * rod, b, 0);
      addShare(motion, rod, point, sum, sizes);
      double weight = rods[rod].rodMass() * Math.sqrt(dot(tree.gravity, 0, tree.gravity, 0));
      sizes[0] += weight;
      sizes[1] += weight * Math.sqrt(dot(force, 0, force, 0));
    }
  }

  /**
   * Adds a rod's contribution for the vectors {@code a} and {@code b} of its ends; leaves r_B in
   * {@code force}.
   */
  private void addShare(TreeMotion motion, int rod, double[] point, double[] sum, double[] sizes) {
    double sixth = rods[rod].rodMass() / 6;
    Arrays.fill(wrench, 0);
    for (int i = 0; i < 3; i++) {
      wrench[i] = 3 * sixth * (a[i] + b[i]);
    }
    addMoment(motion, linkA[rod], endA, 3 * rod, point, sixth, a, b);
    addMoment(motion, linkB[rod], endB, 3 * rod, point, sixth, b, a);
    for (int i = 0; i < 6; i++) {
      sum[i] += wrench[i];
    }
    sizes[0] += Math.sqrt(dot(wrench, 0, wrench, 0));
    sizes[1] += Math.sqrt(dot(wrench, 3, wrench, 3));
  }

  private void addMoment(
      TreeMotion motion,
      int link,
      double[] end,
      int at,
      double[] point,
      double sixth,
      double[] own,
      double[] other) {
    motion.points.position(link, end, at, force, 0);
    for (int i = 0; i < 3; i++) {
      force[i] -= point[i];
      unit[i] = sixth * (2 * own[i] + other[i]);
    }
    addCross(force, 0, unit, 0, wrench, 3);
  }
}
