package org.mechservice.solver.force.law.printed;

import org.mechservice.solver.force.law.PrintedLaw;
import org.mechservice.solver.spatial.Piecewise;

/**
 * Printed from its formula; do not edit. PrintedLawsTest compares it with the formula and
 * prints it anew with -Dgolden.write=true.
 */
final class PrintedSmoothJointUpperStop implements PrintedLaw {

  @Override
  public void load(double[] x, double[] c, double[] out) {
    // The load by its formula.
    double v = x[1];
    double law_1 = x[0] - c[2];
    double law_2 = Math.sqrt(law_1 * law_1 + c[6]);
    double law_3 = Piecewise.choose(0.0, law_1, 0.5 * (law_1 + law_2), c[4] / (law_2
        - law_1) * c[7]);
    double law_4 = c[0] * law_3;
    double law_5 = 0.5 * law_4;
    double law_6 = law_3 / law_2 * (c[1] * v) + c[5] * v * law_4 + law_4;
    double law_7 = Math.max(-1.0, Math.min(1.0, law_6 / (1e-300 + law_5)));
    double law_8 = 1.0 + law_7;
    double law_9 = law_8 * law_8 * law_8;
    double law_10 = (63.0 + law_7 * (law_7 * (102.0 + law_7 * (7.0 * law_7 - 42.0))
        - 122.0)) * (law_9 * law_9) * 0.001953125 * law_5 + Math.max(0.0, law_6 - law_5);
    out[0] = -law_10;
  }

  @Override
  public void slopes(double[] x, double[] c, double[] out) {
    // The load by its formula.
    double stiffness = c[0];
    double settled_2 = c[7];
    double damping = c[1];
    double v = x[1];
    double chi = c[5];
    double law_1 = x[0] - c[2];
    double law_2 = Math.sqrt(law_1 * law_1 + c[6]);
    double law_3 = law_2 - law_1;
    double law_4 = c[4] / law_3;
    double law_5 = Piecewise.choose(0.0, law_1, 0.5 * (law_1 + law_2), law_4 * settled_2);
    double law_6 = stiffness * law_5;
    double law_7 = law_5 / law_2;
    double law_8 = damping * v;
    double law_9 = chi * v;
    double law_10 = law_7 * law_8 + law_6 * law_9 + law_6;
    double law_11 = 0.5 * law_6;
    double law_12 = law_10 - law_11;
    double law_13 = 0.5 * (law_1 + law_1) / law_2;
    double law_14 = Piecewise.choose(0.0, law_1, 0.5 * (1.0 + law_13), -(law_4 * (law_13
        - 1.0) / law_3 * settled_2));
    double law_15 = stiffness * law_14;
    double law_16 = law_9 * law_15 + (law_14 - law_7 * law_13) / law_2 * law_8 + law_15;
    double law_17 = 0.5 * law_15;
    double law_18 = 1e-300 + law_11;
    double law_19 = law_10 / law_18;
    double law_20 = Math.min(1.0, law_19);
    double law_21 = Math.max(-1.0, law_20);
    double law_22 = 7.0 * law_21 - 42.0;
    double law_23 = 102.0 + law_21 * law_22;
    double law_24 = law_21 * law_23 - 122.0;
    double law_25 = 63.0 + law_21 * law_24;
    double law_26 = 1.0 + law_21;
    double law_27 = law_26 * law_26;
    double law_28 = law_26 * law_27;
    double law_29 = law_28 * law_28;
    double law_30 = Piecewise.choose(law_20, -1.0, 0.0, Piecewise.choose(1.0, law_19, 0.0, (law_16
        - law_19 * law_17) / law_18));
    double law_31 = law_26 * law_30;
    double law_32 = law_28 * (law_27 * law_30 + law_26 * (law_31 + law_31));
    double law_33 = law_29 * (law_24 * law_30 + law_21 * (law_23 * law_30
        + law_21 * (law_22 * law_30 + 7.0 * law_30 * law_21))) + law_25 * (law_32 + law_32);
    double law_34 = chi * law_6 + damping * law_7;
    double law_35 = Piecewise.choose(law_20, -1.0, 0.0, Piecewise.choose(1.0, law_19, 0.0, law_34
        / law_18));
    double law_36 = law_26 * law_35;
    double law_37 = law_28 * (law_27 * law_35 + law_26 * (law_36 + law_36));
    double law_38 = law_29 * (law_24 * law_35 + law_21 * (law_23 * law_35
        + law_21 * (law_22 * law_35 + 7.0 * law_35 * law_21))) + law_25 * (law_37 + law_37);
    out[0] = -(law_25 * law_29 * 0.001953125 * law_17 + 0.001953125 * law_33 * law_11
        + Piecewise.choose(law_12, 0.0, 0.0, law_16 - law_17));
    out[1] = -(Piecewise.choose(law_12, 0.0, 0.0, law_34) + 0.001953125 * law_38 * law_11);
  }

  @Override
  public void results(double[] x, double[] c, double[] out) {
    // The load by its formula.
    double stiffness = c[0];
    double v = x[1];
    double law_1 = x[0] - c[2];
    double law_2 = Math.sqrt(law_1 * law_1 + c[6]);
    double law_3 = Piecewise.choose(0.0, law_1, 0.5 * (law_1 + law_2), c[4] / (law_2
        - law_1) * c[7]);
    double law_4 = stiffness * law_3;
    double law_5 = 0.5 * law_4;
    double law_6 = law_3 / law_2 * (c[1] * v) + c[5] * v * law_4 + law_4;
    double law_7 = Math.max(-1.0, Math.min(1.0, law_6 / (1e-300 + law_5)));
    double law_8 = 1.0 + law_7;
    double law_9 = law_8 * law_8 * law_8;
    double law_10 = (63.0 + law_7 * (law_7 * (102.0 + law_7 * (7.0 * law_7 - 42.0))
        - 122.0)) * (law_9 * law_9) * 0.001953125 * law_5 + Math.max(0.0, law_6 - law_5);
    out[0] = stiffness * (law_3 * law_3 * 0.5 + (StrictMath.log(law_3 * c[8]) - 0.5) * c[9]);
    out[1] = -(v * (law_10 - law_4));
  }

  @Override
  public void settle(double[] c, double[] out) {
    // What depends on coefficients alone.
    double c_4 = c[4];
    double c_1 = c_4 * c_4;
    out[6] = c_1;
    out[7] = 0.5 * c_4;
    out[8] = 2.0 / c_4;
    out[9] = 0.25 * c_1;
  }

  @Override
  public int size() {
    return 10;
  }
}
