package org.mechservice.solver.dynamics.recursion;

import static org.mechservice.solver.spatial.Blocks.apply;
import static org.mechservice.solver.spatial.Blocks.dot;

import org.mechservice.solver.kinematics.LinkKind;
import org.mechservice.solver.kinematics.TreeGeometry;
import org.mechservice.solver.kinematics.TreeMotion;

/**
 * The links beyond a joint as one rigid body, whose inertia is the reference size of a pivot of the
 * joint-space inertia. A pivot that is very small relative to it consists of rounding errors
 * (docs/theory/formulations.md#pivots). Workspace of one thread.
 */
public final class RigidComposites {
  private final TreeGeometry tree;
  private final LinkInertias inertias;

  /** Mass, kg. */
  private final double[] mass;

  /** First moment about the reference point in link axes, kg·m, 3 per link. */
  private final double[] moment;

  /** Trace of the inertia about the reference point, kg·m². */
  private final double[] trace;

  private final double[] turned = new double[3];

  public RigidComposites(TreeGeometry tree, LinkInertias inertias) {
    this.tree = tree;
    this.inertias = inertias;
    mass = new double[tree.linkCount];
    moment = new double[3 * tree.linkCount];
    trace = new double[tree.linkCount];
  }

  /** Starts the inward sweep with the links' own values. */
  public void start() {
    System.arraycopy(inertias.mass, 0, mass, 0, mass.length);
    System.arraycopy(inertias.moment, 0, moment, 0, moment.length);
    for (int link = 0; link < trace.length; link++) {
      double[] j = inertias.second;
      trace[link] = j[9 * link] + j[9 * link + 4] + j[9 * link + 8];
    }
  }

  /** Composes all links at a motion's poses. */
  public void compose(TreeMotion motion) {
    start();
    for (int link = trace.length - 1; link >= 0; link--) {
      if (tree.parent[link] != TreeGeometry.ROOT) {
        addToParent(motion, link);
      }
    }
  }

  /** Returns the pivot of the link's joint if all joints beyond were locked. */
  public double scale(int link) {
    if (tree.kind[link] == LinkKind.SLIDE) {
      return mass[link];
    }
    double pitch = tree.pitch[link];
    return trace[link] + pitch * pitch * mass[link];
  }

  /** Adds a link's composite to its parent: m, R h + m p, tr J + 4 pᵀ R h + 2 m pᵀ p. */
  public void addToParent(TreeMotion motion, int link) {
    int parent = tree.parent[link];
    double[] p = motion.position;
    double m = mass[link];
    apply(motion.rotation, 9 * link, moment, 3 * link, turned, 0);
    mass[parent] += m;
    trace[parent] +=
        trace[link] + 4 * dot(p, 3 * link, turned, 0) + 2 * m * dot(p, 3 * link, p, 3 * link);
    for (int i = 0; i < 3; i++) {
      moment[3 * parent + i] += turned[i] + m * p[3 * link + i];
    }
  }
}
