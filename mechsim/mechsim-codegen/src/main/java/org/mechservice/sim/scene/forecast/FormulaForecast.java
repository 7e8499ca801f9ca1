package org.mechservice.sim.scene.forecast;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Collections;
import java.util.Deque;
import java.util.IdentityHashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.function.Predicate;
import org.mechservice.sim.scene.Finding;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.expression.Expression.Call;
import org.mechservice.solver.expression.Expression.Constant;
import org.mechservice.solver.expression.Expression.CoordinateVelocity;
import org.mechservice.solver.expression.Expression.ParameterValue;
import org.mechservice.solver.expression.Expression.PathMotion;
import org.mechservice.solver.expression.Expression.PointVelocity;
import org.mechservice.solver.expression.Expression.RelativeMotion;
import org.mechservice.solver.expression.Expression.Time;
import org.mechservice.solver.expression.FormulaEvaluation;
import org.mechservice.solver.force.formula.FormulaText;
import org.mechservice.solver.mechanism.FurtherState;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.PrescribedMotion;
import org.mechservice.solver.mechanism.force.ForceElement;
import org.mechservice.solver.symbol.MathFunction;
import org.mechservice.solver.text.Origin;

/**
 * Finds, before a run, formulas that force tiny steps: {@code sin} of a time that passes through
 * millions of radians, {@code floor} that jumps as often, and a force that jumps with the sign of a
 * velocity. Such a force makes a joint that should rest oscillate between its two values.
 */
final class FormulaForecast {
  /**
   * Number of radians or jumps within a run that causes a warning, as in {@link StiffnessForecast}.
   */
  private static final double MANY = 1e6;

  /** Behaviour of a function over a wide range of its argument. */
  private enum Shape {
    /** Oscillates or jumps repeatedly. */
    REPEATING,
    /** Jumps where its argument is zero. */
    SWITCHING,
    /** Neither of them. */
    PLAIN
  }

  private final Mechanism mechanism;
  private final RunSettings settings;
  private final Map<String, Finding> findings = new LinkedHashMap<>();

  private FormulaForecast(Mechanism mechanism, RunSettings settings) {
    this.mechanism = mechanism;
    this.settings = settings;
  }

  /**
   * Returns the findings, those of forces first; only the first of each kind for a force or motion.
   */
  static List<Finding> of(Mechanism mechanism, RunSettings settings) {
    FormulaForecast forecast = new FormulaForecast(mechanism, settings);
    for (ForceElement force : mechanism.forces()) {
      String part = "force \"" + force.name() + "\"";
      force.formulas().forEach(f -> forecast.look(f.expression(), part, force.origin()));
    }
    for (FurtherState state : mechanism.furtherStates()) {
      forecast.look(state.derivative(), "state \"" + state.name() + "\"", state.origin());
    }
    for (PrescribedMotion motion : mechanism.motions()) {
      var joint = mechanism.joints().get(motion.joint());
      String part = "the motion of joint \"" + joint.name() + "\"";
      motion.coordinates().forEach(f -> forecast.look(f, part, joint.origin()));
    }
    if (forecast.findings.values().stream()
        .noneMatch(finding -> finding.code() == MessageCode.VERY_MANY_STEPS)) {
      forecast.changes();
    }
    return new ArrayList<>(forecast.findings.values());
  }

  private void look(Expression formula, String part, Origin origin) {
    parts(formula, FormulaForecast::isSmooth).forEach(one -> lookAt(one, part, origin));
  }

  /** Returns whether a part is known to be smooth though it is put together by choices. */
  private static boolean isSmooth(Expression part) {
    return part instanceof Call call && call.function() == MathFunction.SMOOTH;
  }

  private void lookAt(Expression formula, String part, Origin origin) {
    if (formula instanceof Call call) {
      Expression argument = call.arguments().get(0);
      switch (shape(call.function())) {
        case REPEATING -> fast(call, argument, part, origin);
        case SWITCHING -> chatter(call.function(), argument, part, origin);
        case PLAIN -> {}
      }
    }
  }

  private static Shape shape(MathFunction function) {
    return function.repeats() ? Shape.REPEATING : function.jumps() ? Shape.SWITCHING : Shape.PLAIN;
  }

  private void fast(Call call, Expression argument, String part, Origin origin) {
    double rate = Math.abs(rate(argument).orElse(0));
    double steps = rate * (settings.tEnd() - settings.tStart());
    boolean jumps = call.function() == MathFunction.FLOOR;
    boolean skipped = !jumps && rate * settings.maxStep() > Math.PI && rate > 0;
    boolean given = Double.isFinite(settings.maxStep());
    if (steps >= MANY || (given && skipped)) {
      String where = new FormulaText(mechanism).of(call) + " in " + part;
      add(
          MessageCode.VERY_MANY_STEPS,
          part,
          origin,
          where + (jumps ? jumping(rate, steps) : turning(rate, steps)));
    }
  }

  /** Looks whether the formulas of time change their form too often for all changes to be known. */
  private void changes() {
    List<Double> known = mechanism.timeJumps(settings.tStart(), settings.tEnd());
    if (known.size() >= Mechanism.MOST_TIME_JUMPS) {
      String text =
          String.format(
              Locale.ROOT,
              "the formulas of time change their form more than %d times within %.3g s; steps end at"
                  + " these changes only and may pass over the others; leave out what is too fast to"
                  + " matter, or end the run earlier",
              Mechanism.MOST_TIME_JUMPS,
              settings.tEnd() - settings.tStart());
      add(MessageCode.VERY_MANY_STEPS, "", Origin.NONE, text);
    }
  }

  private String jumping(double rate, double steps) {
    return String.format(
        Locale.ROOT,
        " jumps %.2e times a second; a run of %.3g s needs some %.0e steps to follow it, whatever"
            + " the integrator; leave out what is too fast to matter, or end the run earlier",
        rate,
        settings.tEnd() - settings.tStart(),
        steps);
  }

  private String turning(double rate, double steps) {
    return String.format(
        Locale.ROOT,
        " turns %.2e rad/s, once in %.3g s; a run of %.3g s needs some %.0e steps to follow it,"
            + " whatever the integrator, and steps as long as that%s see no more than single"
            + " values of it, which need not be zero on the average; leave out what is too fast to"
            + " matter, bound the steps by maxStep=\"%.1g\", or end the run earlier",
        rate,
        2 * Math.PI / rate,
        settings.tEnd() - settings.tStart(),
        steps,
        Double.isFinite(settings.maxStep())
            ? String.format(Locale.ROOT, " (maxStep allows %.3g s)", settings.maxStep())
            : "",
        1 / rate);
  }

  /** Returns the derivative at the start of an expression of time and parameters alone. */
  private OptionalDouble rate(Expression argument) {
    FormulaEvaluation evaluation = new FormulaEvaluation(List.of(argument));
    List<Expression> leaves = evaluation.leaves();
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

  private void chatter(MathFunction function, Expression argument, String part, Origin origin) {
    if (dependsOnVelocity(argument)) {
      add(
          MessageCode.FORCE_JUMPS_WITH_VELOCITY,
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

  /** Returns an expression and all of its parts, each object once: formulas may share parts. */
  static Set<Expression> parts(Expression formula) {
    return parts(formula, part -> false);
  }

  /** Returns the parts of an expression, without those inside of parts that are whole. */
  private static Set<Expression> parts(Expression formula, Predicate<Expression> whole) {
    Set<Expression> parts = Collections.newSetFromMap(new IdentityHashMap<>());
    Deque<Expression> open = new ArrayDeque<>(List.of(formula));
    while (!open.isEmpty()) {
      Expression next = open.pop();
      if (parts.add(next) && !whole.test(next)) {
        open.addAll(Expression.operands(next));
      }
    }
    return parts;
  }

  private static boolean dependsOnVelocity(Expression formula) {
    return parts(formula).stream().anyMatch(FormulaForecast::isVelocity);
  }

  private static boolean isVelocity(Expression part) {
    return part instanceof CoordinateVelocity
        || part instanceof PointVelocity
        || PathMotion.RATE.equals(part)
        || (part instanceof RelativeMotion relative
            && relative.component() >= RelativeMotion.ANGULAR_VELOCITY);
  }

  private void add(MessageCode code, String part, Origin origin, String text) {
    findings.putIfAbsent(code + part, new Finding(code, text, origin));
  }
}
