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
    double u_x = x[15];
    double r_y = x[1];
    double u_y = x[16];
    double r_z = x[2];
    double u_z = x[17];
    double omega_x = x[12];
    double omega_y = x[13];
    double omega_z = x[14];
    double law_1 = 0.5 * Math.sqrt(1.0 + x[3] + x[7] + x[11]);
    double law_2 = 0.25 / law_1;
    double law_3 = (x[10] - x[8]) * law_2;
    double law_4 = (x[5] - x[9]) * law_2;
    double law_5 = (x[6] - x[4]) * law_2;
    double law_6 = law_3 * law_3 + law_4 * law_4 + law_5 * law_5;
    double law_7 = Math.sqrt(Piecewise.choose(law_6, 0.0, 1.0, law_6));
    double law_8 = Piecewise.choose(law_6, 0.0, 2.0, 2.0 * StrictMath.atan2(law_7, law_1) / law_7);
    double law_9 = law_3 * law_8;
    double law_10 = c[75] - r_x * c[18] - u_x * c[54] - r_y * c[19] - u_y * c[55] - r_z * c[20]
        - u_z * c[56] - c[21] * law_9;
    double law_11 = law_4 * law_8;
    double law_12 = law_5 * law_8;
    double law_13 = c[76] - r_x * c[24] - u_x * c[60] - r_y * c[25] - u_y * c[61] - r_z * c[26]
        - u_z * c[62] - c[27] * law_9;
    double law_14 = c[77] - r_x * c[30] - u_x * c[66] - r_y * c[31] - u_y * c[67] - r_z * c[32]
        - u_z * c[68] - c[33] * law_9;
    double law_15 = c[72] - r_x * c[0] - u_x * c[36] - r_y * c[1] - u_y * c[37] - r_z * c[2]
        - u_z * c[38] - c[3] * law_9;
    double law_16 = c[73] - r_x * c[6] - u_x * c[42] - r_y * c[7] - u_y * c[43] - r_z * c[8]
        - u_z * c[44] - c[9] * law_9;
    double law_17 = c[74] - r_x * c[12] - u_x * c[48] - r_y * c[13] - u_y * c[49] - r_z * c[14]
        - u_z * c[50] - c[15] * law_9;
    out[0] = law_10 - omega_x * c[57] - c[22] * law_11 - omega_y * c[58] - c[23] * law_12
        - omega_z * c[59];
    out[1] = law_13 - omega_x * c[63] - c[28] * law_11 - omega_y * c[64] - c[29] * law_12
        - omega_z * c[65];
    out[2] = law_14 - omega_x * c[69] - c[34] * law_11 - omega_y * c[70] - c[35] * law_12
        - omega_z * c[71];
    out[3] = law_15 - omega_x * c[39] - c[4] * law_11 - omega_y * c[40] - c[5] * law_12
        - omega_z * c[41];
    out[4] = law_16 - omega_x * c[45] - c[10] * law_11 - omega_y * c[46] - c[11] * law_12
        - omega_z * c[47];
    out[5] = law_17 - omega_x * c[51] - c[16] * law_11 - omega_y * c[52] - c[17] * law_12
        - omega_z * c[53];
    out[6] = law_1 - 0.001;
  }

  @Override
  public void slopes(double[] x, double[] c, double[] out) {
    // Derivatives by motion 1.
    double K_23 = c[23];
    double R_zy = x[10];
    double R_yz = x[8];
    double R_zz = x[11];
    double R_yy = x[7];
    double R_xx = x[3];
    double R_xz = x[5];
    double R_zx = x[9];
    double R_yx = x[6];
    double R_xy = x[4];
    double K_22 = c[22];
    double K_21 = c[21];
    double K_29 = c[29];
    double K_28 = c[28];
    double K_27 = c[27];
    double K_35 = c[35];
    double K_34 = c[34];
    double K_33 = c[33];
    double K_5 = c[5];
    double K_4 = c[4];
    double K_3 = c[3];
    double K_11 = c[11];
    double K_10 = c[10];
    double K_9 = c[9];
    double K_17 = c[17];
    double K_16 = c[16];
    double K_15 = c[15];
    double by1_1 = R_zy - R_yz;
    double by1_2 = Math.sqrt(1.0 + R_xx + R_yy + R_zz);
    double by1_3 = 0.5 * by1_2;
    double by1_4 = 0.25 / by1_3;
    double by1_5 = by1_1 * by1_4;
    double by1_6 = R_xz - R_zx;
    double by1_7 = by1_6 * by1_4;
    double by1_8 = R_yx - R_xy;
    double by1_9 = by1_8 * by1_4;
    double by1_10 = by1_5 * by1_5 + by1_7 * by1_7 + by1_9 * by1_9;
    double by1_11 = Math.sqrt(Piecewise.choose(by1_10, 0.0, 1.0, by1_10));
    double by1_12 = 2.0 * StrictMath.atan2(by1_11, by1_3) / by1_11;
    double by1_13 = Piecewise.choose(by1_10, 0.0, 2.0, by1_12);
    double by1_14 = 0.5 * by1_1 / by1_2 * 0.5;
    double by1_15 = by1_4 * by1_14 / by1_3;
    double by1_16 = by1_8 * by1_15 - R_zx * by1_4;
    double by1_17 = by1_9 * by1_16;
    double by1_18 = by1_6 * by1_15 - R_yx * by1_4;
    double by1_19 = by1_7 * by1_18;
    double by1_20 = by1_4 * (R_yy + R_zz) + by1_1 * by1_15;
    double by1_21 = by1_5 * by1_20;
    double by1_22 = 0.5 * Piecewise.choose(by1_10, 0.0, 0.0, by1_17 + by1_17 + (by1_19 + by1_19
        + (by1_21 + by1_21))) / by1_11;
    double by1_23 = by1_11 * by1_11 + by1_3 * by1_3;
    double by1_24 = Piecewise.choose(by1_23, 0.0, 1.0, by1_23);
    double by1_25 = by1_3 / by1_24;
    double by1_26 = by1_11 / by1_24;
    double by1_27 = Piecewise.choose(by1_10, 0.0, 0.0, (2.0 * (by1_22 * by1_25 + by1_14 * by1_26)
        - by1_12 * by1_22) / by1_11);
    double by1_28 = by1_13 * by1_16 + by1_9 * by1_27;
    double by1_29 = by1_13 * by1_18 + by1_7 * by1_27;
    double by1_30 = by1_13 * by1_20 + by1_5 * by1_27;
    out[0] = -(K_22 * by1_29 + K_21 * by1_30 + K_23 * by1_28);
    out[6] = -(K_28 * by1_29 + K_27 * by1_30 + K_29 * by1_28);
    out[12] = -(K_34 * by1_29 + K_33 * by1_30 + K_35 * by1_28);
    out[18] = -(K_4 * by1_29 + K_3 * by1_30 + K_5 * by1_28);
    out[24] = -(K_10 * by1_29 + K_9 * by1_30 + K_11 * by1_28);
    out[30] = -(K_16 * by1_29 + K_15 * by1_30 + K_17 * by1_28);

    // Derivatives by motion 2.
    double by2_1 = 0.5 * by1_6 / by1_2 * 0.5;
    double by2_2 = by1_4 * by2_1 / by1_3;
    double by2_3 = by1_8 * by2_2 - R_zy * by1_4;
    double by2_4 = by1_9 * by2_3;
    double by2_5 = by1_4 * (R_xx + R_zz) + by1_6 * by2_2;
    double by2_6 = by1_7 * by2_5;
    double by2_7 = by1_1 * by2_2 - R_xy * by1_4;
    double by2_8 = by1_5 * by2_7;
    double by2_9 = 0.5 * Piecewise.choose(by1_10, 0.0, 0.0, by2_4 + by2_4 + (by2_6 + by2_6 + (by2_8
        + by2_8))) / by1_11;
    double by2_10 = Piecewise.choose(by1_10, 0.0, 0.0, (2.0 * (by1_25 * by2_9 + by1_26 * by2_1)
        - by1_12 * by2_9) / by1_11);
    double by2_11 = by1_13 * by2_3 + by1_9 * by2_10;
    double by2_12 = by1_13 * by2_5 + by1_7 * by2_10;
    double by2_13 = by1_13 * by2_7 + by1_5 * by2_10;
    out[1] = -(K_22 * by2_12 + K_21 * by2_13 + K_23 * by2_11);
    out[7] = -(K_28 * by2_12 + K_27 * by2_13 + K_29 * by2_11);
    out[13] = -(K_34 * by2_12 + K_33 * by2_13 + K_35 * by2_11);
    out[19] = -(K_4 * by2_12 + K_3 * by2_13 + K_5 * by2_11);
    out[25] = -(K_10 * by2_12 + K_9 * by2_13 + K_11 * by2_11);
    out[31] = -(K_16 * by2_12 + K_15 * by2_13 + K_17 * by2_11);

    // Derivatives by motion 3.
    double by3_1 = 0.5 * by1_8 / by1_2 * 0.5;
    double by3_2 = by1_4 * by3_1 / by1_3;
    double by3_3 = by1_4 * (R_xx + R_yy) + by1_8 * by3_2;
    double by3_4 = by1_9 * by3_3;
    double by3_5 = by1_6 * by3_2 - R_yz * by1_4;
    double by3_6 = by1_7 * by3_5;
    double by3_7 = by1_1 * by3_2 - R_xz * by1_4;
    double by3_8 = by1_5 * by3_7;
    double by3_9 = 0.5 * Piecewise.choose(by1_10, 0.0, 0.0, by3_4 + by3_4 + (by3_6 + by3_6 + (by3_8
        + by3_8))) / by1_11;
    double by3_10 = Piecewise.choose(by1_10, 0.0, 0.0, (2.0 * (by1_25 * by3_9 + by1_26 * by3_1)
        - by1_12 * by3_9) / by1_11);
    double by3_11 = by1_13 * by3_3 + by1_9 * by3_10;
    double by3_12 = by1_13 * by3_5 + by1_7 * by3_10;
    double by3_13 = by1_13 * by3_7 + by1_5 * by3_10;
    out[2] = -(K_22 * by3_12 + K_21 * by3_13 + K_23 * by3_11);
    out[8] = -(K_28 * by3_12 + K_27 * by3_13 + K_29 * by3_11);
    out[14] = -(K_34 * by3_12 + K_33 * by3_13 + K_35 * by3_11);
    out[20] = -(K_4 * by3_12 + K_3 * by3_13 + K_5 * by3_11);
    out[26] = -(K_10 * by3_12 + K_9 * by3_13 + K_11 * by3_11);
    out[32] = -(K_16 * by3_12 + K_15 * by3_13 + K_17 * by3_11);

    // Derivatives by motion 4.
    out[3] = -c[18];
    out[9] = -c[24];
    out[15] = -c[30];
    out[21] = -c[0];
    out[27] = -c[6];
    out[33] = -c[12];

    // Derivatives by motion 5.
    out[4] = -c[19];
    out[10] = -c[25];
    out[16] = -c[31];
    out[22] = -c[1];
    out[28] = -c[7];
    out[34] = -c[13];

    // Derivatives by motion 6.
    out[5] = -c[20];
    out[11] = -c[26];
    out[17] = -c[32];
    out[23] = -c[2];
    out[29] = -c[8];
    out[35] = -c[14];

    // Derivatives by motion 7.
    out[36] = -c[57];
    out[42] = -c[63];
    out[48] = -c[69];
    out[54] = -c[39];
    out[60] = -c[45];
    out[66] = -c[51];

    // Derivatives by motion 8.
    out[37] = -c[58];
    out[43] = -c[64];
    out[49] = -c[70];
    out[55] = -c[40];
    out[61] = -c[46];
    out[67] = -c[52];

    // Derivatives by motion 9.
    out[38] = -c[59];
    out[44] = -c[65];
    out[50] = -c[71];
    out[56] = -c[41];
    out[62] = -c[47];
    out[68] = -c[53];

    // Derivatives by motion 10.
    out[39] = -c[54];
    out[45] = -c[60];
    out[51] = -c[66];
    out[57] = -c[36];
    out[63] = -c[42];
    out[69] = -c[48];

    // Derivatives by motion 11.
    out[40] = -c[55];
    out[46] = -c[61];
    out[52] = -c[67];
    out[58] = -c[37];
    out[64] = -c[43];
    out[70] = -c[49];

    // Derivatives by motion 12.
    out[41] = -c[56];
    out[47] = -c[62];
    out[53] = -c[68];
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
    double omega_y = x[13];
    double omega_z = x[14];
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
    double law_35 = law_34 - omega_x * c[39] - c[4] * law_14 - omega_y * c[40] - c[5] * law_16
        - omega_z * c[41];
    double law_36 = preload_1 - r_x * c[6] - u_x * c[42] - r_y * c[7] - u_y * c[43] - r_z * c[8]
        - u_z * c[44] - c[9] * law_12;
    double law_37 = law_36 - omega_x * c[45] - c[10] * law_14 - omega_y * c[46] - c[11] * law_16
        - omega_z * c[47];
    double law_38 = preload_2 - r_x * c[12] - u_x * c[48] - r_y * c[13] - u_y * c[49] - r_z * c[14]
        - u_z * c[50] - c[15] * law_12;
    double law_39 = law_38 - omega_x * c[51] - c[16] * law_14 - omega_y * c[52] - c[17] * law_16
        - omega_z * c[53];
    double law_40 = preload_3 - r_x * c[18] - u_x * c[54] - r_y * c[19] - u_y * c[55] - r_z * c[20]
        - u_z * c[56] - c[21] * law_12;
    double law_41 = law_40 - omega_x * c[57] - c[22] * law_14 - omega_y * c[58] - c[23] * law_16
        - omega_z * c[59];
    double law_42 = preload_4 - r_x * c[24] - u_x * c[60] - r_y * c[25] - u_y * c[61] - r_z * c[26]
        - u_z * c[62] - c[27] * law_12;
    double law_43 = law_42 - omega_x * c[63] - c[28] * law_14 - omega_y * c[64] - c[29] * law_16
        - omega_z * c[65];
    double law_44 = preload_5 - r_x * c[30] - u_x * c[66] - r_y * c[31] - u_y * c[67] - r_z * c[32]
        - u_z * c[68] - c[33] * law_12;
    double law_45 = law_44 - omega_x * c[69] - c[34] * law_14 - omega_y * c[70] - c[35] * law_16
        - omega_z * c[71];
    double law_46 = u_x * law_35 + u_y * law_37 + u_z * law_39 + (omega_x * law_41
        + omega_y * law_43 + omega_z * law_45) + u_x * (r_x * c[114] - preload_0 + r_y * settled_38
        + r_z * settled_39 + law_12 * settled_40 + law_14 * settled_41 + law_16 * settled_42);
    double law_47 = law_46 + u_y * (r_x * settled_38 - preload_1 + r_y * c[120] + r_z * settled_44
        + law_12 * settled_45 + law_14 * settled_46 + law_16 * settled_47);
    double law_48 = law_47 + u_z * (r_x * settled_39 - preload_2 + r_y * settled_44 + r_z * c[125]
        + law_12 * settled_49 + law_14 * settled_50 + law_16 * settled_51);
    double law_49 = omega_z * law_14 - omega_y * law_16;
    double law_50 = Piecewise.choose(law_8, 0.0, 0.0, law_10);
    double law_51 = law_50 * law_50;
    double law_52 = Piecewise.choose(law_50, 0.05, 0.08333333333333333
        + law_51 * (0.001388888888888889 + law_51 * (3.306878306878307e-5
        + 8.267195767195768e-7 * law_51)), (1.0 - law_3 / law_9 * (0.5 * law_10)) / (law_10
        * law_10));
    double law_53 = omega_y * law_12 - omega_x * law_14;
    double law_54 = omega_x * law_16 - omega_z * law_12;
    double law_55 = (omega_x - 0.5 * law_49 + law_52 * (law_14 * law_53
        - law_16 * law_54)) * (r_x * settled_40 - preload_3 + r_y * settled_45 + r_z * settled_49
        + law_12 * c[129] + law_14 * settled_53 + law_16 * settled_54);
    double law_56 = (omega_y - 0.5 * law_54 + law_52 * (law_16 * law_49
        - law_12 * law_53)) * (r_x * settled_41 - preload_4 + r_y * settled_46 + r_z * settled_50
        + law_12 * settled_53 + law_14 * c[132] + law_16 * settled_56);
    double law_57 = (omega_z - 0.5 * law_53 + law_52 * (law_12 * law_54
        - law_14 * law_49)) * (r_x * settled_42 - preload_5 + r_y * settled_47 + r_z * settled_51
        + law_12 * settled_54 + law_14 * settled_56 + law_16 * c[134]);
    out[0] = law_33;
    out[1] = law_48 + law_55 + law_56 + law_57;
    System.arraycopy(x, 0, out, 2, 3);
    out[5] = law_12;
    out[6] = law_14;
    out[7] = law_16;
    out[8] = law_35;
    out[9] = law_37;
    out[10] = law_39;
    out[11] = law_41;
    out[12] = law_43;
    out[13] = law_45;
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
