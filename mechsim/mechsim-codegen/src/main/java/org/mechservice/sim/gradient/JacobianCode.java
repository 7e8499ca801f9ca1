package org.mechservice.sim.gradient;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.mechservice.solver.symbol.Differentiation;
import org.mechservice.solver.symbol.Expressions;
import org.mechservice.solver.symbol.Program;
import org.mechservice.solver.symbol.Scalar;

/**
 * F together with those of its derivatives F_y and F_p that are not 0 everywhere. Tangents along
 * directions are products with it, so the code does not grow with the number of directions: for
 * many of them this costs less than a program of each.
 *
 * <p>A parameter acts on F through the last node z that every way from it to F passes, such as the
 * torque of a joint: F_p = F_z z_p. Parameters with the same z share F_z.
 */
final class JacobianCode {
  private static final double[] NONE = {};

  private final int inputs;
  private final int count;
  private final ProgramCode code;

  /** F, then the entries of F_y column after column, those of F_z, and z_p. */
  private final double[] value;

  /** For each column where its entries begin in {@code value}: those of y, then those of z. */
  private final int[] columnAt;

  /** For each entry its row. */
  private final int[] row;

  /** Entries of F_y row after row: where in {@code value}, and by which element of y. */
  private final int[] rowAt;

  private final int[] entry;
  private final int[] element;

  /** For each direction the column of its z; −1 without one. */
  private final int[] through;

  /** For each direction where {@code value} has z_p. */
  private final int[] slopeAt;

  /** Rates of y, element after element: those of all directions. */
  private final double[] rates;

  /** Derivatives of F, element after element: those along all directions. */
  private final double[] sums;

  /**
   * @param program with the values of F as outputs; not modified
   * @param outputs those values by index
   * @param parameter for each direction the input whose rate is 1; −1 for none
   */
  JacobianCode(
      Program program,
      Map<Integer, Scalar> outputs,
      int inputs,
      int count,
      int[] parameter,
      double[] parameters) {
    this.inputs = inputs;
    this.count = count;
    Expressions expressions = program.expressions();
    int[] next = nextDominators(outputs);
    Map<Scalar, Integer> shared = new LinkedHashMap<>();
    through = new int[parameter.length];
    List<Scalar> slopes = new ArrayList<>();
    for (int k = 0; k < parameter.length; k++) {
      Scalar input = parameter[k] < 0 ? expressions.zero() : expressions.input(parameter[k]);
      boolean acts = parameter[k] >= 0 && input.id() < next.length && next[input.id()] >= 0;
      through[k] = -1;
      Scalar slope = expressions.zero();
      if (acts) {
        Scalar last = input;
        while (next[last.id()] < next.length) {
          last = expressions.node(next[last.id()]);
        }
        through[k] = shared.computeIfAbsent(last, z -> inputs + shared.size());
        slope = new Differentiation(expressions, Map.of(input, expressions.one())).of(last);
      }
      slopes.add(slope);
    }
    Program more = program.in(program.sections());
    more.section("Derivatives by the state and by what parameters act through.", "d");
    List<Integer> rows = new ArrayList<>();
    int columns = inputs + shared.size();
    columnAt = new int[columns + 1];
    List<Scalar> sources = new ArrayList<>();
    for (int j = 0; j < inputs; j++) {
      sources.add(expressions.input(j));
    }
    sources.addAll(shared.keySet());
    for (int j = 0; j < columns; j++) {
      columnAt[j] = rows.size();
      Map<Scalar, Scalar> rate = new HashMap<>();
      rate.put(sources.get(j), expressions.one());
      Differentiation by = new Differentiation(expressions, rate);
      outputs.forEach(
          (index, node) -> {
            Scalar entry = by.of(node);
            if (!entry.isZero()) {
              more.output(count + rows.size(), entry);
              rows.add(index);
            }
          });
    }
    columnAt[columns] = rows.size();
    row = rows.stream().mapToInt(Integer::intValue).toArray();
    rowAt = new int[count + 1];
    entry = new int[columnAt[inputs]];
    element = new int[columnAt[inputs]];
    orderByRows();
    slopeAt = new int[parameter.length];
    for (int k = 0; k < parameter.length; k++) {
      slopeAt[k] = count + row.length + k;
      more.output(slopeAt[k], slopes.get(k));
    }
    value = new double[count + row.length + parameter.length];
    rates = new double[inputs * parameter.length];
    sums = new double[count * parameter.length];
    code = ProgramCode.of(more, inputs, parameters);
  }

  private void orderByRows() {
    int next = 0;
    for (int i = 0; i < count; i++) {
      rowAt[i] = next;
      for (int j = 0; j < inputs; j++) {
        for (int e = columnAt[j]; e < columnAt[j + 1]; e++) {
          if (row[e] == i) {
            entry[next] = count + e;
            element[next++] = j;
          }
        }
      }
    }
    rowAt[count] = next;
  }

  /**
   * Returns for each node the next one that all ways from it to the values pass; the length of the
   * result where there is none, −1 where no way leads to a value. This is the tree of dominators of
   * the reversed graph (Cooper, Harvey and Kennedy 2001); one sweep finds it, since operands are
   * older than what is made of them.
   */
  private static int[] nextDominators(Map<Integer, Scalar> outputs) {
    int size = outputs.values().stream().mapToInt(Scalar::id).max().orElse(-1) + 1;
    int[] next = new int[size];
    Arrays.fill(next, -1);
    Scalar[] reached = new Scalar[size];
    for (Scalar node : outputs.values()) {
      next[node.id()] = size;
      reached[node.id()] = node;
    }
    for (int id = size - 1; id >= 0; id--) {
      Scalar node = reached[id];
      if (node == null) {
        continue;
      }
      for (Scalar operand : node.operands()) {
        int at = operand.id();
        reached[at] = operand;
        next[at] = next[at] < 0 ? id : common(next, next[at], id);
      }
    }
    return next;
  }

  private static int common(int[] next, int a, int b) {
    int first = a;
    int second = b;
    while (first != second) {
      if (first < second) {
        first = next[first];
      } else {
        second = next[second];
      }
    }
    return first;
  }

  /**
   * Evaluates F and its derivatives along the directions.
   *
   * @param seeds rates of y, direction after direction; not modified
   * @param out F, then the derivatives, as many numbers each as F has; overwritten
   * @return {@link ProgramCode#REGULAR}, or the result of a guard that failed
   */
  int tangents(double t, double[] y, double[] seeds, double[] out) {
    int result = code.run(t, y, NONE, value);
    if (result != ProgramCode.REGULAR) {
      return result;
    }
    System.arraycopy(value, 0, out, 0, count);
    int directions = through.length;
    for (int k = 0; k < directions; k++) {
      for (int j = 0; j < inputs; j++) {
        rates[j * directions + k] = seeds[k * inputs + j];
      }
    }
    Arrays.fill(sums, 0);
    for (int i = 0; i < count; i++) {
      addRow(rowAt[i], rowAt[i + 1], i * directions);
    }
    for (int k = 0; k < directions; k++) {
      if (through[k] >= 0) {
        addParameter(k);
      }
      for (int i = 0; i < count; i++) {
        out[(k + 1) * count + i] = sums[i * directions + k];
      }
    }
    return result;
  }

  /** Adds the entries of a row times the rates of their elements of y, for all directions. */
  private void addRow(int first, int end, int to) {
    int directions = through.length;
    int e = first;
    // four at once: the sums are read and written a quarter as often
    for (; e + 3 < end; e += 4) {
      double a = value[entry[e]];
      double b = value[entry[e + 1]];
      double c = value[entry[e + 2]];
      double d = value[entry[e + 3]];
      if (!(Math.abs(a) + Math.abs(b) + Math.abs(c) + Math.abs(d) <= Double.MAX_VALUE)) {
        break;
      }
      int ofA = element[e] * directions;
      int ofB = element[e + 1] * directions;
      int ofC = element[e + 2] * directions;
      int ofD = element[e + 3] * directions;
      for (int k = 0; k < directions; k++) {
        sums[to + k] +=
            a * rates[ofA + k] + b * rates[ofB + k] + (c * rates[ofC + k] + d * rates[ofD + k]);
      }
    }
    for (; e < end; e++) {
      int from = element[e] * directions;
      for (int k = 0; k < directions; k++) {
        addProduct(value[entry[e]], rates[from + k], to + k);
      }
    }
  }

  private void addParameter(int k) {
    for (int e = columnAt[through[k]]; e < columnAt[through[k] + 1]; e++) {
      addProduct(value[count + e], value[slopeAt[k]], row[e] * through.length + k);
    }
  }

  /** A rate 0 adds nothing, even where the derivative is infinite. */
  private void addProduct(double entry, double rate, int to) {
    if (rate != 0) {
      sums[to] += entry * rate;
    }
  }
}
