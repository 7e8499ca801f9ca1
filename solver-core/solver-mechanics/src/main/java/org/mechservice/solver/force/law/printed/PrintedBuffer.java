package org.mechservice.solver.force.law.printed;

import org.mechservice.solver.force.law.PrintedLaw;
import org.mechservice.solver.spatial.Piecewise;

/**
 * Printed from its formula; do not edit. PrintedLawsTest compares it with the formula and
 * prints it anew with -Dgolden.write=true.
 */
final class PrintedBuffer implements PrintedLaw {

  @Override
  public void load(double[] x, double[] c, double[] out) {
    // The load by its formula.
    double r_x = x[0];
    double r_y = x[1];
    double r_z = x[2];
    double u_x = x[15];
    double u_y = x[16];
    double u_z = x[17];
    double stiffness = c[0];
    double damping = c[1];
    double rest = c[2];
    double eps = c[4];
    double chi = c[5];
    double law_1 = Math.sqrt(r_x * r_x + r_y * r_y + r_z * r_z);
    double law_2 = eps * eps;
    double law_3 = Math.sqrt(rest * rest + law_2);
    double law_4 = Piecewise.choose(0.0, rest, rest, 0.0);
    double law_5 = 0.5 * eps;
    double law_6 = Piecewise.choose(eps, 0.0, law_4, Piecewise.choose(0.0, rest, 0.5 * (rest
        + law_3), eps / (law_3 - rest) * law_5));
    double law_7 = stiffness * law_6;
    double law_8 = 0.5 * law_7;
    double law_9 = 1e-300 + law_8;
    double law_10 = Math.max(-1.0, Math.min(1.0, law_7 / law_9));
    double law_11 = 1.0 + law_10;
    double law_12 = law_11 * law_11 * law_11;
    double law_13 = (63.0 + law_10 * (law_10 * (102.0 + law_10 * (7.0 * law_10 - 42.0))
        - 122.0)) * (law_12 * law_12) * 0.001953125 * law_8 + Math.max(0.0, law_7 - law_8);
    double law_14 = stiffness * law_4;
    double law_15 = Piecewise.choose(Math.abs(-Piecewise.choose(eps, 0.0, Piecewise.choose(rest,
        0.0, 0.0, Math.max(0.0, law_14)), law_13)), 1e-9 * (Math.abs(stiffness) * (eps
        + Math.abs(rest)) + Math.abs(c[3])), 1.0, 0.0);
    double law_16 = Piecewise.choose(law_1, 0.0, Math.sqrt(u_x * u_x + u_y * u_y
        + u_z * u_z), (r_x * u_x + r_y * u_y + r_z * u_z) / law_1);
    double law_17 = law_1 - rest;
    double law_18 = Math.sqrt(law_2 + law_17 * law_17);
    double law_19 = Piecewise.choose(0.0, -law_17, -law_17, 0.0);
    double law_20 = Piecewise.choose(eps, 0.0, law_19, Piecewise.choose(0.0, -law_17, 0.5 * (law_18
        - law_17), eps / (law_17 + law_18) * law_5));
    double law_21 = stiffness * law_20;
    double law_22 = damping * law_16;
    double law_23 = chi * law_16;
    double law_24 = law_21 - (law_20 / law_18 * law_22 + law_21 * law_23);
    double law_25 = 0.5 * law_21;
    double law_26 = Math.max(-1.0, Math.min(1.0, law_24 / (1e-300 + law_25)));
    double law_27 = 1.0 + law_26;
    double law_28 = law_27 * law_27 * law_27;
    double law_29 = (63.0 + law_26 * (law_26 * (102.0 + law_26 * (7.0 * law_26 - 42.0))
        - 122.0)) * (law_28 * law_28) * 0.001953125 * law_25 + Math.max(0.0, law_24 - law_25);
    double law_30 = stiffness * law_19;
    double law_31 = Piecewise.choose(eps, 0.0, Piecewise.choose(-law_17, 0.0, Piecewise.choose(0.0,
        -law_17, Math.max(0.0, -(0.5 * law_22)), 0.0), Math.max(0.0, law_30 - (law_22
        + law_23 * law_30))), law_29);
    double law_32 = law_7 - (law_6 / law_3 * damping + chi * law_7);
    double law_33 = Math.max(-1.0, Math.min(1.0, law_32 / law_9));
    double law_34 = 1.0 + law_33;
    double law_35 = law_34 * law_34 * law_34;
    double law_36 = (63.0 + law_33 * (law_33 * (102.0 + law_33 * (7.0 * law_33 - 42.0))
        - 122.0)) * (law_35 * law_35) * 0.001953125 * law_8 + Math.max(0.0, law_32 - law_8);
    double law_37 = Piecewise.choose(eps, 0.0, Piecewise.choose(rest, 0.0, Piecewise.choose(0.0,
        rest, Math.max(0.0, -(0.5 * damping)), 0.0), Math.max(0.0, law_14 - (damping
        + chi * law_14))), law_36);
    double law_38 = 1e-300 - rest;
    double law_39 = Piecewise.choose(0.0, -law_38, -law_38, 0.0);
    double law_40 = Piecewise.choose(0.0, -law_38, -1.0, 0.0);
    double law_41 = Math.sqrt(law_2 + law_38 * law_38);
    double law_42 = law_38 + law_41;
    double law_43 = eps / law_42;
    double law_44 = stiffness * Piecewise.choose(eps, 0.0, law_39, Piecewise.choose(0.0,
        -law_38, 0.5 * (law_41 - law_38), law_5 * law_43));
    double law_45 = 0.5 * law_44;
    double law_46 = 0.5 * (law_38 + law_38) / law_41;
    double law_47 = stiffness * Piecewise.choose(eps, 0.0, law_40, Piecewise.choose(0.0,
        -law_38, 0.5 * (law_46 - 1.0), -(law_43 * (1.0 + law_46) / law_42 * law_5)));
    double law_48 = 0.5 * law_47;
    double law_49 = 1e-300 + law_45;
    double law_50 = law_44 / law_49;
    double law_51 = Math.min(1.0, law_50);
    double law_52 = Math.max(-1.0, law_51);
    double law_53 = 7.0 * law_52 - 42.0;
    double law_54 = 102.0 + law_52 * law_53;
    double law_55 = law_52 * law_54 - 122.0;
    double law_56 = 63.0 + law_52 * law_55;
    double law_57 = 1.0 + law_52;
    double law_58 = law_57 * law_57;
    double law_59 = law_57 * law_58;
    double law_60 = law_59 * law_59;
    double law_61 = Piecewise.choose(law_51, -1.0, 0.0, Piecewise.choose(1.0, law_50, 0.0, (law_47
        - law_48 * law_50) / law_49));
    double law_62 = law_57 * law_61;
    double law_63 = law_59 * (law_58 * law_61 + law_57 * (law_62 + law_62));
    double law_64 = law_60 * (law_55 * law_61 + law_52 * (law_54 * law_61
        + law_52 * (law_53 * law_61 + 7.0 * law_61 * law_52))) + law_56 * (law_63 + law_63);
    double law_65 = Piecewise.choose(eps, 0.0, Piecewise.choose(-law_38, 0.0, 0.0,
        Piecewise.choose(stiffness * law_39, 0.0, 0.0, stiffness * law_40)), law_56 * law_60
        * 0.001953125 * law_48 + 0.001953125 * law_64 * law_45 + Piecewise.choose(law_44
        - law_45, 0.0, 0.0, law_47 - law_48));
    double law_66 = Piecewise.choose(law_1, 0.0, law_65, law_31 / law_1);
    double law_67 = Piecewise.choose(law_1, 0.0, law_37 - law_7, 0.0);
    out[0] = 0.0;
    out[1] = 0.0;
    out[2] = 0.0;
    out[3] = r_x * law_66 + u_x * law_67;
    out[4] = r_y * law_66 + u_y * law_67;
    out[5] = r_z * law_66 + u_z * law_67;
    out[6] = Piecewise.choose(1.0, law_15, 1.0, law_1);
  }

  @Override
  public void slopes(double[] x, double[] c, double[] out) {
    // The load by its formula.
    double r_x = x[0];
    double r_y = x[1];
    double r_z = x[2];
    double u_x = x[15];
    double u_y = x[16];
    double u_z = x[17];
    double stiffness = c[0];
    double damping = c[1];
    double rest = c[2];
    double eps = c[4];
    double chi = c[5];
    double law_1 = Math.sqrt(r_x * r_x + r_y * r_y + r_z * r_z);
    double law_2 = eps * eps;
    double law_3 = Math.sqrt(rest * rest + law_2);
    double law_4 = Piecewise.choose(0.0, rest, rest, 0.0);
    double law_5 = 0.5 * eps;
    double law_6 = Piecewise.choose(eps, 0.0, law_4, Piecewise.choose(0.0, rest, 0.5 * (rest
        + law_3), eps / (law_3 - rest) * law_5));
    double law_7 = stiffness * law_6;
    double law_8 = 0.5 * law_7;
    double law_9 = stiffness * law_4;
    double law_10 = (r_x * u_x + r_y * u_y + r_z * u_z) / law_1;
    double law_11 = Math.sqrt(u_x * u_x + u_y * u_y + u_z * u_z);
    double law_12 = Piecewise.choose(law_1, 0.0, law_11, law_10);
    double law_13 = law_1 - rest;
    double law_14 = Math.sqrt(law_2 + law_13 * law_13);
    double law_15 = Piecewise.choose(0.0, -law_13, -law_13, 0.0);
    double law_16 = law_13 + law_14;
    double law_17 = eps / law_16;
    double law_18 = Piecewise.choose(eps, 0.0, law_15, Piecewise.choose(0.0, -law_13, 0.5 * (law_14
        - law_13), law_5 * law_17));
    double law_19 = stiffness * law_18;
    double law_20 = law_18 / law_14;
    double law_21 = damping * law_12;
    double law_22 = chi * law_12;
    double law_23 = law_19 - (law_20 * law_21 + law_19 * law_22);
    double law_24 = 0.5 * law_19;
    double law_25 = 1e-300 + law_24;
    double law_26 = law_23 / law_25;
    double law_27 = Math.min(1.0, law_26);
    double law_28 = Math.max(-1.0, law_27);
    double law_29 = 1.0 + law_28;
    double law_30 = law_29 * law_29;
    double law_31 = law_29 * law_30;
    double law_32 = 7.0 * law_28 - 42.0;
    double law_33 = 102.0 + law_28 * law_32;
    double law_34 = law_28 * law_33 - 122.0;
    double law_35 = 63.0 + law_28 * law_34;
    double law_36 = law_31 * law_31;
    double law_37 = law_35 * law_36 * 0.001953125;
    double law_38 = law_23 - law_24;
    double law_39 = stiffness * law_15;
    double law_40 = law_39 - (law_21 + law_22 * law_39);
    double law_41 = 0.5 * law_21;
    double law_42 = Piecewise.choose(eps, 0.0, Piecewise.choose(-law_13, 0.0, Piecewise.choose(0.0,
        -law_13, Math.max(0.0, -law_41), 0.0), Math.max(0.0, law_40)), law_24 * law_37
        + Math.max(0.0, law_38));
    double law_43 = law_42 / law_1;
    double law_44 = law_7 - (law_6 / law_3 * damping + chi * law_7);
    double law_45 = Math.max(-1.0, Math.min(1.0, law_44 / (1e-300 + law_8)));
    double law_46 = 1.0 + law_45;
    double law_47 = law_46 * law_46 * law_46;
    double law_48 = (63.0 + law_45 * (law_45 * (102.0 + law_45 * (7.0 * law_45 - 42.0))
        - 122.0)) * (law_47 * law_47) * 0.001953125 * law_8 + Math.max(0.0, law_44 - law_8);
    double law_49 = Piecewise.choose(eps, 0.0, Piecewise.choose(rest, 0.0, Piecewise.choose(0.0,
        rest, Math.max(0.0, -(0.5 * damping)), 0.0), Math.max(0.0, law_9 - (damping
        + chi * law_9))), law_48);
    double law_50 = 1e-300 - rest;
    double law_51 = Piecewise.choose(0.0, -law_50, -law_50, 0.0);
    double law_52 = Piecewise.choose(0.0, -law_50, -1.0, 0.0);
    double law_53 = Math.sqrt(law_2 + law_50 * law_50);
    double law_54 = law_50 + law_53;
    double law_55 = eps / law_54;
    double law_56 = stiffness * Piecewise.choose(eps, 0.0, law_51, Piecewise.choose(0.0,
        -law_50, 0.5 * (law_53 - law_50), law_5 * law_55));
    double law_57 = 0.5 * law_56;
    double law_58 = 0.5 * (law_50 + law_50) / law_53;
    double law_59 = stiffness * Piecewise.choose(eps, 0.0, law_52, Piecewise.choose(0.0,
        -law_50, 0.5 * (law_58 - 1.0), -(law_55 * (1.0 + law_58) / law_54 * law_5)));
    double law_60 = 0.5 * law_59;
    double law_61 = 1e-300 + law_57;
    double law_62 = law_56 / law_61;
    double law_63 = Math.min(1.0, law_62);
    double law_64 = Math.max(-1.0, law_63);
    double law_65 = 7.0 * law_64 - 42.0;
    double law_66 = 102.0 + law_64 * law_65;
    double law_67 = law_64 * law_66 - 122.0;
    double law_68 = 63.0 + law_64 * law_67;
    double law_69 = 1.0 + law_64;
    double law_70 = law_69 * law_69;
    double law_71 = law_69 * law_70;
    double law_72 = law_71 * law_71;
    double law_73 = Piecewise.choose(law_63, -1.0, 0.0, Piecewise.choose(1.0, law_62, 0.0, (law_59
        - law_60 * law_62) / law_61));
    double law_74 = law_69 * law_73;
    double law_75 = law_71 * (law_70 * law_73 + law_69 * (law_74 + law_74));
    double law_76 = law_72 * (law_67 * law_73 + law_64 * (law_66 * law_73
        + law_64 * (law_65 * law_73 + 7.0 * law_73 * law_64))) + law_68 * (law_75 + law_75);
    double law_77 = Piecewise.choose(eps, 0.0, Piecewise.choose(-law_50, 0.0, 0.0,
        Piecewise.choose(stiffness * law_51, 0.0, 0.0, stiffness * law_52)), law_68 * law_72
        * 0.001953125 * law_60 + 0.001953125 * law_76 * law_57 + Piecewise.choose(law_56
        - law_57, 0.0, 0.0, law_59 - law_60));
    double law_78 = Piecewise.choose(law_1, 0.0, law_77, law_43);
    double law_79 = Piecewise.choose(law_1, 0.0, law_49 - law_7, 0.0);

    // Derivatives by motion 4.
    double by4_1 = 0.5 * (r_x + r_x) / law_1;
    double by4_2 = law_13 * by4_1;
    double by4_3 = 0.5 * (by4_2 + by4_2) / law_14;
    double by4_4 = Piecewise.choose(0.0, -law_13, -by4_1, 0.0);
    double by4_5 = Piecewise.choose(eps, 0.0, by4_4, Piecewise.choose(0.0, -law_13, 0.5 * (by4_3
        - by4_1), -(law_17 * (by4_1 + by4_3) / law_16 * law_5)));
    double by4_6 = stiffness * by4_5;
    double by4_7 = 0.5 * by4_6;
    double by4_8 = Piecewise.choose(law_1, 0.0, 0.0, (u_x - law_10 * by4_1) / law_1);
    double by4_9 = chi * by4_8;
    double by4_10 = damping * by4_8;
    double by4_11 = by4_6 - (law_22 * by4_6 + law_19 * by4_9 + ((by4_5
        - law_20 * by4_3) / law_14 * law_21 + law_20 * by4_10));
    double by4_12 = Piecewise.choose(law_27, -1.0, 0.0, Piecewise.choose(1.0, law_26, 0.0, (by4_11
        - law_26 * by4_7) / law_25));
    double by4_13 = law_29 * by4_12;
    double by4_14 = law_31 * (law_30 * by4_12 + law_29 * (by4_13 + by4_13));
    double by4_15 = law_36 * (law_34 * by4_12 + law_28 * (law_33 * by4_12
        + law_28 * (law_32 * by4_12 + 7.0 * by4_12 * law_28))) + law_35 * (by4_14 + by4_14);
    double by4_16 = stiffness * by4_4;
    double by4_17 = Piecewise.choose(-law_13, 0.0, Piecewise.choose(0.0,
        -law_13, Piecewise.choose(-law_41, 0.0, 0.0, -(0.5 * by4_10)), 0.0),
        Piecewise.choose(law_40, 0.0, 0.0, by4_16 - (law_39 * by4_9 + law_22 * by4_16 + by4_10)));
    double by4_18 = Piecewise.choose(eps, 0.0, by4_17, law_37 * by4_7
        + 0.001953125 * by4_15 * law_24 + Piecewise.choose(law_38, 0.0, 0.0, by4_11 - by4_7))
        - law_43 * by4_1;
    double by4_19 = Piecewise.choose(law_1, 0.0, 0.0, by4_18 / law_1);
    out[39] = law_78 + r_x * by4_19;
    out[51] = r_y * by4_19;
    out[63] = r_z * by4_19;

    // Derivatives by motion 5.
    double by5_1 = 0.5 * (r_y + r_y) / law_1;
    double by5_2 = law_13 * by5_1;
    double by5_3 = 0.5 * (by5_2 + by5_2) / law_14;
    double by5_4 = Piecewise.choose(0.0, -law_13, -by5_1, 0.0);
    double by5_5 = Piecewise.choose(eps, 0.0, by5_4, Piecewise.choose(0.0, -law_13, 0.5 * (by5_3
        - by5_1), -(law_17 * (by5_1 + by5_3) / law_16 * law_5)));
    double by5_6 = stiffness * by5_5;
    double by5_7 = 0.5 * by5_6;
    double by5_8 = Piecewise.choose(law_1, 0.0, 0.0, (u_y - law_10 * by5_1) / law_1);
    double by5_9 = chi * by5_8;
    double by5_10 = damping * by5_8;
    double by5_11 = by5_6 - (law_22 * by5_6 + law_19 * by5_9 + ((by5_5
        - law_20 * by5_3) / law_14 * law_21 + law_20 * by5_10));
    double by5_12 = Piecewise.choose(law_27, -1.0, 0.0, Piecewise.choose(1.0, law_26, 0.0, (by5_11
        - law_26 * by5_7) / law_25));
    double by5_13 = law_29 * by5_12;
    double by5_14 = law_31 * (law_30 * by5_12 + law_29 * (by5_13 + by5_13));
    double by5_15 = law_36 * (law_34 * by5_12 + law_28 * (law_33 * by5_12
        + law_28 * (law_32 * by5_12 + 7.0 * by5_12 * law_28))) + law_35 * (by5_14 + by5_14);
    double by5_16 = stiffness * by5_4;
    double by5_17 = Piecewise.choose(-law_13, 0.0, Piecewise.choose(0.0,
        -law_13, Piecewise.choose(-law_41, 0.0, 0.0, -(0.5 * by5_10)), 0.0),
        Piecewise.choose(law_40, 0.0, 0.0, by5_16 - (law_39 * by5_9 + law_22 * by5_16 + by5_10)));
    double by5_18 = Piecewise.choose(eps, 0.0, by5_17, law_37 * by5_7
        + 0.001953125 * by5_15 * law_24 + Piecewise.choose(law_38, 0.0, 0.0, by5_11 - by5_7))
        - law_43 * by5_1;
    double by5_19 = Piecewise.choose(law_1, 0.0, 0.0, by5_18 / law_1);
    out[40] = r_x * by5_19;
    out[52] = law_78 + r_y * by5_19;
    out[64] = r_z * by5_19;

    // Derivatives by motion 6.
    double by6_1 = 0.5 * (r_z + r_z) / law_1;
    double by6_2 = law_13 * by6_1;
    double by6_3 = 0.5 * (by6_2 + by6_2) / law_14;
    double by6_4 = Piecewise.choose(0.0, -law_13, -by6_1, 0.0);
    double by6_5 = Piecewise.choose(eps, 0.0, by6_4, Piecewise.choose(0.0, -law_13, 0.5 * (by6_3
        - by6_1), -(law_17 * (by6_1 + by6_3) / law_16 * law_5)));
    double by6_6 = stiffness * by6_5;
    double by6_7 = 0.5 * by6_6;
    double by6_8 = Piecewise.choose(law_1, 0.0, 0.0, (u_z - law_10 * by6_1) / law_1);
    double by6_9 = chi * by6_8;
    double by6_10 = damping * by6_8;
    double by6_11 = by6_6 - (law_22 * by6_6 + law_19 * by6_9 + ((by6_5
        - law_20 * by6_3) / law_14 * law_21 + law_20 * by6_10));
    double by6_12 = Piecewise.choose(law_27, -1.0, 0.0, Piecewise.choose(1.0, law_26, 0.0, (by6_11
        - law_26 * by6_7) / law_25));
    double by6_13 = law_29 * by6_12;
    double by6_14 = law_31 * (law_30 * by6_12 + law_29 * (by6_13 + by6_13));
    double by6_15 = law_36 * (law_34 * by6_12 + law_28 * (law_33 * by6_12
        + law_28 * (law_32 * by6_12 + 7.0 * by6_12 * law_28))) + law_35 * (by6_14 + by6_14);
    double by6_16 = stiffness * by6_4;
    double by6_17 = Piecewise.choose(-law_13, 0.0, Piecewise.choose(0.0,
        -law_13, Piecewise.choose(-law_41, 0.0, 0.0, -(0.5 * by6_10)), 0.0),
        Piecewise.choose(law_40, 0.0, 0.0, by6_16 - (law_39 * by6_9 + law_22 * by6_16 + by6_10)));
    double by6_18 = Piecewise.choose(eps, 0.0, by6_17, law_37 * by6_7
        + 0.001953125 * by6_15 * law_24 + Piecewise.choose(law_38, 0.0, 0.0, by6_11 - by6_7))
        - law_43 * by6_1;
    double by6_19 = Piecewise.choose(law_1, 0.0, 0.0, by6_18 / law_1);
    out[41] = r_x * by6_19;
    out[53] = r_y * by6_19;
    out[65] = law_78 + r_z * by6_19;

    // Derivatives by motion 10.
    double by10_1 = Piecewise.choose(law_1, 0.0, 0.5 * (u_x + u_x) / law_11, r_x / law_1);
    double by10_2 = chi * by10_1;
    double by10_3 = damping * by10_1;
    double by10_4 = law_19 * by10_2 + law_20 * by10_3;
    double by10_5 = Piecewise.choose(law_27, -1.0, 0.0, Piecewise.choose(1.0, law_26, 0.0,
        -(by10_4 / law_25)));
    double by10_6 = law_29 * by10_5;
    double by10_7 = law_31 * (law_30 * by10_5 + law_29 * (by10_6 + by10_6));
    double by10_8 = law_36 * (law_34 * by10_5 + law_28 * (law_33 * by10_5
        + law_28 * (law_32 * by10_5 + 7.0 * by10_5 * law_28))) + law_35 * (by10_7 + by10_7);
    double by10_9 = Piecewise.choose(-law_13, 0.0, Piecewise.choose(0.0,
        -law_13, Piecewise.choose(-law_41, 0.0, 0.0, -(0.5 * by10_3)), 0.0),
        Piecewise.choose(law_40, 0.0, 0.0, -(by10_3 + law_39 * by10_2)));
    double by10_10 = Piecewise.choose(law_1, 0.0, 0.0, Piecewise.choose(eps, 0.0, by10_9,
        Piecewise.choose(law_38, 0.0, 0.0, -by10_4) + 0.001953125 * by10_8 * law_24) / law_1);
    out[45] = law_79 + r_x * by10_10;
    out[57] = r_y * by10_10;
    out[69] = r_z * by10_10;

    // Derivatives by motion 11.
    double by11_1 = Piecewise.choose(law_1, 0.0, 0.5 * (u_y + u_y) / law_11, r_y / law_1);
    double by11_2 = chi * by11_1;
    double by11_3 = damping * by11_1;
    double by11_4 = law_19 * by11_2 + law_20 * by11_3;
    double by11_5 = Piecewise.choose(law_27, -1.0, 0.0, Piecewise.choose(1.0, law_26, 0.0,
        -(by11_4 / law_25)));
    double by11_6 = law_29 * by11_5;
    double by11_7 = law_31 * (law_30 * by11_5 + law_29 * (by11_6 + by11_6));
    double by11_8 = law_36 * (law_34 * by11_5 + law_28 * (law_33 * by11_5
        + law_28 * (law_32 * by11_5 + 7.0 * by11_5 * law_28))) + law_35 * (by11_7 + by11_7);
    double by11_9 = Piecewise.choose(-law_13, 0.0, Piecewise.choose(0.0,
        -law_13, Piecewise.choose(-law_41, 0.0, 0.0, -(0.5 * by11_3)), 0.0),
        Piecewise.choose(law_40, 0.0, 0.0, -(by11_3 + law_39 * by11_2)));
    double by11_10 = Piecewise.choose(law_1, 0.0, 0.0, Piecewise.choose(eps, 0.0, by11_9,
        Piecewise.choose(law_38, 0.0, 0.0, -by11_4) + 0.001953125 * by11_8 * law_24) / law_1);
    out[46] = r_x * by11_10;
    out[58] = law_79 + r_y * by11_10;
    out[70] = r_z * by11_10;

    // Derivatives by motion 12.
    double by12_1 = Piecewise.choose(law_1, 0.0, 0.5 * (u_z + u_z) / law_11, r_z / law_1);
    double by12_2 = chi * by12_1;
    double by12_3 = damping * by12_1;
    double by12_4 = law_19 * by12_2 + law_20 * by12_3;
    double by12_5 = Piecewise.choose(law_27, -1.0, 0.0, Piecewise.choose(1.0, law_26, 0.0,
        -(by12_4 / law_25)));
    double by12_6 = law_29 * by12_5;
    double by12_7 = law_31 * (law_30 * by12_5 + law_29 * (by12_6 + by12_6));
    double by12_8 = law_36 * (law_34 * by12_5 + law_28 * (law_33 * by12_5
        + law_28 * (law_32 * by12_5 + 7.0 * by12_5 * law_28))) + law_35 * (by12_7 + by12_7);
    double by12_9 = Piecewise.choose(-law_13, 0.0, Piecewise.choose(0.0,
        -law_13, Piecewise.choose(-law_41, 0.0, 0.0, -(0.5 * by12_3)), 0.0),
        Piecewise.choose(law_40, 0.0, 0.0, -(by12_3 + law_39 * by12_2)));
    double by12_10 = Piecewise.choose(law_1, 0.0, 0.0, Piecewise.choose(eps, 0.0, by12_9,
        Piecewise.choose(law_38, 0.0, 0.0, -by12_4) + 0.001953125 * by12_8 * law_24) / law_1);
    out[47] = r_x * by12_10;
    out[59] = r_y * by12_10;
    out[71] = law_79 + r_z * by12_10;
  }

  @Override
  public void results(double[] x, double[] c, double[] out) {
    // The load by its formula.
    double r_x = x[0];
    double r_y = x[1];
    double r_z = x[2];
    double u_x = x[15];
    double u_y = x[16];
    double u_z = x[17];
    double stiffness = c[0];
    double eps = c[4];
    double law_1 = Math.sqrt(r_x * r_x + r_y * r_y + r_z * r_z);
    double law_2 = eps * eps;
    double law_3 = Piecewise.choose(law_1, 0.0, Math.sqrt(u_x * u_x + u_y * u_y
        + u_z * u_z), (r_x * u_x + r_y * u_y + r_z * u_z) / law_1);
    double law_4 = law_1 - c[2];
    double law_5 = Math.sqrt(law_2 + law_4 * law_4);
    double law_6 = Piecewise.choose(0.0, -law_4, -law_4, 0.0);
    double law_7 = Piecewise.choose(eps, 0.0, law_6, Piecewise.choose(0.0, -law_4, 0.5 * (law_5
        - law_4), 0.5 * eps * (eps / (law_4 + law_5))));
    double law_8 = law_7 * law_7 * 0.5;
    double law_9 = stiffness * law_7;
    double law_10 = c[1] * law_3;
    double law_11 = c[5] * law_3;
    double law_12 = law_9 - (law_7 / law_5 * law_10 + law_9 * law_11);
    double law_13 = 0.5 * law_9;
    double law_14 = Math.max(-1.0, Math.min(1.0, law_12 / (1e-300 + law_13)));
    double law_15 = 1.0 + law_14;
    double law_16 = law_15 * law_15 * law_15;
    double law_17 = (63.0 + law_14 * (law_14 * (102.0 + law_14 * (7.0 * law_14 - 42.0))
        - 122.0)) * (law_16 * law_16) * 0.001953125 * law_13 + Math.max(0.0, law_12 - law_13);
    double law_18 = stiffness * law_6;
    double law_19 = Piecewise.choose(eps, 0.0, Piecewise.choose(-law_4, 0.0, Piecewise.choose(0.0,
        -law_4, Math.max(0.0, -(0.5 * law_10)), 0.0), Math.max(0.0, law_18 - (law_10
        + law_11 * law_18))), law_17);
    out[0] = stiffness * Piecewise.choose(eps, 0.0, law_8, law_8
        + (StrictMath.log(2.0 / eps * law_7) - 0.5) * (0.25 * law_2));
    out[1] = law_3 * (law_19 - law_9);
    out[2] = law_1;
    out[3] = law_3;
    out[4] = -law_19;
  }
}
