package org.mechservice.solver.force.law.printed;

import org.mechservice.solver.force.law.PrintedLaw;
import org.mechservice.solver.spatial.Piecewise;
import org.mechservice.solver.spatial.Powers;

/**
 * Printed from its formula; do not edit. PrintedLawsTest compares it with the formula and
 * prints it anew with -Dgolden.write=true.
 */
final class PrintedContact implements PrintedLaw {

  @Override
  public void load(double[] x, double[] c, double[] out) {
    // The load by its formula.
    double s = c[8];
    double r_x = x[0];
    double slope = c[10];
    double height = c[9];
    double r_z = x[2];
    double bend = c[11];
    double radius = c[0];
    double friction = c[6];
    double u_x = x[15];
    double u_z = x[17];
    double law_1 = s - r_x;
    double law_2 = height - r_z;
    double law_3 = law_1 + slope * law_2;
    double law_4 = Piecewise.held(Math.abs(law_3));
    double law_5 = 1.0 + slope * slope;
    double law_6 = Piecewise.held(Math.sqrt(law_5) * (1e-7 * Math.sqrt(law_1 * law_1
        + law_2 * law_2) + 1e-14 * (Math.abs(r_x) + Math.abs(r_z))));
    double law_7 = law_5 + bend * law_2;
    double law_8 = 1e-6 * law_5;
    double law_9 = (law_3 - Piecewise.held(law_3)) / Piecewise.pick(law_4, law_6,
        Piecewise.pick(law_7, law_8, law_8, law_7), 1e300);
    double law_10 = slope - bend * law_9;
    double law_11 = Math.sqrt(1.0 + law_10 * law_10);
    double law_12 = r_z - (height - slope * law_9);
    double law_13 = r_x - (s - law_9);
    double law_14 = Math.sqrt(law_13 * law_13 + law_12 * law_12);
    double law_15 = Piecewise.choose(Piecewise.held(r_z), Piecewise.held(c[12]), -law_14, law_14);
    double law_16 = Piecewise.choose(law_4, law_6, 1.0 / law_11, law_12 / law_15);
    double law_17 = radius - Piecewise.choose(law_4, law_6, (law_12
        - law_10 * law_13) / law_11, law_15);
    double law_18 = Piecewise.choose(law_4, law_6, law_10 / law_11, -(law_13 / law_15));
    double law_19 = u_x * law_18 - u_z * law_16;
    double law_20 = c[2] * law_19;
    double law_21 = c[1] * Piecewise.choose(law_17, 0.0, 0.0, Powers.power(law_17, c[4]));
    double law_22 = Piecewise.choose(law_17, 0.0, Piecewise.choose(0.0, law_17, Math.max(0.0, 0.5
        * law_20), 0.0), Math.max(0.0, law_20 + c[3] * law_19 * law_21 + law_21));
    double law_23 = friction * law_22;
    double law_24 = x[16] + radius * (x[12] * law_16 + x[14] * law_18);
    double law_25 = u_x * law_16 + u_z * law_18 - x[13] * radius;
    double law_26 = Math.sqrt(law_25 * law_25 + law_24 * law_24 + c[13]);
    double law_27 = Piecewise.choose(friction, 0.0, 0.0, -(law_24 / law_26 * law_23));
    double law_28 = radius * law_27;
    double law_29 = Piecewise.choose(friction, 0.0, 0.0, -(law_25 / law_26 * law_23));
    out[0] = law_16 * law_28;
    out[1] = -(radius * law_29);
    out[2] = law_18 * law_28;
    out[3] = law_16 * law_29 - law_18 * law_22;
    out[4] = law_27;
    out[5] = law_18 * law_29 + law_16 * law_22;
    out[6] = 1.0;
  }

  @Override
  public void slopes(double[] x, double[] c, double[] out) {
    // Derivatives by motion 4.
    double radius = c[0];
    double friction = c[6];
    double s = c[8];
    double r_x = x[0];
    double slope = c[10];
    double height = c[9];
    double r_z = x[2];
    double bend = c[11];
    double damping = c[2];
    double u_x = x[15];
    double u_z = x[17];
    double stiffness = c[1];
    double exponent = c[4];
    double chi = c[3];
    double omega_x = x[12];
    double omega_z = x[14];
    double by4_1 = s - r_x;
    double by4_2 = height - r_z;
    double by4_3 = by4_1 + slope * by4_2;
    double by4_4 = Piecewise.held(Math.abs(by4_3));
    double by4_5 = 1.0 + slope * slope;
    double by4_6 = Piecewise.held(Math.sqrt(by4_5) * (1e-7 * Math.sqrt(by4_1 * by4_1
        + by4_2 * by4_2) + 1e-14 * (Math.abs(r_x) + Math.abs(r_z))));
    double by4_7 = by4_5 + bend * by4_2;
    double by4_8 = 1e-6 * by4_5;
    double by4_9 = Piecewise.pick(by4_4, by4_6, Piecewise.pick(by4_7, by4_8, by4_8, by4_7), 1e300);
    double by4_10 = (by4_3 - Piecewise.held(by4_3)) / by4_9;
    double by4_11 = r_z - (height - slope * by4_10);
    double by4_12 = slope - bend * by4_10;
    double by4_13 = r_x - (s - by4_10);
    double by4_14 = Math.sqrt(1.0 + by4_12 * by4_12);
    double by4_15 = (by4_11 - by4_12 * by4_13) / by4_14;
    double by4_16 = Piecewise.held(r_z);
    double by4_17 = Piecewise.held(c[12]);
    double by4_18 = Math.sqrt(by4_13 * by4_13 + by4_11 * by4_11);
    double by4_19 = Piecewise.choose(by4_16, by4_17, -by4_18, by4_18);
    double by4_20 = radius - Piecewise.choose(by4_4, by4_6, by4_15, by4_19);
    double by4_21 = by4_12 / by4_14;
    double by4_22 = by4_13 / by4_19;
    double by4_23 = Piecewise.choose(by4_4, by4_6, by4_21, -by4_22);
    double by4_24 = 1.0 / by4_14;
    double by4_25 = by4_11 / by4_19;
    double by4_26 = Piecewise.choose(by4_4, by4_6, by4_24, by4_25);
    double by4_27 = u_x * by4_23 - u_z * by4_26;
    double by4_28 = damping * by4_27;
    double by4_29 = 0.5 * by4_28;
    double by4_30 = stiffness * Piecewise.choose(by4_20, 0.0, 0.0, Powers.power(by4_20, exponent));
    double by4_31 = chi * by4_27;
    double by4_32 = by4_28 + by4_30 * by4_31 + by4_30;
    double by4_33 = Piecewise.choose(by4_20, 0.0, Piecewise.choose(0.0, by4_20, Math.max(0.0,
        by4_29), 0.0), Math.max(0.0, by4_32));
    double by4_34 = friction * by4_33;
    double by4_35 = x[16] + radius * (omega_x * by4_26 + omega_z * by4_23);
    double by4_36 = u_x * by4_26 + u_z * by4_23 - x[13] * radius;
    double by4_37 = Math.sqrt(by4_36 * by4_36 + by4_35 * by4_35 + c[13]);
    double by4_38 = by4_35 / by4_37;
    double by4_39 = radius * Piecewise.choose(friction, 0.0, 0.0, -(by4_34 * by4_38));
    double by4_40 = 1.0 / by4_9;
    double by4_41 = bend * by4_40;
    double by4_42 = by4_12 * by4_41;
    double by4_43 = 0.5 * (by4_42 + by4_42) / by4_14;
    double by4_44 = slope * by4_40;
    double by4_45 = 1.0 - by4_40;
    double by4_46 = by4_13 * by4_45;
    double by4_47 = by4_11 * by4_44;
    double by4_48 = 0.5 * (by4_46 + by4_46 - (by4_47 + by4_47)) / by4_18;
    double by4_49 = Piecewise.choose(by4_16, by4_17, -by4_48, by4_48);
    double by4_50 = Piecewise.choose(by4_4, by4_6, -(by4_24 * by4_43 / by4_14), -((by4_44
        + by4_25 * by4_49) / by4_19));
    double by4_51 = Piecewise.choose(by4_4, by4_6, (by4_41 - by4_21 * by4_43) / by4_14, -((by4_45
        - by4_22 * by4_49) / by4_19));
    double by4_52 = u_x * by4_51 - u_z * by4_50;
    double by4_53 = damping * by4_52;
    double by4_54 = Piecewise.product(exponent, Powers.power(by4_20, c[14]));
    double by4_55 = Piecewise.choose(by4_20, 0.0, 0.0, -(Piecewise.choose(by4_4, by4_6,
        -((by4_13 * by4_41 + by4_12 * by4_45 + by4_44 + by4_15 * by4_43) / by4_14), by4_49)
        * by4_54));
    double by4_56 = stiffness * by4_55;
    double by4_57 = Piecewise.choose(by4_20, 0.0, Piecewise.choose(0.0, by4_20,
        Piecewise.choose(by4_29, 0.0, 0.0, 0.5 * by4_53), 0.0), Piecewise.choose(by4_32, 0.0, 0.0,
        by4_31 * by4_56 + chi * by4_52 * by4_30 + by4_53 + by4_56));
    double by4_58 = friction * by4_57;
    double by4_59 = radius * (omega_z * by4_51 + omega_x * by4_50);
    double by4_60 = by4_35 * by4_59;
    double by4_61 = u_z * by4_51 + u_x * by4_50;
    double by4_62 = by4_36 * by4_61;
    double by4_63 = 0.5 * (by4_60 + by4_60 + (by4_62 + by4_62)) / by4_37;
    double by4_64 = Piecewise.choose(friction, 0.0, 0.0, -(by4_38 * by4_58 + (by4_59
        - by4_38 * by4_63) / by4_37 * by4_34));
    double by4_65 = radius * by4_64;
    double by4_66 = by4_36 / by4_37;
    double by4_67 = Piecewise.choose(friction, 0.0, 0.0, -(by4_66 * by4_58 + (by4_61
        - by4_66 * by4_63) / by4_37 * by4_34));
    double by4_68 = Piecewise.choose(friction, 0.0, 0.0, -(by4_34 * by4_66));
    out[3] = by4_39 * by4_50 + by4_26 * by4_65;
    out[9] = -(radius * by4_67);
    out[15] = by4_39 * by4_51 + by4_23 * by4_65;
    out[21] = by4_68 * by4_50 + by4_26 * by4_67 - (by4_33 * by4_51 + by4_23 * by4_57);
    out[27] = by4_64;
    out[33] = by4_33 * by4_50 + by4_26 * by4_57 + (by4_68 * by4_51 + by4_23 * by4_67);

    // Derivatives by motion 6.
    double by6_1 = slope / by4_9;
    double by6_2 = bend * by6_1;
    double by6_3 = by4_12 * by6_2;
    double by6_4 = 0.5 * (by6_3 + by6_3) / by4_14;
    double by6_5 = 1.0 - slope * by6_1;
    double by6_6 = by4_11 * by6_5;
    double by6_7 = by4_13 * by6_1;
    double by6_8 = 0.5 * (by6_6 + by6_6 - (by6_7 + by6_7)) / by4_18;
    double by6_9 = Piecewise.choose(by4_16, by4_17, -by6_8, by6_8);
    double by6_10 = Piecewise.choose(by4_4, by4_6, -(by4_24 * by6_4 / by4_14), (by6_5
        - by4_25 * by6_9) / by4_19);
    double by6_11 = Piecewise.choose(by4_4, by4_6, (by6_2 - by4_21 * by6_4) / by4_14, (by6_1
        + by4_22 * by6_9) / by4_19);
    double by6_12 = u_x * by6_11 - u_z * by6_10;
    double by6_13 = damping * by6_12;
    double by6_14 = Piecewise.choose(by4_20, 0.0, 0.0,
        -(by4_54 * Piecewise.choose(by4_4, by4_6, (by6_5 - (by4_13 * by6_2 - by4_12 * by6_1)
        - by4_15 * by6_4) / by4_14, by6_9)));
    double by6_15 = stiffness * by6_14;
    double by6_16 = Piecewise.choose(by4_20, 0.0, Piecewise.choose(0.0, by4_20,
        Piecewise.choose(by4_29, 0.0, 0.0, 0.5 * by6_13), 0.0), Piecewise.choose(by4_32, 0.0, 0.0,
        by4_31 * by6_15 + chi * by6_12 * by4_30 + by6_13 + by6_15));
    double by6_17 = friction * by6_16;
    double by6_18 = radius * (omega_z * by6_11 + omega_x * by6_10);
    double by6_19 = by4_35 * by6_18;
    double by6_20 = u_z * by6_11 + u_x * by6_10;
    double by6_21 = by4_36 * by6_20;
    double by6_22 = 0.5 * (by6_19 + by6_19 + (by6_21 + by6_21)) / by4_37;
    double by6_23 = Piecewise.choose(friction, 0.0, 0.0, -(by4_38 * by6_17 + (by6_18
        - by4_38 * by6_22) / by4_37 * by4_34));
    double by6_24 = radius * by6_23;
    double by6_25 = Piecewise.choose(friction, 0.0, 0.0, -(by4_66 * by6_17 + (by6_20
        - by4_66 * by6_22) / by4_37 * by4_34));
    out[5] = by4_39 * by6_10 + by4_26 * by6_24;
    out[11] = -(radius * by6_25);
    out[17] = by4_39 * by6_11 + by4_23 * by6_24;
    out[23] = by4_68 * by6_10 + by4_26 * by6_25 - (by4_33 * by6_11 + by4_23 * by6_16);
    out[29] = by6_23;
    out[35] = by4_33 * by6_10 + by4_26 * by6_16 + (by4_68 * by6_11 + by4_23 * by6_25);

    // Derivatives by motion 7.
    double by7_1 = radius * by4_26;
    double by7_2 = by4_35 * by7_1;
    double by7_3 = 0.5 * (by7_2 + by7_2) / by4_37;
    double by7_4 = Piecewise.choose(friction, 0.0, 0.0, -((by7_1
        - by4_38 * by7_3) / by4_37 * by4_34));
    double by7_5 = radius * by7_4;
    double by7_6 = Piecewise.choose(friction, 0.0, 0.0, by4_66 * by7_3 / by4_37 * by4_34);
    out[36] = by4_26 * by7_5;
    out[42] = -(radius * by7_6);
    out[48] = by4_23 * by7_5;
    out[54] = by4_26 * by7_6;
    out[60] = by7_4;
    out[66] = by4_23 * by7_6;

    // Derivatives by motion 8.
    double by8_1 = radius * by4_36;
    double by8_2 = 0.5 * (by8_1 + by8_1) / by4_37;
    double by8_3 = Piecewise.choose(friction, 0.0, 0.0, -(by4_38 * by8_2 / by4_37 * by4_34));
    double by8_4 = radius * by8_3;
    double by8_5 = Piecewise.choose(friction, 0.0, 0.0, -((by4_66 * by8_2
        - radius) / by4_37 * by4_34));
    out[37] = by4_26 * by8_4;
    out[43] = -(radius * by8_5);
    out[49] = by4_23 * by8_4;
    out[55] = by4_26 * by8_5;
    out[61] = by8_3;
    out[67] = by4_23 * by8_5;

    // Derivatives by motion 9.
    double by9_1 = radius * by4_23;
    double by9_2 = by4_35 * by9_1;
    double by9_3 = 0.5 * (by9_2 + by9_2) / by4_37;
    double by9_4 = Piecewise.choose(friction, 0.0, 0.0, -((by9_1
        - by4_38 * by9_3) / by4_37 * by4_34));
    double by9_5 = radius * by9_4;
    double by9_6 = Piecewise.choose(friction, 0.0, 0.0, by4_66 * by9_3 / by4_37 * by4_34);
    out[38] = by4_26 * by9_5;
    out[44] = -(radius * by9_6);
    out[50] = by4_23 * by9_5;
    out[56] = by4_26 * by9_6;
    out[62] = by9_4;
    out[68] = by4_23 * by9_6;

    // Derivatives by motion 10.
    double by10_1 = damping * by4_23;
    double by10_2 = Piecewise.choose(by4_20, 0.0, Piecewise.choose(0.0, by4_20,
        Piecewise.choose(by4_29, 0.0, 0.0, 0.5 * by10_1), 0.0), Piecewise.choose(by4_32, 0.0, 0.0,
        chi * by4_23 * by4_30 + by10_1));
    double by10_3 = friction * by10_2;
    double by10_4 = by4_26 * by4_36;
    double by10_5 = 0.5 * (by10_4 + by10_4) / by4_37;
    double by10_6 = Piecewise.choose(friction, 0.0, 0.0, by4_38 * by10_5 / by4_37 * by4_34
        - by4_38 * by10_3);
    double by10_7 = radius * by10_6;
    double by10_8 = Piecewise.choose(friction, 0.0, 0.0, -(by4_66 * by10_3 + (by4_26
        - by4_66 * by10_5) / by4_37 * by4_34));
    out[39] = by4_26 * by10_7;
    out[45] = -(radius * by10_8);
    out[51] = by4_23 * by10_7;
    out[57] = by4_26 * by10_8 - by4_23 * by10_2;
    out[63] = by10_6;
    out[69] = by4_26 * by10_2 + by4_23 * by10_8;

    // Derivatives by motion 11.
    double by11_1 = 0.5 * (by4_35 + by4_35) / by4_37;
    double by11_2 = Piecewise.choose(friction, 0.0, 0.0, -((1.0
        - by4_38 * by11_1) / by4_37 * by4_34));
    double by11_3 = radius * by11_2;
    double by11_4 = Piecewise.choose(friction, 0.0, 0.0, by4_66 * by11_1 / by4_37 * by4_34);
    out[40] = by4_26 * by11_3;
    out[46] = -(radius * by11_4);
    out[52] = by4_23 * by11_3;
    out[58] = by4_26 * by11_4;
    out[64] = by11_2;
    out[70] = by4_23 * by11_4;

    // Derivatives by motion 12.
    double by12_1 = damping * by4_26;
    double by12_2 = Piecewise.choose(by4_20, 0.0, Piecewise.choose(0.0, by4_20,
        Piecewise.choose(by4_29, 0.0, 0.0, -(0.5 * by12_1)), 0.0), Piecewise.choose(by4_32, 0.0,
        0.0, -(chi * by4_26 * by4_30 + by12_1)));
    double by12_3 = friction * by12_2;
    double by12_4 = by4_23 * by4_36;
    double by12_5 = 0.5 * (by12_4 + by12_4) / by4_37;
    double by12_6 = Piecewise.choose(friction, 0.0, 0.0, by4_38 * by12_5 / by4_37 * by4_34
        - by4_38 * by12_3);
    double by12_7 = radius * by12_6;
    double by12_8 = Piecewise.choose(friction, 0.0, 0.0, -(by4_66 * by12_3 + (by4_23
        - by4_66 * by12_5) / by4_37 * by4_34));
    out[41] = by4_26 * by12_7;
    out[47] = -(radius * by12_8);
    out[53] = by4_23 * by12_7;
    out[59] = by4_26 * by12_8 - by4_23 * by12_2;
    out[65] = by12_6;
    out[71] = by4_26 * by12_2 + by4_23 * by12_8;
  }

  @Override
  public void results(double[] x, double[] c, double[] out) {
    // The load by its formula.
    double stiffness = c[1];
    double exponent = c[4];
    double radius = c[0];
    double s = c[8];
    double r_x = x[0];
    double slope = c[10];
    double height = c[9];
    double r_z = x[2];
    double bend = c[11];
    double u_x = x[15];
    double u_z = x[17];
    double friction = c[6];
    double law_1 = s - r_x;
    double law_2 = height - r_z;
    double law_3 = law_1 + slope * law_2;
    double law_4 = Piecewise.held(Math.abs(law_3));
    double law_5 = 1.0 + slope * slope;
    double law_6 = Piecewise.held(Math.sqrt(law_5) * (1e-7 * Math.sqrt(law_1 * law_1
        + law_2 * law_2) + 1e-14 * (Math.abs(r_x) + Math.abs(r_z))));
    double law_7 = law_5 + bend * law_2;
    double law_8 = 1e-6 * law_5;
    double law_9 = (law_3 - Piecewise.held(law_3)) / Piecewise.pick(law_4, law_6,
        Piecewise.pick(law_7, law_8, law_8, law_7), 1e300);
    double law_10 = r_z - (height - slope * law_9);
    double law_11 = slope - bend * law_9;
    double law_12 = r_x - (s - law_9);
    double law_13 = Math.sqrt(1.0 + law_11 * law_11);
    double law_14 = Math.sqrt(law_12 * law_12 + law_10 * law_10);
    double law_15 = Piecewise.choose(Piecewise.held(r_z), Piecewise.held(c[12]), -law_14, law_14);
    double law_16 = radius - Piecewise.choose(law_4, law_6, (law_10
        - law_11 * law_12) / law_13, law_15);
    double law_17 = Piecewise.choose(0.0, law_16, law_16, 0.0);
    double law_18 = law_17 * law_17;
    double law_19 = Piecewise.choose(law_4, law_6, 1.0 / law_13, law_10 / law_15);
    double law_20 = Piecewise.choose(law_4, law_6, law_11 / law_13, -(law_12 / law_15));
    double law_21 = u_x * law_19 + u_z * law_20 - x[13] * radius;
    double law_22 = u_x * law_20 - u_z * law_19;
    double law_23 = c[2] * law_22;
    double law_24 = stiffness * Piecewise.choose(law_16, 0.0, 0.0, Powers.power(law_16, exponent));
    double law_25 = Piecewise.choose(law_16, 0.0, Piecewise.choose(0.0, law_16, Math.max(0.0, 0.5
        * law_23), 0.0), Math.max(0.0, law_23 + c[3] * law_22 * law_24 + law_24));
    double law_26 = friction * law_25;
    double law_27 = x[16] + radius * (x[12] * law_19 + x[14] * law_20);
    double law_28 = Math.sqrt(law_21 * law_21 + law_27 * law_27 + c[13]);
    double law_29 = Piecewise.choose(friction, 0.0, 0.0, -(law_21 / law_28 * law_26));
    double law_30 = Piecewise.choose(friction, 0.0, 0.0, -(law_27 / law_28 * law_26));
    out[0] = stiffness * Piecewise.choose(exponent, 1.0, 0.5 * law_18, law_18 * Powers.power(law_17,
        c[14]) * c[15]);
    out[1] = law_21 * law_29 + law_27 * law_30 - law_22 * (law_25 - law_24);
    out[2] = law_16;
    out[3] = law_25;
    out[4] = law_29;
    out[5] = law_30;
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
