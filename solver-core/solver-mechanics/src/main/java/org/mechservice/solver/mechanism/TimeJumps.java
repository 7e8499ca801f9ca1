package org.mechservice.solver.mechanism;

import java.util.ArrayList;
import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.expression.Expression.Call;
import org.mechservice.solver.expression.Expression.Constant;
import org.mechservice.solver.expression.Expression.Negation;
import org.mechservice.solver.expression.Expression.ParameterValue;
import org.mechservice.solver.expression.Expression.Product;
import org.mechservice.solver.expression.Expression.Quotient;
import org.mechservice.solver.expression.Expression.Sum;
import org.mechservice.solver.expression.Expression.TableValue;
import org.mechservice.solver.expression.Expression.Time;
import org.mechservice.solver.mechanism.force.ForceElement;

/**
 * The times at which a mechanism's equations jump because of an expression of time: {@code
 * step(t-1)} at 1 s, {@code floor(10*t)} every tenth of a second. A jump is found if the argument
 * of such a function is c₀ + c₁ t with numbers or parameters for c; the time of a jump that depends
 * on the state is not known in advance.
 *
 * <p>A force jumps with {@code step}, {@code floor} and {@code signum}. The acceleration of a
 * driven joint also jumps with {@code smoothStep}, {@code abs}, {@code min} and {@code max}.
 */
final class TimeJumps {
  /** Largest number of jumps found; a function with more is not piecewise smooth. */
  private static final int MOST = 10_000;

  private final List<Parameter> parameters;
  private final double from;
  private final double to;
  private final TreeSet<Double> times = new TreeSet<>();

  /** What {@link #search} has met, without and with two derivatives; parts may be shared. */
  private final List<Set<Expression>> searched =
      List.of(
          Collections.newSetFromMap(new IdentityHashMap<>()),
          Collections.newSetFromMap(new IdentityHashMap<>()));

  private final IdentityHashMap<Expression, Optional<Line>> lines = new IdentityHashMap<>();

  private TimeJumps(List<Parameter> parameters, double from, double to) {
    this.parameters = parameters;
    this.from = from;
    this.to = to;
  }

  /** Returns the jumps of an interval, ascending; the first ten thousand if there are more. */
  static List<Double> of(Mechanism mechanism, double from, double to) {
    TimeJumps jumps = new TimeJumps(mechanism.parameters(), from, to);
    for (PrescribedMotion motion : mechanism.motions()) {
      motion.coordinates().forEach(coordinate -> jumps.search(coordinate, true));
    }
    for (ForceElement force : mechanism.forces()) {
      force.formulas().forEach(formula -> jumps.search(formula.expression(), false));
    }
    mechanism.furtherStates().forEach(state -> jumps.search(state.derivative(), false));
    return List.copyOf(jumps.times);
  }

  private void search(Expression expression, boolean twiceDifferentiated) {
    if (!searched.get(twiceDifferentiated ? 1 : 0).add(expression)) {
      return;
    }
    if (expression instanceof Call call) {
      call.arguments().forEach(argument -> search(argument, twiceDifferentiated));
      call(call, twiceDifferentiated);
    } else {
      Expression.operands(expression).forEach(operand -> search(operand, twiceDifferentiated));
      if (expression instanceof TableValue value) {
        corners(value);
      }
    }
  }

  private void call(Call call, boolean twiceDifferentiated) {
    Optional<Line> argument = line(call.arguments().get(0));
    if (argument.isEmpty() || argument.get().slope() == 0) {
      return;
    }
    Line line = argument.get();
    switch (call.function()) {
      case STEP, SIGNUM -> add(line.where(0));
      case FLOOR -> addWholes(line);
      case ABS -> {
        if (twiceDifferentiated) {
          add(line.where(0));
        }
      }
      case SMOOTH_STEP -> {
        if (twiceDifferentiated) {
          add(line.where(0));
          add(line.where(1));
        }
      }
      case MIN, MAX -> {
        if (twiceDifferentiated) {
          line(call.arguments().get(1)).ifPresent(other -> addMeeting(line, other));
        }
      }
      // smooth wherever they are defined
      case SQRT,
          SIN,
          COS,
          TAN,
          ASIN,
          ACOS,
          ATAN,
          ATAN2,
          EXP,
          LOG,
          POW,
          SINH,
          COSH,
          TANH,
          HYPOT -> {}
    }
  }

  /** Adds the times at which the slope or the curvature of a table or map jumps. */
  private void corners(TableValue value) {
    for (int i = 0; i < value.arguments().size(); i++) {
      List<Double> points = value.table().grid().get(i);
      line(value.arguments().get(i))
          .filter(line -> line.slope() != 0)
          .ifPresent(line -> points.forEach(point -> add(line.where(point))));
    }
  }

  private void addMeeting(Line one, Line other) {
    double slope = one.slope() - other.slope();
    if (slope != 0) {
      add((other.atZero() - one.atZero()) / slope);
    }
  }

  private void addWholes(Line line) {
    double first = Math.ceil(Math.min(line.at(from), line.at(to)));
    double last = Math.max(line.at(from), line.at(to));
    if (Double.isInfinite(first)) {
      add(line.where(0));
      return;
    }
    for (int i = 0; i < MOST && first + i <= last; i++) {
      add(line.where(first + i));
    }
  }

  private void add(double t) {
    if (t >= from && t <= to && times.size() < MOST) {
      times.add(t);
    }
  }

  /** Returns an expression as a linear function of time, if it is one. */
  private Optional<Line> line(Expression expression) {
    Optional<Line> known = lines.get(expression);
    if (known == null) {
      known = lineOf(expression);
      lines.put(expression, known);
    }
    return known;
  }

  private Optional<Line> lineOf(Expression expression) {
    if (expression instanceof Constant constant) {
      return Optional.of(new Line(constant.value(), 0));
    } else if (expression instanceof ParameterValue parameter) {
      return Optional.of(new Line(parameters.get(parameter.index()).value(), 0));
    } else if (expression instanceof Time) {
      return Optional.of(new Line(0, 1));
    } else if (expression instanceof Negation negation) {
      return line(negation.operand()).map(a -> new Line(-a.atZero(), -a.slope()));
    }
    List<Line> operands = new ArrayList<>();
    Expression.operands(expression).forEach(operand -> line(operand).ifPresent(operands::add));
    return operands.size() == 2
        ? combination(expression, operands.get(0), operands.get(1))
        : Optional.empty();
  }

  private static Optional<Line> combination(Expression expression, Line a, Line b) {
    if (expression instanceof Sum) {
      return Optional.of(new Line(a.atZero() + b.atZero(), a.slope() + b.slope()));
    } else if (expression instanceof Product && a.slope() * b.slope() == 0) {
      double slope = a.atZero() * b.slope() + a.slope() * b.atZero();
      return Optional.of(new Line(a.atZero() * b.atZero(), slope));
    } else if (expression instanceof Quotient && b.slope() == 0) {
      return Optional.of(new Line(a.atZero() / b.atZero(), a.slope() / b.atZero()));
    }
    return Optional.empty();
  }

  /**
   * A linear function of time.
   *
   * @param atZero value at t = 0
   * @param slope per second
   */
  private record Line(double atZero, double slope) {
    double at(double t) {
      return atZero + slope * t;
    }

    double where(double value) {
      return (value - atZero) / slope;
    }
  }
}
