package org.mechservice.solver.symbol;

import org.mechservice.solver.spatial.SinCos;

/**
 * Evaluates programs in doubles, node by node. Generated code must reproduce these results bit for
 * bit.
 */
final class ProgramEvaluation {
  private final double time;
  private final double[] inputs;
  private final double[] pair = new double[2];

  /** Creates an evaluation at a time, s, for inputs by index; not modified. */
  ProgramEvaluation(double time, double[] inputs) {
    this.time = time;
    this.inputs = inputs;
  }

  /** Returns the value of every node the program contains, by node number. */
  double[] valuesOf(Program program) {
    int[] uses = program.uses();
    double[] values = new double[uses.length];
    for (int id = 0; id < uses.length; id++) {
      if (uses[id] > 0) {
        values[id] = valueOf(program.expressions().node(id), values);
      }
    }
    return values;
  }

  private double valueOf(Scalar node, double[] values) {
    return switch (node.operation()) {
      case CONSTANT -> node.value();
      case INPUT -> node.index() == Program.TIME ? time : inputs[node.index()];
      case FUNCTION -> function(node, values);
      case NEGATE, SQUARE_ROOT, SINE, COSINE -> unary(node, values[node.first().id()]);
      default -> binary(node, values[node.first().id()], values[node.second().id()]);
    };
  }

  private static double function(Scalar node, double[] values) {
    double[] arguments =
        node.operands().stream().mapToDouble(operand -> values[operand.id()]).toArray();
    return node.function().readsRow()
        ? node.row().value(node.function(), arguments)
        : node.function().value(arguments);
  }

  private double unary(Scalar node, double operand) {
    return switch (node.operation()) {
      case NEGATE -> -operand;
      case SQUARE_ROOT -> Math.sqrt(operand);
      default -> {
        SinCos.sinCos(operand, pair, 0);
        yield pair[node.operation() == ScalarOperation.SINE ? 0 : 1];
      }
    };
  }

  private static double binary(Scalar node, double first, double second) {
    return switch (node.operation()) {
      case ADD -> first + second;
      case SUBTRACT -> first - second;
      case MULTIPLY -> first * second;
      case DIVIDE -> first / second;
      default -> throw new AssertionError(node.operation());
    };
  }
}
