package org.mechservice.study.identify;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.function.DoubleUnaryOperator;
import org.junit.jupiter.api.Test;
import org.mechservice.study.optimise.DesignVariable;
import org.mechservice.study.optimise.Response;

/** Profiles agree with linear theory where it holds, and with closed forms where it does not. */
class ProfileTest {
  private static final int SAMPLES = 40;

  private static Response residuals(Response model, double noise, double... truth)
      throws Exception {
    Random random = new Random(8);
    double[] measured = model.at(truth);
    for (int i = 0; i < measured.length; i++) {
      measured[i] += noise * random.nextGaussian();
    }
    return p -> {
      double[] r = model.at(p);
      for (int i = 0; i < r.length; i++) {
        r[i] = (r[i] - measured[i]) / noise;
      }
      return r;
    };
  }

  private static double[] samples(DoubleUnaryOperator f) {
    double[] values = new double[SAMPLES];
    for (int i = 0; i < SAMPLES; i++) {
      values[i] = f.applyAsDouble(0.1 * i);
    }
    return values;
  }

  /** A straight line through points: the profile is the interval of Student's t. */
  @Test
  void profileOfALinearModelIsAStraightLine() throws Exception {
    List<DesignVariable> line =
        List.of(new DesignVariable("a", -5, 5, 0), new DesignVariable("b", -5, 5, 0));
    Response response = residuals(p -> samples(t -> p[0] + p[1] * t), 0.1, 1, 2);
    Identification found = Identification.of(line, response, 1e-4);
    Profile profile = Profile.of(found, 1, response, 1e-4, Optional.empty(), 0.95);
    double half = found.halfWidth(1, 0.95);
    assertThat(profile.lower().orElseThrow())
        .isCloseTo(found.values()[1] - half, within(1e-6 * half));
    assertThat(profile.upper().orElseThrow())
        .isCloseTo(found.values()[1] + half, within(1e-6 * half));
    for (double[] point : profile.points()) {
      assertThat(point[1])
          .isCloseTo((point[0] - found.values()[1]) / found.deviations()[1], within(1e-6));
    }
  }

  /** With one parameter the profile is the sum of squares itself: e^(kt) bends it. */
  @Test
  void profileOfABentModelEndsWhereTheSumOfSquaresDoes() throws Exception {
    List<DesignVariable> growth = List.of(new DesignVariable("k", -3, 3, 0.5));
    Response response = residuals(p -> samples(t -> Math.exp(p[0] * t)), 4, 0.8);
    Identification found = Identification.of(growth, response, 1e-5);
    Profile profile = Profile.of(found, 0, response, 1e-5, Optional.empty(), 0.95);
    double quantile = found.halfWidth(0, 0.95) / found.deviations()[0];
    double least = sum(found.residuals());
    for (double end : new double[] {profile.lower().orElseThrow(), profile.upper().orElseThrow()}) {
      double tau = Math.sqrt(sum(response.at(new double[] {end})) - least) / found.noise();
      // between two points of the profile τ is taken as straight
      assertThat(tau).isCloseTo(quantile, within(0.02 * quantile));
    }
    double below = found.values()[0] - profile.lower().orElseThrow();
    double above = profile.upper().orElseThrow() - found.values()[0];
    assertThat(below).isGreaterThan(above);
  }

  /** Two springs in parallel: neither has an end, and the profile goes to the bounds. */
  @Test
  void parameterThatIsOpenHasNoEnds() throws Exception {
    List<DesignVariable> springs =
        List.of(new DesignVariable("a", 0, 4, 1), new DesignVariable("b", 0, 4, 1));
    Response response = residuals(p -> samples(t -> (p[0] + p[1]) * Math.sin(t)), 0.05, 1.5, 1.5);
    Identification found = Identification.of(springs, response, 1e-4);
    Profile profile = Profile.of(found, 0, response, 1e-4, Optional.empty(), 0.95);
    assertThat(profile.lower()).isEmpty();
    assertThat(profile.points()).hasSizeGreaterThan(3);
    assertThat(profile.points()).isSortedAccordingTo((x, y) -> Double.compare(x[0], y[0]));
  }

  private static double sum(double[] r) {
    double sum = 0;
    for (double each : r) {
      sum += each * each;
    }
    return sum;
  }
}
