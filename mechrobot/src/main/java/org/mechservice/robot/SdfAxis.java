package org.mechservice.robot;

import java.util.Optional;
import org.mechservice.mechml.document.Element;
import org.mechservice.robot.Robot.Coordinate;
import org.mechservice.robot.Robot.Mimic;
import org.mechservice.robot.Robot.Range;
import org.mechservice.robot.Robot.Stop;

/** Properties of an axis of a joint in SDF: limits, a spring, damping, friction. */
final class SdfAxis {
  /** SDF writes no limit as a very large one, by default 1e16, in newer files as inf. */
  private static final double NO_LIMIT = 1e15;

  /** SDF's stiffness of a stop that is not given. */
  private static final double HARD = 1e8;

  private final Element axis;
  private final RobotNumbers numbers;

  SdfAxis(Element axis, RobotNumbers numbers) {
    this.axis = axis;
    this.numbers = numbers;
  }

  /**
   * Returns what acts along the axis.
   *
   * @param endless whether limits have no meaning at this joint
   * @param armature inertia of its motor as the axis feels it, kg or kg·m²
   * @param mimic the joint that it follows
   */
  Coordinate coordinate(boolean endless, double armature, Optional<Mimic> mimic) {
    Element dynamics = axis.child("dynamics").orElse(axis);
    return new Coordinate(
        endless ? Optional.empty() : axis.child("limit").flatMap(this::limits),
        stop(),
        numbers.text(dynamics, "spring_stiffness", 0),
        numbers.text(dynamics, "spring_reference", 0),
        numbers.text(dynamics, "damping", 0),
        numbers.text(dynamics, "friction", 0),
        armature,
        mimic);
  }

  /** A stop of SDF has a stiffness, N/m or N·m/rad, and a dissipation, its damping. */
  private Stop stop() {
    Optional<Element> limit = axis.child("limit");
    double stiffness = limit.map(one -> numbers.text(one, "stiffness", 0)).orElse(0.0);
    double damping = limit.map(one -> numbers.text(one, "dissipation", 0)).orElse(0.0);
    // 1e8 and 1 are what converters write for "hard".
    return stiffness > 0 && stiffness < HARD
        ? new Stop(0, 0, stiffness, Math.max(damping, 0))
        : Stop.ASSUMED;
  }

  private Optional<Range> limits(Element limit) {
    double lower = end(limit, "lower").orElse(Double.NEGATIVE_INFINITY);
    double upper = end(limit, "upper").orElse(Double.POSITIVE_INFINITY);
    if (Double.isInfinite(lower) && Double.isInfinite(upper)) {
      return Optional.empty();
    }
    if (lower > upper) {
      numbers.contradiction(limit, "lower is " + lower + " and upper " + upper + "; exchange them");
    }
    return Optional.of(new Range(lower, upper));
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
