package org.mechservice.mechml.resolve;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.mechservice.mechml.diagnosis.Diagnostics;
import org.mechservice.mechml.diagnosis.MessageCode;
import org.mechservice.mechml.diagnosis.Phrase;
import org.mechservice.mechml.document.Element;
import org.mechservice.solver.mechanism.MotionJump;

/** Refuses prescribed motions whose position jumps: no mechanism can follow, whatever the force. */
final class MotionCheck {
  private static final MathContext DIGITS = new MathContext(6);

  /** Size of a jump, in SI units, that only a pole makes; that next to it is no number to tell. */
  private static final double POLE = 1e12;

  private MotionCheck() {}

  /** Reports the first jump of each driven joint. */
  static void of(List<JointLink> links, List<MotionJump> jumps, Diagnostics diagnostics) {
    Set<String> told = new HashSet<>();
    for (MotionJump jump : jumps) {
      if (jump.ofPosition() && told.add(jump.joint())) {
        links.stream()
            .filter(link -> link.element().required("name").equals(jump.joint()))
            .flatMap(link -> link.start().stream())
            .findFirst()
            .ifPresent(
                element ->
                    diagnostics.error(
                        MessageCode.MOTION_JUMPS, element.place(), text(element, jump)));
      }
    }
  }

  private static String text(Element element, MotionJump jump) {
    String what =
        Math.abs(jump.size()) < POLE
            ? Phrase.of(
                "the motion driven jumps at t = %s s, by %s in SI units, and no mechanism can"
                    + " follow",
                number(jump.time()), number(jump.size()))
            : Phrase.of("the motion driven has no finite value near t = %s s", number(jump.time()));
    return Phrase.of(
        "%s: %s; write a motion that takes time, as smoothStep((t-1)/0.1) does in place of"
            + " step(t-1)",
        element.label(), what);
  }

  /** Returns six digits of a number, without zeros behind them. */
  private static String number(double x) {
    BigDecimal rounded = new BigDecimal(x).round(DIGITS).stripTrailingZeros();
    return rounded.scale() < 0 && rounded.scale() > -6
        ? rounded.toPlainString()
        : rounded.toString();
  }
}
