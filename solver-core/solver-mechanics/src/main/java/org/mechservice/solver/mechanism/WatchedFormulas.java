package org.mechservice.solver.mechanism;

import java.util.ArrayList;
import java.util.Collections;
import java.util.HashMap;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.mechservice.solver.expression.BodyFrame;
import org.mechservice.solver.expression.BodyPoint;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.expression.Expression.Argument;
import org.mechservice.solver.expression.Expression.Call;
import org.mechservice.solver.expression.Expression.ClosestStation;
import org.mechservice.solver.expression.Expression.Composed;
import org.mechservice.solver.expression.Expression.Constant;
import org.mechservice.solver.expression.Expression.CoordinatePosition;
import org.mechservice.solver.expression.Expression.Negation;
import org.mechservice.solver.expression.Expression.ParameterValue;
import org.mechservice.solver.expression.Expression.PathMotion;
import org.mechservice.solver.expression.Expression.PointPosition;
import org.mechservice.solver.expression.Expression.Power;
import org.mechservice.solver.expression.Expression.Product;
import org.mechservice.solver.expression.Expression.Quotient;
import org.mechservice.solver.expression.Expression.RelativeMotion;
import org.mechservice.solver.expression.Expression.Sum;
import org.mechservice.solver.expression.Expression.TableValue;
import org.mechservice.solver.expression.Expression.Time;
import org.mechservice.solver.expression.FormulaRate;
import org.mechservice.solver.expression.ScalarFormulas;
import org.mechservice.solver.expression.Tape;
import org.mechservice.solver.force.law.Frames;
import org.mechservice.solver.force.law.PairLoad;
import org.mechservice.solver.force.law.Side;
import org.mechservice.solver.mechanism.closure.CoordinateClosure;
import org.mechservice.solver.mechanism.closure.JointClosure;
import org.mechservice.solver.mechanism.closure.LoopClosure;
import org.mechservice.solver.mechanism.force.Bushing;
import org.mechservice.solver.mechanism.force.Contact;
import org.mechservice.solver.mechanism.force.CouplingSpringDamper;
import org.mechservice.solver.mechanism.force.ForceElement;
import org.mechservice.solver.mechanism.force.ForceTorque;
import org.mechservice.solver.mechanism.force.ForceVisitor;
import org.mechservice.solver.mechanism.force.JointForce;
import org.mechservice.solver.mechanism.force.JointFriction;
import org.mechservice.solver.mechanism.force.JointSpringDamper;
import org.mechservice.solver.mechanism.force.LawForce;
import org.mechservice.solver.mechanism.force.PairForce;
import org.mechservice.solver.mechanism.force.PathForce;
import org.mechservice.solver.mechanism.force.SpringDamper;
import org.mechservice.solver.mechanism.force.UserForceElement;
import org.mechservice.solver.spatial.Rotation;
import org.mechservice.solver.symbol.Corners;
import org.mechservice.solver.symbol.Expressions;
import org.mechservice.solver.symbol.MathFunction;
import org.mechservice.solver.symbol.Scalar;

/**
 * The formulas of a mechanism that a step could pass over: those that change their form with the
 * state, and those that can be large over a short way and nothing beside it. They are written
 * without the terms that change evenly wherever the state goes.
 *
 * <p>Contacts and springs that act on one side give the amount by which they are pressed or
 * stretched, {@code max(0, ...)}; forces, states, drives and couplings give their formulas.
 */
final class WatchedFormulas implements ForceVisitor<List<Expression>> {
  /** Largest exponent that counts as even: higher powers of a cosine are pulses. */
  private static final double EVEN_POWER = 3;

  /** Way over which the slope of a surface is taken, m. */
  private static final double SHORT = 1e-6;

  private final IdentityHashMap<Expression, Optional<Expression>> contents =
      new IdentityHashMap<>();
  private final IdentityHashMap<Expression, Boolean> fixed = new IdentityHashMap<>();

  private final Mechanism mechanism;

  private WatchedFormulas(Mechanism mechanism) {
    this.mechanism = mechanism;
  }

  /** Returns the formulas, none if the equations are even everywhere. */
  static List<Expression> of(Mechanism mechanism) {
    WatchedFormulas formulas = new WatchedFormulas(mechanism);
    List<Expression> all = new ArrayList<>();
    mechanism.forces().forEach(force -> all.addAll(force.accept(formulas)));
    mechanism.furtherStates().forEach(state -> all.add(state.derivative()));
    mechanism.motions().forEach(motion -> all.addAll(motion.coordinates()));
    for (LoopClosure closure : mechanism.closures()) {
      if (closure instanceof CoordinateClosure coupling) {
        all.add(coupling.relation());
      } else if (closure instanceof JointClosure cut) {
        all.addAll(cut.motion());
      }
    }
    List<Expression> watched = new ArrayList<>();
    for (Expression formula : all) {
      formulas.content(formula).filter(WatchedFormulas::isNarrowOrMoves).ifPresent(watched::add);
    }
    return watched;
  }

  /** Pieces of time alone need no watching: steps end where they change. */
  private static boolean isNarrowOrMoves(Expression formula) {
    Tape tape = new Tape(List.of(formula));
    boolean ofTime =
        tape.leaves().stream().allMatch(l -> l instanceof Time || l instanceof ParameterValue);
    return !ofTime || isNarrow(formula);
  }

  private static boolean isNarrow(Expression formula) {
    return isNarrow(formula, Collections.newSetFromMap(new IdentityHashMap<>()));
  }

  /**
   * @param seen parts that are known not to be; formulas share parts
   */
  private static boolean isNarrow(Expression formula, Set<Expression> seen) {
    if (!seen.add(formula)) {
      return false;
    }
    boolean here =
        formula instanceof TableValue
            || (formula instanceof Call call && call.function().corners() == Corners.NONE)
            || formula instanceof Power
            || formula instanceof Quotient;
    return here || Expression.operands(formula).stream().anyMatch(part -> isNarrow(part, seen));
  }

  /** Returns a formula without its even terms; empty if it has no others. */
  private Optional<Expression> content(Expression formula) {
    Optional<Expression> known = contents.get(formula);
    if (known == null) {
      known = contentOf(formula);
      contents.put(formula, known);
    }
    return known;
  }

  private Optional<Expression> contentOf(Expression formula) {
    List<Expression> operands = Expression.operands(formula);
    List<Optional<Expression>> parts = operands.stream().map(this::content).toList();
    if (formula instanceof Call call && call.function() == MathFunction.SMOOTH) {
      return Optional.empty();
    } else if (isUneven(formula)) {
      return Optional.of(formula);
    } else if (parts.stream().allMatch(Optional::isEmpty)) {
      return Optional.empty();
    } else if (formula instanceof Negation) {
      return parts.get(0).map(Negation::new);
    } else if (formula instanceof Sum) {
      return parts.get(0).isEmpty()
          ? parts.get(1)
          : parts.get(1).isEmpty()
              ? parts.get(0)
              : Optional.of(new Sum(parts.get(0).get(), parts.get(1).get()));
    } else if (formula instanceof Product && parts.stream().anyMatch(Optional::isEmpty)) {
      int uneven = parts.get(0).isPresent() ? 0 : 1;
      Expression even = operands.get(1 - uneven);
      return isFixed(even)
          ? parts.get(uneven).map(part -> new Product(even, part))
          : parts.get(uneven);
    } else if (formula instanceof Quotient && isFixed(operands.get(1))) {
      return parts.get(0).map(part -> new Quotient(part, operands.get(1)));
    }
    return Optional.of(formula);
  }

  private boolean isFixed(Expression formula) {
    Boolean known = fixed.get(formula);
    if (known == null) {
      List<Expression> operands = Expression.operands(formula);
      known =
          operands.isEmpty()
              ? formula instanceof Constant || formula instanceof ParameterValue
              : operands.stream().allMatch(this::isFixed);
      fixed.put(formula, known);
    }
    return known;
  }

  /** Returns whether an operation has pieces, or can be narrow by itself. */
  private boolean isUneven(Expression formula) {
    if (formula instanceof TableValue value) {
      return !value.arguments().stream().allMatch(this::isFixed);
    } else if (formula instanceof Quotient quotient) {
      return !isFixed(quotient.divisor());
    } else if (formula instanceof Power power) {
      boolean even =
          power.exponent() instanceof Constant exponent
              && exponent.value() >= 0
              && exponent.value() <= EVEN_POWER;
      return !even && !isFixed(formula);
    } else if (formula instanceof Call call) {
      return isUneven(call.function()) && !isFixed(formula);
    }
    return false;
  }

  private static boolean isUneven(MathFunction function) {
    return function.corners() != Corners.NONE || function.isNarrow();
  }

  private static Expression pressed(Expression amount) {
    return Expression.call(MathFunction.MAX, List.of(Expression.ZERO, amount));
  }

  /** Returns by how much a one-sided spring is stretched or pressed; nothing for another. */
  private static List<Expression> oneSided(Side side, Expression length, Expression rest) {
    Expression beyond = new Sum(length, new Negation(rest));
    return switch (side) {
      case BOTH -> List.of();
      case ABOVE -> List.of(pressed(beyond));
      case BELOW -> List.of(pressed(new Negation(beyond)));
    };
  }

  @Override
  public List<Expression> springDamper(SpringDamper force) {
    Expression squares = Expression.ZERO;
    for (int axis = 0; axis < 3; axis++) {
      Expression way =
          new Sum(
              new PointPosition(force.point2(), axis),
              new Negation(new PointPosition(force.point1(), axis)));
      squares = new Sum(squares, new Product(way, way));
    }
    Expression length = Expression.call(MathFunction.SQRT, List.of(squares));
    return oneSided(force.side(), length, force.length0());
  }

  @Override
  public List<Expression> jointSpringDamper(JointSpringDamper force) {
    return oneSided(force.side(), new CoordinatePosition(force.coordinate()), force.position0());
  }

  @Override
  public List<Expression> couplingSpringDamper(CouplingSpringDamper force) {
    List<Expression> all = new ArrayList<>(oneSided(force.side(), force.along(), force.rest()));
    all.addAll(force.watched());
    return all;
  }

  @Override
  public List<Expression> pathForce(PathForce force) {
    List<Expression> all = new ArrayList<>(force.watched());
    Map<Expression, Expression> motion = new HashMap<>();
    motion.put(PathMotion.LENGTH, force.along());
    if (new Tape(List.of(force.tension())).leaves().contains(PathMotion.RATE)) {
      motion.put(PathMotion.RATE, FormulaRate.of(force.along(), mechanism::rateOf));
    }
    content(force.tension()).map(tension -> replaced(tension, motion)).ifPresent(all::add);
    return all;
  }

  /** Returns by how much the centre is below the heights at which the sphere touches. */
  @Override
  public List<Expression> contact(Contact force) {
    BodyPoint center = force.center();
    BodyFrame ball = new BodyFrame(center.body(), center.position(), Rotation.IDENTITY);
    Expression x = new RelativeMotion(force.surface(), ball, 0);
    Expression below = new Negation(new RelativeMotion(force.surface(), ball, 2));
    if (force.tracks().isEmpty()) {
      return ofClosestPoint(force, ball, x, below);
    }
    return force.tracks().stream().map(track -> pressed(new Sum(at(x, track), below))).toList();
  }

  /**
   * Returns the depth below h + R √(1 + h′²), which is exact on a straight slope, with h′ from a
   * difference. The closest point jumps from one side of a hollow corner to the other before the
   * centre reaches the corner; the side matters while the sphere presses.
   */
  private static List<Expression> ofClosestPoint(
      Contact force, BodyFrame ball, Expression x, Expression below) {
    Expression height = force.height();
    Expression radius = force.radius();
    Expression above = new Sum(at(x, height), below);
    if (height instanceof Constant || radius.equals(Expression.ZERO)) {
      return List.of(pressed(new Sum(above, radius)));
    }
    Expression depth = pressed(new Sum(above, new Product(radius, length(height, x))));
    Expression closest = new ClosestStation(force.surface(), ball, height);
    List<Expression> watched = new ArrayList<>(List.of(depth));
    for (Expression side : HollowCorners.of(height)) {
      watched.add(
          new Product(depth, Expression.call(MathFunction.SIGNUM, List.of(at(closest, side)))));
    }
    return watched;
  }

  /** Returns √(1 + h′²). */
  private static Expression length(Expression curve, Expression x) {
    Expression ahead = at(new Sum(x, Expression.of(SHORT)), curve);
    Expression behind = at(new Sum(x, Expression.of(-SHORT)), curve);
    Expression slope =
        new Product(Expression.of(0.5 / SHORT), new Sum(ahead, new Negation(behind)));
    return Expression.call(
        MathFunction.SQRT, List.of(new Sum(Expression.of(1), new Product(slope, slope))));
  }

  private static Expression at(Expression x, Expression curve) {
    return replaced(curve, Map.of(new Argument(), x));
  }

  /** Returns a formula with leaves replaced by others. */
  static Expression replaced(Expression formula, Map<Expression, Expression> leaves) {
    List<Expression> parts =
        Expression.operands(formula).stream().map(part -> replaced(part, leaves)).toList();
    if (parts.isEmpty()) {
      return leaves.getOrDefault(formula, formula);
    } else if (formula instanceof Sum) {
      return new Sum(parts.get(0), parts.get(1));
    } else if (formula instanceof Product) {
      return new Product(parts.get(0), parts.get(1));
    } else if (formula instanceof Quotient) {
      return new Quotient(parts.get(0), parts.get(1));
    } else if (formula instanceof Power) {
      return new Power(parts.get(0), parts.get(1));
    } else if (formula instanceof Negation) {
      return new Negation(parts.get(0));
    } else if (formula instanceof Call call) {
      return Expression.call(call.function(), parts);
    } else if (formula instanceof Composed) {
      return parts.get(0);
    }
    return new TableValue(((TableValue) formula).table(), parts);
  }

  @Override
  public List<Expression> pairForce(PairForce force) {
    // a pair that tells no load has its formulas watched
    return force.outputs().size() > 1 ? List.of(force.load()) : force.wrench();
  }

  @Override
  public List<Expression> lawForce(LawForce force) {
    Expressions e = new Expressions();
    List<Expression> leaves = new ArrayList<>();
    for (int i = 0; i < RelativeMotion.COUNT; i++) {
      leaves.add(new RelativeMotion(force.frame1(), force.frame2(), i));
    }
    leaves.addAll(force.numbers());
    List<Scalar> numbers = new ArrayList<>();
    for (int i = 0; i < force.numbers().size(); i++) {
      boolean isKnown = force.numbers().get(i) instanceof Constant;
      numbers.add(
          isKnown
              ? e.constant(((Constant) force.numbers().get(i)).value())
              : e.input(RelativeMotion.COUNT + i));
    }
    PairLoad load = force.law().of(Frames.ofInputs(e), numbers);
    ScalarFormulas formulas = new ScalarFormulas(leaves);
    List<Expression> wrench = new ArrayList<>();
    load.moment().components().forEach(component -> wrench.add(formulas.of(component)));
    load.force().components().forEach(component -> wrench.add(formulas.of(component)));
    return wrench;
  }

  @Override
  public List<Expression> forceTorque(ForceTorque force) {
    return formulas(force);
  }

  @Override
  public List<Expression> jointForce(JointForce force) {
    return formulas(force);
  }

  private static List<Expression> formulas(ForceElement force) {
    return force.formulas().stream().map(ForceElement.Formula::expression).toList();
  }

  @Override
  public List<Expression> bushing(Bushing force) {
    return List.of();
  }

  @Override
  public List<Expression> jointFriction(JointFriction force) {
    return List.of();
  }

  /** A user's class states no formulas. */
  @Override
  public List<Expression> userForce(UserForceElement force) {
    return List.of();
  }
}
