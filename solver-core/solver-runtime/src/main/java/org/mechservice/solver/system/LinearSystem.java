package org.mechservice.solver.system;

import java.util.List;
import org.mechservice.solver.api.result.Variable;

/**
 * A linear time-invariant system x' = A x + B u, y = C x + D u. An element of a matrix has the unit
 * of its row (for A and B: of the state, per second) over that of its column.
 */
public final class LinearSystem {
  private final List<Variable> states;
  private final List<Variable> inputs;
  private final List<Variable> outputs;

  /** Matrices, row by row. */
  private final double[] a;

  private final double[] b;
  private final double[] c;
  private final double[] d;

  /**
   * Joins the matrices.
   *
   * @param states names and units of x, n of them
   * @param inputs names and units of u, m of them
   * @param outputs names and units of y, p of them
   * @param a n × n, row by row, as the others; not copied
   * @param b n × m
   * @param c p × n
   * @param d p × m
   * @throws IllegalArgumentException if a matrix has another size
   */
  public LinearSystem(
      List<Variable> states,
      List<Variable> inputs,
      List<Variable> outputs,
      double[] a,
      double[] b,
      double[] c,
      double[] d) {
    this.states = List.copyOf(states);
    this.inputs = List.copyOf(inputs);
    this.outputs = List.copyOf(outputs);
    this.a = sized("A", a, states.size(), states.size());
    this.b = sized("B", b, states.size(), inputs.size());
    this.c = sized("C", c, outputs.size(), states.size());
    this.d = sized("D", d, outputs.size(), inputs.size());
  }

  private static double[] sized(String name, double[] matrix, int rows, int columns) {
    if (matrix.length != rows * columns) {
      throw new IllegalArgumentException(
          name + " has " + matrix.length + " elements, not " + rows + " x " + columns);
    }
    return matrix;
  }

  /** Returns names and units of the states x. */
  public List<Variable> states() {
    return states;
  }

  /** Returns names and units of the inputs u. */
  public List<Variable> inputs() {
    return inputs;
  }

  /** Returns names and units of the outputs y. */
  public List<Variable> outputs() {
    return outputs;
  }

  /** Returns an element of A. */
  public double a(int row, int column) {
    return a[row * states.size() + column];
  }

  /** Returns an element of B. */
  public double b(int row, int column) {
    return b[row * inputs.size() + column];
  }

  /** Returns an element of C. */
  public double c(int row, int column) {
    return c[row * states.size() + column];
  }

  /** Returns an element of D. */
  public double d(int row, int column) {
    return d[row * inputs.size() + column];
  }

  /** Returns A, B, C and D, each row by row; copies. */
  public List<double[]> matrices() {
    return List.of(a.clone(), b.clone(), c.clone(), d.clone());
  }
}
