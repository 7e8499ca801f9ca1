package org.mechservice.solver.expression;

import java.util.List;

/**
 * Expressions compiled to a list of operations on numbered slots, equal subexpressions only once
 * and constant ones done in advance. Immutable; {@link TapeEvaluation} runs it.
 *
 * <p>The leaves that are not constants ({@link #leaves()}) are inputs, which the caller sets from a
 * mechanism's motion.
 */
public final class Tape {
  private final List<Expression> leaves;
  private final boolean[] constantResult;

  /** Slot of each leaf. */
  final int[] leafSlot;

  /** Slot of each result. */
  final int[] result;

  /** The steps in order: operation, slot written, slots read. */
  final TapeStep[] operation;

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
    constantResult = new boolean[result.length];
    for (int i = 0; i < result.length; i++) {
      constantResult[i] = compiler.isConstant(result[i]);
    }
    leaves = List.copyOf(compiler.leaves);
    leafSlot = compiler.leafSlots();
    operation = compiler.steps.stream().map(TapeCompiler.Step::operation).toArray(TapeStep[]::new);
    target = compiler.targets.stream().mapToInt(Integer::intValue).toArray();
    first = compiler.steps.stream().mapToInt(TapeCompiler.Step::first).toArray();
    second = compiler.steps.stream().mapToInt(TapeCompiler.Step::second).toArray();
    initial = compiler.constants.stream().mapToDouble(Double::doubleValue).toArray();
  }

  /** Returns the inputs of an evaluation: all leaves except constants, each once. */
  public List<Expression> leaves() {
    return leaves;
  }

  /** Returns the number of results. */
  public int resultCount() {
    return result.length;
  }

  /** Returns whether a result does not depend on the leaves. */
  public boolean isConstantResult(int index) {
    return constantResult[index];
  }
}
