package org.mechservice.solver.expression;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import org.mechservice.solver.symbol.Expressions;
import org.mechservice.solver.symbol.MathFunction;
import org.mechservice.solver.symbol.NumberRow;
import org.mechservice.solver.symbol.Program;
import org.mechservice.solver.symbol.Scalar;

/** Formulas of the model file as scalars. Subclasses supply the leaves. */
public abstract class Formulas {
  /** Largest integer or half-integer exponent that becomes a product. */
  private static final int LARGEST_PRODUCT = 64;

  private final Expressions e;
  private final IdentityHashMap<Expression, Scalar> done = new IdentityHashMap<>();

  protected Formulas(Expressions expressions) {
    this.e = expressions;
  }

  /** Returns a leaf that is neither a constant nor the time nor a parameter, which are inputs. */
  protected abstract Scalar leaf(Expression leaf);

  /** Returns the time, a parameter or a leaf. */
  protected Scalar input(Expression leaf) {
    if (leaf instanceof Expression.Time) {
      return e.input(Program.TIME);
    } else if (leaf instanceof Expression.ParameterValue parameter) {
      return e.input(Program.PARAMETER + parameter.index());
    }
    return leaf(leaf);
  }

  /**
   * Returns a formula as a scalar; parts that formulas share are converted once. A sum of thousands
   * of terms is a tree as deep, so a stack of our own holds what is open.
   */
  public final Scalar scalar(Expression formula) {
    Deque<Expression> open = new ArrayDeque<>();
    open.push(formula);
    while (!open.isEmpty()) {
      Expression next = open.element();
      Optional<Expression> missing =
          parts(next).stream().filter(part -> !done.containsKey(part)).findFirst();
      if (missing.isPresent()) {
        open.push(missing.get());
      } else {
        open.pop();
        if (!done.containsKey(next)) {
          done.put(next, convert(next));
        }
      }
    }
    return known(formula);
  }

  /** Returns what a formula is converted from: of a composed function its arguments. */
  private static List<Expression> parts(Expression formula) {
    return formula instanceof Expression.Composed call
        ? call.arguments()
        : Expression.operands(formula);
  }

  private Scalar known(Expression formula) {
    return Objects.requireNonNull(done.get(formula));
  }

  private Scalar convert(Expression formula) {
    if (formula instanceof Expression.Constant constant) {
      return e.constant(constant.value());
    } else if (formula instanceof Expression.Sum sum) {
      return known(sum.left()).plus(known(sum.right()));
    } else if (formula instanceof Expression.Product product) {
      return known(product.left()).times(known(product.right()));
    } else if (formula instanceof Expression.Quotient quotient) {
      return quotient(known(quotient.dividend()), known(quotient.divisor()));
    } else if (formula instanceof Expression.Power power) {
      return power(known(power.base()), known(power.exponent()));
    } else if (formula instanceof Expression.Negation negation) {
      return known(negation.operand()).negated();
    } else if (formula instanceof Expression.Call call) {
      return call(call.function(), call.arguments().stream().map(this::known).toList());
    } else if (formula instanceof Expression.Composed call) {
      return call(call.function(), call.arguments().stream().map(this::known).toList());
    } else if (formula instanceof Expression.TableValue value) {
      return table(value.table(), value.arguments().stream().map(this::known).toList());
    }
    return input(formula);
  }

  /** Returns a quotient, marked as steep: its divisor may pass through zero or be infinite. */
  private Scalar quotient(Scalar dividend, Scalar divisor) {
    Scalar quotient = dividend.over(divisor);
    return divisor.isConstant() ? quotient : quotient.markedSteep();
  }

  /**
   * Returns a power: by default products for integer and half-integer exponents, in the solver's
   * order of multiplication.
   */
  protected Scalar power(Scalar base, Scalar exponent) {
    double n = exponent.isConstant() ? exponent.value() : Double.NaN;
    if (Math.abs(n) <= LARGEST_PRODUCT && n == Math.rint(n)) {
      return whole(base, (int) n);
    } else if (Math.abs(n) <= LARGEST_PRODUCT && 2 * n == Math.rint(2 * n)) {
      Scalar root = base.squareRoot().markedSteep().times(whole(base, (int) Math.abs(n)));
      return n > 0 ? root : quotient(e.one(), root);
    }
    return e.function(MathFunction.POWER, base, exponent).markedSteep();
  }

  private Scalar whole(Scalar base, int n) {
    Scalar product = e.one();
    Scalar square = base;
    for (int k = Math.abs(n); k > 0; k >>= 1) {
      if ((k & 1) == 1) {
        product = product.times(square);
      }
      square = square.squared();
    }
    return n >= 0 ? product : quotient(e.one(), product);
  }

  /** Returns a call of a function: by default the formula that it is, if it is one. */
  protected Scalar call(MathFunction function, List<Scalar> arguments) {
    return function.call(arguments);
  }

  /** Returns the value of a table or map: by default the polynomials of which it is made. */
  protected Scalar table(PointFunction table, List<Scalar> arguments) {
    return table instanceof Table ofOne
        ? curve(ofOne.curve(), arguments.get(0))
        : surface(((TableMap) table).surface(), arguments.get(0), arguments.get(1));
  }

  /** Returns the polynomial of the interval that an argument is in, in the solver's order. */
  private Scalar curve(TableCurve curve, Scalar x) {
    Scalar place = e.interval(NumberRow.ofKnots(curve.knots(), curve.corners()), x);
    Scalar[] chosen = new Scalar[5];
    for (int number = 0; number < chosen.length; number++) {
      chosen[number] = e.element(new NumberRow(curve.numbers(number)), place);
    }
    Scalar d = x.minus(chosen[0]);
    Scalar inner = chosen[3].plus(d.times(chosen[4]));
    Scalar value = chosen[1].plus(d.times(chosen[2].plus(d.times(inner))));
    return curve.isBounded() ? value.plus(nothingOutside(curve.knots(), x)) : value;
  }

  /** Returns the polynomial of the cell that two arguments are in, in the solver's order. */
  private Scalar surface(MapSurface surface, Scalar x, Scalar y) {
    NumberRow originX = new NumberRow(surface.origins(0));
    NumberRow originY = new NumberRow(surface.origins(1));
    Scalar k = e.interval(NumberRow.ofKnots(surface.knots(0), surface.corners(0)), x);
    Scalar l = e.interval(NumberRow.ofKnots(surface.knots(1), surface.corners(1)), y);
    Scalar cell = k.times(originY.size()).plus(l);
    Scalar dx = x.minus(e.element(originX, k));
    Scalar dy = y.minus(e.element(originY, l));
    Scalar value = along(surface, 3, cell, dy);
    for (int i = 2; i >= 0; i--) {
      value = along(surface, i, cell, dy).plus(dx.times(value));
    }
    return surface.isBounded()
        ? value.plus(nothingOutside(surface.knots(0), x)).plus(nothingOutside(surface.knots(1), y))
        : value;
  }

  private Scalar along(MapSurface surface, int i, Scalar cell, Scalar dy) {
    Scalar value = e.element(new NumberRow(surface.coefficients(i, 3)), cell);
    for (int j = 2; j >= 0; j--) {
      Scalar c = e.element(new NumberRow(surface.coefficients(i, j)), cell);
      value = c.plus(dy.times(value));
    }
    return value;
  }

  /** Returns 0 between the first and the last knot, NaN beyond them. */
  private Scalar nothingOutside(double[] knots, Scalar x) {
    Scalar none = e.constant(-1).minus(x.squared()).squareRoot();
    Scalar last = e.constant(knots[knots.length - 1]);
    Scalar below = e.function(MathFunction.CHOOSE, x, last, e.zero(), none);
    return e.function(MathFunction.CHOOSE, e.constant(knots[0]), x, below, none);
  }
}
