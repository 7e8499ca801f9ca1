package org.mechservice.solver.force.law.printed;

import org.mechservice.solver.force.law.PrintedLaw;

/**
 * Printed from its formula; do not edit. PrintedLawsTest compares it with the formula and
 * prints it anew with -Dgolden.write=true.
 */
final class PrintedJointSpring implements PrintedLaw {

  @Override
  public void load(double[] x, double[] c, double[] out) {
    // The load by its formula.
    out[0] = -(c[3] + c[0] * (x[0] - c[2]) + c[1] * x[1]);
  }

  @Override
  public void slopes(double[] x, double[] c, double[] out) {
    // The load by its formula.
    out[0] = -c[0];
    out[1] = -c[1];
  }

  @Override
  public void results(double[] x, double[] c, double[] out) {
    // The load by its formula.
    double v = x[1];
    double law_1 = x[0] - c[2];
    out[0] = law_1 * (c[3] + law_1 * c[6]);
    out[1] = -(c[1] * v * v);
  }

  @Override
  public void settle(double[] c, double[] out) {
    // What depends on coefficients alone.
    out[6] = 0.5 * c[0];
  }

  @Override
  public int size() {
    return 7;
  }
}
