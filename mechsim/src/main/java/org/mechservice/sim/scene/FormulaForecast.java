package org.mechservice.sim.scene;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.OptionalDouble;
import org.mechservice.solver.api.RunSettings;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.expression.Expression.Call;
import org.mechservice.solver.expression.Expression.Constant;
import org.mechservice.solver.expression.Expression.CoordinateVelocity;
import org.mechservice.solver.expression.Expression.ParameterValue;
import org.mechservice.solver.expression.Expression.PointVelocity;
import org.mechservice.solver.expression.Expression.Time;
import org.mechservice.solver.expression.Function;
import org.mechservice.solver.expression.Tape;
import org.mechservice.solver.expression.TapeEvaluation;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.Origin;
import org.mechservice.solver.mechanism.PrescribedMotion;
import org.mechservice.solver.mechanism.force.ForceElement;

/**
 * Says before a run what in its formulas will keep steps tiny: {@code sin} of a time that runs
 * through millions of radians, {@code floor} that jumps as often, and a force that jumps with the
 * sign of a velocity, between whose two values a joint that should rest goes to and fro.
 */
final class FormulaForecast {
  /** Radians or jumps within a run that are worth a word, as in {@link StiffnessForecast}. */
  private static final double MANY = 1e6;

  private final Mechanism mechanism;
  private final RunSettings settings;
  private final Map<String, Finding> findings = new LinkedHashMap<>();

  private FormulaForecast(Mechanism mechanism, RunSettings settings) {
    this.mechanism = mechanism;
    this.settings = settings;
  }

  /** Returns what to tell the user, forces first; of each force or motion the first of a kind. */
  static List<Finding> of(Mechanism mechanism, RunSettings settings) {
    FormulaForecast forecast = new FormulaForecast(mechanism, settings);
    for (ForceElement force : mechanism.forces()) {
      String part = "force \"" + force.name() + "\"";
      BriefPush.formulas(force).forEach(f -> forecast.look(f, part, force.origin()));
    }
    for (PrescribedMotion motion : mechanism.motions()) {
      var joint = mechanism.joints().get(motion.joint());
      String part = "the motion of joint \"" + joint.name() + "\"";
      motion.coordinates().forEach(f -> forecast.look(f, part, joint.origin()));
    }
    return new ArrayList<>(forecast.findings.values());
  }

  private void look(Expression formula, String part, Origin origin) {
    if (formula instanceof Call call) {
      Expression argument = call.arguments().get(0);
      switch (call.function()) {
        case SIN, COS, FLOOR -> fast(call.function(), argument, part, origin);
        case SIGNUM, STEP -> chatter(call.function(), argument, part, origin);
        default -> {}
      }
    }
    BriefPush.operands(formula).forEach(operand -> look(operand, part, origin));
  }

  private void fast(Function function, Expression argument, String part, Origin origin) {
    OptionalDouble rate = rate(argument);
    double length = settings.tEnd() - settings.tStart();
    if (rate.isPresent() && Math.abs(rate.getAsDouble()) * length >= MANY) {
      String what = function == Function.FLOOR ? "jumps %.3g times a second" : "turns %.3g rad/s";
      add(
          "N-019",
          part,
          origin,
          String.format(
              Locale.ROOT,
              "a formula in %s "
                  + what
                  + "; a run of %.3g s needs some %.0e steps to follow it,"
                  + " whatever the integrator; leave out what is too fast to matter, or end the run"
                  + " earlier",
              part,
              Math.abs(rate.getAsDouble()),
              length,
              Math.abs(rate.getAsDouble()) * length));
    }
  }

  /** Returns the derivative at the start of an expression of time and parameters alone. */
  private OptionalDouble rate(Expression argument) {
    TapeEvaluation evaluation = new TapeEvaluation(new Tape(List.of(argument)));
    List<Expression> leaves = evaluation.tape().leaves();
    for (int i = 0; i < leaves.size(); i++) {
      if (leaves.get(i) instanceof Time) {
        evaluation.setLeaf(i, settings.tStart(), 1, 0);
      } else if (leaves.get(i) instanceof ParameterValue parameter) {
        evaluation.setLeaf(i, mechanism.parameters().get(parameter.index()).value(), 0, 0);
      } else if (!(leaves.get(i) instanceof Constant)) {
        return OptionalDouble.empty();
      }
    }
    evaluation.derivatives();
    evaluation.rates();
    return OptionalDouble.of(evaluation.rate(0));
  }

  private void chatter(Function function, Expression argument, String part, Origin origin) {
    if (dependsOnVelocity(argument)) {
      add(
          "N-028",
          part,
          origin,
          part
              + " jumps with "
              + function.symbol()
              + " of a velocity: where that velocity comes to zero and stays, the steps shrink to"
              + " nothing, since the force has no value at rest; use the friction of a joint, or"
              + " tanh(v/0.001) in place of signum(v)");
    }
  }

  private static boolean dependsOnVelocity(Expression formula) {
    return formula instanceof CoordinateVelocity
        || formula instanceof PointVelocity
        || BriefPush.operands(formula).stream().anyMatch(FormulaForecast::dependsOnVelocity);
  }

  private void add(String code, String part, Origin origin, String text) {
    findings.putIfAbsent(code + part, new Finding(code, text, origin));
  }
}
