package org.mechservice.solver.ode.suite;

/**
 * Seven stars attracting each other in a plane, masses 1 to 7; state [x(7), y(7), x'(7), y'(7)].
 *
 * <p>x_i'' = Σ_j m_j (x_j − x_i) / r_ij³, y alike. Hairer, Nørsett and Wanner I, II.10; IVP Test
 * Set, PLEI. End value confirmed to 13.7 digits by collocation of order 13 and 17 in quadruple
 * precision, and by the published one to 14.
 */
public final class Pleiades implements SuiteProblem {
  private static final int STARS = 7;

  private static final VerifiedValues REFERENCE =
      new VerifiedValues(
          3.0,
          new double[] {
            3.0, 3.0, -1.0, -3.0, 2.0, -2.0, 2.0, 3.0, -3.0, 2.0, 0.0, 0.0, -4.0, 4.0, 0.0, 0.0,
            0.0, 0.0, 0.0, 1.75, -1.5, 0.0, 0.0, 0.0, -1.25, 1.0, 0.0, 0.0
          },
          new double[] {
            1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0,
            1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0
          },
          new double[] {
            0.3706139143970536,
            3.2372840920572328,
            -3.222559032418323,
            0.6597091455775298,
            0.34255817071565825,
            1.5621721014006318,
            -0.7003092922212499,
            -3.9434375855173966,
            -3.271380973972551,
            5.225081843456549,
            -2.59061243497747,
            1.198213693392274,
            -0.24296823449358243,
            1.0914492404289795,
            3.417003806314317,
            1.3545845016255011,
            -2.5900655978107765,
            2.02505373471424,
            -1.1558151001604473,
            -0.8072988170223018,
            0.595239635420871,
            -3.74124496123401,
            0.377345968575062,
            0.9386858869551123,
            0.3667922227200557,
            -0.34740463538085037,
            2.344915448180937,
            -1.9470204342632922
          },
          1.5,
          new double[] {
            0.11774749065356975,
            2.2310181494054016,
            0.29505942652308426,
            -2.126919585569375,
            1.1635888089023405,
            0.7584836731077504,
            -0.1894471157020472,
            1.9504351127216988,
            -2.401004738431604,
            2.149574605607718,
            -1.8201088025046945,
            2.13328964200611,
            -3.3010719508252673,
            2.831895607465455,
            -2.9726493936263134,
            -1.333367693172503,
            3.5692691534152234,
            1.2174388243972374,
            -2.089411503014045,
            1.9025726463005328,
            -1.5580794772280389,
            0.0173212957044555,
            0.5996218660720692,
            0.7910780048057127,
            -1.113916652164491,
            2.1242736252280854,
            1.0269573686129683,
            -2.273892110203715
          });

  @Override
  public VerifiedValues reference() {
    return REFERENCE;
  }

  @Override
  public void derivative(double t, double[] y, double[] yDot) {
    System.arraycopy(y, 2 * STARS, yDot, 0, 2 * STARS);
    for (int i = 0; i < STARS; i++) {
      double ax = 0;
      double ay = 0;
      for (int j = 0; j < STARS; j++) {
        if (j != i) {
          double dx = y[j] - y[i];
          double dy = y[STARS + j] - y[STARS + i];
          double squared = dx * dx + dy * dy;
          double pull = (j + 1) / (squared * Math.sqrt(squared));
          ax += pull * dx;
          ay += pull * dy;
        }
      }
      yDot[2 * STARS + i] = ax;
      yDot[3 * STARS + i] = ay;
    }
  }
}
