package org.mechservice.sim.gradient;

import java.util.HashSet;
import java.util.LinkedHashSet;
import java.util.Set;
import org.mechservice.sim.symbolic.MathFunction;
import org.mechservice.sim.symbolic.Program;
import org.mechservice.sim.symbolic.Scalar;
import org.mechservice.sim.symbolic.ScalarOperation;

/**
 * The places at which the equations choose between two forms by the state or by a parameter, and so
 * may jump: sign, step, contacts. Corners of abs, min, max and the knots of tables are none: values
 * are continuous there.
 */
final class Switches {
  private Switches() {}

  /**
   * Returns a program of the numbers that change their sign at the switches of programs.
   *
   * @throws IllegalArgumentException if a value is rounded down by the state or by a chosen
   *     parameter
   */
  static Program of(Iterable<Program> programs, int[] chosen) {
    Program margins = new Program();
    margins.section("Switches.", "switches");
    int count = 0;
    for (Program program : programs) {
      GraphCopy copy = new GraphCopy(margins.expressions());
      for (Scalar margin : found(program, chosen)) {
        margins.output(count++, copy.of(margin));
      }
    }
    return margins;
  }

  private static Set<Scalar> found(Program program, int[] chosen) {
    int[] uses = program.uses();
    boolean[] varies = varying(program, uses.length, chosen);
    Set<Scalar> margins = new LinkedHashSet<>();
    for (int id = 0; id < uses.length; id++) {
      Scalar node = program.expressions().node(id);
      if (uses[id] == 0 || node.operation() != ScalarOperation.FUNCTION || !varies[id]) {
        continue;
      }
      if (node.function() == MathFunction.FLOOR && varies[node.first().id()]) {
        throw new IllegalArgumentException(
            "floor() of the state or of a parameter jumps at every whole number, and has no"
                + " derivative there; write what it stands for by step() or sign()");
      } else if (node.function() == MathFunction.SIGNUM && varies[node.first().id()]) {
        add(margins, node.first());
      } else if (node.function() == MathFunction.CHOOSE
          && (varies[node.first().id()] || varies[node.second().id()])) {
        add(margins, node.first().minus(node.second()));
      }
    }
    return margins;
  }

  /** Adds a margin; the same one with the other sign is no further place. */
  private static void add(Set<Scalar> margins, Scalar margin) {
    if (!margins.contains(margin.negated())) {
      margins.add(margin);
    }
  }

  /** Returns which nodes depend on the state or on a chosen parameter. */
  private static boolean[] varying(Program program, int size, int[] chosen) {
    Set<Integer> parameters = new HashSet<>();
    for (int parameter : chosen) {
      parameters.add(Program.PARAMETER + parameter);
    }
    boolean[] varies = new boolean[size];
    for (int id = 0; id < size; id++) {
      Scalar node = program.expressions().node(id);
      if (node.operation() == ScalarOperation.INPUT) {
        varies[id] = node.index() < Program.PARAMETER || parameters.contains(node.index());
      }
      for (Scalar operand : node.operands()) {
        varies[id] |= varies[operand.id()];
      }
    }
    return varies;
  }
}
