package org.mechservice.mechml.resolve.joint;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.mechservice.mechml.diagnosis.Diagnostics;
import org.mechservice.mechml.diagnosis.Phrase;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.expression.FormulaEvaluation;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.MotionJump;
import org.mechservice.solver.mechanism.PrescribedMotion;
import org.mechservice.solver.mechanism.closure.JointClosure;
import org.mechservice.solver.mechanism.closure.LoopClosure;

/**
 * Refuses prescribed motions that no mechanism can follow: those whose position jumps, and those
 * whose position, velocity or acceleration is not finite at the start of the run.
 */
public final class MotionCheck {
  private static final MathContext DIGITS = new MathContext(6);

  /** Jumps of this size, in SI units, or larger come from poles; the message omits their size. */
  private static final double POLE = 1e12;

  private MotionCheck() {}

  /**
   * Reports the first jump of each driven joint, or the quantity that is not finite at its start.
   *
   * @param links the joints of the file
   * @param mechanism the mechanism
   * @param run start and end
   * @param moves whether accelerations are needed; statics and kinematics need none
   */
  public static void of(
      List<JointLink> links,
      Mechanism mechanism,
      RunSettings run,
      boolean moves,
      Diagnostics diagnostics) {
    Set<String> told = new HashSet<>();
    for (MotionJump jump : mechanism.motionJumps(run.tStart(), run.tEnd())) {
      if ((jump.ofPosition() || jump.roundedAway()) && told.add(jump.joint())) {
        report(links, jump.joint(), jump.ofPosition() ? text(jump) : corner(jump), diagnostics);
      }
    }
    for (PrescribedMotion motion : mechanism.motions()) {
      String joint = mechanism.joints().get(motion.joint()).name();
      if (!told.contains(joint)) {
        atStart(mechanism, motion.coordinates(), run.tStart(), moves)
            .ifPresent(text -> report(links, joint, text, diagnostics));
      }
    }
    for (LoopClosure closure : mechanism.closures()) {
      if (closure instanceof JointClosure cut && !told.contains(cut.name())) {
        atStart(mechanism, cut.motion(), run.tStart(), moves)
            .ifPresent(text -> report(links, cut.name(), text, diagnostics));
      }
    }
  }

  private static void report(
      List<JointLink> links, String joint, String text, Diagnostics diagnostics) {
    links.stream()
        .filter(link -> link.element().required("name").equals(joint))
        .flatMap(link -> link.start().stream())
        .findFirst()
        .ifPresent(
            element ->
                diagnostics.error(
                    MessageCode.MOTION_JUMPS,
                    element.position(),
                    Phrase.of("%s: %s", element.label(), text)));
  }

  private static Optional<String> atStart(
      Mechanism mechanism, List<Expression> coordinates, double t, boolean moves) {
    FormulaEvaluation motion = new FormulaEvaluation(coordinates);
    for (int i = 0; i < motion.leaves().size(); i++) {
      if (motion.leaves().get(i) instanceof Expression.ParameterValue parameter) {
        motion.setLeaf(i, mechanism.parameters().get(parameter.index()).value(), 0, 0);
      } else {
        motion.setLeaf(i, t, 1, 0);
      }
    }
    motion.derivatives();
    motion.rates();
    for (int i = 0; i < coordinates.size(); i++) {
      String missing =
          !Double.isFinite(motion.value(i))
              ? "position"
              : !Double.isFinite(motion.rate(i))
                  ? "velocity"
                  : moves && !Double.isFinite(motion.secondRate(i)) ? "acceleration" : "";
      if (!missing.isEmpty()) {
        return Optional.of(
            Phrase.of(
                "the %s of the prescribed motion has no finite value at the start, t = %s s; write"
                    + " a motion with a finite one, such as t^2 or smoothStep(t/0.1), or start the"
                    + " run later",
                missing, number(t)));
      }
    }
    return Optional.empty();
  }

  private static String text(MotionJump jump) {
    String what =
        Math.abs(jump.size()) < POLE
            ? Phrase.of(
                "the prescribed motion jumps at t = %s s, by %s in SI units, which no mechanism can"
                    + " follow",
                number(jump.time()), number(jump.size()))
            : Phrase.of(
                "the prescribed motion has no finite value near t = %s s", number(jump.time()));
    return Phrase.of(
        "%s; write a continuous motion, such as smoothStep((t-1)/0.1) instead of step(t-1)", what);
  }

  private static String corner(MotionJump jump) {
    return Phrase.of(
        "the velocity of the prescribed motion jumps at t = %s s, by %s in SI units, and its"
            + " formula has no finite velocity near the jump; write the corner with abs, min or"
            + " max",
        number(jump.time()), number(jump.size()));
  }

  /** Returns a number rounded to six digits, without trailing zeros. */
  private static String number(double x) {
    BigDecimal rounded = new BigDecimal(x).round(DIGITS).stripTrailingZeros();
    return rounded.scale() < 0 && rounded.scale() > -6
        ? rounded.toPlainString()
        : rounded.toString();
  }
}
