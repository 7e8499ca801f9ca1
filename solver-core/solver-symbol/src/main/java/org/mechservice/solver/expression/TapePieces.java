package org.mechservice.solver.expression;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import org.mechservice.solver.expression.Expression.ParameterValue;
import org.mechservice.solver.expression.Expression.Time;
import org.mechservice.solver.symbol.Corners;
import org.mechservice.solver.symbol.MathFunction;
import org.mechservice.solver.symbol.ProgramSteps;
import org.mechservice.solver.symbol.WatchedStep;

/**
 * The smooth pieces of a tape: which branch each of its choices takes, at a point, along a short
 * way and all over a box of leaves, and which choices matter there.
 *
 * <p>A choice is an operation that is made of pieces: {@code abs}, {@code min} and {@code max},
 * {@code step}, {@code signum}, {@code floor}, {@code smoothStep} and tables of straight lines. A
 * choice matters if it can change a result: the factor of a product whose other factor is exactly
 * zero does not, nor does an argument that {@code max} does not take, nor what stands in a {@code
 * step} that keeps its value. Choices of time alone are left out, since steps end where they
 * change.
 *
 * <p>Workspace of one thread; nothing allocates after construction.
 */
public final class TapePieces {
  private final Tape tape;
  private final TapeBounds bounds;
  private final double[] low;
  private final double[] high;
  private final boolean[] matters;
  private final double[] room = new double[ProgramSteps.ARGUMENTS];

  /** Steps that are choices of the state, and the index among them of each step, −1 of others. */
  private final int[] choices;

  private final int[] choiceAt;

  /** Number of results that are formulas, and the choices that the other results are. */
  private final int formulas;

  private final int[] signs;
  private final boolean[] isSign;
  private final boolean canBeNarrow;
  private boolean even;
  private final int[] undecided;
  private int undecidedCount;

  /**
   * Makes a workspace for a tape.
   *
   * @param formulas number of results that are formulas; the others, behind them, are choices whose
   *     piece alone counts, whatever stands in their argument
   */
  public TapePieces(Tape tape, int formulas) {
    this(tape, formulas, false);
  }

  /**
   * Makes a workspace for the choice that a tape of time and parameters ends with; every table is
   * one.
   */
  public static TapePieces ofTime(Tape tape) {
    return new TapePieces(tape, 0, true);
  }

  private TapePieces(Tape tape, int formulas, boolean ofTime) {
    this.tape = tape;
    this.formulas = formulas;
    int slots = tape.initial.length;
    bounds = new TapeBounds(tape);
    low = bounds.low;
    high = bounds.high;
    matters = new boolean[slots];
    boolean[] moves = moving(tape, slots, ofTime);
    choiceAt = new int[tape.target.length];
    int[] found = new int[tape.target.length];
    int count = 0;
    for (int i = 0; i < found.length; i++) {
      WatchedStep step = tape.operation[i];
      boolean watched =
          moves[tape.target[i]]
              && (ofTime ? tape.target[i] == tape.result[0] && hasPlaces(step) : step.hasPieces());
      choiceAt[i] = watched ? count : -1;
      if (watched) {
        found[count++] = i;
      }
    }
    choices = Arrays.copyOf(found, count);
    undecided = new int[count];
    isSign = new boolean[count];
    canBeNarrow = IntStream.range(0, found.length).anyMatch(bounds::isNarrow);
    for (int i = 0; i < found.length; i++) {
      for (int r = formulas; r < tape.result.length; r++) {
        if (choiceAt[i] >= 0 && tape.result[r] == tape.target[i]) {
          isSign[choiceAt[i]] = true;
        }
      }
    }
    signs = IntStream.range(0, count).filter(choice -> isSign[choice]).toArray();
  }

  /** Returns whether a choice is one of those whose piece alone counts. */
  public boolean isSign(int choice) {
    return isSign[choice];
  }

  private static boolean hasPlaces(WatchedStep step) {
    return step instanceof TableCurve || step instanceof MapSurface || step.hasPieces();
  }

  private static boolean[] moving(Tape tape, int slots, boolean withTime) {
    boolean[] moves = new boolean[slots];
    for (int leaf = 0; leaf < tape.leafSlot.length; leaf++) {
      Expression one = tape.leaves().get(leaf);
      moves[tape.leafSlot[leaf]] =
          !(one instanceof ParameterValue) && (withTime || !(one instanceof Time));
    }
    for (int i = 0; i < tape.target.length; i++) {
      moves[tape.target[i]] = moves[tape.first[i]] || moves[tape.second[i]];
    }
    return moves;
  }

  /** Returns whether any formula can be large over a short way without a choice. */
  public boolean canBeNarrow() {
    return canBeNarrow;
  }

  /** Returns the number of choices of the state. */
  public int choiceCount() {
    return choices.length;
  }

  /** Returns the number of formulas. */
  public int formulaCount() {
    return formulas;
  }

  /** Returns the tape and its choices as lists. */
  public TapeListing listing() {
    List<TapeListing.Step> steps = new ArrayList<>();
    for (int i = 0; i < tape.target.length; i++) {
      WatchedStep step = tape.operation[i];
      Optional<TableCurve> curve =
          step instanceof TableCurve table ? Optional.of(table) : Optional.empty();
      Optional<MapSurface> map =
          step instanceof MapSurface table ? Optional.of(table) : Optional.empty();
      steps.add(
          new TapeListing.Step(
              step.name(), tape.target[i], tape.first[i], tape.second[i], choiceAt[i], curve, map));
    }
    return new TapeListing(
        IntStream.of(tape.leafSlot).boxed().toList(),
        IntStream.range(0, formulas).mapToObj(r -> tape.result[r]).toList(),
        DoubleStream.of(tape.initial).boxed().toList(),
        steps,
        IntStream.range(0, choices.length)
            .mapToObj(c -> new TapeListing.Choice(choices[c], isSign[c]))
            .toList(),
        canBeNarrow);
  }

  /** Returns an array for the values at a point. */
  public double[] newPoint() {
    return tape.initial.clone();
  }

  /**
   * Evaluates the tape at a point.
   *
   * @param leaves values of the leaves; more numbers may follow them
   * @param point as made by {@link #newPoint}; overwritten
   */
  public void at(double[] leaves, double[] point) {
    for (int leaf = 0; leaf < tape.leafSlot.length; leaf++) {
      point[tape.leafSlot[leaf]] = leaves[leaf];
    }
    tape.evaluate(point, room);
  }

  /** Returns a formula's value at a point. */
  public double value(int formula, double[] point) {
    return point[tape.result[formula]];
  }

  /** Returns the value of a leaf at a point. */
  public double leaf(int leaf, double[] point) {
    return point[tape.leafSlot[leaf]];
  }

  /**
   * Returns the number of the piece that a choice takes at a point. Neighbouring pieces of a choice
   * of one argument have neighbouring numbers.
   */
  public double piece(int choice, double[] point) {
    int i = choices[choice];
    return tape.operation[i].piece(point[tape.first[i]], point[tape.second[i]]);
  }

  /**
   * Returns how far the argument of a choice is, at a point, from where its piece ends, in the unit
   * of the argument.
   */
  public double distance(int choice, double[] point) {
    int i = choices[choice];
    return tape.operation[i].distance(point[tape.first[i]], point[tape.second[i]]);
  }

  /** Sets the interval of a leaf. */
  public void setLeaf(int leaf, double lowest, double highest) {
    int slot = tape.leafSlot[leaf];
    low[slot] = lowest;
    high[slot] = highest;
  }

  /**
   * Bounds all values over the box of the leaves and finds the choices that matter and are not the
   * same all over it.
   *
   * @return whether there is none
   */
  public boolean decide() {
    bounds.ofBox();
    return findOpen();
  }

  /**
   * Bounds all values along a short way and finds the choices that matter and are not the same all
   * along it.
   *
   * @param start point at its start; not modified
   * @param middle point in the middle of its time; not modified
   * @param end point at its end; not modified
   * @return whether there is none
   */
  public boolean decide(double[] start, double[] middle, double[] end) {
    bounds.ofWay(start, middle, end);
    return findOpen();
  }

  private boolean findOpen() {
    Arrays.fill(matters, false);
    for (int r = 0; r < formulas; r++) {
      matters[tape.result[r]] = true;
    }
    undecidedCount = 0;
    even = true;
    for (int i = tape.target.length - 1; i >= 0; i--) {
      if (matters[tape.target[i]]) {
        passOn(i);
      }
    }
    for (int choice : signs) {
      int i = choices[choice];
      if (!matters[tape.target[i]] && !bounds.isDecided(i)) {
        undecided[undecidedCount++] = choice;
      }
    }
    return undecidedCount == 0;
  }

  /** Marks the operands that matter to a step that does, and notes a choice that is open. */
  private void passOn(int i) {
    int a = tape.first[i];
    int b = tape.second[i];
    if (tape.kind[i] == Tape.PRODUCT) {
      boolean aIsZero = bounds.isZero(a);
      matters[a] |= aIsZero || !bounds.isZero(b);
      matters[b] |= !aIsZero;
    } else if (tape.kind[i] == Tape.OTHER) {
      even &= !bounds.isNarrow(i) || bounds.isEven(i);
      boolean open = choiceAt[i] >= 0 && !bounds.isDecided(i);
      if (open) {
        undecided[undecidedCount++] = choiceAt[i];
      }
      passOn(tape.operation[i], tape.target[i], open, a, b);
    } else {
      matters[a] = true;
      matters[b] = true;
    }
  }

  private void passOn(WatchedStep step, int target, boolean open, int a, int b) {
    if (step == Operation.DIVIDE) {
      matters[a] = true;
      matters[b] |= !bounds.isZero(a);
    } else if (step instanceof MathFunction function) {
      passOn(function, target, open, a, b);
    } else {
      matters[a] = true;
      matters[b] = true;
    }
  }

  private void passOn(MathFunction function, int target, boolean open, int a, int b) {
    if (function == MathFunction.SMOOTH) {
      return; // no choice inside matters
    } else if (function.isChoice()) {
      int least = function.choice().get(0) == 0 ? a : b;
      int most = least == a ? b : a;
      matters[a] |= low[least] <= high[most];
      matters[b] |= low[most] <= high[least];
    } else if (function.isPart()) {
      matters[a] |= open;
      matters[b] |= !bounds.isZero(target);
    } else if (function.jumps()) {
      matters[a] |= open;
    } else if (function.corners() == Corners.BORDERS) {
      matters[a] |= high[a] >= 0 && low[a] <= 1;
    } else {
      matters[a] = true;
      matters[b] |= !function.zeroStaysZero() || !bounds.isZero(a);
    }
  }

  /**
   * Returns whether the formulas change evenly all over the box of the last {@link #decide}, so
   * that a parabola through three of their values describes them.
   */
  public boolean isEven() {
    return even;
  }

  /** Returns the number of choices that {@link #decide} has left open. */
  public int undecidedCount() {
    return undecidedCount;
  }

  /** Returns one of them, as an index among the choices. */
  public int undecided(int index) {
    return undecided[index];
  }

  /**
   * Returns how far the argument of an open choice can go beyond the boundary between its pieces in
   * the box of the last {@link #decide}, in the unit of the argument; for a choice of many pieces,
   * how far it can go at all. Infinite for a choice whose value jumps.
   */
  public double excursion(int choice) {
    int i = choices[choice];
    int a = tape.first[i];
    int b = tape.second[i];
    if (tape.operation[i] instanceof MathFunction function && function.jumps()) {
      return Double.POSITIVE_INFINITY;
    }
    Corners corners =
        tape.operation[i] instanceof MathFunction function ? function.corners() : Corners.NONE;
    return switch (corners) {
      case EQUAL -> Math.min(high[a] - low[b], high[b] - low[a]);
      case SIDES, ZERO -> Math.min(-low[a], high[a]);
      default -> Math.max(high[a] - low[a], high[b] - low[b]);
    };
  }

  /** Returns whether the value of a choice jumps where its piece changes. */
  public boolean jumps(int choice) {
    return tape.operation[choices[choice]] instanceof MathFunction function && function.jumps();
  }

  /**
   * Returns the largest size of what decides a choice, in the box of {@link #decide}: of a part the
   * first argument, since the second is its value.
   */
  public double size(int choice) {
    int i = choices[choice];
    boolean isPart = tape.operation[i] instanceof MathFunction function && function.isPart();
    int a = tape.first[i];
    int b = isPart ? a : tape.second[i];
    return Math.max(Math.max(-low[a], high[a]), Math.max(-low[b], high[b]));
  }

  /** Returns the lower bound of a formula after {@link #decide}. */
  public double low(int formula) {
    return low[tape.result[formula]];
  }

  /** Returns the upper bound of a formula after {@link #decide}. */
  public double high(int formula) {
    return high[tape.result[formula]];
  }
}
