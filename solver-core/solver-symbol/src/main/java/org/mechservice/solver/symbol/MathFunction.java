package org.mechservice.solver.symbol;

import static org.mechservice.solver.symbol.FunctionTraits.MATH;
import static org.mechservice.solver.symbol.FunctionTraits.SPATIAL;
import static org.mechservice.solver.symbol.FunctionTraits.composed;
import static org.mechservice.solver.symbol.FunctionTraits.inner;
import static org.mechservice.solver.symbol.FunctionTraits.one;
import static org.mechservice.solver.symbol.FunctionTraits.two;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.mechservice.solver.spatial.CubicCurve;
import org.mechservice.solver.spatial.NumberTable;
import org.mechservice.solver.spatial.Piecewise;
import org.mechservice.solver.spatial.Powers;
import org.mechservice.solver.spatial.SinCos;
import org.mechservice.solver.spatial.TouchingPoint;

/**
 * The catalogue of functions: those that formulas of models, studies and benchmarks can call
 * (docs/mechml.md#values; angles in rad), and those that only derived formulas need. Whatever is
 * known of a function stands in its row: name, value, slopes, rule of units, bounds, where it is
 * not smooth, the method that generated Java calls and the function that generated C calls. The
 * parser, the check of units, differentiation, the search of steps and the printers ask it.
 *
 * <p>Values are those of a run, also for constants. They come from StrictMath, or from kernels of
 * {@code solver.spatial}, and have the same bits on every machine.
 *
 * <p>A function that is a formula of others is one row, of {@code composed}. Another needs, beside
 * its row, a function of {@code mech_math.c} with the same bits, and, if formulas can call it, its
 * cases in {@code mech_watch.c}.
 */
public enum MathFunction implements WatchedStep {
  SQRT(
      one("sqrt", Math::sqrt)
          .units(UnitRule.ROOT)
          .formula(x -> x.get(0).squareRoot())
          .risingFrom(0, Double.POSITIVE_INFINITY)
          .evenOffZero()
          .steep()),
  ABS(
      one("abs", Math::abs)
          .by(MATH, "abs")
          .units(UnitRule.SAME)
          .slope((f, i) -> FunctionFormulas.ofSize(f.first()))
          .bound((out, aLow, aHigh, bLow, bHigh) -> out.absolute(aLow, aHigh))
          .corners(Corners.SIDES)
          .exact()),
  SIN(
      one("sin", SinCos::sine)
          .by(SPATIAL + "SinCos", "sine")
          .inC("sine")
          .slope((f, i) -> Simplification.cosine(f.first()))
          .formula(x -> Simplification.sine(x.get(0)))
          .wave(0.5 * Math.PI)
          .smooth()),
  COS(
      one("cos", SinCos::cosine)
          .by(SPATIAL + "SinCos", "cosine")
          .inC("cosine")
          .slope((f, i) -> Simplification.sine(f.first()).negated())
          .formula(x -> Simplification.cosine(x.get(0)))
          .wave(0)
          .smooth()),
  TAN(composed("tan", 1, x -> Simplification.sine(x.get(0)).over(Simplification.cosine(x.get(0))))),
  ASIN(
      one("asin", StrictMath::asin)
          .units(UnitRule.ANGLE)
          .slope((f, i) -> FunctionFormulas.ofArcSine(f.first()))
          .risingFrom(-1, 1)
          .evenNearZero()
          .steep()),
  ACOS(
      one("acos", StrictMath::acos)
          .units(UnitRule.ANGLE)
          .slope((f, i) -> FunctionFormulas.ofArcSine(f.first()).negated())
          .fallingFrom(-1, 1)
          .evenNearZero()
          .steep()),
  ATAN(
      one("atan", StrictMath::atan)
          .units(UnitRule.ANGLE)
          .slope((f, i) -> FunctionFormulas.ofArcTangent(f.first()))
          .evenAlsoOffZero()
          .narrow()
          .smooth()),
  /**
   * {@code atan2(y, x)}: the angle of the point (x, y), −π … π; at the origin its slope counts as
   * 0.
   */
  ATAN2(
      two("atan2", StrictMath::atan2)
          .units(UnitRule.ANGLE_OF_TWO)
          .slope(FunctionFormulas::ofAngle)
          .bound(Enclosure::angle)
          .even(
              (aLow, aHigh, bLow, bHigh, highest) ->
                  Enclosure.changesLittle(bLow, bHigh) && bLow > 0)),
  EXP(
      one("exp", StrictMath::exp)
          .slope((f, i) -> f)
          .levelBeyond(-1, Double.POSITIVE_INFINITY)
          .steep()
          .narrow()
          .smooth()),
  /** The natural logarithm. */
  LOG(
      one("log", StrictMath::log)
          .slope((f, i) -> f.expressions().one().over(f.first()))
          .risingFrom(0, Double.POSITIVE_INFINITY)
          .evenOffZero()
          .steep()),
  /** {@code pow(a, b)} = aᵇ. A negative base requires a whole exponent. */
  POWER(
      two("pow", Powers::power)
          .by(SPATIAL + "Powers", "power")
          .units(UnitRule.POWER)
          .slope(FunctionFormulas::ofPower)
          .bound(Enclosure::power)
          .evenAsPower()
          .zeroStaysZero()
          .steep()
          .narrow()),
  /** The lesser of two; the derivative of the first if they are equal. */
  MIN(
      two("min", Math::min)
          .by(MATH, "min")
          .units(UnitRule.COMMON)
          .choice(0, 1, 0, 1)
          .bound(
              (out, aLow, aHigh, bLow, bHigh) ->
                  out.set(Math.min(aLow, bLow), Math.min(aHigh, bHigh)))
          .corners(Corners.EQUAL)
          .exact()),
  /** The greater of two; the derivative of the first if they are equal. */
  MAX(
      two("max", Math::max)
          .by(MATH, "max")
          .units(UnitRule.COMMON)
          .choice(1, 0, 0, 1)
          .bound(
              (out, aLow, aHigh, bLow, bHigh) ->
                  out.set(Math.max(aLow, bLow), Math.max(aHigh, bHigh)))
          .corners(Corners.EQUAL)
          .exact()),
  SINH(
      one("sinh", StrictMath::sinh)
          .slope((f, i) -> FunctionFormulas.ofHyperbolicSine(f.first()))
          .steep()
          .narrow()
          .smooth()),
  COSH(
      one("cosh", StrictMath::cosh)
          .slope((f, i) -> FunctionFormulas.of(MathFunction.SINH, f.first()))
          .bound(
              (out, aLow, aHigh, bLow, bHigh) -> {
                out.absolute(aLow, aHigh);
                out.rising(StrictMath::cosh, out.low(), out.high());
              })
          .steep()
          .narrow()
          .smooth()),
  TANH(
      one("tanh", StrictMath::tanh)
          .slope((f, i) -> FunctionFormulas.ofTanh(f.first()))
          .levelBeyond(-0.5, 0.5)
          .narrow()
          .smooth()),
  /** −1, 0 or 1; its derivative counts as 0 everywhere. */
  SIGNUM(one("signum", Math::signum).by(MATH, "signum").jumps(Corners.ZERO)),
  /** {@code hypot(x, y)} = √(x² + y²); at the origin its slope counts as 0. */
  HYPOT(
      two("hypot", StrictMath::hypot)
          .units(UnitRule.COMMON)
          .slope((f, i) -> f.operands().get(i).over(FunctionFormulas.notZero(f)))
          .bound(Enclosure::length)
          .even(
              (aLow, aHigh, bLow, bHigh, highest) ->
                  Enclosure.changesLittle(aLow, aHigh) || Enclosure.changesLittle(bLow, bHigh))),
  /** The greatest integer not above the argument; its derivative counts as 0 everywhere. */
  FLOOR(
      one("floor", Math::floor)
          .by(MATH, "floor")
          .units(UnitRule.COUNT)
          .jumps(Corners.WHOLE_NUMBERS)
          .repeats()),
  /** 0 below zero, 1 from zero on; its derivative counts as 0 everywhere. */
  STEP(
      one("step", x -> x < 0 ? 0 : x >= 0 ? 1 : x)
          .formula(x -> FunctionFormulas.step(x.get(0)))
          .jumps(Corners.SIDES)),
  /** 0 below zero, 1 above one, 3x² − 2x³ between. */
  SMOOTH_STEP(
      one("smoothStep", FunctionFormulas::smoothStep)
          .formula(x -> FunctionFormulas.smoothStep(x.get(0)))
          .corners(Corners.BORDERS)
          .smooth()),

  /** {@code where(a, x)}: x where a ≥ 0, else 0 whatever x is; a part of a choice on a tape. */
  WHERE(
      two("", Piecewise::where)
          .by(SPATIAL + "Piecewise", "where")
          .formula(x -> FunctionFormulas.where(x.get(0), x.get(1)))
          .bound((out, aLow, aHigh, bLow, bHigh) -> out.part(aHigh >= 0, aLow < 0, bLow, bHigh))
          .part()),
  /** {@code elsewhere(a, x)}: 0 where a ≥ 0 whatever x is, else x; the other part. */
  ELSEWHERE(
      two("", Piecewise::elsewhere)
          .by(SPATIAL + "Piecewise", "elsewhere")
          .formula(x -> FunctionFormulas.elsewhere(x.get(0), x.get(1)))
          .bound((out, aLow, aHigh, bLow, bHigh) -> out.part(aLow < 0, aHigh >= 0, bLow, bHigh))
          .part()),
  /**
   * {@code smooth(x)}: x, a formula that is known to be smooth, whatever the search of steps could
   * find out about its parts; it has no pieces that matter.
   */
  SMOOTH(
      one("", x -> x)
          .formula(x -> x.get(0))
          .slope((f, i) -> f.expressions().one())
          .even((aLow, aHigh, bLow, bHigh, highest) -> true)
          .exact()),
  /** {@code choose(a, b, x, y)}: x where a ≤ b, else y. */
  CHOOSE(
      inner("Piecewise", "choose", 4, (row, x) -> Piecewise.choose(x[0], x[1], x[2], x[3]))
          .choice(0, 1, 2, 3)),
  /** {@code product(a, b)}: a b, but 0 if one factor is 0, even if the other is infinite or NaN. */
  PRODUCT(
      two("", Piecewise::product)
          .by(SPATIAL + "Piecewise", "product")
          .slope((f, i) -> f.operands().get(1 - i))),
  /** {@code pick(a, b, x, y)}: x where a ≤ b, else y; found by a search, so without derivatives. */
  PICK(
      inner("Piecewise", "pick", 4, (row, x) -> Piecewise.pick(x[0], x[1], x[2], x[3]))
          .bound(
              (out, aLow, aHigh, bLow, bHigh) ->
                  out.set(Double.NEGATIVE_INFINITY, Double.POSITIVE_INFINITY))
          .even((aLow, aHigh, bLow, bHigh, highest) -> aHigh <= bLow || aLow > bHigh)),
  /** {@code held(x)}: x, without a derivative. */
  HELD(one("", Piecewise::held).by(SPATIAL + "Piecewise", "held")),
  /**
   * {@code interval(row, x)}: how many numbers of an ascending {@link NumberRow} are not above x, 0
   * if x is NaN.
   */
  INTERVAL(
      inner(
              "NumberTable",
              "interval",
              1,
              (row, x) -> NumberTable.interval(row, 0, row.length, x[0]))
          .readsRow()),
  /** {@code element(row, k)}: number k of a {@link NumberRow}, counted from 0. */
  ELEMENT(
      inner("NumberTable", "element", 1, (row, x) -> NumberTable.element(row, 0, row.length, x[0]))
          .readsRow()),
  /**
   * {@code closest(row, x, z)}: abscissa of the point closest to (x, z) of the curve that a {@link
   * NumberRow} holds; found by a search, so without derivatives.
   */
  CLOSEST(
      inner(
              "CubicCurve",
              "closest",
              2,
              (row, x) -> CubicCurve.closest(row, 0, row.length, x[0], x[1]))
          .readsRow()),
  /**
   * {@code touch(l₁, l₂, ψ, radius, tolerance)}: where a string through a ring touches it, an angle
   * between 0 and ψ; found by a search, so without derivatives.
   */
  TOUCH(
      inner(
              "TouchingPoint",
              "angle",
              5,
              (row, x) -> TouchingPoint.angle(x[0], x[1], x[2], x[3], x[4]))
          .bound((out, aLow, aHigh, bLow, bHigh) -> out.set(0, Math.PI))
          .even(
              (aLow, aHigh, bLow, bHigh, highest) ->
                  Enclosure.changesLittle(aLow, aHigh) && Enclosure.changesLittle(bLow, bHigh))),
  /** The number of the polynomial of a {@link GivenFunction} at its arguments. */
  PLACE(two("", (a, b) -> Double.NaN)),
  /**
   * A {@link GivenFunction} of its arguments and their {@link #PLACE}, which tells value and
   * slopes; both only in programs that are evaluated and not printed.
   */
  GIVEN(
      inner("", "", 3, (row, x) -> Double.NaN).slope((f, i) -> f.expressions().slopeOfGiven(f, i)));

  private static final double[] NO_ROW = {};

  @SuppressWarnings("ImmutableEnumChecker") // not changed after its row is written
  private final FunctionTraits traits;

  MathFunction(FunctionTraits traits) {
    this.traits = traits;
  }

  /** Returns the functions that formulas of models can call. */
  public static List<MathFunction> inFormulas() {
    return Arrays.stream(values()).filter(function -> !function.symbol().isEmpty()).toList();
  }

  /** Returns the function of a name in formulas, which has no prefix {@code Math.}. */
  public static Optional<MathFunction> named(String symbol) {
    return inFormulas().stream().filter(function -> function.symbol().equals(symbol)).findFirst();
  }

  /** Returns the names in formulas. */
  public static List<String> symbols() {
    return inFormulas().stream().map(MathFunction::symbol).toList();
  }

  /** Returns the name in formulas; empty if they cannot call it. */
  public String symbol() {
    return traits.symbol;
  }

  /** Returns how many numbers it takes, without those of a row. */
  public int arity() {
    return traits.arity;
  }

  /** Returns what its unit has to do with those of its arguments. */
  public UnitRule units() {
    return traits.units;
  }

  /** Returns the internal name of the class whose method generated Java calls. */
  public String owner() {
    return traits.owner;
  }

  /** Returns the name of its static method. */
  public String method() {
    return traits.method;
  }

  /** Returns the name of the function that generated C calls, without prefix. */
  public String cName() {
    return traits.cName.orElseGet(() -> name().toLowerCase(Locale.ROOT));
  }

  /**
   * Returns whether it reads a row of numbers that is fixed when code is generated. Its method
   * takes the array that holds the row, the place and the number of its elements, and then the
   * argument.
   */
  public boolean readsRow() {
    return traits.readsRow;
  }

  /** Returns whether the value of one or two arguments is computed without an array. */
  boolean isDirect() {
    return traits.direct;
  }

  /** Returns its value if it reads a row; {@code x} holds the other arguments. */
  double value(double[] row, double[] x) {
    return traits.value.of(row, x);
  }

  /**
   * Returns its value; NaN or infinite where it is not defined.
   *
   * @param x arguments, as many as the arity; more may follow; not modified
   */
  public double value(double[] x) {
    return traits.value.of(NO_ROW, x);
  }

  /** Returns the value of a function of one or two arguments; of one it ignores the second. */
  public double value(double a, double b) {
    return traits.arity == 1 ? traits.single.applyAsDouble(a) : traits.pair.applyAsDouble(a, b);
  }

  /**
   * Returns a call of it in a formula of a model: marked as steep where it is.
   *
   * @param arguments as many as the arity
   */
  public Scalar call(List<Scalar> arguments) {
    Scalar call = Simplification.function(this, arguments);
    return traits.steep ? call.markedSteep() : call;
  }

  /** Returns the formula that a call of it is, if it is no node of its own. */
  Optional<Scalar> formula(List<Scalar> arguments) {
    return traits.formula.map(formula -> formula.apply(arguments));
  }

  /** Returns whether all there is to know of it follows from the formula that it is. */
  public boolean isComposed() {
    return traits.composed;
  }

  /** Returns the slope of a call of it by one of its arguments; that of a steep one is steep. */
  Scalar slope(Scalar call, int argument) {
    Scalar slope = traits.slope.of(call, argument);
    return traits.steep && call.isSteep() ? slope.markedSteep() : slope;
  }

  /** Returns whether it is one of its arguments. */
  public boolean isChoice() {
    return traits.choice.isPresent();
  }

  /**
   * Returns four numbers of arguments: where the first is not above the second it is the third,
   * else the fourth.
   *
   * @throws java.util.NoSuchElementException if it is no choice
   */
  public List<Integer> choice() {
    return traits.choice.orElseThrow();
  }

  @Override
  public void bound(double aLow, double aHigh, double bLow, double bHigh, Enclosure out) {
    traits.bound.of(out, aLow, aHigh, bLow, bHigh);
    out.settle(traits.exact ? 0 : Enclosure.ROUNDING);
  }

  /** Returns where it is made of pieces. */
  public Corners corners() {
    return traits.corners;
  }

  @Override
  public boolean hasPieces() {
    return traits.corners != Corners.NONE;
  }

  @Override
  public double piece(double a, double b) {
    return traits.corners.piece(a, b);
  }

  @Override
  public double distance(double a, double b) {
    return traits.corners.distance(a, b);
  }

  /** Returns whether it is 0 to one side of 0 of its first argument, else the second. */
  public boolean isPart() {
    return traits.part;
  }

  /** Returns whether it jumps between its pieces, which are constant unless it is a part. */
  public boolean jumps() {
    return traits.jumps;
  }

  /** Returns whether it has a value and a continuous slope everywhere. */
  public boolean isSmooth() {
    return traits.smooth;
  }

  /** Returns whether it repeats itself along its argument. */
  public boolean repeats() {
    return traits.repeats;
  }

  @Override
  public boolean isNarrow() {
    return traits.narrow;
  }

  /** Returns whether {@link #isEven} reads the highest value. */
  public boolean isEvenByValue() {
    return traits.evenByValue;
  }

  @Override
  public boolean isEven(double aLow, double aHigh, double bLow, double bHigh, double highest) {
    return traits.even.holds(aLow, aHigh, bLow, bHigh, highest);
  }

  /** Returns whether it is 0 where its first argument is, whatever the second is. */
  public boolean zeroStaysZero() {
    return traits.zeroStaysZero;
  }
}
