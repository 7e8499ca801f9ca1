package org.mechservice.solver.expression;

import java.util.List;
import java.util.stream.IntStream;
import org.mechservice.solver.symbol.Expressions;
import org.mechservice.solver.symbol.MathFunction;
import org.mechservice.solver.symbol.Scalar;

/**
 * A formula of time, parameters and the state, in SI units.
 *
 * <p>Names are resolved: parameters, coordinates and points are indices into the mechanism. {@code
 * a − b} is {@code Sum(a, Negation(b))}, which rounds identically; {@code pow(a, b)} and {@code a ^
 * b} are both {@link Power}.
 */
public sealed interface Expression {
  /** The expression 0. */
  Expression ZERO = new Constant(0);

  /** Returns the constant of that value, in SI units. */
  static Expression of(double value) {
    return new Constant(value);
  }

  /** Returns the expressions that an expression combines, in their order; none for a leaf. */
  static List<Expression> operands(Expression expression) {
    if (expression instanceof Sum sum) {
      return List.of(sum.left(), sum.right());
    } else if (expression instanceof Product product) {
      return List.of(product.left(), product.right());
    } else if (expression instanceof Quotient quotient) {
      return List.of(quotient.dividend(), quotient.divisor());
    } else if (expression instanceof Power power) {
      return List.of(power.base(), power.exponent());
    } else if (expression instanceof Negation negation) {
      return List.of(negation.operand());
    } else if (expression instanceof Call call) {
      return call.arguments();
    } else if (expression instanceof Composed composed) {
      return List.of(composed.formula());
    } else if (expression instanceof TableValue value) {
      return value.arguments();
    }
    return List.of();
  }

  /**
   * A number.
   *
   * @param value finite, in SI units
   */
  record Constant(double value) implements Expression {
    public Constant {
      if (!Double.isFinite(value)) {
        throw new IllegalArgumentException("a constant must be finite, not " + value);
      }
    }
  }

  /** The time, s. */
  record Time() implements Expression {}

  /**
   * The argument of a function of one variable, such as the distance along a road whose height the
   * expression gives, m. It has no meaning elsewhere.
   */
  record Argument() implements Expression {}

  /**
   * A tunable parameter, which is constant during a run.
   *
   * @param index among the mechanism's parameters
   */
  record ParameterValue(int index) implements Expression {}

  /**
   * The length of the path along which a force pulls, m, or the rate of the length, m/s. It has no
   * meaning elsewhere.
   *
   * @param isRate whether it is the rate
   */
  record PathMotion(boolean isRate) implements Expression {
    /** The length. */
    public static final PathMotion LENGTH = new PathMotion(false);

    /** Its rate. */
    public static final PathMotion RATE = new PathMotion(true);
  }

  /**
   * A state besides positions and velocities, in its own unit.
   *
   * @param index among the mechanism's further states
   */
  record StateValue(int index) implements Expression {}

  /**
   * A joint's position, rad or m, or an Euler parameter in the form of the output.
   *
   * @param coordinate component counts positions
   */
  record CoordinatePosition(Coordinate coordinate) implements Expression {}

  /**
   * A joint's velocity, rad/s or m/s.
   *
   * @param coordinate component counts velocities
   */
  record CoordinateVelocity(Coordinate coordinate) implements Expression {}

  /**
   * A coordinate of a point from the world's origin, in world axes, m.
   *
   * @param point fixed in a body
   * @param axis 0, 1, 2 for x, y, z
   */
  record PointPosition(BodyPoint point, int axis) implements Expression {
    public PointPosition {
      checkAxis(axis);
    }
  }

  /**
   * A component of the velocity of a point in the world, in world axes, m/s.
   *
   * @param point fixed in a body
   * @param axis 0, 1, 2 for x, y, z
   */
  record PointVelocity(BodyPoint point, int axis) implements Expression {
    public PointVelocity {
      checkAxis(axis);
    }
  }

  /**
   * A component of the pose or velocity of frame 2 relative to frame 1, in the axes of frame 1.
   *
   * @param frame1 fixed in body 1
   * @param frame2 fixed in body 2
   * @param component 0 to 2: origin of frame 2 from that of frame 1, m; 3 to 11: rotation from the
   *     axes of frame 2 to those of frame 1, row by row; 12 to 14: relative angular velocity,
   *     rad/s; 15 to 17: rate of the displacement as seen from body 1, m/s
   */
  record RelativeMotion(BodyFrame frame1, BodyFrame frame2, int component) implements Expression {
    /** The first components of the rotation, the angular velocity and the rate; their end. */
    public static final int ROTATION = 3;

    public static final int ANGULAR_VELOCITY = 12;
    public static final int RATE = 15;
    public static final int COUNT = 18;

    public RelativeMotion {
      if (component < 0 || component >= COUNT) {
        throw new IllegalArgumentException("a component is 0 to 17, not " + component);
      }
    }
  }

  /**
   * Abscissa of the point of a curve z = h(x) that is closest to the origin of a frame, m; where it
   * changes with the frame it has no derivatives.
   *
   * @param surface x along the curve, z up
   * @param point the frame
   * @param curve h of {@link Argument} and parameters, m
   */
  record ClosestStation(BodyFrame surface, BodyFrame point, Expression curve)
      implements Expression {
    /** Returns x of the frame. */
    public RelativeMotion along() {
      return new RelativeMotion(surface, point, 0);
    }

    /** Returns z of the frame. */
    public RelativeMotion above() {
      return new RelativeMotion(surface, point, 2);
    }
  }

  /**
   * left + right.
   *
   * @param left first term
   * @param right second term
   */
  record Sum(Expression left, Expression right) implements Expression {}

  /**
   * left · right.
   *
   * @param left first factor
   * @param right second factor
   */
  record Product(Expression left, Expression right) implements Expression {}

  /**
   * dividend / divisor.
   *
   * @param dividend numerator
   * @param divisor denominator
   */
  record Quotient(Expression dividend, Expression divisor) implements Expression {}

  /**
   * base to the power of exponent. A negative base requires an integer exponent.
   *
   * @param base the base
   * @param exponent the exponent
   */
  record Power(Expression base, Expression exponent) implements Expression {}

  /**
   * −operand.
   *
   * @param operand the operand
   */
  record Negation(Expression operand) implements Expression {}

  /**
   * Returns a call of a function: of {@link MathFunction#POWER} a {@link Power}, of a function that
   * is a formula of others a {@link Composed}.
   *
   * @param arguments as many as the arity of the function
   * @throws IllegalArgumentException if there are more or fewer
   */
  static Expression call(MathFunction function, List<Expression> arguments) {
    checkCount(function, arguments);
    if (function == MathFunction.POWER) {
      return new Power(arguments.get(0), arguments.get(1));
    }
    return function.isComposed()
        ? new Composed(function, arguments, formula(function, arguments))
        : new Call(function, arguments);
  }

  /** Returns the formula that a composed function is. */
  private static Expression formula(MathFunction function, List<Expression> arguments) {
    Expressions e = new Expressions();
    List<Scalar> inputs = IntStream.range(0, arguments.size()).mapToObj(e::input).toList();
    return new ScalarFormulas(arguments).of(function.call(inputs));
  }

  private static void checkCount(MathFunction function, List<Expression> arguments) {
    if (arguments.size() != function.arity()) {
      throw new IllegalArgumentException(
          function.symbol() + " takes " + function.arity() + " arguments, not " + arguments.size());
    }
  }

  /**
   * A function of docs/mechml.md#values whose calls are neither {@link Power} nor {@link Composed}.
   *
   * @param function the function
   * @param arguments as many as its arity
   */
  record Call(MathFunction function, List<Expression> arguments) implements Expression {
    public Call {
      arguments = List.copyOf(arguments);
      checkCount(function, arguments);
      if (function == MathFunction.POWER || function.isComposed()) {
        throw new IllegalArgumentException(
            "a call of " + function.symbol() + " is made by Expression.call");
      }
    }
  }

  /**
   * A call of a function that is a formula of others. The formula is its operand; its name and its
   * arguments are what the user wrote.
   *
   * @param function the function
   * @param arguments as many as its arity
   * @param formula what it is
   */
  record Composed(MathFunction function, List<Expression> arguments, Expression formula)
      implements Expression {
    public Composed {
      arguments = List.copyOf(arguments);
    }
  }

  /**
   * The value of a table or map.
   *
   * @param table what gives it
   * @param arguments as many as it has
   */
  record TableValue(PointFunction table, List<Expression> arguments) implements Expression {
    public TableValue {
      arguments = List.copyOf(arguments);
      if (arguments.size() != table.argumentCount()) {
        throw new IllegalArgumentException(
            table.name() + " takes " + table.argumentCount() + ", not " + arguments.size());
      }
    }
  }

  private static void checkAxis(int axis) {
    if (axis < 0 || axis > 2) {
      throw new IllegalArgumentException("an axis is 0, 1 or 2, not " + axis);
    }
  }
}
