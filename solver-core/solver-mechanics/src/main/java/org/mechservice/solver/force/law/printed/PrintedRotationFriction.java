package org.mechservice.solver.force.law.printed;

import org.mechservice.solver.force.law.PrintedLaw;

/**
 * Printed from its formula; do not edit. PrintedLawsTest compares it with the formula and
 * prints it anew with -Dgolden.write=true.
 */
final class PrintedRotationFriction implements PrintedLaw {

  @Override
  public void load(double[] x, double[] c, double[] out) {
    // The load by its formula.
    double omega_x = x[12];
    double omega_y = x[13];
    double omega_z = x[14];
    double law_1 = c[0] + c[1] / Math.sqrt(omega_x * omega_x + omega_y * omega_y + omega_z * omega_z
        + c[3]);
    out[0] = -(omega_x * law_1);
    out[1] = -(omega_y * law_1);
    out[2] = -(omega_z * law_1);
    out[3] = 0.0;
    out[4] = 0.0;
    out[5] = 0.0;
    out[6] = 1.0;
  }

  @Override
  public void slopes(double[] x, double[] c, double[] out) {
    // Derivatives by motion 7.
    double omega_x = x[12];
    double omega_y = x[13];
    double omega_z = x[14];
    double by7_1 = Math.sqrt(omega_x * omega_x + omega_y * omega_y + omega_z * omega_z + c[3]);
    double by7_2 = c[1] / by7_1;
    double by7_3 = c[0] + by7_2;
    double by7_4 = 0.5 * (omega_x + omega_x) / by7_1 * by7_2 / by7_1;
    out[36] = omega_x * by7_4 - by7_3;
    out[42] = omega_y * by7_4;
    out[48] = omega_z * by7_4;

    // Derivatives by motion 8.
    double by8_1 = 0.5 * (omega_y + omega_y) / by7_1 * by7_2 / by7_1;
    out[37] = omega_x * by8_1;
    out[43] = omega_y * by8_1 - by7_3;
    out[49] = omega_z * by8_1;

    // Derivatives by motion 9.
    double by9_1 = 0.5 * (omega_z + omega_z) / by7_1 * by7_2 / by7_1;
    out[38] = omega_x * by9_1;
    out[44] = omega_y * by9_1;
    out[50] = omega_z * by9_1 - by7_3;
  }

  @Override
  public void results(double[] x, double[] c, double[] out) {
    // The load by its formula.
    double omega_x = x[12];
    double omega_y = x[13];
    double omega_z = x[14];
    double law_1 = omega_x * omega_x + omega_y * omega_y + omega_z * omega_z;
    double law_2 = law_1 * (c[0] + c[1] / Math.sqrt(law_1 + c[3]));
    out[0] = 0.0;
    out[1] = -law_2;
    out[2] = law_2;
  }

  @Override
  public void settle(double[] c, double[] out) {
    // What depends on coefficients alone.
    double c_2 = c[2];
    out[3] = c_2 * c_2;
  }

  @Override
  public int size() {
    return 4;
  }
}
