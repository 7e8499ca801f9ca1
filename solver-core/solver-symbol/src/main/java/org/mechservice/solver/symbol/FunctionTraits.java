package org.mechservice.solver.symbol;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.DoubleBinaryOperator;
import java.util.function.DoubleUnaryOperator;
import java.util.function.Function;
import java.util.stream.IntStream;
import org.mechservice.solver.spatial.Powers;

/**
 * What a row of the catalogue {@link MathFunction} says. The methods that return this change it,
 * and are called while the row is written only.
 */
final class FunctionTraits {
  /** The slope of a call by one of its arguments, which counts from 0. */
  interface Slope {
    Scalar of(Scalar call, int argument);
  }

  /** Finds the bounds of the values for a and b in two intervals, without rounding. */
  interface Bound {
    void of(Enclosure out, double aLow, double aHigh, double bLow, double bHigh);
  }

  /** A value of a row of numbers, which few functions read, and of arguments. */
  interface Value {
    double of(double[] row, double[] x);
  }

  /** Whether values stay near a parabola through three of them, for a and b in two intervals. */
  interface Evenness {
    boolean holds(double aLow, double aHigh, double bLow, double bHigh, double highest);
  }

  static final String STRICT_MATH = "java/lang/StrictMath";
  static final String MATH = "java/lang/Math";
  static final String SPATIAL = "org/mechservice/solver/spatial/";

  /** Change of an argument within which sines, exponential and hyperbolic functions are even. */
  private static final double EVEN = 0.5;

  /** Exponent below which an exponential is nothing; twice the argument beyond which tanh is 1. */
  private static final double NOTHING = -40;

  final String symbol;
  final int arity;
  final Value value;

  /** The same of one argument, if it has one, and of one or two. */
  final DoubleUnaryOperator single;

  final DoubleBinaryOperator pair;

  String owner = STRICT_MATH;
  String method;
  Optional<String> cName = Optional.empty();
  Optional<Function<List<Scalar>, Scalar>> formula = Optional.empty();
  boolean composed;

  /** Whether {@link #pair} computes its value without an array. */
  boolean direct;

  UnitRule units = UnitRule.NUMBER;
  Slope slope = (call, argument) -> call.expressions().zero();
  Optional<List<Integer>> choice = Optional.empty();
  Bound bound;
  Evenness even = (aLow, aHigh, bLow, bHigh, highest) -> aHigh - aLow <= EVEN;
  boolean evenByValue;
  Corners corners = Corners.NONE;
  boolean jumps;
  boolean part;
  boolean steep;
  boolean narrow;
  boolean exact;
  boolean smooth;
  boolean repeats;
  boolean zeroStaysZero;
  boolean readsRow;

  private FunctionTraits(String symbol, int arity, Value value, DoubleBinaryOperator pair) {
    this(symbol, arity, value, a -> pair.applyAsDouble(a, a), pair);
  }

  private FunctionTraits(
      String symbol,
      int arity,
      Value value,
      DoubleUnaryOperator single,
      DoubleBinaryOperator pair) {
    this.symbol = symbol;
    this.arity = arity;
    this.value = value;
    this.single = single;
    this.pair = pair;
    this.method = symbol;
    this.bound = (out, aLow, aHigh, bLow, bHigh) -> out.rising(this::value, aLow, aHigh);
  }

  /**
   * A function of one argument that does not fall, of numbers, whose slope is 0; its method is that
   * of StrictMath.
   */
  static FunctionTraits one(String symbol, DoubleUnaryOperator value) {
    return new FunctionTraits(
            symbol,
            1,
            (row, x) -> value.applyAsDouble(x[0]),
            value,
            (a, b) -> value.applyAsDouble(a))
        .direct();
  }

  /** A function of two arguments; its method is that of StrictMath. */
  static FunctionTraits two(String symbol, DoubleBinaryOperator value) {
    return new FunctionTraits(symbol, 2, (row, x) -> value.applyAsDouble(x[0], x[1]), value)
        .direct();
  }

  private FunctionTraits direct() {
    direct = true;
    return this;
  }

  /** A function that formulas cannot call, with its method; its slopes are 0. */
  static FunctionTraits inner(String type, String method, int arity, Value value) {
    double[] none = {};
    return new FunctionTraits("", arity, value, (a, b) -> value.of(none, new double[] {a, b}))
        .by(SPATIAL + type, method);
  }

  /**
   * A function that is a formula of others: whatever else there is to know of it follows from the
   * formula, but for its unit.
   */
  static FunctionTraits composed(String symbol, int arity, Function<List<Scalar>, Scalar> formula) {
    Value value = (row, x) -> valueOf(formula, Arrays.copyOf(x, arity));
    double[] none = {};
    FunctionTraits traits =
        new FunctionTraits(symbol, arity, value, (a, b) -> value.of(none, new double[] {a, b}));
    traits.composed = true;
    return traits.formula(formula);
  }

  private static double valueOf(Function<List<Scalar>, Scalar> formula, double[] x) {
    Program program = new Program();
    program.section("value", "f");
    program.output(
        0,
        formula.apply(
            IntStream.range(0, x.length).mapToObj(program.expressions()::input).toList()));
    double[] value = new double[1];
    program.evaluate(x, value);
    return value[0];
  }

  private double value(double a) {
    return single.applyAsDouble(a);
  }

  /** Generated code calls another method than that of StrictMath. */
  FunctionTraits by(String otherOwner, String otherMethod) {
    owner = otherOwner;
    method = otherMethod;
    return this;
  }

  /** Generated C calls a function of another name than that of the row. */
  FunctionTraits inC(String name) {
    cName = Optional.of(name);
    return this;
  }

  /** It is no node of its own in a graph, but a formula of others. */
  FunctionTraits formula(Function<List<Scalar>, Scalar> ofArguments) {
    formula = Optional.of(ofArguments);
    return this;
  }

  FunctionTraits units(UnitRule rule) {
    units = rule;
    return this;
  }

  FunctionTraits slope(Slope byArgument) {
    slope = byArgument;
    return this;
  }

  /**
   * It is one of its arguments: x[p] ≤ x[q] takes x[r], else x[s]. Its derivative is that of the
   * one taken.
   */
  FunctionTraits choice(int p, int q, int r, int s) {
    choice = Optional.of(List.of(p, q, r, s));
    return this;
  }

  FunctionTraits bound(Bound ofIntervals) {
    bound = ofIntervals;
    return this;
  }

  /** It rises on a part of the line, beyond which it is not defined. */
  FunctionTraits risingFrom(double from, double to) {
    return bound(
        (out, aLow, aHigh, bLow, bHigh) ->
            out.set(value(within(aLow, from, to)), value(within(aHigh, from, to))));
  }

  /** It falls on a part of the line, beyond which it is not defined. */
  FunctionTraits fallingFrom(double from, double to) {
    return bound(
        (out, aLow, aHigh, bLow, bHigh) ->
            out.set(value(within(aHigh, from, to)), value(within(aLow, from, to))));
  }

  private static double within(double a, double from, double to) {
    return Math.max(from, Math.min(to, a));
  }

  /** It is a wave of period 2 π between −1 and 1 with a crest at an angle, rad. */
  FunctionTraits wave(double crest) {
    repeats = true;
    return bound((out, aLow, aHigh, bLow, bHigh) -> out.wave(this::value, aLow, aHigh, crest));
  }

  FunctionTraits even(Evenness rule) {
    even = rule;
    return this;
  }

  /** It is even where its first argument keeps its sign and changes little. */
  FunctionTraits evenOffZero() {
    return even((aLow, aHigh, bLow, bHigh, highest) -> Enclosure.changesLittle(aLow, aHigh));
  }

  /** It is even near 0, where |a| is below a half. */
  FunctionTraits evenNearZero() {
    return even((aLow, aHigh, bLow, bHigh, highest) -> aHigh < EVEN && aLow > -EVEN);
  }

  /** It is even as others are, and beyond arguments where it is constant but for rounding. */
  FunctionTraits levelBeyond(double below, double above) {
    return even(
        (aLow, aHigh, bLow, bHigh, highest) ->
            aHigh - aLow <= EVEN || aHigh < below * -NOTHING || aLow > above * -NOTHING);
  }

  /** It is even as others are, and where its argument keeps its sign and changes little. */
  FunctionTraits evenAlsoOffZero() {
    return even(
        (aLow, aHigh, bLow, bHigh, highest) ->
            aHigh - aLow <= EVEN || Enclosure.changesLittle(aLow, aHigh));
  }

  /** It is even as a power is: where it is nothing, and where its base changes little. */
  FunctionTraits evenAsPower() {
    evenByValue = true;
    return even(
        (aLow, aHigh, bLow, bHigh, highest) ->
            highest < StrictMath.exp(NOTHING)
                || Enclosure.changesLittle(
                    aLow, aHigh, Powers.power(Enclosure.RATIO, 1 / Math.max(1, bHigh))));
  }

  /** It is made of pieces that meet in corners; the slope of one of them is taken there. */
  FunctionTraits corners(Corners where) {
    corners = where;
    return this;
  }

  /** It is made of constant pieces and jumps between them. */
  FunctionTraits jumps(Corners where) {
    jumps = true;
    exact = true;
    return corners(where);
  }

  /** It is 0 to one side of 0 of its first argument, else the second. */
  FunctionTraits part() {
    part = true;
    return jumps(Corners.SIDES);
  }

  /** It may be infinite, or have no value or an unbounded slope, for finite arguments. */
  FunctionTraits steep() {
    steep = true;
    return this;
  }

  /** It can change much while its arguments hardly do, without a corner. */
  FunctionTraits narrow() {
    narrow = true;
    return this;
  }

  /** It does not round. */
  FunctionTraits exact() {
    exact = true;
    return this;
  }

  /** It has a value and a continuous slope everywhere. */
  FunctionTraits smooth() {
    smooth = true;
    return this;
  }

  /** It repeats itself along its argument. */
  FunctionTraits repeats() {
    repeats = true;
    return this;
  }

  /** It is 0 where its first argument is, whatever the second is. */
  FunctionTraits zeroStaysZero() {
    zeroStaysZero = true;
    return this;
  }

  /** It reads a row of numbers that is fixed when code is generated. */
  FunctionTraits readsRow() {
    readsRow = true;
    return this;
  }
}
