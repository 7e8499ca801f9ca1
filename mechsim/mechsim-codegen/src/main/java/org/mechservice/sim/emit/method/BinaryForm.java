package org.mechservice.sim.emit.method;

import java.util.Map;
import java.util.OptionalDouble;
import org.mechservice.solver.symbol.Scalar;
import org.mechservice.solver.symbol.ScalarOperation;

/**
 * The written form of an operation on two values. Signs of operands are absorbed if this adds no
 * operation: a + (−3 b) as a − 3 b, −(−3 b) as 3 b, −(a − b) as b − a. Rounding does not depend on
 * signs, so the bits are the same but for the sign of a zero difference.
 *
 * @param operation addition, subtraction, multiplication or division
 * @param first first written operand
 * @param second second written operand
 */
public record BinaryForm(ScalarOperation operation, Term first, Term second) {
  /**
   * An operand.
   *
   * @param value the operand, or its opposite
   * @param opposite whether it is the opposite: a sign that {@link #absorbsSign} is dropped
   */
  public record Term(Scalar value, boolean opposite) {}

  /**
   * Returns the written form of an operation on two values.
   *
   * @param places locations of values that are not written out
   */
  public static BinaryForm of(Scalar node, Map<Scalar, ValueLocation> places) {
    Scalar a = node.first();
    Scalar b = node.second();
    return switch (node.operation()) {
      case ADD ->
          isNegative(a, places) && !isNegative(b, places)
              ? new BinaryForm(ScalarOperation.SUBTRACT, new Term(b, false), new Term(a, true))
              : plus(a, b, places);
      case SUBTRACT -> minus(new Term(a, false), b, places);
      default -> {
        boolean both = isNegative(a, places) && isNegative(b, places);
        yield new BinaryForm(node.operation(), new Term(a, both), new Term(b, both));
      }
    };
  }

  /** Returns the written form of the opposite of an operation that {@link #absorbsSign}. */
  public static BinaryForm ofOpposite(Scalar node, Map<Scalar, ValueLocation> places) {
    Scalar a = node.first();
    Scalar b = node.second();
    return switch (node.operation()) {
      case ADD ->
          absorbsSign(a, places)
              ? minus(new Term(a, true), b, places)
              : minus(new Term(b, true), a, places);
      case SUBTRACT -> minus(new Term(b, false), a, places);
      default -> {
        boolean first = isNegative(a, places);
        yield new BinaryForm(node.operation(), new Term(a, first), new Term(b, !first));
      }
    };
  }

  private static BinaryForm plus(Scalar a, Scalar b, Map<Scalar, ValueLocation> places) {
    boolean negative = isNegative(b, places);
    ScalarOperation operation = negative ? ScalarOperation.SUBTRACT : ScalarOperation.ADD;
    return new BinaryForm(operation, new Term(a, false), new Term(b, negative));
  }

  private static BinaryForm minus(Term a, Scalar b, Map<Scalar, ValueLocation> places) {
    boolean negative = isNegative(b, places);
    ScalarOperation operation = negative ? ScalarOperation.ADD : ScalarOperation.SUBTRACT;
    return new BinaryForm(operation, a, new Term(b, negative));
  }

  /** Returns whether the opposite of a value takes no more operations than the value. */
  public static boolean absorbsSign(Scalar node, Map<Scalar, ValueLocation> places) {
    if (isNegative(node, places)) {
      return true;
    }
    if (places.containsKey(node)) {
      return false;
    }
    return switch (node.operation()) {
      case SUBTRACT -> true;
      case ADD -> absorbsSign(node.first(), places) || absorbsSign(node.second(), places);
      default -> false;
    };
  }

  /** Returns whether a value is written out and has an odd number of negative constant factors. */
  private static boolean isNegative(Scalar node, Map<Scalar, ValueLocation> places) {
    OptionalDouble constant = constant(node, places);
    if (constant.isPresent()) {
      return constant.getAsDouble() < 0;
    }
    if (places.containsKey(node)) {
      return false;
    }
    return switch (node.operation()) {
      case MULTIPLY, DIVIDE ->
          isNegative(node.first(), places) != isNegative(node.second(), places);
      default -> false;
    };
  }

  /** Returns the number that a value is, if it is one that is written out. */
  public static OptionalDouble constant(Scalar node, Map<Scalar, ValueLocation> places) {
    ValueLocation place = places.get(node);
    if (place instanceof ValueLocation.Constant number) {
      return OptionalDouble.of(number.value());
    }
    return place == null && node.isNumber()
        ? OptionalDouble.of(node.value())
        : OptionalDouble.empty();
  }
}
