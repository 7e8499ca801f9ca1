package org.mechservice.solver.ode.newton;

/** A vector function of a vector, to be differenced. */
public interface DifferencedFunction {
  /**
   * Evaluates the function.
   *
   * @param x not modified
   * @param value overwritten
   * @return false if told to stop instead
   */
  boolean evaluate(double[] x, double[] value);
}
