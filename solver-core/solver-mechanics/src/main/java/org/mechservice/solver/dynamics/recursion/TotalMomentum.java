package org.mechservice.solver.dynamics.recursion;

import static org.mechservice.solver.spatial.Blocks.addCross;
import static org.mechservice.solver.spatial.Blocks.apply;
import static org.mechservice.solver.spatial.Blocks.dot;

import java.util.Arrays;
import org.mechservice.solver.kinematics.TreeGeometry;
import org.mechservice.solver.kinematics.TreeMotion;

/**
 * Total linear and angular momentum of a mechanism, rods with mass included, and their rates: Σ m
 * v, Σ (r × m v + I ω) and Σ m a, Σ (r × m a + I α + ω × I ω), r from a point at rest in the world,
 * world axes. By Newton's and Euler's laws the rates equal the sum of gravity, external applied
 * forces and ground reactions. Workspace of one thread; nothing allocates after construction.
 */
public final class TotalMomentum {
  private final TreeGeometry tree;
  private final TreeMotion motion;
  private final MassiveRods rods;
  private final double weight;
  private final double[] place = new double[3];
  private final double[] rate = new double[3];
  private final double[] spin = new double[3];
  private final double[] turned = new double[6];

  /** The point that angular momentum is about, from the world's origin, m. */
  public final double[] point = new double[3];

  /** [linear; angular] of the last evaluation, N·s, N·m·s, or N, N·m; world axes. */
  public final double[] sum = new double[6];

  /** Sum of the sizes of the bodies' contributions to {@link #sum}: linear, angular. */
  public final double[] sizes = new double[2];

  /**
   * @param motion swept by the caller before each evaluation
   */
  public TotalMomentum(TreeMotion motion) {
    this.motion = motion;
    tree = motion.tree();
    rods = new MassiveRods(tree);
    weight = Math.sqrt(dot(tree.gravity, 0, tree.gravity, 0));
  }

  /** Moves the point to the centre of mass, or to the world's origin if there is no mass. */
  public void toCenterOfMass() {
    double mass = 0;
    Arrays.fill(point, 0);
    for (int link = 0; link < tree.linkCount; link++) {
      double one = tree.mass[link];
      if (one > 0) {
        mass += one;
        motion.points.position(link, tree.centerOfMass, 3 * link, place, 0);
        for (int i = 0; i < 3; i++) {
          // A running mean keeps the digits of a mechanism far from the origin.
          point[i] += (place[i] - point[i]) * (one / mass);
        }
      }
    }
  }

  /** Evaluates momentum after a sweep. */
  public void evaluateMomentum() {
    begin();
    for (int link = 0; link < tree.linkCount; link++) {
      motion.points.velocity(link, tree.centerOfMass, 3 * link, rate, 0);
      inertia(link, motion.angularVelocity, spin);
      add(link);
    }
    rods.addMomentum(motion, point, sum, sizes);
  }

  /**
   * Evaluates the rates after a sweep and an acceleration sweep. The sizes include the weights,
   * because rounding errors of accelerations are relative to them.
   */
  public void evaluateRate() {
    begin();
    for (int link = 0; link < tree.linkCount; link++) {
      motion.points.acceleration(link, tree.centerOfMass, 3 * link, rate, 0);
      inertia(link, motion.angularVelocity, turned);
      inertia(link, motion.angularAcceleration, spin);
      addCross(motion.angularVelocity, 3 * link, turned, 0, spin, 0);
      add(link);
      double heavy = tree.mass[link] * weight;
      sizes[0] += heavy;
      sizes[1] += heavy * Math.sqrt(dot(place, 0, place, 0));
    }
    rods.addMomentumRate(motion, point, sum, sizes);
  }

  private void begin() {
    Arrays.fill(sum, 0);
    Arrays.fill(sizes, 0);
  }

  /** I x of a link about its centre of mass, link axes. */
  private void inertia(int link, double[] vector, double[] out) {
    double[] i = tree.inertia;
    int at = 6 * link;
    double x = vector[3 * link];
    double y = vector[3 * link + 1];
    double z = vector[3 * link + 2];
    out[0] = i[at] * x + i[at + 3] * y + i[at + 4] * z;
    out[1] = i[at + 3] * x + i[at + 1] * y + i[at + 5] * z;
    out[2] = i[at + 4] * x + i[at + 5] * y + i[at + 2] * z;
  }

  /** Adds the link's contribution: its mass times {@code rate}, and {@code spin}. */
  private void add(int link) {
    motion.points.position(link, tree.centerOfMass, 3 * link, place, 0);
    apply(motion.worldRotation, 9 * link, spin, 0, turned, 3);
    for (int i = 0; i < 3; i++) {
      place[i] -= point[i];
      turned[i] = tree.mass[link] * rate[i];
    }
    addCross(place, 0, turned, 0, turned, 3);
    for (int i = 0; i < 6; i++) {
      sum[i] += turned[i];
    }
    sizes[0] += Math.sqrt(dot(turned, 0, turned, 0));
    sizes[1] += Math.sqrt(dot(turned, 3, turned, 3));
  }
}
