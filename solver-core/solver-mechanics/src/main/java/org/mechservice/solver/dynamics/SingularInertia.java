package org.mechservice.solver.dynamics;

import static org.mechservice.solver.spatial.Blocks.addCross;
import static org.mechservice.solver.spatial.Blocks.dot;

import java.util.Arrays;
import java.util.Locale;
import java.util.Optional;
import org.mechservice.solver.api.capability.ExplicitModel;
import org.mechservice.solver.dynamics.recursion.TreeSteps;
import org.mechservice.solver.kinematics.TreeGeometry;
import org.mechservice.solver.kinematics.TreeMotion;
import org.mechservice.solver.mechanism.Mechanism;

/**
 * A motion of an open tree that its inertia does not resist, or resists by less than double
 * precision can tell from the inertia of what hangs on its first joint: that joint moves, and those
 * beyond it follow such that the kinetic energy is least. It is found as a zero pivot; the energy
 * itself is then summed over the bodies, without the difference of large numbers that the pivot is,
 * and tells the two cases apart.
 */
public final class SingularInertia {
  /** Largest number of velocities for which the joints that follow are computed. */
  private static final int MOST_VELOCITIES = 2000;

  /**
   * Part of an energy that is rounding: the square of 64 rounding units of the velocities, as of
   * the pivots in {@link org.mechservice.solver.dynamics.tree.PivotCheck}.
   */
  private static final double ROUNDING = Math.pow(64 * Math.ulp(1.0), 2);

  private final TreeGeometry tree;
  private final int velocity;
  private final double[] motion;

  /** Energies of the links in this motion, and while the first joint moves alone, J. */
  private final double[] energies;

  private final double[] alone;

  private SingularInertia(TreeMotion at, double t, int velocity) {
    tree = at.tree();
    this.velocity = velocity;
    double[] first = new double[tree.stateVelocityCount];
    first[velocity] = 1;
    motion = following(at, first);
    TreeMotion swept = new TreeMotion(tree);
    energies = energies(at, t, swept, motion);
    alone = energies(at, t, swept, first);
  }

  /**
   * Returns the one that a zero pivot shows.
   *
   * @param at motion of the tree, swept; not modified
   * @param t time of it, s
   * @param velocity index of the velocity whose pivot is zero
   */
  public static SingularInertia of(TreeMotion at, double t, int velocity) {
    return new SingularInertia(at, t, velocity);
  }

  /**
   * Looks for one at a place; the rods of loops and the loops are left out.
   *
   * @param at motion of the tree, swept; its accelerations are overwritten
   * @param t time of it, s
   * @return empty if every motion has inertia
   */
  public static Optional<SingularInertia> find(TreeMotion at, double t) {
    TreeGeometry tree = at.tree();
    double[] a = new double[tree.stateVelocityCount];
    int found =
        new TreeSteps(at).accelerations(new double[0], new double[tree.velocityCount], a, 0);
    return found == ExplicitModel.REGULAR ? Optional.empty() : Optional.of(of(at, t, found));
  }

  /** Returns the motion in which those beyond follow the first; itself if that is not clear. */
  private static double[] following(TreeMotion at, double[] first) {
    if (first.length <= MOST_VELOCITIES) {
      SemiRecursive work = new SemiRecursive(at);
      work.formMassMatrix();
      int found = work.factorMassMatrix();
      if (found != ExplicitModel.REGULAR && first[found] != 0) {
        return work.massMatrix().unresistedMotion(found);
      }
    }
    return first;
  }

  /** Returns the kinetic energies of the links in a motion at a place, J. */
  private double[] energies(TreeMotion at, double t, TreeMotion swept, double[] v) {
    // Driven joints move too; their part is the same with and without the motion.
    swept.sweep(t, at.q, new double[v.length]);
    double[] linear = swept.linearVelocity.clone();
    double[] angular = swept.angularVelocity.clone();
    swept.sweep(t, at.q, v);
    double[] energies = new double[tree.linkCount];
    double[] u = new double[3];
    for (int link = 0; link < tree.linkCount; link++) {
      for (int k = 3 * link; k < 3 * link + 3; k++) {
        angular[k] = swept.angularVelocity[k] - angular[k];
        u[k - 3 * link] = swept.linearVelocity[k] - linear[k];
      }
      addCross(angular, 3 * link, tree.centerOfMass, 3 * link, u, 0);
      energies[link] = 0.5 * (tree.mass[link] * dot(u, 0, u, 0) + twiceTurning(link, angular));
    }
    for (int k = 0; k < v.length; k++) {
      energies[tree.linkOfVelocity[k]] += 0.5 * tree.armature[k] * v[k] * v[k];
    }
    return energies;
  }

  /** Returns ωᵀ I ω, J. */
  private double twiceTurning(int link, double[] angular) {
    double[] i = tree.inertia;
    int at = 6 * link;
    double x = angular[3 * link];
    double y = angular[3 * link + 1];
    double z = angular[3 * link + 2];
    return i[at] * x * x
        + i[at + 1] * y * y
        + i[at + 2] * z * z
        + 2 * (i[at + 3] * x * y + i[at + 4] * x * z + i[at + 5] * y * z);
  }

  /** Returns the motion, one number per velocity of the state; not to be modified. */
  public double[] motion() {
    return motion;
  }

  /** Returns the index of the velocity of the first joint. */
  public int velocity() {
    return velocity;
  }

  /** Returns the energy that resists over that of the first joint's motion alone; 0 if none. */
  public double part() {
    double all = Arrays.stream(alone).sum();
    return all > 0 ? Arrays.stream(energies).sum() / all : 0;
  }

  /**
   * Returns whether there is inertia, of another body than most of what hangs there, of which
   * double precision has lost every digit. One body alone resists little where axes nearly
   * coincide.
   */
  public boolean isOfDifferentSizes() {
    return part() > ROUNDING && largest(energies) != largest(alone);
  }

  /** Returns the bodies of such different sizes and their ratio, as the rest of a sentence. */
  public String sizes() {
    return String.format(
        Locale.ROOT,
        "when the joints beyond move freely, only body %s resists, with one part in %.1e of what"
            + " hangs there, most of it body %s; double precision has 16 digits",
        body(largest(energies)),
        1 / part(),
        body(largest(alone)));
  }

  private String body(int link) {
    Mechanism mechanism = tree.mechanism();
    int body = tree.body[link];
    String name = mechanism.bodies().get(body).name();
    return String.format(Locale.ROOT, "\"%s\" (%.4g kg)", name, tree.mass[link]);
  }

  private int largest(double[] of) {
    int largest = 0;
    for (int link = 1; link < of.length; link++) {
      largest = of[link] > of[largest] ? link : largest;
    }
    return largest;
  }
}
