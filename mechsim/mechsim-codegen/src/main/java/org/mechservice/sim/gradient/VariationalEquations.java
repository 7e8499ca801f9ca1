package org.mechservice.sim.gradient;

import org.mechservice.solver.symbol.Program;

/**
 * y' = f(t, y, p) of a model with tangents and adjoint. The state is [q; v; s] as a run has it; p
 * are the chosen parameters, SI. Workspace of one thread.
 *
 * <p>All methods that evaluate return {@link ProgramCode#REGULAR}, or another number where f has no
 * value: a force without direction, a joint without inertia beyond it, dependent equations of
 * loops.
 */
public abstract class VariationalEquations {
  private final int states;

  VariationalEquations(int states) {
    this.states = states;
  }

  /** Returns the number of states. */
  public final int states() {
    return states;
  }

  /**
   * Evaluates f.
   *
   * @param y state, may be longer; not modified
   * @param yDot overwritten, its first {@link #states} numbers
   */
  public abstract int derivative(double t, double[] y, double[] yDot);

  /**
   * Prepares {@link #tangents}.
   *
   * @param unit for each direction the place among the chosen parameters of the one that changes
   *     with it by 1; −1: none does
   */
  public abstract void directions(int[] unit);

  /**
   * Evaluates f and its derivatives along the directions of {@link #directions}.
   *
   * @param seeds rates of y, direction after direction; not modified
   * @param out f, then the derivatives, {@link #states} numbers each; overwritten
   */
  public abstract int tangents(double t, double[] y, double[] seeds, double[] out);

  /**
   * Evaluates f and its derivative along any direction.
   *
   * @param seed rates of y, of t and of the chosen parameters; not modified
   * @param out f, then the derivative, {@link #states} numbers each; overwritten
   */
  public abstract int tangent(double t, double[] y, double[] seed, double[] out);

  /**
   * Evaluates the derivatives of Σ weight · f by the state, the time and the chosen parameters.
   *
   * @param weights length {@link #states}; not modified
   * @param out {@link #states} + 1 + number of chosen parameters; overwritten
   */
  public abstract int adjoint(double t, double[] y, double[] weights, double[] out);

  /**
   * Moves a state onto the loops; leaves it as it is if there are none.
   *
   * @param y state; overwritten
   * @return whether the loops are closed now
   */
  public boolean project(double t, double[] y) {
    return true;
  }

  /** Returns the programs in which values may jump. */
  abstract Iterable<Program> programs();
}
