package org.mechservice.solver.step.printed;

import org.mechservice.solver.step.StepKernel;

/**
 * Printed from its equations; do not edit. PrintedStepsTest compares it with them and
 * prints it anew with -Dgolden.write=true.
 */
final class PrintedTurn implements StepKernel {

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
    double cos = w[i + 33];
    double sin = w[i + 34];
    double v = w[i + 35];
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
    double motion_12 = E_xx * alpha_p_x + E_yx * alpha_p_y + E_zx * alpha_p_z;
    double motion_13 = E_xy * alpha_p_x + E_yy * alpha_p_y + E_zy * alpha_p_z;
    double motion_14 = E_xx * motion_7 + E_yx * motion_8 + E_zx * motion_9;
    double motion_15 = E_xy * motion_7 + E_yy * motion_8 + E_zy * motion_9;
    double a_z = E_xz * motion_7 + E_yz * motion_8 + E_zz * motion_9;
    double omega_x = motion_10 * cos + motion_11 * sin;
    double omega_y = motion_11 * cos - motion_10 * sin;
    double alpha_x = motion_12 * cos + motion_13 * sin + v * omega_y;
    double alpha_y = motion_13 * cos - motion_12 * sin - v * omega_x;
    double omega_z = E_xz * omega_p_x + E_yz * omega_p_y + E_zz * omega_p_z + v;
    double alpha_z = E_xz * alpha_p_x + E_yz * alpha_p_y + E_zz * alpha_p_z + w[i + 36];
    double a_x = motion_14 * cos + motion_15 * sin;
    double a_y = motion_15 * cos - motion_14 * sin;
    double motion_16 = omega_x * omega_x;
    double motion_17 = omega_y * omega_y;
    double motion_18 = omega_z * omega_z;
    double motion_19 = omega_x * omega_y;
    double motion_20 = omega_x * omega_z;
    double motion_21 = omega_y * omega_z;
    double W_xy = motion_19 - alpha_z;
    double W_xz = alpha_y + motion_20;
    double W_yx = alpha_z + motion_19;
    double W_yz = motion_21 - alpha_x;
    double W_zx = motion_20 - alpha_y;
    double W_zy = alpha_x + motion_21;
    double motion_22 = m * (c_y * W_xy - c_x * (motion_17 + motion_18) + c_z * W_xz + a_x);
    double motion_23 = m * (c_x * W_yx - c_y * (motion_16 + motion_18) + c_z * W_yz + a_y);
    double motion_24 = m * (c_x * W_zx + c_y * W_zy - c_z * (motion_16 + motion_17) + a_z);
    double motion_25 = I_xx * alpha_x + motion_21 * (I_zz - I_yy) + I_xz * W_yx - I_xy * W_zx
        + I_yz * (motion_17 - motion_18) + (c_y * motion_24 - c_z * motion_23);
    double motion_26 = I_yy * alpha_y + motion_20 * (I_xx - I_zz) + I_xy * W_zy - I_yz * W_xy
        + I_xz * (motion_18 - motion_16) + (c_z * motion_22 - c_x * motion_24);
    double motion_27 = I_zz * alpha_z + motion_19 * (I_yy - I_xx) + I_yz * W_xz - I_xz * W_yz
        + I_xy * (motion_16 - motion_17) + (c_x * motion_23 - c_y * motion_22);
    w[i + 38] = omega_x;
    w[i + 39] = omega_y;
    w[i + 40] = omega_z;
    w[i + 41] = alpha_x;
    w[i + 42] = alpha_y;
    w[i + 43] = alpha_z;
    w[i + 44] = a_x;
    w[i + 45] = a_y;
    w[i + 46] = a_z;
    w[i + 47] = motion_25 - w[i + 53];
    w[i + 48] = motion_26 - w[i + 54];
    w[i + 49] = motion_27 - w[i + 55];
    w[i + 50] = motion_22 - w[i + 56];
    w[i + 51] = motion_23 - w[i + 57];
    w[i + 52] = motion_24 - w[i + 58];
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
    double tau = w[i + 37];
    double cos = w[i + 33];
    double sin = w[i + 34];
    double J_xz = w[i + 30] + w[i + 63];
    double J_yz = w[i + 31] + w[i + 64];
    double J_zz = w[i + 28] + w[i + 61];
    double H_zx = w[i + 71] - link__24;
    double H_zy = link__23 + w[i + 72];
    double one_over_D = 1.0 / J_zz;
    double kn_x = J_xz * one_over_D;
    double kn_y = J_yz * one_over_D;
    double kf_x = H_zx * one_over_D;
    double kf_y = H_zy * one_over_D;
    double kf_z = H_zz * one_over_D;
    double u_over_D = one_over_D * (tau - w[i + 49]);
    double inertia_1 = w[i + 47] + J_xz * u_over_D;
    double inertia_2 = w[i + 48] + J_yz * u_over_D;
    double inertia_3 = w[i + 50] + H_zx * u_over_D;
    double inertia_4 = w[i + 51] + H_zy * u_over_D;
    double inertia_5 = w[i + 52] + H_zz * u_over_D;
    double inertia_6 = w[i + 26] + w[i + 59] - J_xz * kn_x;
    double inertia_7 = w[i + 29] + w[i + 62] - J_yz * kn_x;
    double inertia_8 = w[i + 27] + w[i + 60] - J_yz * kn_y;
    double inertia_9 = w[i + 65] - H_zx * kn_x;
    double inertia_10 = w[i + 66] - link__25 - H_zy * kn_x;
    double inertia_11 = link__24 + w[i + 67] - H_zz * kn_x;
    double inertia_12 = link__25 + w[i + 68] - H_zx * kn_y;
    double inertia_13 = w[i + 69] - H_zy * kn_y;
    double inertia_14 = w[i + 70] - link__23 - H_zz * kn_y;
    double inertia_15 = m + w[i + 74] - H_zx * kf_x;
    double inertia_16 = w[i + 77] - H_zy * kf_x;
    double inertia_17 = w[i + 78] - H_zz * kf_x;
    double inertia_18 = m + w[i + 75] - H_zy * kf_y;
    double inertia_19 = w[i + 79] - H_zz * kf_y;
    double inertia_20 = m + w[i + 76] - H_zz * kf_z;
    double inertia_21 = 2.0 * cos;
    double inertia_22 = inertia_7 * inertia_21 + sin * (inertia_6 - inertia_8);
    double inertia_23 = sin * inertia_22;
    double inertia_24 = inertia_6 - inertia_23;
    double inertia_25 = inertia_8 + inertia_23;
    double inertia_26 = cos * inertia_22 - inertia_7;
    double inertia_27 = cos * (inertia_10 + inertia_12) + sin * (inertia_9 - inertia_13);
    double inertia_28 = sin * inertia_27;
    double inertia_29 = cos * inertia_27;
    double inertia_30 = inertia_11 * cos - inertia_14 * sin;
    double inertia_31 = inertia_11 * sin + inertia_14 * cos;
    double inertia_32 = inertia_9 - inertia_28;
    double inertia_33 = inertia_13 + inertia_28;
    double inertia_34 = inertia_29 - inertia_12;
    double inertia_35 = inertia_29 - inertia_10;
    double inertia_36 = inertia_16 * inertia_21 + sin * (inertia_15 - inertia_18);
    double inertia_37 = sin * inertia_36;
    double inertia_38 = inertia_17 * cos - inertia_19 * sin;
    double inertia_39 = inertia_17 * sin + inertia_19 * cos;
    double inertia_40 = inertia_15 - inertia_37;
    double inertia_41 = inertia_18 + inertia_37;
    double inertia_42 = cos * inertia_36 - inertia_16;
    double inertia_43 = E_xx * inertia_24 + E_xy * inertia_26;
    double inertia_44 = E_xx * inertia_26 + E_xy * inertia_25;
    double inertia_45 = E_yx * inertia_24 + E_yy * inertia_26;
    double inertia_46 = E_yx * inertia_26 + E_yy * inertia_25;
    double inertia_47 = E_xx * inertia_32 + E_xy * inertia_35;
    double inertia_48 = E_xx * inertia_34 + E_xy * inertia_33;
    double inertia_49 = E_xx * inertia_30 + E_xy * inertia_31;
    double inertia_50 = E_yx * inertia_32 + E_yy * inertia_35;
    double inertia_51 = E_yx * inertia_34 + E_yy * inertia_33;
    double inertia_52 = E_yx * inertia_30 + E_yy * inertia_31;
    double inertia_53 = E_zx * inertia_32 + E_zy * inertia_35;
    double inertia_54 = E_zx * inertia_34 + E_zy * inertia_33;
    double inertia_55 = E_zx * inertia_30 + E_zy * inertia_31;
    double inertia_56 = E_xx * inertia_47 + E_xy * inertia_48 + E_xz * inertia_49;
    double inertia_57 = E_yx * inertia_47 + E_yy * inertia_48 + E_yz * inertia_49;
    double inertia_58 = E_zx * inertia_47 + E_zy * inertia_48 + E_zz * inertia_49;
    double inertia_59 = E_xx * inertia_50 + E_xy * inertia_51 + E_xz * inertia_52;
    double inertia_60 = E_yx * inertia_50 + E_yy * inertia_51 + E_yz * inertia_52;
    double inertia_61 = E_zx * inertia_50 + E_zy * inertia_51 + E_zz * inertia_52;
    double inertia_62 = E_xx * inertia_53 + E_xy * inertia_54 + E_xz * inertia_55;
    double inertia_63 = E_yx * inertia_53 + E_yy * inertia_54 + E_yz * inertia_55;
    double inertia_64 = E_zx * inertia_53 + E_zy * inertia_54 + E_zz * inertia_55;
    double inertia_65 = E_xx * inertia_40 + E_xy * inertia_42 + E_xz * inertia_38;
    double inertia_66 = E_xx * inertia_42 + E_xy * inertia_41 + E_xz * inertia_39;
    double inertia_67 = E_xx * inertia_38 + E_xy * inertia_39 + E_xz * inertia_20;
    double inertia_68 = E_yx * inertia_40 + E_yy * inertia_42 + E_yz * inertia_38;
    double inertia_69 = E_yx * inertia_42 + E_yy * inertia_41 + E_yz * inertia_39;
    double inertia_70 = E_yx * inertia_38 + E_yy * inertia_39 + E_yz * inertia_20;
    double inertia_71 = E_xx * inertia_65 + E_xy * inertia_66 + E_xz * inertia_67;
    double inertia_72 = E_yx * inertia_65 + E_yy * inertia_66 + E_yz * inertia_67;
    double inertia_73 = E_zx * inertia_65 + E_zy * inertia_66 + E_zz * inertia_67;
    double inertia_74 = E_yx * inertia_68 + E_yy * inertia_69 + E_yz * inertia_70;
    double inertia_75 = E_zx * inertia_68 + E_zy * inertia_69 + E_zz * inertia_70;
    double inertia_76 = E_zx * (E_zx * inertia_40 + E_zy * inertia_42 + E_zz * inertia_38)
        + E_zy * (E_zx * inertia_42 + E_zy * inertia_41 + E_zz * inertia_39)
        + E_zz * (E_zx * inertia_38 + E_zy * inertia_39 + E_zz * inertia_20);
    double inertia_77 = r_z * inertia_72;
    double inertia_78 = r_y * inertia_73;
    double inertia_79 = r_x * inertia_75;
    double inertia_80 = inertia_78 - inertia_77 + inertia_56;
    double inertia_81 = r_y * inertia_75 - r_z * inertia_74 + inertia_57;
    double inertia_82 = r_y * inertia_76 - r_z * inertia_75 + inertia_58;
    double inertia_83 = r_z * inertia_71 - r_x * inertia_73 + inertia_59;
    double inertia_84 = inertia_77 - inertia_79 + inertia_60;
    double inertia_85 = r_z * inertia_73 - r_x * inertia_76 + inertia_61;
    double inertia_86 = r_x * inertia_72 - r_y * inertia_71 + inertia_62;
    double inertia_87 = r_x * inertia_74 - r_y * inertia_72 + inertia_63;
    double inertia_88 = inertia_79 - inertia_78 + inertia_64;
    double inertia_89 = E_zx * (E_zx * inertia_24 + E_zy * inertia_26) + E_zy * (E_zx * inertia_26
        + E_zy * inertia_25) + (r_x * (inertia_63 + inertia_87) - r_y * (inertia_62 + inertia_86));
    double inertia_90 = inertia_1 * cos - inertia_2 * sin;
    double inertia_91 = inertia_1 * sin + inertia_2 * cos;
    double inertia_92 = inertia_3 * cos - inertia_4 * sin;
    double inertia_93 = inertia_3 * sin + inertia_4 * cos;
    double inertia_94 = E_xx * inertia_92 + E_xy * inertia_93 + E_xz * inertia_5;
    double inertia_95 = E_yx * inertia_92 + E_yy * inertia_93 + E_yz * inertia_5;
    double inertia_96 = E_zx * inertia_92 + E_zy * inertia_93 + E_zz * inertia_5;
    w[i + 80] = J_zz;
    w[i + 81] = u_over_D;
    w[i + 82] = kn_x;
    w[i + 83] = kn_y;
    w[i + 85] = kf_x;
    w[i + 86] = kf_y;
    w[i + 87] = kf_z;
    w[p + 59] = E_xx * inertia_43 + E_xy * inertia_44 + (r_y * (inertia_58 + inertia_82)
        - r_z * (inertia_57 + inertia_81)) + w[p + 59];
    w[p + 60] = E_yx * inertia_45 + E_yy * inertia_46 + (r_z * (inertia_59 + inertia_83)
        - r_x * (inertia_61 + inertia_85)) + w[p + 60];
    w[p + 61] = inertia_89 + w[p + 61];
    w[p + 62] = E_yx * inertia_43 + E_yy * inertia_44 + (r_y * inertia_85 - r_x * inertia_58
        + r_z * (inertia_56 - inertia_84)) + w[p + 62];
    w[p + 63] = E_zx * inertia_43 + E_zy * inertia_44 + (r_x * inertia_81 - r_z * inertia_63
        + r_y * (inertia_64 - inertia_80)) + w[p + 63];
    w[p + 64] = E_zx * inertia_45 + E_zy * inertia_46 + (r_z * inertia_86 - r_y * inertia_59
        + r_x * (inertia_60 - inertia_88)) + w[p + 64];
    w[p + 65] = inertia_80 + w[p + 65];
    w[p + 66] = inertia_81 + w[p + 66];
    w[p + 67] = inertia_82 + w[p + 67];
    w[p + 68] = inertia_83 + w[p + 68];
    w[p + 69] = inertia_84 + w[p + 69];
    w[p + 70] = inertia_85 + w[p + 70];
    w[p + 71] = inertia_86 + w[p + 71];
    w[p + 72] = inertia_87 + w[p + 72];
    w[p + 73] = inertia_88 + w[p + 73];
    w[p + 74] = inertia_71 + w[p + 74];
    w[p + 75] = inertia_74 + w[p + 75];
    w[p + 76] = inertia_76 + w[p + 76];
    w[p + 77] = inertia_72 + w[p + 77];
    w[p + 78] = inertia_73 + w[p + 78];
    w[p + 79] = inertia_75 + w[p + 79];
    w[p + 47] = E_xx * inertia_90 + E_xy * inertia_91 + E_xz * tau + (r_y * inertia_96
        - r_z * inertia_95) + w[p + 47];
    w[p + 50] = inertia_94 + w[p + 50];
    w[p + 48] = E_yx * inertia_90 + E_yy * inertia_91 + E_yz * tau + (r_z * inertia_94
        - r_x * inertia_96) + w[p + 48];
    w[p + 51] = inertia_95 + w[p + 51];
    w[p + 49] = E_zx * inertia_90 + E_zy * inertia_91 + E_zz * tau + (r_x * inertia_95
        - r_y * inertia_94) + w[p + 49];
    w[p + 52] = inertia_96 + w[p + 52];
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
    double J_zz = w[i + 28] + w[i + 61];
    double one_over_D = 1.0 / J_zz;
    w[i + 80] = J_zz;
    w[i + 81] = (w[i + 37] - w[i + 49]) / J_zz;
    w[i + 82] = (w[i + 30] + w[i + 63]) * one_over_D;
    w[i + 83] = (w[i + 31] + w[i + 64]) * one_over_D;
    w[i + 85] = (w[i + 71] - w[i + 24]) * one_over_D;
    w[i + 86] = (w[i + 23] + w[i + 72]) * one_over_D;
    w[i + 87] = w[i + 73] * one_over_D;
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
    double cos = w[i + 33];
    double sin = w[i + 34];
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
    double pass_1 = 2.0 * cos;
    double pass_2 = J_xy * pass_1 + sin * (J_xx - J_yy);
    double pass_3 = sin * pass_2;
    double pass_4 = J_xz * cos - J_yz * sin;
    double pass_5 = J_xz * sin + J_yz * cos;
    double pass_6 = J_xx - pass_3;
    double pass_7 = J_yy + pass_3;
    double pass_8 = cos * pass_2 - J_xy;
    double pass_9 = cos * (H_xy + H_yx) + sin * (H_xx - H_yy);
    double pass_10 = sin * pass_9;
    double pass_11 = cos * pass_9;
    double pass_12 = H_xz * cos - H_yz * sin;
    double pass_13 = H_xz * sin + H_yz * cos;
    double pass_14 = H_zx * cos - H_zy * sin;
    double pass_15 = H_zx * sin + H_zy * cos;
    double pass_16 = H_xx - pass_10;
    double pass_17 = H_yy + pass_10;
    double pass_18 = pass_11 - H_yx;
    double pass_19 = pass_11 - H_xy;
    double pass_20 = M_xy * pass_1 + sin * (M_xx - M_yy);
    double pass_21 = sin * pass_20;
    double pass_22 = M_xz * cos - M_yz * sin;
    double pass_23 = M_xz * sin + M_yz * cos;
    double pass_24 = M_xx - pass_21;
    double pass_25 = M_yy + pass_21;
    double pass_26 = cos * pass_20 - M_xy;
    double pass_27 = E_xx * pass_6 + E_xy * pass_8 + E_xz * pass_4;
    double pass_28 = E_xx * pass_8 + E_xy * pass_7 + E_xz * pass_5;
    double pass_29 = E_xx * pass_4 + E_xy * pass_5 + E_xz * J_zz;
    double pass_30 = E_yx * pass_6 + E_yy * pass_8 + E_yz * pass_4;
    double pass_31 = E_yx * pass_8 + E_yy * pass_7 + E_yz * pass_5;
    double pass_32 = E_yx * pass_4 + E_yy * pass_5 + E_yz * J_zz;
    double pass_33 = E_zx * (E_zx * pass_6 + E_zy * pass_8 + E_zz * pass_4) + E_zy * (E_zx * pass_8
        + E_zy * pass_7 + E_zz * pass_5) + E_zz * (E_zx * pass_4 + E_zy * pass_5 + E_zz * J_zz);
    double pass_34 = E_xx * pass_16 + E_xy * pass_19 + E_xz * pass_14;
    double pass_35 = E_xx * pass_18 + E_xy * pass_17 + E_xz * pass_15;
    double pass_36 = E_xx * pass_12 + E_xy * pass_13 + E_xz * H_zz;
    double pass_37 = E_yx * pass_16 + E_yy * pass_19 + E_yz * pass_14;
    double pass_38 = E_yx * pass_18 + E_yy * pass_17 + E_yz * pass_15;
    double pass_39 = E_yx * pass_12 + E_yy * pass_13 + E_yz * H_zz;
    double pass_40 = E_zx * pass_16 + E_zy * pass_19 + E_zz * pass_14;
    double pass_41 = E_zx * pass_18 + E_zy * pass_17 + E_zz * pass_15;
    double pass_42 = E_zx * pass_12 + E_zy * pass_13 + E_zz * H_zz;
    double pass_43 = E_xx * pass_34 + E_xy * pass_35 + E_xz * pass_36;
    double pass_44 = E_yx * pass_34 + E_yy * pass_35 + E_yz * pass_36;
    double pass_45 = E_zx * pass_34 + E_zy * pass_35 + E_zz * pass_36;
    double pass_46 = E_xx * pass_37 + E_xy * pass_38 + E_xz * pass_39;
    double pass_47 = E_yx * pass_37 + E_yy * pass_38 + E_yz * pass_39;
    double pass_48 = E_zx * pass_37 + E_zy * pass_38 + E_zz * pass_39;
    double pass_49 = E_xx * pass_40 + E_xy * pass_41 + E_xz * pass_42;
    double pass_50 = E_yx * pass_40 + E_yy * pass_41 + E_yz * pass_42;
    double pass_51 = E_zx * pass_40 + E_zy * pass_41 + E_zz * pass_42;
    double pass_52 = E_xx * pass_24 + E_xy * pass_26 + E_xz * pass_22;
    double pass_53 = E_xx * pass_26 + E_xy * pass_25 + E_xz * pass_23;
    double pass_54 = E_xx * pass_22 + E_xy * pass_23 + E_xz * M_zz;
    double pass_55 = E_yx * pass_24 + E_yy * pass_26 + E_yz * pass_22;
    double pass_56 = E_yx * pass_26 + E_yy * pass_25 + E_yz * pass_23;
    double pass_57 = E_yx * pass_22 + E_yy * pass_23 + E_yz * M_zz;
    double pass_58 = E_xx * pass_52 + E_xy * pass_53 + E_xz * pass_54;
    double pass_59 = E_yx * pass_52 + E_yy * pass_53 + E_yz * pass_54;
    double pass_60 = E_zx * pass_52 + E_zy * pass_53 + E_zz * pass_54;
    double pass_61 = E_yx * pass_55 + E_yy * pass_56 + E_yz * pass_57;
    double pass_62 = E_zx * pass_55 + E_zy * pass_56 + E_zz * pass_57;
    double pass_63 = E_zx * (E_zx * pass_24 + E_zy * pass_26 + E_zz * pass_22)
        + E_zy * (E_zx * pass_26 + E_zy * pass_25 + E_zz * pass_23) + E_zz * (E_zx * pass_22
        + E_zy * pass_23 + E_zz * M_zz);
    double pass_64 = r_z * pass_59;
    double pass_65 = r_y * pass_60;
    double pass_66 = r_x * pass_62;
    double pass_67 = pass_65 - pass_64 + pass_43;
    double pass_68 = r_y * pass_62 - r_z * pass_61 + pass_44;
    double pass_69 = r_y * pass_63 - r_z * pass_62 + pass_45;
    double pass_70 = r_z * pass_58 - r_x * pass_60 + pass_46;
    double pass_71 = pass_64 - pass_66 + pass_47;
    double pass_72 = r_z * pass_60 - r_x * pass_63 + pass_48;
    double pass_73 = r_x * pass_59 - r_y * pass_58 + pass_49;
    double pass_74 = r_x * pass_61 - r_y * pass_59 + pass_50;
    double pass_75 = pass_66 - pass_65 + pass_51;
    double pass_76 = n_x * cos - n_y * sin;
    double pass_77 = n_x * sin + n_y * cos;
    double pass_78 = f_x * cos - f_y * sin;
    double pass_79 = f_x * sin + f_y * cos;
    double pass_80 = E_xx * pass_78 + E_xy * pass_79 + E_xz * f_z;
    double pass_81 = E_yx * pass_78 + E_yy * pass_79 + E_yz * f_z;
    double pass_82 = E_zx * pass_78 + E_zy * pass_79 + E_zz * f_z;
    w[p + 59] = E_xx * pass_27 + E_xy * pass_28 + E_xz * pass_29 + (r_y * (pass_45 + pass_69)
        - r_z * (pass_44 + pass_68)) + w[p + 59];
    w[p + 60] = E_yx * pass_30 + E_yy * pass_31 + E_yz * pass_32 + (r_z * (pass_46 + pass_70)
        - r_x * (pass_48 + pass_72)) + w[p + 60];
    w[p + 61] = r_x * (pass_50 + pass_74) - r_y * (pass_49 + pass_73) + pass_33 + w[p + 61];
    w[p + 62] = E_yx * pass_27 + E_yy * pass_28 + E_yz * pass_29 + (r_y * pass_72 - r_x * pass_45
        + r_z * (pass_43 - pass_71)) + w[p + 62];
    w[p + 63] = E_zx * pass_27 + E_zy * pass_28 + E_zz * pass_29 + (r_x * pass_68 - r_z * pass_50
        + r_y * (pass_51 - pass_67)) + w[p + 63];
    w[p + 64] = E_zx * pass_30 + E_zy * pass_31 + E_zz * pass_32 + (r_z * pass_73 - r_y * pass_46
        + r_x * (pass_47 - pass_75)) + w[p + 64];
    w[p + 65] = pass_67 + w[p + 65];
    w[p + 66] = pass_68 + w[p + 66];
    w[p + 67] = pass_69 + w[p + 67];
    w[p + 68] = pass_70 + w[p + 68];
    w[p + 69] = pass_71 + w[p + 69];
    w[p + 70] = pass_72 + w[p + 70];
    w[p + 71] = pass_73 + w[p + 71];
    w[p + 72] = pass_74 + w[p + 72];
    w[p + 73] = pass_75 + w[p + 73];
    w[p + 74] = pass_58 + w[p + 74];
    w[p + 75] = pass_61 + w[p + 75];
    w[p + 76] = pass_63 + w[p + 76];
    w[p + 77] = pass_59 + w[p + 77];
    w[p + 78] = pass_60 + w[p + 78];
    w[p + 79] = pass_62 + w[p + 79];
    w[p + 47] = E_xx * pass_76 + E_xy * pass_77 + E_xz * n_z + (r_y * pass_82 - r_z * pass_81)
        + w[p + 47];
    w[p + 50] = pass_80 + w[p + 50];
    w[p + 48] = E_yx * pass_76 + E_yy * pass_77 + E_yz * n_z + (r_z * pass_80 - r_x * pass_82)
        + w[p + 48];
    w[p + 51] = pass_81 + w[p + 51];
    w[p + 49] = E_zx * pass_76 + E_zy * pass_77 + E_zz * n_z + (r_x * pass_81 - r_y * pass_80)
        + w[p + 49];
    w[p + 52] = pass_82 + w[p + 52];
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
    double cos = w[i + 33];
    double sin = w[i + 34];
    double acceleration_1 = r_z * above_89 - r_y * above_90 + w[p + 91];
    double acceleration_2 = r_x * above_90 - r_z * above_88 + w[p + 92];
    double acceleration_3 = r_y * above_88 - r_x * above_89 + w[p + 93];
    double acceleration_4 = E_xx * above_88 + E_yx * above_89 + E_zx * above_90;
    double acceleration_5 = E_xy * above_88 + E_yy * above_89 + E_zy * above_90;
    double acceleration_6 = E_xz * above_88 + E_yz * above_89 + E_zz * above_90;
    double acceleration_7 = E_xx * acceleration_1 + E_yx * acceleration_2 + E_zx * acceleration_3;
    double acceleration_8 = E_xy * acceleration_1 + E_yy * acceleration_2 + E_zy * acceleration_3;
    double da_z = E_xz * acceleration_1 + E_yz * acceleration_2 + E_zz * acceleration_3;
    double dalpha_x = acceleration_4 * cos + acceleration_5 * sin;
    double dalpha_y = acceleration_5 * cos - acceleration_4 * sin;
    double da_x = acceleration_7 * cos + acceleration_8 * sin;
    double da_y = acceleration_8 * cos - acceleration_7 * sin;
    double acceleration_9 = w[i + 81] - (dalpha_x * w[i + 82] + dalpha_y * w[i + 83]
        + acceleration_6 + (da_x * w[i + 85] + da_y * w[i + 86] + da_z * w[i + 87]));
    w[i + 88] = dalpha_x;
    w[i + 89] = dalpha_y;
    w[i + 90] = acceleration_6 + acceleration_9;
    w[i + 91] = da_x;
    w[i + 92] = da_y;
    w[i + 93] = da_z;
    w[i + 94] = acceleration_9;
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
    double cos = w[i + 33];
    double sin = w[i + 34];
    double carry_1 = r_z * above_89 - r_y * above_90 + w[p + 91];
    double carry_2 = r_x * above_90 - r_z * above_88 + w[p + 92];
    double carry_3 = r_y * above_88 - r_x * above_89 + w[p + 93];
    double carry_4 = E_xx * above_88 + E_yx * above_89 + E_zx * above_90;
    double carry_5 = E_xy * above_88 + E_yy * above_89 + E_zy * above_90;
    double carry_6 = E_xx * carry_1 + E_yx * carry_2 + E_zx * carry_3;
    double carry_7 = E_xy * carry_1 + E_yy * carry_2 + E_zy * carry_3;
    w[i + 88] = carry_4 * cos + carry_5 * sin;
    w[i + 89] = carry_5 * cos - carry_4 * sin;
    w[i + 90] = E_xz * above_88 + E_yz * above_89 + E_zz * above_90;
    w[i + 91] = carry_6 * cos + carry_7 * sin;
    w[i + 92] = carry_7 * cos - carry_6 * sin;
    w[i + 93] = E_xz * carry_1 + E_yz * carry_2 + E_zz * carry_3;
  }

  @Override
  public void driving(double[] w, int i, int p) {
    // U.A + p.z - tau of each degree of freedom.
    double driving_1 = (w[i + 30] + w[i + 63]) * w[i + 88] + (w[i + 31] + w[i + 64]) * w[i + 89]
        + (w[i + 28] + w[i + 61]) * w[i + 90] + ((w[i + 71] - w[i + 24]) * w[i + 91] + (w[i + 23]
        + w[i + 72]) * w[i + 92] + w[i + 73] * w[i + 93]);
    w[i + 94] = w[i + 49] + driving_1 - w[i + 37];
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
    double cos = w[i + 33];
    double sin = w[i + 34];
    double force_1 = n_x * cos - n_y * sin;
    double force_2 = n_x * sin + n_y * cos;
    double force_3 = f_x * cos - f_y * sin;
    double force_4 = f_x * sin + f_y * cos;
    double force_5 = E_xx * force_3 + E_xy * force_4 + E_xz * f_z;
    double force_6 = E_yx * force_3 + E_yy * force_4 + E_yz * f_z;
    double force_7 = E_zx * force_3 + E_zy * force_4 + E_zz * f_z;
    w[i + 94] = n_z - w[i + 37];
    w[p + 47] = E_xx * force_1 + E_xy * force_2 + E_xz * n_z + (r_y * force_7 - r_z * force_6)
        + w[p + 47];
    w[p + 50] = force_5 + w[p + 50];
    w[p + 48] = E_yx * force_1 + E_yy * force_2 + E_yz * n_z + (r_z * force_5 - r_x * force_7)
        + w[p + 48];
    w[p + 51] = force_6 + w[p + 51];
    w[p + 49] = E_zx * force_1 + E_zy * force_2 + E_zz * n_z + (r_x * force_6 - r_y * force_5)
        + w[p + 49];
    w[p + 52] = force_7 + w[p + 52];
  }

  @Override
  public void forceOnRoot(double[] w, int i, int p) {
    // p.z - tau of each degree of freedom.
    w[i + 94] = w[i + 49] - w[i + 37];
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
    double cos = w[i + 33];
    double sin = w[i + 34];
    double push_1 = tau - w[i + 49];
    double push_2 = w[i + 47] + w[i + 82] * push_1;
    double push_3 = w[i + 48] + w[i + 83] * push_1;
    double push_4 = w[i + 50] + w[i + 85] * push_1;
    double push_5 = w[i + 51] + w[i + 86] * push_1;
    double push_6 = w[i + 52] + w[i + 87] * push_1;
    double push_7 = push_2 * cos - push_3 * sin;
    double push_8 = push_2 * sin + push_3 * cos;
    double push_9 = push_4 * cos - push_5 * sin;
    double push_10 = push_4 * sin + push_5 * cos;
    double push_11 = E_xx * push_9 + E_xy * push_10 + E_xz * push_6;
    double push_12 = E_yx * push_9 + E_yy * push_10 + E_yz * push_6;
    double push_13 = E_zx * push_9 + E_zy * push_10 + E_zz * push_6;
    w[i + 81] = push_1 / w[i + 80];
    w[p + 47] = E_xx * push_7 + E_xy * push_8 + E_xz * tau + (r_y * push_13 - r_z * push_12)
        + w[p + 47];
    w[p + 50] = push_11 + w[p + 50];
    w[p + 48] = E_yx * push_7 + E_yy * push_8 + E_yz * tau + (r_z * push_11 - r_x * push_13)
        + w[p + 48];
    w[p + 51] = push_12 + w[p + 51];
    w[p + 49] = E_zx * push_7 + E_zy * push_8 + E_zz * tau + (r_x * push_12 - r_y * push_11)
        + w[p + 49];
    w[p + 52] = push_13 + w[p + 52];
  }

  @Override
  public void pushOnRoot(double[] w, int i, int p) {
    // u / D of each degree of freedom, with its D and U / D.
    w[i + 81] = (w[i + 37] - w[i + 49]) / w[i + 80];
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
    double cos = w[i + 33];
    double sin = w[i + 34];
    double couple_1 = w[p + 2] + above_6;
    double couple_2 = w[p + 0] - w[i + 82] * couple_1;
    double couple_3 = w[p + 1] - w[i + 83] * couple_1;
    double couple_4 = w[p + 3] - w[i + 85] * couple_1;
    double couple_5 = w[p + 4] - w[i + 86] * couple_1;
    double couple_6 = w[p + 5] - w[i + 87] * couple_1;
    double couple_7 = couple_2 * cos - couple_3 * sin;
    double couple_8 = couple_2 * sin + couple_3 * cos;
    double couple_9 = couple_4 * cos - couple_5 * sin;
    double couple_10 = couple_4 * sin + couple_5 * cos;
    double couple_11 = E_xx * couple_9 + E_xy * couple_10 + E_xz * couple_6;
    double couple_12 = E_yx * couple_9 + E_yy * couple_10 + E_yz * couple_6;
    double couple_13 = E_zx * couple_9 + E_zy * couple_10 + E_zz * couple_6;
    w[p + 6] = couple_1;
    w[p + 9] = E_xx * couple_7 + E_xy * couple_8 - E_xz * above_6 + (r_y * couple_13
        - r_z * couple_12);
    w[p + 10] = E_yx * couple_7 + E_yy * couple_8 - E_yz * above_6 + (r_z * couple_11
        - r_x * couple_13);
    w[p + 11] = E_zx * couple_7 + E_zy * couple_8 - E_zz * above_6 + (r_x * couple_12
        - r_y * couple_11);
    w[p + 12] = couple_11;
    w[p + 13] = couple_12;
    w[p + 14] = couple_13;
  }

  @Override
  public void coupleOnRoot(double[] w, int i, int p) {
    // kappa + K.z of each degree of freedom.
    w[p + 6] = w[p + 2] + w[p + 6];
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
    double cos = w[i + 33];
    double sin = w[i + 34];
    double transfer_1 = Kn_x * cos - Kn_y * sin;
    double transfer_2 = Kn_x * sin + Kn_y * cos;
    double transfer_3 = Kf_x * cos - Kf_y * sin;
    double transfer_4 = Kf_x * sin + Kf_y * cos;
    double transfer_5 = E_xx * transfer_3 + E_xy * transfer_4 + E_xz * Kf_z;
    double transfer_6 = E_yx * transfer_3 + E_yy * transfer_4 + E_yz * Kf_z;
    double transfer_7 = E_zx * transfer_3 + E_zy * transfer_4 + E_zz * Kf_z;
    w[p + 9] = E_xx * transfer_1 + E_xy * transfer_2 + E_xz * Kn_z + (r_y * transfer_7
        - r_z * transfer_6);
    w[p + 10] = E_yx * transfer_1 + E_yy * transfer_2 + E_yz * Kn_z + (r_z * transfer_5
        - r_x * transfer_7);
    w[p + 11] = E_zx * transfer_1 + E_zy * transfer_2 + E_zz * Kn_z + (r_x * transfer_6
        - r_y * transfer_5);
    w[p + 12] = transfer_5;
    w[p + 13] = transfer_6;
    w[p + 14] = transfer_7;
  }
}
