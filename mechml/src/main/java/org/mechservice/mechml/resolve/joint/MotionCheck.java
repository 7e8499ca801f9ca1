package org.mechservice.mechml.resolve.joint;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
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
 * Refuses prescribed motions that no mechanism can follow: those whose position jumps, those whose
 * position, velocity or acceleration is not finite at the start of the run, and measured Euler
 * parameters whose signs change from one row of their tables to the next.
 */
public final class MotionCheck {
  private static final MathContext DIGITS = new MathContext(6);

  /** Jumps of this size, in SI units, or larger come from poles; the message omits their size. */
  private static final double POLE = 1e12;

  /**
   * Norm of Euler parameters between two rows of their tables, over that at the rows, below which
   * their signs differ. Rows that are a rotation of β apart have cos β/4 in the middle, and sin β/4
   * if one of them has the other sign: 0.71 both for half a turn, above which nobody could tell.
   */
  private static final double LEAST_NORM = 0.6;

  /**
   * Parts of the time from one place of the formulas to the next at which the norm is looked at.
   */
  private static final int PARTS = 8;

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
        TurningPath.normOfTables(motion.coordinates())
            .flatMap(norm -> turnsOver(mechanism, norm, run))
            .ifPresent(
                text -> report(links, joint, MessageCode.NOT_EULER_PARAMETERS, text, diagnostics));
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
    report(links, joint, MessageCode.MOTION_JUMPS, text, diagnostics);
  }

  private static void report(
      List<JointLink> links, String joint, MessageCode code, String text, Diagnostics diagnostics) {
    links.stream()
        .filter(link -> link.element().required("name").equals(joint))
        .flatMap(link -> link.start().stream())
        .findFirst()
        .ifPresent(
            element ->
                diagnostics.error(
                    code, element.position(), Phrase.of("%s: %s", element.label(), text)));
  }

  /** Returns where Euler parameters come near zero between rows of about the same norm. */
  private static Optional<String> turnsOver(Mechanism mechanism, Expression norm, RunSettings run) {
    FormulaEvaluation formula = new FormulaEvaluation(List.of(norm));
    double[] times = times(mechanism, run);
    double[] norms = new double[times.length];
    for (int k = 0; k < times.length; k++) {
      setLeaves(formula, mechanism, times[k]);
      formula.values();
      norms[k] = formula.value(0);
    }
    double[] behind = new double[norms.length];
    double most = 0;
    for (int k = norms.length - 1; k >= 0; k--) {
      most = Math.max(most, norms[k]);
      behind[k] = most;
    }
    double before = 0;
    for (int k = 0; k < norms.length; k++) {
      before = Math.max(before, norms[k]);
      if (norms[k] < LEAST_NORM * Math.min(before, behind[k])) {
        return Optional.of(
            Phrase.of(
                "the Euler parameters fall to the norm %s near t = %s s, between rows of greater"
                    + " norm: their signs change from one row of the tables to the next. (e0; e1;"
                    + " e2; e3) and its negative are one orientation; give each row the sign with"
                    + " which its scalar product with the row before it is positive",
                number(norms[k]), number(times[k])));
      }
    }
    return Optional.empty();
  }

  /** Returns the places of the formulas in a run, and times between them. */
  private static double[] times(Mechanism mechanism, RunSettings run) {
    TreeSet<Double> places = new TreeSet<>(mechanism.timeJumps(run.tStart(), run.tEnd()));
    places.add(run.tStart());
    places.add(run.tEnd());
    List<Double> all = new ArrayList<>();
    for (double place : places) {
      if (!all.isEmpty()) {
        double last = all.get(all.size() - 1);
        for (int i = 1; i < PARTS; i++) {
          all.add(last + (place - last) * i / PARTS);
        }
      }
      all.add(place);
    }
    return all.stream().mapToDouble(Double::doubleValue).toArray();
  }

  private static void setLeaves(FormulaEvaluation formula, Mechanism mechanism, double t) {
    for (int i = 0; i < formula.leaves().size(); i++) {
      if (formula.leaves().get(i) instanceof Expression.ParameterValue parameter) {
        formula.setLeaf(i, mechanism.parameters().get(parameter.index()).value(), 0, 0);
      } else {
        formula.setLeaf(i, t, 1, 0);
      }
    }
  }

  private static Optional<String> atStart(
      Mechanism mechanism, List<Expression> coordinates, double t, boolean moves) {
    FormulaEvaluation motion = new FormulaEvaluation(coordinates);
    setLeaves(motion, mechanism, t);
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
