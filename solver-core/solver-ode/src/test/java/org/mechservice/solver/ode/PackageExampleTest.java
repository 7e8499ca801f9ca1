package org.mechservice.solver.ode;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.mechservice.solver.ode.adams.Ode113;

/** Runs the lines shown in the package documentation. */
class PackageExampleTest {
  private static final class Ballistics implements OdeSystem {
    @Override
    public int dimension() {
      return 2;
    }

    @Override
    public void derivative(double t, double[] y, double[] yDot) {
      yDot[0] = y[1];
      yDot[1] = -9.81 - 0.01 * y[1] * Math.abs(y[1]);
    }
  }

  @Test
  void exampleOfThePackageDocumentationThrowsABall() {
    List<Double> heights = new ArrayList<>();
    OdeSystem ball = new Ballistics();
    Integrator integrator = new Ode113(new IntegratorSettings(1e-6, 1e-9));
    double[] y = new double[2];
    double[] yDot = new double[2];
    StepResult result = integrator.start(ball, 0, new double[] {0, 20}, 4);
    for (double t = 0.5; t <= 4; t += 0.5) {
      while (result == StepResult.ADVANCED && integrator.time() < t) {
        result = integrator.step();
      }
      if (result == StepResult.FAILED) {
        throw new ArithmeticException("" + integrator.failure());
      }
      integrator.interpolate(t, y, yDot);
      heights.add(y[0]);
    }
    assertThat(heights).hasSize(8);
    // Rising with air drag, v' = −g (1 + v²/w²), w² = g/0.01: the height is
    // (w²/g) ln(cos(θ − g t/w) / cos θ) with tan θ = v0/w.
    double w = Math.sqrt(9.81 / 0.01);
    double angle = StrictMath.atan(20 / w);
    double exact =
        w
            * w
            / 9.81
            * StrictMath.log(StrictMath.cos(angle - 9.81 * 1.5 / w) / StrictMath.cos(angle));
    assertThat(heights.get(2)).isCloseTo(exact, within(1e-4));
  }
}
