package org.mechservice.solver.force.formula;

import java.util.List;
import java.util.Locale;
import org.mechservice.solver.expression.BodyPoint;
import org.mechservice.solver.expression.ClosureCoordinate;
import org.mechservice.solver.expression.Coordinate;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.expression.JointCoordinate;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.spatial.Vector3;

/** Writes formulas as readable text, with the names of their mechanism. */
public final class FormulaText {
  private static final int SUM = 1;
  private static final int PRODUCT = 2;
  private static final int SIGN = 3;
  private static final int POWER = 4;
  private static final int ATOM = 5;
  private static final String[] AXES = {"x", "y", "z"};

  private final Mechanism mechanism;

  /**
   * @param mechanism mechanism whose names the formulas use
   */
  public FormulaText(Mechanism mechanism) {
    this.mechanism = mechanism;
  }

  /** Returns a formula in the syntax of model files, in SI units. */
  public String of(Expression formula) {
    return beginning(formula, Integer.MAX_VALUE);
  }

  /**
   * Returns a formula in the syntax of model files, in SI units, cut to a length of about {@code
   * longest} and followed by "..." if it is longer. Nothing behind the cut is written: a formula of
   * shared parts can be far longer as text than as expression.
   */
  String beginning(Expression formula, int longest) {
    StringBuilder text = new StringBuilder();
    new Writing(text, longest).write(formula);
    return text.length() <= longest ? text.toString() : text.substring(0, longest) + "...";
  }

  /** Writes until the text is longer than asked for. */
  private final class Writing {
    private final StringBuilder text;
    private final int longest;

    Writing(StringBuilder text, int longest) {
      this.text = text;
      this.longest = longest;
    }

    void write(Expression formula) {
      if (text.length() > longest) {
        return;
      }
      if (formula instanceof Expression.Constant constant) {
        text.append(number(constant.value()));
      } else if (formula instanceof Expression.Sum sum) {
        write(sum);
      } else if (formula instanceof Expression.Product product) {
        writeInside(product.left(), PRODUCT);
        text.append('*');
        writeInside(product.right(), PRODUCT);
      } else if (formula instanceof Expression.Quotient quotient) {
        writeInside(quotient.dividend(), PRODUCT);
        text.append('/');
        writeInside(quotient.divisor(), SIGN);
      } else if (formula instanceof Expression.Power power) {
        writeInside(power.base(), ATOM);
        text.append('^');
        writeInside(power.exponent(), ATOM);
      } else if (formula instanceof Expression.Negation negation) {
        text.append('-');
        writeInside(negation.operand(), SIGN);
      } else if (formula instanceof Expression.Call call) {
        write(call.function().symbol(), call.arguments());
      } else if (formula instanceof Expression.Composed call) {
        write(call.function().symbol(), call.arguments());
      } else if (formula instanceof Expression.TableValue value) {
        write(value.table().name(), value.arguments());
      } else {
        text.append(leaf(formula));
      }
    }

    private void write(String function, List<Expression> arguments) {
      text.append(function).append('(');
      for (int i = 0; i < arguments.size(); i++) {
        text.append(i == 0 ? "" : ", ");
        write(arguments.get(i));
      }
      text.append(')');
    }

    private void write(Expression.Sum sum) {
      write(sum.left());
      if (sum.right() instanceof Expression.Negation minus) {
        text.append(" - ");
        writeInside(minus.operand(), PRODUCT);
      } else {
        text.append(" + ");
        write(sum.right());
      }
    }

    private void writeInside(Expression formula, int least) {
      boolean loose = binding(formula) < least;
      text.append(loose ? "(" : "");
      write(formula);
      text.append(loose ? ")" : "");
    }
  }

  private static int binding(Expression formula) {
    if (formula instanceof Expression.Sum) {
      return SUM;
    } else if (formula instanceof Expression.Product || formula instanceof Expression.Quotient) {
      return PRODUCT;
    } else if (formula instanceof Expression.Power) {
      return POWER;
    }
    boolean signed =
        formula instanceof Expression.Negation
            || (formula instanceof Expression.Constant constant && constant.value() < 0);
    return signed ? SUM : ATOM;
  }

  private static String number(double value) {
    return value == Math.rint(value) && Math.abs(value) < 1e6
        ? Long.toString((long) value)
        : Double.toString(value);
  }

  private String leaf(Expression leaf) {
    if (leaf instanceof Expression.Time) {
      return "t";
    } else if (leaf instanceof Expression.ParameterValue parameter) {
      return mechanism.parameters().get(parameter.index()).name();
    } else if (leaf instanceof Expression.StateValue state) {
      return mechanism.furtherStates().get(state.index()).name();
    } else if (leaf instanceof Expression.CoordinatePosition position) {
      return coordinate(position.coordinate(), "q", true);
    } else if (leaf instanceof Expression.CoordinateVelocity velocity) {
      return coordinate(velocity.coordinate(), "v", false);
    } else if (leaf instanceof Expression.PointPosition point) {
      return place(point.point(), AXES[point.axis()]);
    } else if (leaf instanceof Expression.PointVelocity point) {
      return place(point.point(), "v" + AXES[point.axis()]);
    } else if (leaf instanceof Expression.RelativeMotion relative) {
      return "motion[" + relative.component() + "]";
    } else if (leaf instanceof Expression.PathMotion motion) {
      return motion.isRate() ? "rate" : "length";
    } else if (leaf instanceof Expression.ClosestStation) {
      return "closest";
    }
    return "x";
  }

  private String coordinate(Coordinate coordinate, String what, boolean position) {
    String name = "joint";
    int count = 1;
    if (coordinate instanceof JointCoordinate joint) {
      name = mechanism.joints().get(joint.joint()).name();
      var type = mechanism.joints().get(joint.joint()).type();
      count = position ? type.positionCount() : type.velocityCount();
    } else if (coordinate instanceof ClosureCoordinate closure) {
      name = mechanism.closures().get(closure.closure()).name();
    }
    return name + "." + what + (count == 1 ? "" : "[" + coordinate.component() + "]");
  }

  private String place(BodyPoint point, String what) {
    String body =
        point.body() == BodyPoint.ROOT
            ? mechanism.root().name()
            : mechanism.bodies().get(point.body()).name();
    Vector3 at = point.position();
    return String.format(
        Locale.ROOT, "%s(%.6g; %.6g; %.6g).%s", body, at.x(), at.y(), at.z(), what);
  }
}
