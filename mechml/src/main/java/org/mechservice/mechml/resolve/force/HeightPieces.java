package org.mechservice.mechml.resolve.force;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.SortedSet;
import java.util.TreeSet;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.expression.Expression.Argument;
import org.mechservice.solver.expression.Expression.Call;
import org.mechservice.solver.expression.Expression.Constant;
import org.mechservice.solver.expression.Expression.Negation;
import org.mechservice.solver.expression.Expression.Product;
import org.mechservice.solver.expression.Expression.Quotient;
import org.mechservice.solver.expression.Expression.Sum;
import org.mechservice.solver.expression.Expression.TableValue;
import org.mechservice.solver.expression.FormulaEvaluation;
import org.mechservice.solver.expression.Table;
import org.mechservice.solver.symbol.MathFunction;

/**
 * A height h(s) that is smooth between finitely many places and straight before the first and
 * behind the last of them: a sum of multiples of tables and smoothSteps of what is linear in s, and
 * of absolute values, minima and maxima of what is made of straight lines.
 */
final class HeightPieces {
  /** Distance of two places that are the same, by their size. */
  private static final double ROUNDING = 1e-13;

  private final FormulaEvaluation height;
  private final double[] breaks;
  private final boolean bounded;

  private HeightPieces(Expression height, double[] breaks, boolean bounded) {
    this.height = new FormulaEvaluation(List.of(height));
    this.breaks = breaks;
    this.bounded = bounded;
  }

  /** Returns the pieces of a height; empty if it has none or is not of this kind. */
  static Optional<HeightPieces> of(Expression height) {
    Collector collector = new Collector();
    return collector.isSum(height) && !collector.places.isEmpty()
        ? Optional.of(
            new HeightPieces(
                height,
                collector.places.stream().mapToDouble(Double::doubleValue).toArray(),
                collector.bounded))
        : Optional.empty();
  }

  /** Returns the places where it is not smooth, ascending. */
  double[] breaks() {
    return breaks.clone();
  }

  /** Returns whether it has no value before the first and behind the last place. */
  boolean isBounded() {
    return bounded;
  }

  /** Returns h(s). */
  double value(double s) {
    evaluate(s);
    return height.value(0);
  }

  /** Returns h′(s). */
  double slope(double s) {
    evaluate(s);
    return height.rate(0);
  }

  private void evaluate(double s) {
    height.setLeaf(0, s, 1, 0);
    height.derivatives();
    height.rates();
  }

  /** a s + b. */
  private record Line(double slope, double offset) {
    static Optional<Line> of(Expression e) {
      if (e instanceof Argument) {
        return Optional.of(new Line(1, 0));
      } else if (e instanceof Constant constant) {
        return Optional.of(new Line(0, constant.value()));
      } else if (e instanceof Sum sum) {
        return of(sum.left())
            .flatMap(
                a -> of(sum.right()).map(b -> new Line(a.slope + b.slope, a.offset + b.offset)));
      } else if (e instanceof Negation negation) {
        return of(negation.operand()).map(a -> a.times(-1));
      } else if (e instanceof Product product) {
        return of(product.left())
            .flatMap(
                a ->
                    of(product.right())
                        .filter(b -> a.slope == 0 || b.slope == 0)
                        .map(b -> a.slope == 0 ? b.times(a.offset) : a.times(b.offset)));
      } else if (e instanceof Quotient quotient) {
        return of(quotient.divisor())
            .filter(b -> b.slope == 0)
            .flatMap(b -> of(quotient.dividend()).map(a -> a.times(1 / b.offset)));
      }
      return Optional.empty();
    }

    Line times(double factor) {
      return new Line(factor * slope, factor * offset);
    }
  }

  /** Collects the places of a sum. */
  private static final class Collector {
    final TreeSet<Double> places = new TreeSet<>();
    boolean bounded;

    boolean isSum(Expression e) {
      if (Line.of(e).isPresent()) {
        return true;
      } else if (e instanceof Sum sum) {
        return isSum(sum.left()) && isSum(sum.right());
      } else if (e instanceof Negation negation) {
        return isSum(negation.operand());
      } else if (e instanceof Product product) {
        return isConstant(product.left())
            ? isSum(product.right())
            : isConstant(product.right()) && isSum(product.left());
      } else if (e instanceof Quotient quotient) {
        return isConstant(quotient.divisor()) && isSum(quotient.dividend());
      } else if (e instanceof TableValue value && value.table() instanceof Table table) {
        bounded |= table.outside() == Table.Extrapolation.ERROR;
        return areWhere(value.arguments().get(0), table.x());
      }
      return e instanceof Call call && isPiecewise(call);
    }

    private boolean isPiecewise(Call call) {
      List<Expression> arguments = call.arguments();
      Expression first = arguments.get(0);
      return switch (call.function()) {
        case SMOOTH_STEP -> areWhere(first, List.of(0.0, 1.0));
        case ABS -> changeSides(first);
        case MAX, MIN -> changeSides(new Sum(first, new Negation(arguments.get(1))));
        default -> false;
      };
    }

    /** Adds the places where what is made of straight lines has a corner or changes its sign. */
    private boolean changeSides(Expression difference) {
      Collector inside = new Collector();
      if (Line.of(difference).isPresent()) {
        return areWhere(difference, List.of(0.0));
      } else if (!isStraight(difference) || !inside.isSum(difference)) {
        return false;
      }
      inside.places.forEach(this::add);
      zeros(difference, inside.places).forEach(this::add);
      return true;
    }

    /** Returns the zeros of what is straight between places, and before and behind them. */
    private static List<Double> zeros(Expression lines, SortedSet<Double> places) {
      HeightPieces values = new HeightPieces(lines, new double[0], false);
      List<Double> ends = new ArrayList<>(places);
      ends.add(0, places.isEmpty() ? -1 : places.first() - 1);
      ends.add(places.isEmpty() ? 1 : places.last() + 1);
      List<Double> zeros = new ArrayList<>();
      for (int i = 0; i + 1 < ends.size(); i++) {
        double from = ends.get(i);
        double to = ends.get(i + 1);
        double middle = 0.5 * (from + to);
        double zero = middle - values.value(middle) / values.slope(middle);
        boolean afterFirst = i == 0 || zero >= from;
        boolean beforeLast = i + 2 == ends.size() || zero <= to;
        if (Double.isFinite(zero) && afterFirst && beforeLast) {
          zeros.add(zero);
        }
      }
      return zeros;
    }

    private static boolean isStraight(Expression e) {
      boolean here =
          !(e instanceof TableValue)
              && !(e instanceof Call call && call.function() == MathFunction.SMOOTH_STEP);
      return here && Expression.operands(e).stream().allMatch(Collector::isStraight);
    }

    private static boolean isConstant(Expression e) {
      return Line.of(e).filter(line -> line.slope() == 0).isPresent();
    }

    /** Adds the places where an argument that is linear in s has the given values. */
    private boolean areWhere(Expression argument, List<Double> values) {
      Optional<Line> line = Line.of(argument);
      line.filter(l -> l.slope() != 0)
          .ifPresent(l -> values.forEach(v -> add((v - l.offset()) / l.slope())));
      return line.isPresent();
    }

    /** Adds a place, if it is not one that is known but for rounding. */
    private void add(double place) {
      double rounding = ROUNDING * Math.abs(place);
      if (places.subSet(place - rounding, true, place + rounding, true).isEmpty()) {
        places.add(place);
      }
    }
  }
}
