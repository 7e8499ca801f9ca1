package org.mechservice.robot;

import java.util.Optional;
import org.mechservice.mechml.document.Element;
import org.mechservice.robot.Robot.Coordinate;
import org.mechservice.robot.Robot.Range;

/** Properties of an axis of a joint in SDF: limits, a spring, damping, friction. */
final class SdfAxis {
  /** SDF writes no limit as a very large one, by default 1e16, in newer files as inf. */
  private static final double NO_LIMIT = 1e15;

  private final Element axis;
  private final RobotNumbers numbers;
  private final ImportLosses losses;

  SdfAxis(Element axis, RobotNumbers numbers, ImportLosses losses) {
    this.axis = axis;
    this.numbers = numbers;
    this.losses = losses;
  }

  /**
   * Returns what acts along the axis.
   *
   * @param endless whether limits have no meaning at this joint
   */
  Coordinate coordinate(boolean endless) {
    Element dynamics = axis.child("dynamics").orElse(axis);
    axis.child("mimic").ifPresent(mimic -> losses.add(mimic, "the joint does not follow another"));
    return new Coordinate(
        endless ? Optional.empty() : axis.child("limit").flatMap(this::limits),
        numbers.text(dynamics, "spring_stiffness", 0),
        numbers.text(dynamics, "spring_reference", 0),
        numbers.text(dynamics, "damping", 0),
        numbers.text(dynamics, "friction", 0),
        Optional.empty());
  }

  private Optional<Range> limits(Element limit) {
    limit.children().stream()
        .filter(child -> !child.name().equals("lower") && !child.name().equals("upper"))
        .filter(child -> !isUnlimited(child.text()))
        .forEach(child -> losses.add(child, "has no meaning in MechML and is left out"));
    Optional<Double> lower = end(limit, "lower");
    Optional<Double> upper = end(limit, "upper");
    if (lower.isEmpty() && upper.isEmpty()) {
      return Optional.empty();
    }
    if (lower.isEmpty() || upper.isEmpty()) {
      losses.add(limit, "a limit on one side only is left out");
      return Optional.empty();
    }
    if (lower.get() > upper.get()) {
      numbers.contradiction(
          limit, "lower is " + lower.get() + " and upper " + upper.get() + "; exchange them");
    }
    return Optional.of(new Range(lower.get(), upper.get()));
  }

  private static boolean isUnlimited(String text) {
    return text.matches("[+-]?(?i:inf|infinity)") || text.equals("-1");
  }

  private Optional<Double> end(Element limit, String name) {
    Optional<Element> found = limit.child(name);
    if (found.isEmpty() || found.get().text().matches("[+-]?(?i:inf|infinity)")) {
      return Optional.empty();
    }
    double value = numbers.text(limit, name, 0);
    return Math.abs(value) < NO_LIMIT ? Optional.of(value) : Optional.empty();
  }
}
