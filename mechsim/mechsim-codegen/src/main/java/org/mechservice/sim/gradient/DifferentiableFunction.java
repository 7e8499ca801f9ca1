package org.mechservice.sim.gradient;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.jspecify.annotations.Nullable;
import org.mechservice.sim.emit.plan.CodeForm;
import org.mechservice.solver.symbol.Differentiation;
import org.mechservice.solver.symbol.Program;
import org.mechservice.solver.symbol.ReverseDifferentiation;
import org.mechservice.solver.symbol.Scalar;
import org.mechservice.solver.symbol.ScalarOperation;

/**
 * A function F(t, y, p) recorded as a program, with its tangents and its adjoint. Each is compiled
 * when it is first asked for. Workspace of one thread.
 */
public final class DifferentiableFunction {
  /** Number of operations from which the tangents of several directions become several classes. */
  private static final int MOST_OPERATIONS = 60_000;

  /** Directions whose programs grow beyond what is compiled well at run time. */
  private static final int MANY = 12;

  private static final double[] NONE = {};

  private final Program program;
  private final Map<Integer, Scalar> outputs = new TreeMap<>();
  private final int inputs;
  private final int count;
  private final int[] chosen;
  private final double[] parameters;
  private final double[] scratch;
  private @Nullable ProgramCode value;
  private @Nullable ProgramCode tangent;
  private @Nullable ProgramCode adjoint;
  private @Nullable JacobianCode jacobian;
  private List<Chunk> chunks = List.of();
  private int[] units = {};

  /** Tangents of some directions, one after another. */
  private record Chunk(ProgramCode code, int first, int size) {}

  /**
   * @param program outputs below {@code count}; not modified
   * @param inputs length of y; every input of the program but time and parameters is below it
   * @param count number of outputs; what the program does not put out is 0
   * @param chosen numbers of the parameters by which it is differentiated
   * @param parameters values of all parameters of the model, SI; read at each evaluation
   */
  DifferentiableFunction(
      Program program, int inputs, int count, int[] chosen, double[] parameters) {
    this.program = program;
    this.inputs = inputs;
    this.count = count;
    this.chosen = chosen.clone();
    this.parameters = parameters;
    this.scratch = new double[count];
    for (Program.Section section : program.sections()) {
      section.outputs().forEach(output -> outputs.put(output.index(), output.value()));
    }
  }

  /** Returns the number of values. */
  public int count() {
    return count;
  }

  /** Returns the length of y. */
  public int inputs() {
    return inputs;
  }

  /** Returns whether the values depend on an element of y from {@code first} on. */
  public boolean usesFrom(int first) {
    int[] uses = program.uses();
    for (int id = 0; id < uses.length; id++) {
      Scalar node = program.expressions().node(id);
      if (uses[id] > 0
          && node.operation() == ScalarOperation.INPUT
          && node.index() >= first
          && node.index() < inputs) {
        return true;
      }
    }
    return false;
  }

  Program program() {
    return program;
  }

  /** Returns a program of the same values with one more section. */
  private Program extended(String title) {
    Program more = program.in(program.sections());
    more.section(title, "d");
    return more;
  }

  /**
   * Evaluates F.
   *
   * @param y length {@link #inputs}; not modified
   * @param out length {@link #count}; overwritten
   * @return {@link ProgramCode#REGULAR}, or the result of a guard that failed
   */
  public int value(double t, double[] y, double[] out) {
    if (value == null) {
      value = ProgramCode.of(program, inputs, parameters);
    }
    return value.run(t, y, NONE, out);
  }

  /** Returns the derivatives of the outputs along a direction, into a program. */
  private void tangents(Program into, Map<Scalar, Scalar> rates, int from) {
    Differentiation along = new Differentiation(program.expressions(), rates);
    if (program.operationCount() >= CodeForm.LEAST_OPERATIONS) {
      along.sections(program, into);
      into.section("Derivatives of the outputs.", "d");
    }
    outputs.forEach((index, node) -> into.output(from + index, along.of(node)));
  }

  /**
   * Evaluates F and its derivative along any direction.
   *
   * @param seed rates of y, of t and of the chosen parameters (SI); not modified
   * @param out F, then F_y dy + F_t dt + F_p dp: 2 {@link #count} numbers; overwritten
   * @return as {@link #value}
   */
  public int tangent(double t, double[] y, double[] seed, double[] out) {
    if (tangent == null) {
      Program more = extended("Derivative along a direction.");
      Map<Scalar, Scalar> rates = new HashMap<>();
      for (int i = 0; i < inputs; i++) {
        rates.put(input(i), input(inputs + i));
      }
      rates.put(input(Program.TIME), input(2 * inputs));
      for (int k = 0; k < chosen.length; k++) {
        rates.put(input(Program.PARAMETER + chosen[k]), input(2 * inputs + 1 + k));
      }
      tangents(more, rates, count);
      tangent = ProgramCode.of(more, inputs, parameters);
    }
    return tangent.run(t, y, seed, out);
  }

  private Scalar input(int index) {
    return program.expressions().input(index);
  }

  /**
   * Prepares {@link #tangents} for some directions at once: by a program for each of them, or, for
   * more than half as many as y has elements, or a sixth if they are many, by products with the
   * Jacobian.
   *
   * @param unit for each direction the place among the chosen parameters of the one that changes
   *     with it by 1; −1: none does
   */
  public void directions(int[] unit) {
    boolean isPrepared = jacobian != null || !chunks.isEmpty();
    if (isPrepared && Arrays.equals(unit, units)) {
      return;
    }
    units = unit.clone();
    chunks = new ArrayList<>();
    jacobian = null;
    if (2 * unit.length > inputs || (unit.length > MANY && 6 * unit.length > inputs)) {
      int[] of = Arrays.stream(unit).map(k -> k < 0 ? -1 : Program.PARAMETER + chosen[k]).toArray();
      jacobian = new JacobianCode(program, outputs, inputs, count, of, parameters);
      return;
    }
    int size = Math.max(1, unit.length);
    while (true) {
      Program first = ofDirections(0, Math.min(size, unit.length));
      if (size == 1 || first.operationCount() <= MOST_OPERATIONS) {
        chunks.add(
            new Chunk(ProgramCode.of(first, inputs, parameters), 0, Math.min(size, unit.length)));
        break;
      }
      size = (size + 1) / 2;
    }
    for (int k = size; k < unit.length; k += size) {
      int next = Math.min(size, unit.length - k);
      chunks.add(new Chunk(ProgramCode.of(ofDirections(k, next), inputs, parameters), k, next));
    }
  }

  private Program ofDirections(int first, int size) {
    Program more = extended("Derivatives along several directions.");
    for (int k = 0; k < size; k++) {
      Map<Scalar, Scalar> rates = new HashMap<>();
      for (int i = 0; i < inputs; i++) {
        rates.put(input(i), input(inputs + (first + k) * inputs + i));
      }
      if (units[first + k] >= 0) {
        rates.put(input(Program.PARAMETER + chosen[units[first + k]]), program.expressions().one());
      }
      tangents(more, rates, count + (first + k) * count);
    }
    return more;
  }

  /**
   * Evaluates F and its derivatives along the directions of {@link #directions}.
   *
   * @param seeds rates of y, direction after direction, {@link #inputs} numbers each; not modified
   * @param out F, then the derivatives, {@link #count} numbers each; overwritten
   * @return as {@link #value}
   */
  public int tangents(double t, double[] y, double[] seeds, double[] out) {
    if (jacobian != null) {
      return jacobian.tangents(t, y, seeds, out);
    }
    int result = ProgramCode.REGULAR;
    for (int i = 0; i < chunks.size() && result == ProgramCode.REGULAR; i++) {
      result = chunks.get(i).code().run(t, y, seeds, out);
    }
    return result;
  }

  /**
   * Evaluates the derivatives of Σ weight · F by all inputs.
   *
   * @param weights length {@link #count}; not modified
   * @param out derivatives by y, by t and by the chosen parameters: {@link #inputs} + 1 + their
   *     number; overwritten
   * @return as {@link #value}
   */
  public int adjoint(double t, double[] y, double[] weights, double[] out) {
    if (adjoint == null) {
      Program more = program.in(guardsOnly());
      more.section("Derivatives of the weighted sum.", "adjoint");
      Map<Scalar, Scalar> sum = new HashMap<>();
      outputs.forEach((index, node) -> sum.merge(node, input(inputs + index), Scalar::plus));
      boolean isLong = program.operationCount() >= CodeForm.LEAST_OPERATIONS;
      ReverseDifferentiation slopes =
          isLong
              ? ReverseDifferentiation.sections(program, sum, more)
              : new ReverseDifferentiation(program.expressions(), sum);
      if (isLong) {
        more.section("Derivatives by the inputs.", "by");
      }
      for (int i = 0; i < inputs; i++) {
        more.output(i, slopes.by(input(i)));
      }
      more.output(inputs, slopes.by(input(Program.TIME)));
      for (int k = 0; k < chosen.length; k++) {
        more.output(inputs + 1 + k, slopes.by(input(Program.PARAMETER + chosen[k])));
      }
      adjoint = ProgramCode.of(more, inputs, parameters);
    }
    return adjoint.run(t, y, weights, out);
  }

  /** Returns the sections without their outputs: they hold values that the adjoint uses. */
  private List<Program.Section> guardsOnly() {
    return program.sections().stream().map(Program.Section::withoutOutputs).toList();
  }

  /** Returns the values of F in an array that the next call overwrites. */
  public double[] values(double t, double[] y) {
    value(t, y, scratch);
    return scratch;
  }
}
