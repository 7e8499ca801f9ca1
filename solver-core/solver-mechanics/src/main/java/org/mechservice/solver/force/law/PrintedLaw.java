package org.mechservice.solver.force.law;

/**
 * A law as methods over arrays, printed from its formula. Workspace of one thread; nothing
 * allocates.
 */
public interface PrintedLaw {
  /** Returns the number of coefficients together with what is computed from them. */
  int size();

  /**
   * Computes what depends on coefficients alone, once for each change of them.
   *
   * @param c coefficients, in the order of the law
   * @param out the same array; overwritten behind the coefficients
   */
  void settle(double[] c, double[] out);

  /**
   * Computes the load.
   *
   * @param x variables, as the law says; not modified
   * @param c coefficients, settled; not modified
   * @param out overwritten where the law puts something out, as it says
   */
  void load(double[] x, double[] c, double[] out);

  /** Computes the derivatives of the load by motions, likewise. */
  void slopes(double[] x, double[] c, double[] out);

  /** Computes potential energy, power and values for results, likewise. */
  void results(double[] x, double[] c, double[] out);
}
