package org.mechservice.solver.step.printed;

import org.mechservice.solver.step.StepKernel;

/**
 * Printed from its equations; do not edit. PrintedStepsTest compares it with them and
 * prints it anew with -Dgolden.write=true.
 */
final class PrintedBallBack implements StepKernel {

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
    double R_xx = w[i + 105];
    double R_xy = w[i + 106];
    double R_xz = w[i + 107];
    double R_yx = w[i + 108];
    double R_yy = w[i + 109];
    double R_yz = w[i + 110];
    double R_zx = w[i + 111];
    double R_zy = w[i + 112];
    double R_zz = w[i + 113];
    double v_x = w[i + 96];
    double v_y = w[i + 97];
    double v_z = w[i + 98];
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
    double motion_10 = E_xx * omega_p_x + E_yx * omega_p_y + E_zx * omega_p_z;
    double motion_11 = E_xy * omega_p_x + E_yy * omega_p_y + E_zy * omega_p_z;
    double motion_12 = E_xz * omega_p_x + E_yz * omega_p_y + E_zz * omega_p_z;
    double motion_13 = E_xx * alpha_p_x + E_yx * alpha_p_y + E_zx * alpha_p_z;
    double motion_14 = E_xy * alpha_p_x + E_yy * alpha_p_y + E_zy * alpha_p_z;
    double motion_15 = E_xz * alpha_p_x + E_yz * alpha_p_y + E_zz * alpha_p_z;
    double motion_16 = E_xx * motion_7 + E_yx * motion_8 + E_zx * motion_9;
    double motion_17 = E_xy * motion_7 + E_yy * motion_8 + E_zy * motion_9;
    double motion_18 = E_xz * motion_7 + E_yz * motion_8 + E_zz * motion_9;
    double motion_19 = motion_10 * R_xx + motion_11 * R_yx + motion_12 * R_zx;
    double motion_20 = motion_10 * R_xy + motion_11 * R_yy + motion_12 * R_zy;
    double motion_21 = motion_10 * R_xz + motion_11 * R_yz + motion_12 * R_zz;
    double omega_x = motion_19 - v_x;
    double omega_y = motion_20 - v_y;
    double omega_z = motion_21 - v_z;
    double alpha_x = motion_13 * R_xx + motion_14 * R_yx + motion_15 * R_zx + (v_y * motion_21
        - v_z * motion_20) - w[i + 99];
    double alpha_y = motion_13 * R_xy + motion_14 * R_yy + motion_15 * R_zy + (v_z * motion_19
        - v_x * motion_21) - w[i + 100];
    double alpha_z = motion_13 * R_xz + motion_14 * R_yz + motion_15 * R_zz + (v_x * motion_20
        - v_y * motion_19) - w[i + 101];
    double a_x = motion_16 * R_xx + motion_17 * R_yx + motion_18 * R_zx;
    double a_y = motion_16 * R_xy + motion_17 * R_yy + motion_18 * R_zy;
    double a_z = motion_16 * R_xz + motion_17 * R_yz + motion_18 * R_zz;
    double motion_22 = omega_x * omega_x;
    double motion_23 = omega_y * omega_y;
    double motion_24 = omega_z * omega_z;
    double motion_25 = omega_x * omega_y;
    double motion_26 = omega_x * omega_z;
    double motion_27 = omega_y * omega_z;
    double W_xy = motion_25 - alpha_z;
    double W_xz = alpha_y + motion_26;
    double W_yx = alpha_z + motion_25;
    double W_yz = motion_27 - alpha_x;
    double W_zx = motion_26 - alpha_y;
    double W_zy = alpha_x + motion_27;
    double motion_28 = m * (c_y * W_xy - c_x * (motion_23 + motion_24) + c_z * W_xz + a_x);
    double motion_29 = m * (c_x * W_yx - c_y * (motion_22 + motion_24) + c_z * W_yz + a_y);
    double motion_30 = m * (c_x * W_zx + c_y * W_zy - c_z * (motion_22 + motion_23) + a_z);
    double motion_31 = I_xx * alpha_x + motion_27 * (I_zz - I_yy) + I_xz * W_yx - I_xy * W_zx
        + I_yz * (motion_23 - motion_24) + (c_y * motion_30 - c_z * motion_29);
    double motion_32 = I_yy * alpha_y + motion_26 * (I_xx - I_zz) + I_xy * W_zy - I_yz * W_xy
        + I_xz * (motion_24 - motion_22) + (c_z * motion_28 - c_x * motion_30);
    double motion_33 = I_zz * alpha_z + motion_25 * (I_yy - I_xx) + I_yz * W_xz - I_xz * W_yz
        + I_xy * (motion_22 - motion_23) + (c_x * motion_29 - c_y * motion_28);
    w[i + 38] = omega_x;
    w[i + 39] = omega_y;
    w[i + 40] = omega_z;
    w[i + 41] = alpha_x;
    w[i + 42] = alpha_y;
    w[i + 43] = alpha_z;
    w[i + 44] = a_x;
    w[i + 45] = a_y;
    w[i + 46] = a_z;
    w[i + 47] = motion_31 - w[i + 53];
    w[i + 48] = motion_32 - w[i + 54];
    w[i + 49] = motion_33 - w[i + 55];
    w[i + 50] = motion_28 - w[i + 56];
    w[i + 51] = motion_29 - w[i + 57];
    w[i + 52] = motion_30 - w[i + 58];
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
    double H_xx = w[i + 65];
    double tau_x = w[i + 102];
    double tau_y = w[i + 103];
    double tau_z = w[i + 104];
    double R_xx = w[i + 105];
    double R_xy = w[i + 106];
    double R_xz = w[i + 107];
    double R_yx = w[i + 108];
    double R_yy = w[i + 109];
    double R_yz = w[i + 110];
    double R_zx = w[i + 111];
    double R_zy = w[i + 112];
    double R_zz = w[i + 113];
    double J_xx = w[i + 26] + w[i + 59];
    double J_xy = w[i + 29] + w[i + 62];
    double J_xz = w[i + 30] + w[i + 63];
    double H_xy = w[i + 66] - link__25;
    double H_xz = link__24 + w[i + 67];
    double one_over_D_x = 1.0 / J_xx;
    double kn_x_y = J_xy * one_over_D_x;
    double kn_x_z = J_xz * one_over_D_x;
    double kf_x_x = H_xx * one_over_D_x;
    double kf_x_y = H_xy * one_over_D_x;
    double kf_x_z = H_xz * one_over_D_x;
    double u_over_D_x = one_over_D_x * (tau_x - w[i + 47]);
    double D_y = w[i + 27] + w[i + 60] - J_xy * kn_x_y;
    double inertia_1 = w[i + 31] + w[i + 64] - J_xz * kn_x_y;
    double inertia_2 = link__25 + w[i + 68] - H_xx * kn_x_y;
    double inertia_3 = w[i + 69] - H_xy * kn_x_y;
    double inertia_4 = w[i + 70] - link__23 - H_xz * kn_x_y;
    double one_over_D_y = 1.0 / D_y;
    double kn_y_z = inertia_1 * one_over_D_y;
    double kf_y_x = inertia_2 * one_over_D_y;
    double kf_y_y = inertia_3 * one_over_D_y;
    double kf_y_z = inertia_4 * one_over_D_y;
    double u_over_D_y = one_over_D_y * (tau_y - (w[i + 48] + J_xy * u_over_D_x));
    double D_z = w[i + 28] + w[i + 61] - J_xz * kn_x_z - inertia_1 * kn_y_z;
    double inertia_5 = w[i + 71] - link__24 - H_xx * kn_x_z - inertia_2 * kn_y_z;
    double inertia_6 = link__23 + w[i + 72] - H_xy * kn_x_z - inertia_3 * kn_y_z;
    double inertia_7 = w[i + 73] - H_xz * kn_x_z - inertia_4 * kn_y_z;
    double one_over_D_z = 1.0 / D_z;
    double kf_z_x = inertia_5 * one_over_D_z;
    double kf_z_y = inertia_6 * one_over_D_z;
    double kf_z_z = inertia_7 * one_over_D_z;
    double u_over_D_z = one_over_D_z * (tau_z - (w[i + 49] + J_xz * u_over_D_x
        + inertia_1 * u_over_D_y));
    double inertia_8 = w[i + 50] + H_xx * u_over_D_x + inertia_2 * u_over_D_y
        + inertia_5 * u_over_D_z;
    double inertia_9 = w[i + 51] + H_xy * u_over_D_x + inertia_3 * u_over_D_y
        + inertia_6 * u_over_D_z;
    double inertia_10 = w[i + 52] + H_xz * u_over_D_x + inertia_4 * u_over_D_y
        + inertia_7 * u_over_D_z;
    double inertia_11 = m + w[i + 74] - H_xx * kf_x_x - inertia_2 * kf_y_x - inertia_5 * kf_z_x;
    double inertia_12 = w[i + 77] - H_xy * kf_x_x - inertia_3 * kf_y_x - inertia_6 * kf_z_x;
    double inertia_13 = w[i + 78] - H_xz * kf_x_x - inertia_4 * kf_y_x - inertia_7 * kf_z_x;
    double inertia_14 = m + w[i + 75] - H_xy * kf_x_y - inertia_3 * kf_y_y - inertia_6 * kf_z_y;
    double inertia_15 = w[i + 79] - H_xz * kf_x_y - inertia_4 * kf_y_y - inertia_7 * kf_z_y;
    double inertia_16 = m + w[i + 76] - H_xz * kf_x_z - inertia_4 * kf_y_z - inertia_7 * kf_z_z;
    double inertia_17 = inertia_11 * R_xx + inertia_12 * R_xy + inertia_13 * R_xz;
    double inertia_18 = inertia_12 * R_xx + inertia_14 * R_xy + inertia_15 * R_xz;
    double inertia_19 = inertia_13 * R_xx + inertia_15 * R_xy + inertia_16 * R_xz;
    double inertia_20 = inertia_11 * R_yx + inertia_12 * R_yy + inertia_13 * R_yz;
    double inertia_21 = inertia_12 * R_yx + inertia_14 * R_yy + inertia_15 * R_yz;
    double inertia_22 = inertia_13 * R_yx + inertia_15 * R_yy + inertia_16 * R_yz;
    double inertia_23 = R_xx * inertia_17 + R_xy * inertia_18 + R_xz * inertia_19;
    double inertia_24 = R_yx * inertia_17 + R_yy * inertia_18 + R_yz * inertia_19;
    double inertia_25 = R_zx * inertia_17 + R_zy * inertia_18 + R_zz * inertia_19;
    double inertia_26 = R_yx * inertia_20 + R_yy * inertia_21 + R_yz * inertia_22;
    double inertia_27 = R_zx * inertia_20 + R_zy * inertia_21 + R_zz * inertia_22;
    double inertia_28 = R_zx * (inertia_11 * R_zx + inertia_12 * R_zy + inertia_13 * R_zz)
        + R_zy * (inertia_12 * R_zx + inertia_14 * R_zy + inertia_15 * R_zz)
        + R_zz * (inertia_13 * R_zx + inertia_15 * R_zy + inertia_16 * R_zz);
    double inertia_29 = E_xx * inertia_23 + E_xy * inertia_24 + E_xz * inertia_25;
    double inertia_30 = E_xx * inertia_24 + E_xy * inertia_26 + E_xz * inertia_27;
    double inertia_31 = E_xx * inertia_25 + E_xy * inertia_27 + E_xz * inertia_28;
    double inertia_32 = E_yx * inertia_23 + E_yy * inertia_24 + E_yz * inertia_25;
    double inertia_33 = E_yx * inertia_24 + E_yy * inertia_26 + E_yz * inertia_27;
    double inertia_34 = E_yx * inertia_25 + E_yy * inertia_27 + E_yz * inertia_28;
    double inertia_35 = E_xx * inertia_29 + E_xy * inertia_30 + E_xz * inertia_31;
    double inertia_36 = E_yx * inertia_29 + E_yy * inertia_30 + E_yz * inertia_31;
    double inertia_37 = E_zx * inertia_29 + E_zy * inertia_30 + E_zz * inertia_31;
    double inertia_38 = E_yx * inertia_32 + E_yy * inertia_33 + E_yz * inertia_34;
    double inertia_39 = E_zx * inertia_32 + E_zy * inertia_33 + E_zz * inertia_34;
    double inertia_40 = E_zx * (E_zx * inertia_23 + E_zy * inertia_24 + E_zz * inertia_25)
        + E_zy * (E_zx * inertia_24 + E_zy * inertia_26 + E_zz * inertia_27)
        + E_zz * (E_zx * inertia_25 + E_zy * inertia_27 + E_zz * inertia_28);
    double inertia_41 = r_z * inertia_36;
    double inertia_42 = r_y * inertia_37;
    double inertia_43 = inertia_42 - inertia_41;
    double inertia_44 = r_y * inertia_39 - r_z * inertia_38;
    double inertia_45 = r_y * inertia_40 - r_z * inertia_39;
    double inertia_46 = r_z * inertia_35 - r_x * inertia_37;
    double inertia_47 = r_x * inertia_39;
    double inertia_48 = inertia_41 - inertia_47;
    double inertia_49 = r_z * inertia_37 - r_x * inertia_40;
    double inertia_50 = r_x * inertia_36 - r_y * inertia_35;
    double inertia_51 = r_x * inertia_38 - r_y * inertia_36;
    double inertia_52 = inertia_47 - inertia_42;
    double inertia_53 = tau_x * R_xx + tau_y * R_xy + tau_z * R_xz;
    double inertia_54 = tau_x * R_yx + tau_y * R_yy + tau_z * R_yz;
    double inertia_55 = tau_x * R_zx + tau_y * R_zy + tau_z * R_zz;
    double inertia_56 = inertia_8 * R_xx + inertia_9 * R_xy + inertia_10 * R_xz;
    double inertia_57 = inertia_8 * R_yx + inertia_9 * R_yy + inertia_10 * R_yz;
    double inertia_58 = inertia_8 * R_zx + inertia_9 * R_zy + inertia_10 * R_zz;
    double inertia_59 = E_xx * inertia_56 + E_xy * inertia_57 + E_xz * inertia_58;
    double inertia_60 = E_yx * inertia_56 + E_yy * inertia_57 + E_yz * inertia_58;
    double inertia_61 = E_zx * inertia_56 + E_zy * inertia_57 + E_zz * inertia_58;
    w[i + 80] = J_xx;
    w[i + 81] = u_over_D_x;
    w[i + 83] = kn_x_y;
    w[i + 84] = kn_x_z;
    w[i + 85] = kf_x_x;
    w[i + 86] = kf_x_y;
    w[i + 87] = kf_x_z;
    w[i + 114] = D_y;
    w[i + 115] = u_over_D_y;
    w[i + 118] = kn_y_z;
    w[i + 119] = kf_y_x;
    w[i + 120] = kf_y_y;
    w[i + 121] = kf_y_z;
    w[i + 122] = D_z;
    w[i + 123] = u_over_D_z;
    w[i + 127] = kf_z_x;
    w[i + 128] = kf_z_y;
    w[i + 129] = kf_z_z;
    w[p + 59] = r_y * inertia_45 - r_z * inertia_44 + w[p + 59];
    w[p + 60] = r_z * inertia_46 - r_x * inertia_49 + w[p + 60];
    w[p + 61] = r_x * inertia_51 - r_y * inertia_50 + w[p + 61];
    w[p + 62] = r_y * inertia_49 - r_z * inertia_48 + w[p + 62];
    w[p + 63] = r_x * inertia_44 - r_y * inertia_43 + w[p + 63];
    w[p + 64] = r_z * inertia_50 - r_x * inertia_52 + w[p + 64];
    w[p + 65] = inertia_43 + w[p + 65];
    w[p + 66] = inertia_44 + w[p + 66];
    w[p + 67] = inertia_45 + w[p + 67];
    w[p + 68] = inertia_46 + w[p + 68];
    w[p + 69] = inertia_48 + w[p + 69];
    w[p + 70] = inertia_49 + w[p + 70];
    w[p + 71] = inertia_50 + w[p + 71];
    w[p + 72] = inertia_51 + w[p + 72];
    w[p + 73] = inertia_52 + w[p + 73];
    w[p + 74] = inertia_35 + w[p + 74];
    w[p + 75] = inertia_38 + w[p + 75];
    w[p + 76] = inertia_40 + w[p + 76];
    w[p + 77] = inertia_36 + w[p + 77];
    w[p + 78] = inertia_37 + w[p + 78];
    w[p + 79] = inertia_39 + w[p + 79];
    w[p + 47] = E_xx * inertia_53 + E_xy * inertia_54 + E_xz * inertia_55 + (r_y * inertia_61
        - r_z * inertia_60) + w[p + 47];
    w[p + 50] = inertia_59 + w[p + 50];
    w[p + 48] = E_yx * inertia_53 + E_yy * inertia_54 + E_yz * inertia_55 + (r_z * inertia_59
        - r_x * inertia_61) + w[p + 48];
    w[p + 51] = inertia_60 + w[p + 51];
    w[p + 49] = E_zx * inertia_53 + E_zy * inertia_54 + E_zz * inertia_55 + (r_x * inertia_60
        - r_y * inertia_59) + w[p + 49];
    w[p + 52] = inertia_61 + w[p + 52];
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
    double link__23 = w[i + 23];
    double link__24 = w[i + 24];
    double link__25 = w[i + 25];
    double H_xx = w[i + 65];
    double J_xx = w[i + 26] + w[i + 59];
    double J_xy = w[i + 29] + w[i + 62];
    double J_xz = w[i + 30] + w[i + 63];
    double H_xy = w[i + 66] - link__25;
    double H_xz = link__24 + w[i + 67];
    double one_over_D_x = 1.0 / J_xx;
    double kn_x_y = J_xy * one_over_D_x;
    double kn_x_z = J_xz * one_over_D_x;
    double u_over_D_x = one_over_D_x * (w[i + 102] - w[i + 47]);
    double D_y = w[i + 27] + w[i + 60] - J_xy * kn_x_y;
    double inertiaOnRoot_1 = w[i + 31] + w[i + 64] - J_xz * kn_x_y;
    double inertiaOnRoot_2 = link__25 + w[i + 68] - H_xx * kn_x_y;
    double inertiaOnRoot_3 = w[i + 69] - H_xy * kn_x_y;
    double inertiaOnRoot_4 = w[i + 70] - link__23 - H_xz * kn_x_y;
    double one_over_D_y = 1.0 / D_y;
    double kn_y_z = inertiaOnRoot_1 * one_over_D_y;
    double u_over_D_y = one_over_D_y * (w[i + 103] - (w[i + 48] + J_xy * u_over_D_x));
    double D_z = w[i + 28] + w[i + 61] - J_xz * kn_x_z - inertiaOnRoot_1 * kn_y_z;
    double one_over_D_z = 1.0 / D_z;
    w[i + 80] = J_xx;
    w[i + 81] = u_over_D_x;
    w[i + 83] = kn_x_y;
    w[i + 84] = kn_x_z;
    w[i + 85] = H_xx * one_over_D_x;
    w[i + 86] = H_xy * one_over_D_x;
    w[i + 87] = H_xz * one_over_D_x;
    w[i + 114] = D_y;
    w[i + 115] = u_over_D_y;
    w[i + 118] = kn_y_z;
    w[i + 119] = inertiaOnRoot_2 * one_over_D_y;
    w[i + 120] = inertiaOnRoot_3 * one_over_D_y;
    w[i + 121] = inertiaOnRoot_4 * one_over_D_y;
    w[i + 122] = D_z;
    w[i + 123] = (w[i + 104] - (w[i + 49] + J_xz * u_over_D_x
        + inertiaOnRoot_1 * u_over_D_y)) / D_z;
    w[i + 127] = (w[i + 71] - link__24 - H_xx * kn_x_z - inertiaOnRoot_2 * kn_y_z) * one_over_D_z;
    w[i + 128] = (link__23 + w[i + 72] - H_xy * kn_x_z - inertiaOnRoot_3 * kn_y_z) * one_over_D_z;
    w[i + 129] = (w[i + 73] - H_xz * kn_x_z - inertiaOnRoot_4 * kn_y_z) * one_over_D_z;
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
    double H_yy = w[i + 69];
    double H_zz = w[i + 73];
    double M_xy = w[i + 77];
    double M_xz = w[i + 78];
    double M_yz = w[i + 79];
    double n_x = w[i + 47];
    double n_y = w[i + 48];
    double n_z = w[i + 49];
    double f_x = w[i + 50];
    double f_y = w[i + 51];
    double f_z = w[i + 52];
    double R_xx = w[i + 105];
    double R_xy = w[i + 106];
    double R_xz = w[i + 107];
    double R_yx = w[i + 108];
    double R_yy = w[i + 109];
    double R_yz = w[i + 110];
    double R_zx = w[i + 111];
    double R_zy = w[i + 112];
    double R_zz = w[i + 113];
    double J_xx = w[i + 26] + w[i + 59];
    double J_xy = w[i + 29] + w[i + 62];
    double J_xz = w[i + 30] + w[i + 63];
    double J_yy = w[i + 27] + w[i + 60];
    double J_yz = w[i + 31] + w[i + 64];
    double J_zz = w[i + 28] + w[i + 61];
    double H_xy = w[i + 66] - link__25;
    double H_xz = link__24 + w[i + 67];
    double H_yx = link__25 + w[i + 68];
    double H_yz = w[i + 70] - link__23;
    double H_zx = w[i + 71] - link__24;
    double H_zy = link__23 + w[i + 72];
    double M_xx = m + w[i + 74];
    double M_yy = m + w[i + 75];
    double M_zz = m + w[i + 76];
    double pass_1 = J_xx * R_xx + J_xy * R_xy + J_xz * R_xz;
    double pass_2 = J_xy * R_xx + J_yy * R_xy + J_yz * R_xz;
    double pass_3 = J_xz * R_xx + J_yz * R_xy + J_zz * R_xz;
    double pass_4 = J_xx * R_yx + J_xy * R_yy + J_xz * R_yz;
    double pass_5 = J_xy * R_yx + J_yy * R_yy + J_yz * R_yz;
    double pass_6 = J_xz * R_yx + J_yz * R_yy + J_zz * R_yz;
    double pass_7 = R_xx * pass_1 + R_xy * pass_2 + R_xz * pass_3;
    double pass_8 = R_yx * pass_1 + R_yy * pass_2 + R_yz * pass_3;
    double pass_9 = R_zx * pass_1 + R_zy * pass_2 + R_zz * pass_3;
    double pass_10 = R_yx * pass_4 + R_yy * pass_5 + R_yz * pass_6;
    double pass_11 = R_zx * pass_4 + R_zy * pass_5 + R_zz * pass_6;
    double pass_12 = R_zx * (J_xx * R_zx + J_xy * R_zy + J_xz * R_zz) + R_zy * (J_xy * R_zx
        + J_yy * R_zy + J_yz * R_zz) + R_zz * (J_xz * R_zx + J_yz * R_zy + J_zz * R_zz);
    double pass_13 = H_xx * R_xx + H_yx * R_xy + H_zx * R_xz;
    double pass_14 = H_xy * R_xx + H_yy * R_xy + H_zy * R_xz;
    double pass_15 = H_xz * R_xx + H_yz * R_xy + H_zz * R_xz;
    double pass_16 = H_xx * R_yx + H_yx * R_yy + H_zx * R_yz;
    double pass_17 = H_xy * R_yx + H_yy * R_yy + H_zy * R_yz;
    double pass_18 = H_xz * R_yx + H_yz * R_yy + H_zz * R_yz;
    double pass_19 = H_xx * R_zx + H_yx * R_zy + H_zx * R_zz;
    double pass_20 = H_xy * R_zx + H_yy * R_zy + H_zy * R_zz;
    double pass_21 = H_xz * R_zx + H_yz * R_zy + H_zz * R_zz;
    double pass_22 = R_xx * pass_13 + R_xy * pass_14 + R_xz * pass_15;
    double pass_23 = R_yx * pass_13 + R_yy * pass_14 + R_yz * pass_15;
    double pass_24 = R_zx * pass_13 + R_zy * pass_14 + R_zz * pass_15;
    double pass_25 = R_xx * pass_16 + R_xy * pass_17 + R_xz * pass_18;
    double pass_26 = R_yx * pass_16 + R_yy * pass_17 + R_yz * pass_18;
    double pass_27 = R_zx * pass_16 + R_zy * pass_17 + R_zz * pass_18;
    double pass_28 = R_xx * pass_19 + R_xy * pass_20 + R_xz * pass_21;
    double pass_29 = R_yx * pass_19 + R_yy * pass_20 + R_yz * pass_21;
    double pass_30 = R_zx * pass_19 + R_zy * pass_20 + R_zz * pass_21;
    double pass_31 = M_xx * R_xx + M_xy * R_xy + M_xz * R_xz;
    double pass_32 = M_xy * R_xx + M_yy * R_xy + M_yz * R_xz;
    double pass_33 = M_xz * R_xx + M_yz * R_xy + M_zz * R_xz;
    double pass_34 = M_xx * R_yx + M_xy * R_yy + M_xz * R_yz;
    double pass_35 = M_xy * R_yx + M_yy * R_yy + M_yz * R_yz;
    double pass_36 = M_xz * R_yx + M_yz * R_yy + M_zz * R_yz;
    double pass_37 = R_xx * pass_31 + R_xy * pass_32 + R_xz * pass_33;
    double pass_38 = R_yx * pass_31 + R_yy * pass_32 + R_yz * pass_33;
    double pass_39 = R_zx * pass_31 + R_zy * pass_32 + R_zz * pass_33;
    double pass_40 = R_yx * pass_34 + R_yy * pass_35 + R_yz * pass_36;
    double pass_41 = R_zx * pass_34 + R_zy * pass_35 + R_zz * pass_36;
    double pass_42 = R_zx * (M_xx * R_zx + M_xy * R_zy + M_xz * R_zz) + R_zy * (M_xy * R_zx
        + M_yy * R_zy + M_yz * R_zz) + R_zz * (M_xz * R_zx + M_yz * R_zy + M_zz * R_zz);
    double pass_43 = E_xx * pass_7 + E_xy * pass_8 + E_xz * pass_9;
    double pass_44 = E_xx * pass_8 + E_xy * pass_10 + E_xz * pass_11;
    double pass_45 = E_xx * pass_9 + E_xy * pass_11 + E_xz * pass_12;
    double pass_46 = E_yx * pass_7 + E_yy * pass_8 + E_yz * pass_9;
    double pass_47 = E_yx * pass_8 + E_yy * pass_10 + E_yz * pass_11;
    double pass_48 = E_yx * pass_9 + E_yy * pass_11 + E_yz * pass_12;
    double pass_49 = E_zx * (E_zx * pass_7 + E_zy * pass_8 + E_zz * pass_9) + E_zy * (E_zx * pass_8
        + E_zy * pass_10 + E_zz * pass_11) + E_zz * (E_zx * pass_9 + E_zy * pass_11
        + E_zz * pass_12);
    double pass_50 = E_xx * pass_22 + E_xy * pass_25 + E_xz * pass_28;
    double pass_51 = E_xx * pass_23 + E_xy * pass_26 + E_xz * pass_29;
    double pass_52 = E_xx * pass_24 + E_xy * pass_27 + E_xz * pass_30;
    double pass_53 = E_yx * pass_22 + E_yy * pass_25 + E_yz * pass_28;
    double pass_54 = E_yx * pass_23 + E_yy * pass_26 + E_yz * pass_29;
    double pass_55 = E_yx * pass_24 + E_yy * pass_27 + E_yz * pass_30;
    double pass_56 = E_zx * pass_22 + E_zy * pass_25 + E_zz * pass_28;
    double pass_57 = E_zx * pass_23 + E_zy * pass_26 + E_zz * pass_29;
    double pass_58 = E_zx * pass_24 + E_zy * pass_27 + E_zz * pass_30;
    double pass_59 = E_xx * pass_50 + E_xy * pass_51 + E_xz * pass_52;
    double pass_60 = E_yx * pass_50 + E_yy * pass_51 + E_yz * pass_52;
    double pass_61 = E_zx * pass_50 + E_zy * pass_51 + E_zz * pass_52;
    double pass_62 = E_xx * pass_53 + E_xy * pass_54 + E_xz * pass_55;
    double pass_63 = E_yx * pass_53 + E_yy * pass_54 + E_yz * pass_55;
    double pass_64 = E_zx * pass_53 + E_zy * pass_54 + E_zz * pass_55;
    double pass_65 = E_xx * pass_56 + E_xy * pass_57 + E_xz * pass_58;
    double pass_66 = E_yx * pass_56 + E_yy * pass_57 + E_yz * pass_58;
    double pass_67 = E_zx * pass_56 + E_zy * pass_57 + E_zz * pass_58;
    double pass_68 = E_xx * pass_37 + E_xy * pass_38 + E_xz * pass_39;
    double pass_69 = E_xx * pass_38 + E_xy * pass_40 + E_xz * pass_41;
    double pass_70 = E_xx * pass_39 + E_xy * pass_41 + E_xz * pass_42;
    double pass_71 = E_yx * pass_37 + E_yy * pass_38 + E_yz * pass_39;
    double pass_72 = E_yx * pass_38 + E_yy * pass_40 + E_yz * pass_41;
    double pass_73 = E_yx * pass_39 + E_yy * pass_41 + E_yz * pass_42;
    double pass_74 = E_xx * pass_68 + E_xy * pass_69 + E_xz * pass_70;
    double pass_75 = E_yx * pass_68 + E_yy * pass_69 + E_yz * pass_70;
    double pass_76 = E_zx * pass_68 + E_zy * pass_69 + E_zz * pass_70;
    double pass_77 = E_yx * pass_71 + E_yy * pass_72 + E_yz * pass_73;
    double pass_78 = E_zx * pass_71 + E_zy * pass_72 + E_zz * pass_73;
    double pass_79 = E_zx * (E_zx * pass_37 + E_zy * pass_38 + E_zz * pass_39)
        + E_zy * (E_zx * pass_38 + E_zy * pass_40 + E_zz * pass_41) + E_zz * (E_zx * pass_39
        + E_zy * pass_41 + E_zz * pass_42);
    double pass_80 = r_z * pass_75;
    double pass_81 = r_y * pass_76;
    double pass_82 = r_x * pass_78;
    double pass_83 = pass_81 - pass_80 + pass_59;
    double pass_84 = r_y * pass_78 - r_z * pass_77 + pass_60;
    double pass_85 = r_y * pass_79 - r_z * pass_78 + pass_61;
    double pass_86 = r_z * pass_74 - r_x * pass_76 + pass_62;
    double pass_87 = pass_80 - pass_82 + pass_63;
    double pass_88 = r_z * pass_76 - r_x * pass_79 + pass_64;
    double pass_89 = r_x * pass_75 - r_y * pass_74 + pass_65;
    double pass_90 = r_x * pass_77 - r_y * pass_75 + pass_66;
    double pass_91 = pass_82 - pass_81 + pass_67;
    double pass_92 = n_x * R_xx + n_y * R_xy + n_z * R_xz;
    double pass_93 = n_x * R_yx + n_y * R_yy + n_z * R_yz;
    double pass_94 = n_x * R_zx + n_y * R_zy + n_z * R_zz;
    double pass_95 = f_x * R_xx + f_y * R_xy + f_z * R_xz;
    double pass_96 = f_x * R_yx + f_y * R_yy + f_z * R_yz;
    double pass_97 = f_x * R_zx + f_y * R_zy + f_z * R_zz;
    double pass_98 = E_xx * pass_95 + E_xy * pass_96 + E_xz * pass_97;
    double pass_99 = E_yx * pass_95 + E_yy * pass_96 + E_yz * pass_97;
    double pass_100 = E_zx * pass_95 + E_zy * pass_96 + E_zz * pass_97;
    w[p + 59] = E_xx * pass_43 + E_xy * pass_44 + E_xz * pass_45 + (r_y * (pass_61 + pass_85)
        - r_z * (pass_60 + pass_84)) + w[p + 59];
    w[p + 60] = E_yx * pass_46 + E_yy * pass_47 + E_yz * pass_48 + (r_z * (pass_62 + pass_86)
        - r_x * (pass_64 + pass_88)) + w[p + 60];
    w[p + 61] = r_x * (pass_66 + pass_90) - r_y * (pass_65 + pass_89) + pass_49 + w[p + 61];
    w[p + 62] = E_yx * pass_43 + E_yy * pass_44 + E_yz * pass_45 + (r_y * pass_88 - r_x * pass_61
        + r_z * (pass_59 - pass_87)) + w[p + 62];
    w[p + 63] = E_zx * pass_43 + E_zy * pass_44 + E_zz * pass_45 + (r_x * pass_84 - r_z * pass_66
        + r_y * (pass_67 - pass_83)) + w[p + 63];
    w[p + 64] = E_zx * pass_46 + E_zy * pass_47 + E_zz * pass_48 + (r_z * pass_89 - r_y * pass_62
        + r_x * (pass_63 - pass_91)) + w[p + 64];
    w[p + 65] = pass_83 + w[p + 65];
    w[p + 66] = pass_84 + w[p + 66];
    w[p + 67] = pass_85 + w[p + 67];
    w[p + 68] = pass_86 + w[p + 68];
    w[p + 69] = pass_87 + w[p + 69];
    w[p + 70] = pass_88 + w[p + 70];
    w[p + 71] = pass_89 + w[p + 71];
    w[p + 72] = pass_90 + w[p + 72];
    w[p + 73] = pass_91 + w[p + 73];
    w[p + 74] = pass_74 + w[p + 74];
    w[p + 75] = pass_77 + w[p + 75];
    w[p + 76] = pass_79 + w[p + 76];
    w[p + 77] = pass_75 + w[p + 77];
    w[p + 78] = pass_76 + w[p + 78];
    w[p + 79] = pass_78 + w[p + 79];
    w[p + 47] = E_xx * pass_92 + E_xy * pass_93 + E_xz * pass_94 + (r_y * pass_100
        - r_z * pass_99) + w[p + 47];
    w[p + 50] = pass_98 + w[p + 50];
    w[p + 48] = E_yx * pass_92 + E_yy * pass_93 + E_yz * pass_94 + (r_z * pass_98
        - r_x * pass_100) + w[p + 48];
    w[p + 51] = pass_99 + w[p + 51];
    w[p + 49] = E_zx * pass_92 + E_zy * pass_93 + E_zz * pass_94 + (r_x * pass_99 - r_y * pass_98)
        + w[p + 49];
    w[p + 52] = pass_100 + w[p + 52];
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
    double R_xx = w[i + 105];
    double R_xy = w[i + 106];
    double R_xz = w[i + 107];
    double R_yx = w[i + 108];
    double R_yy = w[i + 109];
    double R_yz = w[i + 110];
    double R_zx = w[i + 111];
    double R_zy = w[i + 112];
    double R_zz = w[i + 113];
    double acceleration_1 = r_z * above_89 - r_y * above_90 + w[p + 91];
    double acceleration_2 = r_x * above_90 - r_z * above_88 + w[p + 92];
    double acceleration_3 = r_y * above_88 - r_x * above_89 + w[p + 93];
    double acceleration_4 = E_xx * above_88 + E_yx * above_89 + E_zx * above_90;
    double acceleration_5 = E_xy * above_88 + E_yy * above_89 + E_zy * above_90;
    double acceleration_6 = E_xz * above_88 + E_yz * above_89 + E_zz * above_90;
    double acceleration_7 = E_xx * acceleration_1 + E_yx * acceleration_2 + E_zx * acceleration_3;
    double acceleration_8 = E_xy * acceleration_1 + E_yy * acceleration_2 + E_zy * acceleration_3;
    double acceleration_9 = E_xz * acceleration_1 + E_yz * acceleration_2 + E_zz * acceleration_3;
    double acceleration_10 = acceleration_4 * R_xx + acceleration_5 * R_yx + acceleration_6 * R_zx;
    double acceleration_11 = acceleration_4 * R_xy + acceleration_5 * R_yy + acceleration_6 * R_zy;
    double acceleration_12 = acceleration_4 * R_xz + acceleration_5 * R_yz + acceleration_6 * R_zz;
    double da_x = acceleration_7 * R_xx + acceleration_8 * R_yx + acceleration_9 * R_zx;
    double da_y = acceleration_7 * R_xy + acceleration_8 * R_yy + acceleration_9 * R_zy;
    double da_z = acceleration_7 * R_xz + acceleration_8 * R_yz + acceleration_9 * R_zz;
    double acceleration_13 = w[i + 123] - (acceleration_10 * w[i + 124]
        + acceleration_11 * w[i + 125] + acceleration_12 + (da_x * w[i + 127] + da_y * w[i + 128]
        + da_z * w[i + 129]));
    double dalpha_z = acceleration_12 + acceleration_13;
    double acceleration_14 = w[i + 115] - (acceleration_11 + acceleration_10 * w[i + 116]
        + dalpha_z * w[i + 118] + (da_x * w[i + 119] + da_y * w[i + 120] + da_z * w[i + 121]));
    double dalpha_y = acceleration_11 + acceleration_14;
    double acceleration_15 = w[i + 81] - (acceleration_10 + dalpha_y * w[i + 83]
        + dalpha_z * w[i + 84] + (da_x * w[i + 85] + da_y * w[i + 86] + da_z * w[i + 87]));
    w[i + 88] = acceleration_10 + acceleration_15;
    w[i + 89] = dalpha_y;
    w[i + 90] = dalpha_z;
    w[i + 91] = da_x;
    w[i + 92] = da_y;
    w[i + 93] = da_z;
    w[i + 130] = -acceleration_15;
    w[i + 131] = -acceleration_14;
    w[i + 132] = -acceleration_13;
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
    double R_xx = w[i + 105];
    double R_xy = w[i + 106];
    double R_xz = w[i + 107];
    double R_yx = w[i + 108];
    double R_yy = w[i + 109];
    double R_yz = w[i + 110];
    double R_zx = w[i + 111];
    double R_zy = w[i + 112];
    double R_zz = w[i + 113];
    double carry_1 = r_z * above_89 - r_y * above_90 + w[p + 91];
    double carry_2 = r_x * above_90 - r_z * above_88 + w[p + 92];
    double carry_3 = r_y * above_88 - r_x * above_89 + w[p + 93];
    double carry_4 = E_xx * above_88 + E_yx * above_89 + E_zx * above_90;
    double carry_5 = E_xy * above_88 + E_yy * above_89 + E_zy * above_90;
    double carry_6 = E_xz * above_88 + E_yz * above_89 + E_zz * above_90;
    double carry_7 = E_xx * carry_1 + E_yx * carry_2 + E_zx * carry_3;
    double carry_8 = E_xy * carry_1 + E_yy * carry_2 + E_zy * carry_3;
    double carry_9 = E_xz * carry_1 + E_yz * carry_2 + E_zz * carry_3;
    w[i + 88] = carry_4 * R_xx + carry_5 * R_yx + carry_6 * R_zx;
    w[i + 89] = carry_4 * R_xy + carry_5 * R_yy + carry_6 * R_zy;
    w[i + 90] = carry_4 * R_xz + carry_5 * R_yz + carry_6 * R_zz;
    w[i + 91] = carry_7 * R_xx + carry_8 * R_yx + carry_9 * R_zx;
    w[i + 92] = carry_7 * R_xy + carry_8 * R_yy + carry_9 * R_zy;
    w[i + 93] = carry_7 * R_xz + carry_8 * R_yz + carry_9 * R_zz;
  }

  @Override
  public void driving(double[] w, int i, int p) {
    // U.A + p.z - tau of each degree of freedom.
    double link__23 = w[i + 23];
    double link__24 = w[i + 24];
    double link__25 = w[i + 25];
    double link__88 = w[i + 88];
    double link__89 = w[i + 89];
    double link__90 = w[i + 90];
    double link__91 = w[i + 91];
    double link__92 = w[i + 92];
    double link__93 = w[i + 93];
    double J_xy = w[i + 29] + w[i + 62];
    double J_xz = w[i + 30] + w[i + 63];
    double J_yz = w[i + 31] + w[i + 64];
    double driving_1 = (w[i + 26] + w[i + 59]) * link__88 + J_xy * link__89 + J_xz * link__90
        + (w[i + 65] * link__91 + (w[i + 66] - link__25) * link__92 + (link__24
        + w[i + 67]) * link__93);
    double driving_2 = J_xy * link__88 + (w[i + 27] + w[i + 60]) * link__89 + J_yz * link__90
        + ((link__25 + w[i + 68]) * link__91 + w[i + 69] * link__92 + (w[i + 70]
        - link__23) * link__93);
    double driving_3 = J_xz * link__88 + J_yz * link__89 + (w[i + 28] + w[i + 61]) * link__90
        + ((w[i + 71] - link__24) * link__91 + (link__23 + w[i + 72]) * link__92
        + w[i + 73] * link__93);
    w[i + 130] = w[i + 102] - (w[i + 47] + driving_1);
    w[i + 131] = w[i + 103] - (w[i + 48] + driving_2);
    w[i + 132] = w[i + 104] - (w[i + 49] + driving_3);
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
    double n_x = w[i + 47];
    double n_y = w[i + 48];
    double n_z = w[i + 49];
    double f_x = w[i + 50];
    double f_y = w[i + 51];
    double f_z = w[i + 52];
    double R_xx = w[i + 105];
    double R_xy = w[i + 106];
    double R_xz = w[i + 107];
    double R_yx = w[i + 108];
    double R_yy = w[i + 109];
    double R_yz = w[i + 110];
    double R_zx = w[i + 111];
    double R_zy = w[i + 112];
    double R_zz = w[i + 113];
    double force_1 = n_x * R_xx + n_y * R_xy + n_z * R_xz;
    double force_2 = n_x * R_yx + n_y * R_yy + n_z * R_yz;
    double force_3 = n_x * R_zx + n_y * R_zy + n_z * R_zz;
    double force_4 = f_x * R_xx + f_y * R_xy + f_z * R_xz;
    double force_5 = f_x * R_yx + f_y * R_yy + f_z * R_yz;
    double force_6 = f_x * R_zx + f_y * R_zy + f_z * R_zz;
    double force_7 = E_xx * force_4 + E_xy * force_5 + E_xz * force_6;
    double force_8 = E_yx * force_4 + E_yy * force_5 + E_yz * force_6;
    double force_9 = E_zx * force_4 + E_zy * force_5 + E_zz * force_6;
    w[i + 130] = w[i + 102] - n_x;
    w[i + 131] = w[i + 103] - n_y;
    w[i + 132] = w[i + 104] - n_z;
    w[p + 47] = E_xx * force_1 + E_xy * force_2 + E_xz * force_3 + (r_y * force_9 - r_z * force_8)
        + w[p + 47];
    w[p + 50] = force_7 + w[p + 50];
    w[p + 48] = E_yx * force_1 + E_yy * force_2 + E_yz * force_3 + (r_z * force_7 - r_x * force_9)
        + w[p + 48];
    w[p + 51] = force_8 + w[p + 51];
    w[p + 49] = E_zx * force_1 + E_zy * force_2 + E_zz * force_3 + (r_x * force_8 - r_y * force_7)
        + w[p + 49];
    w[p + 52] = force_9 + w[p + 52];
  }

  @Override
  public void forceOnRoot(double[] w, int i, int p) {
    // p.z - tau of each degree of freedom.
    w[i + 130] = w[i + 102] - w[i + 47];
    w[i + 131] = w[i + 103] - w[i + 48];
    w[i + 132] = w[i + 104] - w[i + 49];
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
    double tau_x = w[i + 102];
    double tau_y = w[i + 103];
    double tau_z = w[i + 104];
    double R_xx = w[i + 105];
    double R_xy = w[i + 106];
    double R_xz = w[i + 107];
    double R_yx = w[i + 108];
    double R_yy = w[i + 109];
    double R_yz = w[i + 110];
    double R_zx = w[i + 111];
    double R_zy = w[i + 112];
    double R_zz = w[i + 113];
    double push_1 = tau_x - w[i + 47];
    double push_2 = tau_y - (w[i + 48] + w[i + 83] * push_1);
    double push_3 = tau_z - (w[i + 49] + w[i + 84] * push_1 + w[i + 118] * push_2);
    double push_4 = tau_x + w[i + 116] * push_2 + w[i + 124] * push_3;
    double push_5 = tau_y + w[i + 125] * push_3;
    double push_6 = w[i + 50] + w[i + 85] * push_1 + w[i + 119] * push_2 + w[i + 127] * push_3;
    double push_7 = w[i + 51] + w[i + 86] * push_1 + w[i + 120] * push_2 + w[i + 128] * push_3;
    double push_8 = w[i + 52] + w[i + 87] * push_1 + w[i + 121] * push_2 + w[i + 129] * push_3;
    double push_9 = push_4 * R_xx + push_5 * R_xy + tau_z * R_xz;
    double push_10 = push_4 * R_yx + push_5 * R_yy + tau_z * R_yz;
    double push_11 = push_4 * R_zx + push_5 * R_zy + tau_z * R_zz;
    double push_12 = push_6 * R_xx + push_7 * R_xy + push_8 * R_xz;
    double push_13 = push_6 * R_yx + push_7 * R_yy + push_8 * R_yz;
    double push_14 = push_6 * R_zx + push_7 * R_zy + push_8 * R_zz;
    double push_15 = E_xx * push_12 + E_xy * push_13 + E_xz * push_14;
    double push_16 = E_yx * push_12 + E_yy * push_13 + E_yz * push_14;
    double push_17 = E_zx * push_12 + E_zy * push_13 + E_zz * push_14;
    w[i + 81] = push_1 / w[i + 80];
    w[i + 115] = push_2 / w[i + 114];
    w[i + 123] = push_3 / w[i + 122];
    w[p + 47] = E_xx * push_9 + E_xy * push_10 + E_xz * push_11 + (r_y * push_17 - r_z * push_16)
        + w[p + 47];
    w[p + 50] = push_15 + w[p + 50];
    w[p + 48] = E_yx * push_9 + E_yy * push_10 + E_yz * push_11 + (r_z * push_15 - r_x * push_17)
        + w[p + 48];
    w[p + 51] = push_16 + w[p + 51];
    w[p + 49] = E_zx * push_9 + E_zy * push_10 + E_zz * push_11 + (r_x * push_16 - r_y * push_15)
        + w[p + 49];
    w[p + 52] = push_17 + w[p + 52];
  }

  @Override
  public void pushOnRoot(double[] w, int i, int p) {
    // u / D of each degree of freedom, with its D and U / D.
    double pushOnRoot_1 = w[i + 102] - w[i + 47];
    double pushOnRoot_2 = w[i + 103] - (w[i + 48] + w[i + 83] * pushOnRoot_1);
    w[i + 81] = pushOnRoot_1 / w[i + 80];
    w[i + 115] = pushOnRoot_2 / w[i + 114];
    w[i + 123] = (w[i + 104] - (w[i + 49] + w[i + 84] * pushOnRoot_1
        + w[i + 118] * pushOnRoot_2)) / w[i + 122];
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
    double above_7 = w[p + 7];
    double above_8 = w[p + 8];
    double R_xx = w[i + 105];
    double R_xy = w[i + 106];
    double R_xz = w[i + 107];
    double R_yx = w[i + 108];
    double R_yy = w[i + 109];
    double R_yz = w[i + 110];
    double R_zx = w[i + 111];
    double R_zy = w[i + 112];
    double R_zz = w[i + 113];
    double couple_1 = w[p + 0] + above_6;
    double couple_2 = w[p + 1] - w[i + 83] * couple_1 + above_7;
    double couple_3 = w[p + 2] - w[i + 84] * couple_1 - w[i + 118] * couple_2 + above_8;
    double couple_4 = above_6 + w[i + 116] * couple_2 + w[i + 124] * couple_3;
    double couple_5 = above_7 + w[i + 125] * couple_3;
    double couple_6 = w[p + 3] - w[i + 85] * couple_1 - w[i + 119] * couple_2
        - w[i + 127] * couple_3;
    double couple_7 = w[p + 4] - w[i + 86] * couple_1 - w[i + 120] * couple_2
        - w[i + 128] * couple_3;
    double couple_8 = w[p + 5] - w[i + 87] * couple_1 - w[i + 121] * couple_2
        - w[i + 129] * couple_3;
    double couple_9 = couple_4 * R_xx + couple_5 * R_xy + above_8 * R_xz;
    double couple_10 = couple_4 * R_yx + couple_5 * R_yy + above_8 * R_yz;
    double couple_11 = couple_4 * R_zx + couple_5 * R_zy + above_8 * R_zz;
    double couple_12 = couple_6 * R_xx + couple_7 * R_xy + couple_8 * R_xz;
    double couple_13 = couple_6 * R_yx + couple_7 * R_yy + couple_8 * R_yz;
    double couple_14 = couple_6 * R_zx + couple_7 * R_zy + couple_8 * R_zz;
    double couple_15 = E_xx * couple_12 + E_xy * couple_13 + E_xz * couple_14;
    double couple_16 = E_yx * couple_12 + E_yy * couple_13 + E_yz * couple_14;
    double couple_17 = E_zx * couple_12 + E_zy * couple_13 + E_zz * couple_14;
    w[p + 6] = couple_1;
    w[p + 7] = couple_2;
    w[p + 8] = couple_3;
    w[p + 9] = r_y * couple_17 - r_z * couple_16 - (E_xx * couple_9 + E_xy * couple_10
        + E_xz * couple_11);
    w[p + 10] = r_z * couple_15 - r_x * couple_17 - (E_yx * couple_9 + E_yy * couple_10
        + E_yz * couple_11);
    w[p + 11] = r_x * couple_16 - r_y * couple_15 - (E_zx * couple_9 + E_zy * couple_10
        + E_zz * couple_11);
    w[p + 12] = couple_15;
    w[p + 13] = couple_16;
    w[p + 14] = couple_17;
  }

  @Override
  public void coupleOnRoot(double[] w, int i, int p) {
    // kappa + K.z of each degree of freedom.
    double coupleOnRoot_1 = w[p + 0] + w[p + 6];
    double coupleOnRoot_2 = w[p + 1] - w[i + 83] * coupleOnRoot_1 + w[p + 7];
    w[p + 6] = coupleOnRoot_1;
    w[p + 7] = coupleOnRoot_2;
    w[p + 8] = w[p + 2] - w[i + 84] * coupleOnRoot_1 - w[i + 118] * coupleOnRoot_2 + w[p + 8];
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
    double Kn_x = w[p + 0];
    double Kn_y = w[p + 1];
    double Kn_z = w[p + 2];
    double Kf_x = w[p + 3];
    double Kf_y = w[p + 4];
    double Kf_z = w[p + 5];
    double R_xx = w[i + 105];
    double R_xy = w[i + 106];
    double R_xz = w[i + 107];
    double R_yx = w[i + 108];
    double R_yy = w[i + 109];
    double R_yz = w[i + 110];
    double R_zx = w[i + 111];
    double R_zy = w[i + 112];
    double R_zz = w[i + 113];
    double transfer_1 = Kn_x * R_xx + Kn_y * R_xy + Kn_z * R_xz;
    double transfer_2 = Kn_x * R_yx + Kn_y * R_yy + Kn_z * R_yz;
    double transfer_3 = Kn_x * R_zx + Kn_y * R_zy + Kn_z * R_zz;
    double transfer_4 = Kf_x * R_xx + Kf_y * R_xy + Kf_z * R_xz;
    double transfer_5 = Kf_x * R_yx + Kf_y * R_yy + Kf_z * R_yz;
    double transfer_6 = Kf_x * R_zx + Kf_y * R_zy + Kf_z * R_zz;
    double transfer_7 = E_xx * transfer_4 + E_xy * transfer_5 + E_xz * transfer_6;
    double transfer_8 = E_yx * transfer_4 + E_yy * transfer_5 + E_yz * transfer_6;
    double transfer_9 = E_zx * transfer_4 + E_zy * transfer_5 + E_zz * transfer_6;
    w[p + 9] = E_xx * transfer_1 + E_xy * transfer_2 + E_xz * transfer_3 + (r_y * transfer_9
        - r_z * transfer_8);
    w[p + 10] = E_yx * transfer_1 + E_yy * transfer_2 + E_yz * transfer_3 + (r_z * transfer_7
        - r_x * transfer_9);
    w[p + 11] = E_zx * transfer_1 + E_zy * transfer_2 + E_zz * transfer_3 + (r_x * transfer_8
        - r_y * transfer_7);
    w[p + 12] = transfer_7;
    w[p + 13] = transfer_8;
    w[p + 14] = transfer_9;
  }
}
