package org.mechservice.solver.symbol;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.mechservice.solver.spatial.Piecewise;
import org.mechservice.solver.spatial.SinCos;

/**
 * Runs a program in doubles, node by node. Generated code must reproduce these results bit for bit.
 * Workspace of one thread that keeps nothing of the graph; nothing allocates after construction.
 */
public final class ProgramEvaluation {
  private static final double[] NO_ROW = {};

  /** Kinds of steps; from {@link #OF_POINTS} on they are calls. */
  private static final byte ADD = 0;

  private static final byte SUBTRACT = 1;
  private static final byte MULTIPLY = 2;
  private static final byte DIVIDE = 3;
  private static final byte NEGATE = 4;
  private static final byte SQUARE_ROOT = 5;
  private static final byte SINE = 6;
  private static final byte COSINE = 7;
  private static final byte PRODUCT = 8;
  private static final byte OF_POINTS = 9;

  /** A function of one or two arguments, and one of a row or of more. */
  private static final byte DIRECT = 10;

  private static final byte OTHER = 11;

  /** Outputs and guards of a section: indices and slots. */
  private static final class Part {
    private final int[] index;
    private final int[] output;
    private final int[] pivot;
    private final int[] bound;
    private final int[] result;

    Part(Program.Section section, int[] slot) {
      List<Program.Output> outputs = section.outputs();
      List<Program.Guard> guards = section.guards();
      index = outputs.stream().mapToInt(Program.Output::index).toArray();
      output = slots(outputs.stream().map(Program.Output::value).toList(), slot);
      pivot = slots(guards.stream().map(Program.Guard::pivot).toList(), slot);
      bound = slots(guards.stream().map(Program.Guard::bound).toList(), slot);
      result = guards.stream().mapToInt(Program.Guard::result).toArray();
    }
  }

  /** A function with what it reads and the slots of its arguments. */
  private static final class Call {
    private final MathFunction function;
    private final double[] row;
    private final Optional<GivenFunction> given;
    private final int[] arguments;

    Call(Scalar node, int[] slot) {
      function = node.function();
      row = function.readsRow() ? node.row().numbers() : NO_ROW;
      given = isOfPoints(function) ? Optional.of(node.given()) : Optional.empty();
      arguments = slots(node.operands(), slot);
    }
  }

  private final Part[] parts;

  /** Inputs that the program reads, and the slots that they go to. */
  private final int[] input;

  private final int[] inputSlot;

  /** The steps in order, with the slots that they write and read. */
  private final byte[] kind;

  private final int[] target;
  private final int[] first;
  private final int[] last;

  /** The functions among them, and for each step how many are before it. */
  private final Call[] calls;

  private final int[] call;

  /** Value of each slot; those of constants stay. */
  private final double[] values;

  private final double[] arguments = new double[4];

  /** Makes a workspace for a program as it is now. */
  public ProgramEvaluation(Program program) {
    int[] uses = program.uses();
    int[] slot = new int[uses.length];
    List<Scalar> used = new ArrayList<>();
    for (int id = 0; id < uses.length; id++) {
      if (uses[id] > 0) {
        slot[id] = used.size();
        used.add(program.expressions().node(id));
      }
    }
    values = used.stream().mapToDouble(node -> node.isConstant() ? node.value() : 0).toArray();
    List<Scalar> inputs = used.stream().filter(node -> node.is(ScalarOperation.INPUT)).toList();
    input = inputs.stream().mapToInt(Scalar::index).toArray();
    inputSlot = slots(inputs, slot);
    List<Scalar> steps = used.stream().filter(node -> !node.operands().isEmpty()).toList();
    kind = new byte[steps.size()];
    for (int i = 0; i < kind.length; i++) {
      kind[i] = kind(steps.get(i));
    }
    target = slots(steps, slot);
    first = slots(steps.stream().map(Scalar::first).toList(), slot);
    last = slots(steps.stream().map(ProgramEvaluation::lastOperand).toList(), slot);
    List<Call> functions = new ArrayList<>();
    call = new int[kind.length];
    for (int i = 0; i < kind.length; i++) {
      call[i] = functions.size();
      if (kind[i] >= OF_POINTS) {
        functions.add(new Call(steps.get(i), slot));
      }
    }
    calls = functions.toArray(Call[]::new);
    parts =
        program.sections().stream().map(section -> new Part(section, slot)).toArray(Part[]::new);
  }

  private static Scalar lastOperand(Scalar node) {
    return node.operands().get(node.operands().size() - 1);
  }

  private static int[] slots(List<Scalar> nodes, int[] slot) {
    return nodes.stream().mapToInt(node -> slot[node.id()]).toArray();
  }

  private static byte kind(Scalar node) {
    return switch (node.operation()) {
      case ADD -> ADD;
      case SUBTRACT -> SUBTRACT;
      case MULTIPLY -> MULTIPLY;
      case DIVIDE -> DIVIDE;
      case NEGATE -> NEGATE;
      case SQUARE_ROOT -> SQUARE_ROOT;
      case SINE -> SINE;
      case COSINE -> COSINE;
      case CONSTANT, INPUT -> throw new IllegalArgumentException(node + " is no step");
      case FUNCTION -> {
        MathFunction function = node.function();
        boolean direct = function.isDirect();
        yield function == MathFunction.PRODUCT
            ? PRODUCT
            : isOfPoints(function) ? OF_POINTS : direct ? DIRECT : OTHER;
      }
    };
  }

  private static boolean isOfPoints(MathFunction function) {
    return function == MathFunction.GIVEN || function == MathFunction.PLACE;
  }

  /**
   * Runs the program.
   *
   * @param time s
   * @param inputs the others, by index; not modified
   * @param outputs by index; overwritten where the program puts something out
   * @return the result of the first guard that fails; −1 if none does
   */
  public int run(double time, double[] inputs, double[] outputs) {
    for (int i = 0; i < input.length; i++) {
      values[inputSlot[i]] = input[i] == Program.TIME ? time : inputs[input[i]];
    }
    evaluate();
    for (Part part : parts) {
      for (int i = 0; i < part.index.length; i++) {
        outputs[part.index[i]] = values[part.output[i]];
      }
      for (int i = 0; i < part.result.length; i++) {
        if (values[part.pivot[i]] <= values[part.bound[i]]) {
          return part.result[i];
        }
      }
    }
    return -1;
  }

  private void evaluate() {
    for (int i = 0; i < kind.length; i++) {
      double a = values[first[i]];
      double b = values[last[i]];
      values[target[i]] =
          switch (kind[i]) {
            case ADD -> a + b;
            case SUBTRACT -> a - b;
            case MULTIPLY -> a * b;
            case DIVIDE -> a / b;
            case NEGATE -> -a;
            case SQUARE_ROOT -> Math.sqrt(a);
            case SINE -> SinCos.sine(a);
            case COSINE -> SinCos.cosine(a);
            case PRODUCT -> Piecewise.product(a, b);
            case OF_POINTS -> ofPoints(calls[call[i]], a, b);
            case DIRECT -> calls[call[i]].function.value(a, b);
            default -> call(calls[call[i]]);
          };
    }
  }

  private double ofPoints(Call call, double a, double b) {
    GivenFunction given = call.given.orElseThrow();
    int[] slots = call.arguments;
    return call.function == MathFunction.PLACE
        ? given.place(a, b)
        : given.value(a, values[slots[slots.length - 2]], b);
  }

  private double call(Call call) {
    int[] slots = call.arguments;
    for (int i = 0; i < slots.length; i++) {
      arguments[i] = values[slots[i]];
    }
    return call.function.value(call.row, arguments);
  }
}
