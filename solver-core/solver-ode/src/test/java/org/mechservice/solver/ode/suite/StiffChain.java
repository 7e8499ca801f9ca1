package org.mechservice.solver.ode.suite;

/**
 * Ten unit masses in a row from a wall, springs and dampers between them alternately stiff and
 * soft, the last one pushed by 10 sin 3t N; state [x(10), v(10)]. Fast motions of 4·10⁴ rad/s, slow
 * ones of 1 to 10 rad/s. End value confirmed to 13.2 digits by collocation of order 13 and 17.
 */
public final class StiffChain implements SuiteProblem {
  private static final int MASSES = 10;

  /** Stiffness in N/m and damping in N·s/m of even and odd springs, counted from the wall. */
  private static final double[] STIFFNESS = {1e9, 1e3};

  private static final double[] DAMPING = {1e4, 1};

  private static final VerifiedValues REFERENCE =
      new VerifiedValues(
          5.0,
          new double[] {
            0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
            0.0, 0.0, 0.0
          },
          new double[] {
            0.01, 0.01, 0.01, 0.01, 0.01, 0.01, 0.01, 0.01, 0.01, 0.01, 0.1, 0.1, 0.1, 0.1, 0.1,
            0.1, 0.1, 0.1, 0.1, 0.1
          },
          new double[] {
            1.0869907820836146e-08,
            0.01085933996818747,
            0.010859350589188639,
            0.021225368872161064,
            0.021225378784247642,
            0.03067971842157452,
            0.030679727307305914,
            0.039010613468330485,
            0.039010621193294216,
            0.04616046715259791,
            1.0436420751524705e-08,
            0.010682846039324357,
            0.010682854220799396,
            0.01681837405291541,
            0.016818375821002318,
            0.014533294488219118,
            0.014533287469962743,
            0.0029149243206858773,
            0.0029149087322205493,
            -0.016583179323625182
          },
          2.0,
          new double[] {
            -9.77949819201269e-09,
            -0.009799235293782321,
            -0.00979924472031875,
            -0.018904284268064397,
            -0.01890429277072646,
            -0.026872888353207926,
            -0.02687289541702174,
            -0.03310534213761326,
            -0.03310534722998651,
            -0.03712477928185827,
            2.0279905797372405e-08,
            0.01993050043077169,
            0.01993052657102097,
            0.051715343459793055,
            0.05171537821791728,
            0.08893698314137326,
            0.08893702048592297,
            0.1258772460738418,
            0.125877280142353,
            0.156750851457176
          });

  @Override
  public VerifiedValues reference() {
    return REFERENCE;
  }

  @Override
  public void derivative(double t, double[] y, double[] yDot) {
    double pull = 10 * StrictMath.sin(3 * t);
    for (int i = MASSES - 1; i >= 0; i--) {
      double tension = tension(i, y);
      yDot[i] = y[MASSES + i];
      yDot[MASSES + i] = pull - tension;
      pull = tension;
    }
  }

  /** Force of the spring before mass i, N. */
  private static double tension(int i, double[] y) {
    double x = i == 0 ? y[0] : y[i] - y[i - 1];
    double v = i == 0 ? y[MASSES] : y[MASSES + i] - y[MASSES + i - 1];
    return STIFFNESS[i % 2] * x + DAMPING[i % 2] * v;
  }
}
