package org.mechservice.robot;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.expression.JointCoordinate;
import org.mechservice.solver.mechanism.FurtherState;
import org.mechservice.solver.mechanism.FurtherState.Role;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.force.JointForce;
import org.mechservice.solver.symbol.MathFunction;

/**
 * Forces along coordinates that are motors of MuJoCo: a sum of terms, each linear in one input, in
 * the position and the velocity of the coordinate, and each within limits or not. The input may be
 * limited, and a state that follows it with a delay of the first order may stand for it.
 */
final class MjcfMotors {
  /** An expression within limits. */
  private record Bounded(double low, double high, Expression inner) {}

  /** What a term is of: an input, as the force sees it. */
  private record Signal(String name, Optional<Bounded> bounds, double time) {}

  private final Mechanism mechanism;
  private final Map<JointCoordinate, MjcfCoordinate> along;
  private final ExportLosses losses;
  private final TagBuilder actuators = new TagBuilder("actuator");
  private final Set<String> names = new HashSet<>();
  private final Set<Integer> used = new HashSet<>();

  MjcfMotors(Mechanism mechanism, Map<JointCoordinate, MjcfCoordinate> along, ExportLosses losses) {
    this.mechanism = mechanism;
    this.along = along;
    this.losses = losses;
  }

  /** Returns the element with all motors. */
  TagBuilder actuators() {
    return actuators;
  }

  /** Returns the states and inputs of the model that no motor has. */
  List<String> unused() {
    List<String> all = new ArrayList<>();
    for (int i = 0; i < mechanism.furtherStates().size(); i++) {
      if (!used.contains(i)) {
        all.add("state \"" + mechanism.furtherStates().get(i).name() + "\"");
      }
    }
    return all;
  }

  /** One motor to be written. */
  private record Motor(TagBuilder tag, Set<Integer> states) {}

  /** Takes a force; returns whether it is made of motors. */
  boolean take(JointForce force) {
    JointCoordinate at = (JointCoordinate) force.coordinate();
    MjcfCoordinate coordinate = along.get(at);
    Expression whole = force.force();
    List<Motor> found = new ArrayList<>();
    Optional<LinearRelation> outer =
        LinearRelation.of(whole, mechanism, part -> isAtom(part, at) || isForce(part));
    if (coordinate == null || outer.isEmpty()) {
      return false;
    }
    LinearRelation rest = outer.get();
    List<Expression> bounded = rest.factors().keySet().stream().filter(this::isForce).toList();
    for (Expression one : bounded) {
      Bounded limits = bounded(one).orElseThrow();
      Optional<LinearRelation> inner =
          LinearRelation.of(limits.inner(), mechanism, part -> isAtom(part, at));
      Optional<Motor> motor =
          inner.flatMap(
              sum -> motor(force, coordinate, at, sum, rest.factor(one), Optional.of(limits)));
      if (motor.isEmpty()) {
        return false;
      }
      found.add(motor.get());
    }
    Map<Expression, Double> free = new LinkedHashMap<>(rest.factors());
    free.keySet().removeIf(this::isForce);
    for (LinearRelation part : oneByOne(new LinearRelation(rest.constant(), free), at)) {
      Optional<Motor> motor = motor(force, coordinate, at, part, 1, Optional.empty());
      if (motor.isEmpty()) {
        return false;
      }
      found.add(motor.get());
    }
    for (Motor motor : found) {
      actuators.add(motor.tag());
      used.addAll(motor.states());
    }
    return true;
  }

  /**
   * Returns a sum as parts with one input each, the constant and the motion with the input that
   * commands the position, or the first; nothing if the sum is empty.
   */
  private static List<LinearRelation> oneByOne(LinearRelation sum, JointCoordinate at) {
    Expression position = new Expression.CoordinatePosition(at);
    Expression velocity = new Expression.CoordinateVelocity(at);
    List<Expression> inputs =
        new ArrayList<>(
            sum.factors().keySet().stream()
                .filter(one -> !one.equals(position) && !one.equals(velocity))
                .toList());
    if (inputs.isEmpty()) {
      return sum.factors().isEmpty() && sum.constant() == 0 ? List.of() : List.of(sum);
    }
    Expression servo =
        inputs.stream()
            .filter(one -> sum.factor(one) == -sum.factor(position))
            .findFirst()
            .orElse(inputs.get(0));
    List<LinearRelation> parts = new ArrayList<>();
    for (Expression input : inputs) {
      Map<Expression, Double> factors = new LinkedHashMap<>(Map.of(input, sum.factor(input)));
      if (input.equals(servo)) {
        factors.put(position, sum.factor(position));
        factors.put(velocity, sum.factor(velocity));
      }
      parts.add(new LinearRelation(input.equals(servo) ? sum.constant() : 0, factors));
    }
    return parts;
  }

  /** Returns whether an expression is an input as a force sees it, or the coordinate's motion. */
  private boolean isAtom(Expression part, JointCoordinate at) {
    return part.equals(new Expression.CoordinatePosition(at))
        || part.equals(new Expression.CoordinateVelocity(at))
        || signal(part, new HashSet<>()).isPresent();
  }

  /** Returns whether an expression is a force within limits, and no input within limits. */
  private boolean isForce(Expression part) {
    return bounded(part).isPresent() && signal(part, new HashSet<>()).isEmpty();
  }

  private Optional<Signal> signal(Expression part, Set<Integer> states) {
    if (part instanceof Expression.StateValue value) {
      FurtherState state = mechanism.furtherStates().get(value.index());
      if (state.role() == Role.INPUT) {
        states.add(value.index());
        return Optional.of(new Signal(state.name(), Optional.empty(), 0));
      }
      return state.role() == Role.INTEGRATED ? delayed(value, state, states) : Optional.empty();
    }
    return bounded(part)
        .filter(limits -> limits.inner() instanceof Expression.StateValue)
        .flatMap(
            limits ->
                signal(limits.inner(), states)
                    .filter(input -> input.time() == 0)
                    .map(input -> new Signal(input.name(), Optional.of(limits), 0)));
  }

  /** Returns the input that a state follows: its rate is (input − state) / time. */
  private Optional<Signal> delayed(
      Expression.StateValue value, FurtherState state, Set<Integer> states) {
    Optional<LinearRelation> rate =
        LinearRelation.of(
            state.derivative(),
            mechanism,
            part -> part.equals(value) || (isState(part) && signal(part, states).isPresent()));
    if (rate.isEmpty() || rate.get().factors().size() != 2 || rate.get().constant() != 0) {
      return Optional.empty();
    }
    double decay = -rate.get().factor(value);
    Optional<Expression> followed =
        rate.get().factors().keySet().stream().filter(one -> !one.equals(value)).findFirst();
    boolean first =
        decay > 0
            && state.start() == 0
            && followed.isPresent()
            && Math.abs(rate.get().factor(followed.get()) / decay - 1) < 1e-14;
    if (!first) {
      return Optional.empty();
    }
    states.add(value.index());
    return signal(followed.get(), states)
        .filter(input -> input.time() == 0)
        .map(input -> new Signal(input.name(), input.bounds(), 1 / decay));
  }

  /** Returns whether an expression is an input or an input within limits. */
  private boolean isState(Expression part) {
    Expression inner = bounded(part).map(Bounded::inner).orElse(part);
    return inner instanceof Expression.StateValue value
        && mechanism.furtherStates().get(value.index()).role() == Role.INPUT;
  }

  /** Returns an expression max(low, min(high, inner)). */
  private Optional<Bounded> bounded(Expression expression) {
    List<Expression> outer = arguments(expression, MathFunction.MAX);
    if (outer.size() != 2) {
      return Optional.empty();
    }
    List<Expression> inner = arguments(outer.get(1), MathFunction.MIN);
    if (inner.size() != 2) {
      return Optional.empty();
    }
    Optional<Double> low = LinearRelation.number(outer.get(0), mechanism);
    Optional<Double> high = LinearRelation.number(inner.get(0), mechanism);
    return low.flatMap(a -> high.map(b -> new Bounded(a, b, inner.get(1))));
  }

  private static List<Expression> arguments(Expression expression, MathFunction function) {
    if (expression instanceof Expression.Call call && call.function() == function) {
      return call.arguments();
    } else if (expression instanceof Expression.Composed call && call.function() == function) {
      return call.arguments();
    }
    return List.of();
  }

  private Optional<Motor> motor(
      JointForce force,
      MjcfCoordinate coordinate,
      JointCoordinate at,
      LinearRelation sum,
      double gear,
      Optional<Bounded> limits) {
    Expression position = new Expression.CoordinatePosition(at);
    Expression velocity = new Expression.CoordinateVelocity(at);
    List<Expression> inputs =
        sum.factors().keySet().stream()
            .filter(one -> !one.equals(position) && !one.equals(velocity))
            .toList();
    if (inputs.size() > 1 || gear == 0) {
      return Optional.empty();
    }
    Set<Integer> states = new HashSet<>();
    Optional<Signal> signal = inputs.isEmpty() ? Optional.empty() : signal(inputs.get(0), states);
    String name = signal.map(Signal::name).orElse(force.name());
    while (!names.add(name)) {
      name += "_";
      if (signal.isPresent()) {
        losses.add(
            force.origin(),
            "input \"" + signal.get().name() + "\" of several forces is one motor for each");
      }
    }
    // The length of a motor is gear · position, as its force on the joint is gear · force.
    TagBuilder tag =
        new TagBuilder("general")
            .set("name", name)
            .set("joint", coordinate.name())
            .set("gear", gear)
            .set("gainprm", inputs.isEmpty() ? 0 : sum.factor(inputs.get(0)));
    double stiff = sum.factor(position) / gear;
    double damp = sum.factor(velocity) / gear;
    if (sum.constant() != 0 || stiff != 0 || damp != 0) {
      tag.set("biastype", "affine")
          .set(
              "biasprm",
              MechmlText.number(sum.constant())
                  + " "
                  + MechmlText.number(stiff)
                  + " "
                  + MechmlText.number(damp));
    }
    signal
        .filter(one -> one.time() > 0)
        .ifPresent(
            one -> tag.set("dyntype", "filter").set("dynprm", MechmlText.number(one.time())));
    signal.flatMap(Signal::bounds).ifPresent(one -> tag.set("ctrlrange", range(one)));
    limits.ifPresent(one -> tag.set("forcerange", range(one)));
    return Optional.of(new Motor(tag, states));
  }

  private static String range(Bounded bounds) {
    return MechmlText.number(bounds.low()) + " " + MechmlText.number(bounds.high());
  }
}
