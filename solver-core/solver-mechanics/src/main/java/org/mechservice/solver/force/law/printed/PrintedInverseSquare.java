package org.mechservice.solver.force.law.printed;

import org.mechservice.solver.force.law.PrintedLaw;

/**
 * Printed from its formula; do not edit. PrintedLawsTest compares it with the formula and
 * prints it anew with -Dgolden.write=true.
 */
final class PrintedInverseSquare implements PrintedLaw {

  @Override
  public void load(double[] x, double[] c, double[] out) {
    // The load by its formula.
    double r_x = x[0];
    double r_y = x[1];
    double r_z = x[2];
    double law_1 = r_x * r_x + r_y * r_y + r_z * r_z + c[2];
    double law_2 = c[0] / (law_1 * Math.sqrt(law_1));
    out[0] = 0.0;
    out[1] = 0.0;
    out[2] = 0.0;
    out[3] = -(r_x * law_2);
    out[4] = -(r_y * law_2);
    out[5] = -(r_z * law_2);
    out[6] = law_1;
  }

  @Override
  public void slopes(double[] x, double[] c, double[] out) {
    // Derivatives by motion 4.
    double r_x = x[0];
    double r_y = x[1];
    double r_z = x[2];
    double by4_1 = r_x * r_x + r_y * r_y + r_z * r_z + c[2];
    double by4_2 = Math.sqrt(by4_1);
    double by4_3 = by4_1 * by4_2;
    double by4_4 = c[0] / by4_3;
    double by4_5 = r_x + r_x;
    double by4_6 = by4_4 * (by4_2 * by4_5 + 0.5 * by4_5 / by4_2 * by4_1) / by4_3;
    out[21] = r_x * by4_6 - by4_4;
    out[27] = r_y * by4_6;
    out[33] = r_z * by4_6;

    // Derivatives by motion 5.
    double by5_1 = r_y + r_y;
    double by5_2 = by4_4 * (by4_2 * by5_1 + 0.5 * by5_1 / by4_2 * by4_1) / by4_3;
    out[22] = r_x * by5_2;
    out[28] = r_y * by5_2 - by4_4;
    out[34] = r_z * by5_2;

    // Derivatives by motion 6.
    double by6_1 = r_z + r_z;
    double by6_2 = by4_4 * (by4_2 * by6_1 + 0.5 * by6_1 / by4_2 * by4_1) / by4_3;
    out[23] = r_x * by6_2;
    out[29] = r_y * by6_2;
    out[35] = r_z * by6_2 - by4_4;
  }

  @Override
  public void results(double[] x, double[] c, double[] out) {
    // The load by its formula.
    double strength = c[0];
    double r_x = x[0];
    double r_y = x[1];
    double r_z = x[2];
    double law_1 = r_x * r_x + r_y * r_y + r_z * r_z;
    double law_2 = law_1 + c[2];
    double law_3 = Math.sqrt(law_2);
    double law_4 = Math.sqrt(law_1);
    out[0] = -(strength / law_3);
    out[1] = 0.0;
    out[2] = law_4;
    out[3] = strength / (law_2 * law_3) * law_4;
  }

  @Override
  public void settle(double[] c, double[] out) {
    // What depends on coefficients alone.
    double c_1 = c[1];
    out[2] = c_1 * c_1;
  }

  @Override
  public int size() {
    return 3;
  }
}
