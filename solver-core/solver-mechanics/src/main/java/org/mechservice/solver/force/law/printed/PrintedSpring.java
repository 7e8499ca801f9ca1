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
    double u_x = x[15];
    double u_y = x[16];
    double u_z = x[17];
    double stiffness = c[0];
    double damping = c[1];
    double rest = c[2];
    double preload = c[3];
    double law_1 = Math.sqrt(r_x * r_x + r_y * r_y + r_z * r_z);
    double law_2 = Piecewise.choose(law_1, 0.0, Math.sqrt(u_x * u_x + u_y * u_y
        + u_z * u_z), (r_x * u_x + r_y * u_y + r_z * u_z) / law_1);
    double law_3 = Piecewise.choose(law_1, 0.0, -stiffness, -((preload + stiffness * (law_1 - rest)
        + damping * law_2) / law_1));
    double law_4 = Piecewise.choose(law_1, 0.0, -damping, 0.0);
    out[0] = 0.0;
    out[1] = 0.0;
    out[2] = 0.0;
    out[3] = r_x * law_3 + u_x * law_4;
    out[4] = r_y * law_3 + u_y * law_4;
    out[5] = r_z * law_3 + u_z * law_4;
    out[6] = Piecewise.choose(1.0, Piecewise.choose(Math.abs(preload
        - stiffness * rest), 1e-9 * (Math.abs(stiffness) * (c[4] + Math.abs(rest))
        + Math.abs(preload)), 1.0, 0.0), 1.0, law_1);
  }

  @Override
  public void slopes(double[] x, double[] c, double[] out) {
    // The load by its formula.
    double r_x = x[0];
    double r_y = x[1];
    double r_z = x[2];
    double u_x = x[15];
    double u_y = x[16];
    double u_z = x[17];
    double stiffness = c[0];
    double damping = c[1];
    double law_1 = Math.sqrt(r_x * r_x + r_y * r_y + r_z * r_z);
    double law_2 = (r_x * u_x + r_y * u_y + r_z * u_z) / law_1;
    double law_3 = Math.sqrt(u_x * u_x + u_y * u_y + u_z * u_z);
    double law_4 = (c[3] + stiffness * (law_1 - c[2])
        + damping * Piecewise.choose(law_1, 0.0, law_3, law_2)) / law_1;
    double law_5 = Piecewise.choose(law_1, 0.0, -stiffness, -law_4);
    double law_6 = Piecewise.choose(law_1, 0.0, -damping, 0.0);

    // Derivatives by motion 4.
    double by4_1 = 0.5 * (r_x + r_x) / law_1;
    double by4_2 = Piecewise.choose(law_1, 0.0, 0.0, -((damping * Piecewise.choose(law_1, 0.0, 0.0,
        (u_x - law_2 * by4_1) / law_1) + stiffness * by4_1 - law_4 * by4_1) / law_1));
    out[39] = law_5 + r_x * by4_2;
    out[51] = r_y * by4_2;
    out[63] = r_z * by4_2;

    // Derivatives by motion 5.
    double by5_1 = 0.5 * (r_y + r_y) / law_1;
    double by5_2 = Piecewise.choose(law_1, 0.0, 0.0, -((damping * Piecewise.choose(law_1, 0.0, 0.0,
        (u_y - law_2 * by5_1) / law_1) + stiffness * by5_1 - law_4 * by5_1) / law_1));
    out[40] = r_x * by5_2;
    out[52] = law_5 + r_y * by5_2;
    out[64] = r_z * by5_2;

    // Derivatives by motion 6.
    double by6_1 = 0.5 * (r_z + r_z) / law_1;
    double by6_2 = Piecewise.choose(law_1, 0.0, 0.0, -((damping * Piecewise.choose(law_1, 0.0, 0.0,
        (u_z - law_2 * by6_1) / law_1) + stiffness * by6_1 - law_4 * by6_1) / law_1));
    out[41] = r_x * by6_2;
    out[53] = r_y * by6_2;
    out[65] = law_5 + r_z * by6_2;

    // Derivatives by motion 10.
    double by10_1 = Piecewise.choose(law_1, 0.0, 0.0,
        -(damping * Piecewise.choose(law_1, 0.0, 0.5 * (u_x + u_x) / law_3, r_x / law_1) / law_1));
    out[45] = law_6 + r_x * by10_1;
    out[57] = r_y * by10_1;
    out[69] = r_z * by10_1;

    // Derivatives by motion 11.
    double by11_1 = Piecewise.choose(law_1, 0.0, 0.0,
        -(damping * Piecewise.choose(law_1, 0.0, 0.5 * (u_y + u_y) / law_3, r_y / law_1) / law_1));
    out[46] = r_x * by11_1;
    out[58] = law_6 + r_y * by11_1;
    out[70] = r_z * by11_1;

    // Derivatives by motion 12.
    double by12_1 = Piecewise.choose(law_1, 0.0, 0.0,
        -(damping * Piecewise.choose(law_1, 0.0, 0.5 * (u_z + u_z) / law_3, r_z / law_1) / law_1));
    out[47] = r_x * by12_1;
    out[59] = r_y * by12_1;
    out[71] = law_6 + r_z * by12_1;
  }

  @Override
  public void results(double[] x, double[] c, double[] out) {
    // The load by its formula.
    double r_x = x[0];
    double r_y = x[1];
    double r_z = x[2];
    double u_x = x[15];
    double u_y = x[16];
    double u_z = x[17];
    double stiffness = c[0];
    double preload = c[3];
    double law_1 = Math.sqrt(r_x * r_x + r_y * r_y + r_z * r_z);
    double law_2 = Piecewise.choose(law_1, 0.0, Math.sqrt(u_x * u_x + u_y * u_y
        + u_z * u_z), (r_x * u_x + r_y * u_y + r_z * u_z) / law_1);
    double law_3 = law_1 - c[2];
    double law_4 = c[1] * law_2;
    out[0] = law_3 * (preload + 0.5 * stiffness * law_3);
    out[1] = -(law_2 * law_4);
    out[2] = law_1;
    out[3] = law_2;
    out[4] = preload + stiffness * law_3 + law_4;
  }
}
