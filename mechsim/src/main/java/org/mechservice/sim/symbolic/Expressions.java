package org.mechservice.sim.symbolic;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/**
 * A graph of expressions in which equal expressions are one node.
 *
 * <p>Nodes are numbered as they arise; the table of known nodes is looked into, never walked
 * through.
 */
public final class Expressions {
  /**
   * Identity of a node: what it does, to which nodes; a constant by its bits, an input by index.
   */
  private record Key(Operation operation, long first, long second) {}

  private final List<Scalar> nodes = new ArrayList<>();
  private final Map<Key, Scalar> known = new HashMap<>();
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
    Key key = new Key(Operation.CONSTANT, Double.doubleToRawLongBits(number), 0);
    Scalar node = known.get(key);
    return node != null ? node : add(key, List.of(), number, 0);
  }

  /** Returns the number given as input {@code index}. */
  public Scalar input(int index) {
    Key key = new Key(Operation.INPUT, index, 0);
    Scalar node = known.get(key);
    return node != null ? node : add(key, List.of(), 0, index);
  }

  /** Returns the sine of an angle. */
  public Scalar sine(Scalar angle) {
    return Simplification.sine(angle);
  }

  /** Returns the cosine of an angle. */
  public Scalar cosine(Scalar angle) {
    return Simplification.cosine(angle);
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
  Scalar unary(Operation operation, Scalar operand) {
    Key key = new Key(operation, operand.id(), -1);
    Scalar node = known.get(key);
    return node != null ? node : add(key, List.of(operand), 0, 0);
  }

  /** Returns the node of an operation that needs no simplification, operands in this order. */
  Scalar binary(Operation operation, Scalar first, Scalar second) {
    Key key = new Key(operation, first.id(), second.id());
    Scalar node = known.get(key);
    return node != null ? node : add(key, List.of(first, second), 0, 0);
  }

  /** Returns whether an expression has arisen already. */
  boolean knows(Operation operation, Scalar first, Scalar second) {
    return known.containsKey(new Key(operation, first.id(), second.id()));
  }

  private Scalar add(Key key, List<Scalar> operands, double value, int index) {
    Scalar node = new Scalar(this, nodes.size(), key.operation(), operands, value, index);
    nodes.add(node);
    known.put(key, node);
    return node;
  }
}
