package org.mechservice.solver.force.formula;

import java.util.List;
import java.util.Optional;
import org.mechservice.solver.api.capability.Defects.Defect;
import org.mechservice.solver.catalogue.MessageCode;

/** Describes the subexpression of a force's formula that has no finite value. */
final class FormulaFinding {
  /** Number of fields of a line before the operands. */
  private static final int HEAD = 4;

  /**
   * Relative change within a step of about 1e-16 of the elapsed time that marks a force; rounding
   * causes 1e-15, a motion of 1e6 rad/s over 1 s causes 1e-10.
   */
  private static final double NOTICEABLE = 1e-8;

  /** Relative change between states 1e-7 apart that no practical force has. */
  private static final double STEEP = 0.01;

  private FormulaFinding() {}

  /**
   * Finds the first subexpression without a finite value.
   *
   * @param lines of {@link ForceFormulas}
   * @param values of its expressions; not modified
   */
  static Optional<Defect> of(double t, String lines, double[] values) {
    int at = 0;
    for (String line : lines.split("\n", -1)) {
      String[] fields = line.split("\t", -1);
      if (!Double.isFinite(values[at])) {
        return Optional.of(defect(t, fields, values, at));
      }
      at += fields.length - HEAD + 1;
    }
    return Optional.empty();
  }

  /**
   * Finds the force that changes most within a smallest possible step, if it changes more than by
   * rounding or by any smooth motion.
   *
   * @param here values at {@code t}; not modified
   * @param ahead values one step later; not modified
   */
  static Optional<Defect> tooFast(double t, String lines, double[] here, double[] ahead) {
    return tooFast(t, lines, here, ahead, NOTICEABLE);
  }

  /**
   * Finds the force that jumps, or is nearly vertical, within a step that failed the error test.
   *
   * @param here values at {@code t}; not modified
   * @param ahead values one step later; not modified
   */
  static Optional<Defect> jump(double t, String lines, double[] here, double[] ahead) {
    return tooFast(t, lines, here, ahead, STEEP);
  }

  private static Optional<Defect> tooFast(
      double t, String lines, double[] here, double[] ahead, double least) {
    return fastest(lines, here, ahead, least)
        .map(
            changed ->
                changed.defect(
                    MessageCode.STEP_TOO_SMALL,
                    "The error test fails at every step size: "
                        + changed.sentence(" within one", t),
                    "A pole, an overflow or a jump lies there: give the formula a bounded value"
                        + " and slope, make the jump an event, or end the run before."));
  }

  /**
   * Finds the force that changes most between neighbouring states, if it jumps or is nearly
   * vertical.
   *
   * @param here values at {@code t}; not modified
   * @param beside values at a state that differs slightly in one component; not modified
   */
  static Optional<Defect> tooSteep(double t, String lines, double[] here, double[] beside) {
    return fastest(lines, here, beside, STEEP)
        .map(
            changed ->
                changed.defect(
                    MessageCode.NEWTON_DIVERGES,
                    "The equations of an implicit step cannot be solved at any step size: "
                        + changed.sentence(" between neighbouring states", t),
                    "Give the formula a slope in place of the jump, such as tanh(x/eps) for"
                        + " signum(x), or make the jump an event."));
  }

  /** A force with two values. */
  private record Changed(List<String> fields, double here, double there) {
    String sentence(String where, double t) {
      return "the "
          + fields.get(1)
          + " "
          + fields.get(2)
          + " changes"
          + where
          + " from "
          + here
          + " at t = "
          + t
          + " s to "
          + there
          + ".";
    }

    Defect defect(MessageCode code, String cause, String advice) {
      return new Defect(code, "force " + fields.get(0), cause, advice);
    }
  }

  /** Returns the whole formula with the largest relative change; not finite counts as most. */
  private static Optional<Changed> fastest(
      String lines, double[] here, double[] there, double least) {
    double most = least;
    Optional<Changed> found = Optional.empty();
    int at = 0;
    for (String line : lines.split("\n", -1)) {
      String[] fields = line.split("\t", -1);
      double size = Math.max(Math.abs(here[at]), Math.abs(there[at]));
      double change = Math.abs(there[at] - here[at]) / size;
      boolean whole = fields.length == HEAD;
      if (whole && here[at] != there[at] && !(change <= most)) {
        most = Double.isNaN(change) ? Double.POSITIVE_INFINITY : change;
        found = Optional.of(new Changed(List.of(fields), here[at], there[at]));
      }
      at += fields.length - HEAD + 1;
    }
    return found;
  }

  private static Defect defect(double t, String[] fields, double[] values, int at) {
    StringBuilder cause = new StringBuilder("The ");
    cause.append(fields[1]).append(' ').append(fields[2]);
    cause.append(" has no finite value at t = ").append(t).append(" s: ");
    cause.append(fields[3]).append(" is ").append(values[at]);
    for (int i = HEAD; i < fields.length; i++) {
      cause.append(i == HEAD ? " for " : " and ").append(fields[i]).append(" = ");
      cause.append(values[at + 1 + i - HEAD]);
    }
    return new Defect(
        MessageCode.FORCE_NOT_FINITE,
        "force " + fields[0],
        cause.append('.').toString(),
        "Give the formula a finite value in all states near the motion, such as sqrt(max(x, 0)) or"
            + " a divisor that stays away from 0; or end the run before.");
  }
}
