package org.mechservice.solver.dynamics.recursion;

import java.util.List;
import org.mechservice.solver.dynamics.tree.PivotCheck;
import org.mechservice.solver.kinematics.LinkKind;
import org.mechservice.solver.links.Link;
import org.mechservice.solver.links.Links;

/**
 * For each link a bound of the inertia that its joint moves with all joints beyond it locked, at
 * any position: a pivot well above it needs no closer look (docs/theory/formulations.md#pivots). As
 * long as no joint slides further than before, the bounds stay. Workspace of one thread.
 */
final class PivotBounds {
  private final List<Link> links;

  /** Distance that a sliding link may have gone, m: a metre more than at the start, or more. */
  private final double[] reach;

  private final double[] mass;
  private final double[] first;
  private final double[] trace;
  private final double[] clear;

  PivotBounds(List<Link> links) {
    this.links = links;
    reach = new double[links.size()];
    mass = new double[links.size()];
    first = new double[links.size()];
    trace = new double[links.size()];
    clear = new double[links.size()];
    for (int i = 0; i < reach.length; i++) {
      Link link = links.get(i);
      reach[i] = link.way() == 0 ? 0 : 1 + Math.abs(link.way() * link.initialPosition());
    }
    form();
  }

  /** Takes the displacement of a sliding link, m; the bounds include twice of it from then on. */
  void reached(int link, double way) {
    if (!(Math.abs(way) <= reach[link])) {
      reach[link] = 2 * Math.abs(way);
      form();
    }
  }

  /**
   * Sums, over the links beyond, masses m, first moments m ρ, and trace I + 2 m ρ², with ρ the
   * length of the way to the centre of mass.
   */
  private void form() {
    for (int i = 0; i < reach.length; i++) {
      Link link = links.get(i);
      double distance = link.centerOfMass().norm();
      mass[i] = link.mass();
      first[i] = link.mass() * distance;
      trace[i] = link.inertia().trace() + 2 * first[i] * distance;
    }
    for (int i = reach.length - 1; i >= 0; i--) {
      int parent = links.get(i).parent();
      if (parent != Links.ROOT) {
        double way = links.get(i).offset().norm() + reach[i];
        mass[parent] += mass[i];
        first[parent] += first[i] + way * mass[i];
        trace[parent] += trace[i] + way * (4 * first[i] + 2 * way * mass[i]);
      }
    }
    for (int i = 0; i < reach.length; i++) {
      Link link = links.get(i);
      double pitch = link.way();
      boolean slide = link.kind() == LinkKind.SLIDE;
      clear[i] = PivotCheck.WEAK * (slide ? mass[i] : trace[i] + pitch * pitch * mass[i]);
    }
  }

  /** Returns the value above which a pivot of a link's joint is neither zero nor weak. */
  double clear(int link) {
    return clear[link];
  }
}
