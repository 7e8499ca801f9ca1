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
    double law_2 = Math.sqrt(law_1 * law_1 + c[7]);
    double law_3 = Math.abs(law_1);
    double law_4 = c[6] / (law_2 + law_3) + 0.5 * (law_1 + law_3);
    double law_5 = c[0] * law_4;
    double law_6 = 0.5 * law_5;
    double law_7 = law_4 / law_2 * (c[1] * v) + c[5] * v * law_5 + law_5;
    double law_8 = Math.max(-1.0, Math.min(1.0, law_7 / (1e-300 + law_6)));
    double law_9 = 1.0 + law_8;
    double law_10 = law_9 * law_9 * law_9;
    double law_11 = (63.0 + law_8 * (law_8 * (102.0 + law_8 * (7.0 * law_8 - 42.0))
        - 122.0)) * (law_10 * law_10) * 0.001953125 * law_6 + Math.max(0.0, law_7 - law_6);
    out[0] = -law_11;
  }

  @Override
  public void slopes(double[] x, double[] c, double[] out) {
    // The load by its formula.
    double stiffness = c[0];
    double damping = c[1];
    double v = x[1];
    double chi = c[5];
    double law_1 = x[0] - c[2];
    double law_2 = Math.sqrt(law_1 * law_1 + c[7]);
    double law_3 = Math.abs(law_1);
    double law_4 = law_2 + law_3;
    double law_5 = c[6] / law_4;
    double law_6 = law_5 + 0.5 * (law_1 + law_3);
    double law_7 = stiffness * law_6;
    double law_8 = law_6 / law_2;
    double law_9 = damping * v;
    double law_10 = chi * v;
    double law_11 = law_8 * law_9 + law_7 * law_10 + law_7;
    double law_12 = 0.5 * law_7;
    double law_13 = law_11 - law_12;
    double law_14 = Math.signum(law_1);
    double law_15 = 0.5 * (law_1 + law_1) / law_2;
    double law_16 = 0.5 * (1.0 + law_14) - law_5 * (law_14 + law_15) / law_4;
    double law_17 = stiffness * law_16;
    double law_18 = law_10 * law_17 + (law_16 - law_8 * law_15) / law_2 * law_9 + law_17;
    double law_19 = 0.5 * law_17;
    double law_20 = 1e-300 + law_12;
    double law_21 = law_11 / law_20;
    double law_22 = Math.min(1.0, law_21);
    double law_23 = Math.max(-1.0, law_22);
    double law_24 = 7.0 * law_23 - 42.0;
    double law_25 = 102.0 + law_23 * law_24;
    double law_26 = law_23 * law_25 - 122.0;
    double law_27 = 63.0 + law_23 * law_26;
    double law_28 = 1.0 + law_23;
    double law_29 = law_28 * law_28;
    double law_30 = law_28 * law_29;
    double law_31 = law_30 * law_30;
    double law_32 = Piecewise.choose(law_22, -1.0, 0.0, Piecewise.choose(1.0, law_21, 0.0, (law_18
        - law_21 * law_19) / law_20));
    double law_33 = law_28 * law_32;
    double law_34 = law_30 * (law_29 * law_32 + law_28 * (law_33 + law_33));
    double law_35 = law_31 * (law_26 * law_32 + law_23 * (law_25 * law_32
        + law_23 * (law_24 * law_32 + 7.0 * law_32 * law_23))) + law_27 * (law_34 + law_34);
    double law_36 = chi * law_7 + damping * law_8;
    double law_37 = Piecewise.choose(law_22, -1.0, 0.0, Piecewise.choose(1.0, law_21, 0.0, law_36
        / law_20));
    double law_38 = law_28 * law_37;
    double law_39 = law_30 * (law_29 * law_37 + law_28 * (law_38 + law_38));
    double law_40 = law_31 * (law_26 * law_37 + law_23 * (law_25 * law_37
        + law_23 * (law_24 * law_37 + 7.0 * law_37 * law_23))) + law_27 * (law_39 + law_39);
    out[0] = -(law_27 * law_31 * 0.001953125 * law_19 + 0.001953125 * law_35 * law_12
        + Piecewise.choose(law_13, 0.0, 0.0, law_18 - law_19));
    out[1] = -(Piecewise.choose(law_13, 0.0, 0.0, law_36) + 0.001953125 * law_40 * law_12);
  }

  @Override
  public void results(double[] x, double[] c, double[] out) {
    // The load by its formula.
    double stiffness = c[0];
    double v = x[1];
    double law_1 = x[0] - c[2];
    double law_2 = Math.sqrt(law_1 * law_1 + c[7]);
    double law_3 = Math.abs(law_1);
    double law_4 = c[6] / (law_2 + law_3) + 0.5 * (law_1 + law_3);
    double law_5 = stiffness * law_4;
    double law_6 = 0.5 * law_5;
    double law_7 = law_4 / law_2 * (c[1] * v) + c[5] * v * law_5 + law_5;
    double law_8 = Math.max(-1.0, Math.min(1.0, law_7 / (1e-300 + law_6)));
    double law_9 = 1.0 + law_8;
    double law_10 = law_9 * law_9 * law_9;
    double law_11 = (63.0 + law_8 * (law_8 * (102.0 + law_8 * (7.0 * law_8 - 42.0))
        - 122.0)) * (law_10 * law_10) * 0.001953125 * law_6 + Math.max(0.0, law_7 - law_6);
    out[0] = stiffness * (law_4 * law_4 * 0.5 + (StrictMath.log(law_4 * c[8]) - 0.5) * c[9]);
    out[1] = -(v * (law_11 - law_5));
  }

  @Override
  public void settle(double[] c, double[] out) {
    // What depends on coefficients alone.
    double c_4 = c[4];
    double c_1 = c_4 * c_4;
    out[6] = 0.5 * c_1;
    out[7] = c_1;
    out[8] = 2.0 / c_4;
    out[9] = 0.25 * c_1;
  }

  @Override
  public int size() {
    return 10;
  }
}
