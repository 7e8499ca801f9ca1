package org.mechservice.solver.simulation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.mechservice.solver.simulation.equations.ExplicitForm;

/** q'' = -k q - c q'. */
class LocalMotionTest {
  private static final double PART = 1e-6;
  private static final int POSITION = 0;
  private static final int VELOCITY = 1;

  private static LocalMotion at(double k, double c, double q, double v, int unknown) {
    return LocalMotion.of(new ExplicitForm().of(new Spring(k, c)), unknown, 0, new double[] {q, v});
  }

  private static String said(double damping, double stiffness) {
    return new LocalMotion(damping, stiffness).sentence();
  }

  @Test
  void positionAndVelocityOfACoordinateTellItsStiffnessAndDamping() {
    for (int unknown : new int[] {POSITION, VELOCITY}) {
      LocalMotion motion = at(4e12, 3e5, 0.1, -20, unknown);
      assertThat(motion.stiffness()).isCloseTo(4e12, within(4e12 * PART));
      // The spring's acceleration rounds to 6e-5, seen through a change of velocity by 3e-7.
      assertThat(motion.damping()).isCloseTo(3e5, within(200.0));
    }
  }

  @Test
  void atRestAtTheOriginItIsKnownToo() {
    LocalMotion motion = at(1e8, 10, 0, 0, VELOCITY);
    assertThat(motion.stiffness()).isCloseTo(1e8, within(1e8 * PART));
    assertThat(motion.damping()).isCloseTo(10, within(10 * PART));
  }

  @Test
  void oscillationIsToldByItsFrequencyInHertzAndDampingRatio() {
    assertThat(said(0.2 * Math.PI, 4 * Math.PI * Math.PI))
        .isEqualTo("By itself it swings at 1.0 Hz, damping ratio 0.05 there. ");
  }

  @Test
  void numbersBeyondSinglePrecisionAreTold() {
    assertThat(said(0, 1e300)).startsWith("By itself it swings at 1.59154943").contains("E149 Hz");
  }

  @Test
  void overdampedMotionIsToldByItsFastestRate() {
    assertThat(said(1e5, 0)).isEqualTo("By itself it decays at 100000.0 1/s there. ");
  }

  @Test
  void motionThatIsDrivenAwayIsToldAsSuch() {
    assertThat(said(-3, 2)).isEqualTo("By itself it grows at 2.0 1/s there. ");
    assertThat(said(0, -4)).isEqualTo("By itself it grows at 2.0 1/s there. ");
    assertThat(said(1, -6)).isEqualTo("By itself it grows at 2.0 1/s there. ");
  }

  @Test
  void nothingIsSaidOfAFreeCoordinateNorOfOneWithoutValues() {
    assertThat(at(0, 0, 1, 1, VELOCITY).sentence()).isEmpty();
    assertThat(at(Double.NaN, 0, 1, 1, VELOCITY).sentence()).isEmpty();
    assertThat(at(1, 0, 1, 1, -1).sentence()).isEmpty();
    assertThat(at(1, 0, 1, 1, 2).sentence()).isEmpty();
  }

  private static final class Spring extends HarmonicOscillator {
    private final double k;
    private final double c;

    Spring(double k, double c) {
      this.k = k;
      this.c = c;
    }

    @Override
    public int derivative(double t, double[] y, double[] yDot) {
      yDot[0] = y[1];
      yDot[1] = -k * y[0] - c * y[1];
      return REGULAR;
    }
  }
}
