package org.mechservice.sim.build.emit;

import java.util.Map;
import org.mechservice.sim.symbolic.Operation;
import org.mechservice.sim.symbolic.Scalar;

/**
 * Writes values as Java expressions, with no more parentheses than the order of operations needs.
 */
final class ExpressionPrinter {
  private static final int SUM = 1;
  private static final int PRODUCT = 2;
  private static final int SIGN = 3;
  private static final int ATOM = 4;

  private final Map<Scalar, Place> places;
  private final Head head;
  private final LocalNames names;
  private final NumberText numbers;

  /**
   * @param places where values are found; the others are written out
   * @param head the method that has the inputs as parameters
   * @param names names of local variables
   * @param numbers writes constants
   */
  ExpressionPrinter(Map<Scalar, Place> places, Head head, LocalNames names, NumberText numbers) {
    this.places = places;
    this.head = head;
    this.names = names;
    this.numbers = numbers;
  }

  /** Returns a value: its place, or else the operation that gives it. */
  String value(Scalar node) {
    Place place = places.get(node);
    return place == null ? operation(node) : place(place);
  }

  /** Returns a place as an expression. */
  String place(Place place) {
    if (place instanceof Place.Local local) {
      return names.of(local.value());
    } else if (place instanceof Place.Slot slot) {
      return "w[" + slot.index() + "]";
    }
    return input(((Place.Input) place).index());
  }

  private String input(int index) {
    Head.Argument argument = head.argumentOf(index);
    return argument.isArray()
        ? argument.name() + "[" + (index - argument.first()) + "]"
        : argument.name();
  }

  /** Returns the operation that gives a value, even if it has a place. */
  String operation(Scalar node) {
    return switch (node.operation()) {
      case CONSTANT -> numbers.of(node.value());
      case INPUT -> input(node.index());
      case NEGATE -> "-" + atLeast(node.first(), SIGN);
      case SQUARE_ROOT -> "Math.sqrt(" + value(node.first()) + ")";
      case SINE, COSINE -> throw new IllegalStateException("an angle function has a place");
      default -> binary(node);
    };
  }

  /**
   * A sum or product whose second operand only is one is written the other way round: same bits.
   */
  private String binary(Scalar node) {
    int level = level(node.operation());
    boolean commutes = node.operation() == Operation.ADD || node.operation() == Operation.MULTIPLY;
    boolean swap = commutes && levelOf(node.second()) == level && levelOf(node.first()) > level;
    Scalar first = swap ? node.second() : node.first();
    Scalar second = swap ? node.first() : node.second();
    return atLeast(first, level) + symbol(node.operation()) + atLeast(second, level + 1);
  }

  private String atLeast(Scalar node, int level) {
    return levelOf(node) < level ? "(" + value(node) + ")" : value(node);
  }

  private int levelOf(Scalar node) {
    return places.containsKey(node) ? ATOM : level(node.operation());
  }

  private static int level(Operation operation) {
    return switch (operation) {
      case ADD, SUBTRACT -> SUM;
      case MULTIPLY, DIVIDE -> PRODUCT;
      case NEGATE -> SIGN;
      default -> ATOM;
    };
  }

  private static String symbol(Operation operation) {
    return switch (operation) {
      case ADD -> " + ";
      case SUBTRACT -> " - ";
      case MULTIPLY -> " * ";
      default -> " / ";
    };
  }
}
