package org.mechservice.study.identify;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Random;
import java.util.concurrent.atomic.AtomicInteger;
import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.apache.commons.math3.linear.LUDecomposition;
import org.apache.commons.math3.linear.RealMatrix;
import org.junit.jupiter.api.Test;
import org.mechservice.study.optimise.DesignVariable;
import org.mechservice.study.optimise.PointFailedException;
import org.mechservice.study.optimise.Response;

/** Identified values, their intervals and what the data leave open agree with linear theory. */
class IdentificationTest {
  private static final int SAMPLES = 60;
  private static final double NOISE = 0.02;

  /** Decay and frequency of a free oscillation x = exp(-d t) cos(w t). */
  private static final double[] TRUTH = {0.3, 2.0};

  private static final List<DesignVariable> OSCILLATOR =
      List.of(new DesignVariable("d", 0, 1, 0.5), new DesignVariable("w", 1.5, 2.5, 1.8));

  private static double motion(double d, double w, double t) {
    return Math.exp(-d * t) * Math.cos(w * t);
  }

  private static Response oscillator(long seed) {
    Random random = new Random(seed);
    double[] measured = new double[SAMPLES];
    for (int i = 0; i < SAMPLES; i++) {
      measured[i] = motion(TRUTH[0], TRUTH[1], 0.1 * i) + NOISE * random.nextGaussian();
    }
    return p -> {
      double[] r = new double[SAMPLES];
      for (int i = 0; i < SAMPLES; i++) {
        r[i] = (motion(p[0], p[1], 0.1 * i) - measured[i]) / NOISE;
      }
      return r;
    };
  }

  /** s² (JᵀJ)⁻¹ with the analytic Jacobian at the found values. */
  @Test
  void covarianceIsThatOfLinearTheory() throws Exception {
    Identification found = Identification.of(OSCILLATOR, oscillator(5), 1e-4);
    double[][] j = new double[SAMPLES][2];
    for (int i = 0; i < SAMPLES; i++) {
      double t = 0.1 * i;
      double decay = Math.exp(-found.values()[0] * t);
      j[i][0] = -t * decay * Math.cos(found.values()[1] * t) / NOISE;
      j[i][1] = -t * decay * Math.sin(found.values()[1] * t) / NOISE;
    }
    RealMatrix jacobian = new Array2DRowRealMatrix(j);
    RealMatrix covariance =
        new LUDecomposition(jacobian.transpose().multiply(jacobian)).getSolver().getInverse();
    double s = found.noise();
    for (int k = 0; k < 2; k++) {
      double expected = s * Math.sqrt(covariance.getEntry(k, k));
      assertThat(found.deviations()[k]).isCloseTo(expected, within(1e-5 * expected));
    }
    assertThat(found.correlation()[0][1])
        .isCloseTo(
            covariance.getEntry(0, 1)
                / Math.sqrt(covariance.getEntry(0, 0) * covariance.getEntry(1, 1)),
            within(1e-5));
    // s² (m - n) is chi-squared: its standard deviation is sqrt(2 / 58) of 1.
    assertThat(s * s).isCloseTo(1, within(4 * Math.sqrt(2.0 / 58)));
    // Student's t with 58 degrees of freedom: 2.0017.
    assertThat(found.halfWidth(0, 0.95)).isCloseTo(2.0017 * found.deviations()[0], within(1e-6));
    assertThat(found.undetermined()).isEmpty();
  }

  /** Of 200 intervals (100 noises, 2 values) 190 ± 3 sqrt(200 · 0.95 · 0.05) hold the truth. */
  @Test
  void intervalsHoldTheTruthAsOftenAsTheySay() throws Exception {
    int holding = 0;
    for (int seed = 1; seed <= 100; seed++) {
      Identification found = Identification.of(OSCILLATOR, oscillator(seed), 1e-4);
      for (int k = 0; k < 2; k++) {
        if (Math.abs(found.values()[k] - TRUTH[k]) <= found.halfWidth(k, 0.95)) {
          holding++;
        }
      }
    }
    assertThat(holding).isBetween(181, 199);
  }

  /** Two springs in parallel move a mass by their sum alone. */
  @Test
  void springsInParallelAreNamedAsNotToBeToldApart() throws Exception {
    List<DesignVariable> springs =
        List.of(
            new DesignVariable("k1", 1, 10, 4),
            new DesignVariable("k2", 1, 10, 4),
            new DesignVariable("c", 0, 1, 0.5));
    Response response =
        p -> {
          double[] r = new double[SAMPLES];
          for (int i = 0; i < SAMPLES; i++) {
            double t = 0.1 * i;
            r[i] =
                motion(p[2], Math.sqrt(p[0] + p[1]), t)
                    - motion(0.3, Math.sqrt(8.5), t)
                    + 1e-3 * Math.sin(40.0 * i);
          }
          return r;
        };
    Identification found = Identification.of(springs, response, 1e-4);
    assertThat(found.undetermined()).hasSize(1);
    assertThat(found.undetermined().get(0)).startsWith("k1 and k2 cannot be told apart");
    assertThat(found.values()[0] + found.values()[1]).isCloseTo(8.5, within(0.01));
    assertThat(found.halfWidth(0, 0.95)).isInfinite();
    assertThat(found.halfWidth(1, 0.95)).isInfinite();
    assertThat(found.values()[2]).isCloseTo(0.3, within(found.halfWidth(2, 0.95)));
    assertThat(found.correlation()[0][1]).isNaN();
  }

  @Test
  void parameterWithoutEffectIsNamed() throws Exception {
    List<DesignVariable> variables =
        List.of(new DesignVariable("a", 0, 2, 0.5), new DesignVariable("idle", 0, 1, 0.5));
    Response response = p -> new double[] {p[0] - 1.1, p[0] - 0.9, 2 * p[0] - 2.05, p[0] - 1};
    Identification found = Identification.of(variables, response, 1e-4);
    assertThat(found.undetermined()).containsExactly("idle has no visible effect on the data");
    assertThat(found.deviations()[0]).isFinite();
  }

  /** From here the first step leads to a negative decay, where the response has no values. */
  @Test
  void trialThatFailsIsTooFarAndAStartThatFailsEndsTheFit() throws Exception {
    List<DesignVariable> decay = List.of(new DesignVariable("d", -5, 5, 4));
    AtomicInteger failed = new AtomicInteger();
    Response holed =
        p -> {
          if (p[0] < 0) {
            failed.incrementAndGet();
            throw new PointFailedException("N-013 no convergence");
          }
          double[] r = new double[SAMPLES];
          for (int i = 0; i < SAMPLES; i++) {
            double t = 0.1 * i;
            r[i] = Math.exp(-p[0] * t) - Math.exp(-0.3 * t) + 1e-3 * Math.sin(40.0 * i);
          }
          return r;
        };
    Identification found = Identification.of(decay, holed, 1e-4);
    assertThat(failed).hasPositiveValue();
    assertThat(found.values()[0]).isCloseTo(0.3, within(found.halfWidth(0, 0.99)));

    List<DesignVariable> nowhere = List.of(new DesignVariable("d", -5, 5, -1));
    assertThatThrownBy(() -> Identification.of(nowhere, holed, 1e-4))
        .isInstanceOf(PointFailedException.class)
        .hasMessageContaining("N-013 no convergence");
  }

  @Test
  void fewerValuesThanParametersAreRefused() {
    assertThatThrownBy(() -> Identification.of(OSCILLATOR, p -> new double[] {p[0], p[1]}, 1e-4))
        .hasMessageContaining("2 measured values for 2 parameters");
  }
}
