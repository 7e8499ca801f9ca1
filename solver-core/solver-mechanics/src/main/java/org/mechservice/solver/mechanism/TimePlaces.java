package org.mechservice.solver.mechanism;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Collections;
import java.util.Deque;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.DoubleStream;
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
import org.mechservice.solver.expression.Tape;
import org.mechservice.solver.expression.TapePieces;
import org.mechservice.solver.mechanism.closure.CoordinateClosure;
import org.mechservice.solver.mechanism.closure.JointClosure;
import org.mechservice.solver.mechanism.closure.LoopClosure;
import org.mechservice.solver.mechanism.force.ForceElement;
import org.mechservice.solver.symbol.Corners;
import org.mechservice.solver.symbol.MathFunction;

/**
 * The places in time at which a mechanism's equations change their form because of an expression of
 * time: {@code step(t-1)} at 1 s, {@code floor(10*t)} every tenth of a second, {@code
 * smoothStep(t*t-4)} at 2 and √5 s. Steps end there.
 *
 * <p>A place is a change of a choice whose argument depends on time and parameters alone: {@code
 * step}, {@code signum}, {@code floor}, {@code abs}, {@code min}, {@code max}, {@code smoothStep},
 * tables and maps. If the argument is c₀ + c₁ t, it follows from that; if not, the interval is
 * halved until {@linkplain TapePieces interval arithmetic} excludes a change in a part or the part
 * is as short as the resolution, so that no change is overlooked, however close others are.
 */
final class TimePlaces {
  /** Halvings of the interval after which a part counts as a place. */
  private static final int HALVINGS = 42;

  /** Further halvings by which a place is narrowed down. */
  private static final int NARROWINGS = 60;

  /** Doublings of the last place of time up to which it is asked whether rounding decides. */
  private static final int DOUBLINGS = 9;

  /** Doublings that steps keep off a place in any case. */
  private static final int FINE = 1;

  private final List<Parameter> parameters;
  private final double from;
  private final double to;
  private final TreeSet<Double> times = new TreeSet<>();

  /** What {@link #search} has met; parts may be shared. */
  private final Set<Expression> searched = Collections.newSetFromMap(new IdentityHashMap<>());

  private final IdentityHashMap<Expression, Optional<Line>> lines = new IdentityHashMap<>();
  private final IdentityHashMap<Expression, Dependence> dependences = new IdentityHashMap<>();

  /** What a formula depends on: nothing that changes, time alone, or more. */
  private enum Dependence {
    NOTHING,
    TIME,
    STATE;

    Dependence and(Dependence other) {
      return compareTo(other) < 0 ? other : this;
    }
  }

  private TimePlaces(List<Parameter> parameters, double from, double to) {
    this.parameters = parameters;
    this.from = from;
    this.to = to;
  }

  /**
   * Returns the places in an interval, ascending; the first million if there are more.
   *
   * @param from start of the interval, s; finite
   * @param to its end, s; finite
   */
  static List<Double> of(Mechanism mechanism, double from, double to) {
    TimePlaces places = new TimePlaces(mechanism.parameters(), from, to);
    formulas(mechanism).forEach(places::search);
    return List.copyOf(places.times);
  }

  /** Returns whether any choice of a mechanism's formulas depends on time alone. */
  static boolean possible(Mechanism mechanism) {
    TimePlaces places = new TimePlaces(mechanism.parameters(), 0, 0);
    return formulas(mechanism).stream().anyMatch(places::hasChoice);
  }

  private static List<Expression> formulas(Mechanism mechanism) {
    List<Expression> all = new ArrayList<>();
    mechanism.motions().forEach(motion -> all.addAll(motion.coordinates()));
    for (LoopClosure closure : mechanism.closures()) {
      if (closure instanceof CoordinateClosure coupling) {
        all.add(coupling.relation());
      } else if (closure instanceof JointClosure cut) {
        all.addAll(cut.motion());
      }
    }
    for (ForceElement force : mechanism.forces()) {
      force.formulas().forEach(formula -> all.add(formula.expression()));
    }
    mechanism.furtherStates().forEach(state -> all.add(state.derivative()));
    return all;
  }

  /** Searches an expression and its parts; without recursion, since sums can be deep. */
  private void search(Expression root) {
    Deque<Expression> open = new ArrayDeque<>();
    open.push(root);
    while (!open.isEmpty()) {
      Expression next = open.pop();
      if (searched.add(next)) {
        Expression.operands(next).forEach(open::push);
        if (isChoiceOfTime(next)) {
          choice(next);
        }
      }
    }
  }

  private boolean hasChoice(Expression root) {
    Deque<Expression> open = new ArrayDeque<>();
    open.push(root);
    while (!open.isEmpty()) {
      Expression next = open.pop();
      if (searched.add(next)) {
        Expression.operands(next).forEach(open::push);
        if (isChoiceOfTime(next)) {
          return true;
        }
      }
    }
    return false;
  }

  private boolean isChoiceOfTime(Expression part) {
    if (part instanceof Call call) {
      return call.function().corners() != Corners.NONE && isOfTime(part);
    }
    return part instanceof TableValue && isOfTime(part);
  }

  /** Returns whether an expression depends on time, and on nothing else that changes. */
  private boolean isOfTime(Expression expression) {
    Deque<Expression> open = new ArrayDeque<>();
    open.push(expression);
    while (!open.isEmpty()) {
      Expression next = open.element();
      Dependence all = dependence(next);
      for (Expression operand : Expression.operands(next)) {
        Dependence known = dependences.get(operand);
        if (known == null) {
          open.push(operand);
        } else {
          all = all.and(known);
        }
      }
      if (next == open.element()) {
        open.pop();
        dependences.put(next, all);
      }
    }
    return dependences.get(expression) == Dependence.TIME;
  }

  /** Returns what an expression itself depends on, without its operands. */
  private static Dependence dependence(Expression part) {
    if (part instanceof Time) {
      return Dependence.TIME;
    }
    boolean moves =
        !(part instanceof Constant)
            && !(part instanceof ParameterValue)
            && Expression.operands(part).isEmpty();
    return moves ? Dependence.STATE : Dependence.NOTHING;
  }

  /** Adds the places of a choice. */
  private void choice(Expression part) {
    List<Optional<Line>> arguments = Expression.operands(part).stream().map(this::line).toList();
    if (!arguments.stream().allMatch(Optional::isPresent)) {
      searchInterval(part);
    } else if (part instanceof TableValue value) {
      corners(value);
    } else {
      lines(((Call) part).function(), arguments);
    }
  }

  private void lines(MathFunction function, List<Optional<Line>> arguments) {
    Line line = arguments.get(0).orElseThrow();
    Line other = arguments.get(arguments.size() - 1).orElseThrow();
    switch (function.corners()) {
      case EQUAL -> addMeeting(line, other);
      case WHOLE_NUMBERS -> {
        if (line.slope() != 0) {
          addWholes(line);
        }
      }
      default -> {
        if (line.slope() != 0) {
          DoubleStream.of(function.corners().places()).map(line::where).forEach(this::add);
        }
      }
    }
  }

  /** Finds the places of a choice with any argument. */
  private void searchInterval(Expression part) {
    Tape tape = new Tape(List.of(part));
    TapePieces pieces = TapePieces.ofTime(tape);
    if (pieces.choiceCount() == 0) {
      return;
    }
    double[] leaves = new double[tape.leaves().size()];
    int time = tape.leaves().indexOf(new Time());
    for (int i = 0; i < leaves.length; i++) {
      if (tape.leaves().get(i) instanceof ParameterValue parameter) {
        leaves[i] = parameters.get(parameter.index()).value();
        pieces.setLeaf(i, leaves[i], leaves[i]);
      }
    }
    if (Double.isFinite(to - from)) {
      halve(new Search(pieces, leaves, time), from, to, 0);
    }
  }

  /** A choice as a function of time. */
  private static final class Search {
    private final TapePieces pieces;
    private final double[] leaves;
    private final int time;
    private final double[] point;

    /**
     * @param leaves values of the leaves; that of the time changes
     * @param time index of the time among them
     */
    Search(TapePieces pieces, double[] leaves, int time) {
      this.pieces = pieces;
      this.leaves = leaves;
      this.time = time;
      point = pieces.newPoint();
    }

    boolean isDecided(double start, double end) {
      pieces.setLeaf(time, start, end);
      return pieces.decide();
    }

    /** Returns whether the choice takes a piece, and its argument is off where that ends. */
    boolean isClear(double t, double piece) {
      return piece(t) == piece && pieces.distance(0, point) > 0;
    }

    /** Returns the number of the piece of the choice. */
    double piece(double t) {
      leaves[time] = t;
      pieces.at(leaves, point);
      return pieces.piece(0, point);
    }
  }

  private void halve(Search search, double start, double end, int depth) {
    if (times.size() >= Mechanism.MOST_TIME_JUMPS || search.isDecided(start, end)) {
      return;
    }
    double middle = 0.5 * (start + end);
    if (depth < HALVINGS && middle > start && middle < end) {
      halve(search, start, middle, depth + 1);
      halve(search, middle, end, depth + 1);
      return;
    }
    double last = search.piece(end);
    if (search.piece(start) == last) {
      return;
    }
    double before = start;
    double behind = end;
    for (int i = 0; i < NARROWINGS; i++) {
      double between = 0.5 * (before + behind);
      if (!(between > before && between < behind)) {
        break;
      }
      if (search.piece(between) == last) {
        behind = between;
      } else {
        before = between;
      }
    }
    double zone = rounding(search, behind, search.piece(start), last);
    if (zone > 0) {
      add(behind - zone);
      add(behind + zone);
    } else {
      add(behind);
    }
  }

  /**
   * Returns half the width of the times in which rounding decides which piece is taken, where that
   * is more than some last places of time: the argument may be coarser than time. Both ends of it
   * are places, and one to the integrator.
   */
  private static double rounding(Search search, double place, double before, double behind) {
    double width = Math.ulp(place);
    for (int i = 0; i < DOUBLINGS; i++) {
      if (search.isClear(place - width, before) && search.isClear(place + width, behind)) {
        return i <= FINE ? 0 : 2 * width;
      }
      width *= 2;
    }
    return 0;
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
    for (int i = 0; i < Mechanism.MOST_TIME_JUMPS && first + i <= last; i++) {
      add(line.where(first + i));
    }
  }

  private void add(double t) {
    if (t >= from && t <= to && times.size() < Mechanism.MOST_TIME_JUMPS) {
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
