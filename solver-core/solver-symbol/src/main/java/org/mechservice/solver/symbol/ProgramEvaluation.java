package org.mechservice.solver.symbol;

import java.util.ArrayList;
import java.util.List;

/**
 * Runs a program in doubles, step by step. Workspace of one thread that keeps nothing of the graph.
 */
public final class ProgramEvaluation {
  /** Outputs up to the next guards, and those guards: indices and slots. */
  private static final class Part {
    private final int[] index;
    private final int[] output;
    private final int[] pivot;
    private final int[] bound;
    private final int[] result;

    Part(List<Program.Output> outputs, List<Program.Guard> guards, ProgramSlots slots) {
      index = outputs.stream().mapToInt(Program.Output::index).toArray();
      output = slots.slots(outputs.stream().map(Program.Output::value).toList());
      pivot = slots.slots(guards.stream().map(Program.Guard::pivot).toList());
      bound = slots.slots(guards.stream().map(Program.Guard::bound).toList());
      result = guards.stream().mapToInt(Program.Guard::result).toArray();
    }

    /** Returns the parts of a program: sections without guards go on into the next. */
    static Part[] of(Program program, ProgramSlots slots) {
      List<Part> parts = new ArrayList<>();
      List<Program.Output> outputs = new ArrayList<>();
      for (Program.Section section : program.sections()) {
        outputs.addAll(section.outputs());
        if (!section.guards().isEmpty()) {
          parts.add(new Part(outputs, section.guards(), slots));
          outputs.clear();
        }
      }
      if (!outputs.isEmpty()) {
        parts.add(new Part(outputs, List.of(), slots));
      }
      return parts.toArray(Part[]::new);
    }
  }

  private final Part[] parts;
  private final ProgramSteps steps;

  /** Inputs that the program reads, and the slots that they go to. */
  private final int[] input;

  private final int[] inputSlot;

  /** Value of each slot; those of constants stay. */
  private final double[] values;

  private final double[] room = new double[ProgramSteps.ARGUMENTS];

  /** Makes a workspace for a program as it is now. */
  public ProgramEvaluation(Program program) {
    ProgramSlots slots = new ProgramSlots(program);
    values = slots.initial();
    List<Scalar> inputs = slots.inputs();
    input = inputs.stream().mapToInt(Scalar::index).toArray();
    inputSlot = slots.slots(inputs);
    steps = new ProgramSteps(slots);
    parts = Part.of(program, slots);
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
    steps.evaluate(values, room);
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
}
