package org.mechservice.solver.dynamics.recursion;

import static org.mechservice.solver.spatial.Blocks.addCross;
import static org.mechservice.solver.spatial.Blocks.apply;
import static org.mechservice.solver.spatial.Blocks.congruence;
import static org.mechservice.solver.spatial.Blocks.cross;
import static org.mechservice.solver.spatial.Blocks.dot;

import org.mechservice.solver.dynamics.tree.TreeMatrix;
import org.mechservice.solver.dynamics.tree.TreePattern;
import org.mechservice.solver.kinematics.LinkKind;
import org.mechservice.solver.kinematics.TreeGeometry;
import org.mechservice.solver.kinematics.TreeMotion;

/**
 * Composite rigid-body inertias: each link with all links beyond it as one rigid body, in link axes
 * about the link's reference point. Workspace of one thread.
 */
public final class CompositeInertias {
  private final TreeGeometry tree;
  private final TreeMotion motion;
  private final LinkInertias links;

  /** Mass, kg. */
  private final double[] mass;

  /** First moment, kg·m, 3 per link. */
  private final double[] moment;

  /** Second moment, kg·m², 9 per link. */
  private final double[] second;

  private final double[] work = new double[21];

  /** I S of a velocity, carried towards the root. */
  private final double[] momentum = new double[6];

  public CompositeInertias(TreeMotion motion, LinkInertias links) {
    this.motion = motion;
    this.links = links;
    tree = motion.tree();
    mass = new double[tree.linkCount];
    moment = new double[3 * tree.linkCount];
    second = new double[9 * tree.linkCount];
  }

  /** Forms all composites, from the leaves inwards, for the poses of the last sweep. */
  public void compose() {
    System.arraycopy(links.mass, 0, mass, 0, mass.length);
    System.arraycopy(links.moment, 0, moment, 0, moment.length);
    System.arraycopy(links.second, 0, second, 0, second.length);
    for (int link = tree.linkCount - 1; link >= 0; link--) {
      if (tree.parent[link] != TreeGeometry.ROOT) {
        addToParent(link);
      }
    }
  }

  /** m, h + m p, J + (2 pᵀh + m pᵀp) 1 − h pᵀ − p hᵀ − m p pᵀ, with h and J in parent axes. */
  private void addToParent(int link) {
    int parent = tree.parent[link];
    double m = mass[link];
    double[] p = motion.position;
    double[] r = motion.rotation;
    apply(r, 9 * link, moment, 3 * link, work, 0);
    double onDiagonal = 2 * dot(p, 3 * link, work, 0) + m * dot(p, 3 * link, p, 3 * link);
    mass[parent] += m;
    for (int i = 0; i < 3; i++) {
      double pi = p[3 * link + i];
      double hi = work[i] + m * pi;
      moment[3 * parent + i] += hi;
      for (int j = 0; j < 3; j++) {
        second[9 * parent + 3 * i + j] -= hi * p[3 * link + j] + pi * work[j];
      }
      second[9 * parent + 4 * i] += onDiagonal;
    }
    congruenceAdd(r, link, parent);
  }

  private void congruenceAdd(double[] r, int link, int parent) {
    // the link's own second moment stays: masses of its joint are asked for later
    congruence(r, 9 * link, second, 9 * link, work, 3, work, 12);
    for (int i = 0; i < 9; i++) {
      second[9 * parent + i] += work[3 + i];
    }
  }

  /**
   * Composes all and forms M: its elements M_kj = S_jᵀ X* I S_k between each velocity k of the
   * state and those of its ancestors (Featherstone 2008, §6.2), with the armatures on its diagonal.
   *
   * @param pattern of M, with room for these elements
   * @param mass overwritten
   */
  public void formMass(TreePattern pattern, TreeMatrix mass) {
    compose();
    mass.clear();
    for (int place = 0; place < pattern.size; place++) {
      formRow(place, pattern, mass);
    }
  }

  private void formRow(int place, TreePattern pattern, TreeMatrix mass) {
    int k = pattern.velocityAt[place];
    int link = tree.linkOfVelocity[k];
    applyTo(link, motion.subspace, 6 * k, momentum, 0);
    mass.setDiagonal(place, along(k) + tree.armature[k]);
    for (int i = link; i != TreeGeometry.ROOT; i = tree.parent[i]) {
      if (!tree.driven[i]) {
        // in the link of velocity k those before it alone
        int end = i == link ? k : tree.velocityAt[i] + tree.kind[i].velocityCount();
        for (int j = tree.velocityAt[i]; j < end; j++) {
          mass.setElement(pattern.find(place, pattern.placeOf[j]), along(j));
        }
      }
      motion.wrenches.toParent(i, momentum, 0);
    }
  }

  private double along(int velocity) {
    double[] s = motion.subspace;
    return dot(s, 6 * velocity, momentum, 0) + dot(s, 6 * velocity + 3, momentum, 3);
  }

  /**
   * Writes I x = [J ω + h × u; m u − h × ω] for x = [ω; u].
   *
   * @param out [angular; linear]; overwritten
   */
  public void applyTo(int link, double[] x, int ix, double[] out, int at) {
    apply(second, 9 * link, x, ix, out, at);
    addCross(moment, 3 * link, x, ix + 3, out, at);
    cross(x, ix, moment, 3 * link, out, at + 3);
    for (int i = 0; i < 3; i++) {
      out[at + 3 + i] += mass[link] * x[ix + 3 + i];
    }
  }

  /**
   * Returns the reference size of the pivots of a link's joint
   * (docs/theory/formulations.md#pivots).
   */
  public double scale(int link) {
    if (tree.kind[link] == LinkKind.SLIDE) {
      return mass[link];
    }
    double trace = second[9 * link] + second[9 * link + 4] + second[9 * link + 8];
    return trace + tree.pitch[link] * tree.pitch[link] * mass[link];
  }
}
