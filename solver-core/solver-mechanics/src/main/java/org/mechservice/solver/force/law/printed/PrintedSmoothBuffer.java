package org.mechservice.solver.force.law.printed;

import org.mechservice.solver.force.law.PrintedLaw;
import org.mechservice.solver.spatial.Piecewise;

/**
 * Printed from its formula; do not edit. PrintedLawsTest compares it with the formula and
 * prints it anew with -Dgolden.write=true.
 */
final class PrintedSmoothBuffer implements PrintedLaw {

  @Override
  public void load(double[] x, double[] c, double[] out) {
    // The load by its formula.
    double r_x = x[0];
    double r_y = x[1];
    double r_z = x[2];
    double u_x = x[15];
    double u_y = x[16];
    double u_z = x[17];
    double law_1 = Math.sqrt(r_x * r_x + r_y * r_y + r_z * r_z);
    double law_2 = law_1 - c[2];
    double law_3 = Math.sqrt(c[8] + law_2 * law_2);
    double law_4 = Math.abs(-law_2);
    double law_5 = c[7] / (law_3 + law_4) + 0.5 * (law_4 - law_2);
    double law_6 = c[0] * law_5;
    double law_7 = 0.5 * law_6;
    double law_8 = Piecewise.choose(law_1, 0.0, Math.sqrt(u_x * u_x + u_y * u_y
        + u_z * u_z), (r_x * u_x + r_y * u_y + r_z * u_z) / law_1);
    double law_9 = law_6 - (law_5 / law_3 * (c[1] * law_8) + c[5] * law_8 * law_6);
    double law_10 = Math.max(-1.0, Math.min(1.0, law_9 / (1e-300 + law_7)));
    double law_11 = 1.0 + law_10;
    double law_12 = law_11 * law_11 * law_11;
    double law_13 = (63.0 + law_10 * (law_10 * (102.0 + law_10 * (7.0 * law_10 - 42.0))
        - 122.0)) * (law_12 * law_12) * 0.001953125 * law_7 + Math.max(0.0, law_9 - law_7);
    double law_14 = Piecewise.choose(law_1, 0.0, c[6], law_13 / law_1);
    double law_15 = Piecewise.choose(law_1, 0.0, c[9], 0.0);
    out[0] = 0.0;
    out[1] = 0.0;
    out[2] = 0.0;
    out[3] = r_x * law_14 + u_x * law_15;
    out[4] = r_y * law_14 + u_y * law_15;
    out[5] = r_z * law_14 + u_z * law_15;
    out[6] = Piecewise.choose(1.0, c[10], 1.0, law_1);
  }

  @Override
  public void slopes(double[] x, double[] c, double[] out) {
    // Derivatives by motion 4.
    double r_x = x[0];
    double r_y = x[1];
    double r_z = x[2];
    double stiffness = c[0];
    double damping = c[1];
    double u_x = x[15];
    double u_y = x[16];
    double u_z = x[17];
    double chi = c[5];
    double by4_1 = Math.sqrt(r_x * r_x + r_y * r_y + r_z * r_z);
    double by4_2 = by4_1 - c[2];
    double by4_3 = Math.sqrt(c[8] + by4_2 * by4_2);
    double by4_4 = Math.abs(-by4_2);
    double by4_5 = by4_3 + by4_4;
    double by4_6 = c[7] / by4_5;
    double by4_7 = by4_6 + 0.5 * (by4_4 - by4_2);
    double by4_8 = stiffness * by4_7;
    double by4_9 = 0.5 * by4_8;
    double by4_10 = by4_7 / by4_3;
    double by4_11 = Math.sqrt(u_x * u_x + u_y * u_y + u_z * u_z);
    double by4_12 = (r_x * u_x + r_y * u_y + r_z * u_z) / by4_1;
    double by4_13 = Piecewise.choose(by4_1, 0.0, by4_11, by4_12);
    double by4_14 = damping * by4_13;
    double by4_15 = chi * by4_13;
    double by4_16 = by4_8 - (by4_10 * by4_14 + by4_8 * by4_15);
    double by4_17 = 1e-300 + by4_9;
    double by4_18 = by4_16 / by4_17;
    double by4_19 = Math.min(1.0, by4_18);
    double by4_20 = Math.max(-1.0, by4_19);
    double by4_21 = 7.0 * by4_20 - 42.0;
    double by4_22 = 102.0 + by4_20 * by4_21;
    double by4_23 = by4_20 * by4_22 - 122.0;
    double by4_24 = 63.0 + by4_20 * by4_23;
    double by4_25 = 1.0 + by4_20;
    double by4_26 = by4_25 * by4_25;
    double by4_27 = by4_25 * by4_26;
    double by4_28 = by4_27 * by4_27;
    double by4_29 = by4_24 * by4_28 * 0.001953125;
    double by4_30 = by4_16 - by4_9;
    double by4_31 = (by4_9 * by4_29 + Math.max(0.0, by4_30)) / by4_1;
    double by4_32 = Piecewise.choose(by4_1, 0.0, c[6], by4_31);
    double by4_33 = 0.5 * (r_x + r_x) / by4_1;
    double by4_34 = Math.signum(-by4_2);
    double by4_35 = by4_33 * by4_34;
    double by4_36 = by4_2 * by4_33;
    double by4_37 = 0.5 * (by4_36 + by4_36) / by4_3;
    double by4_38 = 0.5 * (by4_33 + by4_35) + by4_6 * (by4_37 - by4_35) / by4_5;
    double by4_39 = stiffness * by4_38;
    double by4_40 = 0.5 * by4_39;
    double by4_41 = Piecewise.choose(by4_1, 0.0, 0.0, (u_x - by4_12 * by4_33) / by4_1);
    double by4_42 = chi * by4_41 * by4_8 - by4_15 * by4_39 + (damping * by4_41 * by4_10 - (by4_38
        + by4_10 * by4_37) / by4_3 * by4_14) + by4_39;
    double by4_43 = Piecewise.choose(by4_19, -1.0, 0.0, Piecewise.choose(1.0, by4_18, 0.0, (by4_18
        * by4_40 - by4_42) / by4_17));
    double by4_44 = by4_25 * by4_43;
    double by4_45 = by4_27 * (by4_26 * by4_43 + by4_25 * (by4_44 + by4_44));
    double by4_46 = by4_28 * (by4_23 * by4_43 + by4_20 * (by4_22 * by4_43
        + by4_20 * (by4_21 * by4_43 + 7.0 * by4_43 * by4_20))) + by4_24 * (by4_45 + by4_45);
    double by4_47 = Piecewise.choose(by4_1, 0.0, 0.0, (0.001953125 * by4_46 * by4_9
        - by4_29 * by4_40 + Piecewise.choose(by4_30, 0.0, 0.0, by4_40 - by4_42)
        - by4_31 * by4_33) / by4_1);
    out[21] = by4_32 + r_x * by4_47;
    out[27] = r_y * by4_47;
    out[33] = r_z * by4_47;

    // Derivatives by motion 5.
    double by5_1 = 0.5 * (r_y + r_y) / by4_1;
    double by5_2 = by4_34 * by5_1;
    double by5_3 = by4_2 * by5_1;
    double by5_4 = 0.5 * (by5_3 + by5_3) / by4_3;
    double by5_5 = 0.5 * (by5_1 + by5_2) + by4_6 * (by5_4 - by5_2) / by4_5;
    double by5_6 = stiffness * by5_5;
    double by5_7 = 0.5 * by5_6;
    double by5_8 = Piecewise.choose(by4_1, 0.0, 0.0, (u_y - by4_12 * by5_1) / by4_1);
    double by5_9 = chi * by5_8 * by4_8 - by4_15 * by5_6 + (damping * by5_8 * by4_10 - (by5_5
        + by4_10 * by5_4) / by4_3 * by4_14) + by5_6;
    double by5_10 = Piecewise.choose(by4_19, -1.0, 0.0, Piecewise.choose(1.0, by4_18, 0.0, (by4_18
        * by5_7 - by5_9) / by4_17));
    double by5_11 = by4_25 * by5_10;
    double by5_12 = by4_27 * (by4_26 * by5_10 + by4_25 * (by5_11 + by5_11));
    double by5_13 = by4_28 * (by4_23 * by5_10 + by4_20 * (by4_22 * by5_10
        + by4_20 * (by4_21 * by5_10 + 7.0 * by5_10 * by4_20))) + by4_24 * (by5_12 + by5_12);
    double by5_14 = Piecewise.choose(by4_1, 0.0, 0.0, (0.001953125 * by5_13 * by4_9 - by4_29 * by5_7
        + Piecewise.choose(by4_30, 0.0, 0.0, by5_7 - by5_9) - by4_31 * by5_1) / by4_1);
    out[22] = r_x * by5_14;
    out[28] = by4_32 + r_y * by5_14;
    out[34] = r_z * by5_14;

    // Derivatives by motion 6.
    double by6_1 = 0.5 * (r_z + r_z) / by4_1;
    double by6_2 = by4_34 * by6_1;
    double by6_3 = by4_2 * by6_1;
    double by6_4 = 0.5 * (by6_3 + by6_3) / by4_3;
    double by6_5 = 0.5 * (by6_1 + by6_2) + by4_6 * (by6_4 - by6_2) / by4_5;
    double by6_6 = stiffness * by6_5;
    double by6_7 = 0.5 * by6_6;
    double by6_8 = Piecewise.choose(by4_1, 0.0, 0.0, (u_z - by4_12 * by6_1) / by4_1);
    double by6_9 = chi * by6_8 * by4_8 - by4_15 * by6_6 + (damping * by6_8 * by4_10 - (by6_5
        + by4_10 * by6_4) / by4_3 * by4_14) + by6_6;
    double by6_10 = Piecewise.choose(by4_19, -1.0, 0.0, Piecewise.choose(1.0, by4_18, 0.0, (by4_18
        * by6_7 - by6_9) / by4_17));
    double by6_11 = by4_25 * by6_10;
    double by6_12 = by4_27 * (by4_26 * by6_10 + by4_25 * (by6_11 + by6_11));
    double by6_13 = by4_28 * (by4_23 * by6_10 + by4_20 * (by4_22 * by6_10
        + by4_20 * (by4_21 * by6_10 + 7.0 * by6_10 * by4_20))) + by4_24 * (by6_12 + by6_12);
    double by6_14 = Piecewise.choose(by4_1, 0.0, 0.0, (0.001953125 * by6_13 * by4_9 - by4_29 * by6_7
        + Piecewise.choose(by4_30, 0.0, 0.0, by6_7 - by6_9) - by4_31 * by6_1) / by4_1);
    out[23] = r_x * by6_14;
    out[29] = r_y * by6_14;
    out[35] = by4_32 + r_z * by6_14;

    // Derivatives by motion 10.
    double by10_1 = Piecewise.choose(by4_1, 0.0, c[9], 0.0);
    double by10_2 = Piecewise.choose(by4_1, 0.0, 0.5 * (u_x + u_x) / by4_11, r_x / by4_1);
    double by10_3 = chi * by10_2 * by4_8 + damping * by10_2 * by4_10;
    double by10_4 = Piecewise.choose(by4_19, -1.0, 0.0, Piecewise.choose(1.0, by4_18, 0.0,
        -(by10_3 / by4_17)));
    double by10_5 = by4_25 * by10_4;
    double by10_6 = by4_27 * (by4_26 * by10_4 + by4_25 * (by10_5 + by10_5));
    double by10_7 = by4_28 * (by4_23 * by10_4 + by4_20 * (by4_22 * by10_4
        + by4_20 * (by4_21 * by10_4 + 7.0 * by10_4 * by4_20))) + by4_24 * (by10_6 + by10_6);
    double by10_8 = Piecewise.choose(by4_1, 0.0, 0.0, (Piecewise.choose(by4_30, 0.0, 0.0, -by10_3)
        + 0.001953125 * by10_7 * by4_9) / by4_1);
    out[57] = by10_1 + r_x * by10_8;
    out[63] = r_y * by10_8;
    out[69] = r_z * by10_8;

    // Derivatives by motion 11.
    double by11_1 = Piecewise.choose(by4_1, 0.0, 0.5 * (u_y + u_y) / by4_11, r_y / by4_1);
    double by11_2 = chi * by11_1 * by4_8 + damping * by11_1 * by4_10;
    double by11_3 = Piecewise.choose(by4_19, -1.0, 0.0, Piecewise.choose(1.0, by4_18, 0.0,
        -(by11_2 / by4_17)));
    double by11_4 = by4_25 * by11_3;
    double by11_5 = by4_27 * (by4_26 * by11_3 + by4_25 * (by11_4 + by11_4));
    double by11_6 = by4_28 * (by4_23 * by11_3 + by4_20 * (by4_22 * by11_3
        + by4_20 * (by4_21 * by11_3 + 7.0 * by11_3 * by4_20))) + by4_24 * (by11_5 + by11_5);
    double by11_7 = Piecewise.choose(by4_1, 0.0, 0.0, (Piecewise.choose(by4_30, 0.0, 0.0, -by11_2)
        + 0.001953125 * by11_6 * by4_9) / by4_1);
    out[58] = r_x * by11_7;
    out[64] = by10_1 + r_y * by11_7;
    out[70] = r_z * by11_7;

    // Derivatives by motion 12.
    double by12_1 = Piecewise.choose(by4_1, 0.0, 0.5 * (u_z + u_z) / by4_11, r_z / by4_1);
    double by12_2 = chi * by12_1 * by4_8 + damping * by12_1 * by4_10;
    double by12_3 = Piecewise.choose(by4_19, -1.0, 0.0, Piecewise.choose(1.0, by4_18, 0.0,
        -(by12_2 / by4_17)));
    double by12_4 = by4_25 * by12_3;
    double by12_5 = by4_27 * (by4_26 * by12_3 + by4_25 * (by12_4 + by12_4));
    double by12_6 = by4_28 * (by4_23 * by12_3 + by4_20 * (by4_22 * by12_3
        + by4_20 * (by4_21 * by12_3 + 7.0 * by12_3 * by4_20))) + by4_24 * (by12_5 + by12_5);
    double by12_7 = Piecewise.choose(by4_1, 0.0, 0.0, (Piecewise.choose(by4_30, 0.0, 0.0, -by12_2)
        + 0.001953125 * by12_6 * by4_9) / by4_1);
    out[59] = r_x * by12_7;
    out[65] = r_y * by12_7;
    out[71] = by10_1 + r_z * by12_7;
  }

  @Override
  public void results(double[] x, double[] c, double[] out) {
    // The load by its formula.
    double stiffness = c[0];
    double r_x = x[0];
    double r_y = x[1];
    double r_z = x[2];
    double u_x = x[15];
    double u_y = x[16];
    double u_z = x[17];
    double law_1 = Math.sqrt(r_x * r_x + r_y * r_y + r_z * r_z);
    double law_2 = law_1 - c[2];
    double law_3 = Math.sqrt(c[8] + law_2 * law_2);
    double law_4 = Math.abs(-law_2);
    double law_5 = c[7] / (law_3 + law_4) + 0.5 * (law_4 - law_2);
    double law_6 = Piecewise.choose(law_1, 0.0, Math.sqrt(u_x * u_x + u_y * u_y
        + u_z * u_z), (r_x * u_x + r_y * u_y + r_z * u_z) / law_1);
    double law_7 = stiffness * law_5;
    double law_8 = 0.5 * law_7;
    double law_9 = law_7 - (law_5 / law_3 * (c[1] * law_6) + c[5] * law_6 * law_7);
    double law_10 = Math.max(-1.0, Math.min(1.0, law_9 / (1e-300 + law_8)));
    double law_11 = 1.0 + law_10;
    double law_12 = law_11 * law_11 * law_11;
    double law_13 = (63.0 + law_10 * (law_10 * (102.0 + law_10 * (7.0 * law_10 - 42.0))
        - 122.0)) * (law_12 * law_12) * 0.001953125 * law_8 + Math.max(0.0, law_9 - law_8);
    out[0] = stiffness * (law_5 * law_5 * 0.5 + (StrictMath.log(law_5 * c[11]) - 0.5) * c[12]);
    out[1] = law_6 * (law_13 - law_7);
    out[2] = law_1;
    out[3] = law_6;
    out[4] = -law_13;
  }

  @Override
  public void settle(double[] c, double[] out) {
    // What depends on coefficients alone.
    double c_0 = c[0];
    double c_4 = c[4];
    double c_2 = c[2];
    double c_6 = c_4 * c_4;
    double c_7 = 0.5 * c_6;
    double c_8 = 1e-300 - c_2;
    double c_9 = Math.sqrt(c_6 + c_8 * c_8);
    double c_10 = Math.abs(-c_8);
    double c_11 = c_9 + c_10;
    double c_12 = c_7 / c_11;
    double c_13 = c_0 * (c_12 + 0.5 * (c_10 - c_8));
    double c_14 = 0.5 * c_13;
    double c_15 = Math.signum(-c_8);
    double c_16 = c_0 * (0.5 * (1.0 + c_15) + c_12 * (0.5 * (c_8 + c_8) / c_9 - c_15) / c_11);
    double c_17 = 0.5 * c_16;
    double c_18 = 1e-300 + c_14;
    double c_19 = c_13 / c_18;
    double c_20 = Math.min(1.0, c_19);
    double c_21 = Math.max(-1.0, c_20);
    double c_22 = 1.0 + c_21;
    double c_23 = c_22 * c_22;
    double c_24 = c_22 * c_23;
    double c_25 = c_24 * c_24;
    double c_26 = 7.0 * c_21 - 42.0;
    double c_27 = 102.0 + c_21 * c_26;
    double c_28 = c_21 * c_27 - 122.0;
    double c_29 = Piecewise.choose(c_20, -1.0, 0.0, Piecewise.choose(1.0, c_19, 0.0, (c_17 * c_19
        - c_16) / c_18));
    double c_30 = 63.0 + c_21 * c_28;
    double c_31 = c_22 * c_29;
    double c_32 = c_24 * (c_23 * c_29 + c_22 * (c_31 + c_31));
    double c_33 = c_25 * (c_28 * c_29 + c_21 * (c_27 * c_29 + c_21 * (c_26 * c_29
        + 7.0 * c_29 * c_21))) + c_30 * (c_32 + c_32);
    double c_34 = Math.sqrt(c_2 * c_2 + c_6);
    double c_35 = Math.abs(c_2);
    double c_36 = c_7 / (c_34 + c_35) + 0.5 * (c_2 + c_35);
    double c_37 = c_0 * c_36;
    double c_38 = 0.5 * c_37;
    double c_39 = c_37 - (c_36 / c_34 * c[1] + c[5] * c_37);
    double c_40 = 1e-300 + c_38;
    double c_41 = Math.max(-1.0, Math.min(1.0, c_39 / c_40));
    double c_42 = 1.0 + c_41;
    double c_43 = c_42 * c_42 * c_42;
    double c_44 = (63.0 + c_41 * (c_41 * (102.0 + c_41 * (7.0 * c_41 - 42.0))
        - 122.0)) * (c_43 * c_43) * 0.001953125 * c_38 + Math.max(0.0, c_39 - c_38);
    double c_45 = Math.max(-1.0, Math.min(1.0, c_37 / c_40));
    double c_46 = 1.0 + c_45;
    double c_47 = c_46 * c_46 * c_46;
    double c_48 = (63.0 + c_45 * (c_45 * (102.0 + c_45 * (7.0 * c_45 - 42.0))
        - 122.0)) * (c_47 * c_47) * 0.001953125 * c_38 + Math.max(0.0, c_37 - c_38);
    out[6] = 0.001953125 * c_33 * c_14 - c_25 * c_30 * 0.001953125 * c_17 + Piecewise.choose(c_13
        - c_14, 0.0, 0.0, c_17 - c_16);
    out[7] = c_7;
    out[8] = c_6;
    out[9] = c_44 - c_37;
    out[10] = Piecewise.choose(Math.abs(-c_48), 1e-9 * (Math.abs(c_0) * (c_4 + c_35)
        + Math.abs(c[3])), 1.0, 0.0);
    out[11] = 2.0 / c_4;
    out[12] = 0.25 * c_6;
  }

  @Override
  public int size() {
    return 13;
  }
}
