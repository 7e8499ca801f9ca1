package org.mechservice.solver.step.printed;

import org.mechservice.solver.step.StepKernel;

/**
 * Printed from its equations; do not edit. PrintedStepsTest compares it with them and
 * prints it anew with -Dgolden.write=true.
 */
final class PrintedSlide implements StepKernel {

  @Override
  public void motion(double[] w, int i, int p) {
    // Motion: omega, alpha and a of the computing frame; the wrench that it takes.
    double E_xx = w[i + 0];
    double E_xy = w[i + 1];
    double E_xz = w[i + 2];
    double E_yx = w[i + 3];
    double E_yy = w[i + 4];
    double E_yz = w[i + 5];
    double E_zx = w[i + 6];
    double E_zy = w[i + 7];
    double E_zz = w[i + 8];
    double r_x = w[i + 9];
    double r_y = w[i + 10];
    double r_z = w[i + 11];
    double m = w[i + 13];
    double c_x = w[i + 14];
    double c_y = w[i + 15];
    double c_z = w[i + 16];
    double I_xx = w[i + 17];
    double I_xy = w[i + 20];
    double I_xz = w[i + 21];
    double I_yy = w[i + 18];
    double I_yz = w[i + 22];
    double I_zz = w[i + 19];
    double omega_p_x = w[p + 38];
    double omega_p_y = w[p + 39];
    double omega_p_z = w[p + 40];
    double alpha_p_x = w[p + 41];
    double alpha_p_y = w[p + 42];
    double alpha_p_z = w[p + 43];
    double q = w[i + 32];
    double motion_1 = omega_p_x * omega_p_x;
    double motion_2 = omega_p_y * omega_p_y;
    double motion_3 = omega_p_z * omega_p_z;
    double motion_4 = omega_p_x * omega_p_y;
    double motion_5 = omega_p_x * omega_p_z;
    double motion_6 = omega_p_y * omega_p_z;
    double motion_7 = r_y * (motion_4 - alpha_p_z) - r_x * (motion_2 + motion_3) + r_z * (alpha_p_y
        + motion_5) + w[p + 44];
    double motion_8 = r_x * (alpha_p_z + motion_4) - r_y * (motion_1 + motion_3) + r_z * (motion_6
        - alpha_p_x) + w[p + 45];
    double motion_9 = r_x * (motion_5 - alpha_p_y) + r_y * (alpha_p_x + motion_6) - r_z * (motion_1
        + motion_2) + w[p + 46];
    double omega_x = E_xx * omega_p_x + E_yx * omega_p_y + E_zx * omega_p_z;
    double omega_y = E_xy * omega_p_x + E_yy * omega_p_y + E_zy * omega_p_z;
    double omega_z = E_xz * omega_p_x + E_yz * omega_p_y + E_zz * omega_p_z;
    double alpha_x = E_xx * alpha_p_x + E_yx * alpha_p_y + E_zx * alpha_p_z;
    double alpha_y = E_xy * alpha_p_x + E_yy * alpha_p_y + E_zy * alpha_p_z;
    double alpha_z = E_xz * alpha_p_x + E_yz * alpha_p_y + E_zz * alpha_p_z;
    double motion_10 = 2.0 * w[i + 35];
    double motion_11 = omega_x * omega_x;
    double motion_12 = omega_y * omega_y;
    double motion_13 = omega_z * omega_z;
    double motion_14 = omega_x * omega_y;
    double motion_15 = omega_x * omega_z;
    double motion_16 = omega_y * omega_z;
    double W_xy = motion_14 - alpha_z;
    double W_xz = alpha_y + motion_15;
    double W_yx = alpha_z + motion_14;
    double W_yz = motion_16 - alpha_x;
    double W_zx = motion_15 - alpha_y;
    double W_zy = alpha_x + motion_16;
    double minus_W_zz = motion_11 + motion_12;
    double a_x = E_xx * motion_7 + E_yx * motion_8 + E_zx * motion_9 + W_xz * q
        + omega_y * motion_10;
    double a_y = E_xy * motion_7 + E_yy * motion_8 + E_zy * motion_9 + W_yz * q
        - omega_x * motion_10;
    double a_z = E_xz * motion_7 + E_yz * motion_8 + E_zz * motion_9 - minus_W_zz * q + w[i + 36];
    double motion_17 = m * (c_y * W_xy - c_x * (motion_12 + motion_13) + c_z * W_xz + a_x);
    double motion_18 = m * (c_x * W_yx - c_y * (motion_11 + motion_13) + c_z * W_yz + a_y);
    double motion_19 = m * (c_x * W_zx + c_y * W_zy - c_z * minus_W_zz + a_z);
    double motion_20 = I_xx * alpha_x + motion_16 * (I_zz - I_yy) + I_xz * W_yx - I_xy * W_zx
        + I_yz * (motion_12 - motion_13) + (c_y * motion_19 - c_z * motion_18);
    double motion_21 = I_yy * alpha_y + motion_15 * (I_xx - I_zz) + I_xy * W_zy - I_yz * W_xy
        + I_xz * (motion_13 - motion_11) + (c_z * motion_17 - c_x * motion_19);
    double motion_22 = I_zz * alpha_z + motion_14 * (I_yy - I_xx) + I_yz * W_xz - I_xz * W_yz
        + I_xy * (motion_11 - motion_12) + (c_x * motion_18 - c_y * motion_17);
    w[i + 38] = omega_x;
    w[i + 39] = omega_y;
    w[i + 40] = omega_z;
    w[i + 41] = alpha_x;
    w[i + 42] = alpha_y;
    w[i + 43] = alpha_z;
    w[i + 44] = a_x;
    w[i + 45] = a_y;
    w[i + 46] = a_z;
    w[i + 47] = motion_20 - w[i + 53];
    w[i + 48] = motion_21 - w[i + 54];
    w[i + 49] = motion_22 - w[i + 55];
    w[i + 50] = motion_17 - w[i + 56];
    w[i + 51] = motion_18 - w[i + 57];
    w[i + 52] = motion_19 - w[i + 58];
  }

  @Override
  public void inertia(double[] w, int i, int p) {
    // I - U U' / D and p + U u / D for each degree of freedom, added to the parent.
    double E_xx = w[i + 0];
    double E_xy = w[i + 1];
    double E_xz = w[i + 2];
    double E_yx = w[i + 3];
    double E_yy = w[i + 4];
    double E_yz = w[i + 5];
    double E_zx = w[i + 6];
    double E_zy = w[i + 7];
    double E_zz = w[i + 8];
    double r_x = w[i + 9];
    double r_y = w[i + 10];
    double r_z = w[i + 11];
    double m = w[i + 13];
    double link__23 = w[i + 23];
    double link__24 = w[i + 24];
    double link__25 = w[i + 25];
    double H_zz = w[i + 73];
    double M_xz = w[i + 78];
    double M_yz = w[i + 79];
    double tau = w[i + 37];
    double q = w[i + 32];
    double H_xz = link__24 + w[i + 67];
    double H_yz = w[i + 70] - link__23;
    double M_zz = m + w[i + 76];
    double one_over_D = 1.0 / M_zz;
    double kn_x = H_xz * one_over_D;
    double kn_y = H_yz * one_over_D;
    double kn_z = H_zz * one_over_D;
    double kf_x = M_xz * one_over_D;
    double kf_y = M_yz * one_over_D;
    double u_over_D = one_over_D * (tau - w[i + 52]);
    double inertia_1 = w[i + 49] + H_zz * u_over_D;
    double inertia_2 = w[i + 50] + M_xz * u_over_D;
    double inertia_3 = w[i + 51] + M_yz * u_over_D;
    double inertia_4 = w[i + 28] + w[i + 61] - H_zz * kn_z;
    double inertia_5 = w[i + 65] - M_xz * kn_x;
    double inertia_6 = w[i + 66] - link__25 - M_yz * kn_x;
    double inertia_7 = link__25 + w[i + 68] - M_xz * kn_y;
    double inertia_8 = w[i + 71] - link__24 - M_xz * kn_z;
    double inertia_9 = link__23 + w[i + 72] - M_yz * kn_z;
    double inertia_10 = m + w[i + 74] - M_xz * kf_x;
    double inertia_11 = w[i + 77] - M_yz * kf_x;
    double inertia_12 = m + w[i + 75] - M_yz * kf_y;
    double inertia_13 = inertia_11 * q;
    double inertia_14 = inertia_5 - inertia_13;
    double inertia_15 = inertia_6 - inertia_12 * q;
    double inertia_16 = inertia_7 + inertia_10 * q;
    double inertia_17 = w[i + 69] - M_yz * kn_y + inertia_13;
    double inertia_18 = w[i + 26] + w[i + 59] - H_xz * kn_x - q * (inertia_6 + inertia_15);
    double inertia_19 = w[i + 29] + w[i + 62] - H_yz * kn_x + q * (inertia_5 - inertia_17);
    double inertia_20 = w[i + 30] + w[i + 63] - H_zz * kn_x - inertia_9 * q;
    double inertia_21 = w[i + 27] + w[i + 60] - H_yz * kn_y + q * (inertia_7 + inertia_16);
    double inertia_22 = w[i + 31] + w[i + 64] - H_zz * kn_y + inertia_8 * q;
    double inertia_23 = E_xx * inertia_18 + E_xy * inertia_19 + E_xz * inertia_20;
    double inertia_24 = E_xx * inertia_19 + E_xy * inertia_21 + E_xz * inertia_22;
    double inertia_25 = E_xx * inertia_20 + E_xy * inertia_22 + E_xz * inertia_4;
    double inertia_26 = E_yx * inertia_18 + E_yy * inertia_19 + E_yz * inertia_20;
    double inertia_27 = E_yx * inertia_19 + E_yy * inertia_21 + E_yz * inertia_22;
    double inertia_28 = E_yx * inertia_20 + E_yy * inertia_22 + E_yz * inertia_4;
    double inertia_29 = E_zx * (E_zx * inertia_18 + E_zy * inertia_19 + E_zz * inertia_20)
        + E_zy * (E_zx * inertia_19 + E_zy * inertia_21 + E_zz * inertia_22)
        + E_zz * (E_zx * inertia_20 + E_zy * inertia_22 + E_zz * inertia_4);
    double inertia_30 = E_xx * inertia_14 + E_xy * inertia_16 + E_xz * inertia_8;
    double inertia_31 = E_xx * inertia_15 + E_xy * inertia_17 + E_xz * inertia_9;
    double inertia_32 = E_yx * inertia_14 + E_yy * inertia_16 + E_yz * inertia_8;
    double inertia_33 = E_yx * inertia_15 + E_yy * inertia_17 + E_yz * inertia_9;
    double inertia_34 = E_zx * inertia_14 + E_zy * inertia_16 + E_zz * inertia_8;
    double inertia_35 = E_zx * inertia_15 + E_zy * inertia_17 + E_zz * inertia_9;
    double inertia_36 = E_xx * inertia_30 + E_xy * inertia_31;
    double inertia_37 = E_yx * inertia_30 + E_yy * inertia_31;
    double inertia_38 = E_zx * inertia_30 + E_zy * inertia_31;
    double inertia_39 = E_xx * inertia_32 + E_xy * inertia_33;
    double inertia_40 = E_yx * inertia_32 + E_yy * inertia_33;
    double inertia_41 = E_zx * inertia_32 + E_zy * inertia_33;
    double inertia_42 = E_xx * inertia_34 + E_xy * inertia_35;
    double inertia_43 = E_yx * inertia_34 + E_yy * inertia_35;
    double inertia_44 = E_zx * inertia_34 + E_zy * inertia_35;
    double inertia_45 = E_xx * inertia_10 + E_xy * inertia_11;
    double inertia_46 = E_xx * inertia_11 + E_xy * inertia_12;
    double inertia_47 = E_yx * inertia_10 + E_yy * inertia_11;
    double inertia_48 = E_yx * inertia_11 + E_yy * inertia_12;
    double inertia_49 = E_xx * inertia_45 + E_xy * inertia_46;
    double inertia_50 = E_yx * inertia_45 + E_yy * inertia_46;
    double inertia_51 = E_zx * inertia_45 + E_zy * inertia_46;
    double inertia_52 = E_yx * inertia_47 + E_yy * inertia_48;
    double inertia_53 = E_zx * inertia_47 + E_zy * inertia_48;
    double inertia_54 = E_zx * (E_zx * inertia_10 + E_zy * inertia_11) + E_zy * (E_zx * inertia_11
        + E_zy * inertia_12);
    double inertia_55 = r_z * inertia_50;
    double inertia_56 = r_y * inertia_51;
    double inertia_57 = r_x * inertia_53;
    double inertia_58 = inertia_56 - inertia_55 + inertia_36;
    double inertia_59 = r_y * inertia_53 - r_z * inertia_52 + inertia_37;
    double inertia_60 = r_y * inertia_54 - r_z * inertia_53 + inertia_38;
    double inertia_61 = r_z * inertia_49 - r_x * inertia_51 + inertia_39;
    double inertia_62 = inertia_55 - inertia_57 + inertia_40;
    double inertia_63 = r_z * inertia_51 - r_x * inertia_54 + inertia_41;
    double inertia_64 = r_x * inertia_50 - r_y * inertia_49 + inertia_42;
    double inertia_65 = r_x * inertia_52 - r_y * inertia_50 + inertia_43;
    double inertia_66 = inertia_57 - inertia_56 + inertia_44;
    double inertia_67 = w[i + 47] + H_xz * u_over_D - inertia_3 * q;
    double inertia_68 = w[i + 48] + H_yz * u_over_D + inertia_2 * q;
    double inertia_69 = E_xx * inertia_2 + E_xy * inertia_3 + E_xz * tau;
    double inertia_70 = E_yx * inertia_2 + E_yy * inertia_3 + E_yz * tau;
    double inertia_71 = E_zx * inertia_2 + E_zy * inertia_3 + E_zz * tau;
    w[i + 80] = M_zz;
    w[i + 81] = u_over_D;
    w[i + 82] = kn_x;
    w[i + 83] = kn_y;
    w[i + 84] = kn_z;
    w[i + 85] = kf_x;
    w[i + 86] = kf_y;
    w[p + 59] = E_xx * inertia_23 + E_xy * inertia_24 + E_xz * inertia_25 + (r_y * (inertia_38
        + inertia_60) - r_z * (inertia_37 + inertia_59)) + w[p + 59];
    w[p + 60] = E_yx * inertia_26 + E_yy * inertia_27 + E_yz * inertia_28 + (r_z * (inertia_39
        + inertia_61) - r_x * (inertia_41 + inertia_63)) + w[p + 60];
    w[p + 61] = r_x * (inertia_43 + inertia_65) - r_y * (inertia_42 + inertia_64) + inertia_29
        + w[p + 61];
    w[p + 62] = E_yx * inertia_23 + E_yy * inertia_24 + E_yz * inertia_25 + (r_y * inertia_63
        - r_x * inertia_38 + r_z * (inertia_36 - inertia_62)) + w[p + 62];
    w[p + 63] = E_zx * inertia_23 + E_zy * inertia_24 + E_zz * inertia_25 + (r_x * inertia_59
        - r_z * inertia_43 + r_y * (inertia_44 - inertia_58)) + w[p + 63];
    w[p + 64] = E_zx * inertia_26 + E_zy * inertia_27 + E_zz * inertia_28 + (r_z * inertia_64
        - r_y * inertia_39 + r_x * (inertia_40 - inertia_66)) + w[p + 64];
    w[p + 65] = inertia_58 + w[p + 65];
    w[p + 66] = inertia_59 + w[p + 66];
    w[p + 67] = inertia_60 + w[p + 67];
    w[p + 68] = inertia_61 + w[p + 68];
    w[p + 69] = inertia_62 + w[p + 69];
    w[p + 70] = inertia_63 + w[p + 70];
    w[p + 71] = inertia_64 + w[p + 71];
    w[p + 72] = inertia_65 + w[p + 72];
    w[p + 73] = inertia_66 + w[p + 73];
    w[p + 74] = inertia_49 + w[p + 74];
    w[p + 75] = inertia_52 + w[p + 75];
    w[p + 76] = inertia_54 + w[p + 76];
    w[p + 77] = inertia_50 + w[p + 77];
    w[p + 78] = inertia_51 + w[p + 78];
    w[p + 79] = inertia_53 + w[p + 79];
    w[p + 47] = E_xx * inertia_67 + E_xy * inertia_68 + E_xz * inertia_1 + (r_y * inertia_71
        - r_z * inertia_70) + w[p + 47];
    w[p + 50] = inertia_69 + w[p + 50];
    w[p + 48] = E_yx * inertia_67 + E_yy * inertia_68 + E_yz * inertia_1 + (r_z * inertia_69
        - r_x * inertia_71) + w[p + 48];
    w[p + 51] = inertia_70 + w[p + 51];
    w[p + 49] = E_zx * inertia_67 + E_zy * inertia_68 + E_zz * inertia_1 + (r_x * inertia_70
        - r_y * inertia_69) + w[p + 49];
    w[p + 52] = inertia_71 + w[p + 52];
    w[i + 59] = 0.0;
    w[i + 60] = 0.0;
    w[i + 61] = 0.0;
    w[i + 62] = 0.0;
    w[i + 63] = 0.0;
    w[i + 64] = 0.0;
    w[i + 65] = 0.0;
    w[i + 66] = 0.0;
    w[i + 67] = 0.0;
    w[i + 68] = 0.0;
    w[i + 69] = 0.0;
    w[i + 70] = 0.0;
    w[i + 71] = 0.0;
    w[i + 72] = 0.0;
    w[i + 73] = 0.0;
    w[i + 74] = 0.0;
    w[i + 75] = 0.0;
    w[i + 76] = 0.0;
    w[i + 77] = 0.0;
    w[i + 78] = 0.0;
    w[i + 79] = 0.0;
  }

  @Override
  public void inertiaOnRoot(double[] w, int i, int p) {
    // u / D of each degree of freedom.
    double M_zz = w[i + 13] + w[i + 76];
    double one_over_D = 1.0 / M_zz;
    w[i + 80] = M_zz;
    w[i + 81] = (w[i + 37] - w[i + 52]) / M_zz;
    w[i + 82] = (w[i + 24] + w[i + 67]) * one_over_D;
    w[i + 83] = (w[i + 70] - w[i + 23]) * one_over_D;
    w[i + 84] = w[i + 73] * one_over_D;
    w[i + 85] = w[i + 78] * one_over_D;
    w[i + 86] = w[i + 79] * one_over_D;
    w[i + 59] = 0.0;
    w[i + 60] = 0.0;
    w[i + 61] = 0.0;
    w[i + 62] = 0.0;
    w[i + 63] = 0.0;
    w[i + 64] = 0.0;
    w[i + 65] = 0.0;
    w[i + 66] = 0.0;
    w[i + 67] = 0.0;
    w[i + 68] = 0.0;
    w[i + 69] = 0.0;
    w[i + 70] = 0.0;
    w[i + 71] = 0.0;
    w[i + 72] = 0.0;
    w[i + 73] = 0.0;
    w[i + 74] = 0.0;
    w[i + 75] = 0.0;
    w[i + 76] = 0.0;
    w[i + 77] = 0.0;
    w[i + 78] = 0.0;
    w[i + 79] = 0.0;
  }

  @Override
  public void pass(double[] w, int i, int p) {
    // I and p, added to the parent.
    double E_xx = w[i + 0];
    double E_xy = w[i + 1];
    double E_xz = w[i + 2];
    double E_yx = w[i + 3];
    double E_yy = w[i + 4];
    double E_yz = w[i + 5];
    double E_zx = w[i + 6];
    double E_zy = w[i + 7];
    double E_zz = w[i + 8];
    double r_x = w[i + 9];
    double r_y = w[i + 10];
    double r_z = w[i + 11];
    double m = w[i + 13];
    double link__23 = w[i + 23];
    double link__24 = w[i + 24];
    double link__25 = w[i + 25];
    double H_xx = w[i + 65];
    double H_zz = w[i + 73];
    double M_xy = w[i + 77];
    double M_xz = w[i + 78];
    double M_yz = w[i + 79];
    double n_z = w[i + 49];
    double f_x = w[i + 50];
    double f_y = w[i + 51];
    double f_z = w[i + 52];
    double q = w[i + 32];
    double J_zz = w[i + 28] + w[i + 61];
    double H_xy = w[i + 66] - link__25;
    double H_yx = link__25 + w[i + 68];
    double H_zx = w[i + 71] - link__24;
    double H_zy = link__23 + w[i + 72];
    double M_xx = m + w[i + 74];
    double M_yy = m + w[i + 75];
    double M_zz = m + w[i + 76];
    double pass_1 = M_xy * q;
    double pass_2 = H_xx - pass_1;
    double pass_3 = H_xy - M_yy * q;
    double pass_4 = link__24 + w[i + 67] - M_yz * q;
    double pass_5 = H_yx + M_xx * q;
    double pass_6 = w[i + 69] + pass_1;
    double pass_7 = w[i + 70] - link__23 + M_xz * q;
    double pass_8 = w[i + 26] + w[i + 59] - q * (H_xy + pass_3);
    double pass_9 = w[i + 29] + w[i + 62] + q * (H_xx - pass_6);
    double pass_10 = w[i + 30] + w[i + 63] - H_zy * q;
    double pass_11 = w[i + 27] + w[i + 60] + q * (H_yx + pass_5);
    double pass_12 = w[i + 31] + w[i + 64] + H_zx * q;
    double pass_13 = E_xx * pass_8 + E_xy * pass_9 + E_xz * pass_10;
    double pass_14 = E_xx * pass_9 + E_xy * pass_11 + E_xz * pass_12;
    double pass_15 = E_xx * pass_10 + E_xy * pass_12 + E_xz * J_zz;
    double pass_16 = E_yx * pass_8 + E_yy * pass_9 + E_yz * pass_10;
    double pass_17 = E_yx * pass_9 + E_yy * pass_11 + E_yz * pass_12;
    double pass_18 = E_yx * pass_10 + E_yy * pass_12 + E_yz * J_zz;
    double pass_19 = E_zx * (E_zx * pass_8 + E_zy * pass_9 + E_zz * pass_10) + E_zy * (E_zx * pass_9
        + E_zy * pass_11 + E_zz * pass_12) + E_zz * (E_zx * pass_10 + E_zy * pass_12 + E_zz * J_zz);
    double pass_20 = E_xx * pass_2 + E_xy * pass_5 + E_xz * H_zx;
    double pass_21 = E_xx * pass_3 + E_xy * pass_6 + E_xz * H_zy;
    double pass_22 = E_xx * pass_4 + E_xy * pass_7 + E_xz * H_zz;
    double pass_23 = E_yx * pass_2 + E_yy * pass_5 + E_yz * H_zx;
    double pass_24 = E_yx * pass_3 + E_yy * pass_6 + E_yz * H_zy;
    double pass_25 = E_yx * pass_4 + E_yy * pass_7 + E_yz * H_zz;
    double pass_26 = E_zx * pass_2 + E_zy * pass_5 + E_zz * H_zx;
    double pass_27 = E_zx * pass_3 + E_zy * pass_6 + E_zz * H_zy;
    double pass_28 = E_zx * pass_4 + E_zy * pass_7 + E_zz * H_zz;
    double pass_29 = E_xx * pass_20 + E_xy * pass_21 + E_xz * pass_22;
    double pass_30 = E_yx * pass_20 + E_yy * pass_21 + E_yz * pass_22;
    double pass_31 = E_zx * pass_20 + E_zy * pass_21 + E_zz * pass_22;
    double pass_32 = E_xx * pass_23 + E_xy * pass_24 + E_xz * pass_25;
    double pass_33 = E_yx * pass_23 + E_yy * pass_24 + E_yz * pass_25;
    double pass_34 = E_zx * pass_23 + E_zy * pass_24 + E_zz * pass_25;
    double pass_35 = E_xx * pass_26 + E_xy * pass_27 + E_xz * pass_28;
    double pass_36 = E_yx * pass_26 + E_yy * pass_27 + E_yz * pass_28;
    double pass_37 = E_zx * pass_26 + E_zy * pass_27 + E_zz * pass_28;
    double pass_38 = E_xx * M_xx + E_xy * M_xy + E_xz * M_xz;
    double pass_39 = E_xx * M_xy + E_xy * M_yy + E_xz * M_yz;
    double pass_40 = E_xx * M_xz + E_xy * M_yz + E_xz * M_zz;
    double pass_41 = E_yx * M_xx + E_yy * M_xy + E_yz * M_xz;
    double pass_42 = E_yx * M_xy + E_yy * M_yy + E_yz * M_yz;
    double pass_43 = E_yx * M_xz + E_yy * M_yz + E_yz * M_zz;
    double pass_44 = E_xx * pass_38 + E_xy * pass_39 + E_xz * pass_40;
    double pass_45 = E_yx * pass_38 + E_yy * pass_39 + E_yz * pass_40;
    double pass_46 = E_zx * pass_38 + E_zy * pass_39 + E_zz * pass_40;
    double pass_47 = E_yx * pass_41 + E_yy * pass_42 + E_yz * pass_43;
    double pass_48 = E_zx * pass_41 + E_zy * pass_42 + E_zz * pass_43;
    double pass_49 = E_zx * (E_zx * M_xx + E_zy * M_xy + E_zz * M_xz) + E_zy * (E_zx * M_xy
        + E_zy * M_yy + E_zz * M_yz) + E_zz * (E_zx * M_xz + E_zy * M_yz + E_zz * M_zz);
    double pass_50 = r_z * pass_45;
    double pass_51 = r_y * pass_46;
    double pass_52 = r_x * pass_48;
    double pass_53 = pass_51 - pass_50 + pass_29;
    double pass_54 = r_y * pass_48 - r_z * pass_47 + pass_30;
    double pass_55 = r_y * pass_49 - r_z * pass_48 + pass_31;
    double pass_56 = r_z * pass_44 - r_x * pass_46 + pass_32;
    double pass_57 = pass_50 - pass_52 + pass_33;
    double pass_58 = r_z * pass_46 - r_x * pass_49 + pass_34;
    double pass_59 = r_x * pass_45 - r_y * pass_44 + pass_35;
    double pass_60 = r_x * pass_47 - r_y * pass_45 + pass_36;
    double pass_61 = pass_52 - pass_51 + pass_37;
    double pass_62 = w[i + 47] - f_y * q;
    double pass_63 = w[i + 48] + f_x * q;
    double pass_64 = E_xx * f_x + E_xy * f_y + E_xz * f_z;
    double pass_65 = E_yx * f_x + E_yy * f_y + E_yz * f_z;
    double pass_66 = E_zx * f_x + E_zy * f_y + E_zz * f_z;
    w[p + 59] = E_xx * pass_13 + E_xy * pass_14 + E_xz * pass_15 + (r_y * (pass_31 + pass_55)
        - r_z * (pass_30 + pass_54)) + w[p + 59];
    w[p + 60] = E_yx * pass_16 + E_yy * pass_17 + E_yz * pass_18 + (r_z * (pass_32 + pass_56)
        - r_x * (pass_34 + pass_58)) + w[p + 60];
    w[p + 61] = r_x * (pass_36 + pass_60) - r_y * (pass_35 + pass_59) + pass_19 + w[p + 61];
    w[p + 62] = E_yx * pass_13 + E_yy * pass_14 + E_yz * pass_15 + (r_y * pass_58 - r_x * pass_31
        + r_z * (pass_29 - pass_57)) + w[p + 62];
    w[p + 63] = E_zx * pass_13 + E_zy * pass_14 + E_zz * pass_15 + (r_x * pass_54 - r_z * pass_36
        + r_y * (pass_37 - pass_53)) + w[p + 63];
    w[p + 64] = E_zx * pass_16 + E_zy * pass_17 + E_zz * pass_18 + (r_z * pass_59 - r_y * pass_32
        + r_x * (pass_33 - pass_61)) + w[p + 64];
    w[p + 65] = pass_53 + w[p + 65];
    w[p + 66] = pass_54 + w[p + 66];
    w[p + 67] = pass_55 + w[p + 67];
    w[p + 68] = pass_56 + w[p + 68];
    w[p + 69] = pass_57 + w[p + 69];
    w[p + 70] = pass_58 + w[p + 70];
    w[p + 71] = pass_59 + w[p + 71];
    w[p + 72] = pass_60 + w[p + 72];
    w[p + 73] = pass_61 + w[p + 73];
    w[p + 74] = pass_44 + w[p + 74];
    w[p + 75] = pass_47 + w[p + 75];
    w[p + 76] = pass_49 + w[p + 76];
    w[p + 77] = pass_45 + w[p + 77];
    w[p + 78] = pass_46 + w[p + 78];
    w[p + 79] = pass_48 + w[p + 79];
    w[p + 47] = E_xx * pass_62 + E_xy * pass_63 + E_xz * n_z + (r_y * pass_66 - r_z * pass_65)
        + w[p + 47];
    w[p + 50] = pass_64 + w[p + 50];
    w[p + 48] = E_yx * pass_62 + E_yy * pass_63 + E_yz * n_z + (r_z * pass_64 - r_x * pass_66)
        + w[p + 48];
    w[p + 51] = pass_65 + w[p + 51];
    w[p + 49] = E_zx * pass_62 + E_zy * pass_63 + E_zz * n_z + (r_x * pass_65 - r_y * pass_64)
        + w[p + 49];
    w[p + 52] = pass_66 + w[p + 52];
  }

  @Override
  public void acceleration(double[] w, int i, int p) {
    // q'' = u / D - k.A of each degree of freedom, A = X' A_p + q'' z.
    double E_xx = w[i + 0];
    double E_xy = w[i + 1];
    double E_xz = w[i + 2];
    double E_yx = w[i + 3];
    double E_yy = w[i + 4];
    double E_yz = w[i + 5];
    double E_zx = w[i + 6];
    double E_zy = w[i + 7];
    double E_zz = w[i + 8];
    double r_x = w[i + 9];
    double r_y = w[i + 10];
    double r_z = w[i + 11];
    double above_88 = w[p + 88];
    double above_89 = w[p + 89];
    double above_90 = w[p + 90];
    double q = w[i + 32];
    double acceleration_1 = r_z * above_89 - r_y * above_90 + w[p + 91];
    double acceleration_2 = r_x * above_90 - r_z * above_88 + w[p + 92];
    double acceleration_3 = r_y * above_88 - r_x * above_89 + w[p + 93];
    double dalpha_x = E_xx * above_88 + E_yx * above_89 + E_zx * above_90;
    double dalpha_y = E_xy * above_88 + E_yy * above_89 + E_zy * above_90;
    double dalpha_z = E_xz * above_88 + E_yz * above_89 + E_zz * above_90;
    double acceleration_4 = E_xz * acceleration_1 + E_yz * acceleration_2 + E_zz * acceleration_3;
    double da_x = E_xx * acceleration_1 + E_yx * acceleration_2 + E_zx * acceleration_3
        + dalpha_y * q;
    double da_y = E_xy * acceleration_1 + E_yy * acceleration_2 + E_zy * acceleration_3
        - dalpha_x * q;
    double acceleration_5 = w[i + 81] - (dalpha_x * w[i + 82] + dalpha_y * w[i + 83]
        + dalpha_z * w[i + 84] + (da_x * w[i + 85] + da_y * w[i + 86] + acceleration_4));
    w[i + 88] = dalpha_x;
    w[i + 89] = dalpha_y;
    w[i + 90] = dalpha_z;
    w[i + 91] = da_x;
    w[i + 92] = da_y;
    w[i + 93] = acceleration_4 + acceleration_5;
    w[i + 94] = acceleration_5;
  }

  @Override
  public void carry(double[] w, int i, int p) {
    // A = X' A_p.
    double E_xx = w[i + 0];
    double E_xy = w[i + 1];
    double E_xz = w[i + 2];
    double E_yx = w[i + 3];
    double E_yy = w[i + 4];
    double E_yz = w[i + 5];
    double E_zx = w[i + 6];
    double E_zy = w[i + 7];
    double E_zz = w[i + 8];
    double r_x = w[i + 9];
    double r_y = w[i + 10];
    double r_z = w[i + 11];
    double above_88 = w[p + 88];
    double above_89 = w[p + 89];
    double above_90 = w[p + 90];
    double q = w[i + 32];
    double carry_1 = r_z * above_89 - r_y * above_90 + w[p + 91];
    double carry_2 = r_x * above_90 - r_z * above_88 + w[p + 92];
    double carry_3 = r_y * above_88 - r_x * above_89 + w[p + 93];
    double dalpha_x = E_xx * above_88 + E_yx * above_89 + E_zx * above_90;
    double dalpha_y = E_xy * above_88 + E_yy * above_89 + E_zy * above_90;
    w[i + 88] = dalpha_x;
    w[i + 89] = dalpha_y;
    w[i + 90] = E_xz * above_88 + E_yz * above_89 + E_zz * above_90;
    w[i + 91] = E_xx * carry_1 + E_yx * carry_2 + E_zx * carry_3 + dalpha_y * q;
    w[i + 92] = E_xy * carry_1 + E_yy * carry_2 + E_zy * carry_3 - dalpha_x * q;
    w[i + 93] = E_xz * carry_1 + E_yz * carry_2 + E_zz * carry_3;
  }

  @Override
  public void driving(double[] w, int i, int p) {
    // U.A + p.z - tau of each degree of freedom.
    double driving_1 = (w[i + 24] + w[i + 67]) * w[i + 88] + (w[i + 70] - w[i + 23]) * w[i + 89]
        + w[i + 73] * w[i + 90] + (w[i + 78] * w[i + 91] + w[i + 79] * w[i + 92] + (w[i + 13]
        + w[i + 76]) * w[i + 93]);
    w[i + 94] = w[i + 52] + driving_1 - w[i + 37];
    w[i + 59] = 0.0;
    w[i + 60] = 0.0;
    w[i + 61] = 0.0;
    w[i + 62] = 0.0;
    w[i + 63] = 0.0;
    w[i + 64] = 0.0;
    w[i + 65] = 0.0;
    w[i + 66] = 0.0;
    w[i + 67] = 0.0;
    w[i + 68] = 0.0;
    w[i + 69] = 0.0;
    w[i + 70] = 0.0;
    w[i + 71] = 0.0;
    w[i + 72] = 0.0;
    w[i + 73] = 0.0;
    w[i + 74] = 0.0;
    w[i + 75] = 0.0;
    w[i + 76] = 0.0;
    w[i + 77] = 0.0;
    w[i + 78] = 0.0;
    w[i + 79] = 0.0;
  }

  @Override
  public void force(double[] w, int i, int p) {
    // p.z - tau of each degree of freedom; p added to the parent.
    double E_xx = w[i + 0];
    double E_xy = w[i + 1];
    double E_xz = w[i + 2];
    double E_yx = w[i + 3];
    double E_yy = w[i + 4];
    double E_yz = w[i + 5];
    double E_zx = w[i + 6];
    double E_zy = w[i + 7];
    double E_zz = w[i + 8];
    double r_x = w[i + 9];
    double r_y = w[i + 10];
    double r_z = w[i + 11];
    double n_z = w[i + 49];
    double f_x = w[i + 50];
    double f_y = w[i + 51];
    double f_z = w[i + 52];
    double q = w[i + 32];
    double force_1 = w[i + 47] - f_y * q;
    double force_2 = w[i + 48] + f_x * q;
    double force_3 = E_xx * f_x + E_xy * f_y + E_xz * f_z;
    double force_4 = E_yx * f_x + E_yy * f_y + E_yz * f_z;
    double force_5 = E_zx * f_x + E_zy * f_y + E_zz * f_z;
    w[i + 94] = f_z - w[i + 37];
    w[p + 47] = E_xx * force_1 + E_xy * force_2 + E_xz * n_z + (r_y * force_5 - r_z * force_4)
        + w[p + 47];
    w[p + 50] = force_3 + w[p + 50];
    w[p + 48] = E_yx * force_1 + E_yy * force_2 + E_yz * n_z + (r_z * force_3 - r_x * force_5)
        + w[p + 48];
    w[p + 51] = force_4 + w[p + 51];
    w[p + 49] = E_zx * force_1 + E_zy * force_2 + E_zz * n_z + (r_x * force_4 - r_y * force_3)
        + w[p + 49];
    w[p + 52] = force_5 + w[p + 52];
  }

  @Override
  public void forceOnRoot(double[] w, int i, int p) {
    // p.z - tau of each degree of freedom.
    w[i + 94] = w[i + 52] - w[i + 37];
  }

  @Override
  public void push(double[] w, int i, int p) {
    // u / D of each degree of freedom, with its D and U / D; p added to the parent.
    double E_xx = w[i + 0];
    double E_xy = w[i + 1];
    double E_xz = w[i + 2];
    double E_yx = w[i + 3];
    double E_yy = w[i + 4];
    double E_yz = w[i + 5];
    double E_zx = w[i + 6];
    double E_zy = w[i + 7];
    double E_zz = w[i + 8];
    double r_x = w[i + 9];
    double r_y = w[i + 10];
    double r_z = w[i + 11];
    double tau = w[i + 37];
    double q = w[i + 32];
    double push_1 = tau - w[i + 52];
    double push_2 = w[i + 49] + w[i + 84] * push_1;
    double push_3 = w[i + 50] + w[i + 85] * push_1;
    double push_4 = w[i + 51] + w[i + 86] * push_1;
    double push_5 = w[i + 47] + w[i + 82] * push_1 - push_4 * q;
    double push_6 = w[i + 48] + w[i + 83] * push_1 + push_3 * q;
    double push_7 = E_xx * push_3 + E_xy * push_4 + E_xz * tau;
    double push_8 = E_yx * push_3 + E_yy * push_4 + E_yz * tau;
    double push_9 = E_zx * push_3 + E_zy * push_4 + E_zz * tau;
    w[i + 81] = push_1 / w[i + 80];
    w[p + 47] = E_xx * push_5 + E_xy * push_6 + E_xz * push_2 + (r_y * push_9 - r_z * push_8)
        + w[p + 47];
    w[p + 50] = push_7 + w[p + 50];
    w[p + 48] = E_yx * push_5 + E_yy * push_6 + E_yz * push_2 + (r_z * push_7 - r_x * push_9)
        + w[p + 48];
    w[p + 51] = push_8 + w[p + 51];
    w[p + 49] = E_zx * push_5 + E_zy * push_6 + E_zz * push_2 + (r_x * push_8 - r_y * push_7)
        + w[p + 49];
    w[p + 52] = push_9 + w[p + 52];
  }

  @Override
  public void pushOnRoot(double[] w, int i, int p) {
    // u / D of each degree of freedom, with its D and U / D.
    w[i + 81] = (w[i + 37] - w[i + 52]) / w[i + 80];
  }

  @Override
  public void couple(double[] w, int i, int p) {
    // kappa + K.z of each degree of freedom; K - (U / D) kappa as the parent feels it.
    double E_xx = w[i + 0];
    double E_xy = w[i + 1];
    double E_xz = w[i + 2];
    double E_yx = w[i + 3];
    double E_yy = w[i + 4];
    double E_yz = w[i + 5];
    double E_zx = w[i + 6];
    double E_zy = w[i + 7];
    double E_zz = w[i + 8];
    double r_x = w[i + 9];
    double r_y = w[i + 10];
    double r_z = w[i + 11];
    double above_6 = w[p + 6];
    double q = w[i + 32];
    double couple_1 = w[p + 5] + above_6;
    double couple_2 = w[p + 2] - w[i + 84] * couple_1;
    double couple_3 = w[p + 3] - w[i + 85] * couple_1;
    double couple_4 = w[p + 4] - w[i + 86] * couple_1;
    double couple_5 = w[p + 0] - w[i + 82] * couple_1 - couple_4 * q;
    double couple_6 = w[p + 1] - w[i + 83] * couple_1 + couple_3 * q;
    double couple_7 = E_xx * couple_3 + E_xy * couple_4 - E_xz * above_6;
    double couple_8 = E_yx * couple_3 + E_yy * couple_4 - E_yz * above_6;
    double couple_9 = E_zx * couple_3 + E_zy * couple_4 - E_zz * above_6;
    w[p + 6] = couple_1;
    w[p + 9] = E_xx * couple_5 + E_xy * couple_6 + E_xz * couple_2 + (r_y * couple_9
        - r_z * couple_8);
    w[p + 10] = E_yx * couple_5 + E_yy * couple_6 + E_yz * couple_2 + (r_z * couple_7
        - r_x * couple_9);
    w[p + 11] = E_zx * couple_5 + E_zy * couple_6 + E_zz * couple_2 + (r_x * couple_8
        - r_y * couple_7);
    w[p + 12] = couple_7;
    w[p + 13] = couple_8;
    w[p + 14] = couple_9;
  }

  @Override
  public void coupleOnRoot(double[] w, int i, int p) {
    // kappa + K.z of each degree of freedom.
    w[p + 6] = w[p + 5] + w[p + 6];
  }

  @Override
  public void transfer(double[] w, int i, int p) {
    // K as the parent feels it.
    double E_xx = w[i + 0];
    double E_xy = w[i + 1];
    double E_xz = w[i + 2];
    double E_yx = w[i + 3];
    double E_yy = w[i + 4];
    double E_yz = w[i + 5];
    double E_zx = w[i + 6];
    double E_zy = w[i + 7];
    double E_zz = w[i + 8];
    double r_x = w[i + 9];
    double r_y = w[i + 10];
    double r_z = w[i + 11];
    double Kn_z = w[p + 2];
    double Kf_x = w[p + 3];
    double Kf_y = w[p + 4];
    double Kf_z = w[p + 5];
    double q = w[i + 32];
    double transfer_1 = w[p + 0] - Kf_y * q;
    double transfer_2 = w[p + 1] + Kf_x * q;
    double transfer_3 = E_xx * Kf_x + E_xy * Kf_y + E_xz * Kf_z;
    double transfer_4 = E_yx * Kf_x + E_yy * Kf_y + E_yz * Kf_z;
    double transfer_5 = E_zx * Kf_x + E_zy * Kf_y + E_zz * Kf_z;
    w[p + 9] = E_xx * transfer_1 + E_xy * transfer_2 + E_xz * Kn_z + (r_y * transfer_5
        - r_z * transfer_4);
    w[p + 10] = E_yx * transfer_1 + E_yy * transfer_2 + E_yz * Kn_z + (r_z * transfer_3
        - r_x * transfer_5);
    w[p + 11] = E_zx * transfer_1 + E_zy * transfer_2 + E_zz * Kn_z + (r_x * transfer_4
        - r_y * transfer_3);
    w[p + 12] = transfer_3;
    w[p + 13] = transfer_4;
    w[p + 14] = transfer_5;
  }
}
