package org.mechservice.solver.dynamics.recursion;

import static org.mechservice.solver.spatial.Blocks.addCross;
import static org.mechservice.solver.spatial.Blocks.apply;
import static org.mechservice.solver.spatial.Blocks.cross;

import org.mechservice.solver.kinematics.TreeGeometry;
import org.mechservice.solver.kinematics.TreeMotion;

/**
 * Rigid-body inertias of the links about their reference points, in link axes. Immutable; callers
 * must not write to the shared arrays.
 */
public final class LinkInertias {
  /** Mass, kg. */
  final double[] mass;

  /** First moment m c, kg·m, 3 per link. */
  public final double[] moment;

  /** Second moment J = I_c − m [c]×[c]×, kg·m², 9 per link. */
  public final double[] second;

  /** Whether the link has neither mass nor inertia. */
  final boolean[] massless;

  public LinkInertias(TreeGeometry tree) {
    int n = tree.linkCount;
    mass = tree.mass;
    moment = new double[3 * n];
    second = new double[9 * n];
    massless = new boolean[n];
    for (int link = 0; link < n; link++) {
      fill(tree, link);
    }
  }

  private void fill(TreeGeometry tree, int link) {
    double m = mass[link];
    double x = tree.centerOfMass[3 * link];
    double y = tree.centerOfMass[3 * link + 1];
    double z = tree.centerOfMass[3 * link + 2];
    double[] i = tree.inertia;
    int ii = 6 * link;
    double[] j = second;
    int at = 9 * link;
    j[at] = i[ii] + m * (y * y + z * z);
    j[at + 4] = i[ii + 1] + m * (x * x + z * z);
    j[at + 8] = i[ii + 2] + m * (x * x + y * y);
    j[at + 1] = i[ii + 3] - m * x * y;
    j[at + 2] = i[ii + 4] - m * x * z;
    j[at + 5] = i[ii + 5] - m * y * z;
    j[at + 3] = j[at + 1];
    j[at + 6] = j[at + 2];
    j[at + 7] = j[at + 5];
    moment[3 * link] = m * x;
    moment[3 * link + 1] = m * y;
    moment[3 * link + 2] = m * z;
    massless[link] = m == 0;
    for (int k = ii; k < ii + 6; k++) {
      massless[link] &= i[k] == 0;
    }
  }

  /** Returns the mean radius of the links about their joints, m; 1 m if none has mass. */
  public double meanRadius() {
    double sum = 0;
    int counted = 0;
    for (int link = 0; link < mass.length; link++) {
      double trace = second[9 * link] + second[9 * link + 4] + second[9 * link + 8];
      if (mass[link] > 0 && trace > 0) {
        sum += Math.sqrt(trace / (2 * mass[link]));
        counted++;
      }
    }
    return counted == 0 ? 1 : sum / counted;
  }

  /**
   * Writes the momentum I V of a link: [J ω + h × u; m u − h × ω] with h = m c.
   *
   * @param out [angular; linear], N·m·s, N·s; overwritten
   */
  public void momentum(int link, double[] omega, double[] u, double[] out, int at) {
    apply(second, 9 * link, omega, 3 * link, out, at);
    addCross(moment, 3 * link, u, 3 * link, out, at);
    cross(omega, 3 * link, moment, 3 * link, out, at + 3);
    for (int i = 0; i < 3; i++) {
      out[at + 3 + i] += mass[link] * u[3 * link + i];
    }
  }

  /**
   * Writes the velocity part of the inertia force, V ×* (I V) = [ω × n + u × l; ω × l].
   *
   * @param work 6 numbers; overwritten with the momentum [n; l]
   * @param out [moment; force] at 6 · link, N·m, N; overwritten
   */
  void velocityForce(TreeMotion motion, int link, double[] work, double[] out) {
    double[] omega = motion.angularVelocity;
    double[] u = motion.linearVelocity;
    momentum(link, omega, u, work, 0);
    cross(omega, 3 * link, work, 0, out, 6 * link);
    addCross(u, 3 * link, work, 3, out, 6 * link);
    cross(omega, 3 * link, work, 3, out, 6 * link + 3);
  }
}
