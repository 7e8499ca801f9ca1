package org.mechservice.solver.ode.suite;

/**
 * A pendulum of six massless links with point masses at their ends and damping in the joints,
 * released horizontally; state [θ(6), ω(6)] with absolute angles from the vertical.
 *
 * <p>M_ij = (6 − max(i, j)) m l² cos(θ_i − θ_j). End value confirmed to 14.1 digits by collocation
 * of order 13 and 17.
 */
public final class SixLinkChain implements SuiteProblem {
  private static final int LINKS = 6;
  private static final double MASS = 1;
  private static final double LENGTH = 0.3;
  private static final double GRAVITY = 9.81;
  private static final double DAMPING = 0.05;

  private static final VerifiedValues REFERENCE =
      new VerifiedValues(
          2.0,
          new double[] {
            1.5707963267948966,
            1.5707963267948966,
            1.5707963267948966,
            1.5707963267948966,
            1.5707963267948966,
            1.5707963267948966,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0
          },
          new double[] {1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0},
          new double[] {
            0.007040563444114494,
            0.013002758512628474,
            0.026945373685114727,
            0.04508544700728793,
            -0.04849568814061043,
            1.0668546325352593,
            2.7217048234760055,
            2.748807352320729,
            2.7058390327917836,
            1.4265232731261035,
            5.292260282977237,
            17.02433946484912
          },
          1.0,
          new double[] {
            -1.0361275974386042,
            -1.107481343169851,
            -1.1624654759619526,
            -1.1853100837409964,
            -1.1426004756733612,
            -1.0511635070140397,
            -4.610937538871389,
            -3.9192933156039067,
            -2.453384091972539,
            -0.7951809599020381,
            0.5391371901556916,
            1.5025819056521472
          });

  /** Lower triangle of the mass matrix, then its factor, kg·m². */
  private final double[][] mass = new double[LINKS][LINKS];

  @Override
  public VerifiedValues reference() {
    return REFERENCE;
  }

  @Override
  public void derivative(double t, double[] y, double[] yDot) {
    for (int i = 0; i < LINKS; i++) {
      yDot[i] = y[LINKS + i];
      for (int j = 0; j <= i; j++) {
        mass[i][j] = (LINKS - i) * MASS * LENGTH * LENGTH * StrictMath.cos(y[i] - y[j]);
      }
      yDot[LINKS + i] = torque(i, y);
    }
    solve(yDot);
  }

  /** Centrifugal, gravity and damping torque on link i, N·m. */
  private static double torque(int i, double[] y) {
    double torque = -(LINKS - i) * MASS * GRAVITY * LENGTH * StrictMath.sin(y[i]);
    for (int j = 0; j < LINKS; j++) {
      double inertia = (LINKS - Math.max(i, j)) * MASS * LENGTH * LENGTH;
      torque -= inertia * StrictMath.sin(y[i] - y[j]) * y[LINKS + j] * y[LINKS + j];
    }
    double below = i == 0 ? 0 : y[LINKS + i - 1];
    torque += DAMPING * (below - y[LINKS + i]);
    if (i + 1 < LINKS) {
      torque += DAMPING * (y[LINKS + i + 1] - y[LINKS + i]);
    }
    return torque;
  }

  /** Solves M a = b by Cholesky factors, b and a in the second half of the vector. */
  private void solve(double[] x) {
    for (int i = 0; i < LINKS; i++) {
      for (int j = 0; j <= i; j++) {
        double sum = mass[i][j];
        for (int k = 0; k < j; k++) {
          sum -= mass[i][k] * mass[j][k];
        }
        mass[i][j] = i == j ? Math.sqrt(sum) : sum / mass[j][j];
      }
    }
    for (int i = 0; i < LINKS; i++) {
      for (int k = 0; k < i; k++) {
        x[LINKS + i] -= mass[i][k] * x[LINKS + k];
      }
      x[LINKS + i] /= mass[i][i];
    }
    for (int i = LINKS - 1; i >= 0; i--) {
      for (int k = i + 1; k < LINKS; k++) {
        x[LINKS + i] -= mass[k][i] * x[LINKS + k];
      }
      x[LINKS + i] /= mass[i][i];
    }
  }
}
