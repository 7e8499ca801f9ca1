package org.mechservice.sim.equations.kinematics;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.mechservice.solver.links.Link;
import org.mechservice.solver.symbol.Expressions;
import org.mechservice.solver.symbol.Program;
import org.mechservice.solver.symbol.Scalar;
import org.mechservice.solver.symbol.ScalarMatrix;
import org.mechservice.solver.symbol.ScalarVector;

/**
 * Places of links from an ancestor's origin, in the ancestor's axes: for ways through the tree that
 * are long or used often. Each link is computed once, from its parent, in a section of its own, so
 * that equal links share their code.
 */
public final class LinkPlaces {
  /**
   * Place of a link.
   *
   * @param axes from the link's computing axes to those of the ancestor
   * @param origin the link's computing origin from that of the ancestor, m
   */
  public record Place(ScalarMatrix axes, ScalarVector origin) {}

  private record Way(int ancestor, int link) {}

  private final Program program;
  private final Expressions expressions;
  private final LinkKinematics kinematics;
  private final List<Link> links;
  private final Map<Way, Place> known = new HashMap<>();

  LinkPlaces(Program program, LinkKinematics kinematics) {
    this.program = program;
    this.expressions = program.expressions();
    this.kinematics = kinematics;
    this.links = kinematics.mechanism().links();
  }

  /** Returns the place of a link from an ancestor of it, which may be the link or the root. */
  Place of(int ancestor, int index) {
    Scalar zero = expressions.zero();
    Scalar one = expressions.one();
    Place place =
        new Place(ScalarMatrix.of((i, j) -> i == j ? one : zero), ScalarVector.zero(expressions));
    if (index == ancestor || known.containsKey(new Way(ancestor, index))) {
      return known.getOrDefault(new Way(ancestor, index), place);
    }
    Deque<Integer> way = new ArrayDeque<>();
    for (int i = index; i != ancestor; i = links.get(i).parent()) {
      way.push(i);
    }
    for (int i : way) {
      Place parent = place;
      place = known.computeIfAbsent(new Way(ancestor, i), key -> beyond(parent, i));
    }
    program.section("Between the ways.", "pair");
    return place;
  }

  private Place beyond(Place parent, int index) {
    Link link = links.get(index);
    program.section(
        "Place: " + link.title() + ".\nR = R_p X, r = r_p + R_p s, and its motion",
        link.bodyLabel());
    // the velocities belong to the same section; programs that do not need them leave them out
    kinematics.velocity(index);
    kinematics.omega(index);
    ScalarVector origin =
        program.named(
            "r_" + link.bodyLabel(),
            parent.origin().plus(parent.axes().times(kinematics.origin(link))));
    return new Place(program.named("R_" + link.bodyLabel(), axes(parent, link)), origin);
  }

  /** Returns R_p X; if a row is constant, as in plane motion, another follows from two. */
  private ScalarMatrix axes(Place parent, Link link) {
    ScalarVector[] rows = new ScalarVector[3];
    int fixed = -1;
    for (int i = 0; i < 3; i++) {
      rows[i] = kinematics.toLink(link, parent.axes().row(i));
      if (rows[i].components().stream().allMatch(Scalar::isConstant)) {
        fixed = i;
      }
    }
    if (fixed >= 0) {
      rows[(fixed + 2) % 3] = rows[fixed].cross(rows[(fixed + 1) % 3]);
    }
    return ScalarMatrix.of((i, j) -> rows[i].at(j));
  }
}
