package org.mechservice.robot;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import org.mechservice.mechml.document.Element;
import org.mechservice.robot.MjcfForces.Site;
import org.mechservice.robot.Robot.BodyForce;
import org.mechservice.robot.Robot.Force;
import org.mechservice.robot.Robot.Mark;
import org.mechservice.solver.spatial.Vector3;

/**
 * The line of a spatial tendon over sites: straight from each to the next one. Its length is the
 * sum of the parts, of which those behind a pulley count less.
 */
final class MjcfLine {
  private static final List<String> AXES = List.of("x", "y", "z");

  /** A part between two marks, and how much of its length counts. */
  private record Part(Mark from, Mark to, double factor) {
    String difference(String component) {
      return "(" + to.part(component) + " - " + from.part(component) + ")";
    }

    String length() {
      return "sqrt("
          + String.join(" + ", AXES.stream().map(x -> difference(x) + "^2").toList())
          + ")";
    }

    String rate() {
      return "("
          + String.join(
              " + ", AXES.stream().map(x -> difference(x) + "*" + difference("v" + x)).toList())
          + ")/"
          + length();
    }
  }

  private final Element tendon;
  private final String name;
  private final List<Mark> marks = new ArrayList<>();
  private final List<Part> parts = new ArrayList<>();

  /**
   * @param name of the tendon, for the names of its marks
   */
  MjcfLine(Element tendon, String name) {
    this.tendon = tendon;
    this.name = name;
  }

  /** Adds a stretch of sites, one behind the other, of whose length a part counts. */
  void add(List<Site> sites, double factor) {
    Mark before = null;
    for (Site site : sites) {
      Mark mark = new Mark(tendon, name + " site " + marks.size(), site.link(), site.frame().at());
      marks.add(mark);
      if (before != null) {
        parts.add(new Part(before, mark, factor));
      }
      before = mark;
    }
  }

  /** Returns the points that the expressions name. */
  List<Mark> marks() {
    return marks;
  }

  /** Returns its length in MechML, m. */
  String length() {
    return sum(Part::length);
  }

  /** Returns the rate of its length in MechML, m/s. */
  String rate() {
    return sum(Part::rate);
  }

  private String sum(Function<Part, String> what) {
    return String.join(
        " + ",
        parts.stream()
            .map(
                part ->
                    (part.factor() == 1 ? "" : "(" + MechmlText.number(part.factor()) + ")*")
                        + what.apply(part))
            .toList());
  }

  /** Returns its length with the bodies in given places, m. */
  double length(Function<Mark, Vector3> place) {
    return parts.stream()
        .mapToDouble(
            part -> part.factor() * place.apply(part.to()).minus(place.apply(part.from())).norm())
        .sum();
  }

  /** Returns what each of its ends would move by if the line grew, with the bodies in places. */
  List<RobotInertia.Pull> pulls(Function<Mark, Vector3> place) {
    List<RobotInertia.Pull> all = new ArrayList<>();
    for (Part part : parts) {
      Vector3 along = place.apply(part.to()).minus(place.apply(part.from()));
      if (along.norm() > 0) {
        Vector3 pull = along.times(part.factor() / along.norm());
        all.add(new RobotInertia.Pull(part.to().link(), place.apply(part.to()), pull));
        all.add(
            new RobotInertia.Pull(part.from().link(), place.apply(part.from()), pull.negated()));
      }
    }
    return all;
  }

  /**
   * Returns the forces of a motor that makes the line longer.
   *
   * @param motor its element
   * @param owner a name for the forces
   * @param force in MechML, N
   */
  List<Force> forces(Element motor, String owner, String force) {
    Map<Mark, List<String>> all = new LinkedHashMap<>();
    for (Part part : parts) {
      String each = "(" + MechmlText.number(part.factor()) + ")*(" + force + ")/" + part.length();
      for (Mark end : List.of(part.to(), part.from())) {
        List<String> sums = all.computeIfAbsent(end, key -> new ArrayList<>());
        String sign = end.equals(part.to()) ? "" : "-";
        for (int i = 0; i < 3; i++) {
          String one = sign + each + "*" + part.difference(AXES.get(i));
          if (sums.size() <= i) {
            sums.add(one);
          } else {
            sums.set(i, sums.get(i) + " + " + one);
          }
        }
      }
    }
    List<Force> acting = new ArrayList<>();
    all.forEach(
        (mark, force3) ->
            acting.add(
                new BodyForce(
                    motor,
                    owner + " " + acting.size(),
                    mark.link(),
                    mark.at(),
                    false,
                    force3,
                    List.of())));
    return acting;
  }
}
