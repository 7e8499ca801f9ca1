package org.mechservice.solver.step.printed;

import org.mechservice.solver.step.StepKernel;

/**
 * Printed from its equations; do not edit. PrintedStepsTest compares it with them and
 * prints it anew with -Dgolden.write=true.
 */
final class PrintedAxesY implements StepKernel {

  @Override
  public void motion(double[] w, int i, int p) {
    // Motion: omega, alpha and a of the computing frame; the wrench that it takes.
    double link__0 = w[i + 0];
    double link__1 = w[i + 1];
    double link__9 = w[i + 9];
    double link__10 = w[i + 10];
    double link__11 = w[i + 11];
    double omega_p_x = w[p + 38];
    double omega_p_y = w[p + 39];
    double omega_p_z = w[p + 40];
    double alpha_p_x = w[p + 41];
    double alpha_p_y = w[p + 42];
    double alpha_p_z = w[p + 43];
    double motion_1 = omega_p_x * omega_p_x;
    double motion_2 = omega_p_y * omega_p_y;
    double motion_3 = omega_p_z * omega_p_z;
    double motion_4 = omega_p_x * omega_p_y;
    double motion_5 = omega_p_x * omega_p_z;
    double motion_6 = omega_p_y * omega_p_z;
    double motion_7 = link__10 * (motion_4 - alpha_p_z) - link__9 * (motion_2 + motion_3)
        + link__11 * (alpha_p_y + motion_5) + w[p + 44];
    double motion_8 = link__9 * (motion_5 - alpha_p_y) + link__10 * (alpha_p_x + motion_6)
        - link__11 * (motion_1 + motion_2) + w[p + 46];
    w[i + 38] = link__0 * omega_p_x - link__1 * omega_p_z;
    w[i + 39] = omega_p_y;
    w[i + 40] = link__0 * omega_p_z + link__1 * omega_p_x;
    w[i + 41] = link__0 * alpha_p_x - link__1 * alpha_p_z;
    w[i + 42] = alpha_p_y;
    w[i + 43] = link__0 * alpha_p_z + link__1 * alpha_p_x;
    w[i + 44] = link__0 * motion_7 - link__1 * motion_8;
    w[i + 45] = link__9 * (alpha_p_z + motion_4) - link__10 * (motion_1 + motion_3)
        + link__11 * (motion_6 - alpha_p_x) + w[p + 45];
    w[i + 46] = link__0 * motion_8 + link__1 * motion_7;
    w[i + 47] = 0.0;
    w[i + 48] = 0.0;
    w[i + 49] = 0.0;
    w[i + 50] = 0.0;
    w[i + 51] = 0.0;
    w[i + 52] = 0.0;
  }

  @Override
  public void inertia(double[] w, int i, int p) {
    // I - U U' / D and p + U u / D for each degree of freedom, added to the parent.
    double link__0 = w[i + 0];
    double link__1 = w[i + 1];
    double link__9 = w[i + 9];
    double link__10 = w[i + 10];
    double link__11 = w[i + 11];
    double J_xx = w[i + 59];
    double J_xy = w[i + 62];
    double J_xz = w[i + 63];
    double J_yz = w[i + 64];
    double J_zz = w[i + 61];
    double H_xx = w[i + 65];
    double H_xy = w[i + 66];
    double H_xz = w[i + 67];
    double H_yx = w[i + 68];
    double H_yy = w[i + 69];
    double H_yz = w[i + 70];
    double H_zx = w[i + 71];
    double H_zy = w[i + 72];
    double H_zz = w[i + 73];
    double M_xx = w[i + 74];
    double M_xy = w[i + 77];
    double M_xz = w[i + 78];
    double M_yy = w[i + 75];
    double M_yz = w[i + 79];
    double M_zz = w[i + 76];
    double n_x = w[i + 47];
    double n_z = w[i + 49];
    double f_x = w[i + 50];
    double f_y = w[i + 51];
    double f_z = w[i + 52];
    double inertia_1 = 2.0 * link__0;
    double inertia_2 = J_xz * inertia_1 + link__1 * (J_zz - J_xx);
    double inertia_3 = link__1 * inertia_2;
    double inertia_4 = link__0 * (H_xz + H_zx) + link__1 * (H_zz - H_xx);
    double inertia_5 = link__1 * inertia_4;
    double inertia_6 = link__0 * inertia_4;
    double inertia_7 = link__0 * H_zy - link__1 * H_xy;
    double inertia_8 = link__1 * H_zy + link__0 * H_xy;
    double inertia_9 = link__0 * H_yz - link__1 * H_yx;
    double inertia_10 = link__1 * H_yz + link__0 * H_yx;
    double inertia_11 = H_zz - inertia_5;
    double inertia_12 = H_xx + inertia_5;
    double inertia_13 = inertia_6 - H_xz;
    double inertia_14 = inertia_6 - H_zx;
    double inertia_15 = M_xz * inertia_1 + link__1 * (M_zz - M_xx);
    double inertia_16 = link__1 * inertia_15;
    double inertia_17 = link__0 * M_yz - link__1 * M_xy;
    double inertia_18 = link__1 * M_yz + link__0 * M_xy;
    double inertia_19 = M_zz - inertia_16;
    double inertia_20 = M_xx + inertia_16;
    double inertia_21 = link__0 * inertia_15 - M_xz;
    double inertia_22 = link__11 * inertia_18;
    double inertia_23 = link__10 * inertia_21;
    double inertia_24 = link__9 * inertia_17;
    double inertia_25 = inertia_23 - inertia_22 + inertia_12;
    double inertia_26 = link__10 * inertia_17 - link__11 * M_yy + inertia_8;
    double inertia_27 = link__10 * inertia_19 - link__11 * inertia_17 + inertia_14;
    double inertia_28 = link__11 * inertia_20 - link__9 * inertia_21 + inertia_10;
    double inertia_29 = inertia_22 - inertia_24 + H_yy;
    double inertia_30 = link__11 * inertia_21 - link__9 * inertia_19 + inertia_9;
    double inertia_31 = link__9 * inertia_18 - link__10 * inertia_20 + inertia_13;
    double inertia_32 = link__9 * M_yy - link__10 * inertia_18 + inertia_7;
    double inertia_33 = inertia_24 - inertia_23 + inertia_11;
    double inertia_34 = link__0 * f_z - link__1 * f_x;
    double inertia_35 = link__1 * f_z + link__0 * f_x;
    w[p + 59] = J_xx + inertia_3 + (link__10 * (inertia_14 + inertia_27) - link__11 * (inertia_8
        + inertia_26)) + w[p + 59];
    w[p + 60] = link__11 * (inertia_10 + inertia_28) - link__9 * (inertia_9 + inertia_30)
        + w[i + 60] + w[p + 60];
    w[p + 61] = J_zz - inertia_3 + (link__9 * (inertia_7 + inertia_32) - link__10 * (inertia_13
        + inertia_31)) + w[p + 61];
    w[p + 62] = link__1 * J_yz + link__0 * J_xy + (link__10 * inertia_30 - link__9 * inertia_14
        + link__11 * (inertia_12 - inertia_29)) + w[p + 62];
    w[p + 63] = link__0 * inertia_2 - J_xz + (link__9 * inertia_26 - link__11 * inertia_7
        + link__10 * (inertia_11 - inertia_25)) + w[p + 63];
    w[p + 64] = link__0 * J_yz - link__1 * J_xy + (link__11 * inertia_31 - link__10 * inertia_10
        + link__9 * (H_yy - inertia_33)) + w[p + 64];
    w[p + 65] = inertia_25 + w[p + 65];
    w[p + 66] = inertia_26 + w[p + 66];
    w[p + 67] = inertia_27 + w[p + 67];
    w[p + 68] = inertia_28 + w[p + 68];
    w[p + 69] = inertia_29 + w[p + 69];
    w[p + 70] = inertia_30 + w[p + 70];
    w[p + 71] = inertia_31 + w[p + 71];
    w[p + 72] = inertia_32 + w[p + 72];
    w[p + 73] = inertia_33 + w[p + 73];
    w[p + 74] = inertia_20 + w[p + 74];
    w[p + 75] = M_yy + w[p + 75];
    w[p + 76] = inertia_19 + w[p + 76];
    w[p + 77] = inertia_18 + w[p + 77];
    w[p + 78] = inertia_21 + w[p + 78];
    w[p + 79] = inertia_17 + w[p + 79];
    w[p + 47] = link__1 * n_z + link__0 * n_x + (link__10 * inertia_34 - link__11 * f_y)
        + w[p + 47];
    w[p + 50] = inertia_35 + w[p + 50];
    w[p + 48] = link__11 * inertia_35 - link__9 * inertia_34 + w[i + 48] + w[p + 48];
    w[p + 51] = f_y + w[p + 51];
    w[p + 49] = link__0 * n_z - link__1 * n_x + (link__9 * f_y - link__10 * inertia_35)
        + w[p + 49];
    w[p + 52] = inertia_34 + w[p + 52];
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
    double link__0 = w[i + 0];
    double link__1 = w[i + 1];
    double link__9 = w[i + 9];
    double link__10 = w[i + 10];
    double link__11 = w[i + 11];
    double J_xx = w[i + 59];
    double J_xy = w[i + 62];
    double J_xz = w[i + 63];
    double J_yz = w[i + 64];
    double J_zz = w[i + 61];
    double H_xx = w[i + 65];
    double H_xy = w[i + 66];
    double H_xz = w[i + 67];
    double H_yx = w[i + 68];
    double H_yy = w[i + 69];
    double H_yz = w[i + 70];
    double H_zx = w[i + 71];
    double H_zy = w[i + 72];
    double H_zz = w[i + 73];
    double M_xx = w[i + 74];
    double M_xy = w[i + 77];
    double M_xz = w[i + 78];
    double M_yy = w[i + 75];
    double M_yz = w[i + 79];
    double M_zz = w[i + 76];
    double n_x = w[i + 47];
    double n_z = w[i + 49];
    double f_x = w[i + 50];
    double f_y = w[i + 51];
    double f_z = w[i + 52];
    double pass_1 = 2.0 * link__0;
    double pass_2 = J_xz * pass_1 + link__1 * (J_zz - J_xx);
    double pass_3 = link__1 * pass_2;
    double pass_4 = link__0 * (H_xz + H_zx) + link__1 * (H_zz - H_xx);
    double pass_5 = link__1 * pass_4;
    double pass_6 = link__0 * pass_4;
    double pass_7 = link__0 * H_zy - link__1 * H_xy;
    double pass_8 = link__1 * H_zy + link__0 * H_xy;
    double pass_9 = link__0 * H_yz - link__1 * H_yx;
    double pass_10 = link__1 * H_yz + link__0 * H_yx;
    double pass_11 = H_zz - pass_5;
    double pass_12 = H_xx + pass_5;
    double pass_13 = pass_6 - H_xz;
    double pass_14 = pass_6 - H_zx;
    double pass_15 = M_xz * pass_1 + link__1 * (M_zz - M_xx);
    double pass_16 = link__1 * pass_15;
    double pass_17 = link__0 * M_yz - link__1 * M_xy;
    double pass_18 = link__1 * M_yz + link__0 * M_xy;
    double pass_19 = M_zz - pass_16;
    double pass_20 = M_xx + pass_16;
    double pass_21 = link__0 * pass_15 - M_xz;
    double pass_22 = link__11 * pass_18;
    double pass_23 = link__10 * pass_21;
    double pass_24 = link__9 * pass_17;
    double pass_25 = pass_23 - pass_22 + pass_12;
    double pass_26 = link__10 * pass_17 - link__11 * M_yy + pass_8;
    double pass_27 = link__10 * pass_19 - link__11 * pass_17 + pass_14;
    double pass_28 = link__11 * pass_20 - link__9 * pass_21 + pass_10;
    double pass_29 = pass_22 - pass_24 + H_yy;
    double pass_30 = link__11 * pass_21 - link__9 * pass_19 + pass_9;
    double pass_31 = link__9 * pass_18 - link__10 * pass_20 + pass_13;
    double pass_32 = link__9 * M_yy - link__10 * pass_18 + pass_7;
    double pass_33 = pass_24 - pass_23 + pass_11;
    double pass_34 = link__0 * f_z - link__1 * f_x;
    double pass_35 = link__1 * f_z + link__0 * f_x;
    w[p + 59] = J_xx + pass_3 + (link__10 * (pass_14 + pass_27) - link__11 * (pass_8 + pass_26))
        + w[p + 59];
    w[p + 60] = link__11 * (pass_10 + pass_28) - link__9 * (pass_9 + pass_30) + w[i + 60]
        + w[p + 60];
    w[p + 61] = J_zz - pass_3 + (link__9 * (pass_7 + pass_32) - link__10 * (pass_13 + pass_31))
        + w[p + 61];
    w[p + 62] = link__1 * J_yz + link__0 * J_xy + (link__10 * pass_30 - link__9 * pass_14
        + link__11 * (pass_12 - pass_29)) + w[p + 62];
    w[p + 63] = link__0 * pass_2 - J_xz + (link__9 * pass_26 - link__11 * pass_7
        + link__10 * (pass_11 - pass_25)) + w[p + 63];
    w[p + 64] = link__0 * J_yz - link__1 * J_xy + (link__11 * pass_31 - link__10 * pass_10
        + link__9 * (H_yy - pass_33)) + w[p + 64];
    w[p + 65] = pass_25 + w[p + 65];
    w[p + 66] = pass_26 + w[p + 66];
    w[p + 67] = pass_27 + w[p + 67];
    w[p + 68] = pass_28 + w[p + 68];
    w[p + 69] = pass_29 + w[p + 69];
    w[p + 70] = pass_30 + w[p + 70];
    w[p + 71] = pass_31 + w[p + 71];
    w[p + 72] = pass_32 + w[p + 72];
    w[p + 73] = pass_33 + w[p + 73];
    w[p + 74] = pass_20 + w[p + 74];
    w[p + 75] = M_yy + w[p + 75];
    w[p + 76] = pass_19 + w[p + 76];
    w[p + 77] = pass_18 + w[p + 77];
    w[p + 78] = pass_21 + w[p + 78];
    w[p + 79] = pass_17 + w[p + 79];
    w[p + 47] = link__1 * n_z + link__0 * n_x + (link__10 * pass_34 - link__11 * f_y) + w[p + 47];
    w[p + 50] = pass_35 + w[p + 50];
    w[p + 48] = link__11 * pass_35 - link__9 * pass_34 + w[i + 48] + w[p + 48];
    w[p + 51] = f_y + w[p + 51];
    w[p + 49] = link__0 * n_z - link__1 * n_x + (link__9 * f_y - link__10 * pass_35) + w[p + 49];
    w[p + 52] = pass_34 + w[p + 52];
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
  public void acceleration(double[] w, int i, int p) {
    // q'' = u / D - k.A of each degree of freedom, A = X' A_p + q'' z.
    double link__0 = w[i + 0];
    double link__1 = w[i + 1];
    double link__9 = w[i + 9];
    double link__10 = w[i + 10];
    double link__11 = w[i + 11];
    double above_88 = w[p + 88];
    double dalpha_y = w[p + 89];
    double above_90 = w[p + 90];
    double acceleration_1 = link__11 * dalpha_y - link__10 * above_90 + w[p + 91];
    double acceleration_2 = link__10 * above_88 - link__9 * dalpha_y + w[p + 93];
    w[i + 88] = link__0 * above_88 - link__1 * above_90;
    w[i + 89] = dalpha_y;
    w[i + 90] = link__0 * above_90 + link__1 * above_88;
    w[i + 91] = link__0 * acceleration_1 - link__1 * acceleration_2;
    w[i + 92] = link__9 * above_90 - link__11 * above_88 + w[p + 92];
    w[i + 93] = link__0 * acceleration_2 + link__1 * acceleration_1;
  }

  @Override
  public void carry(double[] w, int i, int p) {
    // A = X' A_p.
    double link__0 = w[i + 0];
    double link__1 = w[i + 1];
    double link__9 = w[i + 9];
    double link__10 = w[i + 10];
    double link__11 = w[i + 11];
    double above_88 = w[p + 88];
    double dalpha_y = w[p + 89];
    double above_90 = w[p + 90];
    double carry_1 = link__11 * dalpha_y - link__10 * above_90 + w[p + 91];
    double carry_2 = link__10 * above_88 - link__9 * dalpha_y + w[p + 93];
    w[i + 88] = link__0 * above_88 - link__1 * above_90;
    w[i + 89] = dalpha_y;
    w[i + 90] = link__0 * above_90 + link__1 * above_88;
    w[i + 91] = link__0 * carry_1 - link__1 * carry_2;
    w[i + 92] = link__9 * above_90 - link__11 * above_88 + w[p + 92];
    w[i + 93] = link__0 * carry_2 + link__1 * carry_1;
  }

  @Override
  public void driving(double[] w, int i, int p) {
    // U.A + p.z - tau of each degree of freedom.
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
    double link__0 = w[i + 0];
    double link__1 = w[i + 1];
    double link__9 = w[i + 9];
    double link__10 = w[i + 10];
    double link__11 = w[i + 11];
    double n_x = w[i + 47];
    double n_z = w[i + 49];
    double f_x = w[i + 50];
    double f_y = w[i + 51];
    double f_z = w[i + 52];
    double force_1 = link__0 * f_z - link__1 * f_x;
    double force_2 = link__1 * f_z + link__0 * f_x;
    w[p + 47] = link__1 * n_z + link__0 * n_x + (link__10 * force_1 - link__11 * f_y) + w[p + 47];
    w[p + 50] = force_2 + w[p + 50];
    w[p + 48] = link__11 * force_2 - link__9 * force_1 + w[i + 48] + w[p + 48];
    w[p + 51] = f_y + w[p + 51];
    w[p + 49] = link__0 * n_z - link__1 * n_x + (link__9 * f_y - link__10 * force_2) + w[p + 49];
    w[p + 52] = force_1 + w[p + 52];
  }

  @Override
  public void forceOnRoot(double[] w, int i, int p) {
  }

  @Override
  public void push(double[] w, int i, int p) {
    // u / D of each degree of freedom, with its D and U / D; p added to the parent.
    double link__0 = w[i + 0];
    double link__1 = w[i + 1];
    double link__9 = w[i + 9];
    double link__10 = w[i + 10];
    double link__11 = w[i + 11];
    double n_x = w[i + 47];
    double n_z = w[i + 49];
    double f_x = w[i + 50];
    double f_y = w[i + 51];
    double f_z = w[i + 52];
    double push_1 = link__0 * f_z - link__1 * f_x;
    double push_2 = link__1 * f_z + link__0 * f_x;
    w[p + 47] = link__1 * n_z + link__0 * n_x + (link__10 * push_1 - link__11 * f_y) + w[p + 47];
    w[p + 50] = push_2 + w[p + 50];
    w[p + 48] = link__11 * push_2 - link__9 * push_1 + w[i + 48] + w[p + 48];
    w[p + 51] = f_y + w[p + 51];
    w[p + 49] = link__0 * n_z - link__1 * n_x + (link__9 * f_y - link__10 * push_2) + w[p + 49];
    w[p + 52] = push_1 + w[p + 52];
  }

  @Override
  public void pushOnRoot(double[] w, int i, int p) {
  }

  @Override
  public void couple(double[] w, int i, int p) {
    // kappa + K.z of each degree of freedom; K - (U / D) kappa as the parent feels it.
    double link__0 = w[i + 0];
    double link__1 = w[i + 1];
    double link__9 = w[i + 9];
    double link__10 = w[i + 10];
    double link__11 = w[i + 11];
    double Kn_x = w[p + 0];
    double Kn_z = w[p + 2];
    double Kf_x = w[p + 3];
    double Kf_y = w[p + 4];
    double Kf_z = w[p + 5];
    double couple_1 = link__0 * Kf_z - link__1 * Kf_x;
    double couple_2 = link__1 * Kf_z + link__0 * Kf_x;
    w[p + 9] = link__1 * Kn_z + link__0 * Kn_x + (link__10 * couple_1 - link__11 * Kf_y);
    w[p + 10] = link__11 * couple_2 - link__9 * couple_1 + w[p + 1];
    w[p + 11] = link__0 * Kn_z - link__1 * Kn_x + (link__9 * Kf_y - link__10 * couple_2);
    w[p + 12] = couple_2;
    w[p + 13] = Kf_y;
    w[p + 14] = couple_1;
  }

  @Override
  public void coupleOnRoot(double[] w, int i, int p) {
  }

  @Override
  public void transfer(double[] w, int i, int p) {
    // K as the parent feels it.
    double link__0 = w[i + 0];
    double link__1 = w[i + 1];
    double link__9 = w[i + 9];
    double link__10 = w[i + 10];
    double link__11 = w[i + 11];
    double Kn_x = w[p + 0];
    double Kn_z = w[p + 2];
    double Kf_x = w[p + 3];
    double Kf_y = w[p + 4];
    double Kf_z = w[p + 5];
    double transfer_1 = link__0 * Kf_z - link__1 * Kf_x;
    double transfer_2 = link__1 * Kf_z + link__0 * Kf_x;
    w[p + 9] = link__1 * Kn_z + link__0 * Kn_x + (link__10 * transfer_1 - link__11 * Kf_y);
    w[p + 10] = link__11 * transfer_2 - link__9 * transfer_1 + w[p + 1];
    w[p + 11] = link__0 * Kn_z - link__1 * Kn_x + (link__9 * Kf_y - link__10 * transfer_2);
    w[p + 12] = transfer_2;
    w[p + 13] = Kf_y;
    w[p + 14] = transfer_1;
  }
}
