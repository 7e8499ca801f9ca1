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
    double r_x = x[0];
    double r_z = x[2];
    double u_x = x[15];
    double u_z = x[17];
    double radius = c[0];
    double stiffness = c[1];
    double exponent = c[4];
    double eps = c[5];
    double friction = c[6];
    double frictionSpeed = c[7];
    double s = c[8];
    double height = c[9];
    double slope = c[10];
    double bend = c[11];
    double law_1 = height - r_z;
    double law_2 = s - r_x + slope * law_1;
    double law_3 = 1.0 + slope * slope;
    double law_4 = law_3 + bend * law_1;
    double law_5 = 1e-6 * law_3;
    double law_6 = (law_2 - Piecewise.held(law_2)) / Piecewise.pick(law_4, law_5, law_5, law_4);
    double law_7 = slope - bend * law_6;
    double law_8 = Math.sqrt(1.0 + law_7 * law_7);
    double law_9 = (r_z - (height - slope * law_6) - law_7 * (r_x - (s - law_6))) / law_8;
    double law_10 = 1.0 / law_8;
    double law_11 = law_7 / law_8;
    double law_12 = u_x * law_11 - u_z * law_10;
    double law_13 = Math.sqrt(law_9 * law_9 + eps * eps);
    double law_14 = Piecewise.choose(-law_9, 0.0, 0.0, Powers.power(-law_9, exponent));
    double law_15 = Piecewise.choose(eps, 0.0, Piecewise.choose(0.0, -law_9,
        -law_9, 0.0), Piecewise.choose(0.0, -law_9, 0.5 * (law_13 - law_9), eps / (law_9
        + law_13) * (0.5 * eps)));
    double law_16 = stiffness * Piecewise.choose(eps, 0.0, law_14, Powers.power(law_15, exponent));
    double law_17 = c[2] * law_12;
    double law_18 = c[3] * law_12;
    double law_19 = law_15 / law_13 * law_17 + law_16 * law_18 + law_16;
    double law_20 = 0.5 * law_16;
    double law_21 = Math.max(-1.0, Math.min(1.0, law_19 / (1e-300 + law_20)));
    double law_22 = 1.0 + law_21;
    double law_23 = law_22 * law_22 * law_22;
    double law_24 = (63.0 + law_21 * (law_21 * (102.0 + law_21 * (7.0 * law_21 - 42.0))
        - 122.0)) * (law_23 * law_23) * 0.001953125 * law_20 + Math.max(0.0, law_19 - law_20);
    double law_25 = stiffness * law_14;
    double law_26 = Piecewise.choose(eps, 0.0, Piecewise.choose(-law_9, 0.0, Piecewise.choose(0.0,
        -law_9, Math.max(0.0, 0.5 * law_17), 0.0), Math.max(0.0, law_17 + law_18 * law_25
        + law_25)), law_24);
    double law_27 = u_x * law_10 + u_z * law_11 - x[13] * radius;
    double law_28 = x[16] + radius * (x[12] * law_10 + x[14] * law_11);
    double law_29 = Math.sqrt(law_27 * law_27 + law_28 * law_28 + frictionSpeed * frictionSpeed);
    double law_30 = friction * law_26;
    double law_31 = Piecewise.choose(friction, 0.0, 0.0, -(law_27 / law_29 * law_30));
    double law_32 = Piecewise.choose(friction, 0.0, 0.0, -(law_28 / law_29 * law_30));
    double law_33 = radius * law_32;
    out[0] = law_10 * law_33;
    out[1] = -(radius * law_31);
    out[2] = law_11 * law_33;
    out[3] = law_10 * law_31 - law_11 * law_26;
    out[4] = law_32;
    out[5] = law_11 * law_31 + law_10 * law_26;
    out[6] = 1.0;
  }

  @Override
  public void slopes(double[] x, double[] c, double[] out) {
    // The load by its formula.
    double r_x = x[0];
    double r_z = x[2];
    double omega_x = x[12];
    double omega_z = x[14];
    double u_x = x[15];
    double u_z = x[17];
    double radius = c[0];
    double stiffness = c[1];
    double damping = c[2];
    double chi = c[3];
    double exponent = c[4];
    double eps = c[5];
    double friction = c[6];
    double frictionSpeed = c[7];
    double s = c[8];
    double height = c[9];
    double slope = c[10];
    double bend = c[11];
    double law_1 = height - r_z;
    double law_2 = s - r_x + slope * law_1;
    double law_3 = 1.0 + slope * slope;
    double law_4 = law_3 + bend * law_1;
    double law_5 = 1e-6 * law_3;
    double law_6 = Piecewise.pick(law_4, law_5, law_5, law_4);
    double law_7 = (law_2 - Piecewise.held(law_2)) / law_6;
    double law_8 = slope - bend * law_7;
    double law_9 = Math.sqrt(1.0 + law_8 * law_8);
    double law_10 = r_x - (s - law_7);
    double law_11 = (r_z - (height - slope * law_7) - law_8 * law_10) / law_9;
    double law_12 = 1.0 / law_9;
    double law_13 = law_8 / law_9;
    double law_14 = u_x * law_13 - u_z * law_12;
    double law_15 = Math.sqrt(law_11 * law_11 + eps * eps);
    double law_16 = Piecewise.choose(-law_11, 0.0, 0.0, Powers.power(-law_11, exponent));
    double law_17 = law_11 + law_15;
    double law_18 = eps / law_17;
    double law_19 = 0.5 * eps;
    double law_20 = Piecewise.choose(eps, 0.0, Piecewise.choose(0.0, -law_11,
        -law_11, 0.0), Piecewise.choose(0.0, -law_11, 0.5 * (law_15 - law_11), law_18 * law_19));
    double law_21 = stiffness * Piecewise.choose(eps, 0.0, law_16, Powers.power(law_20, exponent));
    double law_22 = law_20 / law_15;
    double law_23 = damping * law_14;
    double law_24 = chi * law_14;
    double law_25 = law_22 * law_23 + law_21 * law_24 + law_21;
    double law_26 = 0.5 * law_21;
    double law_27 = 1e-300 + law_26;
    double law_28 = law_25 / law_27;
    double law_29 = Math.min(1.0, law_28);
    double law_30 = Math.max(-1.0, law_29);
    double law_31 = 1.0 + law_30;
    double law_32 = law_31 * law_31;
    double law_33 = law_31 * law_32;
    double law_34 = 7.0 * law_30 - 42.0;
    double law_35 = 102.0 + law_30 * law_34;
    double law_36 = law_30 * law_35 - 122.0;
    double law_37 = 63.0 + law_30 * law_36;
    double law_38 = law_33 * law_33;
    double law_39 = law_37 * law_38 * 0.001953125;
    double law_40 = law_25 - law_26;
    double law_41 = stiffness * law_16;
    double law_42 = law_23 + law_24 * law_41 + law_41;
    double law_43 = 0.5 * law_23;
    double law_44 = Piecewise.choose(eps, 0.0, Piecewise.choose(-law_11, 0.0, Piecewise.choose(0.0,
        -law_11, Math.max(0.0, law_43), 0.0), Math.max(0.0, law_42)), law_26 * law_39
        + Math.max(0.0, law_40));
    double law_45 = u_x * law_12 + u_z * law_13 - x[13] * radius;
    double law_46 = x[16] + radius * (omega_x * law_12 + omega_z * law_13);
    double law_47 = Math.sqrt(law_45 * law_45 + law_46 * law_46 + frictionSpeed * frictionSpeed);
    double law_48 = friction * law_44;
    double law_49 = law_45 / law_47;
    double law_50 = Piecewise.choose(friction, 0.0, 0.0, -(law_48 * law_49));
    double law_51 = law_46 / law_47;
    double law_52 = radius * Piecewise.choose(friction, 0.0, 0.0, -(law_48 * law_51));

    // Derivatives by motion 4.
    double by4_1 = 1.0 / law_6;
    double by4_2 = bend * by4_1;
    double by4_3 = law_8 * by4_2;
    double by4_4 = 0.5 * (by4_3 + by4_3) / law_9;
    double by4_5 = (by4_2 - law_13 * by4_4) / law_9;
    double by4_6 = law_12 * by4_4 / law_9;
    double by4_7 = radius * (omega_z * by4_5 - omega_x * by4_6);
    double by4_8 = law_46 * by4_7;
    double by4_9 = u_z * by4_5 - u_x * by4_6;
    double by4_10 = law_45 * by4_9;
    double by4_11 = 0.5 * (by4_8 + by4_8 + (by4_10 + by4_10)) / law_47;
    double by4_12 = (law_10 * by4_2 + law_8 * (1.0 - by4_1) + slope * by4_1
        + law_11 * by4_4) / law_9;
    double by4_13 = law_11 * by4_12;
    double by4_14 = 0.5 * (by4_13 + by4_13) / law_15;
    double by4_15 = Piecewise.choose(eps, 0.0, Piecewise.choose(0.0,
        -law_11, by4_12, 0.0), Piecewise.choose(0.0, -law_11, 0.5 * (by4_12
        - by4_14), law_18 * (by4_12 + by4_14) / law_17 * law_19));
    double by4_16 = exponent - 1.0;
    double by4_17 = Piecewise.product(exponent, Powers.power(law_20, by4_16));
    double by4_18 = Piecewise.product(exponent, Powers.power(-law_11, by4_16));
    double by4_19 = Piecewise.choose(-law_11, 0.0, 0.0, by4_12 * by4_18);
    double by4_20 = stiffness * Piecewise.choose(eps, 0.0, by4_19, by4_15 * by4_17);
    double by4_21 = 0.5 * by4_20;
    double by4_22 = u_z * by4_6 + u_x * by4_5;
    double by4_23 = chi * by4_22;
    double by4_24 = damping * by4_22;
    double by4_25 = law_24 * by4_20 + law_21 * by4_23 + ((by4_15
        + law_22 * by4_14) / law_15 * law_23 + law_22 * by4_24) + by4_20;
    double by4_26 = Piecewise.choose(law_29, -1.0, 0.0, Piecewise.choose(1.0, law_28, 0.0, (by4_25
        - law_28 * by4_21) / law_27));
    double by4_27 = law_31 * by4_26;
    double by4_28 = law_33 * (law_32 * by4_26 + law_31 * (by4_27 + by4_27));
    double by4_29 = law_38 * (law_36 * by4_26 + law_30 * (law_35 * by4_26
        + law_30 * (law_34 * by4_26 + 7.0 * by4_26 * law_30))) + law_37 * (by4_28 + by4_28);
    double by4_30 = stiffness * by4_19;
    double by4_31 = Piecewise.choose(-law_11, 0.0, Piecewise.choose(0.0,
        -law_11, Piecewise.choose(law_43, 0.0, 0.0, 0.5 * by4_24), 0.0), Piecewise.choose(law_42,
        0.0, 0.0, law_41 * by4_23 + law_24 * by4_30 + by4_24 + by4_30));
    double by4_32 = Piecewise.choose(eps, 0.0, by4_31, law_39 * by4_21
        + 0.001953125 * by4_29 * law_26 + Piecewise.choose(law_40, 0.0, 0.0, by4_25 - by4_21));
    double by4_33 = friction * by4_32;
    double by4_34 = Piecewise.choose(friction, 0.0, 0.0, -(law_51 * by4_33 + (by4_7
        - law_51 * by4_11) / law_47 * law_48));
    double by4_35 = radius * by4_34;
    double by4_36 = Piecewise.choose(friction, 0.0, 0.0, -(law_49 * by4_33 + (by4_9
        - law_49 * by4_11) / law_47 * law_48));
    out[3] = law_12 * by4_35 - law_52 * by4_6;
    out[15] = -(radius * by4_36);
    out[27] = law_52 * by4_5 + law_13 * by4_35;
    out[39] = law_12 * by4_36 - law_50 * by4_6 - (law_44 * by4_5 + law_13 * by4_32);
    out[51] = by4_34;
    out[63] = law_12 * by4_32 - law_44 * by4_6 + (law_50 * by4_5 + law_13 * by4_36);

    // Derivatives by motion 6.
    double by6_1 = slope / law_6;
    double by6_2 = bend * by6_1;
    double by6_3 = law_8 * by6_2;
    double by6_4 = 0.5 * (by6_3 + by6_3) / law_9;
    double by6_5 = (by6_2 - law_13 * by6_4) / law_9;
    double by6_6 = law_12 * by6_4 / law_9;
    double by6_7 = radius * (omega_z * by6_5 - omega_x * by6_6);
    double by6_8 = law_46 * by6_7;
    double by6_9 = u_z * by6_5 - u_x * by6_6;
    double by6_10 = law_45 * by6_9;
    double by6_11 = 0.5 * (by6_8 + by6_8 + (by6_10 + by6_10)) / law_47;
    double by6_12 = (1.0 - slope * by6_1 - (law_10 * by6_2 - law_8 * by6_1)
        - law_11 * by6_4) / law_9;
    double by6_13 = law_11 * by6_12;
    double by6_14 = 0.5 * (by6_13 + by6_13) / law_15;
    double by6_15 = Piecewise.choose(eps, 0.0, Piecewise.choose(0.0, -law_11,
        -by6_12, 0.0), Piecewise.choose(0.0, -law_11, 0.5 * (by6_14 - by6_12), -(law_18 * (by6_12
        + by6_14) / law_17 * law_19)));
    double by6_16 = Piecewise.choose(-law_11, 0.0, 0.0, -(by4_18 * by6_12));
    double by6_17 = stiffness * Piecewise.choose(eps, 0.0, by6_16, by4_17 * by6_15);
    double by6_18 = 0.5 * by6_17;
    double by6_19 = u_z * by6_6 + u_x * by6_5;
    double by6_20 = chi * by6_19;
    double by6_21 = damping * by6_19;
    double by6_22 = law_24 * by6_17 + law_21 * by6_20 + ((by6_15
        - law_22 * by6_14) / law_15 * law_23 + law_22 * by6_21) + by6_17;
    double by6_23 = Piecewise.choose(law_29, -1.0, 0.0, Piecewise.choose(1.0, law_28, 0.0, (by6_22
        - law_28 * by6_18) / law_27));
    double by6_24 = law_31 * by6_23;
    double by6_25 = law_33 * (law_32 * by6_23 + law_31 * (by6_24 + by6_24));
    double by6_26 = law_38 * (law_36 * by6_23 + law_30 * (law_35 * by6_23
        + law_30 * (law_34 * by6_23 + 7.0 * by6_23 * law_30))) + law_37 * (by6_25 + by6_25);
    double by6_27 = stiffness * by6_16;
    double by6_28 = Piecewise.choose(-law_11, 0.0, Piecewise.choose(0.0,
        -law_11, Piecewise.choose(law_43, 0.0, 0.0, 0.5 * by6_21), 0.0), Piecewise.choose(law_42,
        0.0, 0.0, law_41 * by6_20 + law_24 * by6_27 + by6_21 + by6_27));
    double by6_29 = Piecewise.choose(eps, 0.0, by6_28, law_39 * by6_18
        + 0.001953125 * by6_26 * law_26 + Piecewise.choose(law_40, 0.0, 0.0, by6_22 - by6_18));
    double by6_30 = friction * by6_29;
    double by6_31 = Piecewise.choose(friction, 0.0, 0.0, -(law_51 * by6_30 + (by6_7
        - law_51 * by6_11) / law_47 * law_48));
    double by6_32 = radius * by6_31;
    double by6_33 = Piecewise.choose(friction, 0.0, 0.0, -(law_49 * by6_30 + (by6_9
        - law_49 * by6_11) / law_47 * law_48));
    out[5] = law_12 * by6_32 - law_52 * by6_6;
    out[17] = -(radius * by6_33);
    out[29] = law_52 * by6_5 + law_13 * by6_32;
    out[41] = law_12 * by6_33 - law_50 * by6_6 - (law_44 * by6_5 + law_13 * by6_29);
    out[53] = by6_31;
    out[65] = law_12 * by6_29 - law_44 * by6_6 + (law_50 * by6_5 + law_13 * by6_33);

    // Derivatives by motion 7.
    double by7_1 = radius * law_12;
    double by7_2 = law_46 * by7_1;
    double by7_3 = 0.5 * (by7_2 + by7_2) / law_47;
    double by7_4 = Piecewise.choose(friction, 0.0, 0.0, -((by7_1
        - law_51 * by7_3) / law_47 * law_48));
    double by7_5 = radius * by7_4;
    double by7_6 = Piecewise.choose(friction, 0.0, 0.0, law_49 * by7_3 / law_47 * law_48);
    out[6] = law_12 * by7_5;
    out[18] = -(radius * by7_6);
    out[30] = law_13 * by7_5;
    out[42] = law_12 * by7_6;
    out[54] = by7_4;
    out[66] = law_13 * by7_6;

    // Derivatives by motion 8.
    double by8_1 = radius * law_45;
    double by8_2 = 0.5 * (by8_1 + by8_1) / law_47;
    double by8_3 = Piecewise.choose(friction, 0.0, 0.0, -(law_51 * by8_2 / law_47 * law_48));
    double by8_4 = radius * by8_3;
    double by8_5 = Piecewise.choose(friction, 0.0, 0.0, -((law_49 * by8_2
        - radius) / law_47 * law_48));
    out[7] = law_12 * by8_4;
    out[19] = -(radius * by8_5);
    out[31] = law_13 * by8_4;
    out[43] = law_12 * by8_5;
    out[55] = by8_3;
    out[67] = law_13 * by8_5;

    // Derivatives by motion 9.
    double by9_1 = radius * law_13;
    double by9_2 = law_46 * by9_1;
    double by9_3 = 0.5 * (by9_2 + by9_2) / law_47;
    double by9_4 = Piecewise.choose(friction, 0.0, 0.0, -((by9_1
        - law_51 * by9_3) / law_47 * law_48));
    double by9_5 = radius * by9_4;
    double by9_6 = Piecewise.choose(friction, 0.0, 0.0, law_49 * by9_3 / law_47 * law_48);
    out[8] = law_12 * by9_5;
    out[20] = -(radius * by9_6);
    out[32] = law_13 * by9_5;
    out[44] = law_12 * by9_6;
    out[56] = by9_4;
    out[68] = law_13 * by9_6;

    // Derivatives by motion 10.
    double by10_1 = law_12 * law_45;
    double by10_2 = 0.5 * (by10_1 + by10_1) / law_47;
    double by10_3 = chi * law_13;
    double by10_4 = damping * law_13;
    double by10_5 = law_21 * by10_3 + law_22 * by10_4;
    double by10_6 = Piecewise.choose(law_29, -1.0, 0.0, Piecewise.choose(1.0, law_28, 0.0, by10_5
        / law_27));
    double by10_7 = law_31 * by10_6;
    double by10_8 = law_33 * (law_32 * by10_6 + law_31 * (by10_7 + by10_7));
    double by10_9 = law_38 * (law_36 * by10_6 + law_30 * (law_35 * by10_6
        + law_30 * (law_34 * by10_6 + 7.0 * by10_6 * law_30))) + law_37 * (by10_8 + by10_8);
    double by10_10 = Piecewise.choose(-law_11, 0.0, Piecewise.choose(0.0,
        -law_11, Piecewise.choose(law_43, 0.0, 0.0, 0.5 * by10_4), 0.0), Piecewise.choose(law_42,
        0.0, 0.0, by10_4 + law_41 * by10_3));
    double by10_11 = Piecewise.choose(eps, 0.0, by10_10, Piecewise.choose(law_40, 0.0, 0.0, by10_5)
        + 0.001953125 * by10_9 * law_26);
    double by10_12 = friction * by10_11;
    double by10_13 = Piecewise.choose(friction, 0.0, 0.0, law_51 * by10_2 / law_47 * law_48
        - law_51 * by10_12);
    double by10_14 = radius * by10_13;
    double by10_15 = Piecewise.choose(friction, 0.0, 0.0, -(law_49 * by10_12 + (law_12
        - law_49 * by10_2) / law_47 * law_48));
    out[9] = law_12 * by10_14;
    out[21] = -(radius * by10_15);
    out[33] = law_13 * by10_14;
    out[45] = law_12 * by10_15 - law_13 * by10_11;
    out[57] = by10_13;
    out[69] = law_12 * by10_11 + law_13 * by10_15;

    // Derivatives by motion 11.
    double by11_1 = 0.5 * (law_46 + law_46) / law_47;
    double by11_2 = Piecewise.choose(friction, 0.0, 0.0, -((1.0
        - law_51 * by11_1) / law_47 * law_48));
    double by11_3 = radius * by11_2;
    double by11_4 = Piecewise.choose(friction, 0.0, 0.0, law_49 * by11_1 / law_47 * law_48);
    out[10] = law_12 * by11_3;
    out[22] = -(radius * by11_4);
    out[34] = law_13 * by11_3;
    out[46] = law_12 * by11_4;
    out[58] = by11_2;
    out[70] = law_13 * by11_4;

    // Derivatives by motion 12.
    double by12_1 = law_13 * law_45;
    double by12_2 = 0.5 * (by12_1 + by12_1) / law_47;
    double by12_3 = chi * law_12;
    double by12_4 = damping * law_12;
    double by12_5 = law_21 * by12_3 + law_22 * by12_4;
    double by12_6 = Piecewise.choose(law_29, -1.0, 0.0, Piecewise.choose(1.0, law_28, 0.0,
        -(by12_5 / law_27)));
    double by12_7 = law_31 * by12_6;
    double by12_8 = law_33 * (law_32 * by12_6 + law_31 * (by12_7 + by12_7));
    double by12_9 = law_38 * (law_36 * by12_6 + law_30 * (law_35 * by12_6
        + law_30 * (law_34 * by12_6 + 7.0 * by12_6 * law_30))) + law_37 * (by12_8 + by12_8);
    double by12_10 = Piecewise.choose(-law_11, 0.0, Piecewise.choose(0.0,
        -law_11, Piecewise.choose(law_43, 0.0, 0.0, -(0.5 * by12_4)), 0.0), Piecewise.choose(law_42,
        0.0, 0.0, -(by12_4 + law_41 * by12_3)));
    double by12_11 = Piecewise.choose(eps, 0.0, by12_10, Piecewise.choose(law_40, 0.0, 0.0, -by12_5)
        + 0.001953125 * by12_9 * law_26);
    double by12_12 = friction * by12_11;
    double by12_13 = Piecewise.choose(friction, 0.0, 0.0, law_51 * by12_2 / law_47 * law_48
        - law_51 * by12_12);
    double by12_14 = radius * by12_13;
    double by12_15 = Piecewise.choose(friction, 0.0, 0.0, -(law_49 * by12_12 + (law_13
        - law_49 * by12_2) / law_47 * law_48));
    out[11] = law_12 * by12_14;
    out[23] = -(radius * by12_15);
    out[35] = law_13 * by12_14;
    out[47] = law_12 * by12_15 - law_13 * by12_11;
    out[59] = by12_13;
    out[71] = law_12 * by12_11 + law_13 * by12_15;
  }

  @Override
  public void results(double[] x, double[] c, double[] out) {
    // The load by its formula.
    double r_x = x[0];
    double r_z = x[2];
    double u_x = x[15];
    double u_z = x[17];
    double radius = c[0];
    double stiffness = c[1];
    double exponent = c[4];
    double eps = c[5];
    double friction = c[6];
    double frictionSpeed = c[7];
    double s = c[8];
    double height = c[9];
    double slope = c[10];
    double bend = c[11];
    double law_1 = height - r_z;
    double law_2 = s - r_x + slope * law_1;
    double law_3 = 1.0 + slope * slope;
    double law_4 = law_3 + bend * law_1;
    double law_5 = 1e-6 * law_3;
    double law_6 = (law_2 - Piecewise.held(law_2)) / Piecewise.pick(law_4, law_5, law_5, law_4);
    double law_7 = slope - bend * law_6;
    double law_8 = Math.sqrt(1.0 + law_7 * law_7);
    double law_9 = (r_z - (height - slope * law_6) - law_7 * (r_x - (s - law_6))) / law_8;
    double law_10 = 1.0 / law_8;
    double law_11 = law_7 / law_8;
    double law_12 = u_x * law_11 - u_z * law_10;
    double law_13 = eps * eps;
    double law_14 = Math.sqrt(law_9 * law_9 + law_13);
    double law_15 = Piecewise.choose(-law_9, 0.0, 0.0, Powers.power(-law_9, exponent));
    double law_16 = Piecewise.choose(eps, 0.0, Piecewise.choose(0.0, -law_9,
        -law_9, 0.0), Piecewise.choose(0.0, -law_9, 0.5 * (law_14 - law_9), eps / (law_9
        + law_14) * (0.5 * eps)));
    double law_17 = stiffness * Piecewise.choose(eps, 0.0, law_15, Powers.power(law_16, exponent));
    double law_18 = c[2] * law_12;
    double law_19 = c[3] * law_12;
    double law_20 = law_16 / law_14 * law_18 + law_17 * law_19 + law_17;
    double law_21 = 0.5 * law_17;
    double law_22 = Math.max(-1.0, Math.min(1.0, law_20 / (1e-300 + law_21)));
    double law_23 = 1.0 + law_22;
    double law_24 = law_23 * law_23 * law_23;
    double law_25 = (63.0 + law_22 * (law_22 * (102.0 + law_22 * (7.0 * law_22 - 42.0))
        - 122.0)) * (law_24 * law_24) * 0.001953125 * law_21 + Math.max(0.0, law_20 - law_21);
    double law_26 = stiffness * law_15;
    double law_27 = Piecewise.choose(eps, 0.0, Piecewise.choose(-law_9, 0.0, Piecewise.choose(0.0,
        -law_9, Math.max(0.0, 0.5 * law_18), 0.0), Math.max(0.0, law_18 + law_19 * law_26
        + law_26)), law_25);
    double law_28 = u_x * law_10 + u_z * law_11 - x[13] * radius;
    double law_29 = x[16] + radius * (x[12] * law_10 + x[14] * law_11);
    double law_30 = Math.sqrt(law_28 * law_28 + law_29 * law_29 + frictionSpeed * frictionSpeed);
    double law_31 = friction * law_27;
    double law_32 = Piecewise.choose(friction, 0.0, 0.0, -(law_28 / law_30 * law_31));
    double law_33 = Piecewise.choose(friction, 0.0, 0.0, -(law_29 / law_30 * law_31));
    double law_34 = law_16 * law_16;
    double law_35 = 0.5 * law_34;
    double law_36 = 0.25 * law_13;
    double law_37 = exponent - 1.0;
    double law_38 = Powers.power(law_16, law_37);
    double law_39 = Piecewise.choose(exponent, 1.0, Piecewise.choose(eps, 0.0, law_35, law_35
        + (StrictMath.log(2.0 / eps * law_16) - 0.5) * law_36), law_36 / law_37 * law_38
        + 1.0 / (1.0 + exponent) * (law_34 * law_38));
    out[0] = stiffness * law_39;
    out[1] = law_28 * law_32 + law_29 * law_33 - law_12 * (law_27 - law_17);
    out[2] = -law_9;
    out[3] = law_27;
    out[4] = law_32;
    out[5] = law_33;
  }
}
