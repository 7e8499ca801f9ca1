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
    double r_y = x[1];
    double r_z = x[2];
    double omega_x = x[12];
    double omega_y = x[13];
    double omega_z = x[14];
    double u_x = x[15];
    double u_y = x[16];
    double u_z = x[17];
    double law_1 = 0.5 * Math.sqrt(1.0 + x[3] + x[7] + x[11]);
    double law_2 = 0.25 / law_1;
    double law_3 = (x[10] - x[8]) * law_2;
    double law_4 = (x[5] - x[9]) * law_2;
    double law_5 = (x[6] - x[4]) * law_2;
    double law_6 = law_3 * law_3 + law_4 * law_4 + law_5 * law_5;
    double law_7 = Math.sqrt(Piecewise.choose(law_6, 0.0, 1.0, law_6));
    double law_8 = StrictMath.atan2(law_7, law_1);
    double law_9 = 2.0 * law_8;
    double law_10 = Piecewise.choose(law_6, 0.0, 2.0, law_9 / law_7);
    double law_11 = law_3 * law_10;
    double law_12 = law_4 * law_10;
    double law_13 = law_5 * law_10;
    double law_14 = Piecewise.choose(law_6, 0.0, 0.0, law_9);
    double law_15 = law_14 * law_14;
    double law_16 = Piecewise.choose(law_14, 0.05, 0.08333333333333333
        + law_15 * (0.001388888888888889 + law_15 * (3.306878306878307e-5
        + 8.267195767195768e-7 * law_15)), (1.0 - law_1 / law_7 * law_8) / (law_9 * law_9));
    double law_17 = omega_z * law_12 - omega_y * law_13;
    double law_18 = omega_x * law_13 - omega_z * law_11;
    double law_19 = omega_y * law_11 - omega_x * law_12;
    double law_20 = omega_x - 0.5 * law_17 + law_16 * (law_12 * law_19 - law_13 * law_18);
    double law_21 = omega_y - 0.5 * law_18 + law_16 * (law_13 * law_17 - law_11 * law_19);
    double law_22 = omega_z - 0.5 * law_19 + law_16 * (law_11 * law_18 - law_12 * law_17);
    double law_23 = c[72] - r_x * c[0] - u_x * c[36] - r_y * c[1] - u_y * c[37] - r_z * c[2]
        - u_z * c[38] - c[3] * law_11;
    double law_24 = c[73] - r_x * c[6] - u_x * c[42] - r_y * c[7] - u_y * c[43] - r_z * c[8]
        - u_z * c[44] - c[9] * law_11;
    double law_25 = c[74] - r_x * c[12] - u_x * c[48] - r_y * c[13] - u_y * c[49] - r_z * c[14]
        - u_z * c[50] - c[15] * law_11;
    double law_26 = c[75] - r_x * c[18] - u_x * c[54] - r_y * c[19] - u_y * c[55] - r_z * c[20]
        - u_z * c[56] - c[21] * law_11;
    double law_27 = law_26 - c[57] * law_20 - c[22] * law_12 - c[58] * law_21 - c[23] * law_13
        - c[59] * law_22;
    double law_28 = c[76] - r_x * c[24] - u_x * c[60] - r_y * c[25] - u_y * c[61] - r_z * c[26]
        - u_z * c[62] - c[27] * law_11;
    double law_29 = law_28 - c[63] * law_20 - c[28] * law_12 - c[64] * law_21 - c[29] * law_13
        - c[65] * law_22;
    double law_30 = c[77] - r_x * c[30] - u_x * c[66] - r_y * c[31] - u_y * c[67] - r_z * c[32]
        - u_z * c[68] - c[33] * law_11;
    double law_31 = law_30 - c[69] * law_20 - c[34] * law_12 - c[70] * law_21 - c[35] * law_13
        - c[71] * law_22;
    double law_32 = law_12 * law_31 - law_13 * law_29;
    double law_33 = law_13 * law_27 - law_11 * law_31;
    double law_34 = law_11 * law_29 - law_12 * law_27;
    out[0] = law_27 + 0.5 * law_32 + law_16 * (law_12 * law_34 - law_13 * law_33);
    out[1] = law_29 + 0.5 * law_33 + law_16 * (law_13 * law_32 - law_11 * law_34);
    out[2] = law_31 + 0.5 * law_34 + law_16 * (law_11 * law_33 - law_12 * law_32);
    out[3] = law_23 - c[39] * law_20 - c[4] * law_12 - c[40] * law_21 - c[5] * law_13
        - c[41] * law_22;
    out[4] = law_24 - c[45] * law_20 - c[10] * law_12 - c[46] * law_21 - c[11] * law_13
        - c[47] * law_22;
    out[5] = law_25 - c[51] * law_20 - c[16] * law_12 - c[52] * law_21 - c[17] * law_13
        - c[53] * law_22;
    out[6] = law_1 - 0.001;
  }

  @Override
  public void slopes(double[] x, double[] c, double[] out) {
    // The load by its formula.
    double r_x = x[0];
    double r_y = x[1];
    double r_z = x[2];
    double R_xx = x[3];
    double R_xy = x[4];
    double R_xz = x[5];
    double R_yx = x[6];
    double R_yy = x[7];
    double R_yz = x[8];
    double R_zx = x[9];
    double R_zy = x[10];
    double R_zz = x[11];
    double omega_x = x[12];
    double omega_y = x[13];
    double omega_z = x[14];
    double u_x = x[15];
    double u_y = x[16];
    double u_z = x[17];
    double K_18 = c[18];
    double K_19 = c[19];
    double K_20 = c[20];
    double K_21 = c[21];
    double K_22 = c[22];
    double K_23 = c[23];
    double K_24 = c[24];
    double K_25 = c[25];
    double K_26 = c[26];
    double K_27 = c[27];
    double K_28 = c[28];
    double K_29 = c[29];
    double K_30 = c[30];
    double K_31 = c[31];
    double K_32 = c[32];
    double K_33 = c[33];
    double K_34 = c[34];
    double K_35 = c[35];
    double C_18 = c[54];
    double C_19 = c[55];
    double C_20 = c[56];
    double C_21 = c[57];
    double C_22 = c[58];
    double C_23 = c[59];
    double C_24 = c[60];
    double C_25 = c[61];
    double C_26 = c[62];
    double C_27 = c[63];
    double C_28 = c[64];
    double C_29 = c[65];
    double C_30 = c[66];
    double C_31 = c[67];
    double C_32 = c[68];
    double C_33 = c[69];
    double C_34 = c[70];
    double C_35 = c[71];
    double law_1 = Math.sqrt(1.0 + R_xx + R_yy + R_zz);
    double law_2 = 0.5 * law_1;
    double law_3 = R_zy - R_yz;
    double law_4 = R_xz - R_zx;
    double law_5 = R_yx - R_xy;
    double law_6 = 0.25 / law_2;
    double law_7 = law_3 * law_6;
    double law_8 = law_4 * law_6;
    double law_9 = law_5 * law_6;
    double law_10 = law_7 * law_7 + law_8 * law_8 + law_9 * law_9;
    double law_11 = Math.sqrt(Piecewise.choose(law_10, 0.0, 1.0, law_10));
    double law_12 = StrictMath.atan2(law_11, law_2);
    double law_13 = 2.0 * law_12;
    double law_14 = law_13 / law_11;
    double law_15 = Piecewise.choose(law_10, 0.0, 2.0, law_14);
    double law_16 = law_7 * law_15;
    double law_17 = law_8 * law_15;
    double law_18 = law_9 * law_15;
    double law_19 = Piecewise.choose(law_10, 0.0, 0.0, law_13);
    double law_20 = law_2 / law_11;
    double law_21 = law_19 * law_19;
    double law_22 = 3.306878306878307e-5 + 8.267195767195768e-7 * law_21;
    double law_23 = 0.001388888888888889 + law_21 * law_22;
    double law_24 = law_13 * law_13;
    double law_25 = (1.0 - law_12 * law_20) / law_24;
    double law_26 = Piecewise.choose(law_19, 0.05, 0.08333333333333333 + law_21 * law_23, law_25);
    double law_27 = omega_z * law_17 - omega_y * law_18;
    double law_28 = omega_x * law_18 - omega_z * law_16;
    double law_29 = omega_y * law_16 - omega_x * law_17;
    double law_30 = law_17 * law_29 - law_18 * law_28;
    double law_31 = law_18 * law_27 - law_16 * law_29;
    double law_32 = law_16 * law_28 - law_17 * law_27;
    double law_33 = omega_x - 0.5 * law_27 + law_26 * law_30;
    double law_34 = omega_y - 0.5 * law_28 + law_26 * law_31;
    double law_35 = omega_z - 0.5 * law_29 + law_26 * law_32;
    double law_36 = c[75] - r_x * K_18 - u_x * C_18 - r_y * K_19 - u_y * C_19 - r_z * K_20
        - u_z * C_20 - K_21 * law_16;
    double law_37 = law_36 - C_21 * law_33 - K_22 * law_17 - C_22 * law_34 - K_23 * law_18
        - C_23 * law_35;
    double law_38 = c[76] - r_x * K_24 - u_x * C_24 - r_y * K_25 - u_y * C_25 - r_z * K_26
        - u_z * C_26 - K_27 * law_16;
    double law_39 = law_38 - C_27 * law_33 - K_28 * law_17 - C_28 * law_34 - K_29 * law_18
        - C_29 * law_35;
    double law_40 = c[77] - r_x * K_30 - u_x * C_30 - r_y * K_31 - u_y * C_31 - r_z * K_32
        - u_z * C_32 - K_33 * law_16;
    double law_41 = law_40 - C_33 * law_33 - K_34 * law_17 - C_34 * law_34 - K_35 * law_18
        - C_35 * law_35;
    double law_42 = law_17 * law_41 - law_18 * law_39;
    double law_43 = law_18 * law_37 - law_16 * law_41;
    double law_44 = law_16 * law_39 - law_17 * law_37;
    double law_45 = law_17 * law_44 - law_18 * law_43;
    double law_46 = law_18 * law_42 - law_16 * law_44;
    double law_47 = law_16 * law_43 - law_17 * law_42;

    // Derivatives by motion 1.
    double K_3 = c[3];
    double K_4 = c[4];
    double K_5 = c[5];
    double K_9 = c[9];
    double K_10 = c[10];
    double K_11 = c[11];
    double K_15 = c[15];
    double K_16 = c[16];
    double K_17 = c[17];
    double C_3 = c[39];
    double C_4 = c[40];
    double C_5 = c[41];
    double C_9 = c[45];
    double C_10 = c[46];
    double C_11 = c[47];
    double C_15 = c[51];
    double C_16 = c[52];
    double C_17 = c[53];
    double by1_1 = 0.5 * law_3 / law_1 * 0.5;
    double by1_2 = law_6 * by1_1 / law_2;
    double by1_3 = law_5 * by1_2 - R_zx * law_6;
    double by1_4 = law_9 * by1_3;
    double by1_5 = law_4 * by1_2 - R_yx * law_6;
    double by1_6 = law_8 * by1_5;
    double by1_7 = law_6 * (R_yy + R_zz) + law_3 * by1_2;
    double by1_8 = law_7 * by1_7;
    double by1_9 = 0.5 * Piecewise.choose(law_10, 0.0, 0.0, by1_4 + by1_4 + (by1_6 + by1_6 + (by1_8
        + by1_8))) / law_11;
    double by1_10 = law_11 * law_11 + law_2 * law_2;
    double by1_11 = Piecewise.choose(by1_10, 0.0, 1.0, by1_10);
    double by1_12 = law_2 / by1_11;
    double by1_13 = law_11 / by1_11;
    double by1_14 = by1_9 * by1_12 + by1_1 * by1_13;
    double by1_15 = 2.0 * by1_14;
    double by1_16 = Piecewise.choose(law_10, 0.0, 0.0, (by1_15 - law_14 * by1_9) / law_11);
    double by1_17 = law_15 * by1_3 + law_9 * by1_16;
    double by1_18 = law_15 * by1_5 + law_8 * by1_16;
    double by1_19 = omega_z * by1_18 - omega_y * by1_17;
    double by1_20 = law_15 * by1_7 + law_7 * by1_16;
    double by1_21 = omega_x * by1_17 - omega_z * by1_20;
    double by1_22 = law_13 * by1_15;
    double by1_23 = law_19 * Piecewise.choose(law_10, 0.0, 0.0, by1_15);
    double by1_24 = by1_23 + by1_23;
    double by1_25 = Piecewise.choose(law_19, 0.05, law_23 * by1_24 + law_21 * (law_22 * by1_24
        + 8.267195767195768e-7 * by1_24 * law_21), -((law_20 * by1_14 - (by1_1
        + law_20 * by1_9) / law_11 * law_12 + law_25 * (by1_22 + by1_22)) / law_24));
    double by1_26 = omega_y * by1_20 - omega_x * by1_18;
    double by1_27 = law_32 * by1_25 + law_26 * (law_28 * by1_20 + law_16 * by1_21 - (law_27 * by1_18
        + law_17 * by1_19)) - 0.5 * by1_26;
    double by1_28 = law_31 * by1_25 + law_26 * (law_27 * by1_17 + law_18 * by1_19 - (law_29 * by1_20
        + law_16 * by1_26)) - 0.5 * by1_21;
    double by1_29 = law_30 * by1_25 + law_26 * (law_29 * by1_18 + law_17 * by1_26 - (law_28 * by1_17
        + law_18 * by1_21)) - 0.5 * by1_19;
    double by1_30 = C_33 * by1_29 + K_33 * by1_20 + K_34 * by1_18 + C_34 * by1_28 + K_35 * by1_17
        + C_35 * by1_27;
    double by1_31 = C_21 * by1_29 + K_21 * by1_20 + K_22 * by1_18 + C_22 * by1_28 + K_23 * by1_17
        + C_23 * by1_27;
    double by1_32 = law_37 * by1_17 - law_18 * by1_31 - (law_41 * by1_20 - law_16 * by1_30);
    double by1_33 = C_27 * by1_29 + K_27 * by1_20 + K_28 * by1_18 + C_28 * by1_28 + K_29 * by1_17
        + C_29 * by1_27;
    double by1_34 = law_39 * by1_20 - law_16 * by1_33 - (law_37 * by1_18 - law_17 * by1_31);
    double by1_35 = law_41 * by1_18 - law_17 * by1_30 - (law_39 * by1_17 - law_18 * by1_33);
    out[0] = law_45 * by1_25 + law_26 * (law_44 * by1_18 + law_17 * by1_34 - (law_43 * by1_17
        + law_18 * by1_32)) + (0.5 * by1_35 - by1_31);
    out[12] = law_46 * by1_25 + law_26 * (law_42 * by1_17 + law_18 * by1_35 - (law_44 * by1_20
        + law_16 * by1_34)) + (0.5 * by1_32 - by1_33);
    out[24] = law_47 * by1_25 + law_26 * (law_43 * by1_20 + law_16 * by1_32 - (law_42 * by1_18
        + law_17 * by1_35)) + (0.5 * by1_34 - by1_30);
    out[36] = -(C_3 * by1_29 + K_3 * by1_20 + K_4 * by1_18 + C_4 * by1_28 + K_5 * by1_17
        + C_5 * by1_27);
    out[48] = -(C_9 * by1_29 + K_9 * by1_20 + K_10 * by1_18 + C_10 * by1_28 + K_11 * by1_17
        + C_11 * by1_27);
    out[60] = -(C_15 * by1_29 + K_15 * by1_20 + K_16 * by1_18 + C_16 * by1_28 + K_17 * by1_17
        + C_17 * by1_27);

    // Derivatives by motion 2.
    double by2_1 = 0.5 * law_4 / law_1 * 0.5;
    double by2_2 = law_6 * by2_1 / law_2;
    double by2_3 = law_5 * by2_2 - R_zy * law_6;
    double by2_4 = law_9 * by2_3;
    double by2_5 = law_6 * (R_xx + R_zz) + law_4 * by2_2;
    double by2_6 = law_8 * by2_5;
    double by2_7 = law_3 * by2_2 - R_xy * law_6;
    double by2_8 = law_7 * by2_7;
    double by2_9 = 0.5 * Piecewise.choose(law_10, 0.0, 0.0, by2_4 + by2_4 + (by2_6 + by2_6 + (by2_8
        + by2_8))) / law_11;
    double by2_10 = by1_12 * by2_9 + by1_13 * by2_1;
    double by2_11 = 2.0 * by2_10;
    double by2_12 = Piecewise.choose(law_10, 0.0, 0.0, (by2_11 - law_14 * by2_9) / law_11);
    double by2_13 = law_15 * by2_3 + law_9 * by2_12;
    double by2_14 = law_15 * by2_5 + law_8 * by2_12;
    double by2_15 = omega_z * by2_14 - omega_y * by2_13;
    double by2_16 = law_15 * by2_7 + law_7 * by2_12;
    double by2_17 = omega_x * by2_13 - omega_z * by2_16;
    double by2_18 = law_13 * by2_11;
    double by2_19 = law_19 * Piecewise.choose(law_10, 0.0, 0.0, by2_11);
    double by2_20 = by2_19 + by2_19;
    double by2_21 = Piecewise.choose(law_19, 0.05, law_23 * by2_20 + law_21 * (law_22 * by2_20
        + 8.267195767195768e-7 * by2_20 * law_21), -((law_20 * by2_10 - (by2_1
        + law_20 * by2_9) / law_11 * law_12 + law_25 * (by2_18 + by2_18)) / law_24));
    double by2_22 = omega_y * by2_16 - omega_x * by2_14;
    double by2_23 = law_32 * by2_21 + law_26 * (law_28 * by2_16 + law_16 * by2_17 - (law_27 * by2_14
        + law_17 * by2_15)) - 0.5 * by2_22;
    double by2_24 = law_31 * by2_21 + law_26 * (law_27 * by2_13 + law_18 * by2_15 - (law_29 * by2_16
        + law_16 * by2_22)) - 0.5 * by2_17;
    double by2_25 = law_30 * by2_21 + law_26 * (law_29 * by2_14 + law_17 * by2_22 - (law_28 * by2_13
        + law_18 * by2_17)) - 0.5 * by2_15;
    double by2_26 = C_33 * by2_25 + K_33 * by2_16 + K_34 * by2_14 + C_34 * by2_24 + K_35 * by2_13
        + C_35 * by2_23;
    double by2_27 = C_21 * by2_25 + K_21 * by2_16 + K_22 * by2_14 + C_22 * by2_24 + K_23 * by2_13
        + C_23 * by2_23;
    double by2_28 = law_37 * by2_13 - law_18 * by2_27 - (law_41 * by2_16 - law_16 * by2_26);
    double by2_29 = C_27 * by2_25 + K_27 * by2_16 + K_28 * by2_14 + C_28 * by2_24 + K_29 * by2_13
        + C_29 * by2_23;
    double by2_30 = law_39 * by2_16 - law_16 * by2_29 - (law_37 * by2_14 - law_17 * by2_27);
    double by2_31 = law_41 * by2_14 - law_17 * by2_26 - (law_39 * by2_13 - law_18 * by2_29);
    out[1] = law_45 * by2_21 + law_26 * (law_44 * by2_14 + law_17 * by2_30 - (law_43 * by2_13
        + law_18 * by2_28)) + (0.5 * by2_31 - by2_27);
    out[13] = law_46 * by2_21 + law_26 * (law_42 * by2_13 + law_18 * by2_31 - (law_44 * by2_16
        + law_16 * by2_30)) + (0.5 * by2_28 - by2_29);
    out[25] = law_47 * by2_21 + law_26 * (law_43 * by2_16 + law_16 * by2_28 - (law_42 * by2_14
        + law_17 * by2_31)) + (0.5 * by2_30 - by2_26);
    out[37] = -(C_3 * by2_25 + K_3 * by2_16 + K_4 * by2_14 + C_4 * by2_24 + K_5 * by2_13
        + C_5 * by2_23);
    out[49] = -(C_9 * by2_25 + K_9 * by2_16 + K_10 * by2_14 + C_10 * by2_24 + K_11 * by2_13
        + C_11 * by2_23);
    out[61] = -(C_15 * by2_25 + K_15 * by2_16 + K_16 * by2_14 + C_16 * by2_24 + K_17 * by2_13
        + C_17 * by2_23);

    // Derivatives by motion 3.
    double by3_1 = 0.5 * law_5 / law_1 * 0.5;
    double by3_2 = law_6 * by3_1 / law_2;
    double by3_3 = law_6 * (R_xx + R_yy) + law_5 * by3_2;
    double by3_4 = law_9 * by3_3;
    double by3_5 = law_4 * by3_2 - R_yz * law_6;
    double by3_6 = law_8 * by3_5;
    double by3_7 = law_3 * by3_2 - R_xz * law_6;
    double by3_8 = law_7 * by3_7;
    double by3_9 = 0.5 * Piecewise.choose(law_10, 0.0, 0.0, by3_4 + by3_4 + (by3_6 + by3_6 + (by3_8
        + by3_8))) / law_11;
    double by3_10 = by1_12 * by3_9 + by1_13 * by3_1;
    double by3_11 = 2.0 * by3_10;
    double by3_12 = Piecewise.choose(law_10, 0.0, 0.0, (by3_11 - law_14 * by3_9) / law_11);
    double by3_13 = law_15 * by3_3 + law_9 * by3_12;
    double by3_14 = law_15 * by3_5 + law_8 * by3_12;
    double by3_15 = omega_z * by3_14 - omega_y * by3_13;
    double by3_16 = law_15 * by3_7 + law_7 * by3_12;
    double by3_17 = omega_x * by3_13 - omega_z * by3_16;
    double by3_18 = law_13 * by3_11;
    double by3_19 = law_19 * Piecewise.choose(law_10, 0.0, 0.0, by3_11);
    double by3_20 = by3_19 + by3_19;
    double by3_21 = Piecewise.choose(law_19, 0.05, law_23 * by3_20 + law_21 * (law_22 * by3_20
        + 8.267195767195768e-7 * by3_20 * law_21), -((law_20 * by3_10 - (by3_1
        + law_20 * by3_9) / law_11 * law_12 + law_25 * (by3_18 + by3_18)) / law_24));
    double by3_22 = omega_y * by3_16 - omega_x * by3_14;
    double by3_23 = law_32 * by3_21 + law_26 * (law_28 * by3_16 + law_16 * by3_17 - (law_27 * by3_14
        + law_17 * by3_15)) - 0.5 * by3_22;
    double by3_24 = law_31 * by3_21 + law_26 * (law_27 * by3_13 + law_18 * by3_15 - (law_29 * by3_16
        + law_16 * by3_22)) - 0.5 * by3_17;
    double by3_25 = law_30 * by3_21 + law_26 * (law_29 * by3_14 + law_17 * by3_22 - (law_28 * by3_13
        + law_18 * by3_17)) - 0.5 * by3_15;
    double by3_26 = C_33 * by3_25 + K_33 * by3_16 + K_34 * by3_14 + C_34 * by3_24 + K_35 * by3_13
        + C_35 * by3_23;
    double by3_27 = C_21 * by3_25 + K_21 * by3_16 + K_22 * by3_14 + C_22 * by3_24 + K_23 * by3_13
        + C_23 * by3_23;
    double by3_28 = law_37 * by3_13 - law_18 * by3_27 - (law_41 * by3_16 - law_16 * by3_26);
    double by3_29 = C_27 * by3_25 + K_27 * by3_16 + K_28 * by3_14 + C_28 * by3_24 + K_29 * by3_13
        + C_29 * by3_23;
    double by3_30 = law_39 * by3_16 - law_16 * by3_29 - (law_37 * by3_14 - law_17 * by3_27);
    double by3_31 = law_41 * by3_14 - law_17 * by3_26 - (law_39 * by3_13 - law_18 * by3_29);
    out[2] = law_45 * by3_21 + law_26 * (law_44 * by3_14 + law_17 * by3_30 - (law_43 * by3_13
        + law_18 * by3_28)) + (0.5 * by3_31 - by3_27);
    out[14] = law_46 * by3_21 + law_26 * (law_42 * by3_13 + law_18 * by3_31 - (law_44 * by3_16
        + law_16 * by3_30)) + (0.5 * by3_28 - by3_29);
    out[26] = law_47 * by3_21 + law_26 * (law_43 * by3_16 + law_16 * by3_28 - (law_42 * by3_14
        + law_17 * by3_31)) + (0.5 * by3_30 - by3_26);
    out[38] = -(C_3 * by3_25 + K_3 * by3_16 + K_4 * by3_14 + C_4 * by3_24 + K_5 * by3_13
        + C_5 * by3_23);
    out[50] = -(C_9 * by3_25 + K_9 * by3_16 + K_10 * by3_14 + C_10 * by3_24 + K_11 * by3_13
        + C_11 * by3_23);
    out[62] = -(C_15 * by3_25 + K_15 * by3_16 + K_16 * by3_14 + C_16 * by3_24 + K_17 * by3_13
        + C_17 * by3_23);

    // Derivatives by motion 4.
    double by4_1 = K_30 * law_16 - K_18 * law_18;
    double by4_2 = K_18 * law_17 - K_24 * law_16;
    double by4_3 = K_24 * law_18 - K_30 * law_17;
    out[3] = 0.5 * by4_3 - K_18 + law_26 * (law_17 * by4_2 - law_18 * by4_1);
    out[15] = 0.5 * by4_1 - K_24 + law_26 * (law_18 * by4_3 - law_16 * by4_2);
    out[27] = 0.5 * by4_2 - K_30 + law_26 * (law_16 * by4_1 - law_17 * by4_3);
    out[39] = -c[0];
    out[51] = -c[6];
    out[63] = -c[12];

    // Derivatives by motion 5.
    double by5_1 = K_31 * law_16 - K_19 * law_18;
    double by5_2 = K_19 * law_17 - K_25 * law_16;
    double by5_3 = K_25 * law_18 - K_31 * law_17;
    out[4] = 0.5 * by5_3 - K_19 + law_26 * (law_17 * by5_2 - law_18 * by5_1);
    out[16] = 0.5 * by5_1 - K_25 + law_26 * (law_18 * by5_3 - law_16 * by5_2);
    out[28] = 0.5 * by5_2 - K_31 + law_26 * (law_16 * by5_1 - law_17 * by5_3);
    out[40] = -c[1];
    out[52] = -c[7];
    out[64] = -c[13];

    // Derivatives by motion 6.
    double by6_1 = K_32 * law_16 - K_20 * law_18;
    double by6_2 = K_20 * law_17 - K_26 * law_16;
    double by6_3 = K_26 * law_18 - K_32 * law_17;
    out[5] = 0.5 * by6_3 - K_20 + law_26 * (law_17 * by6_2 - law_18 * by6_1);
    out[17] = 0.5 * by6_1 - K_26 + law_26 * (law_18 * by6_3 - law_16 * by6_2);
    out[29] = 0.5 * by6_2 - K_32 + law_26 * (law_16 * by6_1 - law_17 * by6_3);
    out[41] = -c[2];
    out[53] = -c[8];
    out[65] = -c[14];

    // Derivatives by motion 7.
    double by7_1 = law_16 * law_18 * law_26;
    double by7_2 = -0.5 * law_17;
    double by7_3 = by7_1 - by7_2;
    double by7_4 = law_16 * law_17 * law_26;
    double by7_5 = -0.5 * law_18;
    double by7_6 = by7_4 + by7_5;
    double by7_7 = law_18 * law_18;
    double by7_8 = law_17 * law_17;
    double by7_9 = 1.0 - law_26 * (by7_7 + by7_8);
    double by7_10 = C_34 * by7_6 + C_33 * by7_9 + C_35 * by7_3;
    double by7_11 = C_22 * by7_6 + C_21 * by7_9 + C_23 * by7_3;
    double by7_12 = law_16 * by7_10 - law_18 * by7_11;
    double by7_13 = C_28 * by7_6 + C_27 * by7_9 + C_29 * by7_3;
    double by7_14 = law_17 * by7_11 - law_16 * by7_13;
    double by7_15 = law_18 * by7_13 - law_17 * by7_10;
    out[6] = 0.5 * by7_15 - by7_11 + law_26 * (law_17 * by7_14 - law_18 * by7_12);
    out[18] = 0.5 * by7_12 - by7_13 + law_26 * (law_18 * by7_15 - law_16 * by7_14);
    out[30] = 0.5 * by7_14 - by7_10 + law_26 * (law_16 * by7_12 - law_17 * by7_15);
    out[42] = -(C_4 * by7_6 + C_3 * by7_9 + C_5 * by7_3);
    out[54] = -(C_10 * by7_6 + C_9 * by7_9 + C_11 * by7_3);
    out[66] = -(C_16 * by7_6 + C_15 * by7_9 + C_17 * by7_3);

    // Derivatives by motion 8.
    double by8_1 = law_17 * law_18 * law_26;
    double by8_2 = -0.5 * law_16;
    double by8_3 = by8_1 + by8_2;
    double by8_4 = law_16 * law_16;
    double by8_5 = 1.0 - law_26 * (by7_7 + by8_4);
    double by8_6 = by7_4 - by7_5;
    double by8_7 = C_34 * by8_5 + C_33 * by8_6 + C_35 * by8_3;
    double by8_8 = C_22 * by8_5 + C_21 * by8_6 + C_23 * by8_3;
    double by8_9 = law_16 * by8_7 - law_18 * by8_8;
    double by8_10 = C_28 * by8_5 + C_27 * by8_6 + C_29 * by8_3;
    double by8_11 = law_17 * by8_8 - law_16 * by8_10;
    double by8_12 = law_18 * by8_10 - law_17 * by8_7;
    out[7] = 0.5 * by8_12 - by8_8 + law_26 * (law_17 * by8_11 - law_18 * by8_9);
    out[19] = 0.5 * by8_9 - by8_10 + law_26 * (law_18 * by8_12 - law_16 * by8_11);
    out[31] = 0.5 * by8_11 - by8_7 + law_26 * (law_16 * by8_9 - law_17 * by8_12);
    out[43] = -(C_4 * by8_5 + C_3 * by8_6 + C_5 * by8_3);
    out[55] = -(C_10 * by8_5 + C_9 * by8_6 + C_11 * by8_3);
    out[67] = -(C_16 * by8_5 + C_15 * by8_6 + C_17 * by8_3);

    // Derivatives by motion 9.
    double by9_1 = 1.0 - law_26 * (by7_8 + by8_4);
    double by9_2 = by8_1 - by8_2;
    double by9_3 = by7_1 + by7_2;
    double by9_4 = C_34 * by9_2 + C_33 * by9_3 + C_35 * by9_1;
    double by9_5 = C_22 * by9_2 + C_21 * by9_3 + C_23 * by9_1;
    double by9_6 = law_16 * by9_4 - law_18 * by9_5;
    double by9_7 = C_28 * by9_2 + C_27 * by9_3 + C_29 * by9_1;
    double by9_8 = law_17 * by9_5 - law_16 * by9_7;
    double by9_9 = law_18 * by9_7 - law_17 * by9_4;
    out[8] = 0.5 * by9_9 - by9_5 + law_26 * (law_17 * by9_8 - law_18 * by9_6);
    out[20] = 0.5 * by9_6 - by9_7 + law_26 * (law_18 * by9_9 - law_16 * by9_8);
    out[32] = 0.5 * by9_8 - by9_4 + law_26 * (law_16 * by9_6 - law_17 * by9_9);
    out[44] = -(C_4 * by9_2 + C_3 * by9_3 + C_5 * by9_1);
    out[56] = -(C_10 * by9_2 + C_9 * by9_3 + C_11 * by9_1);
    out[68] = -(C_16 * by9_2 + C_15 * by9_3 + C_17 * by9_1);

    // Derivatives by motion 10.
    double by10_1 = C_30 * law_16 - C_18 * law_18;
    double by10_2 = C_18 * law_17 - C_24 * law_16;
    double by10_3 = C_24 * law_18 - C_30 * law_17;
    out[9] = 0.5 * by10_3 - C_18 + law_26 * (law_17 * by10_2 - law_18 * by10_1);
    out[21] = 0.5 * by10_1 - C_24 + law_26 * (law_18 * by10_3 - law_16 * by10_2);
    out[33] = 0.5 * by10_2 - C_30 + law_26 * (law_16 * by10_1 - law_17 * by10_3);
    out[45] = -c[36];
    out[57] = -c[42];
    out[69] = -c[48];

    // Derivatives by motion 11.
    double by11_1 = C_31 * law_16 - C_19 * law_18;
    double by11_2 = C_19 * law_17 - C_25 * law_16;
    double by11_3 = C_25 * law_18 - C_31 * law_17;
    out[10] = 0.5 * by11_3 - C_19 + law_26 * (law_17 * by11_2 - law_18 * by11_1);
    out[22] = 0.5 * by11_1 - C_25 + law_26 * (law_18 * by11_3 - law_16 * by11_2);
    out[34] = 0.5 * by11_2 - C_31 + law_26 * (law_16 * by11_1 - law_17 * by11_3);
    out[46] = -c[37];
    out[58] = -c[43];
    out[70] = -c[49];

    // Derivatives by motion 12.
    double by12_1 = C_32 * law_16 - C_20 * law_18;
    double by12_2 = C_20 * law_17 - C_26 * law_16;
    double by12_3 = C_26 * law_18 - C_32 * law_17;
    out[11] = 0.5 * by12_3 - C_20 + law_26 * (law_17 * by12_2 - law_18 * by12_1);
    out[23] = 0.5 * by12_1 - C_26 + law_26 * (law_18 * by12_3 - law_16 * by12_2);
    out[35] = 0.5 * by12_2 - C_32 + law_26 * (law_16 * by12_1 - law_17 * by12_3);
    out[47] = -c[38];
    out[59] = -c[44];
    out[71] = -c[50];
  }

  @Override
  public void results(double[] x, double[] c, double[] out) {
    // The load by its formula.
    double r_x = x[0];
    double r_y = x[1];
    double r_z = x[2];
    double omega_x = x[12];
    double omega_y = x[13];
    double omega_z = x[14];
    double u_x = x[15];
    double u_y = x[16];
    double u_z = x[17];
    double K_0 = c[0];
    double K_1 = c[1];
    double K_2 = c[2];
    double K_3 = c[3];
    double K_4 = c[4];
    double K_5 = c[5];
    double K_6 = c[6];
    double K_7 = c[7];
    double K_8 = c[8];
    double K_9 = c[9];
    double K_10 = c[10];
    double K_11 = c[11];
    double K_12 = c[12];
    double K_13 = c[13];
    double K_14 = c[14];
    double K_15 = c[15];
    double K_16 = c[16];
    double K_17 = c[17];
    double K_18 = c[18];
    double K_19 = c[19];
    double K_20 = c[20];
    double K_21 = c[21];
    double K_22 = c[22];
    double K_23 = c[23];
    double K_24 = c[24];
    double K_25 = c[25];
    double K_26 = c[26];
    double K_27 = c[27];
    double K_28 = c[28];
    double K_29 = c[29];
    double K_30 = c[30];
    double K_31 = c[31];
    double K_32 = c[32];
    double K_33 = c[33];
    double K_34 = c[34];
    double K_35 = c[35];
    double preload_0 = c[72];
    double preload_1 = c[73];
    double preload_2 = c[74];
    double preload_3 = c[75];
    double preload_4 = c[76];
    double preload_5 = c[77];
    double law_1 = 0.5 * Math.sqrt(1.0 + x[3] + x[7] + x[11]);
    double law_2 = 0.25 / law_1;
    double law_3 = (x[10] - x[8]) * law_2;
    double law_4 = (x[5] - x[9]) * law_2;
    double law_5 = (x[6] - x[4]) * law_2;
    double law_6 = law_3 * law_3 + law_4 * law_4 + law_5 * law_5;
    double law_7 = Math.sqrt(Piecewise.choose(law_6, 0.0, 1.0, law_6));
    double law_8 = StrictMath.atan2(law_7, law_1);
    double law_9 = 2.0 * law_8;
    double law_10 = Piecewise.choose(law_6, 0.0, 2.0, law_9 / law_7);
    double law_11 = law_3 * law_10;
    double law_12 = law_4 * law_10;
    double law_13 = law_5 * law_10;
    double law_14 = Piecewise.choose(law_6, 0.0, 0.0, law_9);
    double law_15 = law_14 * law_14;
    double law_16 = Piecewise.choose(law_14, 0.05, 0.08333333333333333
        + law_15 * (0.001388888888888889 + law_15 * (3.306878306878307e-5
        + 8.267195767195768e-7 * law_15)), (1.0 - law_1 / law_7 * law_8) / (law_9 * law_9));
    double law_17 = omega_z * law_12 - omega_y * law_13;
    double law_18 = omega_x * law_13 - omega_z * law_11;
    double law_19 = omega_y * law_11 - omega_x * law_12;
    double law_20 = omega_x - 0.5 * law_17 + law_16 * (law_12 * law_19 - law_13 * law_18);
    double law_21 = omega_y - 0.5 * law_18 + law_16 * (law_13 * law_17 - law_11 * law_19);
    double law_22 = omega_z - 0.5 * law_19 + law_16 * (law_11 * law_18 - law_12 * law_17);
    double law_23 = preload_0 - r_x * K_0 - u_x * c[36] - r_y * K_1 - u_y * c[37] - r_z * K_2
        - u_z * c[38] - K_3 * law_11;
    double law_24 = law_23 - c[39] * law_20 - K_4 * law_12 - c[40] * law_21 - K_5 * law_13
        - c[41] * law_22;
    double law_25 = preload_1 - r_x * K_6 - u_x * c[42] - r_y * K_7 - u_y * c[43] - r_z * K_8
        - u_z * c[44] - K_9 * law_11;
    double law_26 = law_25 - c[45] * law_20 - K_10 * law_12 - c[46] * law_21 - K_11 * law_13
        - c[47] * law_22;
    double law_27 = preload_2 - r_x * K_12 - u_x * c[48] - r_y * K_13 - u_y * c[49] - r_z * K_14
        - u_z * c[50] - K_15 * law_11;
    double law_28 = law_27 - c[51] * law_20 - K_16 * law_12 - c[52] * law_21 - K_17 * law_13
        - c[53] * law_22;
    double law_29 = preload_3 - r_x * K_18 - u_x * c[54] - r_y * K_19 - u_y * c[55] - r_z * K_20
        - u_z * c[56] - K_21 * law_11;
    double law_30 = law_29 - c[57] * law_20 - K_22 * law_12 - c[58] * law_21 - K_23 * law_13
        - c[59] * law_22;
    double law_31 = preload_4 - r_x * K_24 - u_x * c[60] - r_y * K_25 - u_y * c[61] - r_z * K_26
        - u_z * c[62] - K_27 * law_11;
    double law_32 = law_31 - c[63] * law_20 - K_28 * law_12 - c[64] * law_21 - K_29 * law_13
        - c[65] * law_22;
    double law_33 = preload_5 - r_x * K_30 - u_x * c[66] - r_y * K_31 - u_y * c[67] - r_z * K_32
        - u_z * c[68] - K_33 * law_11;
    double law_34 = law_33 - c[69] * law_20 - K_34 * law_12 - c[70] * law_21 - K_35 * law_13
        - c[71] * law_22;
    double law_35 = r_x * r_y;
    double law_36 = r_x * r_z;
    double law_37 = r_x * law_11;
    double law_38 = r_x * law_12;
    double law_39 = r_x * r_x * (0.5 * K_0) + 0.5 * K_1 * law_35 + 0.5 * K_2 * law_36
        + 0.5 * K_3 * law_37 + 0.5 * K_4 * law_38;
    double law_40 = r_x * law_13;
    double law_41 = r_y * r_z;
    double law_42 = law_39 + 0.5 * K_5 * law_40 - r_x * preload_0 + 0.5 * K_6 * law_35
        + r_y * r_y * (0.5 * K_7) + 0.5 * K_8 * law_41;
    double law_43 = r_y * law_11;
    double law_44 = r_y * law_12;
    double law_45 = r_y * law_13;
    double law_46 = law_42 + 0.5 * K_9 * law_43 + 0.5 * K_10 * law_44 + 0.5 * K_11 * law_45
        - r_y * preload_1 + 0.5 * K_12 * law_36;
    double law_47 = r_z * law_11;
    double law_48 = r_z * law_12;
    double law_49 = r_z * law_13;
    double law_50 = law_46 + 0.5 * K_13 * law_41 + r_z * r_z * (0.5 * K_14) + 0.5 * K_15 * law_47
        + 0.5 * K_16 * law_48 + 0.5 * K_17 * law_49;
    double law_51 = law_50 - r_z * preload_2 + 0.5 * K_18 * law_37 + 0.5 * K_19 * law_43
        + 0.5 * K_20 * law_47 + law_11 * law_11 * (0.5 * K_21);
    double law_52 = law_11 * law_12;
    double law_53 = law_11 * law_13;
    double law_54 = law_51 + 0.5 * K_22 * law_52 + 0.5 * K_23 * law_53 - preload_3 * law_11
        + 0.5 * K_24 * law_38 + 0.5 * K_25 * law_44;
    double law_55 = law_12 * law_13;
    double law_56 = law_54 + 0.5 * K_26 * law_48 + 0.5 * K_27 * law_52
        + law_12 * law_12 * (0.5 * K_28) + 0.5 * K_29 * law_55 - preload_4 * law_12;
    double law_57 = law_56 + 0.5 * K_30 * law_40 + 0.5 * K_31 * law_45 + 0.5 * K_32 * law_49
        + 0.5 * K_33 * law_53 + 0.5 * K_34 * law_55;
    double law_58 = law_12 * law_34 - law_13 * law_32;
    double law_59 = law_13 * law_30 - law_11 * law_34;
    double law_60 = law_11 * law_32 - law_12 * law_30;
    double law_61 = law_30 + 0.5 * law_58 + law_16 * (law_12 * law_60 - law_13 * law_59);
    double law_62 = law_32 + 0.5 * law_59 + law_16 * (law_13 * law_58 - law_11 * law_60);
    double law_63 = law_34 + 0.5 * law_60 + law_16 * (law_11 * law_59 - law_12 * law_58);
    double law_64 = 0.5 * (K_1 + K_6);
    double law_65 = 0.5 * (K_2 + K_12);
    double law_66 = 0.5 * (K_3 + K_18);
    double law_67 = 0.5 * (K_4 + K_24);
    double law_68 = 0.5 * (K_5 + K_30);
    double law_69 = 0.5 * (K_0 + K_0) * r_x - preload_0 + r_y * law_64 + r_z * law_65
        + law_11 * law_66 + law_12 * law_67 + law_13 * law_68;
    double law_70 = 0.5 * (K_8 + K_13);
    double law_71 = 0.5 * (K_9 + K_19);
    double law_72 = 0.5 * (K_10 + K_25);
    double law_73 = 0.5 * (K_11 + K_31);
    double law_74 = r_x * law_64 - preload_1 + 0.5 * (K_7 + K_7) * r_y + r_z * law_70
        + law_11 * law_71 + law_12 * law_72 + law_13 * law_73;
    double law_75 = u_x * law_24 + u_y * law_26 + u_z * law_28 + (omega_x * law_61
        + omega_y * law_62 + omega_z * law_63) + u_x * law_69 + u_y * law_74;
    double law_76 = 0.5 * (K_15 + K_20);
    double law_77 = 0.5 * (K_16 + K_26);
    double law_78 = 0.5 * (K_17 + K_32);
    double law_79 = r_x * law_65 - preload_2 + r_y * law_70 + 0.5 * (K_14 + K_14) * r_z
        + law_11 * law_76 + law_12 * law_77 + law_13 * law_78;
    double law_80 = 0.5 * (K_22 + K_27);
    double law_81 = 0.5 * (K_23 + K_33);
    double law_82 = r_x * law_66 - preload_3 + r_y * law_71 + r_z * law_76 + 0.5 * (K_21
        + K_21) * law_11 + law_12 * law_80 + law_13 * law_81;
    double law_83 = 0.5 * (K_29 + K_34);
    double law_84 = r_x * law_67 - preload_4 + r_y * law_72 + r_z * law_77 + law_11 * law_80
        + 0.5 * (K_28 + K_28) * law_12 + law_13 * law_83;
    double law_85 = r_x * law_68 - preload_5 + r_y * law_73 + r_z * law_78 + law_11 * law_81
        + law_12 * law_83 + 0.5 * (K_35 + K_35) * law_13;
    out[0] = law_57 + law_13 * law_13 * (0.5 * K_35) - preload_5 * law_13;
    out[1] = law_75 + u_z * law_79 + law_20 * law_82 + law_21 * law_84 + law_22 * law_85;
    System.arraycopy(x, 0, out, 2, 3);
    out[5] = law_11;
    out[6] = law_12;
    out[7] = law_13;
    out[8] = law_24;
    out[9] = law_26;
    out[10] = law_28;
    out[11] = law_61;
    out[12] = law_62;
    out[13] = law_63;
  }
}
