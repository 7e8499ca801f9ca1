package org.mechservice.solver.expression;

import java.util.List;

/**
 * Expressions compiled to a list of operations on numbered slots, equal subexpressions only once
 * and constant ones done in advance. Immutable; {@link TapePieces} runs it.
 *
 * <p>The leaves that are not constants ({@link #leaves()}) are inputs, which the caller sets from a
 * mechanism's motion.
 */
public final class Tape {
  /** Kinds of steps: the four that most steps are, and all others. */
  static final byte SUM = 0;

  static final byte PRODUCT = 1;
  static final byte NEGATION = 2;
  static final byte SQUARE = 3;
  static final byte OTHER = 4;

  private final List<Expression> leaves;

  /** Slot of each leaf. */
  final int[] leafSlot;

  /** Slot of each result. */
  final int[] result;

  /** The steps in order: operation, slot written, slots read. */
  final TapeStep[] operation;

  /** The same as numbers, for the operations that most steps are. */
  final byte[] kind;

  final int[] target;
  final int[] first;
  final int[] second;

  /** Initial contents of all slots: the constants, zero elsewhere. */
  final double[] initial;

  /**
   * Compiles expressions.
   *
   * @param results the expressions, in the order of the results
   */
  public Tape(List<Expression> results) {
    TapeCompiler compiler = new TapeCompiler();
    result = results.stream().mapToInt(compiler::compile).toArray();
    leaves = List.copyOf(compiler.leaves);
    leafSlot = compiler.leafSlots();
    operation = compiler.steps.stream().map(TapeCompiler.Step::operation).toArray(TapeStep[]::new);
    target = compiler.targets.stream().mapToInt(Integer::intValue).toArray();
    first = compiler.steps.stream().mapToInt(TapeCompiler.Step::first).toArray();
    second = compiler.steps.stream().mapToInt(TapeCompiler.Step::second).toArray();
    kind = new byte[operation.length];
    for (int i = 0; i < kind.length; i++) {
      kind[i] = kind(operation[i]);
    }
    initial = compiler.constants.stream().mapToDouble(Double::doubleValue).toArray();
  }

  private static byte kind(TapeStep step) {
    if (step instanceof Operation operation) {
      return switch (operation) {
        case ADD -> SUM;
        case MULTIPLY -> PRODUCT;
        case NEGATE -> NEGATION;
        case SQUARE -> SQUARE;
        default -> OTHER;
      };
    }
    return OTHER;
  }

  /**
   * Evaluates all steps.
   *
   * @param value of each slot: leaves and constants given, the others overwritten
   */
  void evaluate(double[] value) {
    for (int i = 0; i < kind.length; i++) {
      double a = value[first[i]];
      double b = value[second[i]];
      value[target[i]] =
          switch (kind[i]) {
            case SUM -> a + b;
            case PRODUCT -> a * b;
            case NEGATION -> -a;
            case SQUARE -> a * a;
            default -> operation[i].value(a, b);
          };
    }
  }

  /** Returns the inputs of an evaluation: all leaves except constants, each once. */
  public List<Expression> leaves() {
    return leaves;
  }

  /** Returns the number of results. */
  public int resultCount() {
    return result.length;
  }
}
