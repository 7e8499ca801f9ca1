package org.mechservice.solver.force.law.printed;

import org.mechservice.solver.force.law.PrintedLaw;
import org.mechservice.solver.spatial.Piecewise;

/**
 * Printed from its formula; do not edit. PrintedLawsTest compares it with the formula and
 * prints it anew with -Dgolden.write=true.
 */
final class PrintedLinearBushing implements PrintedLaw {

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
    double law_8 = Piecewise.choose(law_6, 0.0, 2.0, 2.0 * StrictMath.atan2(law_7, law_1) / law_7);
    double law_9 = law_3 * law_8;
    double law_10 = law_4 * law_8;
    double law_11 = law_5 * law_8;
    double law_12 = c[72] - r_x * c[0] - u_x * c[36] - r_y * c[1] - u_y * c[37] - r_z * c[2]
        - u_z * c[38] - c[3] * law_9;
    double law_13 = c[73] - r_x * c[6] - u_x * c[42] - r_y * c[7] - u_y * c[43] - r_z * c[8]
        - u_z * c[44] - c[9] * law_9;
    double law_14 = c[74] - r_x * c[12] - u_x * c[48] - r_y * c[13] - u_y * c[49] - r_z * c[14]
        - u_z * c[50] - c[15] * law_9;
    double law_15 = c[75] - r_x * c[18] - u_x * c[54] - r_y * c[19] - u_y * c[55] - r_z * c[20]
        - u_z * c[56] - c[21] * law_9;
    double law_16 = c[76] - r_x * c[24] - u_x * c[60] - r_y * c[25] - u_y * c[61] - r_z * c[26]
        - u_z * c[62] - c[27] * law_9;
    double law_17 = c[77] - r_x * c[30] - u_x * c[66] - r_y * c[31] - u_y * c[67] - r_z * c[32]
        - u_z * c[68] - c[33] * law_9;
    out[0] = law_15 - omega_x * c[57] - c[22] * law_10 - omega_y * c[58] - c[23] * law_11
        - omega_z * c[59];
    out[1] = law_16 - omega_x * c[63] - c[28] * law_10 - omega_y * c[64] - c[29] * law_11
        - omega_z * c[65];
    out[2] = law_17 - omega_x * c[69] - c[34] * law_10 - omega_y * c[70] - c[35] * law_11
        - omega_z * c[71];
    out[3] = law_12 - omega_x * c[39] - c[4] * law_10 - omega_y * c[40] - c[5] * law_11
        - omega_z * c[41];
    out[4] = law_13 - omega_x * c[45] - c[10] * law_10 - omega_y * c[46] - c[11] * law_11
        - omega_z * c[47];
    out[5] = law_14 - omega_x * c[51] - c[16] * law_10 - omega_y * c[52] - c[17] * law_11
        - omega_z * c[53];
    out[6] = law_1 - 0.001;
  }

  @Override
  public void slopes(double[] x, double[] c, double[] out) {
    // The load by its formula.
    double R_xx = x[3];
    double R_xy = x[4];
    double R_xz = x[5];
    double R_yx = x[6];
    double R_yy = x[7];
    double R_yz = x[8];
    double R_zx = x[9];
    double R_zy = x[10];
    double R_zz = x[11];
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
    double law_12 = 2.0 * StrictMath.atan2(law_11, law_2) / law_11;
    double law_13 = Piecewise.choose(law_10, 0.0, 2.0, law_12);

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
    double K_21 = c[21];
    double K_22 = c[22];
    double K_23 = c[23];
    double K_27 = c[27];
    double K_28 = c[28];
    double K_29 = c[29];
    double K_33 = c[33];
    double K_34 = c[34];
    double K_35 = c[35];
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
    double by1_14 = Piecewise.choose(law_10, 0.0, 0.0, (2.0 * (by1_9 * by1_12 + by1_1 * by1_13)
        - law_12 * by1_9) / law_11);
    double by1_15 = law_13 * by1_3 + law_9 * by1_14;
    double by1_16 = law_13 * by1_5 + law_8 * by1_14;
    double by1_17 = law_13 * by1_7 + law_7 * by1_14;
    out[0] = -(K_22 * by1_16 + K_21 * by1_17 + K_23 * by1_15);
    out[12] = -(K_28 * by1_16 + K_27 * by1_17 + K_29 * by1_15);
    out[24] = -(K_34 * by1_16 + K_33 * by1_17 + K_35 * by1_15);
    out[36] = -(K_4 * by1_16 + K_3 * by1_17 + K_5 * by1_15);
    out[48] = -(K_10 * by1_16 + K_9 * by1_17 + K_11 * by1_15);
    out[60] = -(K_16 * by1_16 + K_15 * by1_17 + K_17 * by1_15);

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
    double by2_10 = Piecewise.choose(law_10, 0.0, 0.0, (2.0 * (by1_12 * by2_9 + by1_13 * by2_1)
        - law_12 * by2_9) / law_11);
    double by2_11 = law_13 * by2_3 + law_9 * by2_10;
    double by2_12 = law_13 * by2_5 + law_8 * by2_10;
    double by2_13 = law_13 * by2_7 + law_7 * by2_10;
    out[1] = -(K_22 * by2_12 + K_21 * by2_13 + K_23 * by2_11);
    out[13] = -(K_28 * by2_12 + K_27 * by2_13 + K_29 * by2_11);
    out[25] = -(K_34 * by2_12 + K_33 * by2_13 + K_35 * by2_11);
    out[37] = -(K_4 * by2_12 + K_3 * by2_13 + K_5 * by2_11);
    out[49] = -(K_10 * by2_12 + K_9 * by2_13 + K_11 * by2_11);
    out[61] = -(K_16 * by2_12 + K_15 * by2_13 + K_17 * by2_11);

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
    double by3_10 = Piecewise.choose(law_10, 0.0, 0.0, (2.0 * (by1_12 * by3_9 + by1_13 * by3_1)
        - law_12 * by3_9) / law_11);
    double by3_11 = law_13 * by3_3 + law_9 * by3_10;
    double by3_12 = law_13 * by3_5 + law_8 * by3_10;
    double by3_13 = law_13 * by3_7 + law_7 * by3_10;
    out[2] = -(K_22 * by3_12 + K_21 * by3_13 + K_23 * by3_11);
    out[14] = -(K_28 * by3_12 + K_27 * by3_13 + K_29 * by3_11);
    out[26] = -(K_34 * by3_12 + K_33 * by3_13 + K_35 * by3_11);
    out[38] = -(K_4 * by3_12 + K_3 * by3_13 + K_5 * by3_11);
    out[50] = -(K_10 * by3_12 + K_9 * by3_13 + K_11 * by3_11);
    out[62] = -(K_16 * by3_12 + K_15 * by3_13 + K_17 * by3_11);

    // Derivatives by motion 4.
    out[3] = -c[18];
    out[15] = -c[24];
    out[27] = -c[30];
    out[39] = -c[0];
    out[51] = -c[6];
    out[63] = -c[12];

    // Derivatives by motion 5.
    out[4] = -c[19];
    out[16] = -c[25];
    out[28] = -c[31];
    out[40] = -c[1];
    out[52] = -c[7];
    out[64] = -c[13];

    // Derivatives by motion 6.
    out[5] = -c[20];
    out[17] = -c[26];
    out[29] = -c[32];
    out[41] = -c[2];
    out[53] = -c[8];
    out[65] = -c[14];

    // Derivatives by motion 7.
    out[6] = -c[57];
    out[18] = -c[63];
    out[30] = -c[69];
    out[42] = -c[39];
    out[54] = -c[45];
    out[66] = -c[51];

    // Derivatives by motion 8.
    out[7] = -c[58];
    out[19] = -c[64];
    out[31] = -c[70];
    out[43] = -c[40];
    out[55] = -c[46];
    out[67] = -c[52];

    // Derivatives by motion 9.
    out[8] = -c[59];
    out[20] = -c[65];
    out[32] = -c[71];
    out[44] = -c[41];
    out[56] = -c[47];
    out[68] = -c[53];

    // Derivatives by motion 10.
    out[9] = -c[54];
    out[21] = -c[60];
    out[33] = -c[66];
    out[45] = -c[36];
    out[57] = -c[42];
    out[69] = -c[48];

    // Derivatives by motion 11.
    out[10] = -c[55];
    out[22] = -c[61];
    out[34] = -c[67];
    out[46] = -c[37];
    out[58] = -c[43];
    out[70] = -c[49];

    // Derivatives by motion 12.
    out[11] = -c[56];
    out[23] = -c[62];
    out[35] = -c[68];
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
    double law_17 = preload_0 - r_x * K_0 - u_x * c[36] - r_y * K_1 - u_y * c[37] - r_z * K_2
        - u_z * c[38] - K_3 * law_11;
    double law_18 = law_17 - omega_x * c[39] - K_4 * law_12 - omega_y * c[40] - K_5 * law_13
        - omega_z * c[41];
    double law_19 = preload_1 - r_x * K_6 - u_x * c[42] - r_y * K_7 - u_y * c[43] - r_z * K_8
        - u_z * c[44] - K_9 * law_11;
    double law_20 = law_19 - omega_x * c[45] - K_10 * law_12 - omega_y * c[46] - K_11 * law_13
        - omega_z * c[47];
    double law_21 = preload_2 - r_x * K_12 - u_x * c[48] - r_y * K_13 - u_y * c[49] - r_z * K_14
        - u_z * c[50] - K_15 * law_11;
    double law_22 = law_21 - omega_x * c[51] - K_16 * law_12 - omega_y * c[52] - K_17 * law_13
        - omega_z * c[53];
    double law_23 = preload_3 - r_x * K_18 - u_x * c[54] - r_y * K_19 - u_y * c[55] - r_z * K_20
        - u_z * c[56] - K_21 * law_11;
    double law_24 = law_23 - omega_x * c[57] - K_22 * law_12 - omega_y * c[58] - K_23 * law_13
        - omega_z * c[59];
    double law_25 = preload_4 - r_x * K_24 - u_x * c[60] - r_y * K_25 - u_y * c[61] - r_z * K_26
        - u_z * c[62] - K_27 * law_11;
    double law_26 = law_25 - omega_x * c[63] - K_28 * law_12 - omega_y * c[64] - K_29 * law_13
        - omega_z * c[65];
    double law_27 = preload_5 - r_x * K_30 - u_x * c[66] - r_y * K_31 - u_y * c[67] - r_z * K_32
        - u_z * c[68] - K_33 * law_11;
    double law_28 = law_27 - omega_x * c[69] - K_34 * law_12 - omega_y * c[70] - K_35 * law_13
        - omega_z * c[71];
    double law_29 = r_x * r_y;
    double law_30 = r_x * r_z;
    double law_31 = r_x * law_11;
    double law_32 = r_x * law_12;
    double law_33 = r_x * r_x * (0.5 * K_0) + 0.5 * K_1 * law_29 + 0.5 * K_2 * law_30
        + 0.5 * K_3 * law_31 + 0.5 * K_4 * law_32;
    double law_34 = r_x * law_13;
    double law_35 = r_y * r_z;
    double law_36 = law_33 + 0.5 * K_5 * law_34 - r_x * preload_0 + 0.5 * K_6 * law_29
        + r_y * r_y * (0.5 * K_7) + 0.5 * K_8 * law_35;
    double law_37 = r_y * law_11;
    double law_38 = r_y * law_12;
    double law_39 = r_y * law_13;
    double law_40 = law_36 + 0.5 * K_9 * law_37 + 0.5 * K_10 * law_38 + 0.5 * K_11 * law_39
        - r_y * preload_1 + 0.5 * K_12 * law_30;
    double law_41 = r_z * law_11;
    double law_42 = r_z * law_12;
    double law_43 = r_z * law_13;
    double law_44 = law_40 + 0.5 * K_13 * law_35 + r_z * r_z * (0.5 * K_14) + 0.5 * K_15 * law_41
        + 0.5 * K_16 * law_42 + 0.5 * K_17 * law_43;
    double law_45 = law_44 - r_z * preload_2 + 0.5 * K_18 * law_31 + 0.5 * K_19 * law_37
        + 0.5 * K_20 * law_41 + law_11 * law_11 * (0.5 * K_21);
    double law_46 = law_11 * law_12;
    double law_47 = law_11 * law_13;
    double law_48 = law_45 + 0.5 * K_22 * law_46 + 0.5 * K_23 * law_47 - preload_3 * law_11
        + 0.5 * K_24 * law_32 + 0.5 * K_25 * law_38;
    double law_49 = law_12 * law_13;
    double law_50 = law_48 + 0.5 * K_26 * law_42 + 0.5 * K_27 * law_46
        + law_12 * law_12 * (0.5 * K_28) + 0.5 * K_29 * law_49 - preload_4 * law_12;
    double law_51 = law_50 + 0.5 * K_30 * law_34 + 0.5 * K_31 * law_39 + 0.5 * K_32 * law_43
        + 0.5 * K_33 * law_47 + 0.5 * K_34 * law_49;
    double law_52 = omega_z * law_12 - omega_y * law_13;
    double law_53 = omega_x * law_13 - omega_z * law_11;
    double law_54 = omega_y * law_11 - omega_x * law_12;
    double law_55 = 0.5 * (K_1 + K_6);
    double law_56 = 0.5 * (K_2 + K_12);
    double law_57 = 0.5 * (K_3 + K_18);
    double law_58 = 0.5 * (K_4 + K_24);
    double law_59 = 0.5 * (K_5 + K_30);
    double law_60 = 0.5 * (K_0 + K_0) * r_x - preload_0 + r_y * law_55 + r_z * law_56
        + law_11 * law_57 + law_12 * law_58 + law_13 * law_59;
    double law_61 = 0.5 * (K_8 + K_13);
    double law_62 = 0.5 * (K_9 + K_19);
    double law_63 = 0.5 * (K_10 + K_25);
    double law_64 = 0.5 * (K_11 + K_31);
    double law_65 = r_x * law_55 - preload_1 + 0.5 * (K_7 + K_7) * r_y + r_z * law_61
        + law_11 * law_62 + law_12 * law_63 + law_13 * law_64;
    double law_66 = u_x * law_18 + u_y * law_20 + u_z * law_22 + (omega_x * law_24
        + omega_y * law_26 + omega_z * law_28) + u_x * law_60 + u_y * law_65;
    double law_67 = 0.5 * (K_15 + K_20);
    double law_68 = 0.5 * (K_16 + K_26);
    double law_69 = 0.5 * (K_17 + K_32);
    double law_70 = r_x * law_56 - preload_2 + r_y * law_61 + 0.5 * (K_14 + K_14) * r_z
        + law_11 * law_67 + law_12 * law_68 + law_13 * law_69;
    double law_71 = 0.5 * (K_22 + K_27);
    double law_72 = 0.5 * (K_23 + K_33);
    double law_73 = r_x * law_57 - preload_3 + r_y * law_62 + r_z * law_67 + 0.5 * (K_21
        + K_21) * law_11 + law_12 * law_71 + law_13 * law_72;
    double law_74 = 0.5 * (K_29 + K_34);
    double law_75 = r_x * law_58 - preload_4 + r_y * law_63 + r_z * law_68 + law_11 * law_71
        + 0.5 * (K_28 + K_28) * law_12 + law_13 * law_74;
    double law_76 = law_66 + u_z * law_70 + (omega_x - 0.5 * law_52 + law_16 * (law_12 * law_54
        - law_13 * law_53)) * law_73 + (omega_y - 0.5 * law_53 + law_16 * (law_13 * law_52
        - law_11 * law_54)) * law_75;
    double law_77 = r_x * law_59 - preload_5 + r_y * law_64 + r_z * law_69 + law_11 * law_72
        + law_12 * law_74 + 0.5 * (K_35 + K_35) * law_13;
    out[0] = law_51 + law_13 * law_13 * (0.5 * K_35) - preload_5 * law_13;
    out[1] = law_76 + (omega_z - 0.5 * law_54 + law_16 * (law_11 * law_53
        - law_12 * law_52)) * law_77;
    System.arraycopy(x, 0, out, 2, 3);
    out[5] = law_11;
    out[6] = law_12;
    out[7] = law_13;
    out[8] = law_18;
    out[9] = law_20;
    out[10] = law_22;
    out[11] = law_24;
    out[12] = law_26;
    out[13] = law_28;
  }
}
