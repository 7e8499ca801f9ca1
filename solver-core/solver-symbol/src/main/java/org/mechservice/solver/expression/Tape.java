package org.mechservice.solver.expression;

import java.util.List;
import org.mechservice.solver.symbol.MathFunction;
import org.mechservice.solver.symbol.ProgramSlots;
import org.mechservice.solver.symbol.ProgramSteps;
import org.mechservice.solver.symbol.Scalar;
import org.mechservice.solver.symbol.WatchedStep;

/**
 * Expressions as the steps of a program, in which calls are whole, with what the search of steps
 * must know of each. Immutable; {@link TapePieces} runs it.
 *
 * <p>The leaves that are not constants ({@link #leaves()}) are inputs, which the caller sets from a
 * mechanism's motion.
 */
public final class Tape {
  /** Kinds of steps: the five that most steps are, and all others. */
  static final byte SUM = 0;

  static final byte PRODUCT = 1;
  static final byte NEGATION = 2;
  static final byte SQUARE = 3;
  static final byte DIFFERENCE = 4;
  static final byte OTHER = 5;

  private final List<Expression> leaves;

  /** Slot of each leaf. */
  final int[] leafSlot;

  /** Slot of each result. */
  final int[] result;

  /** The steps in order: operation, slot written, slots read. */
  final WatchedStep[] operation;

  /** The same as numbers, for the operations that most steps are. */
  final byte[] kind;

  final int[] target;
  final int[] first;
  final int[] second;

  /** Initial contents of all slots: the constants, zero elsewhere. */
  final double[] initial;

  /** The same steps, to be run. */
  private final ProgramSteps steps;

  /**
   * Compiles expressions.
   *
   * @param results the expressions, in the order of the results
   */
  public Tape(List<Expression> results) {
    FormulaPrograms programs = new FormulaPrograms(results, true);
    ProgramSlots slots = new ProgramSlots(programs.values());
    leaves =
        programs.leaves().stream().filter(leaf -> slots.slot(programs.leaf(leaf)) >= 0).toList();
    leafSlot = leaves.stream().mapToInt(leaf -> slots.slot(programs.leaf(leaf))).toArray();
    result = slots.slots(programs.results());
    steps = new ProgramSteps(slots);
    List<Scalar> nodes = slots.steps();
    operation = nodes.stream().map(Tape::operation).toArray(WatchedStep[]::new);
    target = slots.slots(nodes);
    first = slots.slots(nodes.stream().map(Scalar::first).toList());
    second = slots.slots(nodes.stream().map(ProgramSteps::secondOf).toList());
    kind = new byte[operation.length];
    for (int i = 0; i < kind.length; i++) {
      kind[i] = kind(operation[i]);
    }
    initial = slots.initial();
  }

  private static WatchedStep operation(Scalar node) {
    return switch (node.operation()) {
      case SQUARE_ROOT -> MathFunction.SQRT;
      case SINE -> MathFunction.SIN;
      case COSINE -> MathFunction.COS;
      case FUNCTION ->
          node.function() == MathFunction.GIVEN ? (WatchedStep) node.given() : node.function();
      default -> Operation.of(node);
    };
  }

  private static byte kind(WatchedStep step) {
    if (step instanceof Operation operation) {
      return switch (operation) {
        case ADD -> SUM;
        case SUBTRACT -> DIFFERENCE;
        case MULTIPLY -> PRODUCT;
        case NEGATE -> NEGATION;
        case SQUARE -> SQUARE;
        case DIVIDE -> OTHER;
      };
    }
    return OTHER;
  }

  /**
   * Evaluates all steps.
   *
   * @param value of each slot: leaves and constants given, the others overwritten
   * @param room as {@link ProgramSteps#evaluate} needs it
   */
  void evaluate(double[] value, double[] room) {
    steps.evaluate(value, room);
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
