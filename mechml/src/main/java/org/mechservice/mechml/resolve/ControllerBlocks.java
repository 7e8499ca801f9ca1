package org.mechservice.mechml.resolve;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.mechservice.mechml.diagnosis.Diagnostics;
import org.mechservice.mechml.document.Element;
import org.mechservice.mechml.resolve.formula.FormulaReader;
import org.mechservice.mechml.resolve.formula.FormulaRole;
import org.mechservice.mechml.resolve.value.AttributeText;
import org.mechservice.mechml.unit.Unit;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.symbol.MathFunction;

/**
 * The blocks {@code pid} and {@code transferFunction} as states and an output formula. A block
 * whose formulas could not be read is empty; the errors have been reported.
 */
final class ControllerBlocks {
  /** Suffixes of the names of a controller's states. */
  static final String INTEGRAL = ".integral";

  static final String FILTER = ".filter";

  /** Suffixes of the states that a sampled controller has besides its output. */
  static final String DERIVATIVE = ".derivative";

  static final String PREVIOUS = ".previous";

  private static final Expression ONE = Expression.of(1);

  private final FormulaReader formulas;
  private final Diagnostics diagnostics;

  ControllerBlocks(FormulaReader formulas, Diagnostics diagnostics) {
    this.formulas = formulas;
    this.diagnostics = diagnostics;
  }

  /**
   * A block.
   *
   * @param output its value
   * @param derivatives of its states, in order
   */
  record Block(Expression output, List<Expression> derivatives) {}

  /** Returns how many states a controller has. */
  static List<String> statesOfPid(Element element) {
    List<String> suffixes = new ArrayList<>();
    if (element.attribute("period").isPresent()) {
      suffixes.add("");
      if (element.attribute("ki").isPresent()) {
        suffixes.add(INTEGRAL);
      }
      if (element.attribute("kd").isPresent()) {
        suffixes.addAll(List.of(DERIVATIVE, PREVIOUS));
      }
      return suffixes;
    }
    if (element.attribute("ki").isPresent()) {
      suffixes.add(INTEGRAL);
    }
    if (element.attribute("kd").isPresent()) {
      suffixes.add(FILTER);
    }
    return suffixes;
  }

  /** Returns the suffixes of the states of a transfer function: the degree of the denominator. */
  static List<String> statesOfTransferFunction(Element element) {
    List<String> suffixes = new ArrayList<>();
    int count = AttributeText.itemsOf(element, "den").size();
    for (int i = 1; i < count; i++) {
      suffixes.add(".x" + i);
    }
    return suffixes;
  }

  /**
   * Returns a controller u = kp e + I + D of the error e = setpoint − measured, with I' = ki e + (u
   * − u_free)/Tt, D = kd (w − x)/Tf, x' = (w − x)/Tf, w the error or −measured, and u the value
   * u_free between the limits.
   *
   * @param first index of its first state
   */
  Optional<Block> pid(Element element, int first) {
    Optional<Expression> setpoint = state(element, "setpoint");
    Optional<Expression> measured = state(element, "measured");
    Optional<Expression> kp = coefficient(element, "kp");
    Optional<Expression> ki = coefficient(element, "ki");
    Optional<Expression> kd = coefficient(element, "kd");
    if (setpoint.isEmpty() || measured.isEmpty() || kp.isEmpty() || ki.isEmpty() || kd.isEmpty()) {
      return Optional.empty();
    }
    boolean integrates = element.attribute("ki").isPresent();
    boolean differentiates = element.attribute("kd").isPresent();
    Expression error = difference(setpoint.get(), measured.get());
    Expression free = product(kp.get(), error);
    List<Expression> derivatives = new ArrayList<>();
    if (integrates) {
      free = new Expression.Sum(free, new Expression.StateValue(first));
    }
    Optional<Expression> slope = Optional.empty();
    if (differentiates) {
      Optional<Expression> filter = positive(element, "filter", "a derivative needs it");
      if (filter.isEmpty()) {
        return Optional.empty();
      }
      Expression watched =
          element.attribute("derivativeOf").orElse("error").equals("measured")
              ? new Expression.Negation(measured.get())
              : error;
      Expression followed = new Expression.StateValue(first + (integrates ? 1 : 0));
      slope = Optional.of(new Expression.Quotient(difference(watched, followed), filter.get()));
      free = new Expression.Sum(free, product(kd.get(), slope.get()));
    }
    Optional<Expression> limited = limited(element, free);
    if (limited.isEmpty()) {
      return Optional.empty();
    }
    if (integrates) {
      Optional<Expression> rate = integral(element, free, limited.get(), product(ki.get(), error));
      if (rate.isEmpty()) {
        return Optional.empty();
      }
      derivatives.add(rate.get());
    }
    slope.ifPresent(derivatives::add);
    return Optional.of(new Block(limited.get(), derivatives));
  }

  /**
   * Returns the new values of the states of a sampled controller, in order: its output u = u_free
   * between the limits, with u_free = kp e + I + D; the integral of the next sample, I + T (ki e +
   * (u − u_free)/Tt); the derivative term D = (Tf D₋ + kd (w − w₋))/(Tf + T), and w (Åström and
   * Hägglund 2006, §13.4, with forward differences for I and backward differences for D).
   *
   * @param first index of its first state
   * @param period T, s
   */
  Optional<List<Expression>> sampledPid(Element element, int first, double period) {
    Optional<Expression> setpoint = state(element, "setpoint");
    Optional<Expression> measured = state(element, "measured");
    Optional<Expression> kp = coefficient(element, "kp");
    Optional<Expression> ki = coefficient(element, "ki");
    Optional<Expression> kd = coefficient(element, "kd");
    Optional<Expression> filter = coefficient(element, "filter");
    if (setpoint.isEmpty()
        || measured.isEmpty()
        || kp.isEmpty()
        || ki.isEmpty()
        || kd.isEmpty()
        || filter.isEmpty()) {
      return Optional.empty();
    }
    if (filter.get() instanceof Expression.Constant constant && constant.value() < 0) {
      return error(element, "filter is " + constant.value() + "; it must not be negative");
    }
    boolean integrates = element.attribute("ki").isPresent();
    boolean differentiates = element.attribute("kd").isPresent();
    Expression error = difference(setpoint.get(), measured.get());
    Expression free = product(kp.get(), error);
    List<Expression> followed = new ArrayList<>();
    if (integrates) {
      free = sum(free, new Expression.StateValue(first + 1));
    }
    if (differentiates) {
      int at = first + (integrates ? 2 : 1);
      Expression watched =
          element.attribute("derivativeOf").orElse("error").equals("measured")
              ? new Expression.Negation(measured.get())
              : error;
      Expression change = difference(watched, new Expression.StateValue(at + 1));
      Expression derivative =
          new Expression.Quotient(
              sum(product(filter.get(), new Expression.StateValue(at)), product(kd.get(), change)),
              sum(filter.get(), Expression.of(period)));
      free = sum(free, derivative);
      followed.addAll(List.of(derivative, watched));
    }
    Optional<Expression> limited = limited(element, free);
    if (limited.isEmpty()) {
      return Optional.empty();
    }
    if (integrates) {
      Optional<Expression> rate = integral(element, free, limited.get(), product(ki.get(), error));
      if (rate.isEmpty()) {
        return Optional.empty();
      }
      Expression step = product(Expression.of(period), rate.get());
      followed.add(0, sum(new Expression.StateValue(first + 1), step));
    }
    followed.add(0, limited.get());
    return Optional.of(followed);
  }

  private Optional<Expression> limited(Element element, Expression free) {
    Expression value = free;
    for (String limit : List.of("upper", "lower")) {
      if (element.attribute(limit).isPresent()) {
        Optional<Expression> bound = state(element, limit);
        if (bound.isEmpty()) {
          return Optional.empty();
        }
        MathFunction nearer = limit.equals("upper") ? MathFunction.MIN : MathFunction.MAX;
        value = Expression.call(nearer, List.of(value, bound.get()));
      }
    }
    return Optional.of(value);
  }

  /** Returns the derivative of the integral, which limits hold back. */
  private Optional<Expression> integral(
      Element element, Expression free, Expression limited, Expression rate) {
    if (free.equals(limited)) {
      return Optional.of(rate);
    }
    Optional<Expression> time =
        element.attribute("trackingTime").isPresent()
            ? positive(element, "trackingTime", "")
            : defaultTracking(element);
    return time.map(
        t -> new Expression.Sum(rate, new Expression.Quotient(difference(limited, free), t)));
  }

  /** Returns √(Ti Td), or Ti without derivative (Åström and Hägglund 2006, §3.5). */
  private Optional<Expression> defaultTracking(Element element) {
    Optional<Expression> ki = coefficient(element, "ki");
    boolean withDerivative = element.attribute("kd").isPresent();
    Optional<Expression> other = coefficient(element, withDerivative ? "kd" : "kp");
    if (ki.isEmpty() || other.isEmpty()) {
      return Optional.empty();
    }
    if (isZero(other.get()) || isZero(ki.get())) {
      return error(
          element,
          "the limits need trackingTime, the time in which the integral gives way at a limit: it"
              + " has no default without "
              + (isZero(ki.get()) ? "ki" : withDerivative ? "kd" : "kp"));
    }
    Expression ratio = new Expression.Quotient(other.get(), ki.get());
    return Optional.of(withDerivative ? Expression.call(MathFunction.SQRT, List.of(ratio)) : ratio);
  }

  /**
   * Returns y = (b_m s^m + … + b_0) / (a_n s^n + … + a_0) u in the controllable canonical form: x_1
   * to x_n are the solution of a_n x_1^(n) + … + a_0 x_1 = u and its derivatives.
   *
   * @param first index of its first state
   */
  Optional<Block> transferFunction(Element element, int first) {
    Optional<Expression> input = state(element, "input");
    List<Expression> num = polynomial(element, "num");
    List<Expression> den = polynomial(element, "den");
    if (input.isEmpty() || num.isEmpty() || den.isEmpty()) {
      return Optional.empty();
    }
    int n = den.size() - 1;
    if (n == 0 || num.size() > den.size()) {
      return error(
          element,
          n == 0
              ? "den has one coefficient, which is a gain; write the product as an expression"
              : "num has "
                  + num.size()
                  + " coefficients and den has "
                  + den.size()
                  + ": the degree of num must not be above that of den");
    }
    if (isZero(den.get(n))) {
      return error(element, "the first coefficient of den is 0; leave it out");
    }
    List<Expression> derivatives = new ArrayList<>();
    Expression highest = input.get();
    for (int i = 0; i < n; i++) {
      if (i > 0) {
        derivatives.add(new Expression.StateValue(first + i));
      }
      highest = difference(highest, product(den.get(i), new Expression.StateValue(first + i)));
    }
    highest = new Expression.Quotient(highest, den.get(n));
    derivatives.add(highest);
    Expression output = Expression.ZERO;
    for (int i = 0; i < num.size(); i++) {
      Expression state = i < n ? new Expression.StateValue(first + i) : highest;
      output = sum(output, product(num.get(i), state));
    }
    return Optional.of(new Block(output, derivatives));
  }

  /** Returns the coefficients, that of the lowest power first; empty after a reported error. */
  private List<Expression> polynomial(Element element, String attribute) {
    List<Expression> coefficients = new ArrayList<>();
    List<AttributeText> items = AttributeText.itemsOf(element, attribute);
    for (AttributeText item : items) {
      formulas.read(item, Unit.ONE, FormulaRole.COEFFICIENT).ifPresent(c -> coefficients.add(0, c));
    }
    return coefficients.size() == items.size() ? coefficients : List.of();
  }

  private Optional<Expression> state(Element element, String attribute) {
    return element.attribute(attribute).isPresent()
        ? formulas.read(AttributeText.of(element, attribute), Unit.ONE, FormulaRole.STATE)
        : Optional.of(Expression.ZERO);
  }

  private Optional<Expression> coefficient(Element element, String attribute) {
    return element.attribute(attribute).isPresent()
        ? formulas.read(AttributeText.of(element, attribute), Unit.ONE, FormulaRole.COEFFICIENT)
        : Optional.of(Expression.ZERO);
  }

  private Optional<Expression> positive(Element element, String attribute, String why) {
    if (element.attribute(attribute).isEmpty()) {
      return error(element, attribute + " is missing; " + why);
    }
    Optional<Expression> value = coefficient(element, attribute);
    if (value.isPresent()
        && value.get() instanceof Expression.Constant constant
        && !(constant.value() > 0)) {
      return error(element, attribute + " is " + constant.value() + "; it must be positive");
    }
    return value;
  }

  private <T> Optional<T> error(Element element, String message) {
    diagnostics.error(
        MessageCode.STATE_VALUE, element.position(), element.label() + ": " + message);
    return Optional.empty();
  }

  private static boolean isZero(Expression value) {
    return value instanceof Expression.Constant constant && constant.value() == 0;
  }

  private static Expression difference(Expression a, Expression b) {
    return isZero(b) ? a : new Expression.Sum(a, new Expression.Negation(b));
  }

  private static Expression sum(Expression a, Expression b) {
    return isZero(a) ? b : isZero(b) ? a : new Expression.Sum(a, b);
  }

  private static Expression product(Expression a, Expression b) {
    return isZero(a) || isZero(b)
        ? Expression.ZERO
        : a.equals(ONE) ? b : new Expression.Product(a, b);
  }
}
