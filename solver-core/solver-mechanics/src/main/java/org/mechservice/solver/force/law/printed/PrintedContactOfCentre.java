package org.mechservice.solver.force.law.printed;

import org.mechservice.solver.force.law.PrintedLaw;
import org.mechservice.solver.spatial.Piecewise;
import org.mechservice.solver.spatial.Powers;

/**
 * Printed from its formula; do not edit. PrintedLawsTest compares it with the formula and
 * prints it anew with -Dgolden.write=true.
 */
final class PrintedContactOfCentre implements PrintedLaw {

  @Override
  public void load(double[] x, double[] c, double[] out) {
    // The load by its formula.
    double slope = c[10];
    double bend = c[11];
    double s = c[8];
    double r_x = x[0];
    double height = c[9];
    double r_z = x[2];
    double radius = c[0];
    double friction = c[6];
    double u_x = x[15];
    double u_z = x[17];
    double law_1 = height - r_z;
    double law_2 = s - r_x + slope * law_1;
    double law_3 = 1.0 + slope * slope;
    double law_4 = law_3 + bend * law_1;
    double law_5 = 1e-6 * law_3;
    double law_6 = (law_2 - Piecewise.held(law_2)) / Piecewise.pick(law_4, law_5, law_5, law_4);
    double law_7 = slope - bend * law_6;
    double law_8 = Math.sqrt(1.0 + law_7 * law_7);
    double law_9 = 1.0 / law_8;
    double law_10 = (r_z - (height - slope * law_6) - law_7 * (r_x - (s - law_6))) / law_8;
    double law_11 = law_7 / law_8;
    double law_12 = u_x * law_11 - u_z * law_9;
    double law_13 = c[2] * law_12;
    double law_14 = c[1] * Piecewise.choose(-law_10, 0.0, 0.0, Powers.power(-law_10, c[4]));
    double law_15 = Piecewise.choose(-law_10, 0.0, Piecewise.choose(0.0,
        -law_10, Math.max(0.0, 0.5 * law_13), 0.0), Math.max(0.0, law_13 + c[3] * law_12 * law_14
        + law_14));
    double law_16 = friction * law_15;
    double law_17 = x[16] + radius * (x[12] * law_9 + x[14] * law_11);
    double law_18 = u_x * law_9 + u_z * law_11 - x[13] * radius;
    double law_19 = Math.sqrt(law_18 * law_18 + law_17 * law_17 + c[13]);
    double law_20 = Piecewise.choose(friction, 0.0, 0.0, -(law_17 / law_19 * law_16));
    double law_21 = radius * law_20;
    double law_22 = Piecewise.choose(friction, 0.0, 0.0, -(law_18 / law_19 * law_16));
    out[0] = law_9 * law_21;
    out[1] = -(radius * law_22);
    out[2] = law_11 * law_21;
    out[3] = law_9 * law_22 - law_11 * law_15;
    out[4] = law_20;
    out[5] = law_11 * law_22 + law_9 * law_15;
    out[6] = 1.0;
  }

  @Override
  public void slopes(double[] x, double[] c, double[] out) {
    // Derivatives by motion 4.
    double slope = c[10];
    double bend = c[11];
    double s = c[8];
    double r_x = x[0];
    double height = c[9];
    double r_z = x[2];
    double radius = c[0];
    double friction = c[6];
    double omega_x = x[12];
    double omega_z = x[14];
    double u_x = x[15];
    double u_z = x[17];
    double damping = c[2];
    double stiffness = c[1];
    double exponent = c[4];
    double chi = c[3];
    double by4_1 = height - r_z;
    double by4_2 = s - r_x + slope * by4_1;
    double by4_3 = 1.0 + slope * slope;
    double by4_4 = by4_3 + bend * by4_1;
    double by4_5 = 1e-6 * by4_3;
    double by4_6 = Piecewise.pick(by4_4, by4_5, by4_5, by4_4);
    double by4_7 = (by4_2 - Piecewise.held(by4_2)) / by4_6;
    double by4_8 = slope - bend * by4_7;
    double by4_9 = Math.sqrt(1.0 + by4_8 * by4_8);
    double by4_10 = 1.0 / by4_9;
    double by4_11 = by4_8 / by4_9;
    double by4_12 = x[16] + radius * (omega_x * by4_10 + omega_z * by4_11);
    double by4_13 = u_x * by4_10 + u_z * by4_11 - x[13] * radius;
    double by4_14 = Math.sqrt(by4_13 * by4_13 + by4_12 * by4_12 + c[13]);
    double by4_15 = by4_12 / by4_14;
    double by4_16 = r_x - (s - by4_7);
    double by4_17 = (r_z - (height - slope * by4_7) - by4_8 * by4_16) / by4_9;
    double by4_18 = u_x * by4_11 - u_z * by4_10;
    double by4_19 = damping * by4_18;
    double by4_20 = 0.5 * by4_19;
    double by4_21 = 1.0 / by4_6;
    double by4_22 = bend * by4_21;
    double by4_23 = by4_8 * by4_22;
    double by4_24 = 0.5 * (by4_23 + by4_23) / by4_9;
    double by4_25 = by4_10 * by4_24 / by4_9;
    double by4_26 = (by4_22 - by4_11 * by4_24) / by4_9;
    double by4_27 = u_z * by4_25 + u_x * by4_26;
    double by4_28 = damping * by4_27;
    double by4_29 = stiffness * Piecewise.choose(-by4_17, 0.0, 0.0, Powers.power(-by4_17,
        exponent));
    double by4_30 = chi * by4_18;
    double by4_31 = by4_19 + by4_29 * by4_30 + by4_29;
    double by4_32 = Piecewise.product(exponent, Powers.power(-by4_17, c[14]));
    double by4_33 = stiffness * Piecewise.choose(-by4_17, 0.0, 0.0, (by4_16 * by4_22 + by4_8 * (1.0
        - by4_21) + slope * by4_21 + by4_17 * by4_24) / by4_9 * by4_32);
    double by4_34 = Piecewise.choose(-by4_17, 0.0, Piecewise.choose(0.0,
        -by4_17, Piecewise.choose(by4_20, 0.0, 0.0, 0.5 * by4_28), 0.0), Piecewise.choose(by4_31,
        0.0, 0.0, by4_30 * by4_33 + chi * by4_27 * by4_29 + by4_28 + by4_33));
    double by4_35 = friction * by4_34;
    double by4_36 = Piecewise.choose(-by4_17, 0.0, Piecewise.choose(0.0,
        -by4_17, Math.max(0.0, by4_20), 0.0), Math.max(0.0, by4_31));
    double by4_37 = friction * by4_36;
    double by4_38 = radius * (omega_z * by4_26 - omega_x * by4_25);
    double by4_39 = by4_12 * by4_38;
    double by4_40 = u_z * by4_26 - u_x * by4_25;
    double by4_41 = by4_13 * by4_40;
    double by4_42 = 0.5 * (by4_39 + by4_39 + (by4_41 + by4_41)) / by4_14;
    double by4_43 = Piecewise.choose(friction, 0.0, 0.0, -(by4_15 * by4_35 + (by4_38
        - by4_15 * by4_42) / by4_14 * by4_37));
    double by4_44 = radius * by4_43;
    double by4_45 = radius * Piecewise.choose(friction, 0.0, 0.0, -(by4_37 * by4_15));
    double by4_46 = by4_13 / by4_14;
    double by4_47 = Piecewise.choose(friction, 0.0, 0.0, -(by4_46 * by4_35 + (by4_40
        - by4_46 * by4_42) / by4_14 * by4_37));
    double by4_48 = Piecewise.choose(friction, 0.0, 0.0, -(by4_37 * by4_46));
    out[3] = by4_10 * by4_44 - by4_45 * by4_25;
    out[9] = -(radius * by4_47);
    out[15] = by4_45 * by4_26 + by4_11 * by4_44;
    out[21] = by4_10 * by4_47 - by4_48 * by4_25 - (by4_36 * by4_26 + by4_11 * by4_34);
    out[27] = by4_43;
    out[33] = by4_10 * by4_34 - by4_36 * by4_25 + (by4_48 * by4_26 + by4_11 * by4_47);

    // Derivatives by motion 6.
    double by6_1 = slope / by4_6;
    double by6_2 = bend * by6_1;
    double by6_3 = by4_8 * by6_2;
    double by6_4 = 0.5 * (by6_3 + by6_3) / by4_9;
    double by6_5 = by4_10 * by6_4 / by4_9;
    double by6_6 = (by6_2 - by4_11 * by6_4) / by4_9;
    double by6_7 = u_z * by6_5 + u_x * by6_6;
    double by6_8 = damping * by6_7;
    double by6_9 = stiffness * Piecewise.choose(-by4_17, 0.0, 0.0, -((1.0 - slope * by6_1
        - (by4_16 * by6_2 - by4_8 * by6_1) - by4_17 * by6_4) / by4_9 * by4_32));
    double by6_10 = Piecewise.choose(-by4_17, 0.0, Piecewise.choose(0.0,
        -by4_17, Piecewise.choose(by4_20, 0.0, 0.0, 0.5 * by6_8), 0.0), Piecewise.choose(by4_31,
        0.0, 0.0, by4_30 * by6_9 + chi * by6_7 * by4_29 + by6_8 + by6_9));
    double by6_11 = friction * by6_10;
    double by6_12 = radius * (omega_z * by6_6 - omega_x * by6_5);
    double by6_13 = by4_12 * by6_12;
    double by6_14 = u_z * by6_6 - u_x * by6_5;
    double by6_15 = by4_13 * by6_14;
    double by6_16 = 0.5 * (by6_13 + by6_13 + (by6_15 + by6_15)) / by4_14;
    double by6_17 = Piecewise.choose(friction, 0.0, 0.0, -(by4_15 * by6_11 + (by6_12
        - by4_15 * by6_16) / by4_14 * by4_37));
    double by6_18 = radius * by6_17;
    double by6_19 = Piecewise.choose(friction, 0.0, 0.0, -(by4_46 * by6_11 + (by6_14
        - by4_46 * by6_16) / by4_14 * by4_37));
    out[5] = by4_10 * by6_18 - by4_45 * by6_5;
    out[11] = -(radius * by6_19);
    out[17] = by4_45 * by6_6 + by4_11 * by6_18;
    out[23] = by4_10 * by6_19 - by4_48 * by6_5 - (by4_36 * by6_6 + by4_11 * by6_10);
    out[29] = by6_17;
    out[35] = by4_10 * by6_10 - by4_36 * by6_5 + (by4_48 * by6_6 + by4_11 * by6_19);

    // Derivatives by motion 7.
    double by7_1 = radius * by4_10;
    double by7_2 = by4_12 * by7_1;
    double by7_3 = 0.5 * (by7_2 + by7_2) / by4_14;
    double by7_4 = Piecewise.choose(friction, 0.0, 0.0, -((by7_1
        - by4_15 * by7_3) / by4_14 * by4_37));
    double by7_5 = radius * by7_4;
    double by7_6 = Piecewise.choose(friction, 0.0, 0.0, by4_46 * by7_3 / by4_14 * by4_37);
    out[36] = by4_10 * by7_5;
    out[42] = -(radius * by7_6);
    out[48] = by4_11 * by7_5;
    out[54] = by4_10 * by7_6;
    out[60] = by7_4;
    out[66] = by4_11 * by7_6;

    // Derivatives by motion 8.
    double by8_1 = radius * by4_13;
    double by8_2 = 0.5 * (by8_1 + by8_1) / by4_14;
    double by8_3 = Piecewise.choose(friction, 0.0, 0.0, -(by4_15 * by8_2 / by4_14 * by4_37));
    double by8_4 = radius * by8_3;
    double by8_5 = Piecewise.choose(friction, 0.0, 0.0, -((by4_46 * by8_2
        - radius) / by4_14 * by4_37));
    out[37] = by4_10 * by8_4;
    out[43] = -(radius * by8_5);
    out[49] = by4_11 * by8_4;
    out[55] = by4_10 * by8_5;
    out[61] = by8_3;
    out[67] = by4_11 * by8_5;

    // Derivatives by motion 9.
    double by9_1 = radius * by4_11;
    double by9_2 = by4_12 * by9_1;
    double by9_3 = 0.5 * (by9_2 + by9_2) / by4_14;
    double by9_4 = Piecewise.choose(friction, 0.0, 0.0, -((by9_1
        - by4_15 * by9_3) / by4_14 * by4_37));
    double by9_5 = radius * by9_4;
    double by9_6 = Piecewise.choose(friction, 0.0, 0.0, by4_46 * by9_3 / by4_14 * by4_37);
    out[38] = by4_10 * by9_5;
    out[44] = -(radius * by9_6);
    out[50] = by4_11 * by9_5;
    out[56] = by4_10 * by9_6;
    out[62] = by9_4;
    out[68] = by4_11 * by9_6;

    // Derivatives by motion 10.
    double by10_1 = damping * by4_11;
    double by10_2 = Piecewise.choose(-by4_17, 0.0, Piecewise.choose(0.0,
        -by4_17, Piecewise.choose(by4_20, 0.0, 0.0, 0.5 * by10_1), 0.0), Piecewise.choose(by4_31,
        0.0, 0.0, chi * by4_11 * by4_29 + by10_1));
    double by10_3 = friction * by10_2;
    double by10_4 = by4_10 * by4_13;
    double by10_5 = 0.5 * (by10_4 + by10_4) / by4_14;
    double by10_6 = Piecewise.choose(friction, 0.0, 0.0, by4_15 * by10_5 / by4_14 * by4_37
        - by4_15 * by10_3);
    double by10_7 = radius * by10_6;
    double by10_8 = Piecewise.choose(friction, 0.0, 0.0, -(by4_46 * by10_3 + (by4_10
        - by4_46 * by10_5) / by4_14 * by4_37));
    out[39] = by4_10 * by10_7;
    out[45] = -(radius * by10_8);
    out[51] = by4_11 * by10_7;
    out[57] = by4_10 * by10_8 - by4_11 * by10_2;
    out[63] = by10_6;
    out[69] = by4_10 * by10_2 + by4_11 * by10_8;

    // Derivatives by motion 11.
    double by11_1 = 0.5 * (by4_12 + by4_12) / by4_14;
    double by11_2 = Piecewise.choose(friction, 0.0, 0.0, -((1.0
        - by4_15 * by11_1) / by4_14 * by4_37));
    double by11_3 = radius * by11_2;
    double by11_4 = Piecewise.choose(friction, 0.0, 0.0, by4_46 * by11_1 / by4_14 * by4_37);
    out[40] = by4_10 * by11_3;
    out[46] = -(radius * by11_4);
    out[52] = by4_11 * by11_3;
    out[58] = by4_10 * by11_4;
    out[64] = by11_2;
    out[70] = by4_11 * by11_4;

    // Derivatives by motion 12.
    double by12_1 = damping * by4_10;
    double by12_2 = Piecewise.choose(-by4_17, 0.0, Piecewise.choose(0.0,
        -by4_17, Piecewise.choose(by4_20, 0.0, 0.0, -(0.5 * by12_1)), 0.0), Piecewise.choose(by4_31,
        0.0, 0.0, -(chi * by4_10 * by4_29 + by12_1)));
    double by12_3 = friction * by12_2;
    double by12_4 = by4_11 * by4_13;
    double by12_5 = 0.5 * (by12_4 + by12_4) / by4_14;
    double by12_6 = Piecewise.choose(friction, 0.0, 0.0, by4_15 * by12_5 / by4_14 * by4_37
        - by4_15 * by12_3);
    double by12_7 = radius * by12_6;
    double by12_8 = Piecewise.choose(friction, 0.0, 0.0, -(by4_46 * by12_3 + (by4_11
        - by4_46 * by12_5) / by4_14 * by4_37));
    out[41] = by4_10 * by12_7;
    out[47] = -(radius * by12_8);
    out[53] = by4_11 * by12_7;
    out[59] = by4_10 * by12_8 - by4_11 * by12_2;
    out[65] = by12_6;
    out[71] = by4_10 * by12_2 + by4_11 * by12_8;
  }

  @Override
  public void results(double[] x, double[] c, double[] out) {
    // The load by its formula.
    double stiffness = c[1];
    double exponent = c[4];
    double r_z = x[2];
    double height = c[9];
    double slope = c[10];
    double s = c[8];
    double r_x = x[0];
    double bend = c[11];
    double u_x = x[15];
    double u_z = x[17];
    double radius = c[0];
    double friction = c[6];
    double law_1 = height - r_z;
    double law_2 = s - r_x + slope * law_1;
    double law_3 = 1.0 + slope * slope;
    double law_4 = law_3 + bend * law_1;
    double law_5 = 1e-6 * law_3;
    double law_6 = (law_2 - Piecewise.held(law_2)) / Piecewise.pick(law_4, law_5, law_5, law_4);
    double law_7 = slope - bend * law_6;
    double law_8 = Math.sqrt(1.0 + law_7 * law_7);
    double law_9 = (r_z - (height - slope * law_6) - law_7 * (r_x - (s - law_6))) / law_8;
    double law_10 = Piecewise.choose(0.0, -law_9, -law_9, 0.0);
    double law_11 = law_10 * law_10;
    double law_12 = 1.0 / law_8;
    double law_13 = law_7 / law_8;
    double law_14 = u_x * law_12 + u_z * law_13 - x[13] * radius;
    double law_15 = u_x * law_13 - u_z * law_12;
    double law_16 = c[2] * law_15;
    double law_17 = stiffness * Piecewise.choose(-law_9, 0.0, 0.0, Powers.power(-law_9, exponent));
    double law_18 = Piecewise.choose(-law_9, 0.0, Piecewise.choose(0.0,
        -law_9, Math.max(0.0, 0.5 * law_16), 0.0), Math.max(0.0, law_16 + c[3] * law_15 * law_17
        + law_17));
    double law_19 = friction * law_18;
    double law_20 = x[16] + radius * (x[12] * law_12 + x[14] * law_13);
    double law_21 = Math.sqrt(law_14 * law_14 + law_20 * law_20 + c[13]);
    double law_22 = Piecewise.choose(friction, 0.0, 0.0, -(law_14 / law_21 * law_19));
    double law_23 = Piecewise.choose(friction, 0.0, 0.0, -(law_20 / law_21 * law_19));
    out[0] = stiffness * Piecewise.choose(exponent, 1.0, 0.5 * law_11, law_11 * Powers.power(law_10,
        c[14]) * c[15]);
    out[1] = law_14 * law_22 + law_20 * law_23 - law_15 * (law_18 - law_17);
    out[2] = -law_9;
    out[3] = law_18;
    out[4] = law_22;
    out[5] = law_23;
  }

  @Override
  public void settle(double[] c, double[] out) {
    // What depends on coefficients alone.
    double c_7 = c[7];
    double c_4 = c[4];
    out[13] = c_7 * c_7;
    out[14] = c_4 - 1.0;
    out[15] = 1.0 / (1.0 + c_4);
  }

  @Override
  public int size() {
    return 16;
  }
}
