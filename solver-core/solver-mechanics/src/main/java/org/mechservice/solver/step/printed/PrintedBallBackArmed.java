package org.mechservice.solver.step.printed;

import org.mechservice.solver.step.StepKernel;

/**
 * Printed from its equations; do not edit. PrintedStepsTest compares it with them and
 * prints it anew with -Dgolden.write=true.
 */
final class PrintedBallBackArmed implements StepKernel {

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
    double A = w[i + 95];
    double H_xx = w[i + 65];
    double n_x = w[i + 47];
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
    double D_x = A + J_xx;
    double one_over_D_x = 1.0 / D_x;
    double kn_x_x = J_xx * one_over_D_x;
    double kn_x_y = J_xy * one_over_D_x;
    double kn_x_z = J_xz * one_over_D_x;
    double kf_x_x = H_xx * one_over_D_x;
    double kf_x_y = H_xy * one_over_D_x;
    double kf_x_z = H_xz * one_over_D_x;
    double u_over_D_x = one_over_D_x * (w[i + 102] - n_x);
    double inertia_1 = w[i + 48] + J_xy * u_over_D_x;
    double inertia_2 = J_xy - J_xy * kn_x_x;
    double inertia_3 = w[i + 27] + w[i + 60] - J_xy * kn_x_y;
    double inertia_4 = w[i + 31] + w[i + 64] - J_xz * kn_x_y;
    double inertia_5 = link__25 + w[i + 68] - H_xx * kn_x_y;
    double inertia_6 = w[i + 69] - H_xy * kn_x_y;
    double inertia_7 = w[i + 70] - link__23 - H_xz * kn_x_y;
    double D_y = A + inertia_3;
    double one_over_D_y = 1.0 / D_y;
    double kn_y_x = inertia_2 * one_over_D_y;
    double kn_y_y = inertia_3 * one_over_D_y;
    double kn_y_z = inertia_4 * one_over_D_y;
    double kf_y_x = inertia_5 * one_over_D_y;
    double kf_y_y = inertia_6 * one_over_D_y;
    double kf_y_z = inertia_7 * one_over_D_y;
    double u_over_D_y = one_over_D_y * (w[i + 103] - inertia_1);
    double inertia_8 = w[i + 49] + J_xz * u_over_D_x + inertia_4 * u_over_D_y;
    double inertia_9 = J_xz - J_xz * kn_x_x - inertia_4 * kn_y_x;
    double inertia_10 = inertia_4 - inertia_4 * kn_y_y;
    double inertia_11 = w[i + 28] + w[i + 61] - J_xz * kn_x_z - inertia_4 * kn_y_z;
    double inertia_12 = w[i + 71] - link__24 - H_xx * kn_x_z - inertia_5 * kn_y_z;
    double inertia_13 = link__23 + w[i + 72] - H_xy * kn_x_z - inertia_6 * kn_y_z;
    double inertia_14 = w[i + 73] - H_xz * kn_x_z - inertia_7 * kn_y_z;
    double D_z = A + inertia_11;
    double one_over_D_z = 1.0 / D_z;
    double kn_z_x = inertia_9 * one_over_D_z;
    double kn_z_y = inertia_10 * one_over_D_z;
    double kn_z_z = inertia_11 * one_over_D_z;
    double kf_z_x = inertia_12 * one_over_D_z;
    double kf_z_y = inertia_13 * one_over_D_z;
    double kf_z_z = inertia_14 * one_over_D_z;
    double u_over_D_z = one_over_D_z * (w[i + 104] - inertia_8);
    double inertia_15 = n_x + J_xx * u_over_D_x + inertia_2 * u_over_D_y + inertia_9 * u_over_D_z;
    double inertia_16 = inertia_1 + inertia_3 * u_over_D_y + inertia_10 * u_over_D_z;
    double inertia_17 = inertia_8 + inertia_11 * u_over_D_z;
    double inertia_18 = w[i + 50] + H_xx * u_over_D_x + inertia_5 * u_over_D_y
        + inertia_12 * u_over_D_z;
    double inertia_19 = w[i + 51] + H_xy * u_over_D_x + inertia_6 * u_over_D_y
        + inertia_13 * u_over_D_z;
    double inertia_20 = w[i + 52] + H_xz * u_over_D_x + inertia_7 * u_over_D_y
        + inertia_14 * u_over_D_z;
    double inertia_21 = J_xx - J_xx * kn_x_x - inertia_2 * kn_y_x - inertia_9 * kn_z_x;
    double inertia_22 = inertia_2 - inertia_3 * kn_y_x - inertia_10 * kn_z_x;
    double inertia_23 = inertia_9 - inertia_11 * kn_z_x;
    double inertia_24 = inertia_3 - inertia_3 * kn_y_y - inertia_10 * kn_z_y;
    double inertia_25 = inertia_10 - inertia_11 * kn_z_y;
    double inertia_26 = inertia_11 - inertia_11 * kn_z_z;
    double inertia_27 = H_xx - H_xx * kn_x_x - inertia_5 * kn_y_x - inertia_12 * kn_z_x;
    double inertia_28 = H_xy - H_xy * kn_x_x - inertia_6 * kn_y_x - inertia_13 * kn_z_x;
    double inertia_29 = H_xz - H_xz * kn_x_x - inertia_7 * kn_y_x - inertia_14 * kn_z_x;
    double inertia_30 = inertia_5 - inertia_5 * kn_y_y - inertia_12 * kn_z_y;
    double inertia_31 = inertia_6 - inertia_6 * kn_y_y - inertia_13 * kn_z_y;
    double inertia_32 = inertia_7 - inertia_7 * kn_y_y - inertia_14 * kn_z_y;
    double inertia_33 = inertia_12 - inertia_12 * kn_z_z;
    double inertia_34 = inertia_13 - inertia_13 * kn_z_z;
    double inertia_35 = inertia_14 - inertia_14 * kn_z_z;
    double inertia_36 = m + w[i + 74] - H_xx * kf_x_x - inertia_5 * kf_y_x - inertia_12 * kf_z_x;
    double inertia_37 = w[i + 77] - H_xy * kf_x_x - inertia_6 * kf_y_x - inertia_13 * kf_z_x;
    double inertia_38 = w[i + 78] - H_xz * kf_x_x - inertia_7 * kf_y_x - inertia_14 * kf_z_x;
    double inertia_39 = m + w[i + 75] - H_xy * kf_x_y - inertia_6 * kf_y_y - inertia_13 * kf_z_y;
    double inertia_40 = w[i + 79] - H_xz * kf_x_y - inertia_7 * kf_y_y - inertia_14 * kf_z_y;
    double inertia_41 = m + w[i + 76] - H_xz * kf_x_z - inertia_7 * kf_y_z - inertia_14 * kf_z_z;
    double inertia_42 = inertia_21 * R_xx + inertia_22 * R_xy + inertia_23 * R_xz;
    double inertia_43 = inertia_22 * R_xx + inertia_24 * R_xy + inertia_25 * R_xz;
    double inertia_44 = inertia_23 * R_xx + inertia_25 * R_xy + inertia_26 * R_xz;
    double inertia_45 = inertia_21 * R_yx + inertia_22 * R_yy + inertia_23 * R_yz;
    double inertia_46 = inertia_22 * R_yx + inertia_24 * R_yy + inertia_25 * R_yz;
    double inertia_47 = inertia_23 * R_yx + inertia_25 * R_yy + inertia_26 * R_yz;
    double inertia_48 = R_xx * inertia_42 + R_xy * inertia_43 + R_xz * inertia_44;
    double inertia_49 = R_yx * inertia_42 + R_yy * inertia_43 + R_yz * inertia_44;
    double inertia_50 = R_zx * inertia_42 + R_zy * inertia_43 + R_zz * inertia_44;
    double inertia_51 = R_yx * inertia_45 + R_yy * inertia_46 + R_yz * inertia_47;
    double inertia_52 = R_zx * inertia_45 + R_zy * inertia_46 + R_zz * inertia_47;
    double inertia_53 = R_zx * (inertia_21 * R_zx + inertia_22 * R_zy + inertia_23 * R_zz)
        + R_zy * (inertia_22 * R_zx + inertia_24 * R_zy + inertia_25 * R_zz)
        + R_zz * (inertia_23 * R_zx + inertia_25 * R_zy + inertia_26 * R_zz);
    double inertia_54 = inertia_27 * R_xx + inertia_30 * R_xy + inertia_33 * R_xz;
    double inertia_55 = inertia_28 * R_xx + inertia_31 * R_xy + inertia_34 * R_xz;
    double inertia_56 = inertia_29 * R_xx + inertia_32 * R_xy + inertia_35 * R_xz;
    double inertia_57 = inertia_27 * R_yx + inertia_30 * R_yy + inertia_33 * R_yz;
    double inertia_58 = inertia_28 * R_yx + inertia_31 * R_yy + inertia_34 * R_yz;
    double inertia_59 = inertia_29 * R_yx + inertia_32 * R_yy + inertia_35 * R_yz;
    double inertia_60 = inertia_27 * R_zx + inertia_30 * R_zy + inertia_33 * R_zz;
    double inertia_61 = inertia_28 * R_zx + inertia_31 * R_zy + inertia_34 * R_zz;
    double inertia_62 = inertia_29 * R_zx + inertia_32 * R_zy + inertia_35 * R_zz;
    double inertia_63 = R_xx * inertia_54 + R_xy * inertia_55 + R_xz * inertia_56;
    double inertia_64 = R_yx * inertia_54 + R_yy * inertia_55 + R_yz * inertia_56;
    double inertia_65 = R_zx * inertia_54 + R_zy * inertia_55 + R_zz * inertia_56;
    double inertia_66 = R_xx * inertia_57 + R_xy * inertia_58 + R_xz * inertia_59;
    double inertia_67 = R_yx * inertia_57 + R_yy * inertia_58 + R_yz * inertia_59;
    double inertia_68 = R_zx * inertia_57 + R_zy * inertia_58 + R_zz * inertia_59;
    double inertia_69 = R_xx * inertia_60 + R_xy * inertia_61 + R_xz * inertia_62;
    double inertia_70 = R_yx * inertia_60 + R_yy * inertia_61 + R_yz * inertia_62;
    double inertia_71 = R_zx * inertia_60 + R_zy * inertia_61 + R_zz * inertia_62;
    double inertia_72 = inertia_36 * R_xx + inertia_37 * R_xy + inertia_38 * R_xz;
    double inertia_73 = inertia_37 * R_xx + inertia_39 * R_xy + inertia_40 * R_xz;
    double inertia_74 = inertia_38 * R_xx + inertia_40 * R_xy + inertia_41 * R_xz;
    double inertia_75 = inertia_36 * R_yx + inertia_37 * R_yy + inertia_38 * R_yz;
    double inertia_76 = inertia_37 * R_yx + inertia_39 * R_yy + inertia_40 * R_yz;
    double inertia_77 = inertia_38 * R_yx + inertia_40 * R_yy + inertia_41 * R_yz;
    double inertia_78 = R_xx * inertia_72 + R_xy * inertia_73 + R_xz * inertia_74;
    double inertia_79 = R_yx * inertia_72 + R_yy * inertia_73 + R_yz * inertia_74;
    double inertia_80 = R_zx * inertia_72 + R_zy * inertia_73 + R_zz * inertia_74;
    double inertia_81 = R_yx * inertia_75 + R_yy * inertia_76 + R_yz * inertia_77;
    double inertia_82 = R_zx * inertia_75 + R_zy * inertia_76 + R_zz * inertia_77;
    double inertia_83 = R_zx * (inertia_36 * R_zx + inertia_37 * R_zy + inertia_38 * R_zz)
        + R_zy * (inertia_37 * R_zx + inertia_39 * R_zy + inertia_40 * R_zz)
        + R_zz * (inertia_38 * R_zx + inertia_40 * R_zy + inertia_41 * R_zz);
    double inertia_84 = E_xx * inertia_48 + E_xy * inertia_49 + E_xz * inertia_50;
    double inertia_85 = E_xx * inertia_49 + E_xy * inertia_51 + E_xz * inertia_52;
    double inertia_86 = E_xx * inertia_50 + E_xy * inertia_52 + E_xz * inertia_53;
    double inertia_87 = E_yx * inertia_48 + E_yy * inertia_49 + E_yz * inertia_50;
    double inertia_88 = E_yx * inertia_49 + E_yy * inertia_51 + E_yz * inertia_52;
    double inertia_89 = E_yx * inertia_50 + E_yy * inertia_52 + E_yz * inertia_53;
    double inertia_90 = E_zx * (E_zx * inertia_48 + E_zy * inertia_49 + E_zz * inertia_50)
        + E_zy * (E_zx * inertia_49 + E_zy * inertia_51 + E_zz * inertia_52)
        + E_zz * (E_zx * inertia_50 + E_zy * inertia_52 + E_zz * inertia_53);
    double inertia_91 = E_xx * inertia_63 + E_xy * inertia_66 + E_xz * inertia_69;
    double inertia_92 = E_xx * inertia_64 + E_xy * inertia_67 + E_xz * inertia_70;
    double inertia_93 = E_xx * inertia_65 + E_xy * inertia_68 + E_xz * inertia_71;
    double inertia_94 = E_yx * inertia_63 + E_yy * inertia_66 + E_yz * inertia_69;
    double inertia_95 = E_yx * inertia_64 + E_yy * inertia_67 + E_yz * inertia_70;
    double inertia_96 = E_yx * inertia_65 + E_yy * inertia_68 + E_yz * inertia_71;
    double inertia_97 = E_zx * inertia_63 + E_zy * inertia_66 + E_zz * inertia_69;
    double inertia_98 = E_zx * inertia_64 + E_zy * inertia_67 + E_zz * inertia_70;
    double inertia_99 = E_zx * inertia_65 + E_zy * inertia_68 + E_zz * inertia_71;
    double inertia_100 = E_xx * inertia_91 + E_xy * inertia_92 + E_xz * inertia_93;
    double inertia_101 = E_yx * inertia_91 + E_yy * inertia_92 + E_yz * inertia_93;
    double inertia_102 = E_zx * inertia_91 + E_zy * inertia_92 + E_zz * inertia_93;
    double inertia_103 = E_xx * inertia_94 + E_xy * inertia_95 + E_xz * inertia_96;
    double inertia_104 = E_yx * inertia_94 + E_yy * inertia_95 + E_yz * inertia_96;
    double inertia_105 = E_zx * inertia_94 + E_zy * inertia_95 + E_zz * inertia_96;
    double inertia_106 = E_xx * inertia_97 + E_xy * inertia_98 + E_xz * inertia_99;
    double inertia_107 = E_yx * inertia_97 + E_yy * inertia_98 + E_yz * inertia_99;
    double inertia_108 = E_zx * inertia_97 + E_zy * inertia_98 + E_zz * inertia_99;
    double inertia_109 = E_xx * inertia_78 + E_xy * inertia_79 + E_xz * inertia_80;
    double inertia_110 = E_xx * inertia_79 + E_xy * inertia_81 + E_xz * inertia_82;
    double inertia_111 = E_xx * inertia_80 + E_xy * inertia_82 + E_xz * inertia_83;
    double inertia_112 = E_yx * inertia_78 + E_yy * inertia_79 + E_yz * inertia_80;
    double inertia_113 = E_yx * inertia_79 + E_yy * inertia_81 + E_yz * inertia_82;
    double inertia_114 = E_yx * inertia_80 + E_yy * inertia_82 + E_yz * inertia_83;
    double inertia_115 = E_xx * inertia_109 + E_xy * inertia_110 + E_xz * inertia_111;
    double inertia_116 = E_yx * inertia_109 + E_yy * inertia_110 + E_yz * inertia_111;
    double inertia_117 = E_zx * inertia_109 + E_zy * inertia_110 + E_zz * inertia_111;
    double inertia_118 = E_yx * inertia_112 + E_yy * inertia_113 + E_yz * inertia_114;
    double inertia_119 = E_zx * inertia_112 + E_zy * inertia_113 + E_zz * inertia_114;
    double inertia_120 = E_zx * (E_zx * inertia_78 + E_zy * inertia_79 + E_zz * inertia_80)
        + E_zy * (E_zx * inertia_79 + E_zy * inertia_81 + E_zz * inertia_82)
        + E_zz * (E_zx * inertia_80 + E_zy * inertia_82 + E_zz * inertia_83);
    double inertia_121 = r_z * inertia_116;
    double inertia_122 = r_y * inertia_117;
    double inertia_123 = r_x * inertia_119;
    double inertia_124 = inertia_122 - inertia_121 + inertia_100;
    double inertia_125 = r_y * inertia_119 - r_z * inertia_118 + inertia_101;
    double inertia_126 = r_y * inertia_120 - r_z * inertia_119 + inertia_102;
    double inertia_127 = r_z * inertia_115 - r_x * inertia_117 + inertia_103;
    double inertia_128 = inertia_121 - inertia_123 + inertia_104;
    double inertia_129 = r_z * inertia_117 - r_x * inertia_120 + inertia_105;
    double inertia_130 = r_x * inertia_116 - r_y * inertia_115 + inertia_106;
    double inertia_131 = r_x * inertia_118 - r_y * inertia_116 + inertia_107;
    double inertia_132 = inertia_123 - inertia_122 + inertia_108;
    double inertia_133 = inertia_15 * R_xx + inertia_16 * R_xy + inertia_17 * R_xz;
    double inertia_134 = inertia_15 * R_yx + inertia_16 * R_yy + inertia_17 * R_yz;
    double inertia_135 = inertia_15 * R_zx + inertia_16 * R_zy + inertia_17 * R_zz;
    double inertia_136 = inertia_18 * R_xx + inertia_19 * R_xy + inertia_20 * R_xz;
    double inertia_137 = inertia_18 * R_yx + inertia_19 * R_yy + inertia_20 * R_yz;
    double inertia_138 = inertia_18 * R_zx + inertia_19 * R_zy + inertia_20 * R_zz;
    double inertia_139 = E_xx * inertia_136 + E_xy * inertia_137 + E_xz * inertia_138;
    double inertia_140 = E_yx * inertia_136 + E_yy * inertia_137 + E_yz * inertia_138;
    double inertia_141 = E_zx * inertia_136 + E_zy * inertia_137 + E_zz * inertia_138;
    w[i + 80] = D_x;
    w[i + 81] = u_over_D_x;
    w[i + 82] = kn_x_x;
    w[i + 83] = kn_x_y;
    w[i + 84] = kn_x_z;
    w[i + 85] = kf_x_x;
    w[i + 86] = kf_x_y;
    w[i + 87] = kf_x_z;
    w[i + 114] = D_y;
    w[i + 115] = u_over_D_y;
    w[i + 116] = kn_y_x;
    w[i + 117] = kn_y_y;
    w[i + 118] = kn_y_z;
    w[i + 119] = kf_y_x;
    w[i + 120] = kf_y_y;
    w[i + 121] = kf_y_z;
    w[i + 122] = D_z;
    w[i + 123] = u_over_D_z;
    w[i + 124] = kn_z_x;
    w[i + 125] = kn_z_y;
    w[i + 126] = kn_z_z;
    w[i + 127] = kf_z_x;
    w[i + 128] = kf_z_y;
    w[i + 129] = kf_z_z;
    w[p + 59] = E_xx * inertia_84 + E_xy * inertia_85 + E_xz * inertia_86 + (r_y * (inertia_102
        + inertia_126) - r_z * (inertia_101 + inertia_125)) + w[p + 59];
    w[p + 60] = E_yx * inertia_87 + E_yy * inertia_88 + E_yz * inertia_89 + (r_z * (inertia_103
        + inertia_127) - r_x * (inertia_105 + inertia_129)) + w[p + 60];
    w[p + 61] = r_x * (inertia_107 + inertia_131) - r_y * (inertia_106 + inertia_130) + inertia_90
        + w[p + 61];
    w[p + 62] = E_yx * inertia_84 + E_yy * inertia_85 + E_yz * inertia_86 + (r_y * inertia_129
        - r_x * inertia_102 + r_z * (inertia_100 - inertia_128)) + w[p + 62];
    w[p + 63] = E_zx * inertia_84 + E_zy * inertia_85 + E_zz * inertia_86 + (r_x * inertia_125
        - r_z * inertia_107 + r_y * (inertia_108 - inertia_124)) + w[p + 63];
    w[p + 64] = E_zx * inertia_87 + E_zy * inertia_88 + E_zz * inertia_89 + (r_z * inertia_130
        - r_y * inertia_103 + r_x * (inertia_104 - inertia_132)) + w[p + 64];
    w[p + 65] = inertia_124 + w[p + 65];
    w[p + 66] = inertia_125 + w[p + 66];
    w[p + 67] = inertia_126 + w[p + 67];
    w[p + 68] = inertia_127 + w[p + 68];
    w[p + 69] = inertia_128 + w[p + 69];
    w[p + 70] = inertia_129 + w[p + 70];
    w[p + 71] = inertia_130 + w[p + 71];
    w[p + 72] = inertia_131 + w[p + 72];
    w[p + 73] = inertia_132 + w[p + 73];
    w[p + 74] = inertia_115 + w[p + 74];
    w[p + 75] = inertia_118 + w[p + 75];
    w[p + 76] = inertia_120 + w[p + 76];
    w[p + 77] = inertia_116 + w[p + 77];
    w[p + 78] = inertia_117 + w[p + 78];
    w[p + 79] = inertia_119 + w[p + 79];
    w[p + 47] = E_xx * inertia_133 + E_xy * inertia_134 + E_xz * inertia_135 + (r_y * inertia_141
        - r_z * inertia_140) + w[p + 47];
    w[p + 50] = inertia_139 + w[p + 50];
    w[p + 48] = E_yx * inertia_133 + E_yy * inertia_134 + E_yz * inertia_135 + (r_z * inertia_139
        - r_x * inertia_141) + w[p + 48];
    w[p + 51] = inertia_140 + w[p + 51];
    w[p + 49] = E_zx * inertia_133 + E_zy * inertia_134 + E_zz * inertia_135 + (r_x * inertia_140
        - r_y * inertia_139) + w[p + 49];
    w[p + 52] = inertia_141 + w[p + 52];
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
    double A = w[i + 95];
    double H_xx = w[i + 65];
    double J_xx = w[i + 26] + w[i + 59];
    double J_xy = w[i + 29] + w[i + 62];
    double J_xz = w[i + 30] + w[i + 63];
    double H_xy = w[i + 66] - link__25;
    double H_xz = link__24 + w[i + 67];
    double D_x = A + J_xx;
    double one_over_D_x = 1.0 / D_x;
    double kn_x_x = J_xx * one_over_D_x;
    double kn_x_y = J_xy * one_over_D_x;
    double kn_x_z = J_xz * one_over_D_x;
    double u_over_D_x = one_over_D_x * (w[i + 102] - w[i + 47]);
    double inertiaOnRoot_1 = w[i + 27] + w[i + 60] - J_xy * kn_x_y;
    double inertiaOnRoot_2 = w[i + 31] + w[i + 64] - J_xz * kn_x_y;
    double inertiaOnRoot_3 = link__25 + w[i + 68] - H_xx * kn_x_y;
    double inertiaOnRoot_4 = w[i + 69] - H_xy * kn_x_y;
    double inertiaOnRoot_5 = w[i + 70] - link__23 - H_xz * kn_x_y;
    double D_y = A + inertiaOnRoot_1;
    double one_over_D_y = 1.0 / D_y;
    double kn_y_x = (J_xy - J_xy * kn_x_x) * one_over_D_y;
    double kn_y_y = inertiaOnRoot_1 * one_over_D_y;
    double kn_y_z = inertiaOnRoot_2 * one_over_D_y;
    double u_over_D_y = one_over_D_y * (w[i + 103] - (w[i + 48] + J_xy * u_over_D_x));
    double inertiaOnRoot_6 = w[i + 28] + w[i + 61] - J_xz * kn_x_z - inertiaOnRoot_2 * kn_y_z;
    double D_z = A + inertiaOnRoot_6;
    double one_over_D_z = 1.0 / D_z;
    w[i + 80] = D_x;
    w[i + 81] = u_over_D_x;
    w[i + 82] = kn_x_x;
    w[i + 83] = kn_x_y;
    w[i + 84] = kn_x_z;
    w[i + 85] = H_xx * one_over_D_x;
    w[i + 86] = H_xy * one_over_D_x;
    w[i + 87] = H_xz * one_over_D_x;
    w[i + 114] = D_y;
    w[i + 115] = u_over_D_y;
    w[i + 116] = kn_y_x;
    w[i + 117] = kn_y_y;
    w[i + 118] = kn_y_z;
    w[i + 119] = inertiaOnRoot_3 * one_over_D_y;
    w[i + 120] = inertiaOnRoot_4 * one_over_D_y;
    w[i + 121] = inertiaOnRoot_5 * one_over_D_y;
    w[i + 122] = D_z;
    w[i + 123] = (w[i + 104] - (w[i + 49] + J_xz * u_over_D_x
        + inertiaOnRoot_2 * u_over_D_y)) / D_z;
    w[i + 124] = (J_xz - J_xz * kn_x_x - inertiaOnRoot_2 * kn_y_x) * one_over_D_z;
    w[i + 125] = (inertiaOnRoot_2 - inertiaOnRoot_2 * kn_y_y) * one_over_D_z;
    w[i + 126] = inertiaOnRoot_6 * one_over_D_z;
    w[i + 127] = (w[i + 71] - link__24 - H_xx * kn_x_z - inertiaOnRoot_3 * kn_y_z) * one_over_D_z;
    w[i + 128] = (link__23 + w[i + 72] - H_xy * kn_x_z - inertiaOnRoot_4 * kn_y_z) * one_over_D_z;
    w[i + 129] = (w[i + 73] - H_xz * kn_x_z - inertiaOnRoot_5 * kn_y_z) * one_over_D_z;
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
        + acceleration_11 * w[i + 125] + acceleration_12 * w[i + 126] + (da_x * w[i + 127]
        + da_y * w[i + 128] + da_z * w[i + 129]));
    double dalpha_z = acceleration_12 + acceleration_13;
    double acceleration_14 = w[i + 115] - (acceleration_10 * w[i + 116]
        + acceleration_11 * w[i + 117] + dalpha_z * w[i + 118] + (da_x * w[i + 119]
        + da_y * w[i + 120] + da_z * w[i + 121]));
    double dalpha_y = acceleration_11 + acceleration_14;
    double acceleration_15 = w[i + 81] - (acceleration_10 * w[i + 82] + dalpha_y * w[i + 83]
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
    double A = w[i + 95];
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
    w[i + 130] = A * w[i + 99] - (w[i + 47] + driving_1 - w[i + 102]);
    w[i + 131] = A * w[i + 100] - (w[i + 48] + driving_2 - w[i + 103]);
    w[i + 132] = A * w[i + 101] - (w[i + 49] + driving_3 - w[i + 104]);
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
    double A = w[i + 95];
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
    w[i + 130] = A * w[i + 99] - (n_x - w[i + 102]);
    w[i + 131] = A * w[i + 100] - (n_y - w[i + 103]);
    w[i + 132] = A * w[i + 101] - (n_z - w[i + 104]);
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
    double A = w[i + 95];
    w[i + 130] = A * w[i + 99] - (w[i + 47] - w[i + 102]);
    w[i + 131] = A * w[i + 100] - (w[i + 48] - w[i + 103]);
    w[i + 132] = A * w[i + 101] - (w[i + 49] - w[i + 104]);
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
    double n_x = w[i + 47];
    double R_xx = w[i + 105];
    double R_xy = w[i + 106];
    double R_xz = w[i + 107];
    double R_yx = w[i + 108];
    double R_yy = w[i + 109];
    double R_yz = w[i + 110];
    double R_zx = w[i + 111];
    double R_zy = w[i + 112];
    double R_zz = w[i + 113];
    double push_1 = w[i + 102] - n_x;
    double push_2 = w[i + 48] + w[i + 83] * push_1;
    double push_3 = w[i + 103] - push_2;
    double push_4 = w[i + 49] + w[i + 84] * push_1 + w[i + 118] * push_3;
    double push_5 = w[i + 104] - push_4;
    double push_6 = n_x + w[i + 82] * push_1 + w[i + 116] * push_3 + w[i + 124] * push_5;
    double push_7 = push_2 + w[i + 117] * push_3 + w[i + 125] * push_5;
    double push_8 = push_4 + w[i + 126] * push_5;
    double push_9 = w[i + 50] + w[i + 85] * push_1 + w[i + 119] * push_3 + w[i + 127] * push_5;
    double push_10 = w[i + 51] + w[i + 86] * push_1 + w[i + 120] * push_3 + w[i + 128] * push_5;
    double push_11 = w[i + 52] + w[i + 87] * push_1 + w[i + 121] * push_3 + w[i + 129] * push_5;
    double push_12 = push_6 * R_xx + push_7 * R_xy + push_8 * R_xz;
    double push_13 = push_6 * R_yx + push_7 * R_yy + push_8 * R_yz;
    double push_14 = push_6 * R_zx + push_7 * R_zy + push_8 * R_zz;
    double push_15 = push_9 * R_xx + push_10 * R_xy + push_11 * R_xz;
    double push_16 = push_9 * R_yx + push_10 * R_yy + push_11 * R_yz;
    double push_17 = push_9 * R_zx + push_10 * R_zy + push_11 * R_zz;
    double push_18 = E_xx * push_15 + E_xy * push_16 + E_xz * push_17;
    double push_19 = E_yx * push_15 + E_yy * push_16 + E_yz * push_17;
    double push_20 = E_zx * push_15 + E_zy * push_16 + E_zz * push_17;
    w[i + 81] = push_1 / w[i + 80];
    w[i + 115] = push_3 / w[i + 114];
    w[i + 123] = push_5 / w[i + 122];
    w[p + 47] = E_xx * push_12 + E_xy * push_13 + E_xz * push_14 + (r_y * push_20 - r_z * push_19)
        + w[p + 47];
    w[p + 50] = push_18 + w[p + 50];
    w[p + 48] = E_yx * push_12 + E_yy * push_13 + E_yz * push_14 + (r_z * push_18 - r_x * push_20)
        + w[p + 48];
    w[p + 51] = push_19 + w[p + 51];
    w[p + 49] = E_zx * push_12 + E_zy * push_13 + E_zz * push_14 + (r_x * push_19 - r_y * push_18)
        + w[p + 49];
    w[p + 52] = push_20 + w[p + 52];
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
    double Kn_x = w[p + 0];
    double R_xx = w[i + 105];
    double R_xy = w[i + 106];
    double R_xz = w[i + 107];
    double R_yx = w[i + 108];
    double R_yy = w[i + 109];
    double R_yz = w[i + 110];
    double R_zx = w[i + 111];
    double R_zy = w[i + 112];
    double R_zz = w[i + 113];
    double couple_1 = Kn_x + w[p + 6];
    double couple_2 = w[p + 1] - w[i + 83] * couple_1;
    double couple_3 = couple_2 + w[p + 7];
    double couple_4 = w[p + 2] - w[i + 84] * couple_1 - w[i + 118] * couple_3;
    double couple_5 = couple_4 + w[p + 8];
    double couple_6 = Kn_x - w[i + 82] * couple_1 - w[i + 116] * couple_3 - w[i + 124] * couple_5;
    double couple_7 = couple_2 - w[i + 117] * couple_3 - w[i + 125] * couple_5;
    double couple_8 = couple_4 - w[i + 126] * couple_5;
    double couple_9 = w[p + 3] - w[i + 85] * couple_1 - w[i + 119] * couple_3
        - w[i + 127] * couple_5;
    double couple_10 = w[p + 4] - w[i + 86] * couple_1 - w[i + 120] * couple_3
        - w[i + 128] * couple_5;
    double couple_11 = w[p + 5] - w[i + 87] * couple_1 - w[i + 121] * couple_3
        - w[i + 129] * couple_5;
    double couple_12 = couple_6 * R_xx + couple_7 * R_xy + couple_8 * R_xz;
    double couple_13 = couple_6 * R_yx + couple_7 * R_yy + couple_8 * R_yz;
    double couple_14 = couple_6 * R_zx + couple_7 * R_zy + couple_8 * R_zz;
    double couple_15 = couple_9 * R_xx + couple_10 * R_xy + couple_11 * R_xz;
    double couple_16 = couple_9 * R_yx + couple_10 * R_yy + couple_11 * R_yz;
    double couple_17 = couple_9 * R_zx + couple_10 * R_zy + couple_11 * R_zz;
    double couple_18 = E_xx * couple_15 + E_xy * couple_16 + E_xz * couple_17;
    double couple_19 = E_yx * couple_15 + E_yy * couple_16 + E_yz * couple_17;
    double couple_20 = E_zx * couple_15 + E_zy * couple_16 + E_zz * couple_17;
    w[p + 6] = couple_1;
    w[p + 7] = couple_3;
    w[p + 8] = couple_5;
    w[p + 9] = E_xx * couple_12 + E_xy * couple_13 + E_xz * couple_14 + (r_y * couple_20
        - r_z * couple_19);
    w[p + 10] = E_yx * couple_12 + E_yy * couple_13 + E_yz * couple_14 + (r_z * couple_18
        - r_x * couple_20);
    w[p + 11] = E_zx * couple_12 + E_zy * couple_13 + E_zz * couple_14 + (r_x * couple_19
        - r_y * couple_18);
    w[p + 12] = couple_18;
    w[p + 13] = couple_19;
    w[p + 14] = couple_20;
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
