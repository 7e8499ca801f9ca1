package org.mechservice.solver.force.law.printed;

import org.mechservice.solver.force.law.PrintedLaw;
import org.mechservice.solver.spatial.Piecewise;

/**
 * Printed from its formula; do not edit. PrintedLawsTest compares it with the formula and
 * prints it anew with -Dgolden.write=true.
 */
final class PrintedSpring implements PrintedLaw {

  @Override
  public void load(double[] x, double[] c, double[] out) {
    // The load by its formula.
    double r_x = x[0];
    double r_y = x[1];
    double r_z = x[2];
    double stiffness = c[0];
    double damping = c[1];
    double u_x = x[15];
    double u_y = x[16];
    double u_z = x[17];
    double law_1 = Math.sqrt(r_x * r_x + r_y * r_y + r_z * r_z);
    double law_2 = Piecewise.choose(law_1, 0.0, Math.sqrt(u_x * u_x + u_y * u_y
        + u_z * u_z), (r_x * u_x + r_y * u_y + r_z * u_z) / law_1);
    double law_3 = Piecewise.choose(law_1, 0.0, -stiffness, -((c[3] + stiffness * (law_1 - c[2])
        + damping * law_2) / law_1));
    double law_4 = Piecewise.choose(law_1, 0.0, -damping, 0.0);
    out[0] = 0.0;
    out[1] = 0.0;
    out[2] = 0.0;
    out[3] = r_x * law_3 + u_x * law_4;
    out[4] = r_y * law_3 + u_y * law_4;
    out[5] = r_z * law_3 + u_z * law_4;
    out[6] = Piecewise.choose(1.0, c[6], 1.0, law_1);
  }

  @Override
  public void slopes(double[] x, double[] c, double[] out) {
    // Derivatives by motion 4.
    double r_x = x[0];
    double r_y = x[1];
    double r_z = x[2];
    double stiffness = c[0];
    double damping = c[1];
    double u_x = x[15];
    double u_y = x[16];
    double u_z = x[17];
    double by4_1 = Math.sqrt(r_x * r_x + r_y * r_y + r_z * r_z);
    double by4_2 = Math.sqrt(u_x * u_x + u_y * u_y + u_z * u_z);
    double by4_3 = (r_x * u_x + r_y * u_y + r_z * u_z) / by4_1;
    double by4_4 = (c[3] + stiffness * (by4_1 - c[2])
        + damping * Piecewise.choose(by4_1, 0.0, by4_2, by4_3)) / by4_1;
    double by4_5 = Piecewise.choose(by4_1, 0.0, -stiffness, -by4_4);
    double by4_6 = 0.5 * (r_x + r_x) / by4_1;
    double by4_7 = Piecewise.choose(by4_1, 0.0, 0.0, -((damping * Piecewise.choose(by4_1, 0.0, 0.0,
        (u_x - by4_3 * by4_6) / by4_1) + stiffness * by4_6 - by4_4 * by4_6) / by4_1));
    out[21] = by4_5 + r_x * by4_7;
    out[27] = r_y * by4_7;
    out[33] = r_z * by4_7;

    // Derivatives by motion 5.
    double by5_1 = 0.5 * (r_y + r_y) / by4_1;
    double by5_2 = Piecewise.choose(by4_1, 0.0, 0.0, -((damping * Piecewise.choose(by4_1, 0.0, 0.0,
        (u_y - by4_3 * by5_1) / by4_1) + stiffness * by5_1 - by4_4 * by5_1) / by4_1));
    out[22] = r_x * by5_2;
    out[28] = by4_5 + r_y * by5_2;
    out[34] = r_z * by5_2;

    // Derivatives by motion 6.
    double by6_1 = 0.5 * (r_z + r_z) / by4_1;
    double by6_2 = Piecewise.choose(by4_1, 0.0, 0.0, -((damping * Piecewise.choose(by4_1, 0.0, 0.0,
        (u_z - by4_3 * by6_1) / by4_1) + stiffness * by6_1 - by4_4 * by6_1) / by4_1));
    out[23] = r_x * by6_2;
    out[29] = r_y * by6_2;
    out[35] = by4_5 + r_z * by6_2;

    // Derivatives by motion 10.
    double by10_1 = Piecewise.choose(by4_1, 0.0, -damping, 0.0);
    double by10_2 = Piecewise.choose(by4_1, 0.0, 0.0,
        -(damping * Piecewise.choose(by4_1, 0.0, 0.5 * (u_x + u_x) / by4_2, r_x / by4_1) / by4_1));
    out[57] = by10_1 + r_x * by10_2;
    out[63] = r_y * by10_2;
    out[69] = r_z * by10_2;

    // Derivatives by motion 11.
    double by11_1 = Piecewise.choose(by4_1, 0.0, 0.0,
        -(damping * Piecewise.choose(by4_1, 0.0, 0.5 * (u_y + u_y) / by4_2, r_y / by4_1) / by4_1));
    out[58] = r_x * by11_1;
    out[64] = by10_1 + r_y * by11_1;
    out[70] = r_z * by11_1;

    // Derivatives by motion 12.
    double by12_1 = Piecewise.choose(by4_1, 0.0, 0.0,
        -(damping * Piecewise.choose(by4_1, 0.0, 0.5 * (u_z + u_z) / by4_2, r_z / by4_1) / by4_1));
    out[59] = r_x * by12_1;
    out[65] = r_y * by12_1;
    out[71] = by10_1 + r_z * by12_1;
  }

  @Override
  public void results(double[] x, double[] c, double[] out) {
    // The load by its formula.
    double r_x = x[0];
    double r_y = x[1];
    double r_z = x[2];
    double preload = c[3];
    double u_x = x[15];
    double u_y = x[16];
    double u_z = x[17];
    double law_1 = Math.sqrt(r_x * r_x + r_y * r_y + r_z * r_z);
    double law_2 = law_1 - c[2];
    double law_3 = Piecewise.choose(law_1, 0.0, Math.sqrt(u_x * u_x + u_y * u_y
        + u_z * u_z), (r_x * u_x + r_y * u_y + r_z * u_z) / law_1);
    double law_4 = c[1] * law_3;
    out[0] = law_2 * (preload + law_2 * c[7]);
    out[1] = -(law_3 * law_4);
    out[2] = law_1;
    out[3] = law_3;
    out[4] = preload + c[0] * law_2 + law_4;
  }

  @Override
  public void settle(double[] c, double[] out) {
    // What depends on coefficients alone.
    double c_3 = c[3];
    double c_0 = c[0];
    double c_2 = c[2];
    out[6] = Piecewise.choose(Math.abs(c_3 - c_0 * c_2), 1e-9 * (Math.abs(c_0) * (c[4]
        + Math.abs(c_2)) + Math.abs(c_3)), 1.0, 0.0);
    out[7] = 0.5 * c_0;
  }

  @Override
  public int size() {
    return 8;
  }
}
