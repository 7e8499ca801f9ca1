package org.mechservice.solver.force.law.printed;

import org.mechservice.solver.force.law.PrintedLaw;
import org.mechservice.solver.spatial.Piecewise;

/**
 * Printed from its formula; do not edit. PrintedLawsTest compares it with the formula and
 * prints it anew with -Dgolden.write=true.
 */
final class PrintedBushing implements PrintedLaw {

  @Override
  public void load(double[] x, double[] c, double[] out) {
    // The load by its formula.
    double r_x = x[0];
    double u_x = x[15];
    double r_y = x[1];
    double u_y = x[16];
    double r_z = x[2];
    double u_z = x[17];
    double omega_x = x[12];
    double omega_z = x[14];
    double omega_y = x[13];
    double law_1 = 0.5 * Math.sqrt(1.0 + x[3] + x[7] + x[11]);
    double law_2 = 0.25 / law_1;
    double law_3 = (x[10] - x[8]) * law_2;
    double law_4 = (x[5] - x[9]) * law_2;
    double law_5 = (x[6] - x[4]) * law_2;
    double law_6 = law_3 * law_3 + law_4 * law_4 + law_5 * law_5;
    double law_7 = Math.sqrt(Piecewise.choose(law_6, 0.0, 1.0, law_6));
    double law_8 = 2.0 * StrictMath.atan2(law_7, law_1);
    double law_9 = Piecewise.choose(law_6, 0.0, 2.0, law_8 / law_7);
    double law_10 = law_3 * law_9;
    double law_11 = c[75] - r_x * c[18] - u_x * c[54] - r_y * c[19] - u_y * c[55] - r_z * c[20]
        - u_z * c[56] - c[21] * law_10;
    double law_12 = law_4 * law_9;
    double law_13 = law_5 * law_9;
    double law_14 = omega_z * law_12 - omega_y * law_13;
    double law_15 = Piecewise.choose(law_6, 0.0, 0.0, law_8);
    double law_16 = law_15 * law_15;
    double law_17 = Piecewise.choose(law_15, 0.05, 0.08333333333333333
        + law_16 * (0.001388888888888889 + law_16 * (3.306878306878307e-5
        + 8.267195767195768e-7 * law_16)), (1.0 - law_1 / law_7 * (0.5 * law_8)) / (law_8 * law_8));
    double law_18 = omega_y * law_10 - omega_x * law_12;
    double law_19 = omega_x * law_13 - omega_z * law_10;
    double law_20 = omega_x - 0.5 * law_14 + law_17 * (law_12 * law_18 - law_13 * law_19);
    double law_21 = omega_y - 0.5 * law_19 + law_17 * (law_13 * law_14 - law_10 * law_18);
    double law_22 = omega_z - 0.5 * law_18 + law_17 * (law_10 * law_19 - law_12 * law_14);
    double law_23 = law_11 - c[57] * law_20 - c[22] * law_12 - c[58] * law_21 - c[23] * law_13
        - c[59] * law_22;
    double law_24 = c[77] - r_x * c[30] - u_x * c[66] - r_y * c[31] - u_y * c[67] - r_z * c[32]
        - u_z * c[68] - c[33] * law_10;
    double law_25 = law_24 - c[69] * law_20 - c[34] * law_12 - c[70] * law_21 - c[35] * law_13
        - c[71] * law_22;
    double law_26 = c[76] - r_x * c[24] - u_x * c[60] - r_y * c[25] - u_y * c[61] - r_z * c[26]
        - u_z * c[62] - c[27] * law_10;
    double law_27 = law_26 - c[63] * law_20 - c[28] * law_12 - c[64] * law_21 - c[29] * law_13
        - c[65] * law_22;
    double law_28 = law_12 * law_25 - law_13 * law_27;
    double law_29 = law_10 * law_27 - law_12 * law_23;
    double law_30 = law_13 * law_23 - law_10 * law_25;
    double law_31 = c[72] - r_x * c[0] - u_x * c[36] - r_y * c[1] - u_y * c[37] - r_z * c[2]
        - u_z * c[38] - c[3] * law_10;
    double law_32 = c[73] - r_x * c[6] - u_x * c[42] - r_y * c[7] - u_y * c[43] - r_z * c[8]
        - u_z * c[44] - c[9] * law_10;
    double law_33 = c[74] - r_x * c[12] - u_x * c[48] - r_y * c[13] - u_y * c[49] - r_z * c[14]
        - u_z * c[50] - c[15] * law_10;
    out[0] = law_23 + 0.5 * law_28 + law_17 * (law_12 * law_29 - law_13 * law_30);
    out[1] = law_27 + 0.5 * law_30 + law_17 * (law_13 * law_28 - law_10 * law_29);
    out[2] = law_25 + 0.5 * law_29 + law_17 * (law_10 * law_30 - law_12 * law_28);
    out[3] = law_31 - c[39] * law_20 - c[4] * law_12 - c[40] * law_21 - c[5] * law_13
        - c[41] * law_22;
    out[4] = law_32 - c[45] * law_20 - c[10] * law_12 - c[46] * law_21 - c[11] * law_13
        - c[47] * law_22;
    out[5] = law_33 - c[51] * law_20 - c[16] * law_12 - c[52] * law_21 - c[17] * law_13
        - c[53] * law_22;
    out[6] = law_1 - 0.001;
  }

  @Override
  public void slopes(double[] x, double[] c, double[] out) {
    // Derivatives by motion 1.
    double R_xz = x[5];
    double R_zx = x[9];
    double R_zz = x[11];
    double R_yy = x[7];
    double R_xx = x[3];
    double R_zy = x[10];
    double R_yz = x[8];
    double R_yx = x[6];
    double R_xy = x[4];
    double r_x = x[0];
    double K_24 = c[24];
    double u_x = x[15];
    double C_24 = c[60];
    double r_y = x[1];
    double K_25 = c[25];
    double u_y = x[16];
    double C_25 = c[61];
    double r_z = x[2];
    double K_26 = c[26];
    double u_z = x[17];
    double C_26 = c[62];
    double K_27 = c[27];
    double C_27 = c[63];
    double omega_x = x[12];
    double omega_z = x[14];
    double omega_y = x[13];
    double K_28 = c[28];
    double C_28 = c[64];
    double K_29 = c[29];
    double C_29 = c[65];
    double K_18 = c[18];
    double C_18 = c[54];
    double K_19 = c[19];
    double C_19 = c[55];
    double K_20 = c[20];
    double C_20 = c[56];
    double K_21 = c[21];
    double C_21 = c[57];
    double K_22 = c[22];
    double C_22 = c[58];
    double K_23 = c[23];
    double C_23 = c[59];
    double K_30 = c[30];
    double C_30 = c[66];
    double K_31 = c[31];
    double C_31 = c[67];
    double K_32 = c[32];
    double C_32 = c[68];
    double K_33 = c[33];
    double C_33 = c[69];
    double K_34 = c[34];
    double C_34 = c[70];
    double K_35 = c[35];
    double C_35 = c[71];
    double C_5 = c[41];
    double K_5 = c[5];
    double C_4 = c[40];
    double K_4 = c[4];
    double C_3 = c[39];
    double K_3 = c[3];
    double C_11 = c[47];
    double K_11 = c[11];
    double C_10 = c[46];
    double K_10 = c[10];
    double C_9 = c[45];
    double K_9 = c[9];
    double C_17 = c[53];
    double K_17 = c[17];
    double C_16 = c[52];
    double K_16 = c[16];
    double C_15 = c[51];
    double K_15 = c[15];
    double by1_1 = R_xz - R_zx;
    double by1_2 = Math.sqrt(1.0 + R_xx + R_yy + R_zz);
    double by1_3 = 0.5 * by1_2;
    double by1_4 = 0.25 / by1_3;
    double by1_5 = by1_1 * by1_4;
    double by1_6 = R_zy - R_yz;
    double by1_7 = by1_6 * by1_4;
    double by1_8 = R_yx - R_xy;
    double by1_9 = by1_8 * by1_4;
    double by1_10 = by1_7 * by1_7 + by1_5 * by1_5 + by1_9 * by1_9;
    double by1_11 = Math.sqrt(Piecewise.choose(by1_10, 0.0, 1.0, by1_10));
    double by1_12 = 2.0 * StrictMath.atan2(by1_11, by1_3);
    double by1_13 = by1_12 / by1_11;
    double by1_14 = Piecewise.choose(by1_10, 0.0, 2.0, by1_13);
    double by1_15 = by1_5 * by1_14;
    double by1_16 = by1_7 * by1_14;
    double by1_17 = c[76] - r_x * K_24 - u_x * C_24 - r_y * K_25 - u_y * C_25 - r_z * K_26
        - u_z * C_26 - K_27 * by1_16;
    double by1_18 = by1_9 * by1_14;
    double by1_19 = omega_z * by1_15 - omega_y * by1_18;
    double by1_20 = Piecewise.choose(by1_10, 0.0, 0.0, by1_12);
    double by1_21 = by1_20 * by1_20;
    double by1_22 = 3.306878306878307e-5 + 8.267195767195768e-7 * by1_21;
    double by1_23 = 0.001388888888888889 + by1_21 * by1_22;
    double by1_24 = by1_3 / by1_11;
    double by1_25 = 0.5 * by1_12;
    double by1_26 = by1_12 * by1_12;
    double by1_27 = (1.0 - by1_24 * by1_25) / by1_26;
    double by1_28 = Piecewise.choose(by1_20, 0.05, 0.08333333333333333 + by1_21 * by1_23, by1_27);
    double by1_29 = omega_y * by1_16 - omega_x * by1_15;
    double by1_30 = omega_x * by1_18 - omega_z * by1_16;
    double by1_31 = by1_15 * by1_29 - by1_18 * by1_30;
    double by1_32 = omega_x - 0.5 * by1_19 + by1_28 * by1_31;
    double by1_33 = by1_18 * by1_19 - by1_16 * by1_29;
    double by1_34 = omega_y - 0.5 * by1_30 + by1_28 * by1_33;
    double by1_35 = by1_16 * by1_30 - by1_15 * by1_19;
    double by1_36 = omega_z - 0.5 * by1_29 + by1_28 * by1_35;
    double by1_37 = by1_17 - C_27 * by1_32 - K_28 * by1_15 - C_28 * by1_34 - K_29 * by1_18
        - C_29 * by1_36;
    double by1_38 = c[75] - r_x * K_18 - u_x * C_18 - r_y * K_19 - u_y * C_19 - r_z * K_20
        - u_z * C_20 - K_21 * by1_16;
    double by1_39 = by1_38 - C_21 * by1_32 - K_22 * by1_15 - C_22 * by1_34 - K_23 * by1_18
        - C_23 * by1_36;
    double by1_40 = by1_16 * by1_37 - by1_15 * by1_39;
    double by1_41 = c[77] - r_x * K_30 - u_x * C_30 - r_y * K_31 - u_y * C_31 - r_z * K_32
        - u_z * C_32 - K_33 * by1_16;
    double by1_42 = by1_41 - C_33 * by1_32 - K_34 * by1_15 - C_34 * by1_34 - K_35 * by1_18
        - C_35 * by1_36;
    double by1_43 = by1_18 * by1_39 - by1_16 * by1_42;
    double by1_44 = by1_15 * by1_40 - by1_18 * by1_43;
    double by1_45 = 0.5 * by1_6 / by1_2 * 0.5;
    double by1_46 = by1_4 * by1_45 / by1_3;
    double by1_47 = by1_8 * by1_46 - R_zx * by1_4;
    double by1_48 = by1_9 * by1_47;
    double by1_49 = by1_1 * by1_46 - R_yx * by1_4;
    double by1_50 = by1_5 * by1_49;
    double by1_51 = by1_4 * (R_yy + R_zz) + by1_6 * by1_46;
    double by1_52 = by1_7 * by1_51;
    double by1_53 = 0.5 * Piecewise.choose(by1_10, 0.0, 0.0, by1_48 + by1_48 + (by1_50 + by1_50
        + (by1_52 + by1_52))) / by1_11;
    double by1_54 = by1_11 * by1_11 + by1_3 * by1_3;
    double by1_55 = Piecewise.choose(by1_54, 0.0, 1.0, by1_54);
    double by1_56 = by1_3 / by1_55;
    double by1_57 = by1_11 / by1_55;
    double by1_58 = 2.0 * (by1_53 * by1_56 + by1_45 * by1_57);
    double by1_59 = by1_20 * Piecewise.choose(by1_10, 0.0, 0.0, by1_58);
    double by1_60 = by1_59 + by1_59;
    double by1_61 = by1_12 * by1_58;
    double by1_62 = Piecewise.choose(by1_20, 0.05, by1_23 * by1_60 + by1_21 * (by1_22 * by1_60
        + 8.267195767195768e-7 * by1_60 * by1_21), -((0.5 * by1_58 * by1_24 - (by1_45
        + by1_24 * by1_53) / by1_11 * by1_25 + by1_27 * (by1_61 + by1_61)) / by1_26));
    double by1_63 = Piecewise.choose(by1_10, 0.0, 0.0, (by1_58 - by1_13 * by1_53) / by1_11);
    double by1_64 = by1_14 * by1_49 + by1_5 * by1_63;
    double by1_65 = by1_14 * by1_51 + by1_7 * by1_63;
    double by1_66 = by1_14 * by1_47 + by1_9 * by1_63;
    double by1_67 = omega_x * by1_66 - omega_z * by1_65;
    double by1_68 = omega_z * by1_64 - omega_y * by1_66;
    double by1_69 = omega_y * by1_65 - omega_x * by1_64;
    double by1_70 = by1_35 * by1_62 + by1_28 * (by1_30 * by1_65 + by1_16 * by1_67 - (by1_19 * by1_64
        + by1_15 * by1_68)) - 0.5 * by1_69;
    double by1_71 = by1_33 * by1_62 + by1_28 * (by1_19 * by1_66 + by1_18 * by1_68 - (by1_29 * by1_65
        + by1_16 * by1_69)) - 0.5 * by1_67;
    double by1_72 = by1_31 * by1_62 + by1_28 * (by1_29 * by1_64 + by1_15 * by1_69 - (by1_30 * by1_66
        + by1_18 * by1_67)) - 0.5 * by1_68;
    double by1_73 = C_27 * by1_72 + K_27 * by1_65 + K_28 * by1_64 + C_28 * by1_71 + K_29 * by1_66
        + C_29 * by1_70;
    double by1_74 = C_21 * by1_72 + K_21 * by1_65 + K_22 * by1_64 + C_22 * by1_71 + K_23 * by1_66
        + C_23 * by1_70;
    double by1_75 = by1_37 * by1_65 - by1_16 * by1_73 - (by1_39 * by1_64 - by1_15 * by1_74);
    double by1_76 = C_33 * by1_72 + K_33 * by1_65 + K_34 * by1_64 + C_34 * by1_71 + K_35 * by1_66
        + C_35 * by1_70;
    double by1_77 = by1_39 * by1_66 - by1_18 * by1_74 - (by1_42 * by1_65 - by1_16 * by1_76);
    double by1_78 = by1_42 * by1_64 - by1_15 * by1_76 - (by1_37 * by1_66 - by1_18 * by1_73);
    double by1_79 = by1_15 * by1_42 - by1_18 * by1_37;
    double by1_80 = by1_18 * by1_79 - by1_16 * by1_40;
    double by1_81 = by1_16 * by1_43 - by1_15 * by1_79;
    out[0] = by1_44 * by1_62 + by1_28 * (by1_40 * by1_64 + by1_15 * by1_75 - (by1_43 * by1_66
        + by1_18 * by1_77)) + (0.5 * by1_78 - by1_74);
    out[6] = by1_80 * by1_62 + by1_28 * (by1_79 * by1_66 + by1_18 * by1_78 - (by1_40 * by1_65
        + by1_16 * by1_75)) + (0.5 * by1_77 - by1_73);
    out[12] = by1_81 * by1_62 + by1_28 * (by1_43 * by1_65 + by1_16 * by1_77 - (by1_79 * by1_64
        + by1_15 * by1_78)) + (0.5 * by1_75 - by1_76);
    out[18] = -(C_3 * by1_72 + K_3 * by1_65 + K_4 * by1_64 + C_4 * by1_71 + K_5 * by1_66
        + C_5 * by1_70);
    out[24] = -(C_9 * by1_72 + K_9 * by1_65 + K_10 * by1_64 + C_10 * by1_71 + K_11 * by1_66
        + C_11 * by1_70);
    out[30] = -(C_15 * by1_72 + K_15 * by1_65 + K_16 * by1_64 + C_16 * by1_71 + K_17 * by1_66
        + C_17 * by1_70);

    // Derivatives by motion 2.
    double by2_1 = 0.5 * by1_1 / by1_2 * 0.5;
    double by2_2 = by1_4 * by2_1 / by1_3;
    double by2_3 = by1_8 * by2_2 - R_zy * by1_4;
    double by2_4 = by1_9 * by2_3;
    double by2_5 = by1_4 * (R_xx + R_zz) + by1_1 * by2_2;
    double by2_6 = by1_5 * by2_5;
    double by2_7 = by1_6 * by2_2 - R_xy * by1_4;
    double by2_8 = by1_7 * by2_7;
    double by2_9 = 0.5 * Piecewise.choose(by1_10, 0.0, 0.0, by2_4 + by2_4 + (by2_6 + by2_6 + (by2_8
        + by2_8))) / by1_11;
    double by2_10 = 2.0 * (by1_56 * by2_9 + by1_57 * by2_1);
    double by2_11 = by1_20 * Piecewise.choose(by1_10, 0.0, 0.0, by2_10);
    double by2_12 = by2_11 + by2_11;
    double by2_13 = by1_12 * by2_10;
    double by2_14 = Piecewise.choose(by1_20, 0.05, by1_23 * by2_12 + by1_21 * (by1_22 * by2_12
        + 8.267195767195768e-7 * by2_12 * by1_21), -((0.5 * by2_10 * by1_24 - (by2_1
        + by1_24 * by2_9) / by1_11 * by1_25 + by1_27 * (by2_13 + by2_13)) / by1_26));
    double by2_15 = Piecewise.choose(by1_10, 0.0, 0.0, (by2_10 - by1_13 * by2_9) / by1_11);
    double by2_16 = by1_14 * by2_5 + by1_5 * by2_15;
    double by2_17 = by1_14 * by2_7 + by1_7 * by2_15;
    double by2_18 = by1_14 * by2_3 + by1_9 * by2_15;
    double by2_19 = omega_x * by2_18 - omega_z * by2_17;
    double by2_20 = omega_z * by2_16 - omega_y * by2_18;
    double by2_21 = omega_y * by2_17 - omega_x * by2_16;
    double by2_22 = by1_35 * by2_14 + by1_28 * (by1_30 * by2_17 + by1_16 * by2_19 - (by1_19 * by2_16
        + by1_15 * by2_20)) - 0.5 * by2_21;
    double by2_23 = by1_33 * by2_14 + by1_28 * (by1_19 * by2_18 + by1_18 * by2_20 - (by1_29 * by2_17
        + by1_16 * by2_21)) - 0.5 * by2_19;
    double by2_24 = by1_31 * by2_14 + by1_28 * (by1_29 * by2_16 + by1_15 * by2_21 - (by1_30 * by2_18
        + by1_18 * by2_19)) - 0.5 * by2_20;
    double by2_25 = C_27 * by2_24 + K_27 * by2_17 + K_28 * by2_16 + C_28 * by2_23 + K_29 * by2_18
        + C_29 * by2_22;
    double by2_26 = C_21 * by2_24 + K_21 * by2_17 + K_22 * by2_16 + C_22 * by2_23 + K_23 * by2_18
        + C_23 * by2_22;
    double by2_27 = by1_37 * by2_17 - by1_16 * by2_25 - (by1_39 * by2_16 - by1_15 * by2_26);
    double by2_28 = C_33 * by2_24 + K_33 * by2_17 + K_34 * by2_16 + C_34 * by2_23 + K_35 * by2_18
        + C_35 * by2_22;
    double by2_29 = by1_39 * by2_18 - by1_18 * by2_26 - (by1_42 * by2_17 - by1_16 * by2_28);
    double by2_30 = by1_42 * by2_16 - by1_15 * by2_28 - (by1_37 * by2_18 - by1_18 * by2_25);
    out[1] = by1_44 * by2_14 + by1_28 * (by1_40 * by2_16 + by1_15 * by2_27 - (by1_43 * by2_18
        + by1_18 * by2_29)) + (0.5 * by2_30 - by2_26);
    out[7] = by1_80 * by2_14 + by1_28 * (by1_79 * by2_18 + by1_18 * by2_30 - (by1_40 * by2_17
        + by1_16 * by2_27)) + (0.5 * by2_29 - by2_25);
    out[13] = by1_81 * by2_14 + by1_28 * (by1_43 * by2_17 + by1_16 * by2_29 - (by1_79 * by2_16
        + by1_15 * by2_30)) + (0.5 * by2_27 - by2_28);
    out[19] = -(C_3 * by2_24 + K_3 * by2_17 + K_4 * by2_16 + C_4 * by2_23 + K_5 * by2_18
        + C_5 * by2_22);
    out[25] = -(C_9 * by2_24 + K_9 * by2_17 + K_10 * by2_16 + C_10 * by2_23 + K_11 * by2_18
        + C_11 * by2_22);
    out[31] = -(C_15 * by2_24 + K_15 * by2_17 + K_16 * by2_16 + C_16 * by2_23 + K_17 * by2_18
        + C_17 * by2_22);

    // Derivatives by motion 3.
    double by3_1 = 0.5 * by1_8 / by1_2 * 0.5;
    double by3_2 = by1_4 * by3_1 / by1_3;
    double by3_3 = by1_4 * (R_xx + R_yy) + by1_8 * by3_2;
    double by3_4 = by1_9 * by3_3;
    double by3_5 = by1_1 * by3_2 - R_yz * by1_4;
    double by3_6 = by1_5 * by3_5;
    double by3_7 = by1_6 * by3_2 - R_xz * by1_4;
    double by3_8 = by1_7 * by3_7;
    double by3_9 = 0.5 * Piecewise.choose(by1_10, 0.0, 0.0, by3_4 + by3_4 + (by3_6 + by3_6 + (by3_8
        + by3_8))) / by1_11;
    double by3_10 = 2.0 * (by1_56 * by3_9 + by1_57 * by3_1);
    double by3_11 = by1_20 * Piecewise.choose(by1_10, 0.0, 0.0, by3_10);
    double by3_12 = by3_11 + by3_11;
    double by3_13 = by1_12 * by3_10;
    double by3_14 = Piecewise.choose(by1_20, 0.05, by1_23 * by3_12 + by1_21 * (by1_22 * by3_12
        + 8.267195767195768e-7 * by3_12 * by1_21), -((0.5 * by3_10 * by1_24 - (by3_1
        + by1_24 * by3_9) / by1_11 * by1_25 + by1_27 * (by3_13 + by3_13)) / by1_26));
    double by3_15 = Piecewise.choose(by1_10, 0.0, 0.0, (by3_10 - by1_13 * by3_9) / by1_11);
    double by3_16 = by1_14 * by3_5 + by1_5 * by3_15;
    double by3_17 = by1_14 * by3_7 + by1_7 * by3_15;
    double by3_18 = by1_14 * by3_3 + by1_9 * by3_15;
    double by3_19 = omega_x * by3_18 - omega_z * by3_17;
    double by3_20 = omega_z * by3_16 - omega_y * by3_18;
    double by3_21 = omega_y * by3_17 - omega_x * by3_16;
    double by3_22 = by1_35 * by3_14 + by1_28 * (by1_30 * by3_17 + by1_16 * by3_19 - (by1_19 * by3_16
        + by1_15 * by3_20)) - 0.5 * by3_21;
    double by3_23 = by1_33 * by3_14 + by1_28 * (by1_19 * by3_18 + by1_18 * by3_20 - (by1_29 * by3_17
        + by1_16 * by3_21)) - 0.5 * by3_19;
    double by3_24 = by1_31 * by3_14 + by1_28 * (by1_29 * by3_16 + by1_15 * by3_21 - (by1_30 * by3_18
        + by1_18 * by3_19)) - 0.5 * by3_20;
    double by3_25 = C_27 * by3_24 + K_27 * by3_17 + K_28 * by3_16 + C_28 * by3_23 + K_29 * by3_18
        + C_29 * by3_22;
    double by3_26 = C_21 * by3_24 + K_21 * by3_17 + K_22 * by3_16 + C_22 * by3_23 + K_23 * by3_18
        + C_23 * by3_22;
    double by3_27 = by1_37 * by3_17 - by1_16 * by3_25 - (by1_39 * by3_16 - by1_15 * by3_26);
    double by3_28 = C_33 * by3_24 + K_33 * by3_17 + K_34 * by3_16 + C_34 * by3_23 + K_35 * by3_18
        + C_35 * by3_22;
    double by3_29 = by1_39 * by3_18 - by1_18 * by3_26 - (by1_42 * by3_17 - by1_16 * by3_28);
    double by3_30 = by1_42 * by3_16 - by1_15 * by3_28 - (by1_37 * by3_18 - by1_18 * by3_25);
    out[2] = by1_44 * by3_14 + by1_28 * (by1_40 * by3_16 + by1_15 * by3_27 - (by1_43 * by3_18
        + by1_18 * by3_29)) + (0.5 * by3_30 - by3_26);
    out[8] = by1_80 * by3_14 + by1_28 * (by1_79 * by3_18 + by1_18 * by3_30 - (by1_40 * by3_17
        + by1_16 * by3_27)) + (0.5 * by3_29 - by3_25);
    out[14] = by1_81 * by3_14 + by1_28 * (by1_43 * by3_17 + by1_16 * by3_29 - (by1_79 * by3_16
        + by1_15 * by3_30)) + (0.5 * by3_27 - by3_28);
    out[20] = -(C_3 * by3_24 + K_3 * by3_17 + K_4 * by3_16 + C_4 * by3_23 + K_5 * by3_18
        + C_5 * by3_22);
    out[26] = -(C_9 * by3_24 + K_9 * by3_17 + K_10 * by3_16 + C_10 * by3_23 + K_11 * by3_18
        + C_11 * by3_22);
    out[32] = -(C_15 * by3_24 + K_15 * by3_17 + K_16 * by3_16 + C_16 * by3_23 + K_17 * by3_18
        + C_17 * by3_22);

    // Derivatives by motion 4.
    double by4_1 = K_18 * by1_15 - K_24 * by1_16;
    double by4_2 = K_30 * by1_16 - K_18 * by1_18;
    double by4_3 = K_24 * by1_18 - K_30 * by1_15;
    out[3] = 0.5 * by4_3 - K_18 + by1_28 * (by1_15 * by4_1 - by1_18 * by4_2);
    out[9] = 0.5 * by4_2 - K_24 + by1_28 * (by1_18 * by4_3 - by1_16 * by4_1);
    out[15] = 0.5 * by4_1 - K_30 + by1_28 * (by1_16 * by4_2 - by1_15 * by4_3);
    out[21] = -c[0];
    out[27] = -c[6];
    out[33] = -c[12];

    // Derivatives by motion 5.
    double by5_1 = K_19 * by1_15 - K_25 * by1_16;
    double by5_2 = K_31 * by1_16 - K_19 * by1_18;
    double by5_3 = K_25 * by1_18 - K_31 * by1_15;
    out[4] = 0.5 * by5_3 - K_19 + by1_28 * (by1_15 * by5_1 - by1_18 * by5_2);
    out[10] = 0.5 * by5_2 - K_25 + by1_28 * (by1_18 * by5_3 - by1_16 * by5_1);
    out[16] = 0.5 * by5_1 - K_31 + by1_28 * (by1_16 * by5_2 - by1_15 * by5_3);
    out[22] = -c[1];
    out[28] = -c[7];
    out[34] = -c[13];

    // Derivatives by motion 6.
    double by6_1 = K_20 * by1_15 - K_26 * by1_16;
    double by6_2 = K_32 * by1_16 - K_20 * by1_18;
    double by6_3 = K_26 * by1_18 - K_32 * by1_15;
    out[5] = 0.5 * by6_3 - K_20 + by1_28 * (by1_15 * by6_1 - by1_18 * by6_2);
    out[11] = 0.5 * by6_2 - K_26 + by1_28 * (by1_18 * by6_3 - by1_16 * by6_1);
    out[17] = 0.5 * by6_1 - K_32 + by1_28 * (by1_16 * by6_2 - by1_15 * by6_3);
    out[23] = -c[2];
    out[29] = -c[8];
    out[35] = -c[14];

    // Derivatives by motion 7.
    double by7_1 = by1_16 * by1_18 * by1_28;
    double by7_2 = -0.5 * by1_15;
    double by7_3 = by7_1 - by7_2;
    double by7_4 = by1_16 * by1_15 * by1_28;
    double by7_5 = -0.5 * by1_18;
    double by7_6 = by7_4 + by7_5;
    double by7_7 = by1_18 * by1_18;
    double by7_8 = by1_15 * by1_15;
    double by7_9 = 1.0 - by1_28 * (by7_7 + by7_8);
    double by7_10 = C_22 * by7_6 + C_21 * by7_9 + C_23 * by7_3;
    double by7_11 = C_28 * by7_6 + C_27 * by7_9 + C_29 * by7_3;
    double by7_12 = by1_15 * by7_10 - by1_16 * by7_11;
    double by7_13 = C_34 * by7_6 + C_33 * by7_9 + C_35 * by7_3;
    double by7_14 = by1_16 * by7_13 - by1_18 * by7_10;
    double by7_15 = by1_18 * by7_11 - by1_15 * by7_13;
    out[36] = 0.5 * by7_15 - by7_10 + by1_28 * (by1_15 * by7_12 - by1_18 * by7_14);
    out[42] = 0.5 * by7_14 - by7_11 + by1_28 * (by1_18 * by7_15 - by1_16 * by7_12);
    out[48] = 0.5 * by7_12 - by7_13 + by1_28 * (by1_16 * by7_14 - by1_15 * by7_15);
    out[54] = -(C_4 * by7_6 + C_3 * by7_9 + C_5 * by7_3);
    out[60] = -(C_10 * by7_6 + C_9 * by7_9 + C_11 * by7_3);
    out[66] = -(C_16 * by7_6 + C_15 * by7_9 + C_17 * by7_3);

    // Derivatives by motion 8.
    double by8_1 = by1_15 * by1_18 * by1_28;
    double by8_2 = -0.5 * by1_16;
    double by8_3 = by8_1 + by8_2;
    double by8_4 = by1_16 * by1_16;
    double by8_5 = 1.0 - by1_28 * (by7_7 + by8_4);
    double by8_6 = by7_4 - by7_5;
    double by8_7 = C_22 * by8_5 + C_21 * by8_6 + C_23 * by8_3;
    double by8_8 = C_28 * by8_5 + C_27 * by8_6 + C_29 * by8_3;
    double by8_9 = by1_15 * by8_7 - by1_16 * by8_8;
    double by8_10 = C_34 * by8_5 + C_33 * by8_6 + C_35 * by8_3;
    double by8_11 = by1_16 * by8_10 - by1_18 * by8_7;
    double by8_12 = by1_18 * by8_8 - by1_15 * by8_10;
    out[37] = 0.5 * by8_12 - by8_7 + by1_28 * (by1_15 * by8_9 - by1_18 * by8_11);
    out[43] = 0.5 * by8_11 - by8_8 + by1_28 * (by1_18 * by8_12 - by1_16 * by8_9);
    out[49] = 0.5 * by8_9 - by8_10 + by1_28 * (by1_16 * by8_11 - by1_15 * by8_12);
    out[55] = -(C_4 * by8_5 + C_3 * by8_6 + C_5 * by8_3);
    out[61] = -(C_10 * by8_5 + C_9 * by8_6 + C_11 * by8_3);
    out[67] = -(C_16 * by8_5 + C_15 * by8_6 + C_17 * by8_3);

    // Derivatives by motion 9.
    double by9_1 = 1.0 - by1_28 * (by7_8 + by8_4);
    double by9_2 = by8_1 - by8_2;
    double by9_3 = by7_1 + by7_2;
    double by9_4 = C_22 * by9_2 + C_21 * by9_3 + C_23 * by9_1;
    double by9_5 = C_28 * by9_2 + C_27 * by9_3 + C_29 * by9_1;
    double by9_6 = by1_15 * by9_4 - by1_16 * by9_5;
    double by9_7 = C_34 * by9_2 + C_33 * by9_3 + C_35 * by9_1;
    double by9_8 = by1_16 * by9_7 - by1_18 * by9_4;
    double by9_9 = by1_18 * by9_5 - by1_15 * by9_7;
    out[38] = 0.5 * by9_9 - by9_4 + by1_28 * (by1_15 * by9_6 - by1_18 * by9_8);
    out[44] = 0.5 * by9_8 - by9_5 + by1_28 * (by1_18 * by9_9 - by1_16 * by9_6);
    out[50] = 0.5 * by9_6 - by9_7 + by1_28 * (by1_16 * by9_8 - by1_15 * by9_9);
    out[56] = -(C_4 * by9_2 + C_3 * by9_3 + C_5 * by9_1);
    out[62] = -(C_10 * by9_2 + C_9 * by9_3 + C_11 * by9_1);
    out[68] = -(C_16 * by9_2 + C_15 * by9_3 + C_17 * by9_1);

    // Derivatives by motion 10.
    double by10_1 = C_18 * by1_15 - C_24 * by1_16;
    double by10_2 = C_30 * by1_16 - C_18 * by1_18;
    double by10_3 = C_24 * by1_18 - C_30 * by1_15;
    out[39] = 0.5 * by10_3 - C_18 + by1_28 * (by1_15 * by10_1 - by1_18 * by10_2);
    out[45] = 0.5 * by10_2 - C_24 + by1_28 * (by1_18 * by10_3 - by1_16 * by10_1);
    out[51] = 0.5 * by10_1 - C_30 + by1_28 * (by1_16 * by10_2 - by1_15 * by10_3);
    out[57] = -c[36];
    out[63] = -c[42];
    out[69] = -c[48];

    // Derivatives by motion 11.
    double by11_1 = C_19 * by1_15 - C_25 * by1_16;
    double by11_2 = C_31 * by1_16 - C_19 * by1_18;
    double by11_3 = C_25 * by1_18 - C_31 * by1_15;
    out[40] = 0.5 * by11_3 - C_19 + by1_28 * (by1_15 * by11_1 - by1_18 * by11_2);
    out[46] = 0.5 * by11_2 - C_25 + by1_28 * (by1_18 * by11_3 - by1_16 * by11_1);
    out[52] = 0.5 * by11_1 - C_31 + by1_28 * (by1_16 * by11_2 - by1_15 * by11_3);
    out[58] = -c[37];
    out[64] = -c[43];
    out[70] = -c[49];

    // Derivatives by motion 12.
    double by12_1 = C_20 * by1_15 - C_26 * by1_16;
    double by12_2 = C_32 * by1_16 - C_20 * by1_18;
    double by12_3 = C_26 * by1_18 - C_32 * by1_15;
    out[41] = 0.5 * by12_3 - C_20 + by1_28 * (by1_15 * by12_1 - by1_18 * by12_2);
    out[47] = 0.5 * by12_2 - C_26 + by1_28 * (by1_18 * by12_3 - by1_16 * by12_1);
    out[53] = 0.5 * by12_1 - C_32 + by1_28 * (by1_16 * by12_2 - by1_15 * by12_3);
    out[59] = -c[38];
    out[65] = -c[44];
    out[71] = -c[50];
  }

  @Override
  public void results(double[] x, double[] c, double[] out) {
    // The load by its formula.
    double r_x = x[0];
    double r_y = x[1];
    double r_z = x[2];
    double preload_0 = c[72];
    double preload_1 = c[73];
    double preload_2 = c[74];
    double preload_3 = c[75];
    double preload_4 = c[76];
    double preload_5 = c[77];
    double u_x = x[15];
    double u_y = x[16];
    double u_z = x[17];
    double omega_x = x[12];
    double omega_z = x[14];
    double omega_y = x[13];
    double settled_38 = c[115];
    double settled_39 = c[116];
    double settled_40 = c[117];
    double settled_41 = c[118];
    double settled_42 = c[119];
    double settled_44 = c[121];
    double settled_45 = c[122];
    double settled_46 = c[123];
    double settled_47 = c[124];
    double settled_49 = c[126];
    double settled_50 = c[127];
    double settled_51 = c[128];
    double settled_53 = c[130];
    double settled_54 = c[131];
    double settled_56 = c[133];
    double law_1 = r_x * r_y;
    double law_2 = r_x * r_z;
    double law_3 = 0.5 * Math.sqrt(1.0 + x[3] + x[7] + x[11]);
    double law_4 = 0.25 / law_3;
    double law_5 = (x[10] - x[8]) * law_4;
    double law_6 = (x[5] - x[9]) * law_4;
    double law_7 = (x[6] - x[4]) * law_4;
    double law_8 = law_5 * law_5 + law_6 * law_6 + law_7 * law_7;
    double law_9 = Math.sqrt(Piecewise.choose(law_8, 0.0, 1.0, law_8));
    double law_10 = 2.0 * StrictMath.atan2(law_9, law_3);
    double law_11 = Piecewise.choose(law_8, 0.0, 2.0, law_10 / law_9);
    double law_12 = law_5 * law_11;
    double law_13 = r_x * law_12;
    double law_14 = law_6 * law_11;
    double law_15 = r_x * law_14;
    double law_16 = law_7 * law_11;
    double law_17 = r_x * law_16;
    double law_18 = r_x * r_x * c[78] + law_1 * c[79] + law_2 * c[80] + law_13 * c[81]
        + law_15 * c[82] + law_17 * c[83] - r_x * preload_0;
    double law_19 = r_y * r_z;
    double law_20 = r_y * law_12;
    double law_21 = r_y * law_14;
    double law_22 = r_y * law_16;
    double law_23 = law_18 + law_1 * c[84] + r_y * r_y * c[85] + law_19 * c[86] + law_20 * c[87]
        + law_21 * c[88] + law_22 * c[89] - r_y * preload_1;
    double law_24 = r_z * law_12;
    double law_25 = r_z * law_14;
    double law_26 = r_z * law_16;
    double law_27 = law_23 + law_2 * c[90] + law_19 * c[91] + r_z * r_z * c[92] + law_24 * c[93]
        + law_25 * c[94] + law_26 * c[95] - r_z * preload_2;
    double law_28 = law_12 * law_14;
    double law_29 = law_12 * law_16;
    double law_30 = law_27 + law_13 * c[96] + law_20 * c[97] + law_24 * c[98]
        + law_12 * law_12 * c[99] + law_28 * c[100] + law_29 * c[101] - preload_3 * law_12;
    double law_31 = law_14 * law_16;
    double law_32 = law_30 + law_15 * c[102] + law_21 * c[103] + law_25 * c[104] + law_28 * c[105]
        + law_14 * law_14 * c[106] + law_31 * c[107] - preload_4 * law_14;
    double law_33 = law_32 + law_17 * c[108] + law_22 * c[109] + law_26 * c[110] + law_29 * c[111]
        + law_31 * c[112] + law_16 * law_16 * c[113] - preload_5 * law_16;
    double law_34 = preload_0 - r_x * c[0] - u_x * c[36] - r_y * c[1] - u_y * c[37] - r_z * c[2]
        - u_z * c[38] - c[3] * law_12;
    double law_35 = omega_z * law_14 - omega_y * law_16;
    double law_36 = Piecewise.choose(law_8, 0.0, 0.0, law_10);
    double law_37 = law_36 * law_36;
    double law_38 = Piecewise.choose(law_36, 0.05, 0.08333333333333333
        + law_37 * (0.001388888888888889 + law_37 * (3.306878306878307e-5
        + 8.267195767195768e-7 * law_37)), (1.0 - law_3 / law_9 * (0.5 * law_10)) / (law_10
        * law_10));
    double law_39 = omega_y * law_12 - omega_x * law_14;
    double law_40 = omega_x * law_16 - omega_z * law_12;
    double law_41 = omega_x - 0.5 * law_35 + law_38 * (law_14 * law_39 - law_16 * law_40);
    double law_42 = omega_y - 0.5 * law_40 + law_38 * (law_16 * law_35 - law_12 * law_39);
    double law_43 = omega_z - 0.5 * law_39 + law_38 * (law_12 * law_40 - law_14 * law_35);
    double law_44 = law_34 - c[39] * law_41 - c[4] * law_14 - c[40] * law_42 - c[5] * law_16
        - c[41] * law_43;
    double law_45 = preload_1 - r_x * c[6] - u_x * c[42] - r_y * c[7] - u_y * c[43] - r_z * c[8]
        - u_z * c[44] - c[9] * law_12;
    double law_46 = law_45 - c[45] * law_41 - c[10] * law_14 - c[46] * law_42 - c[11] * law_16
        - c[47] * law_43;
    double law_47 = preload_2 - r_x * c[12] - u_x * c[48] - r_y * c[13] - u_y * c[49] - r_z * c[14]
        - u_z * c[50] - c[15] * law_12;
    double law_48 = law_47 - c[51] * law_41 - c[16] * law_14 - c[52] * law_42 - c[17] * law_16
        - c[53] * law_43;
    double law_49 = preload_3 - r_x * c[18] - u_x * c[54] - r_y * c[19] - u_y * c[55] - r_z * c[20]
        - u_z * c[56] - c[21] * law_12;
    double law_50 = law_49 - c[57] * law_41 - c[22] * law_14 - c[58] * law_42 - c[23] * law_16
        - c[59] * law_43;
    double law_51 = preload_5 - r_x * c[30] - u_x * c[66] - r_y * c[31] - u_y * c[67] - r_z * c[32]
        - u_z * c[68] - c[33] * law_12;
    double law_52 = law_51 - c[69] * law_41 - c[34] * law_14 - c[70] * law_42 - c[35] * law_16
        - c[71] * law_43;
    double law_53 = preload_4 - r_x * c[24] - u_x * c[60] - r_y * c[25] - u_y * c[61] - r_z * c[26]
        - u_z * c[62] - c[27] * law_12;
    double law_54 = law_53 - c[63] * law_41 - c[28] * law_14 - c[64] * law_42 - c[29] * law_16
        - c[65] * law_43;
    double law_55 = law_14 * law_52 - law_16 * law_54;
    double law_56 = law_12 * law_54 - law_14 * law_50;
    double law_57 = law_16 * law_50 - law_12 * law_52;
    double law_58 = law_50 + 0.5 * law_55 + law_38 * (law_14 * law_56 - law_16 * law_57);
    double law_59 = law_54 + 0.5 * law_57 + law_38 * (law_16 * law_55 - law_12 * law_56);
    double law_60 = law_52 + 0.5 * law_56 + law_38 * (law_12 * law_57 - law_14 * law_55);
    double law_61 = u_x * law_44 + u_y * law_46 + u_z * law_48 + (omega_x * law_58
        + omega_y * law_59 + omega_z * law_60) + u_x * (r_x * c[114] - preload_0 + r_y * settled_38
        + r_z * settled_39 + law_12 * settled_40 + law_14 * settled_41 + law_16 * settled_42);
    double law_62 = law_61 + u_y * (r_x * settled_38 - preload_1 + r_y * c[120] + r_z * settled_44
        + law_12 * settled_45 + law_14 * settled_46 + law_16 * settled_47);
    double law_63 = law_62 + u_z * (r_x * settled_39 - preload_2 + r_y * settled_44 + r_z * c[125]
        + law_12 * settled_49 + law_14 * settled_50 + law_16 * settled_51);
    double law_64 = law_63 + law_41 * (r_x * settled_40 - preload_3 + r_y * settled_45
        + r_z * settled_49 + law_12 * c[129] + law_14 * settled_53 + law_16 * settled_54);
    double law_65 = law_64 + law_42 * (r_x * settled_41 - preload_4 + r_y * settled_46
        + r_z * settled_50 + law_12 * settled_53 + law_14 * c[132] + law_16 * settled_56);
    double law_66 = law_65 + law_43 * (r_x * settled_42 - preload_5 + r_y * settled_47
        + r_z * settled_51 + law_12 * settled_54 + law_14 * settled_56 + law_16 * c[134]);
    out[0] = law_33;
    out[1] = law_66;
    System.arraycopy(x, 0, out, 2, 3);
    out[5] = law_12;
    out[6] = law_14;
    out[7] = law_16;
    out[8] = law_44;
    out[9] = law_46;
    out[10] = law_48;
    out[11] = law_58;
    out[12] = law_59;
    out[13] = law_60;
  }

  @Override
  public void settle(double[] c, double[] out) {
    // What depends on coefficients alone.
    double c_0 = c[0];
    double c_1 = c[1];
    double c_2 = c[2];
    double c_3 = c[3];
    double c_4 = c[4];
    double c_5 = c[5];
    double c_6 = c[6];
    double c_7 = c[7];
    double c_8 = c[8];
    double c_9 = c[9];
    double c_10 = c[10];
    double c_11 = c[11];
    double c_12 = c[12];
    double c_13 = c[13];
    double c_14 = c[14];
    double c_15 = c[15];
    double c_16 = c[16];
    double c_17 = c[17];
    double c_18 = c[18];
    double c_19 = c[19];
    double c_20 = c[20];
    double c_21 = c[21];
    double c_22 = c[22];
    double c_23 = c[23];
    double c_24 = c[24];
    double c_25 = c[25];
    double c_26 = c[26];
    double c_27 = c[27];
    double c_28 = c[28];
    double c_29 = c[29];
    double c_30 = c[30];
    double c_31 = c[31];
    double c_32 = c[32];
    double c_33 = c[33];
    double c_34 = c[34];
    double c_35 = c[35];
    out[78] = 0.5 * c_0;
    out[79] = 0.5 * c_1;
    out[80] = 0.5 * c_2;
    out[81] = 0.5 * c_3;
    out[82] = 0.5 * c_4;
    out[83] = 0.5 * c_5;
    out[84] = 0.5 * c_6;
    out[85] = 0.5 * c_7;
    out[86] = 0.5 * c_8;
    out[87] = 0.5 * c_9;
    out[88] = 0.5 * c_10;
    out[89] = 0.5 * c_11;
    out[90] = 0.5 * c_12;
    out[91] = 0.5 * c_13;
    out[92] = 0.5 * c_14;
    out[93] = 0.5 * c_15;
    out[94] = 0.5 * c_16;
    out[95] = 0.5 * c_17;
    out[96] = 0.5 * c_18;
    out[97] = 0.5 * c_19;
    out[98] = 0.5 * c_20;
    out[99] = 0.5 * c_21;
    out[100] = 0.5 * c_22;
    out[101] = 0.5 * c_23;
    out[102] = 0.5 * c_24;
    out[103] = 0.5 * c_25;
    out[104] = 0.5 * c_26;
    out[105] = 0.5 * c_27;
    out[106] = 0.5 * c_28;
    out[107] = 0.5 * c_29;
    out[108] = 0.5 * c_30;
    out[109] = 0.5 * c_31;
    out[110] = 0.5 * c_32;
    out[111] = 0.5 * c_33;
    out[112] = 0.5 * c_34;
    out[113] = 0.5 * c_35;
    out[114] = 0.5 * (c_0 + c_0);
    out[115] = 0.5 * (c_1 + c_6);
    out[116] = 0.5 * (c_2 + c_12);
    out[117] = 0.5 * (c_3 + c_18);
    out[118] = 0.5 * (c_4 + c_24);
    out[119] = 0.5 * (c_5 + c_30);
    out[120] = 0.5 * (c_7 + c_7);
    out[121] = 0.5 * (c_8 + c_13);
    out[122] = 0.5 * (c_9 + c_19);
    out[123] = 0.5 * (c_10 + c_25);
    out[124] = 0.5 * (c_11 + c_31);
    out[125] = 0.5 * (c_14 + c_14);
    out[126] = 0.5 * (c_15 + c_20);
    out[127] = 0.5 * (c_16 + c_26);
    out[128] = 0.5 * (c_17 + c_32);
    out[129] = 0.5 * (c_21 + c_21);
    out[130] = 0.5 * (c_22 + c_27);
    out[131] = 0.5 * (c_23 + c_33);
    out[132] = 0.5 * (c_28 + c_28);
    out[133] = 0.5 * (c_29 + c_34);
    out[134] = 0.5 * (c_35 + c_35);
  }

  @Override
  public int size() {
    return 135;
  }
}
