package org.mechservice.solver.force.law.printed;

import org.mechservice.solver.force.law.PrintedLaw;
import org.mechservice.solver.spatial.Piecewise;

/**
 * Printed from its formula; do not edit. PrintedLawsTest compares it with the formula and
 * prints it anew with -Dgolden.write=true.
 */
final class PrintedJointLowerStop implements PrintedLaw {

  @Override
  public void load(double[] x, double[] c, double[] out) {
    // The load by its formula.
    double v = x[1];
    double law_1 = x[0] - c[2];
    double law_2 = c[1] * v;
    double law_3 = c[0] * Piecewise.choose(0.0, -law_1, -law_1, 0.0);
    out[0] = Piecewise.choose(-law_1, 0.0, Piecewise.choose(0.0, -law_1, Math.max(0.0,
        -(0.5 * law_2)), 0.0), Math.max(0.0, law_3 - (law_2 + c[5] * v * law_3)));
  }

  @Override
  public void slopes(double[] x, double[] c, double[] out) {
    // The load by its formula.
    double stiffness = c[0];
    double damping = c[1];
    double v = x[1];
    double chi = c[5];
    double law_1 = x[0] - c[2];
    double law_2 = stiffness * Piecewise.choose(0.0, -law_1, -law_1, 0.0);
    double law_3 = damping * v;
    double law_4 = chi * v;
    double law_5 = law_2 - (law_3 + law_2 * law_4);
    double law_6 = stiffness * Piecewise.choose(0.0, -law_1, -1.0, 0.0);
    double law_7 = Piecewise.choose(-law_1, 0.0, Piecewise.choose(0.0,
        -law_1, Piecewise.choose(-(0.5 * law_3), 0.0, 0.0, c[6]), 0.0), Piecewise.choose(law_5, 0.0,
        0.0, -(damping + chi * law_2)));
    out[0] = Piecewise.choose(-law_1, 0.0, 0.0, Piecewise.choose(law_5, 0.0, 0.0, law_6
        - law_4 * law_6));
    out[1] = law_7;
  }

  @Override
  public void results(double[] x, double[] c, double[] out) {
    // The load by its formula.
    double stiffness = c[0];
    double v = x[1];
    double law_1 = x[0] - c[2];
    double law_2 = Piecewise.choose(0.0, -law_1, -law_1, 0.0);
    double law_3 = c[1] * v;
    double law_4 = stiffness * law_2;
    double law_5 = Piecewise.choose(-law_1, 0.0, Piecewise.choose(0.0, -law_1, Math.max(0.0,
        -(0.5 * law_3)), 0.0), Math.max(0.0, law_4 - (law_3 + c[5] * v * law_4))) - law_4;
    out[0] = law_2 * law_2 * 0.5 * stiffness;
    out[1] = v * law_5;
  }

  @Override
  public void settle(double[] c, double[] out) {
    // What depends on coefficients alone.
    out[6] = -(0.5 * c[1]);
  }

  @Override
  public int size() {
    return 7;
  }
}
