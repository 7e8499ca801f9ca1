package org.mechservice.sim.emit.source;

import java.util.Map;
import java.util.OptionalDouble;
import org.mechservice.sim.emit.method.BinaryForm;
import org.mechservice.sim.emit.method.ConstantTable;
import org.mechservice.sim.emit.method.MethodPlan;
import org.mechservice.sim.emit.method.MethodSignature;
import org.mechservice.sim.emit.method.NumberText;
import org.mechservice.sim.emit.method.ValueLocation;
import org.mechservice.solver.symbol.Scalar;
import org.mechservice.solver.symbol.ScalarOperation;

/** Writes values as expressions, with as few parentheses as the order of operations permits. */
final class ExpressionPrinter {
  private static final int SUM = 1;
  private static final int PRODUCT = 2;
  private static final int SIGN = 3;
  private static final int ATOM = 4;

  private final Map<Scalar, ValueLocation> places;
  private final Map<Scalar, Scalar> originals;
  private final MethodSignature head;
  private final LocalNames names;
  private final NumberText numbers;
  private final ConstantTable constants;
  private final Syntax syntax;

  /**
   * @param method locations of values; values without a location are written out
   * @param head the method that has the inputs as parameters
   * @param names names of local variables
   * @param numbers writes constants
   * @param constants holds the rows that functions read
   */
  ExpressionPrinter(
      MethodPlan method,
      MethodSignature head,
      LocalNames names,
      NumberText numbers,
      ConstantTable constants,
      Syntax syntax) {
    this.constants = constants;
    this.syntax = syntax;
    this.places = method.places();
    this.originals = method.originals();
    this.head = head;
    this.names = names;
    this.numbers = numbers;
  }

  /** Returns the name of a local variable. */
  String name(Scalar value) {
    return names.of(originals.getOrDefault(value, value));
  }

  /** Returns the location of a value, or its operation if it has none. */
  String value(Scalar node) {
    ValueLocation place = places.get(node);
    return place == null ? operation(node) : place(place);
  }

  /** Returns a location as an expression. */
  String place(ValueLocation place) {
    if (place instanceof ValueLocation.Local local) {
      return name(local.value());
    } else if (place instanceof ValueLocation.Slot slot) {
      return "w[" + slot.index() + "]";
    } else if (place instanceof ValueLocation.Element element) {
      return element.array() + "[" + element.index().text() + "]";
    } else if (place instanceof ValueLocation.Constant constant) {
      return numbers.of(constant.value());
    }
    return input(((ValueLocation.Input) place).index());
  }

  private String input(int index) {
    MethodSignature.Argument argument = head.argumentOf(index);
    return argument.isArray()
        ? argument.name() + "[" + (index - argument.first()) + "]"
        : argument.name();
  }

  /** Returns the operation of a value, even if it has a location. */
  String operation(Scalar node) {
    return switch (node.operation()) {
      case CONSTANT -> numbers.of(node.value());
      case INPUT -> input(node.index());
      case NEGATE -> opposite(node.first());
      case SQUARE_ROOT -> syntax.squareRoot(value(node.first()));
      case FUNCTION -> call(node);
      case SINE, COSINE -> throw new IllegalStateException("an angle function has a place");
      default -> binary(BinaryForm.of(node, places));
    };
  }

  private String opposite(Scalar node) {
    if (!BinaryForm.absorbsSign(node, places)) {
      return "-" + atLeast(node, SIGN);
    }
    OptionalDouble constant = BinaryForm.constant(node, places);
    return constant.isPresent()
        ? numbers.of(-constant.getAsDouble())
        : binary(BinaryForm.ofOpposite(node, places));
  }

  private String call(Scalar node) {
    StringBuilder text = new StringBuilder(syntax.function(node.function())).append('(');
    if (node.function().readsRow()) {
      text.append(syntax.row(constants.placeOf(node.row()), node.row().size())).append(", ");
    }
    for (int i = 0; i < node.operands().size(); i++) {
      text.append(i == 0 ? "" : ", ").append(value(node.operands().get(i)));
    }
    return text.append(')').toString();
  }

  /**
   * Returns an operation with two operands. If only the second operand of a sum or product is
   * itself one, the operands are exchanged, with the same bits.
   */
  private String binary(BinaryForm form) {
    int level = level(form.operation());
    boolean commutes =
        form.operation() == ScalarOperation.ADD || form.operation() == ScalarOperation.MULTIPLY;
    boolean swap = commutes && levelOf(form.second()) == level && levelOf(form.first()) > level;
    BinaryForm.Term first = swap ? form.second() : form.first();
    BinaryForm.Term second = swap ? form.first() : form.second();
    return atLeast(first, level) + symbol(form.operation()) + atLeast(second, level + 1);
  }

  private String atLeast(BinaryForm.Term term, int level) {
    String text = term.opposite() ? opposite(term.value()) : value(term.value());
    return levelOf(term) < level ? "(" + text + ")" : text;
  }

  private String atLeast(Scalar node, int level) {
    return levelOf(node) < level ? "(" + value(node) + ")" : value(node);
  }

  private int levelOf(BinaryForm.Term term) {
    return term.opposite() ? level(term.value().operation()) : levelOf(term.value());
  }

  private int levelOf(Scalar node) {
    if (places.containsKey(node)) {
      return ATOM;
    }
    boolean absorbed =
        node.operation() == ScalarOperation.NEGATE && BinaryForm.absorbsSign(node.first(), places);
    return level(absorbed ? node.first().operation() : node.operation());
  }

  private static int level(ScalarOperation operation) {
    return switch (operation) {
      case ADD, SUBTRACT -> SUM;
      case MULTIPLY, DIVIDE -> PRODUCT;
      case NEGATE -> SIGN;
      default -> ATOM;
    };
  }

  private static String symbol(ScalarOperation operation) {
    return switch (operation) {
      case ADD -> " + ";
      case SUBTRACT -> " - ";
      case MULTIPLY -> " * ";
      default -> " / ";
    };
  }
}
