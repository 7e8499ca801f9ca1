package org.mechservice.solver.expression;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import org.mechservice.solver.expression.Expression.ParameterValue;
import org.mechservice.solver.expression.Expression.Time;

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
 * <p>Along a short way the values at its start, middle and end are given. An operation that changes
 * evenly stays near the parabola through its three values, with a margin of {@value #MARGIN} of its
 * bow; the others are bounded by interval arithmetic. A parabola passes its points by 1/8 of the
 * second difference at most, so that the margin covers three times as much for what is none.
 *
 * <p>Workspace of one thread; nothing allocates after construction.
 */
public final class TapePieces {
  /** Margin beside three values, relative to their second difference. */
  private static final double MARGIN = 0.5;

  /** Change of an argument within which exponential and hyperbolic functions change evenly. */
  private static final double EVEN = 0.5;

  /** Factor within which a divisor may change for its quotient to change evenly. */
  private static final double RATIO = 2;

  /** Exponent below which an exponential is nothing; twice the argument beyond which tanh is 1. */
  private static final double NOTHING = -40;

  private final Tape tape;
  private final LocalDerivatives local = new LocalDerivatives();
  private final Enclosure enclosure = new Enclosure();
  private final double[] low;
  private final double[] high;
  private final boolean[] matters;

  /** Slots whose way is no parabola. */
  private final boolean[] rough;

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
    low = tape.initial.clone();
    high = tape.initial.clone();
    matters = new boolean[slots];
    rough = new boolean[slots];
    boolean[] moves = moving(tape, slots, ofTime);
    choiceAt = new int[tape.target.length];
    int[] found = new int[tape.target.length];
    int count = 0;
    for (int i = 0; i < found.length; i++) {
      TapeStep step = tape.operation[i];
      boolean watched =
          moves[tape.target[i]]
              && (ofTime ? tape.target[i] == tape.result[0] && hasPlaces(step) : hasPieces(step));
      choiceAt[i] = watched ? count : -1;
      if (watched) {
        found[count++] = i;
      }
    }
    choices = Arrays.copyOf(found, count);
    undecided = new int[count];
    isSign = new boolean[count];
    canBeNarrow = Arrays.stream(tape.operation).anyMatch(TapePieces::isNarrow);
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

  private static boolean hasPlaces(TapeStep step) {
    return !(step instanceof Operation) || hasPieces(step);
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

  private static boolean hasPieces(TapeStep step) {
    if (step instanceof Operation operation) {
      return switch (operation) {
        case ABS, MIN, MAX, SIGNUM, FLOOR, STEP, SMOOTH_STEP -> true;
        case ADD,
            MULTIPLY,
            DIVIDE,
            NEGATE,
            SQUARE,
            SQRT,
            SIN,
            COS,
            TAN,
            ASIN,
            ACOS,
            ATAN,
            ATAN2,
            EXP,
            LOG,
            SINH,
            COSH,
            TANH,
            HYPOT,
            POWER ->
            false;
      };
    }
    return step instanceof TableCurve curve ? curve.hasCorners() : ((MapSurface) step).hasCorners();
  }

  /**
   * Returns whether an operation that is no choice can change much while its argument hardly does.
   */
  private static boolean isNarrow(TapeStep step) {
    if (step instanceof Operation operation) {
      return switch (operation) {
        case DIVIDE, TAN, ATAN, EXP, SINH, COSH, TANH, POWER -> true;
        case ADD,
            MULTIPLY,
            NEGATE,
            SQUARE,
            SQRT,
            ABS,
            SIN,
            COS,
            ASIN,
            ACOS,
            ATAN2,
            LOG,
            MIN,
            MAX,
            SIGNUM,
            HYPOT,
            FLOOR,
            STEP,
            SMOOTH_STEP ->
            false;
      };
    }
    return !hasPieces(step);
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
      TapeStep step = tape.operation[i];
      Optional<TableCurve> curve =
          step instanceof TableCurve table ? Optional.of(table) : Optional.empty();
      Optional<MapSurface> map =
          step instanceof MapSurface table ? Optional.of(table) : Optional.empty();
      String name =
          step instanceof Operation operation
              ? operation.name()
              : curve.isPresent() ? "CURVE" : "MAP";
      steps.add(
          new TapeListing.Step(
              name, tape.target[i], tape.first[i], tape.second[i], choiceAt[i], curve, map));
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
    for (int i = 0; i < tape.target.length; i++) {
      point[tape.target[i]] =
          tape.operation[i].value(point[tape.first[i]], point[tape.second[i]], local);
    }
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
    return piece(tape.operation[i], point[tape.first[i]], point[tape.second[i]]);
  }

  /**
   * Returns how far the argument of a choice is, at a point, from where its piece ends, in the unit
   * of the argument.
   */
  public double distance(int choice, double[] point) {
    int i = choices[choice];
    double a = point[tape.first[i]];
    double b = point[tape.second[i]];
    TapeStep step = tape.operation[i];
    if (step instanceof Operation operation) {
      return switch (operation) {
        case MIN, MAX -> Math.abs(a - b);
        case FLOOR -> Math.abs(a - Math.rint(a));
        case SMOOTH_STEP -> Math.min(Math.abs(a), Math.abs(a - 1));
        default -> Math.abs(a);
      };
    }
    return step instanceof TableCurve curve
        ? curve.distanceFromPoint(a)
        : ((MapSurface) step).distanceFromLine(a, b);
  }

  private static double piece(TapeStep step, double a, double b) {
    if (step instanceof Operation operation) {
      return switch (operation) {
        case ABS, STEP -> a < 0 ? 0 : 1;
        case SIGNUM -> Math.signum(a);
        case FLOOR -> Math.floor(a);
        case SMOOTH_STEP -> a < 0 ? 0 : a <= 1 ? 1 : 2;
        case MIN, MAX -> a < b ? 0 : 1;
        default -> 0;
      };
    }
    return step instanceof TableCurve curve ? curve.place(a) : ((MapSurface) step).place(a, b);
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
    for (int i = 0; i < tape.target.length; i++) {
      enclose(i);
    }
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
    for (int slot : tape.leafSlot) {
      follow(slot, start, middle, end);
    }
    for (int i = 0; i < tape.target.length; i++) {
      int target = tape.target[i];
      rough[target] = rough[tape.first[i]] || rough[tape.second[i]] || !changesEvenly(i);
      if (rough[target]) {
        enclose(i);
      } else {
        follow(target, start, middle, end);
      }
    }
    return findOpen();
  }

  private void enclose(int i) {
    int a = tape.first[i];
    int b = tape.second[i];
    enclosure.of(tape.operation[i], low[a], high[a], low[b], high[b]);
    low[tape.target[i]] = enclosure.low;
    high[tape.target[i]] = enclosure.high;
  }

  private void follow(int slot, double[] start, double[] middle, double[] end) {
    double a = start[slot];
    double m = middle[slot];
    double b = end[slot];
    double bow = MARGIN * Math.abs(a - 2 * m + b);
    low[slot] = Math.min(a, Math.min(m, b)) - bow;
    high[slot] = Math.max(a, Math.max(m, b)) + bow;
  }

  /** Returns whether an operation changes evenly within the bounds of its operands. */
  private boolean changesEvenly(int i) {
    TapeStep step = tape.operation[i];
    int a = tape.first[i];
    int b = tape.second[i];
    if (isNarrow(step)) {
      return isEven(step, i);
    } else if (!(step instanceof Operation)) {
      return isDecided(step, a, b);
    }
    return switch ((Operation) step) {
      case ADD, NEGATE -> true;
      // curved factors that pass through zero make a corner that no three points show
      case SQUARE -> !reachesZero(a);
      case MULTIPLY -> !(reachesZero(a) && reachesZero(b));
      case SIN, COS -> high[a] - low[a] <= EVEN;
      case SQRT, LOG -> changesLittle(low[a], high[a], RATIO);
      case ABS, MIN, MAX, SIGNUM, FLOOR, STEP, SMOOTH_STEP -> isDecided(step, a, b);
      case ASIN, ACOS -> high[a] < EVEN && low[a] > -EVEN;
      case HYPOT -> changesLittle(low[a], high[a], RATIO) || changesLittle(low[b], high[b], RATIO);
      case ATAN2 -> changesLittle(low[b], high[b], RATIO) && low[b] > 0;
      case DIVIDE, TAN, ATAN, EXP, SINH, COSH, TANH, POWER -> isEven(step, i);
    };
  }

  private boolean reachesZero(int slot) {
    return low[slot] <= 0 && high[slot] >= 0;
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
      if (!matters[tape.target[i]]
          && !isDecided(tape.operation[i], tape.first[i], tape.second[i])) {
        undecided[undecidedCount++] = choice;
      }
    }
    return undecidedCount == 0;
  }

  /** Marks the operands that matter to a step that does, and notes a choice that is open. */
  private void passOn(int i) {
    int a = tape.first[i];
    int b = tape.second[i];
    TapeStep step = tape.operation[i];
    even &= !isNarrow(step) || isEven(step, i);
    boolean open = choiceAt[i] >= 0 && !isDecided(step, a, b);
    if (open) {
      undecided[undecidedCount++] = choiceAt[i];
    }
    if (step instanceof Operation operation) {
      switch (operation) {
        case MULTIPLY -> {
          boolean aIsZero = isZero(a);
          matters[a] |= aIsZero || !isZero(b);
          matters[b] |= !aIsZero;
        }
        case DIVIDE, POWER -> {
          matters[a] = true;
          matters[b] |= !isZero(a);
        }
        case MIN -> {
          matters[a] |= low[a] <= high[b];
          matters[b] |= low[b] <= high[a];
        }
        case MAX -> {
          matters[a] |= high[a] >= low[b];
          matters[b] |= high[b] >= low[a];
        }
        case STEP, SIGNUM, FLOOR -> matters[a] |= open;
        case SMOOTH_STEP -> matters[a] |= high[a] >= 0 && low[a] <= 1;
        default -> {
          matters[a] = true;
          matters[b] = true;
        }
      }
    } else {
      matters[a] = true;
      matters[b] = true;
    }
  }

  /** Returns whether an operation that can be narrow changes evenly all over the box. */
  private boolean isEven(TapeStep step, int i) {
    double aLow = low[tape.first[i]];
    double aHigh = high[tape.first[i]];
    double bLow = low[tape.second[i]];
    double bHigh = high[tape.second[i]];
    if (step instanceof Operation operation) {
      return switch (operation) {
        case DIVIDE -> changesLittle(bLow, bHigh, RATIO);
        case EXP -> aHigh - aLow <= EVEN || aHigh < NOTHING;
        case TANH -> aHigh - aLow <= EVEN || 2 * aHigh < NOTHING || 2 * aLow > -NOTHING;
        case ATAN -> aHigh - aLow <= EVEN || changesLittle(aLow, aHigh, RATIO);
        case POWER ->
            high[tape.target[i]] < StrictMath.exp(NOTHING)
                || changesLittle(aLow, aHigh, Powers.power(RATIO, 1 / Math.max(1, bHigh)));
        default -> aHigh - aLow <= EVEN;
      };
    }
    return step instanceof TableCurve curve
        ? curve.place(aHigh) - curve.place(aLow) <= 1
        : ((MapSurface) step).crossings(aLow, aHigh, bLow, bHigh) <= 1;
  }

  private static boolean changesLittle(double lowest, double highest, double ratio) {
    return lowest > 0 ? highest <= ratio * lowest : highest < 0 && lowest >= ratio * highest;
  }

  /**
   * Returns whether the formulas change evenly all over the box of the last {@link #decide}, so
   * that a parabola through three of their values describes them.
   */
  public boolean isEven() {
    return even;
  }

  private boolean isZero(int slot) {
    return low[slot] == 0 && high[slot] == 0;
  }

  private boolean isDecided(TapeStep step, int a, int b) {
    if (step == Operation.MIN || step == Operation.MAX) {
      boolean apart = high[a] < low[b] || low[a] >= high[b];
      return apart || (isZero(a) && isZero(b));
    }
    return piece(step, low[a], low[b]) == piece(step, high[a], high[b]);
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
    TapeStep step = tape.operation[i];
    if (step == Operation.MIN || step == Operation.MAX) {
      return Math.min(high[a] - low[b], high[b] - low[a]);
    } else if (step == Operation.ABS) {
      return Math.min(-low[a], high[a]);
    } else if (step == Operation.SMOOTH_STEP || !(step instanceof Operation)) {
      return Math.max(high[a] - low[a], high[b] - low[b]);
    }
    return Double.POSITIVE_INFINITY;
  }

  /** Returns whether the value of a choice jumps where its piece changes. */
  public boolean jumps(int choice) {
    TapeStep step = tape.operation[choices[choice]];
    return step == Operation.STEP || step == Operation.SIGNUM || step == Operation.FLOOR;
  }

  /** Returns the largest size of the arguments of a choice in the box of {@link #decide}. */
  public double size(int choice) {
    int a = tape.first[choices[choice]];
    int b = tape.second[choices[choice]];
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
