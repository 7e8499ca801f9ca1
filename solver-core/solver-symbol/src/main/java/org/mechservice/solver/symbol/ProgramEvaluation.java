package org.mechservice.solver.symbol;

import java.util.List;
import java.util.stream.IntStream;
import org.mechservice.solver.spatial.SinCos;

/**
 * Runs a program in doubles, node by node. Generated code must reproduce these results bit for bit.
 * Workspace of one thread; nothing allocates after construction.
 */
final class ProgramEvaluation {
  private final Program program;

  /** The nodes that are computed, with the numbers of their first and last operand. */
  private final Scalar[] nodes;

  private final ScalarOperation[] operations;
  private final int[] target;
  private final int[] first;
  private final int[] last;

  /** Value of each node, by number; those of constants stay. */
  private final double[] values;

  private final double[] arguments = new double[4];

  /** Makes a workspace for a program, which must not be changed any more. */
  ProgramEvaluation(Program program) {
    this.program = program;
    int[] uses = program.uses();
    List<Scalar> used =
        IntStream.range(0, uses.length)
            .filter(id -> uses[id] > 0)
            .mapToObj(program.expressions()::node)
            .toList();
    values = new double[uses.length];
    used.stream().filter(Scalar::isConstant).forEach(node -> values[node.id()] = node.value());
    nodes = used.stream().filter(node -> !node.isConstant()).toArray(Scalar[]::new);
    operations = new ScalarOperation[nodes.length];
    target = new int[nodes.length];
    first = new int[nodes.length];
    last = new int[nodes.length];
    for (int i = 0; i < nodes.length; i++) {
      List<Scalar> operands = nodes[i].operands();
      operations[i] = nodes[i].operation();
      target[i] = nodes[i].id();
      first[i] = operands.isEmpty() ? nodes[i].index() : operands.get(0).id();
      last[i] = operands.isEmpty() ? 0 : operands.get(operands.size() - 1).id();
    }
  }

  /** Runs the program, as {@link Program#evaluate(double, double[], double[])} does. */
  int run(double time, double[] inputs, double[] outputs) {
    evaluate(time, inputs);
    for (Program.Section section : program.sections()) {
      for (Program.Output output : section.outputs()) {
        outputs[output.index()] = valueOf(output.value());
      }
      for (Program.Guard guard : section.guards()) {
        if (valueOf(guard.pivot()) <= valueOf(guard.bound())) {
          return guard.result();
        }
      }
    }
    return -1;
  }

  /** Evaluates all nodes of the program. */
  void evaluate(double time, double[] inputs) {
    for (int i = 0; i < nodes.length; i++) {
      int a = first[i];
      int b = last[i];
      values[target[i]] =
          switch (operations[i]) {
            case ADD -> values[a] + values[b];
            case SUBTRACT -> values[a] - values[b];
            case MULTIPLY -> values[a] * values[b];
            case DIVIDE -> values[a] / values[b];
            case NEGATE -> -values[a];
            case SQUARE_ROOT -> Math.sqrt(values[a]);
            case SINE -> SinCos.sine(values[a]);
            case COSINE -> SinCos.cosine(values[a]);
            case INPUT -> a == Program.TIME ? time : inputs[a];
            case CONSTANT -> values[target[i]];
            case FUNCTION -> function(nodes[i], a, b);
          };
    }
  }

  /** Returns the value of a node of the program after {@link #evaluate}. */
  double valueOf(Scalar node) {
    return values[node.id()];
  }

  private double function(Scalar node, int a, int b) {
    if (!node.function().symbol().isEmpty()) {
      return node.function().value(values[a], values[b]);
    }
    for (int i = 0; i < node.operands().size(); i++) {
      arguments[i] = valueOf(node.operands().get(i));
    }
    return node.function().readsRow()
        ? node.row().value(node.function(), arguments)
        : node.function().value(arguments);
  }
}
