package org.mechservice.robot;

import java.util.Optional;
import org.mechservice.solver.force.law.Side;

/** A coordinate of the mechanism that is a joint of URDF, with what URDF has along it. */
final class UrdfCoordinate {
  /** A range that no motion reaches, m: a prismatic joint of URDF must have one. */
  private static final double UNBOUNDED = 1e6;

  /** Limits of a motor, which URDF requires beside a range: MechML has none, N, N·m, m/s, rad/s. */
  private static final String NO_MOTOR = "1000000";

  /** The coordinate follows that of another joint: q = multiplier · other + offset. */
  private record Mimicry(String other, double multiplier, double offset) {}

  private final String name;
  private final boolean turns;
  private Optional<Double> lower = Optional.empty();
  private Optional<Double> upper = Optional.empty();
  private double damping;
  private double friction;
  private Optional<Mimicry> mimicry = Optional.empty();

  /**
   * @param name of the joint in URDF
   * @param turns whether it is an angle, rad, or else a length, m
   */
  UrdfCoordinate(String name, boolean turns) {
    this.name = name;
    this.turns = turns;
  }

  String name() {
    return name;
  }

  boolean turns() {
    return turns;
  }

  /** Returns the joint's type in URDF. */
  String type() {
    if (!turns) {
      return "prismatic";
    }
    return lower.isPresent() || upper.isPresent() ? "revolute" : "continuous";
  }

  /** Takes an end of the range; returns whether there was none on this side. */
  boolean stop(Side side, double position) {
    if (side == Side.ABOVE && upper.isEmpty()) {
      upper = Optional.of(position);
      return true;
    } else if (side == Side.BELOW && lower.isEmpty()) {
      lower = Optional.of(position);
      return true;
    }
    return false;
  }

  /** Adds damping, N·s/m or N·m·s/rad. */
  void damp(double more) {
    damping += more;
  }

  /** Takes Coulomb friction, N or N·m; returns whether there was none. */
  boolean rub(double coulomb) {
    if (friction != 0) {
      return false;
    }
    friction = coulomb;
    return true;
  }

  /** Makes the coordinate follow that of another joint; returns whether it followed none. */
  boolean follow(String other, double multiplier, double offset) {
    if (mimicry.isPresent()) {
      return false;
    }
    mimicry = Optional.of(new Mimicry(other, multiplier, offset));
    return true;
  }

  /** Returns whether programs that read the file begin at this position, as far as they say. */
  boolean startsAt(double position) {
    double assumed =
        Math.max(
            lower.orElse(Double.NEGATIVE_INFINITY),
            Math.min(upper.orElse(Double.POSITIVE_INFINITY), 0));
    return mimicry.isPresent() || position == assumed;
  }

  /** Adds range, damping, friction and coupling to the element of the joint. */
  void addTo(TagBuilder joint) {
    if (!type().equals("continuous")) {
      TagBuilder limit = new TagBuilder("limit");
      limit.set("lower", lower.orElse(-UNBOUNDED)).set("upper", upper.orElse(UNBOUNDED));
      joint.add(limit.set("effort", NO_MOTOR).set("velocity", NO_MOTOR));
    }
    if (damping != 0 || friction != 0) {
      TagBuilder dynamics = new TagBuilder("dynamics").set("damping", damping);
      joint.add(friction == 0 ? dynamics : dynamics.set("friction", friction));
    }
    mimicry.ifPresent(
        one ->
            joint.add(
                new TagBuilder("mimic")
                    .set("joint", one.other)
                    .set("multiplier", one.multiplier)
                    .set("offset", one.offset)));
  }
}
