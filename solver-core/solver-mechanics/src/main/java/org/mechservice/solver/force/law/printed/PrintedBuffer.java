package org.mechservice.solver.force.law.printed;

import org.mechservice.solver.force.law.PrintedLaw;
import org.mechservice.solver.spatial.Piecewise;

/**
 * Printed from its formula; do not edit. PrintedLawsTest compares it with the formula and
 * prints it anew with -Dgolden.write=true.
 */
final class PrintedBuffer implements PrintedLaw {

  @Override
  public void load(double[] x, double[] c, double[] out) {
    // The load by its formula.
    double r_x = x[0];
    double r_y = x[1];
    double r_z = x[2];
    double u_x = x[15];
    double u_y = x[16];
    double u_z = x[17];
    double law_1 = Math.sqrt(r_x * r_x + r_y * r_y + r_z * r_z);
    double law_2 = law_1 - c[2];
    double law_3 = Piecewise.choose(law_1, 0.0, Math.sqrt(u_x * u_x + u_y * u_y
        + u_z * u_z), (r_x * u_x + r_y * u_y + r_z * u_z) / law_1);
    double law_4 = c[1] * law_3;
    double law_5 = c[0] * Piecewise.choose(0.0, -law_2, -law_2, 0.0);
    double law_6 = Piecewise.choose(-law_2, 0.0, Piecewise.choose(0.0, -law_2, Math.max(0.0,
        -(0.5 * law_4)), 0.0), Math.max(0.0, law_5 - (law_4 + c[5] * law_3 * law_5))) / law_1;
    double law_7 = Piecewise.choose(law_1, 0.0, c[6], law_6);
    double law_8 = Piecewise.choose(law_1, 0.0, c[7], 0.0);
    out[0] = 0.0;
    out[1] = 0.0;
    out[2] = 0.0;
    out[3] = r_x * law_7 + u_x * law_8;
    out[4] = r_y * law_7 + u_y * law_8;
    out[5] = r_z * law_7 + u_z * law_8;
    out[6] = Piecewise.choose(1.0, c[8], 1.0, law_1);
  }

  @Override
  public void slopes(double[] x, double[] c, double[] out) {
    // Derivatives by motion 4.
    double r_x = x[0];
    double r_y = x[1];
    double r_z = x[2];
    double damping = c[1];
    double u_x = x[15];
    double u_y = x[16];
    double u_z = x[17];
    double stiffness = c[0];
    double chi = c[5];
    double by4_1 = Math.sqrt(r_x * r_x + r_y * r_y + r_z * r_z);
    double by4_2 = by4_1 - c[2];
    double by4_3 = Math.sqrt(u_x * u_x + u_y * u_y + u_z * u_z);
    double by4_4 = (r_x * u_x + r_y * u_y + r_z * u_z) / by4_1;
    double by4_5 = Piecewise.choose(by4_1, 0.0, by4_3, by4_4);
    double by4_6 = damping * by4_5;
    double by4_7 = 0.5 * by4_6;
    double by4_8 = stiffness * Piecewise.choose(0.0, -by4_2, -by4_2, 0.0);
    double by4_9 = chi * by4_5;
    double by4_10 = by4_8 - (by4_6 + by4_8 * by4_9);
    double by4_11 = Piecewise.choose(-by4_2, 0.0, Piecewise.choose(0.0, -by4_2, Math.max(0.0,
        -by4_7), 0.0), Math.max(0.0, by4_10)) / by4_1;
    double by4_12 = Piecewise.choose(by4_1, 0.0, c[6], by4_11);
    double by4_13 = 0.5 * (r_x + r_x) / by4_1;
    double by4_14 = Piecewise.choose(by4_1, 0.0, 0.0, (u_x - by4_4 * by4_13) / by4_1);
    double by4_15 = damping * by4_14;
    double by4_16 = stiffness * Piecewise.choose(0.0, -by4_2, -by4_13, 0.0);
    double by4_17 = Piecewise.choose(-by4_2, 0.0, Piecewise.choose(0.0,
        -by4_2, Piecewise.choose(-by4_7, 0.0, 0.0, -(0.5 * by4_15)), 0.0), Piecewise.choose(by4_10,
        0.0, 0.0, by4_16 - (by4_9 * by4_16 + chi * by4_14 * by4_8 + by4_15)));
    double by4_18 = Piecewise.choose(by4_1, 0.0, 0.0, (by4_17 - by4_11 * by4_13) / by4_1);
    out[21] = by4_12 + r_x * by4_18;
    out[27] = r_y * by4_18;
    out[33] = r_z * by4_18;

    // Derivatives by motion 5.
    double by5_1 = 0.5 * (r_y + r_y) / by4_1;
    double by5_2 = Piecewise.choose(by4_1, 0.0, 0.0, (u_y - by4_4 * by5_1) / by4_1);
    double by5_3 = damping * by5_2;
    double by5_4 = stiffness * Piecewise.choose(0.0, -by4_2, -by5_1, 0.0);
    double by5_5 = Piecewise.choose(-by4_2, 0.0, Piecewise.choose(0.0,
        -by4_2, Piecewise.choose(-by4_7, 0.0, 0.0, -(0.5 * by5_3)), 0.0), Piecewise.choose(by4_10,
        0.0, 0.0, by5_4 - (by4_9 * by5_4 + chi * by5_2 * by4_8 + by5_3)));
    double by5_6 = Piecewise.choose(by4_1, 0.0, 0.0, (by5_5 - by4_11 * by5_1) / by4_1);
    out[22] = r_x * by5_6;
    out[28] = by4_12 + r_y * by5_6;
    out[34] = r_z * by5_6;

    // Derivatives by motion 6.
    double by6_1 = 0.5 * (r_z + r_z) / by4_1;
    double by6_2 = Piecewise.choose(by4_1, 0.0, 0.0, (u_z - by4_4 * by6_1) / by4_1);
    double by6_3 = damping * by6_2;
    double by6_4 = stiffness * Piecewise.choose(0.0, -by4_2, -by6_1, 0.0);
    double by6_5 = Piecewise.choose(-by4_2, 0.0, Piecewise.choose(0.0,
        -by4_2, Piecewise.choose(-by4_7, 0.0, 0.0, -(0.5 * by6_3)), 0.0), Piecewise.choose(by4_10,
        0.0, 0.0, by6_4 - (by4_9 * by6_4 + chi * by6_2 * by4_8 + by6_3)));
    double by6_6 = Piecewise.choose(by4_1, 0.0, 0.0, (by6_5 - by4_11 * by6_1) / by4_1);
    out[23] = r_x * by6_6;
    out[29] = r_y * by6_6;
    out[35] = by4_12 + r_z * by6_6;

    // Derivatives by motion 10.
    double by10_1 = Piecewise.choose(by4_1, 0.0, c[7], 0.0);
    double by10_2 = Piecewise.choose(by4_1, 0.0, 0.5 * (u_x + u_x) / by4_3, r_x / by4_1);
    double by10_3 = damping * by10_2;
    double by10_4 = Piecewise.choose(-by4_2, 0.0, Piecewise.choose(0.0,
        -by4_2, Piecewise.choose(-by4_7, 0.0, 0.0, -(0.5 * by10_3)), 0.0), Piecewise.choose(by4_10,
        0.0, 0.0, -(chi * by10_2 * by4_8 + by10_3)));
    double by10_5 = Piecewise.choose(by4_1, 0.0, 0.0, by10_4 / by4_1);
    out[57] = by10_1 + r_x * by10_5;
    out[63] = r_y * by10_5;
    out[69] = r_z * by10_5;

    // Derivatives by motion 11.
    double by11_1 = Piecewise.choose(by4_1, 0.0, 0.5 * (u_y + u_y) / by4_3, r_y / by4_1);
    double by11_2 = damping * by11_1;
    double by11_3 = Piecewise.choose(-by4_2, 0.0, Piecewise.choose(0.0,
        -by4_2, Piecewise.choose(-by4_7, 0.0, 0.0, -(0.5 * by11_2)), 0.0), Piecewise.choose(by4_10,
        0.0, 0.0, -(chi * by11_1 * by4_8 + by11_2)));
    double by11_4 = Piecewise.choose(by4_1, 0.0, 0.0, by11_3 / by4_1);
    out[58] = r_x * by11_4;
    out[64] = by10_1 + r_y * by11_4;
    out[70] = r_z * by11_4;

    // Derivatives by motion 12.
    double by12_1 = Piecewise.choose(by4_1, 0.0, 0.5 * (u_z + u_z) / by4_3, r_z / by4_1);
    double by12_2 = damping * by12_1;
    double by12_3 = Piecewise.choose(-by4_2, 0.0, Piecewise.choose(0.0,
        -by4_2, Piecewise.choose(-by4_7, 0.0, 0.0, -(0.5 * by12_2)), 0.0), Piecewise.choose(by4_10,
        0.0, 0.0, -(chi * by12_1 * by4_8 + by12_2)));
    double by12_4 = Piecewise.choose(by4_1, 0.0, 0.0, by12_3 / by4_1);
    out[59] = r_x * by12_4;
    out[65] = r_y * by12_4;
    out[71] = by10_1 + r_z * by12_4;
  }

  @Override
  public void results(double[] x, double[] c, double[] out) {
    // The load by its formula.
    double stiffness = c[0];
    double r_x = x[0];
    double r_y = x[1];
    double r_z = x[2];
    double u_x = x[15];
    double u_y = x[16];
    double u_z = x[17];
    double law_1 = Math.sqrt(r_x * r_x + r_y * r_y + r_z * r_z);
    double law_2 = law_1 - c[2];
    double law_3 = Piecewise.choose(0.0, -law_2, -law_2, 0.0);
    double law_4 = Piecewise.choose(law_1, 0.0, Math.sqrt(u_x * u_x + u_y * u_y
        + u_z * u_z), (r_x * u_x + r_y * u_y + r_z * u_z) / law_1);
    double law_5 = c[1] * law_4;
    double law_6 = stiffness * law_3;
    double law_7 = Piecewise.choose(-law_2, 0.0, Piecewise.choose(0.0, -law_2, Math.max(0.0,
        -(0.5 * law_5)), 0.0), Math.max(0.0, law_6 - (law_5 + c[5] * law_4 * law_6)));
    out[0] = law_3 * law_3 * 0.5 * stiffness;
    out[1] = law_4 * (law_7 - law_6);
    out[2] = law_1;
    out[3] = law_4;
    out[4] = -law_7;
  }

  @Override
  public void settle(double[] c, double[] out) {
    // What depends on coefficients alone.
    double c_2 = c[2];
    double c_0 = c[0];
    double c_1 = c[1];
    double c_4 = 1e-300 - c_2;
    double c_6 = Piecewise.choose(-c_4, 0.0, 0.0, Piecewise.choose(c_0 * Piecewise.choose(0.0, -c_4,
        -c_4, 0.0), 0.0, 0.0, c_0 * Piecewise.choose(0.0, -c_4, -1.0, 0.0)));
    double c_7 = c_0 * Piecewise.choose(0.0, c_2, c_2, 0.0);
    out[6] = c_6;
    out[7] = Piecewise.choose(c_2, 0.0, Piecewise.choose(0.0, c_2, Math.max(0.0,
        -(0.5 * c_1)), 0.0), Math.max(0.0, c_7 - (c_1 + c[5] * c_7))) - c_7;
    out[8] = Piecewise.choose(Math.abs(-Piecewise.choose(c_2, 0.0, 0.0, Math.max(0.0, c_7))), 1e-9
        * (Math.abs(c_0) * Math.abs(c_2) + Math.abs(c[3])), 1.0, 0.0);
  }

  @Override
  public int size() {
    return 9;
  }
}
