package org.mechservice.sim.gradient;

import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.mechservice.solver.symbol.Expressions;
import org.mechservice.solver.symbol.MathFunction;
import org.mechservice.solver.symbol.NumberRow;
import org.mechservice.solver.symbol.Program;
import org.mechservice.solver.symbol.Scalar;
import org.mechservice.solver.symbol.ScalarOperation;

/**
 * The places at which the equations take another form by the state or by a parameter. At a sign, a
 * step or a contact they may jump. At a corner (abs, min, max, a point of a table where its slope
 * jumps) they are continuous, but their derivatives are not. Joints of curves whose slopes are
 * continuous are no places.
 */
final class Switches {
  private final Program margins = new Program();
  private final int jumps;
  private final int count;

  /**
   * Finds the places of programs, in what they put out.
   *
   * @throws IllegalArgumentException if a value is rounded down by the state or by a chosen
   *     parameter
   */
  Switches(Iterable<Program> programs, int[] chosen) {
    margins.section("Switches.", "switches");
    Map<Scalar, Boolean> found = new LinkedHashMap<>();
    for (Program program : programs) {
      find(program, chosen, new GraphCopy(margins.expressions()), found);
    }
    int next = 0;
    for (boolean corner : List.of(false, true)) {
      for (Map.Entry<Scalar, Boolean> place : found.entrySet()) {
        if (place.getValue() == corner) {
          margins.output(next++, place.getKey());
        }
      }
    }
    jumps = (int) found.values().stream().filter(corner -> !corner).count();
    count = next;
  }

  /** Returns a program of the numbers that change their sign at the places, jumps first. */
  Program margins() {
    return margins;
  }

  /** Returns the number of places. */
  int count() {
    return count;
  }

  /** Returns the number of those at which values may jump. */
  int jumps() {
    return jumps;
  }

  private static void find(
      Program program, int[] chosen, GraphCopy copy, Map<Scalar, Boolean> found) {
    boolean[] used = used(program);
    boolean[] varies = varying(program, used.length, chosen);
    for (int id = 0; id < used.length; id++) {
      Scalar node = program.expressions().node(id);
      if (!used[id] || node.operation() != ScalarOperation.FUNCTION || !varies[id]) {
        continue;
      }
      MathFunction function = node.function();
      if (function == MathFunction.FLOOR) {
        throw new IllegalArgumentException(
            "floor() of the state or of a parameter jumps at every whole number, and has no"
                + " derivative there; write what it stands for by step() or sign()");
      } else if (function == MathFunction.SIGNUM) {
        add(found, copy.of(node.first()), false);
      } else if (function == MathFunction.ABS) {
        add(found, copy.of(node.first()), true);
      } else if (function == MathFunction.INTERVAL) {
        double[] corners = node.row().corners();
        if (corners.length > 0) {
          add(found, alternating(corners, copy.of(node.first())), true);
        }
      } else if (function == MathFunction.CHOOSE
          || function == MathFunction.MIN
          || function == MathFunction.MAX) {
        Scalar first = node.first();
        Scalar second = node.second();
        if (varies[first.id()] || varies[second.id()]) {
          add(found, copy.of(first).minus(copy.of(second)), function != MathFunction.CHOOSE);
        }
      }
    }
  }

  /** Adds a margin; the same one with the other sign is no further place. */
  private static void add(Map<Scalar, Boolean> found, Scalar margin, boolean corner) {
    Scalar known = found.containsKey(margin.negated()) ? margin.negated() : margin;
    found.merge(known, corner, Boolean::logicalAnd);
  }

  /**
   * Returns a number that changes its sign, with slope 1 or −1, at each of some arguments: the
   * distance from the outer ones, and a parabola s d (1 − d/w) between two at a distance w.
   */
  private static Scalar alternating(double[] zeros, Scalar x) {
    int n = zeros.length;
    double[] origins = new double[n + 1];
    double[] slopes = new double[n + 1];
    double[] bends = new double[n + 1];
    for (int k = 0; k <= n; k++) {
      origins[k] = zeros[Math.max(0, k - 1)];
      slopes[k] = k == 0 || k % 2 == 1 ? 1 : -1;
      boolean between = k > 0 && k < n;
      bends[k] = between ? -slopes[k] / (zeros[k] - zeros[k - 1]) : 0;
    }
    Expressions e = x.expressions();
    Scalar place = e.interval(new NumberRow(zeros), x);
    Scalar d = x.minus(e.element(new NumberRow(origins), place));
    Scalar slope = e.element(new NumberRow(slopes), place);
    return d.times(slope.plus(d.times(e.element(new NumberRow(bends), place))));
  }

  /** Returns whether a node is found by a search: its parts have no part in derivatives. */
  private static boolean isFound(Scalar node) {
    return node.operation() == ScalarOperation.FUNCTION
        && (node.function() == MathFunction.PICK
            || node.function() == MathFunction.HELD
            || node.function() == MathFunction.CLOSEST
            || node.function() == MathFunction.TOUCH);
  }

  /**
   * Returns which nodes the outputs are computed from, but for those of searches; guards have no
   * part in the values.
   */
  private static boolean[] used(Program program) {
    boolean[] used = new boolean[program.expressions().size()];
    for (Program.Section section : program.sections()) {
      section.outputs().forEach(output -> used[output.value().id()] = true);
    }
    for (int id = used.length - 1; id >= 0; id--) {
      if (used[id] && !isFound(program.expressions().node(id))) {
        program.expressions().node(id).operands().forEach(operand -> used[operand.id()] = true);
      }
    }
    return used;
  }

  /** Returns which nodes have derivatives by the state or by a chosen parameter. */
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
        varies[id] |= varies[operand.id()] && !isFound(node);
      }
    }
    return varies;
  }
}
