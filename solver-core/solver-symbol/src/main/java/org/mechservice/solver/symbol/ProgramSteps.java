package org.mechservice.solver.symbol;

import java.util.ArrayList;
import java.util.List;
import org.mechservice.solver.spatial.Piecewise;
import org.mechservice.solver.spatial.SinCos;

/**
 * The steps of a program, which read and write numbered slots: the one way in which formulas are
 * evaluated without code. Generated code must reproduce these results bit for bit. Immutable; keeps
 * nothing of the graph.
 */
public final class ProgramSteps {
  /** Most arguments that a function has. */
  public static final int ARGUMENTS = 5;

  private static final double[] NO_ROW = {};

  private static final byte ADD = 0;
  private static final byte SUBTRACT = 1;
  private static final byte MULTIPLY = 2;
  private static final byte DIVIDE = 3;
  private static final byte NEGATE = 4;
  private static final byte SQUARE_ROOT = 5;
  private static final byte SINE = 6;
  private static final byte COSINE = 7;
  private static final byte PRODUCT = 8;

  /** A function of one or two arguments, and one of a row or of more. */
  private static final byte DIRECT = 9;

  private static final byte OTHER = 10;

  /** A function given by points: its value, its place, and its value at a place. */
  private static final byte OF_POINTS = 11;

  private static final byte PLACE = 12;
  private static final byte AT_PLACE = 13;

  /** The steps in order, with the slots that they write and read. */
  private final byte[] kind;

  private final int[] target;
  private final int[] first;
  private final int[] second;

  /** Of a function its number among those of its kind. */
  private final int[] call;

  private final MathFunction[] functions;
  private final Call[] calls;
  private final GivenFunction[] given;

  /** Slot of the place of each function given by points. */
  private final int[] placeSlot;

  /** A function of a row or of more than two arguments. */
  private static final class Call {
    private final MathFunction function;
    private final double[] row;
    private final int[] arguments;

    Call(Scalar node, ProgramSlots slots) {
      function = node.function();
      row = function.readsRow() ? node.row().numbers() : NO_ROW;
      arguments = slots.slots(node.operands());
    }

    double value(double[] values, double[] room) {
      for (int i = 0; i < arguments.length; i++) {
        room[i] = values[arguments[i]];
      }
      return function.value(row, room);
    }
  }

  /** Takes the steps of a program whose nodes are numbered. */
  public ProgramSteps(ProgramSlots slots) {
    List<Scalar> steps = slots.steps();
    int count = steps.size();
    kind = new byte[count];
    target = slots.slots(steps);
    first = new int[count];
    second = new int[count];
    call = new int[count];
    List<MathFunction> ofTwo = new ArrayList<>();
    List<Call> ofMore = new ArrayList<>();
    List<GivenFunction> ofPoints = new ArrayList<>();
    placeSlot = new int[count];
    for (int i = 0; i < count; i++) {
      Scalar node = steps.get(i);
      kind[i] = kind(node, slots);
      first[i] = slots.slot(node.first());
      second[i] = slots.slot(secondOf(node));
      if (kind[i] >= OF_POINTS) {
        placeSlot[ofPoints.size()] = slots.slot(last(node));
        call[i] = added(ofPoints, node.given());
      } else if (kind[i] == OTHER) {
        call[i] = added(ofMore, new Call(node, slots));
      } else if (kind[i] == DIRECT) {
        call[i] = added(ofTwo, node.function());
      }
    }
    functions = ofTwo.toArray(MathFunction[]::new);
    calls = ofMore.toArray(Call[]::new);
    given = ofPoints.toArray(GivenFunction[]::new);
  }

  private static <T> int added(List<T> list, T one) {
    list.add(one);
    return list.size() - 1;
  }

  private static Scalar last(Scalar node) {
    return node.operands().get(node.operands().size() - 1);
  }

  /**
   * Returns the last argument of an operation or function, the first if there is one alone; a place
   * is none.
   */
  public static Scalar secondOf(Scalar node) {
    boolean given = node.is(ScalarOperation.FUNCTION) && node.function() == MathFunction.GIVEN;
    return node.operands().get(node.operands().size() - (given ? 2 : 1));
  }

  private static byte kind(Scalar node, ProgramSlots slots) {
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
      case FUNCTION ->
          switch (node.function()) {
            case PRODUCT -> PRODUCT;
            case PLACE -> PLACE;
            case GIVEN -> slots.slot(last(node)) < 0 ? OF_POINTS : AT_PLACE;
            default -> node.function().isDirect() ? DIRECT : OTHER;
          };
    };
  }

  /**
   * Runs the steps.
   *
   * @param values of each slot: inputs and constants given, the others overwritten
   * @param room for {@value #ARGUMENTS} arguments of a function; overwritten
   */
  public void evaluate(double[] values, double[] room) {
    for (int i = 0; i < kind.length; i++) {
      double a = values[first[i]];
      double b = values[second[i]];
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
            case DIRECT -> functions[call[i]].value(a, b);
            case OF_POINTS -> given[call[i]].at(a, b);
            case PLACE -> given[call[i]].place(a, b);
            case AT_PLACE -> given[call[i]].value(a, b, values[placeSlot[call[i]]]);
            default -> calls[call[i]].value(values, room);
          };
    }
  }
}
