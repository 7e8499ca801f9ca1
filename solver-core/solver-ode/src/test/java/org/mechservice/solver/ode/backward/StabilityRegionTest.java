package org.mechservice.solver.ode.backward;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

/** What formulas amplify is known: by the angles of A(α), and by their own recurrence. */
class StabilityRegionTest {
  /** Degrees from the negative real axis; Shampine and Reichelt 1997, table 1. */
  private static final int[] NDF_ANGLES = {90, 90, 80, 66, 51};

  /** Hairer and Wanner II, V.2, table 2.1, cut to whole degrees. */
  private static final int[] BDF_ANGLES = {90, 90, 86, 73, 51};

  /** Whether any step along a ray in the left half plane amplifies. */
  private static boolean onRay(BackwardFormulas formulas, int k, double degrees) {
    StabilityRegion region = new StabilityRegion(formulas);
    double angle = Math.toRadians(degrees);
    for (double size = 1e-3; size < 1e4; size *= 1.05) {
      if (region.amplifies(k, -size * Math.cos(angle), size * Math.sin(angle))) {
        return true;
      }
    }
    return false;
  }

  @Test
  void anglesOfStabilityAreThosePublished() {
    for (int k = 1; k <= 5; k++) {
      assertThat(onRay(BackwardFormulas.NDF, k, NDF_ANGLES[k - 1])).as("NDF %d", k).isFalse();
      assertThat(onRay(BackwardFormulas.BDF, k, BDF_ANGLES[k - 1])).as("BDF %d", k).isFalse();
      // Growth below 1.0005 does not count: it takes a degree or two more to be seen.
      if (k > 2) {
        assertThat(onRay(BackwardFormulas.NDF, k, NDF_ANGLES[k - 1] + 2.5)).as("%d", k).isTrue();
        assertThat(onRay(BackwardFormulas.BDF, k, BDF_ANGLES[k - 1] + 2.5)).as("%d", k).isTrue();
      }
    }
  }

  /** An independent way: the formula run for 8000 steps on y' = λ y. */
  @Test
  void whatIsAmplifiedGrowsInTheRecurrence() {
    StabilityRegion region = new StabilityRegion(BackwardFormulas.NDF);
    for (int k = 1; k <= 5; k++) {
      for (double degrees : new double[] {0, 55, 70, 82, 88, 90}) {
        for (double size = 0.2; size < 20; size *= 1.4) {
          double re = -size * Math.cos(Math.toRadians(degrees));
          double im = size * Math.sin(Math.toRadians(degrees));
          double growth = growth(k, re, im);
          if (Math.abs(Math.log(growth) - Math.log(1.0005)) > 2e-4) {
            assertThat(region.amplifies(k, re, im))
                .as("order %d, %s e^(i %s)", k, size, degrees)
                .isEqualTo(growth > 1.0005);
          }
        }
      }
    }
  }

  /** Growth per step of the largest root, by running the formula for y' = λ y. */
  private static double growth(int k, double re, double im) {
    double[] c = new double[k + 2];
    for (int m = 1; m <= k + 1; m++) {
      double term = m <= k ? 1.0 / m : BackwardFormulas.NDF.furtherShare(k);
      for (int j = 0; j <= m; j++) {
        c[j] += term;
        term *= -(double) (m - j) / (j + 1);
      }
    }
    double leadRe = c[0] - re;
    double leadIm = -im;
    double square = leadRe * leadRe + leadIm * leadIm;
    double[] x = new double[k + 2];
    double[] y = new double[k + 2];
    for (int j = 0; j <= k + 1; j++) {
      x[j] = Math.sin(j + 1.0);
      y[j] = Math.cos(2.0 * j);
    }
    double log = 0;
    int steps = 8000;
    for (int n = 0; n < steps; n++) {
      double sumRe = 0;
      double sumIm = 0;
      for (int j = 1; j <= k + 1; j++) {
        sumRe -= c[j] * x[j - 1];
        sumIm -= c[j] * y[j - 1];
      }
      double nextRe = (sumRe * leadRe + sumIm * leadIm) / square;
      double nextIm = (sumIm * leadRe - sumRe * leadIm) / square;
      System.arraycopy(x, 0, x, 1, k + 1);
      System.arraycopy(y, 0, y, 1, k + 1);
      x[0] = nextRe;
      y[0] = nextIm;
      double norm = 0;
      for (int j = 0; j <= k; j++) {
        norm = Math.max(norm, Math.hypot(x[j], y[j]));
      }
      if (norm == 0) {
        return 0;
      }
      for (int j = 0; j <= k + 1; j++) {
        x[j] /= norm;
        y[j] /= norm;
      }
      log += n >= steps / 2 ? Math.log(norm) : 0;
    }
    return Math.exp(log / (steps - steps / 2));
  }
}
