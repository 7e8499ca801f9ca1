package org.mechservice.sim.build.emit;

import java.util.ArrayList;
import java.util.List;
import org.mechservice.sim.symbolic.Operation;
import org.mechservice.sim.symbolic.Program;
import org.mechservice.sim.symbolic.Scalar;

/**
 * How a program becomes code.
 *
 * @param program the program
 * @param usage which of its values have a place
 * @param methods what follows the sines and cosines, in order
 * @param slots length of workspace it needs
 */
record ProgramPlan(Program program, Usage usage, List<MethodPlan> methods, int slots) {

  /**
   * Returns the angles whose sines and cosines the program needs, computed first: sine of angle i
   * in slot 2 i of the workspace, cosine in slot 2 i + 1.
   */
  List<Scalar> angles() {
    return usage.angles();
  }

  /** Returns how many angles from {@code start} on are consecutive inputs; 0: it is none. */
  int runOfInputs(int start) {
    int run = 0;
    for (int i = start; i < angles().size(); i++) {
      Scalar angle = angles().get(i);
      if (angle.operation() != Operation.INPUT
          || angle.index() != angles().get(start).index() + run) {
        return run;
      }
      run++;
    }
    return run;
  }

  /** Returns whether parameters of the model are read. */
  boolean readsModelParameters() {
    for (Scalar node : usage.given()) {
      if (node.operation() == Operation.INPUT && Head.isModelParameter(node.index())) {
        return true;
      }
    }
    return false;
  }

  /** Returns the fields that every method of the program is given: workspace and parameters. */
  List<String> fields() {
    List<String> fields = new ArrayList<>();
    if (slots > 0) {
      fields.add(Parameters.WORKSPACE);
    }
    if (readsModelParameters()) {
      fields.add(Head.MODEL_PARAMETERS.name());
    }
    return fields;
  }

  /** Returns the parameters of a method that the program reads: all arrays, and numbers it uses. */
  List<Head.Argument> arguments(Head head) {
    List<Head.Argument> read = new ArrayList<>();
    for (Head.Argument argument : head.arguments()) {
      boolean used = argument.isArray();
      for (Scalar node : usage.given()) {
        used |= node.operation() == Operation.INPUT && node.index() == argument.first();
      }
      if (used) {
        read.add(argument);
      }
    }
    return read;
  }
}
