package org.mechservice.solver.force.law.printed;

import org.mechservice.solver.force.law.PrintedLaw;
import org.mechservice.solver.spatial.Piecewise;

/**
 * Printed from its formula; do not edit. PrintedLawsTest compares it with the formula and
 * prints it anew with -Dgolden.write=true.
 */
final class PrintedJointUpperStop implements PrintedLaw {

  @Override
  public void load(double[] x, double[] c, double[] out) {
    // The load by its formula.
    double stiffness = c[0];
    double eps = c[4];
    double v = x[1];
    double law_1 = x[0] - c[2];
    double law_2 = Math.sqrt(law_1 * law_1 + eps * eps);
    double law_3 = Piecewise.choose(0.0, law_1, law_1, 0.0);
    double law_4 = Piecewise.choose(eps, 0.0, law_3, Piecewise.choose(0.0, law_1, 0.5 * (law_1
        + law_2), eps / (law_2 - law_1) * (0.5 * eps)));
    double law_5 = stiffness * law_4;
    double law_6 = c[1] * v;
    double law_7 = c[5] * v;
    double law_8 = law_4 / law_2 * law_6 + law_5 * law_7 + law_5;
    double law_9 = 0.5 * law_5;
    double law_10 = Math.max(-1.0, Math.min(1.0, law_8 / (1e-300 + law_9)));
    double law_11 = 1.0 + law_10;
    double law_12 = law_11 * law_11 * law_11;
    double law_13 = (63.0 + law_10 * (law_10 * (102.0 + law_10 * (7.0 * law_10 - 42.0))
        - 122.0)) * (law_12 * law_12) * 0.001953125 * law_9 + Math.max(0.0, law_8 - law_9);
    double law_14 = stiffness * law_3;
    double law_15 = Piecewise.choose(eps, 0.0, Piecewise.choose(law_1, 0.0, Piecewise.choose(0.0,
        law_1, Math.max(0.0, 0.5 * law_6), 0.0), Math.max(0.0, law_6 + law_7 * law_14
        + law_14)), law_13);
    out[0] = -law_15;
  }

  @Override
  public void slopes(double[] x, double[] c, double[] out) {
    // The load by its formula.
    double stiffness = c[0];
    double damping = c[1];
    double eps = c[4];
    double chi = c[5];
    double v = x[1];
    double law_1 = x[0] - c[2];
    double law_2 = Math.sqrt(law_1 * law_1 + eps * eps);
    double law_3 = Piecewise.choose(0.0, law_1, law_1, 0.0);
    double law_4 = law_2 - law_1;
    double law_5 = eps / law_4;
    double law_6 = 0.5 * eps;
    double law_7 = Piecewise.choose(eps, 0.0, law_3, Piecewise.choose(0.0, law_1, 0.5 * (law_1
        + law_2), law_5 * law_6));
    double law_8 = stiffness * law_7;
    double law_9 = law_7 / law_2;
    double law_10 = damping * v;
    double law_11 = chi * v;
    double law_12 = law_9 * law_10 + law_8 * law_11 + law_8;
    double law_13 = 0.5 * law_8;
    double law_14 = 1e-300 + law_13;
    double law_15 = law_12 / law_14;
    double law_16 = Math.min(1.0, law_15);
    double law_17 = Math.max(-1.0, law_16);
    double law_18 = 1.0 + law_17;
    double law_19 = law_18 * law_18;
    double law_20 = law_18 * law_19;
    double law_21 = 7.0 * law_17 - 42.0;
    double law_22 = 102.0 + law_17 * law_21;
    double law_23 = law_17 * law_22 - 122.0;
    double law_24 = 63.0 + law_17 * law_23;
    double law_25 = law_20 * law_20;
    double law_26 = law_12 - law_13;
    double law_27 = stiffness * law_3;
    double law_28 = law_10 + law_11 * law_27 + law_27;
    double law_29 = 0.5 * (law_1 + law_1) / law_2;
    double law_30 = Piecewise.choose(0.0, law_1, 1.0, 0.0);
    double law_31 = Piecewise.choose(eps, 0.0, law_30, Piecewise.choose(0.0, law_1, 0.5 * (1.0
        + law_29), -(law_5 * (law_29 - 1.0) / law_4 * law_6)));
    double law_32 = stiffness * law_31;
    double law_33 = 0.5 * law_32;
    double law_34 = law_11 * law_32 + (law_31 - law_9 * law_29) / law_2 * law_10 + law_32;
    double law_35 = Piecewise.choose(law_16, -1.0, 0.0, Piecewise.choose(1.0, law_15, 0.0, (law_34
        - law_15 * law_33) / law_14));
    double law_36 = law_18 * law_35;
    double law_37 = law_20 * (law_19 * law_35 + law_18 * (law_36 + law_36));
    double law_38 = law_25 * (law_23 * law_35 + law_17 * (law_22 * law_35
        + law_17 * (law_21 * law_35 + 7.0 * law_35 * law_17))) + law_24 * (law_37 + law_37);
    double law_39 = stiffness * law_30;
    double law_40 = Piecewise.choose(eps, 0.0, Piecewise.choose(law_1, 0.0, 0.0,
        Piecewise.choose(law_28, 0.0, 0.0, law_39 + law_11 * law_39)), law_24 * law_25 * 0.001953125
        * law_33 + 0.001953125 * law_38 * law_13 + Piecewise.choose(law_26, 0.0, 0.0, law_34
        - law_33));
    double law_41 = chi * law_8 + damping * law_9;
    double law_42 = Piecewise.choose(law_16, -1.0, 0.0, Piecewise.choose(1.0, law_15, 0.0, law_41
        / law_14));
    double law_43 = law_18 * law_42;
    double law_44 = law_20 * (law_19 * law_42 + law_18 * (law_43 + law_43));
    double law_45 = law_25 * (law_23 * law_42 + law_17 * (law_22 * law_42
        + law_17 * (law_21 * law_42 + 7.0 * law_42 * law_17))) + law_24 * (law_44 + law_44);
    double law_46 = Piecewise.choose(law_1, 0.0, Piecewise.choose(0.0, law_1, Piecewise.choose(0.5
        * law_10, 0.0, 0.0, 0.5 * damping), 0.0), Piecewise.choose(law_28, 0.0, 0.0, damping
        + chi * law_27));
    out[0] = -law_40;
    out[1] = -Piecewise.choose(eps, 0.0, law_46, Piecewise.choose(law_26, 0.0, 0.0, law_41)
        + 0.001953125 * law_45 * law_13);
  }

  @Override
  public void results(double[] x, double[] c, double[] out) {
    // The load by its formula.
    double stiffness = c[0];
    double eps = c[4];
    double v = x[1];
    double law_1 = x[0] - c[2];
    double law_2 = eps * eps;
    double law_3 = Math.sqrt(law_1 * law_1 + law_2);
    double law_4 = Piecewise.choose(0.0, law_1, law_1, 0.0);
    double law_5 = Piecewise.choose(eps, 0.0, law_4, Piecewise.choose(0.0, law_1, 0.5 * (law_1
        + law_3), eps / (law_3 - law_1) * (0.5 * eps)));
    double law_6 = stiffness * law_5;
    double law_7 = c[1] * v;
    double law_8 = c[5] * v;
    double law_9 = law_5 / law_3 * law_7 + law_6 * law_8 + law_6;
    double law_10 = 0.5 * law_6;
    double law_11 = Math.max(-1.0, Math.min(1.0, law_9 / (1e-300 + law_10)));
    double law_12 = 1.0 + law_11;
    double law_13 = law_12 * law_12 * law_12;
    double law_14 = (63.0 + law_11 * (law_11 * (102.0 + law_11 * (7.0 * law_11 - 42.0))
        - 122.0)) * (law_13 * law_13) * 0.001953125 * law_10 + Math.max(0.0, law_9 - law_10);
    double law_15 = stiffness * law_4;
    double law_16 = Piecewise.choose(eps, 0.0, Piecewise.choose(law_1, 0.0, Piecewise.choose(0.0,
        law_1, Math.max(0.0, 0.5 * law_7), 0.0), Math.max(0.0, law_7 + law_8 * law_15
        + law_15)), law_14);
    double law_17 = law_5 * law_5 * 0.5;
    out[0] = stiffness * Piecewise.choose(eps, 0.0, law_17, law_17
        + (StrictMath.log(2.0 / eps * law_5) - 0.5) * (0.25 * law_2));
    out[1] = -(v * (law_16 - law_6));
  }
}
