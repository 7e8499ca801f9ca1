package org.mechservice.solver.mechanism;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.TreeSet;
import java.util.stream.Stream;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.expression.Expression.Call;
import org.mechservice.solver.expression.Expression.Composed;
import org.mechservice.solver.expression.Expression.Constant;
import org.mechservice.solver.expression.Expression.Negation;
import org.mechservice.solver.expression.Expression.ParameterValue;
import org.mechservice.solver.expression.Expression.Power;
import org.mechservice.solver.expression.Expression.Product;
import org.mechservice.solver.expression.Expression.Quotient;
import org.mechservice.solver.expression.Expression.Sum;
import org.mechservice.solver.expression.Expression.Time;
import org.mechservice.solver.expression.FormulaEvaluation;
import org.mechservice.solver.mechanism.closure.JointClosure;
import org.mechservice.solver.mechanism.closure.LoopClosure;
import org.mechservice.solver.mechanism.joint.Joint;
import org.mechservice.solver.text.Origin;

/**
 * Finds jumps of prescribed coordinates and of their velocities. A function is sampled over the
 * interval, more densely around the times at which its formula is known to change. An interval with
 * a change is bisected towards the greater change until the change vanishes or no number lies
 * between its ends. Two opposite jumps within a two-thousandth of the interval, at times that do
 * not follow from the formula, may be missed.
 */
final class MotionJumps {
  private static final int SAMPLES = 2000;

  /** Half the width of the dense samples around a known time, relative to the interval. */
  private static final double NEAR = 1e-9;

  /** Factor of the distance from a jump at which rounding no longer destroys the velocity. */
  private static final double ROUNDED = 100;

  /** Relative change that counts as zero: rounding errors of long formulas. */
  private static final double NOTHING = 1e-9;

  private final Mechanism mechanism;
  private final double near;
  private final TreeSet<Double> grid = new TreeSet<>();
  private final List<MotionJump> found = new ArrayList<>();

  private MotionJumps(Mechanism mechanism, double from, double to) {
    this.mechanism = mechanism;
    near = NEAR * (to - from);
    // A jump at the start time belongs to the start values.
    double begin = from + near;
    for (int i = 0; i <= SAMPLES; i++) {
      grid.add(i == SAMPLES ? to : begin + (to - begin) * i / SAMPLES);
    }
    for (double time : TimePlaces.of(mechanism, from, to)) {
      if (time > begin) {
        grid.add(Math.max(begin, time - near));
        grid.add(Math.min(to, time + near));
      }
    }
  }

  /** Returns the jumps in an interval, in order of time. */
  static List<MotionJump> of(Mechanism mechanism, double from, double to) {
    if (!(to > from) || !possible(mechanism)) {
      return List.of();
    }
    MotionJumps jumps = new MotionJumps(mechanism, from, to);
    jumps.search();
    return jumps.found.stream().sorted(Comparator.comparingDouble(MotionJump::time)).toList();
  }

  /** Returns whether the formulas of prescribed motions permit jumps. */
  static boolean possible(Mechanism mechanism) {
    Stream<Expression> inTree = mechanism.motions().stream().flatMap(m -> m.coordinates().stream());
    Stream<Expression> cut =
        mechanism.closures().stream().flatMap(closure -> motion(closure).stream());
    return Stream.concat(inTree, cut).anyMatch(formula -> !isSmooth(formula));
  }

  private static List<Expression> motion(LoopClosure closure) {
    return closure instanceof JointClosure joint ? joint.motion() : List.of();
  }

  /** Returns whether a formula certainly has a continuous velocity. */
  private static boolean isSmooth(Expression formula) {
    if (formula instanceof Sum sum) {
      return isSmooth(sum.left()) && isSmooth(sum.right());
    } else if (formula instanceof Product product) {
      return isSmooth(product.left()) && isSmooth(product.right());
    } else if (formula instanceof Negation negation) {
      return isSmooth(negation.operand());
    } else if (formula instanceof Quotient quotient) {
      return isSmooth(quotient.dividend()) && isFixed(quotient.divisor());
    } else if (formula instanceof Power power) {
      return isSmooth(power.base())
          && power.exponent() instanceof Constant n
          && n.value() >= 1
          && n.value() == Math.rint(n.value());
    } else if (formula instanceof Call call) {
      List<Expression> arguments = call.arguments();
      boolean smooth = call.function().isSmooth() && arguments.size() == 1;
      return arguments.stream().allMatch(MotionJumps::isFixed)
          || (smooth && isSmooth(arguments.get(0)));
    } else if (formula instanceof Composed composed) {
      return composed.arguments().stream().allMatch(MotionJumps::isFixed)
          || isSmooth(composed.formula());
    }
    return formula instanceof Time || isFixed(formula);
  }

  private static boolean isFixed(Expression formula) {
    return formula instanceof Constant || formula instanceof ParameterValue;
  }

  private void search() {
    List<PrescribedMotion> motions =
        mechanism.motions().stream()
            .sorted(Comparator.comparingInt(PrescribedMotion::joint))
            .toList();
    int velocity = 0;
    for (PrescribedMotion motion : motions) {
      Joint joint = mechanism.joints().get(motion.joint());
      List<Expression> coordinates = motion.coordinates();
      if (joint.type().hasEulerParameters()) {
        searchTurn(joint, velocity, coordinates.subList(0, 4));
        velocity += 3;
        coordinates = coordinates.subList(4, coordinates.size());
      }
      for (Expression coordinate : coordinates) {
        search(joint, velocity++, coordinate);
      }
    }
    for (LoopClosure closure : mechanism.closures()) {
      if (closure instanceof JointClosure cut) {
        cut.motion().forEach(coordinate -> search(cut.joint(), -1, coordinate));
      }
    }
  }

  private void search(Joint joint, int velocity, Expression coordinate) {
    if (!isSmooth(coordinate)) {
      Curve curve = new Curve(coordinate, mechanism.parameters());
      search(joint, velocity, curve, true);
      search(joint, velocity, curve, false);
    }
  }

  /** Searches the Euler parameters of a ball, and the components of its angular velocity. */
  private void searchTurn(Joint joint, int velocity, List<Expression> e) {
    if (e.stream().allMatch(MotionJumps::isSmooth)) {
      return;
    }
    for (int i = 0; i < 4; i++) {
      search(joint, velocity, new Curve(e.get(i), mechanism.parameters()), true);
    }
    for (int i = 0; i < 3; i++) {
      search(joint, velocity + i, new Curve(e, i, mechanism.parameters()), false);
    }
  }

  private void search(Joint joint, int velocity, Curve curve, boolean position) {
    double[] times = grid.stream().mapToDouble(Double::doubleValue).toArray();
    double[] values = new double[times.length];
    double largest = 0;
    for (int i = 0; i < times.length; i++) {
      values[i] = curve.at(times[i], position);
      largest = Double.isFinite(values[i]) ? Math.max(largest, Math.abs(values[i])) : largest;
    }
    for (int i = 1; i < times.length; i++) {
      double a = times[i - 1];
      double b = times[i];
      double before = values[i - 1];
      double after = values[i];
      while (changes(before, after, largest)) {
        double middle = a + 0.5 * (b - a);
        if (!(middle > a && middle < b)) {
          add(jump(joint, velocity, curve, position, b));
          break;
        }
        double value = curve.at(middle, position);
        boolean first =
            !Double.isFinite(value) || Math.abs(value - before) > Math.abs(after - value);
        if (first) {
          b = middle;
          after = value;
        } else {
          a = middle;
          before = value;
        }
      }
    }
  }

  /**
   * Makes a jump from the values before and after. A function may have a third value at the jump,
   * and rounding may destroy its velocity nearby, as at the corners of {@code asin(sin(t))}.
   */
  private MotionJump jump(Joint joint, int velocity, Curve curve, boolean position, double t) {
    String name = joint.name();
    Origin origin = joint.origin();
    MotionJump place = new MotionJump(name, origin, velocity, position, t, 0, 0, false);
    double before = curve.at(place.ahead(), position);
    double after = curve.at(place.behind(), position);
    boolean lost = !position && !(Double.isFinite(before) && Double.isFinite(after));
    if (lost) {
      before = curve.at(t - ROUNDED * near, false);
      after = curve.at(t + ROUNDED * near, false);
    }
    return new MotionJump(name, origin, velocity, position, t, before, after, lost);
  }

  /** Adds a jump. A velocity that is not finite is reported with the accelerations instead. */
  private void add(MotionJump jump) {
    boolean known = Double.isFinite(jump.before()) && Double.isFinite(jump.after());
    if (!isFound(jump) && (jump.ofPosition() || (known && !jumpsAt(jump)))) {
      found.add(jump);
    }
  }

  private boolean isFound(MotionJump jump) {
    return found.stream()
        .anyMatch(
            other ->
                other.joint().equals(jump.joint())
                    && other.velocity() == jump.velocity()
                    && other.ofPosition() == jump.ofPosition()
                    && other.behind() >= jump.ahead()
                    && other.ahead() <= jump.behind());
  }

  /**
   * Returns whether the position of the coordinate jumps at the same time; its velocity is then
   * ignored.
   */
  private boolean jumpsAt(MotionJump jump) {
    return found.stream()
        .anyMatch(
            other ->
                other.ofPosition()
                    && other.joint().equals(jump.joint())
                    && Math.abs(other.time() - jump.time()) <= near);
  }

  private static boolean changes(double before, double after, double largest) {
    boolean finite = Double.isFinite(after) && Double.isFinite(before);
    return finite
        ? Math.abs(after - before) > NOTHING * largest
        : Double.isFinite(before) != Double.isFinite(after);
  }

  /** A coordinate as a function of time, or a component of the angular velocity of a ball. */
  private static final class Curve {
    private static final int PLAIN = -1;

    private final FormulaEvaluation evaluation;
    private final int turnAbout;

    Curve(Expression coordinate, List<Parameter> parameters) {
      this(List.of(coordinate), PLAIN, parameters);
    }

    /**
     * @param coordinates a coordinate, or four Euler parameters
     * @param turnAbout component of the angular velocity, 0 to 2
     */
    Curve(List<Expression> coordinates, int turnAbout, List<Parameter> parameters) {
      this.turnAbout = turnAbout;
      evaluation = new FormulaEvaluation(coordinates);
      List<Expression> leaves = evaluation.leaves();
      for (int i = 0; i < leaves.size(); i++) {
        if (leaves.get(i) instanceof ParameterValue parameter) {
          evaluation.setLeaf(i, parameters.get(parameter.index()).value());
        }
      }
    }

    double at(double t, boolean position) {
      List<Expression> leaves = evaluation.leaves();
      for (int i = 0; i < leaves.size(); i++) {
        if (leaves.get(i) instanceof Time) {
          evaluation.setLeaf(i, t, 1, 0);
        }
      }
      evaluation.derivatives();
      evaluation.rates();
      if (turnAbout != PLAIN) {
        return turnRate();
      }
      return position ? evaluation.value(0) : evaluation.rate(0);
    }

    /** Component i of 2 E(e) e′ with the cyclic order i, j, k. */
    private double turnRate() {
      int i = 1 + turnAbout;
      int j = 1 + (turnAbout + 1) % 3;
      int k = 1 + (turnAbout + 2) % 3;
      return 2
          * (evaluation.value(0) * evaluation.rate(i)
              - evaluation.value(i) * evaluation.rate(0)
              + evaluation.value(j) * evaluation.rate(k)
              - evaluation.value(k) * evaluation.rate(j));
    }
  }
}
