package org.mechservice.solver.force.law.printed;

import org.mechservice.solver.force.law.PrintedLaw;
import org.mechservice.solver.spatial.Piecewise;
import org.mechservice.solver.spatial.Powers;

/**
 * Printed from its formula; do not edit. PrintedLawsTest compares it with the formula and
 * prints it anew with -Dgolden.write=true.
 */
final class PrintedSmoothContactOfCentre implements PrintedLaw {

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
    double law_11 = Math.sqrt(law_10 * law_10 + c[14]);
    double law_12 = Math.abs(-law_10);
    double law_13 = c[13] / (law_11 + law_12) + 0.5 * (law_12 - law_10);
    double law_14 = c[1] * Powers.power(law_13, c[4]);
    double law_15 = 0.5 * law_14;
    double law_16 = law_7 / law_8;
    double law_17 = u_x * law_16 - u_z * law_9;
    double law_18 = law_13 / law_11 * (c[2] * law_17) + c[3] * law_17 * law_14 + law_14;
    double law_19 = Math.max(-1.0, Math.min(1.0, law_18 / (1e-300 + law_15)));
    double law_20 = 1.0 + law_19;
    double law_21 = law_20 * law_20 * law_20;
    double law_22 = (63.0 + law_19 * (law_19 * (102.0 + law_19 * (7.0 * law_19 - 42.0))
        - 122.0)) * (law_21 * law_21) * 0.001953125 * law_15 + Math.max(0.0, law_18 - law_15);
    double law_23 = friction * law_22;
    double law_24 = x[16] + radius * (x[12] * law_9 + x[14] * law_16);
    double law_25 = u_x * law_9 + u_z * law_16 - x[13] * radius;
    double law_26 = Math.sqrt(law_25 * law_25 + law_24 * law_24 + c[15]);
    double law_27 = Piecewise.choose(friction, 0.0, 0.0, -(law_24 / law_26 * law_23));
    double law_28 = radius * law_27;
    double law_29 = Piecewise.choose(friction, 0.0, 0.0, -(law_25 / law_26 * law_23));
    out[0] = law_9 * law_28;
    out[1] = -(radius * law_29);
    out[2] = law_16 * law_28;
    out[3] = law_9 * law_29 - law_16 * law_22;
    out[4] = law_27;
    out[5] = law_16 * law_29 + law_9 * law_22;
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
    double stiffness = c[1];
    double exponent = c[4];
    double damping = c[2];
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
    double by4_14 = Math.sqrt(by4_13 * by4_13 + by4_12 * by4_12 + c[15]);
    double by4_15 = by4_12 / by4_14;
    double by4_16 = r_x - (s - by4_7);
    double by4_17 = (r_z - (height - slope * by4_7) - by4_8 * by4_16) / by4_9;
    double by4_18 = Math.sqrt(by4_17 * by4_17 + c[14]);
    double by4_19 = Math.abs(-by4_17);
    double by4_20 = by4_18 + by4_19;
    double by4_21 = c[13] / by4_20;
    double by4_22 = by4_21 + 0.5 * (by4_19 - by4_17);
    double by4_23 = stiffness * Powers.power(by4_22, exponent);
    double by4_24 = by4_22 / by4_18;
    double by4_25 = u_x * by4_11 - u_z * by4_10;
    double by4_26 = damping * by4_25;
    double by4_27 = chi * by4_25;
    double by4_28 = by4_24 * by4_26 + by4_23 * by4_27 + by4_23;
    double by4_29 = 0.5 * by4_23;
    double by4_30 = by4_28 - by4_29;
    double by4_31 = 1.0 / by4_6;
    double by4_32 = bend * by4_31;
    double by4_33 = by4_8 * by4_32;
    double by4_34 = 0.5 * (by4_33 + by4_33) / by4_9;
    double by4_35 = (by4_16 * by4_32 + by4_8 * (1.0 - by4_31) + slope * by4_31
        + by4_17 * by4_34) / by4_9;
    double by4_36 = Math.signum(-by4_17);
    double by4_37 = by4_35 * by4_36;
    double by4_38 = by4_17 * by4_35;
    double by4_39 = 0.5 * (by4_38 + by4_38) / by4_18;
    double by4_40 = 0.5 * (by4_35 + by4_37) - by4_21 * (by4_37 - by4_39) / by4_20;
    double by4_41 = Piecewise.product(exponent, Powers.power(by4_22, c[16]));
    double by4_42 = by4_40 * by4_41 * stiffness;
    double by4_43 = by4_10 * by4_34 / by4_9;
    double by4_44 = (by4_32 - by4_11 * by4_34) / by4_9;
    double by4_45 = u_z * by4_43 + u_x * by4_44;
    double by4_46 = by4_27 * by4_42 + chi * by4_45 * by4_23 + ((by4_40
        + by4_24 * by4_39) / by4_18 * by4_26 + damping * by4_45 * by4_24) + by4_42;
    double by4_47 = 0.5 * by4_42;
    double by4_48 = 1e-300 + by4_29;
    double by4_49 = by4_28 / by4_48;
    double by4_50 = Math.min(1.0, by4_49);
    double by4_51 = Math.max(-1.0, by4_50);
    double by4_52 = 7.0 * by4_51 - 42.0;
    double by4_53 = 102.0 + by4_51 * by4_52;
    double by4_54 = by4_51 * by4_53 - 122.0;
    double by4_55 = 63.0 + by4_51 * by4_54;
    double by4_56 = 1.0 + by4_51;
    double by4_57 = by4_56 * by4_56;
    double by4_58 = by4_56 * by4_57;
    double by4_59 = by4_58 * by4_58;
    double by4_60 = by4_55 * by4_59 * 0.001953125;
    double by4_61 = Piecewise.choose(by4_50, -1.0, 0.0, Piecewise.choose(1.0, by4_49, 0.0, (by4_46
        - by4_49 * by4_47) / by4_48));
    double by4_62 = by4_56 * by4_61;
    double by4_63 = by4_58 * (by4_57 * by4_61 + by4_56 * (by4_62 + by4_62));
    double by4_64 = by4_59 * (by4_54 * by4_61 + by4_51 * (by4_53 * by4_61
        + by4_51 * (by4_52 * by4_61 + 7.0 * by4_61 * by4_51))) + by4_55 * (by4_63 + by4_63);
    double by4_65 = by4_60 * by4_47 + 0.001953125 * by4_64 * by4_29
        + Piecewise.choose(by4_30, 0.0, 0.0, by4_46 - by4_47);
    double by4_66 = friction * by4_65;
    double by4_67 = by4_29 * by4_60 + Math.max(0.0, by4_30);
    double by4_68 = friction * by4_67;
    double by4_69 = radius * (omega_z * by4_44 - omega_x * by4_43);
    double by4_70 = by4_12 * by4_69;
    double by4_71 = u_z * by4_44 - u_x * by4_43;
    double by4_72 = by4_13 * by4_71;
    double by4_73 = 0.5 * (by4_70 + by4_70 + (by4_72 + by4_72)) / by4_14;
    double by4_74 = Piecewise.choose(friction, 0.0, 0.0, -(by4_15 * by4_66 + (by4_69
        - by4_15 * by4_73) / by4_14 * by4_68));
    double by4_75 = radius * by4_74;
    double by4_76 = radius * Piecewise.choose(friction, 0.0, 0.0, -(by4_68 * by4_15));
    double by4_77 = by4_13 / by4_14;
    double by4_78 = Piecewise.choose(friction, 0.0, 0.0, -(by4_77 * by4_66 + (by4_71
        - by4_77 * by4_73) / by4_14 * by4_68));
    double by4_79 = Piecewise.choose(friction, 0.0, 0.0, -(by4_68 * by4_77));
    out[3] = by4_10 * by4_75 - by4_76 * by4_43;
    out[9] = -(radius * by4_78);
    out[15] = by4_76 * by4_44 + by4_11 * by4_75;
    out[21] = by4_10 * by4_78 - by4_79 * by4_43 - (by4_67 * by4_44 + by4_11 * by4_65);
    out[27] = by4_74;
    out[33] = by4_10 * by4_65 - by4_67 * by4_43 + (by4_79 * by4_44 + by4_11 * by4_78);

    // Derivatives by motion 6.
    double by6_1 = slope / by4_6;
    double by6_2 = bend * by6_1;
    double by6_3 = by4_8 * by6_2;
    double by6_4 = 0.5 * (by6_3 + by6_3) / by4_9;
    double by6_5 = (1.0 - slope * by6_1 - (by4_16 * by6_2 - by4_8 * by6_1)
        - by4_17 * by6_4) / by4_9;
    double by6_6 = by4_36 * by6_5;
    double by6_7 = by4_17 * by6_5;
    double by6_8 = 0.5 * (by6_7 + by6_7) / by4_18;
    double by6_9 = 0.5 * (by6_5 + by6_6) + by4_21 * (by6_8 - by6_6) / by4_20;
    double by6_10 = by4_41 * by6_9 * stiffness;
    double by6_11 = 0.5 * by6_10;
    double by6_12 = by4_10 * by6_4 / by4_9;
    double by6_13 = (by6_2 - by4_11 * by6_4) / by4_9;
    double by6_14 = u_z * by6_12 + u_x * by6_13;
    double by6_15 = chi * by6_14 * by4_23 - by4_27 * by6_10 + (damping * by6_14 * by4_24 - (by6_9
        + by4_24 * by6_8) / by4_18 * by4_26) - by6_10;
    double by6_16 = Piecewise.choose(by4_50, -1.0, 0.0, Piecewise.choose(1.0, by4_49, 0.0, (by6_15
        + by4_49 * by6_11) / by4_48));
    double by6_17 = by4_56 * by6_16;
    double by6_18 = by4_58 * (by4_57 * by6_16 + by4_56 * (by6_17 + by6_17));
    double by6_19 = by4_59 * (by4_54 * by6_16 + by4_51 * (by4_53 * by6_16
        + by4_51 * (by4_52 * by6_16 + 7.0 * by6_16 * by4_51))) + by4_55 * (by6_18 + by6_18);
    double by6_20 = 0.001953125 * by6_19 * by4_29 - by4_60 * by6_11
        + Piecewise.choose(by4_30, 0.0, 0.0, by6_11 + by6_15);
    double by6_21 = friction * by6_20;
    double by6_22 = radius * (omega_z * by6_13 - omega_x * by6_12);
    double by6_23 = by4_12 * by6_22;
    double by6_24 = u_z * by6_13 - u_x * by6_12;
    double by6_25 = by4_13 * by6_24;
    double by6_26 = 0.5 * (by6_23 + by6_23 + (by6_25 + by6_25)) / by4_14;
    double by6_27 = Piecewise.choose(friction, 0.0, 0.0, -(by4_15 * by6_21 + (by6_22
        - by4_15 * by6_26) / by4_14 * by4_68));
    double by6_28 = radius * by6_27;
    double by6_29 = Piecewise.choose(friction, 0.0, 0.0, -(by4_77 * by6_21 + (by6_24
        - by4_77 * by6_26) / by4_14 * by4_68));
    out[5] = by4_10 * by6_28 - by4_76 * by6_12;
    out[11] = -(radius * by6_29);
    out[17] = by4_76 * by6_13 + by4_11 * by6_28;
    out[23] = by4_10 * by6_29 - by4_79 * by6_12 - (by4_67 * by6_13 + by4_11 * by6_20);
    out[29] = by6_27;
    out[35] = by4_10 * by6_20 - by4_67 * by6_12 + (by4_79 * by6_13 + by4_11 * by6_29);

    // Derivatives by motion 7.
    double by7_1 = radius * by4_10;
    double by7_2 = by4_12 * by7_1;
    double by7_3 = 0.5 * (by7_2 + by7_2) / by4_14;
    double by7_4 = Piecewise.choose(friction, 0.0, 0.0, -((by7_1
        - by4_15 * by7_3) / by4_14 * by4_68));
    double by7_5 = radius * by7_4;
    double by7_6 = Piecewise.choose(friction, 0.0, 0.0, by4_77 * by7_3 / by4_14 * by4_68);
    out[36] = by4_10 * by7_5;
    out[42] = -(radius * by7_6);
    out[48] = by4_11 * by7_5;
    out[54] = by4_10 * by7_6;
    out[60] = by7_4;
    out[66] = by4_11 * by7_6;

    // Derivatives by motion 8.
    double by8_1 = radius * by4_13;
    double by8_2 = 0.5 * (by8_1 + by8_1) / by4_14;
    double by8_3 = Piecewise.choose(friction, 0.0, 0.0, -(by4_15 * by8_2 / by4_14 * by4_68));
    double by8_4 = radius * by8_3;
    double by8_5 = Piecewise.choose(friction, 0.0, 0.0, -((by4_77 * by8_2
        - radius) / by4_14 * by4_68));
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
        - by4_15 * by9_3) / by4_14 * by4_68));
    double by9_5 = radius * by9_4;
    double by9_6 = Piecewise.choose(friction, 0.0, 0.0, by4_77 * by9_3 / by4_14 * by4_68);
    out[38] = by4_10 * by9_5;
    out[44] = -(radius * by9_6);
    out[50] = by4_11 * by9_5;
    out[56] = by4_10 * by9_6;
    out[62] = by9_4;
    out[68] = by4_11 * by9_6;

    // Derivatives by motion 10.
    double by10_1 = chi * by4_11 * by4_23 + damping * by4_11 * by4_24;
    double by10_2 = Piecewise.choose(by4_50, -1.0, 0.0, Piecewise.choose(1.0, by4_49, 0.0, by10_1
        / by4_48));
    double by10_3 = by4_56 * by10_2;
    double by10_4 = by4_58 * (by4_57 * by10_2 + by4_56 * (by10_3 + by10_3));
    double by10_5 = by4_59 * (by4_54 * by10_2 + by4_51 * (by4_53 * by10_2
        + by4_51 * (by4_52 * by10_2 + 7.0 * by10_2 * by4_51))) + by4_55 * (by10_4 + by10_4);
    double by10_6 = Piecewise.choose(by4_30, 0.0, 0.0, by10_1) + 0.001953125 * by10_5 * by4_29;
    double by10_7 = friction * by10_6;
    double by10_8 = by4_10 * by4_13;
    double by10_9 = 0.5 * (by10_8 + by10_8) / by4_14;
    double by10_10 = Piecewise.choose(friction, 0.0, 0.0, by4_15 * by10_9 / by4_14 * by4_68
        - by4_15 * by10_7);
    double by10_11 = radius * by10_10;
    double by10_12 = Piecewise.choose(friction, 0.0, 0.0, -(by4_77 * by10_7 + (by4_10
        - by4_77 * by10_9) / by4_14 * by4_68));
    out[39] = by4_10 * by10_11;
    out[45] = -(radius * by10_12);
    out[51] = by4_11 * by10_11;
    out[57] = by4_10 * by10_12 - by4_11 * by10_6;
    out[63] = by10_10;
    out[69] = by4_10 * by10_6 + by4_11 * by10_12;

    // Derivatives by motion 11.
    double by11_1 = 0.5 * (by4_12 + by4_12) / by4_14;
    double by11_2 = Piecewise.choose(friction, 0.0, 0.0, -((1.0
        - by4_15 * by11_1) / by4_14 * by4_68));
    double by11_3 = radius * by11_2;
    double by11_4 = Piecewise.choose(friction, 0.0, 0.0, by4_77 * by11_1 / by4_14 * by4_68);
    out[40] = by4_10 * by11_3;
    out[46] = -(radius * by11_4);
    out[52] = by4_11 * by11_3;
    out[58] = by4_10 * by11_4;
    out[64] = by11_2;
    out[70] = by4_11 * by11_4;

    // Derivatives by motion 12.
    double by12_1 = chi * by4_10 * by4_23 + damping * by4_10 * by4_24;
    double by12_2 = Piecewise.choose(by4_50, -1.0, 0.0, Piecewise.choose(1.0, by4_49, 0.0,
        -(by12_1 / by4_48)));
    double by12_3 = by4_56 * by12_2;
    double by12_4 = by4_58 * (by4_57 * by12_2 + by4_56 * (by12_3 + by12_3));
    double by12_5 = by4_59 * (by4_54 * by12_2 + by4_51 * (by4_53 * by12_2
        + by4_51 * (by4_52 * by12_2 + 7.0 * by12_2 * by4_51))) + by4_55 * (by12_4 + by12_4);
    double by12_6 = Piecewise.choose(by4_30, 0.0, 0.0, -by12_1) + 0.001953125 * by12_5 * by4_29;
    double by12_7 = friction * by12_6;
    double by12_8 = by4_11 * by4_13;
    double by12_9 = 0.5 * (by12_8 + by12_8) / by4_14;
    double by12_10 = Piecewise.choose(friction, 0.0, 0.0, by4_15 * by12_9 / by4_14 * by4_68
        - by4_15 * by12_7);
    double by12_11 = radius * by12_10;
    double by12_12 = Piecewise.choose(friction, 0.0, 0.0, -(by4_77 * by12_7 + (by4_11
        - by4_77 * by12_9) / by4_14 * by4_68));
    out[41] = by4_10 * by12_11;
    out[47] = -(radius * by12_12);
    out[53] = by4_11 * by12_11;
    out[59] = by4_10 * by12_12 - by4_11 * by12_6;
    out[65] = by12_10;
    out[71] = by4_10 * by12_6 + by4_11 * by12_12;
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
    double law_10 = Math.sqrt(law_9 * law_9 + c[14]);
    double law_11 = Math.abs(-law_9);
    double law_12 = c[13] / (law_10 + law_11) + 0.5 * (law_11 - law_9);
    double law_13 = law_12 * law_12;
    double law_14 = Powers.power(law_12, c[16]);
    double law_15 = 1.0 / law_8;
    double law_16 = law_7 / law_8;
    double law_17 = u_x * law_15 + u_z * law_16 - x[13] * radius;
    double law_18 = stiffness * Powers.power(law_12, exponent);
    double law_19 = 0.5 * law_18;
    double law_20 = u_x * law_16 - u_z * law_15;
    double law_21 = law_12 / law_10 * (c[2] * law_20) + c[3] * law_20 * law_18 + law_18;
    double law_22 = Math.max(-1.0, Math.min(1.0, law_21 / (1e-300 + law_19)));
    double law_23 = 1.0 + law_22;
    double law_24 = law_23 * law_23 * law_23;
    double law_25 = (63.0 + law_22 * (law_22 * (102.0 + law_22 * (7.0 * law_22 - 42.0))
        - 122.0)) * (law_24 * law_24) * 0.001953125 * law_19 + Math.max(0.0, law_21 - law_19);
    double law_26 = friction * law_25;
    double law_27 = x[16] + radius * (x[12] * law_15 + x[14] * law_16);
    double law_28 = Math.sqrt(law_17 * law_17 + law_27 * law_27 + c[15]);
    double law_29 = Piecewise.choose(friction, 0.0, 0.0, -(law_17 / law_28 * law_26));
    double law_30 = Piecewise.choose(friction, 0.0, 0.0, -(law_27 / law_28 * law_26));
    out[0] = stiffness * Piecewise.choose(exponent, 1.0, 0.5 * law_13
        + (StrictMath.log(law_12 * c[17]) - 0.5) * c[18], law_14 * c[19] + law_13 * law_14 * c[20]);
    out[1] = law_17 * law_29 + law_27 * law_30 - law_20 * (law_25 - law_18);
    out[2] = -law_9;
    out[3] = law_25;
    out[4] = law_29;
    out[5] = law_30;
  }

  @Override
  public void settle(double[] c, double[] out) {
    // What depends on coefficients alone.
    double c_5 = c[5];
    double c_7 = c[7];
    double c_4 = c[4];
    double c_1 = c_5 * c_5;
    double c_2 = c_4 - 1.0;
    double c_3 = 0.25 * c_1;
    out[13] = 0.5 * c_1;
    out[14] = c_1;
    out[15] = c_7 * c_7;
    out[16] = c_2;
    out[17] = 2.0 / c_5;
    out[18] = c_3;
    out[19] = c_3 / c_2;
    out[20] = 1.0 / (1.0 + c_4);
  }

  @Override
  public int size() {
    return 21;
  }
}
