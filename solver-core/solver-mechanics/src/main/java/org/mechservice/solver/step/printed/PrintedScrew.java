package org.mechservice.solver.step.printed;

import org.mechservice.solver.step.StepKernel;

/**
 * Printed from its equations; do not edit. PrintedStepsTest compares it with them and
 * prints it anew with -Dgolden.write=true.
 */
final class PrintedScrew implements StepKernel {

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
    double link__12 = w[i + 12];
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
    double v = w[i + 35];
    double link__36 = w[i + 36];
    double cos = w[i + 33];
    double sin = w[i + 34];
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
    double motion_15 = link__12 * v * 2.0;
    double motion_16 = link__12 * w[i + 32];
    double motion_17 = E_xx * motion_7 + E_yx * motion_8 + E_zx * motion_9 + (motion_14
        + motion_10 * motion_12) * motion_16 + motion_11 * motion_15;
    double motion_18 = E_xy * motion_7 + E_yy * motion_8 + E_zy * motion_9 + (motion_11 * motion_12
        - motion_13) * motion_16 - motion_10 * motion_15;
    double a_z = E_xz * motion_7 + E_yz * motion_8 + E_zz * motion_9 - (motion_10 * motion_10
        + motion_11 * motion_11) * motion_16 + link__12 * link__36;
    double omega_x = motion_10 * cos + motion_11 * sin;
    double omega_y = motion_11 * cos - motion_10 * sin;
    double alpha_x = motion_13 * cos + motion_14 * sin + v * omega_y;
    double alpha_y = motion_14 * cos - motion_13 * sin - v * omega_x;
    double omega_z = motion_12 + v;
    double alpha_z = E_xz * alpha_p_x + E_yz * alpha_p_y + E_zz * alpha_p_z + link__36;
    double a_x = motion_17 * cos + motion_18 * sin;
    double a_y = motion_18 * cos - motion_17 * sin;
    double motion_19 = omega_x * omega_x;
    double motion_20 = omega_y * omega_y;
    double motion_21 = omega_z * omega_z;
    double motion_22 = omega_x * omega_y;
    double motion_23 = omega_x * omega_z;
    double motion_24 = omega_y * omega_z;
    double W_xy = motion_22 - alpha_z;
    double W_xz = alpha_y + motion_23;
    double W_yx = alpha_z + motion_22;
    double W_yz = motion_24 - alpha_x;
    double W_zx = motion_23 - alpha_y;
    double W_zy = alpha_x + motion_24;
    double motion_25 = m * (c_y * W_xy - c_x * (motion_20 + motion_21) + c_z * W_xz + a_x);
    double motion_26 = m * (c_x * W_yx - c_y * (motion_19 + motion_21) + c_z * W_yz + a_y);
    double motion_27 = m * (c_x * W_zx + c_y * W_zy - c_z * (motion_19 + motion_20) + a_z);
    double motion_28 = I_xx * alpha_x + motion_24 * (I_zz - I_yy) + I_xz * W_yx - I_xy * W_zx
        + I_yz * (motion_20 - motion_21) + (c_y * motion_27 - c_z * motion_26);
    double motion_29 = I_yy * alpha_y + motion_23 * (I_xx - I_zz) + I_xy * W_zy - I_yz * W_xy
        + I_xz * (motion_21 - motion_19) + (c_z * motion_25 - c_x * motion_27);
    double motion_30 = I_zz * alpha_z + motion_22 * (I_yy - I_xx) + I_yz * W_xz - I_xz * W_yz
        + I_xy * (motion_19 - motion_20) + (c_x * motion_26 - c_y * motion_25);
    w[i + 38] = omega_x;
    w[i + 39] = omega_y;
    w[i + 40] = omega_z;
    w[i + 41] = alpha_x;
    w[i + 42] = alpha_y;
    w[i + 43] = alpha_z;
    w[i + 44] = a_x;
    w[i + 45] = a_y;
    w[i + 46] = a_z;
    w[i + 47] = motion_28 - w[i + 53];
    w[i + 48] = motion_29 - w[i + 54];
    w[i + 49] = motion_30 - w[i + 55];
    w[i + 50] = motion_25 - w[i + 56];
    w[i + 51] = motion_26 - w[i + 57];
    w[i + 52] = motion_27 - w[i + 58];
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
    double link__12 = w[i + 12];
    double m = w[i + 13];
    double link__23 = w[i + 23];
    double link__24 = w[i + 24];
    double link__25 = w[i + 25];
    double H_zz = w[i + 73];
    double M_xz = w[i + 78];
    double M_yz = w[i + 79];
    double n_z = w[i + 49];
    double f_z = w[i + 52];
    double cos = w[i + 33];
    double sin = w[i + 34];
    double J_xz = w[i + 30] + w[i + 63];
    double J_yz = w[i + 31] + w[i + 64];
    double J_zz = w[i + 28] + w[i + 61];
    double H_xz = link__24 + w[i + 67];
    double H_yz = w[i + 70] - link__23;
    double H_zx = w[i + 71] - link__24;
    double H_zy = link__23 + w[i + 72];
    double M_zz = m + w[i + 76];
    double inertia_1 = J_xz + link__12 * H_xz;
    double inertia_2 = J_yz + link__12 * H_yz;
    double inertia_3 = J_zz + link__12 * H_zz;
    double inertia_4 = H_zx + link__12 * M_xz;
    double inertia_5 = H_zy + link__12 * M_yz;
    double inertia_6 = H_zz + link__12 * M_zz;
    double D = inertia_3 + link__12 * inertia_6;
    double one_over_D = 1.0 / D;
    double kn_x = inertia_1 * one_over_D;
    double kn_y = inertia_2 * one_over_D;
    double kn_z = inertia_3 * one_over_D;
    double kf_x = inertia_4 * one_over_D;
    double kf_y = inertia_5 * one_over_D;
    double kf_z = inertia_6 * one_over_D;
    double u_over_D = one_over_D * (w[i + 37] - (n_z + link__12 * f_z));
    double inertia_7 = w[i + 47] + inertia_1 * u_over_D;
    double inertia_8 = w[i + 48] + inertia_2 * u_over_D;
    double inertia_9 = n_z + inertia_3 * u_over_D;
    double inertia_10 = w[i + 50] + inertia_4 * u_over_D;
    double inertia_11 = w[i + 51] + inertia_5 * u_over_D;
    double inertia_12 = f_z + inertia_6 * u_over_D;
    double inertia_13 = w[i + 26] + w[i + 59] - inertia_1 * kn_x;
    double inertia_14 = w[i + 29] + w[i + 62] - inertia_2 * kn_x;
    double inertia_15 = J_xz - inertia_3 * kn_x;
    double inertia_16 = w[i + 27] + w[i + 60] - inertia_2 * kn_y;
    double inertia_17 = J_yz - inertia_3 * kn_y;
    double inertia_18 = J_zz - inertia_3 * kn_z;
    double inertia_19 = w[i + 65] - inertia_4 * kn_x;
    double inertia_20 = w[i + 66] - link__25 - inertia_5 * kn_x;
    double inertia_21 = H_xz - inertia_6 * kn_x;
    double inertia_22 = link__25 + w[i + 68] - inertia_4 * kn_y;
    double inertia_23 = w[i + 69] - inertia_5 * kn_y;
    double inertia_24 = H_yz - inertia_6 * kn_y;
    double inertia_25 = H_zx - inertia_4 * kn_z;
    double inertia_26 = H_zy - inertia_5 * kn_z;
    double inertia_27 = H_zz - inertia_6 * kn_z;
    double inertia_28 = m + w[i + 74] - inertia_4 * kf_x;
    double inertia_29 = w[i + 77] - inertia_5 * kf_x;
    double inertia_30 = M_xz - inertia_6 * kf_x;
    double inertia_31 = m + w[i + 75] - inertia_5 * kf_y;
    double inertia_32 = M_yz - inertia_6 * kf_y;
    double inertia_33 = M_zz - inertia_6 * kf_z;
    double inertia_34 = 2.0 * cos;
    double inertia_35 = inertia_14 * inertia_34 + sin * (inertia_13 - inertia_16);
    double inertia_36 = sin * inertia_35;
    double inertia_37 = cos * (inertia_20 + inertia_22) + sin * (inertia_19 - inertia_23);
    double inertia_38 = sin * inertia_37;
    double inertia_39 = cos * inertia_37;
    double inertia_40 = inertia_25 * cos - inertia_26 * sin;
    double inertia_41 = inertia_25 * sin + inertia_26 * cos;
    double inertia_42 = inertia_19 - inertia_38;
    double inertia_43 = inertia_39 - inertia_22;
    double inertia_44 = inertia_39 - inertia_20;
    double inertia_45 = inertia_29 * inertia_34 + sin * (inertia_28 - inertia_31);
    double inertia_46 = sin * inertia_45;
    double inertia_47 = inertia_30 * cos - inertia_32 * sin;
    double inertia_48 = inertia_30 * sin + inertia_32 * cos;
    double inertia_49 = inertia_28 - inertia_46;
    double inertia_50 = inertia_31 + inertia_46;
    double inertia_51 = cos * inertia_45 - inertia_29;
    double inertia_52 = link__12 * w[i + 32];
    double inertia_53 = inertia_51 * inertia_52;
    double inertia_54 = inertia_42 - inertia_53;
    double inertia_55 = inertia_43 - inertia_50 * inertia_52;
    double inertia_56 = inertia_21 * cos - inertia_24 * sin - inertia_48 * inertia_52;
    double inertia_57 = inertia_44 + inertia_49 * inertia_52;
    double inertia_58 = inertia_23 + inertia_38 + inertia_53;
    double inertia_59 = inertia_21 * sin + inertia_24 * cos + inertia_47 * inertia_52;
    double inertia_60 = inertia_13 - inertia_36 - inertia_52 * (inertia_43 + inertia_55);
    double inertia_61 = cos * inertia_35 - inertia_14 + inertia_52 * (inertia_42 - inertia_58);
    double inertia_62 = inertia_15 * cos - inertia_17 * sin - inertia_41 * inertia_52;
    double inertia_63 = inertia_16 + inertia_36 + inertia_52 * (inertia_44 + inertia_57);
    double inertia_64 = inertia_15 * sin + inertia_17 * cos + inertia_40 * inertia_52;
    double inertia_65 = E_xx * inertia_60 + E_xy * inertia_61 + E_xz * inertia_62;
    double inertia_66 = E_xx * inertia_61 + E_xy * inertia_63 + E_xz * inertia_64;
    double inertia_67 = E_xx * inertia_62 + E_xy * inertia_64 + E_xz * inertia_18;
    double inertia_68 = E_yx * inertia_60 + E_yy * inertia_61 + E_yz * inertia_62;
    double inertia_69 = E_yx * inertia_61 + E_yy * inertia_63 + E_yz * inertia_64;
    double inertia_70 = E_yx * inertia_62 + E_yy * inertia_64 + E_yz * inertia_18;
    double inertia_71 = E_zx * (E_zx * inertia_60 + E_zy * inertia_61 + E_zz * inertia_62)
        + E_zy * (E_zx * inertia_61 + E_zy * inertia_63 + E_zz * inertia_64)
        + E_zz * (E_zx * inertia_62 + E_zy * inertia_64 + E_zz * inertia_18);
    double inertia_72 = E_xx * inertia_54 + E_xy * inertia_57 + E_xz * inertia_40;
    double inertia_73 = E_xx * inertia_55 + E_xy * inertia_58 + E_xz * inertia_41;
    double inertia_74 = E_xx * inertia_56 + E_xy * inertia_59 + E_xz * inertia_27;
    double inertia_75 = E_yx * inertia_54 + E_yy * inertia_57 + E_yz * inertia_40;
    double inertia_76 = E_yx * inertia_55 + E_yy * inertia_58 + E_yz * inertia_41;
    double inertia_77 = E_yx * inertia_56 + E_yy * inertia_59 + E_yz * inertia_27;
    double inertia_78 = E_zx * inertia_54 + E_zy * inertia_57 + E_zz * inertia_40;
    double inertia_79 = E_zx * inertia_55 + E_zy * inertia_58 + E_zz * inertia_41;
    double inertia_80 = E_zx * inertia_56 + E_zy * inertia_59 + E_zz * inertia_27;
    double inertia_81 = E_xx * inertia_72 + E_xy * inertia_73 + E_xz * inertia_74;
    double inertia_82 = E_yx * inertia_72 + E_yy * inertia_73 + E_yz * inertia_74;
    double inertia_83 = E_zx * inertia_72 + E_zy * inertia_73 + E_zz * inertia_74;
    double inertia_84 = E_xx * inertia_75 + E_xy * inertia_76 + E_xz * inertia_77;
    double inertia_85 = E_yx * inertia_75 + E_yy * inertia_76 + E_yz * inertia_77;
    double inertia_86 = E_zx * inertia_75 + E_zy * inertia_76 + E_zz * inertia_77;
    double inertia_87 = E_xx * inertia_78 + E_xy * inertia_79 + E_xz * inertia_80;
    double inertia_88 = E_yx * inertia_78 + E_yy * inertia_79 + E_yz * inertia_80;
    double inertia_89 = E_zx * inertia_78 + E_zy * inertia_79 + E_zz * inertia_80;
    double inertia_90 = E_xx * inertia_49 + E_xy * inertia_51 + E_xz * inertia_47;
    double inertia_91 = E_xx * inertia_51 + E_xy * inertia_50 + E_xz * inertia_48;
    double inertia_92 = E_xx * inertia_47 + E_xy * inertia_48 + E_xz * inertia_33;
    double inertia_93 = E_yx * inertia_49 + E_yy * inertia_51 + E_yz * inertia_47;
    double inertia_94 = E_yx * inertia_51 + E_yy * inertia_50 + E_yz * inertia_48;
    double inertia_95 = E_yx * inertia_47 + E_yy * inertia_48 + E_yz * inertia_33;
    double inertia_96 = E_xx * inertia_90 + E_xy * inertia_91 + E_xz * inertia_92;
    double inertia_97 = E_yx * inertia_90 + E_yy * inertia_91 + E_yz * inertia_92;
    double inertia_98 = E_zx * inertia_90 + E_zy * inertia_91 + E_zz * inertia_92;
    double inertia_99 = E_yx * inertia_93 + E_yy * inertia_94 + E_yz * inertia_95;
    double inertia_100 = E_zx * inertia_93 + E_zy * inertia_94 + E_zz * inertia_95;
    double inertia_101 = E_zx * (E_zx * inertia_49 + E_zy * inertia_51 + E_zz * inertia_47)
        + E_zy * (E_zx * inertia_51 + E_zy * inertia_50 + E_zz * inertia_48)
        + E_zz * (E_zx * inertia_47 + E_zy * inertia_48 + E_zz * inertia_33);
    double inertia_102 = r_z * inertia_97;
    double inertia_103 = r_y * inertia_98;
    double inertia_104 = r_x * inertia_100;
    double inertia_105 = inertia_103 - inertia_102 + inertia_81;
    double inertia_106 = r_y * inertia_100 - r_z * inertia_99 + inertia_82;
    double inertia_107 = r_y * inertia_101 - r_z * inertia_100 + inertia_83;
    double inertia_108 = r_z * inertia_96 - r_x * inertia_98 + inertia_84;
    double inertia_109 = inertia_102 - inertia_104 + inertia_85;
    double inertia_110 = r_z * inertia_98 - r_x * inertia_101 + inertia_86;
    double inertia_111 = r_x * inertia_97 - r_y * inertia_96 + inertia_87;
    double inertia_112 = r_x * inertia_99 - r_y * inertia_97 + inertia_88;
    double inertia_113 = inertia_104 - inertia_103 + inertia_89;
    double inertia_114 = inertia_10 * cos - inertia_11 * sin;
    double inertia_115 = inertia_10 * sin + inertia_11 * cos;
    double inertia_116 = inertia_7 * cos - inertia_8 * sin - inertia_52 * inertia_115;
    double inertia_117 = inertia_7 * sin + inertia_8 * cos + inertia_52 * inertia_114;
    double inertia_118 = E_xx * inertia_114 + E_xy * inertia_115 + E_xz * inertia_12;
    double inertia_119 = E_yx * inertia_114 + E_yy * inertia_115 + E_yz * inertia_12;
    double inertia_120 = E_zx * inertia_114 + E_zy * inertia_115 + E_zz * inertia_12;
    w[i + 80] = D;
    w[i + 81] = u_over_D;
    w[i + 82] = kn_x;
    w[i + 83] = kn_y;
    w[i + 84] = kn_z;
    w[i + 85] = kf_x;
    w[i + 86] = kf_y;
    w[i + 87] = kf_z;
    w[p + 59] = E_xx * inertia_65 + E_xy * inertia_66 + E_xz * inertia_67 + (r_y * (inertia_83
        + inertia_107) - r_z * (inertia_82 + inertia_106)) + w[p + 59];
    w[p + 60] = E_yx * inertia_68 + E_yy * inertia_69 + E_yz * inertia_70 + (r_z * (inertia_84
        + inertia_108) - r_x * (inertia_86 + inertia_110)) + w[p + 60];
    w[p + 61] = r_x * (inertia_88 + inertia_112) - r_y * (inertia_87 + inertia_111) + inertia_71
        + w[p + 61];
    w[p + 62] = E_yx * inertia_65 + E_yy * inertia_66 + E_yz * inertia_67 + (r_y * inertia_110
        - r_x * inertia_83 + r_z * (inertia_81 - inertia_109)) + w[p + 62];
    w[p + 63] = E_zx * inertia_65 + E_zy * inertia_66 + E_zz * inertia_67 + (r_x * inertia_106
        - r_z * inertia_88 + r_y * (inertia_89 - inertia_105)) + w[p + 63];
    w[p + 64] = E_zx * inertia_68 + E_zy * inertia_69 + E_zz * inertia_70 + (r_z * inertia_111
        - r_y * inertia_84 + r_x * (inertia_85 - inertia_113)) + w[p + 64];
    w[p + 65] = inertia_105 + w[p + 65];
    w[p + 66] = inertia_106 + w[p + 66];
    w[p + 67] = inertia_107 + w[p + 67];
    w[p + 68] = inertia_108 + w[p + 68];
    w[p + 69] = inertia_109 + w[p + 69];
    w[p + 70] = inertia_110 + w[p + 70];
    w[p + 71] = inertia_111 + w[p + 71];
    w[p + 72] = inertia_112 + w[p + 72];
    w[p + 73] = inertia_113 + w[p + 73];
    w[p + 74] = inertia_96 + w[p + 74];
    w[p + 75] = inertia_99 + w[p + 75];
    w[p + 76] = inertia_101 + w[p + 76];
    w[p + 77] = inertia_97 + w[p + 77];
    w[p + 78] = inertia_98 + w[p + 78];
    w[p + 79] = inertia_100 + w[p + 79];
    w[p + 47] = E_xx * inertia_116 + E_xy * inertia_117 + E_xz * inertia_9 + (r_y * inertia_120
        - r_z * inertia_119) + w[p + 47];
    w[p + 50] = inertia_118 + w[p + 50];
    w[p + 48] = E_yx * inertia_116 + E_yy * inertia_117 + E_yz * inertia_9 + (r_z * inertia_118
        - r_x * inertia_120) + w[p + 48];
    w[p + 51] = inertia_119 + w[p + 51];
    w[p + 49] = E_zx * inertia_116 + E_zy * inertia_117 + E_zz * inertia_9 + (r_x * inertia_119
        - r_y * inertia_118) + w[p + 49];
    w[p + 52] = inertia_120 + w[p + 52];
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
    double link__12 = w[i + 12];
    double link__23 = w[i + 23];
    double link__24 = w[i + 24];
    double H_zz = w[i + 73];
    double inertiaOnRoot_1 = w[i + 28] + w[i + 61] + link__12 * H_zz;
    double inertiaOnRoot_2 = H_zz + link__12 * (w[i + 13] + w[i + 76]);
    double D = inertiaOnRoot_1 + link__12 * inertiaOnRoot_2;
    double one_over_D = 1.0 / D;
    w[i + 80] = D;
    w[i + 81] = (w[i + 37] - (w[i + 49] + link__12 * w[i + 52])) / D;
    w[i + 82] = (w[i + 30] + w[i + 63] + link__12 * (link__24 + w[i + 67])) * one_over_D;
    w[i + 83] = (w[i + 31] + w[i + 64] + link__12 * (w[i + 70] - link__23)) * one_over_D;
    w[i + 84] = inertiaOnRoot_1 * one_over_D;
    w[i + 85] = (w[i + 71] - link__24 + link__12 * w[i + 78]) * one_over_D;
    w[i + 86] = (link__23 + w[i + 72] + link__12 * w[i + 79]) * one_over_D;
    w[i + 87] = inertiaOnRoot_2 * one_over_D;
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
    double pass_4 = cos * (H_xy + H_yx) + sin * (H_xx - H_yy);
    double pass_5 = sin * pass_4;
    double pass_6 = cos * pass_4;
    double pass_7 = H_zx * cos - H_zy * sin;
    double pass_8 = H_zx * sin + H_zy * cos;
    double pass_9 = H_xx - pass_5;
    double pass_10 = pass_6 - H_yx;
    double pass_11 = pass_6 - H_xy;
    double pass_12 = M_xy * pass_1 + sin * (M_xx - M_yy);
    double pass_13 = sin * pass_12;
    double pass_14 = M_xz * cos - M_yz * sin;
    double pass_15 = M_xz * sin + M_yz * cos;
    double pass_16 = M_xx - pass_13;
    double pass_17 = M_yy + pass_13;
    double pass_18 = cos * pass_12 - M_xy;
    double pass_19 = w[i + 12] * w[i + 32];
    double pass_20 = pass_18 * pass_19;
    double pass_21 = pass_9 - pass_20;
    double pass_22 = pass_10 - pass_17 * pass_19;
    double pass_23 = H_xz * cos - H_yz * sin - pass_15 * pass_19;
    double pass_24 = pass_11 + pass_16 * pass_19;
    double pass_25 = H_yy + pass_5 + pass_20;
    double pass_26 = H_xz * sin + H_yz * cos + pass_14 * pass_19;
    double pass_27 = J_xx - pass_3 - pass_19 * (pass_10 + pass_22);
    double pass_28 = cos * pass_2 - J_xy + pass_19 * (pass_9 - pass_25);
    double pass_29 = J_xz * cos - J_yz * sin - pass_8 * pass_19;
    double pass_30 = J_yy + pass_3 + pass_19 * (pass_11 + pass_24);
    double pass_31 = J_xz * sin + J_yz * cos + pass_7 * pass_19;
    double pass_32 = E_xx * pass_27 + E_xy * pass_28 + E_xz * pass_29;
    double pass_33 = E_xx * pass_28 + E_xy * pass_30 + E_xz * pass_31;
    double pass_34 = E_xx * pass_29 + E_xy * pass_31 + E_xz * J_zz;
    double pass_35 = E_yx * pass_27 + E_yy * pass_28 + E_yz * pass_29;
    double pass_36 = E_yx * pass_28 + E_yy * pass_30 + E_yz * pass_31;
    double pass_37 = E_yx * pass_29 + E_yy * pass_31 + E_yz * J_zz;
    double pass_38 = E_zx * (E_zx * pass_27 + E_zy * pass_28 + E_zz * pass_29)
        + E_zy * (E_zx * pass_28 + E_zy * pass_30 + E_zz * pass_31) + E_zz * (E_zx * pass_29
        + E_zy * pass_31 + E_zz * J_zz);
    double pass_39 = E_xx * pass_21 + E_xy * pass_24 + E_xz * pass_7;
    double pass_40 = E_xx * pass_22 + E_xy * pass_25 + E_xz * pass_8;
    double pass_41 = E_xx * pass_23 + E_xy * pass_26 + E_xz * H_zz;
    double pass_42 = E_yx * pass_21 + E_yy * pass_24 + E_yz * pass_7;
    double pass_43 = E_yx * pass_22 + E_yy * pass_25 + E_yz * pass_8;
    double pass_44 = E_yx * pass_23 + E_yy * pass_26 + E_yz * H_zz;
    double pass_45 = E_zx * pass_21 + E_zy * pass_24 + E_zz * pass_7;
    double pass_46 = E_zx * pass_22 + E_zy * pass_25 + E_zz * pass_8;
    double pass_47 = E_zx * pass_23 + E_zy * pass_26 + E_zz * H_zz;
    double pass_48 = E_xx * pass_39 + E_xy * pass_40 + E_xz * pass_41;
    double pass_49 = E_yx * pass_39 + E_yy * pass_40 + E_yz * pass_41;
    double pass_50 = E_zx * pass_39 + E_zy * pass_40 + E_zz * pass_41;
    double pass_51 = E_xx * pass_42 + E_xy * pass_43 + E_xz * pass_44;
    double pass_52 = E_yx * pass_42 + E_yy * pass_43 + E_yz * pass_44;
    double pass_53 = E_zx * pass_42 + E_zy * pass_43 + E_zz * pass_44;
    double pass_54 = E_xx * pass_45 + E_xy * pass_46 + E_xz * pass_47;
    double pass_55 = E_yx * pass_45 + E_yy * pass_46 + E_yz * pass_47;
    double pass_56 = E_zx * pass_45 + E_zy * pass_46 + E_zz * pass_47;
    double pass_57 = E_xx * pass_16 + E_xy * pass_18 + E_xz * pass_14;
    double pass_58 = E_xx * pass_18 + E_xy * pass_17 + E_xz * pass_15;
    double pass_59 = E_xx * pass_14 + E_xy * pass_15 + E_xz * M_zz;
    double pass_60 = E_yx * pass_16 + E_yy * pass_18 + E_yz * pass_14;
    double pass_61 = E_yx * pass_18 + E_yy * pass_17 + E_yz * pass_15;
    double pass_62 = E_yx * pass_14 + E_yy * pass_15 + E_yz * M_zz;
    double pass_63 = E_xx * pass_57 + E_xy * pass_58 + E_xz * pass_59;
    double pass_64 = E_yx * pass_57 + E_yy * pass_58 + E_yz * pass_59;
    double pass_65 = E_zx * pass_57 + E_zy * pass_58 + E_zz * pass_59;
    double pass_66 = E_yx * pass_60 + E_yy * pass_61 + E_yz * pass_62;
    double pass_67 = E_zx * pass_60 + E_zy * pass_61 + E_zz * pass_62;
    double pass_68 = E_zx * (E_zx * pass_16 + E_zy * pass_18 + E_zz * pass_14)
        + E_zy * (E_zx * pass_18 + E_zy * pass_17 + E_zz * pass_15) + E_zz * (E_zx * pass_14
        + E_zy * pass_15 + E_zz * M_zz);
    double pass_69 = r_z * pass_64;
    double pass_70 = r_y * pass_65;
    double pass_71 = r_x * pass_67;
    double pass_72 = pass_70 - pass_69 + pass_48;
    double pass_73 = r_y * pass_67 - r_z * pass_66 + pass_49;
    double pass_74 = r_y * pass_68 - r_z * pass_67 + pass_50;
    double pass_75 = r_z * pass_63 - r_x * pass_65 + pass_51;
    double pass_76 = pass_69 - pass_71 + pass_52;
    double pass_77 = r_z * pass_65 - r_x * pass_68 + pass_53;
    double pass_78 = r_x * pass_64 - r_y * pass_63 + pass_54;
    double pass_79 = r_x * pass_66 - r_y * pass_64 + pass_55;
    double pass_80 = pass_71 - pass_70 + pass_56;
    double pass_81 = f_x * cos - f_y * sin;
    double pass_82 = f_x * sin + f_y * cos;
    double pass_83 = n_x * cos - n_y * sin - pass_19 * pass_82;
    double pass_84 = n_x * sin + n_y * cos + pass_19 * pass_81;
    double pass_85 = E_xx * pass_81 + E_xy * pass_82 + E_xz * f_z;
    double pass_86 = E_yx * pass_81 + E_yy * pass_82 + E_yz * f_z;
    double pass_87 = E_zx * pass_81 + E_zy * pass_82 + E_zz * f_z;
    w[p + 59] = E_xx * pass_32 + E_xy * pass_33 + E_xz * pass_34 + (r_y * (pass_50 + pass_74)
        - r_z * (pass_49 + pass_73)) + w[p + 59];
    w[p + 60] = E_yx * pass_35 + E_yy * pass_36 + E_yz * pass_37 + (r_z * (pass_51 + pass_75)
        - r_x * (pass_53 + pass_77)) + w[p + 60];
    w[p + 61] = r_x * (pass_55 + pass_79) - r_y * (pass_54 + pass_78) + pass_38 + w[p + 61];
    w[p + 62] = E_yx * pass_32 + E_yy * pass_33 + E_yz * pass_34 + (r_y * pass_77 - r_x * pass_50
        + r_z * (pass_48 - pass_76)) + w[p + 62];
    w[p + 63] = E_zx * pass_32 + E_zy * pass_33 + E_zz * pass_34 + (r_x * pass_73 - r_z * pass_55
        + r_y * (pass_56 - pass_72)) + w[p + 63];
    w[p + 64] = E_zx * pass_35 + E_zy * pass_36 + E_zz * pass_37 + (r_z * pass_78 - r_y * pass_51
        + r_x * (pass_52 - pass_80)) + w[p + 64];
    w[p + 65] = pass_72 + w[p + 65];
    w[p + 66] = pass_73 + w[p + 66];
    w[p + 67] = pass_74 + w[p + 67];
    w[p + 68] = pass_75 + w[p + 68];
    w[p + 69] = pass_76 + w[p + 69];
    w[p + 70] = pass_77 + w[p + 70];
    w[p + 71] = pass_78 + w[p + 71];
    w[p + 72] = pass_79 + w[p + 72];
    w[p + 73] = pass_80 + w[p + 73];
    w[p + 74] = pass_63 + w[p + 74];
    w[p + 75] = pass_66 + w[p + 75];
    w[p + 76] = pass_68 + w[p + 76];
    w[p + 77] = pass_64 + w[p + 77];
    w[p + 78] = pass_65 + w[p + 78];
    w[p + 79] = pass_67 + w[p + 79];
    w[p + 47] = E_xx * pass_83 + E_xy * pass_84 + E_xz * n_z + (r_y * pass_87 - r_z * pass_86)
        + w[p + 47];
    w[p + 50] = pass_85 + w[p + 50];
    w[p + 48] = E_yx * pass_83 + E_yy * pass_84 + E_yz * n_z + (r_z * pass_85 - r_x * pass_87)
        + w[p + 48];
    w[p + 51] = pass_86 + w[p + 51];
    w[p + 49] = E_zx * pass_83 + E_zy * pass_84 + E_zz * n_z + (r_x * pass_86 - r_y * pass_85)
        + w[p + 49];
    w[p + 52] = pass_87 + w[p + 52];
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
    double link__12 = w[i + 12];
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
    double acceleration_7 = E_xz * acceleration_1 + E_yz * acceleration_2 + E_zz * acceleration_3;
    double acceleration_8 = link__12 * w[i + 32];
    double acceleration_9 = E_xx * acceleration_1 + E_yx * acceleration_2 + E_zx * acceleration_3
        + acceleration_5 * acceleration_8;
    double acceleration_10 = E_xy * acceleration_1 + E_yy * acceleration_2 + E_zy * acceleration_3
        - acceleration_4 * acceleration_8;
    double dalpha_x = acceleration_4 * cos + acceleration_5 * sin;
    double dalpha_y = acceleration_5 * cos - acceleration_4 * sin;
    double da_x = acceleration_9 * cos + acceleration_10 * sin;
    double da_y = acceleration_10 * cos - acceleration_9 * sin;
    double acceleration_11 = w[i + 81] - (dalpha_x * w[i + 82] + dalpha_y * w[i + 83]
        + acceleration_6 * w[i + 84] + (da_x * w[i + 85] + da_y * w[i + 86]
        + acceleration_7 * w[i + 87]));
    w[i + 88] = dalpha_x;
    w[i + 89] = dalpha_y;
    w[i + 90] = acceleration_6 + acceleration_11;
    w[i + 91] = da_x;
    w[i + 92] = da_y;
    w[i + 93] = acceleration_7 + link__12 * acceleration_11;
    w[i + 94] = acceleration_11;
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
    double carry_6 = w[i + 12] * w[i + 32];
    double carry_7 = E_xx * carry_1 + E_yx * carry_2 + E_zx * carry_3 + carry_5 * carry_6;
    double carry_8 = E_xy * carry_1 + E_yy * carry_2 + E_zy * carry_3 - carry_4 * carry_6;
    w[i + 88] = carry_4 * cos + carry_5 * sin;
    w[i + 89] = carry_5 * cos - carry_4 * sin;
    w[i + 90] = E_xz * above_88 + E_yz * above_89 + E_zz * above_90;
    w[i + 91] = carry_7 * cos + carry_8 * sin;
    w[i + 92] = carry_8 * cos - carry_7 * sin;
    w[i + 93] = E_xz * carry_1 + E_yz * carry_2 + E_zz * carry_3;
  }

  @Override
  public void driving(double[] w, int i, int p) {
    // U.A + p.z - tau of each degree of freedom.
    double link__12 = w[i + 12];
    double link__23 = w[i + 23];
    double link__24 = w[i + 24];
    double H_zz = w[i + 73];
    double driving_1 = w[i + 88] * (w[i + 30] + w[i + 63] + link__12 * (link__24 + w[i + 67]))
        + w[i + 89] * (w[i + 31] + w[i + 64] + link__12 * (w[i + 70] - link__23))
        + w[i + 90] * (w[i + 28] + w[i + 61] + link__12 * H_zz);
    double driving_2 = w[i + 91] * (w[i + 71] - link__24 + link__12 * w[i + 78])
        + w[i + 92] * (link__23 + w[i + 72] + link__12 * w[i + 79]) + w[i + 93] * (H_zz
        + link__12 * (w[i + 13] + w[i + 76]));
    w[i + 94] = driving_1 + driving_2 + (w[i + 49] + link__12 * w[i + 52]) - w[i + 37];
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
    double link__12 = w[i + 12];
    double n_x = w[i + 47];
    double n_y = w[i + 48];
    double n_z = w[i + 49];
    double f_x = w[i + 50];
    double f_y = w[i + 51];
    double f_z = w[i + 52];
    double cos = w[i + 33];
    double sin = w[i + 34];
    double force_1 = f_x * cos - f_y * sin;
    double force_2 = f_x * sin + f_y * cos;
    double force_3 = link__12 * w[i + 32];
    double force_4 = n_x * cos - n_y * sin - force_2 * force_3;
    double force_5 = n_x * sin + n_y * cos + force_1 * force_3;
    double force_6 = E_xx * force_1 + E_xy * force_2 + E_xz * f_z;
    double force_7 = E_yx * force_1 + E_yy * force_2 + E_yz * f_z;
    double force_8 = E_zx * force_1 + E_zy * force_2 + E_zz * f_z;
    w[i + 94] = n_z + link__12 * f_z - w[i + 37];
    w[p + 47] = E_xx * force_4 + E_xy * force_5 + E_xz * n_z + (r_y * force_8 - r_z * force_7)
        + w[p + 47];
    w[p + 50] = force_6 + w[p + 50];
    w[p + 48] = E_yx * force_4 + E_yy * force_5 + E_yz * n_z + (r_z * force_6 - r_x * force_8)
        + w[p + 48];
    w[p + 51] = force_7 + w[p + 51];
    w[p + 49] = E_zx * force_4 + E_zy * force_5 + E_zz * n_z + (r_x * force_7 - r_y * force_6)
        + w[p + 49];
    w[p + 52] = force_8 + w[p + 52];
  }

  @Override
  public void forceOnRoot(double[] w, int i, int p) {
    // p.z - tau of each degree of freedom.
    w[i + 94] = w[i + 49] + w[i + 12] * w[i + 52] - w[i + 37];
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
    double link__12 = w[i + 12];
    double n_z = w[i + 49];
    double f_z = w[i + 52];
    double cos = w[i + 33];
    double sin = w[i + 34];
    double push_1 = w[i + 37] - (n_z + link__12 * f_z);
    double push_2 = w[i + 47] + w[i + 82] * push_1;
    double push_3 = w[i + 48] + w[i + 83] * push_1;
    double push_4 = n_z + w[i + 84] * push_1;
    double push_5 = w[i + 50] + w[i + 85] * push_1;
    double push_6 = w[i + 51] + w[i + 86] * push_1;
    double push_7 = f_z + w[i + 87] * push_1;
    double push_8 = push_5 * cos - push_6 * sin;
    double push_9 = push_5 * sin + push_6 * cos;
    double push_10 = link__12 * w[i + 32];
    double push_11 = push_2 * cos - push_3 * sin - push_9 * push_10;
    double push_12 = push_2 * sin + push_3 * cos + push_8 * push_10;
    double push_13 = E_xx * push_8 + E_xy * push_9 + E_xz * push_7;
    double push_14 = E_yx * push_8 + E_yy * push_9 + E_yz * push_7;
    double push_15 = E_zx * push_8 + E_zy * push_9 + E_zz * push_7;
    w[i + 81] = push_1 / w[i + 80];
    w[p + 47] = E_xx * push_11 + E_xy * push_12 + E_xz * push_4 + (r_y * push_15 - r_z * push_14)
        + w[p + 47];
    w[p + 50] = push_13 + w[p + 50];
    w[p + 48] = E_yx * push_11 + E_yy * push_12 + E_yz * push_4 + (r_z * push_13 - r_x * push_15)
        + w[p + 48];
    w[p + 51] = push_14 + w[p + 51];
    w[p + 49] = E_zx * push_11 + E_zy * push_12 + E_zz * push_4 + (r_x * push_14 - r_y * push_13)
        + w[p + 49];
    w[p + 52] = push_15 + w[p + 52];
  }

  @Override
  public void pushOnRoot(double[] w, int i, int p) {
    // u / D of each degree of freedom, with its D and U / D.
    w[i + 81] = (w[i + 37] - (w[i + 49] + w[i + 12] * w[i + 52])) / w[i + 80];
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
    double link__12 = w[i + 12];
    double Kn_z = w[p + 2];
    double Kf_z = w[p + 5];
    double cos = w[i + 33];
    double sin = w[i + 34];
    double couple_1 = Kn_z + link__12 * Kf_z + w[p + 6];
    double couple_2 = w[p + 0] - w[i + 82] * couple_1;
    double couple_3 = w[p + 1] - w[i + 83] * couple_1;
    double couple_4 = Kn_z - w[i + 84] * couple_1;
    double couple_5 = w[p + 3] - w[i + 85] * couple_1;
    double couple_6 = w[p + 4] - w[i + 86] * couple_1;
    double couple_7 = Kf_z - w[i + 87] * couple_1;
    double couple_8 = couple_5 * cos - couple_6 * sin;
    double couple_9 = couple_5 * sin + couple_6 * cos;
    double couple_10 = link__12 * w[i + 32];
    double couple_11 = couple_2 * cos - couple_3 * sin - couple_9 * couple_10;
    double couple_12 = couple_2 * sin + couple_3 * cos + couple_8 * couple_10;
    double couple_13 = E_xx * couple_8 + E_xy * couple_9 + E_xz * couple_7;
    double couple_14 = E_yx * couple_8 + E_yy * couple_9 + E_yz * couple_7;
    double couple_15 = E_zx * couple_8 + E_zy * couple_9 + E_zz * couple_7;
    w[p + 6] = couple_1;
    w[p + 9] = E_xx * couple_11 + E_xy * couple_12 + E_xz * couple_4 + (r_y * couple_15
        - r_z * couple_14);
    w[p + 10] = E_yx * couple_11 + E_yy * couple_12 + E_yz * couple_4 + (r_z * couple_13
        - r_x * couple_15);
    w[p + 11] = E_zx * couple_11 + E_zy * couple_12 + E_zz * couple_4 + (r_x * couple_14
        - r_y * couple_13);
    w[p + 12] = couple_13;
    w[p + 13] = couple_14;
    w[p + 14] = couple_15;
  }

  @Override
  public void coupleOnRoot(double[] w, int i, int p) {
    // kappa + K.z of each degree of freedom.
    w[p + 6] = w[p + 2] + w[i + 12] * w[p + 5] + w[p + 6];
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
    double transfer_1 = Kf_x * cos - Kf_y * sin;
    double transfer_2 = Kf_x * sin + Kf_y * cos;
    double transfer_3 = w[i + 12] * w[i + 32];
    double transfer_4 = Kn_x * cos - Kn_y * sin - transfer_2 * transfer_3;
    double transfer_5 = Kn_x * sin + Kn_y * cos + transfer_1 * transfer_3;
    double transfer_6 = E_xx * transfer_1 + E_xy * transfer_2 + E_xz * Kf_z;
    double transfer_7 = E_yx * transfer_1 + E_yy * transfer_2 + E_yz * Kf_z;
    double transfer_8 = E_zx * transfer_1 + E_zy * transfer_2 + E_zz * Kf_z;
    w[p + 9] = E_xx * transfer_4 + E_xy * transfer_5 + E_xz * Kn_z + (r_y * transfer_8
        - r_z * transfer_7);
    w[p + 10] = E_yx * transfer_4 + E_yy * transfer_5 + E_yz * Kn_z + (r_z * transfer_6
        - r_x * transfer_8);
    w[p + 11] = E_zx * transfer_4 + E_zy * transfer_5 + E_zz * Kn_z + (r_x * transfer_7
        - r_y * transfer_6);
    w[p + 12] = transfer_6;
    w[p + 13] = transfer_7;
    w[p + 14] = transfer_8;
  }
}
