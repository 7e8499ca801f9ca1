package org.mechservice.solver.force.law.printed;

import org.mechservice.solver.force.law.PrintedLaw;
import org.mechservice.solver.spatial.Piecewise;
import org.mechservice.solver.spatial.Powers;

/**
 * Printed from its formula; do not edit. PrintedLawsTest compares it with the formula and
 * prints it anew with -Dgolden.write=true.
 */
final class PrintedSmoothContact implements PrintedLaw {

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
    double law_18 = Math.sqrt(law_17 * law_17 + c[14]);
    double law_19 = Math.abs(law_17);
    double law_20 = c[13] / (law_18 + law_19) + 0.5 * (law_17 + law_19);
    double law_21 = c[1] * Powers.power(law_20, c[4]);
    double law_22 = 0.5 * law_21;
    double law_23 = Piecewise.choose(law_4, law_6, law_10 / law_11, -(law_13 / law_15));
    double law_24 = u_x * law_23 - u_z * law_16;
    double law_25 = law_20 / law_18 * (c[2] * law_24) + c[3] * law_24 * law_21 + law_21;
    double law_26 = Math.max(-1.0, Math.min(1.0, law_25 / (1e-300 + law_22)));
    double law_27 = 1.0 + law_26;
    double law_28 = law_27 * law_27 * law_27;
    double law_29 = (63.0 + law_26 * (law_26 * (102.0 + law_26 * (7.0 * law_26 - 42.0))
        - 122.0)) * (law_28 * law_28) * 0.001953125 * law_22 + Math.max(0.0, law_25 - law_22);
    double law_30 = friction * law_29;
    double law_31 = x[16] + radius * (x[12] * law_16 + x[14] * law_23);
    double law_32 = u_x * law_16 + u_z * law_23 - x[13] * radius;
    double law_33 = Math.sqrt(law_32 * law_32 + law_31 * law_31 + c[15]);
    double law_34 = Piecewise.choose(friction, 0.0, 0.0, -(law_31 / law_33 * law_30));
    double law_35 = radius * law_34;
    double law_36 = Piecewise.choose(friction, 0.0, 0.0, -(law_32 / law_33 * law_30));
    out[0] = law_16 * law_35;
    out[1] = -(radius * law_36);
    out[2] = law_23 * law_35;
    out[3] = law_16 * law_36 - law_23 * law_29;
    out[4] = law_34;
    out[5] = law_23 * law_36 + law_16 * law_29;
    out[6] = 1.0;
  }

  @Override
  public void slopes(double[] x, double[] c, double[] out) {
    // Derivatives by motion 4.
    double radius = c[0];
    double friction = c[6];
    double stiffness = c[1];
    double s = c[8];
    double r_x = x[0];
    double slope = c[10];
    double height = c[9];
    double r_z = x[2];
    double bend = c[11];
    double exponent = c[4];
    double damping = c[2];
    double u_x = x[15];
    double u_z = x[17];
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
    double by4_21 = Math.sqrt(by4_20 * by4_20 + c[14]);
    double by4_22 = Math.abs(by4_20);
    double by4_23 = by4_21 + by4_22;
    double by4_24 = c[13] / by4_23;
    double by4_25 = by4_24 + 0.5 * (by4_20 + by4_22);
    double by4_26 = stiffness * Powers.power(by4_25, exponent);
    double by4_27 = 0.5 * by4_26;
    double by4_28 = by4_25 / by4_21;
    double by4_29 = by4_12 / by4_14;
    double by4_30 = by4_13 / by4_19;
    double by4_31 = Piecewise.choose(by4_4, by4_6, by4_29, -by4_30);
    double by4_32 = 1.0 / by4_14;
    double by4_33 = by4_11 / by4_19;
    double by4_34 = Piecewise.choose(by4_4, by4_6, by4_32, by4_33);
    double by4_35 = u_x * by4_31 - u_z * by4_34;
    double by4_36 = damping * by4_35;
    double by4_37 = chi * by4_35;
    double by4_38 = by4_28 * by4_36 + by4_26 * by4_37 + by4_26;
    double by4_39 = 1e-300 + by4_27;
    double by4_40 = by4_38 / by4_39;
    double by4_41 = Math.min(1.0, by4_40);
    double by4_42 = Math.max(-1.0, by4_41);
    double by4_43 = 7.0 * by4_42 - 42.0;
    double by4_44 = 102.0 + by4_42 * by4_43;
    double by4_45 = by4_42 * by4_44 - 122.0;
    double by4_46 = 63.0 + by4_42 * by4_45;
    double by4_47 = 1.0 + by4_42;
    double by4_48 = by4_47 * by4_47;
    double by4_49 = by4_47 * by4_48;
    double by4_50 = by4_49 * by4_49;
    double by4_51 = by4_46 * by4_50 * 0.001953125;
    double by4_52 = by4_38 - by4_27;
    double by4_53 = by4_27 * by4_51 + Math.max(0.0, by4_52);
    double by4_54 = friction * by4_53;
    double by4_55 = x[16] + radius * (omega_x * by4_34 + omega_z * by4_31);
    double by4_56 = u_x * by4_34 + u_z * by4_31 - x[13] * radius;
    double by4_57 = Math.sqrt(by4_56 * by4_56 + by4_55 * by4_55 + c[15]);
    double by4_58 = by4_55 / by4_57;
    double by4_59 = radius * Piecewise.choose(friction, 0.0, 0.0, -(by4_54 * by4_58));
    double by4_60 = 1.0 / by4_9;
    double by4_61 = bend * by4_60;
    double by4_62 = by4_12 * by4_61;
    double by4_63 = 0.5 * (by4_62 + by4_62) / by4_14;
    double by4_64 = slope * by4_60;
    double by4_65 = 1.0 - by4_60;
    double by4_66 = by4_13 * by4_65;
    double by4_67 = by4_11 * by4_64;
    double by4_68 = 0.5 * (by4_66 + by4_66 - (by4_67 + by4_67)) / by4_18;
    double by4_69 = Piecewise.choose(by4_16, by4_17, -by4_68, by4_68);
    double by4_70 = Piecewise.choose(by4_4, by4_6, -(by4_32 * by4_63 / by4_14), -((by4_64
        + by4_33 * by4_69) / by4_19));
    double by4_71 = Piecewise.choose(by4_4, by4_6, -((by4_13 * by4_61 + by4_12 * by4_65 + by4_64
        + by4_15 * by4_63) / by4_14), by4_69);
    double by4_72 = Math.signum(by4_20);
    double by4_73 = by4_71 * by4_72;
    double by4_74 = by4_20 * by4_71;
    double by4_75 = 0.5 * (by4_74 + by4_74) / by4_21;
    double by4_76 = by4_24 * (by4_73 + by4_75) / by4_23 - 0.5 * (by4_71 + by4_73);
    double by4_77 = Piecewise.product(exponent, Powers.power(by4_25, c[16]));
    double by4_78 = by4_76 * by4_77 * stiffness;
    double by4_79 = Piecewise.choose(by4_4, by4_6, (by4_61 - by4_29 * by4_63) / by4_14, -((by4_65
        - by4_30 * by4_69) / by4_19));
    double by4_80 = u_x * by4_79 - u_z * by4_70;
    double by4_81 = by4_37 * by4_78 + chi * by4_80 * by4_26 + ((by4_76
        + by4_28 * by4_75) / by4_21 * by4_36 + damping * by4_80 * by4_28) + by4_78;
    double by4_82 = 0.5 * by4_78;
    double by4_83 = Piecewise.choose(by4_41, -1.0, 0.0, Piecewise.choose(1.0, by4_40, 0.0, (by4_81
        - by4_40 * by4_82) / by4_39));
    double by4_84 = by4_47 * by4_83;
    double by4_85 = by4_49 * (by4_48 * by4_83 + by4_47 * (by4_84 + by4_84));
    double by4_86 = by4_50 * (by4_45 * by4_83 + by4_42 * (by4_44 * by4_83
        + by4_42 * (by4_43 * by4_83 + 7.0 * by4_83 * by4_42))) + by4_46 * (by4_85 + by4_85);
    double by4_87 = by4_51 * by4_82 + 0.001953125 * by4_86 * by4_27
        + Piecewise.choose(by4_52, 0.0, 0.0, by4_81 - by4_82);
    double by4_88 = friction * by4_87;
    double by4_89 = radius * (omega_z * by4_79 + omega_x * by4_70);
    double by4_90 = by4_55 * by4_89;
    double by4_91 = u_z * by4_79 + u_x * by4_70;
    double by4_92 = by4_56 * by4_91;
    double by4_93 = 0.5 * (by4_90 + by4_90 + (by4_92 + by4_92)) / by4_57;
    double by4_94 = Piecewise.choose(friction, 0.0, 0.0, -(by4_58 * by4_88 + (by4_89
        - by4_58 * by4_93) / by4_57 * by4_54));
    double by4_95 = radius * by4_94;
    double by4_96 = by4_56 / by4_57;
    double by4_97 = Piecewise.choose(friction, 0.0, 0.0, -(by4_96 * by4_88 + (by4_91
        - by4_96 * by4_93) / by4_57 * by4_54));
    double by4_98 = Piecewise.choose(friction, 0.0, 0.0, -(by4_54 * by4_96));
    out[3] = by4_59 * by4_70 + by4_34 * by4_95;
    out[9] = -(radius * by4_97);
    out[15] = by4_59 * by4_79 + by4_31 * by4_95;
    out[21] = by4_98 * by4_70 + by4_34 * by4_97 - (by4_53 * by4_79 + by4_31 * by4_87);
    out[27] = by4_94;
    out[33] = by4_53 * by4_70 + by4_34 * by4_87 + (by4_98 * by4_79 + by4_31 * by4_97);

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
    double by6_10 = Piecewise.choose(by4_4, by4_6, -(by4_32 * by6_4 / by4_14), (by6_5
        - by4_33 * by6_9) / by4_19);
    double by6_11 = Piecewise.choose(by4_4, by4_6, (by6_5 - (by4_13 * by6_2 - by4_12 * by6_1)
        - by4_15 * by6_4) / by4_14, by6_9);
    double by6_12 = by4_72 * by6_11;
    double by6_13 = by4_20 * by6_11;
    double by6_14 = 0.5 * (by6_13 + by6_13) / by4_21;
    double by6_15 = by4_24 * (by6_12 + by6_14) / by4_23 - 0.5 * (by6_11 + by6_12);
    double by6_16 = by4_77 * by6_15 * stiffness;
    double by6_17 = Piecewise.choose(by4_4, by4_6, (by6_2 - by4_29 * by6_4) / by4_14, (by6_1
        + by4_30 * by6_9) / by4_19);
    double by6_18 = u_x * by6_17 - u_z * by6_10;
    double by6_19 = by4_37 * by6_16 + chi * by6_18 * by4_26 + ((by6_15
        + by4_28 * by6_14) / by4_21 * by4_36 + damping * by6_18 * by4_28) + by6_16;
    double by6_20 = 0.5 * by6_16;
    double by6_21 = Piecewise.choose(by4_41, -1.0, 0.0, Piecewise.choose(1.0, by4_40, 0.0, (by6_19
        - by4_40 * by6_20) / by4_39));
    double by6_22 = by4_47 * by6_21;
    double by6_23 = by4_49 * (by4_48 * by6_21 + by4_47 * (by6_22 + by6_22));
    double by6_24 = by4_50 * (by4_45 * by6_21 + by4_42 * (by4_44 * by6_21
        + by4_42 * (by4_43 * by6_21 + 7.0 * by6_21 * by4_42))) + by4_46 * (by6_23 + by6_23);
    double by6_25 = by4_51 * by6_20 + 0.001953125 * by6_24 * by4_27
        + Piecewise.choose(by4_52, 0.0, 0.0, by6_19 - by6_20);
    double by6_26 = friction * by6_25;
    double by6_27 = radius * (omega_z * by6_17 + omega_x * by6_10);
    double by6_28 = by4_55 * by6_27;
    double by6_29 = u_z * by6_17 + u_x * by6_10;
    double by6_30 = by4_56 * by6_29;
    double by6_31 = 0.5 * (by6_28 + by6_28 + (by6_30 + by6_30)) / by4_57;
    double by6_32 = Piecewise.choose(friction, 0.0, 0.0, -(by4_58 * by6_26 + (by6_27
        - by4_58 * by6_31) / by4_57 * by4_54));
    double by6_33 = radius * by6_32;
    double by6_34 = Piecewise.choose(friction, 0.0, 0.0, -(by4_96 * by6_26 + (by6_29
        - by4_96 * by6_31) / by4_57 * by4_54));
    out[5] = by4_59 * by6_10 + by4_34 * by6_33;
    out[11] = -(radius * by6_34);
    out[17] = by4_59 * by6_17 + by4_31 * by6_33;
    out[23] = by4_98 * by6_10 + by4_34 * by6_34 - (by4_53 * by6_17 + by4_31 * by6_25);
    out[29] = by6_32;
    out[35] = by4_53 * by6_10 + by4_34 * by6_25 + (by4_98 * by6_17 + by4_31 * by6_34);

    // Derivatives by motion 7.
    double by7_1 = radius * by4_34;
    double by7_2 = by4_55 * by7_1;
    double by7_3 = 0.5 * (by7_2 + by7_2) / by4_57;
    double by7_4 = Piecewise.choose(friction, 0.0, 0.0, -((by7_1
        - by4_58 * by7_3) / by4_57 * by4_54));
    double by7_5 = radius * by7_4;
    double by7_6 = Piecewise.choose(friction, 0.0, 0.0, by4_96 * by7_3 / by4_57 * by4_54);
    out[36] = by4_34 * by7_5;
    out[42] = -(radius * by7_6);
    out[48] = by4_31 * by7_5;
    out[54] = by4_34 * by7_6;
    out[60] = by7_4;
    out[66] = by4_31 * by7_6;

    // Derivatives by motion 8.
    double by8_1 = radius * by4_56;
    double by8_2 = 0.5 * (by8_1 + by8_1) / by4_57;
    double by8_3 = Piecewise.choose(friction, 0.0, 0.0, -(by4_58 * by8_2 / by4_57 * by4_54));
    double by8_4 = radius * by8_3;
    double by8_5 = Piecewise.choose(friction, 0.0, 0.0, -((by4_96 * by8_2
        - radius) / by4_57 * by4_54));
    out[37] = by4_34 * by8_4;
    out[43] = -(radius * by8_5);
    out[49] = by4_31 * by8_4;
    out[55] = by4_34 * by8_5;
    out[61] = by8_3;
    out[67] = by4_31 * by8_5;

    // Derivatives by motion 9.
    double by9_1 = radius * by4_31;
    double by9_2 = by4_55 * by9_1;
    double by9_3 = 0.5 * (by9_2 + by9_2) / by4_57;
    double by9_4 = Piecewise.choose(friction, 0.0, 0.0, -((by9_1
        - by4_58 * by9_3) / by4_57 * by4_54));
    double by9_5 = radius * by9_4;
    double by9_6 = Piecewise.choose(friction, 0.0, 0.0, by4_96 * by9_3 / by4_57 * by4_54);
    out[38] = by4_34 * by9_5;
    out[44] = -(radius * by9_6);
    out[50] = by4_31 * by9_5;
    out[56] = by4_34 * by9_6;
    out[62] = by9_4;
    out[68] = by4_31 * by9_6;

    // Derivatives by motion 10.
    double by10_1 = chi * by4_31 * by4_26 + damping * by4_31 * by4_28;
    double by10_2 = Piecewise.choose(by4_41, -1.0, 0.0, Piecewise.choose(1.0, by4_40, 0.0, by10_1
        / by4_39));
    double by10_3 = by4_47 * by10_2;
    double by10_4 = by4_49 * (by4_48 * by10_2 + by4_47 * (by10_3 + by10_3));
    double by10_5 = by4_50 * (by4_45 * by10_2 + by4_42 * (by4_44 * by10_2
        + by4_42 * (by4_43 * by10_2 + 7.0 * by10_2 * by4_42))) + by4_46 * (by10_4 + by10_4);
    double by10_6 = Piecewise.choose(by4_52, 0.0, 0.0, by10_1) + 0.001953125 * by10_5 * by4_27;
    double by10_7 = friction * by10_6;
    double by10_8 = by4_34 * by4_56;
    double by10_9 = 0.5 * (by10_8 + by10_8) / by4_57;
    double by10_10 = Piecewise.choose(friction, 0.0, 0.0, by4_58 * by10_9 / by4_57 * by4_54
        - by4_58 * by10_7);
    double by10_11 = radius * by10_10;
    double by10_12 = Piecewise.choose(friction, 0.0, 0.0, -(by4_96 * by10_7 + (by4_34
        - by4_96 * by10_9) / by4_57 * by4_54));
    out[39] = by4_34 * by10_11;
    out[45] = -(radius * by10_12);
    out[51] = by4_31 * by10_11;
    out[57] = by4_34 * by10_12 - by4_31 * by10_6;
    out[63] = by10_10;
    out[69] = by4_34 * by10_6 + by4_31 * by10_12;

    // Derivatives by motion 11.
    double by11_1 = 0.5 * (by4_55 + by4_55) / by4_57;
    double by11_2 = Piecewise.choose(friction, 0.0, 0.0, -((1.0
        - by4_58 * by11_1) / by4_57 * by4_54));
    double by11_3 = radius * by11_2;
    double by11_4 = Piecewise.choose(friction, 0.0, 0.0, by4_96 * by11_1 / by4_57 * by4_54);
    out[40] = by4_34 * by11_3;
    out[46] = -(radius * by11_4);
    out[52] = by4_31 * by11_3;
    out[58] = by4_34 * by11_4;
    out[64] = by11_2;
    out[70] = by4_31 * by11_4;

    // Derivatives by motion 12.
    double by12_1 = chi * by4_34 * by4_26 + damping * by4_34 * by4_28;
    double by12_2 = Piecewise.choose(by4_41, -1.0, 0.0, Piecewise.choose(1.0, by4_40, 0.0,
        -(by12_1 / by4_39)));
    double by12_3 = by4_47 * by12_2;
    double by12_4 = by4_49 * (by4_48 * by12_2 + by4_47 * (by12_3 + by12_3));
    double by12_5 = by4_50 * (by4_45 * by12_2 + by4_42 * (by4_44 * by12_2
        + by4_42 * (by4_43 * by12_2 + 7.0 * by12_2 * by4_42))) + by4_46 * (by12_4 + by12_4);
    double by12_6 = Piecewise.choose(by4_52, 0.0, 0.0, -by12_1) + 0.001953125 * by12_5 * by4_27;
    double by12_7 = friction * by12_6;
    double by12_8 = by4_31 * by4_56;
    double by12_9 = 0.5 * (by12_8 + by12_8) / by4_57;
    double by12_10 = Piecewise.choose(friction, 0.0, 0.0, by4_58 * by12_9 / by4_57 * by4_54
        - by4_58 * by12_7);
    double by12_11 = radius * by12_10;
    double by12_12 = Piecewise.choose(friction, 0.0, 0.0, -(by4_96 * by12_7 + (by4_31
        - by4_96 * by12_9) / by4_57 * by4_54));
    out[41] = by4_34 * by12_11;
    out[47] = -(radius * by12_12);
    out[53] = by4_31 * by12_11;
    out[59] = by4_34 * by12_12 - by4_31 * by12_6;
    out[65] = by12_10;
    out[71] = by4_34 * by12_6 + by4_31 * by12_12;
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
    double law_17 = Math.sqrt(law_16 * law_16 + c[14]);
    double law_18 = Math.abs(law_16);
    double law_19 = c[13] / (law_17 + law_18) + 0.5 * (law_16 + law_18);
    double law_20 = law_19 * law_19;
    double law_21 = Powers.power(law_19, c[16]);
    double law_22 = Piecewise.choose(law_4, law_6, 1.0 / law_13, law_10 / law_15);
    double law_23 = Piecewise.choose(law_4, law_6, law_11 / law_13, -(law_12 / law_15));
    double law_24 = u_x * law_22 + u_z * law_23 - x[13] * radius;
    double law_25 = stiffness * Powers.power(law_19, exponent);
    double law_26 = 0.5 * law_25;
    double law_27 = u_x * law_23 - u_z * law_22;
    double law_28 = law_19 / law_17 * (c[2] * law_27) + c[3] * law_27 * law_25 + law_25;
    double law_29 = Math.max(-1.0, Math.min(1.0, law_28 / (1e-300 + law_26)));
    double law_30 = 1.0 + law_29;
    double law_31 = law_30 * law_30 * law_30;
    double law_32 = (63.0 + law_29 * (law_29 * (102.0 + law_29 * (7.0 * law_29 - 42.0))
        - 122.0)) * (law_31 * law_31) * 0.001953125 * law_26 + Math.max(0.0, law_28 - law_26);
    double law_33 = friction * law_32;
    double law_34 = x[16] + radius * (x[12] * law_22 + x[14] * law_23);
    double law_35 = Math.sqrt(law_24 * law_24 + law_34 * law_34 + c[15]);
    double law_36 = Piecewise.choose(friction, 0.0, 0.0, -(law_24 / law_35 * law_33));
    double law_37 = Piecewise.choose(friction, 0.0, 0.0, -(law_34 / law_35 * law_33));
    out[0] = stiffness * Piecewise.choose(exponent, 1.0, 0.5 * law_20
        + (StrictMath.log(law_19 * c[17]) - 0.5) * c[18], law_21 * c[19] + law_20 * law_21 * c[20]);
    out[1] = law_24 * law_36 + law_34 * law_37 - law_27 * (law_32 - law_25);
    out[2] = law_16;
    out[3] = law_32;
    out[4] = law_36;
    out[5] = law_37;
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
