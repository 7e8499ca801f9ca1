package org.mechservice.solver.force.law;

/**
 * A law as methods over arrays, printed from its formula. Workspace of one thread; nothing
 * allocates.
 */
public interface PrintedLaw {
  /**
   * Computes the load.
   *
   * @param x variables, as the law says; not modified
   * @param c coefficients, in the order of the law; not modified
   * @param out overwritten where the law puts something out, as it says
   */
  void load(double[] x, double[] c, double[] out);

  /** Computes the derivatives of the load by motions, likewise. */
  void slopes(double[] x, double[] c, double[] out);

  /** Computes potential energy, power and values for results, likewise. */
  void results(double[] x, double[] c, double[] out);
}
