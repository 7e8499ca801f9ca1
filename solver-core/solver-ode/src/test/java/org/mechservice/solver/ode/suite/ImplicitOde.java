package org.mechservice.solver.ode.suite;

import org.mechservice.solver.ode.ResidualSystem;

/** A problem in residual form written down in a test. */
public class ImplicitOde implements ResidualSystem {
  /** F(t, y, y'). */
  public interface Equation {
    void evaluate(double t, double[] y, double[] yDot, double[] residual);
  }

  private final int dimension;
  private final Equation equation;

  public ImplicitOde(int dimension, Equation equation) {
    this.dimension = dimension;
    this.equation = equation;
  }

  @Override
  public int dimension() {
    return dimension;
  }

  @Override
  public void residual(double t, double[] y, double[] yDot, double[] residual) {
    equation.evaluate(t, y, yDot, residual);
  }
}
