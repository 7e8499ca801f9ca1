package org.mechservice.solver.ode.switching;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.mechservice.solver.ode.backward.BackwardFormulas;
import org.mechservice.solver.ode.step.ErrorNorm;
import org.mechservice.solver.ode.step.Manifold;
import org.mechservice.solver.ode.step.MaximumNorm;
import org.mechservice.solver.ode.suite.FunctionOde;

/** The forecast knows from places on a smooth course with which steps a backward formula passes. */
class StepForecastTest {
  private static final double TOLERANCE = 1e-6;

  /** Places every 0.01 on cos t + sin t, and beside it what the fast motion leaves. */
  private static StepForecast onWave(int steps, double left) {
    StepForecast forecast = new StepForecast();
    forecast.prepare(1, 1);
    for (int i = 0; i < steps; i++) {
      double t = 0.01 * i;
      // Irregular, as the fast motion is at the limit of stability.
      double off = left * TOLERANCE * Math.sin(1e3 * i * i);
      forecast.record(t, new double[] {StrictMath.cos(t) + StrictMath.sin(t) + off});
    }
    return forecast;
  }

  private static ErrorNorm norm() {
    MaximumNorm norm = new MaximumNorm();
    norm.begin(
        TOLERANCE, new double[] {TOLERANCE}, new Manifold(new FunctionOde(1, (t, y, yDot) -> {})));
    norm.weigh(new double[] {1});
    return norm;
  }

  /** Order 4 errs by C_4 h^5 |y⁽⁵⁾|, C_4 = 0.1135 of the formulas used, which is 1e-6 at 0.098. */
  @Test
  void longestStepIsThatOfTheHighestOrderThePlacesTell() {
    StepForecast forecast = onWave(40, 0);
    assertThat(forecast.passes(0.09, BackwardFormulas.NDF, norm())).isTrue();
    assertThat(forecast.passes(0.13, BackwardFormulas.NDF, norm())).isFalse();
  }

  @Test
  void whatIsLeftOfTheFastMotionHidesNoStepsSeveralTimesAsLong() {
    StepForecast forecast = onWave(80, 0.5);
    assertThat(forecast.passes(0.05, BackwardFormulas.NDF, norm())).isTrue();
  }

  @Test
  void nothingIsForecastFromTwoPlaces() {
    assertThat(onWave(6, 0).passes(1e-9, BackwardFormulas.NDF, norm())).isFalse();
    assertThat(onWave(9, 0).passes(1e-9, BackwardFormulas.NDF, norm())).isTrue();
  }

  @Test
  void meanStepIsThatBetweenThePlaces() {
    assertThat(onWave(30, 0).meanStep()).isBetween(0.0099999, 0.0100001);
  }
}
