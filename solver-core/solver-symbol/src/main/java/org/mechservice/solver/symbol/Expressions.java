package org.mechservice.solver.symbol;

import java.util.ArrayList;
import java.util.Collections;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * A graph of expressions in which equal expressions are one node.
 *
 * <p>Nodes are numbered in the order in which they are made. The table of known nodes is only
 * looked up, never iterated, so its hash order has no effect.
 */
public final class Expressions {
  private static final int FIRST_CAPACITY = 256;

  private final List<Scalar> nodes = new ArrayList<>();

  /**
   * Hash table with open addressing. Key: operation and operands of a node, or the bits of a
   * constant. Never full.
   */
  private Scalar[] known = new Scalar[FIRST_CAPACITY];

  private final List<Double> numbers = new ArrayList<>();

  /** Nodes of functions by their arguments and the function. */
  private final Map<List<Object>, Scalar> calls = new HashMap<>();

  private final Scalar zero = constant(0);
  private final Scalar one = constant(1);

  /** Returns the number 0. */
  public Scalar zero() {
    return zero;
  }

  /** Returns the number 1. */
  public Scalar one() {
    return one;
  }

  /**
   * Returns a number; −0 becomes 0.
   *
   * @throws ArithmeticException if it is not finite
   */
  public Scalar constant(double value) {
    if (!Double.isFinite(value)) {
      throw new ArithmeticException("constant " + value + " is not finite");
    }
    double number = value == 0 ? 0 : value;
    return leaf(ScalarOperation.CONSTANT, Double.doubleToRawLongBits(number), number, 0);
  }

  /**
   * Returns a number that no simplification looks at: a node of its own, kept as an operand also
   * where it is 0 or 1. Equations of many things alike have the same form with such numbers,
   * whatever these are, and values with the same bits as with constants.
   *
   * @throws ArithmeticException if it is not finite
   */
  public Scalar number(double value) {
    if (!Double.isFinite(value)) {
      throw new ArithmeticException("number " + value + " is not finite");
    }
    return number(value == 0 ? 0 : value, numbers.size());
  }

  private Scalar number(double value, int index) {
    long bits = Double.doubleToRawLongBits(value);
    int place = place(ScalarOperation.CONSTANT, bits, index);
    Scalar node = known[place];
    if (node == null) {
      while (numbers.size() <= index) {
        numbers.add(0.0);
      }
      numbers.set(index, value);
      node = add(place, ScalarOperation.CONSTANT, List.of(), bits, index, value, index);
    }
    return node;
  }

  /** Returns the values of its {@linkplain #number numbers} by their index, a view. */
  public List<Double> numbers() {
    return Collections.unmodifiableList(numbers);
  }

  /** Returns the number given as input {@code index}. */
  public Scalar input(int index) {
    return leaf(ScalarOperation.INPUT, index, 0, index);
  }

  /** Returns the sine of an angle. */
  public Scalar sine(Scalar angle) {
    return Simplification.sine(angle);
  }

  /** Returns the cosine of an angle. */
  public Scalar cosine(Scalar angle) {
    return Simplification.cosine(angle);
  }

  /** Returns a call of a function; a constant if all arguments are constants. */
  public Scalar function(MathFunction function, Scalar... arguments) {
    return Simplification.function(function, List.of(arguments));
  }

  /**
   * Returns a call of a function as a node of its own, also where it is a formula of others; a
   * constant if all arguments are constants and its value is finite.
   */
  public Scalar whole(MathFunction function, List<Scalar> arguments) {
    boolean known = arguments.stream().allMatch(Scalar::isConstant);
    double value =
        known
            ? function.value(arguments.stream().mapToDouble(Scalar::value).toArray())
            : Double.NaN;
    return Double.isFinite(value) ? constant(value) : call(function, arguments);
  }

  /**
   * Returns how many numbers of a row are not above x; a constant if x is one.
   *
   * @param ascending the row, ascending
   */
  public Scalar interval(NumberRow ascending, Scalar x) {
    return read(MathFunction.INTERVAL, ascending, List.of(x));
  }

  /** Returns number {@code index} of a row, counted from 0; a constant if the index is one. */
  public Scalar element(NumberRow row, Scalar index) {
    return row.isConstant() ? constant(row.at(0)) : read(MathFunction.ELEMENT, row, List.of(index));
  }

  /**
   * Returns the abscissa of the point of a curve that is closest to (x, z).
   *
   * @param curve a row of {@link org.mechservice.solver.spatial.CubicCurve}
   */
  public Scalar closest(NumberRow curve, Scalar x, Scalar z) {
    return read(MathFunction.CLOSEST, curve, List.of(x, z));
  }

  /**
   * Returns the value of a function that is given by points; a constant if all arguments are.
   *
   * @param x its arguments
   */
  public Scalar given(GivenFunction function, List<Scalar> x) {
    if (x.stream().allMatch(Scalar::isConstant)) {
      double a = x.get(0).value();
      double b = x.get(x.size() - 1).value();
      double value = function.value(a, b, function.place(a, b));
      if (Double.isFinite(value)) {
        return constant(value);
      }
    }
    Scalar place = call(MathFunction.PLACE, Optional.of(function.origin()), x);
    List<Scalar> arguments = new ArrayList<>(x);
    arguments.add(place);
    return call(MathFunction.GIVEN, Optional.of(function), arguments);
  }

  /** Returns the slope of such a value by one of its arguments; the place has none. */
  Scalar slopeOfGiven(Scalar value, int argument) {
    return argument == value.operands().size() - 1
        ? zero
        : call(MathFunction.GIVEN, Optional.of(value.given().slope(argument)), value.operands());
  }

  private Scalar read(MathFunction function, NumberRow row, List<Scalar> x) {
    return x.stream().allMatch(Scalar::isConstant)
        ? constant(row.value(function, x.stream().mapToDouble(Scalar::value).toArray()))
        : call(function, Optional.of(row), x);
  }

  /** Returns the call of a node of this or another graph with other arguments. */
  Scalar function(Scalar node, List<Scalar> arguments) {
    if (node.function() == MathFunction.GIVEN || node.function() == MathFunction.PLACE) {
      return call(node.function(), node.fixed(), arguments);
    }
    return node.function().readsRow()
        ? read(node.function(), node.row(), arguments)
        : Simplification.function(node.function(), arguments);
  }

  /**
   * Returns a node with the operation of a node of this or another graph and other operands. The
   * node is not simplified, so its value has the same bits.
   */
  public Scalar alike(Scalar node, List<Scalar> operands) {
    Scalar same = sameOf(node, operands);
    return node.isSteep() ? same.markedSteep() : same;
  }

  private Scalar sameOf(Scalar node, List<Scalar> operands) {
    return switch (node.operation()) {
      case CONSTANT ->
          node.isConstant() ? constant(node.value()) : number(node.value(), node.index());
      case INPUT -> input(node.index());
      case FUNCTION -> call(node.function(), node.fixed(), operands);
      case NEGATE, SQUARE_ROOT, SINE, COSINE -> unary(node.operation(), operands.get(0));
      default -> binary(node.operation(), operands.get(0), operands.get(1));
    };
  }

  /** Returns the number of nodes so far. */
  public int size() {
    return nodes.size();
  }

  /** Returns node {@code id}. */
  public Scalar node(int id) {
    return nodes.get(id);
  }

  /** Returns the node of an operation that needs no simplification. */
  Scalar unary(ScalarOperation operation, Scalar operand) {
    int place = place(operation, operand.id(), -1);
    Scalar node = known[place];
    return node != null ? node : add(place, operation, List.of(operand), operand.id(), -1, 0, 0);
  }

  /** Returns the node of an operation that needs no simplification, operands in this order. */
  Scalar binary(ScalarOperation operation, Scalar first, Scalar second) {
    int place = place(operation, first.id(), second.id());
    Scalar node = known[place];
    return node != null
        ? node
        : add(place, operation, List.of(first, second), first.id(), second.id(), 0, 0);
  }

  /** Returns the node of a function that needs no simplification. */
  Scalar call(MathFunction function, List<Scalar> arguments) {
    return call(function, Optional.empty(), arguments);
  }

  private Scalar call(MathFunction function, Optional<FixedPart> fixed, List<Scalar> arguments) {
    List<Object> key = new ArrayList<>(arguments);
    key.add(function);
    fixed.ifPresent(key::add);
    Scalar node = calls.get(key);
    if (node == null) {
      node = new Scalar(this, nodes.size(), function, fixed, arguments);
      nodes.add(node);
      calls.put(key, node);
    }
    return node;
  }

  private Scalar leaf(ScalarOperation operation, long identity, double value, int index) {
    int place = place(operation, identity, -1);
    Scalar node = known[place];
    return node != null ? node : add(place, operation, List.of(), identity, -1, value, index);
  }

  /** Returns whether an expression exists already. */
  boolean contains(ScalarOperation operation, Scalar first, Scalar second) {
    return known[place(operation, first.id(), second.id())] != null;
  }

  /** Returns the index of a node in the table, or the free index for it. */
  private int place(ScalarOperation operation, long first, long second) {
    int mask = known.length - 1;
    int place = hash(operation, first, second) & mask;
    for (Scalar node = known[place]; node != null; node = known[place]) {
      if (node.identity == first
          && node.secondIdentity == second
          && node.operation() == operation) {
        return place;
      }
      place = (place + 1) & mask;
    }
    return place;
  }

  private static int hash(ScalarOperation operation, long first, long second) {
    long mixed = (first * 0xC2B2AE3D27D4EB4FL + second) * 0x9E3779B97F4A7C15L;
    mixed = (mixed ^ mixed >>> 29) * 0x9E3779B97F4A7C15L;
    return (int) (mixed >>> 32) + operation.hash();
  }

  private Scalar add(
      int place,
      ScalarOperation operation,
      List<Scalar> operands,
      long identity,
      long secondIdentity,
      double value,
      int index) {
    Scalar node =
        new Scalar(this, nodes.size(), operation, operands, identity, secondIdentity, value, index);
    nodes.add(node);
    known[place] = node;
    if (2 * nodes.size() > known.length) {
      grow();
    }
    return node;
  }

  private void grow() {
    known = new Scalar[2 * known.length];
    for (Scalar node : nodes) {
      if (node.operation() == ScalarOperation.FUNCTION) {
        continue;
      }
      known[place(node.operation(), node.identity, node.secondIdentity)] = node;
    }
  }
}
