package org.mechservice.solver.force.law.printed;

import org.mechservice.solver.force.law.PrintedLaw;
import org.mechservice.solver.spatial.Piecewise;

/**
 * Printed from its formula; do not edit. PrintedLawsTest compares it with the formula and
 * prints it anew with -Dgolden.write=true.
 */
final class PrintedJointFriction implements PrintedLaw {

  @Override
  public void load(double[] x, double[] c, double[] out) {
    // The load by its formula.
    double v = x[1];
    double coulomb = c[0];
    out[0] = -(c[2] * v + Piecewise.choose(coulomb, 0.0, 0.0, v / Math.sqrt(v * v
        + c[3]) * coulomb));
  }

  @Override
  public void slopes(double[] x, double[] c, double[] out) {
    // The load by its formula.
    double coulomb = c[0];
    double v = x[1];
    double law_1 = Math.sqrt(v * v + c[3]);
    out[1] = -(c[2] + Piecewise.choose(coulomb, 0.0, 0.0, (1.0 - v / law_1 * (0.5 * (v
        + v) / law_1)) / law_1 * coulomb));
  }

  @Override
  public void results(double[] x, double[] c, double[] out) {
    // The load by its formula.
    double v = x[1];
    double coulomb = c[0];
    out[0] = 0.0;
    out[1] = -(v * (c[2] * v + Piecewise.choose(coulomb, 0.0, 0.0, v / Math.sqrt(v * v
        + c[3]) * coulomb)));
  }

  @Override
  public void settle(double[] c, double[] out) {
    // What depends on coefficients alone.
    double c_1 = c[1];
    out[3] = c_1 * c_1;
  }

  @Override
  public int size() {
    return 4;
  }
}
