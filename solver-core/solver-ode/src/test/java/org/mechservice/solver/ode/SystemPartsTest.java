package org.mechservice.solver.ode;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.mechservice.solver.ode.stiff.Ode15s;
import org.mechservice.solver.ode.stiff.Ode15sR;
import org.mechservice.solver.ode.suite.Run;

/** A problem wrapped around another keeps what that one tells of itself. */
class SystemPartsTest {
  private static final int N = 40;

  /** Diffusion along a rod, y_i' = y_{i−1} − 2 y_i + y_{i+1}, and a jump of the source at t = 1. */
  private static class Rod implements OdeSystem, BandedSystem, PiecewiseSystem {
    @Override
    public int dimension() {
      return N;
    }

    @Override
    public void derivative(double t, double[] y, double[] yDot) {
      for (int i = 0; i < N; i++) {
        double left = i == 0 ? 0 : y[i - 1];
        double right = i == N - 1 ? 0 : y[i + 1];
        yDot[i] = 100 * (left - 2 * y[i] + right) + (t < 1 ? 1 : 0);
      }
    }

    @Override
    public int lowerBandwidth() {
      return 1;
    }

    @Override
    public int upperBandwidth() {
      return 1;
    }

    @Override
    public List<Double> breakpoints() {
      return List.of(1.0);
    }
  }

  private static final class Counted implements OdeSystem {
    private final OdeSystem inner;
    private long count;

    Counted(OdeSystem inner) {
      this.inner = inner;
    }

    @Override
    public int dimension() {
      return inner.dimension();
    }

    @Override
    public void derivative(double t, double[] y, double[] yDot) {
      count++;
      inner.derivative(t, y, yDot);
    }

    @Override
    public <T> Optional<T> part(Class<T> kind) {
      return inner.part(kind);
    }
  }

  private static final class CountedResidual implements ResidualSystem {
    private final OdeSystem inner;

    CountedResidual(OdeSystem inner) {
      this.inner = inner;
    }

    @Override
    public int dimension() {
      return inner.dimension();
    }

    @Override
    public void residual(double t, double[] y, double[] yDot, double[] residual) {
      inner.derivative(t, y, residual);
      for (int i = 0; i < residual.length; i++) {
        residual[i] = yDot[i] - residual[i];
      }
    }

    @Override
    public <T> Optional<T> part(Class<T> kind) {
      return inner.part(kind);
    }
  }

  private static double[] ones() {
    double[] y = new double[N];
    Arrays.fill(y, 1);
    return y;
  }

  @Test
  void wrappedProblemIsIntegratedWithTheSameStepsEvaluationsAndBits() {
    IntegratorSettings settings = new IntegratorSettings(1e-6, 1e-9);
    Counted counted = new Counted(new Rod());
    Run plain = Run.of(new Ode15s(settings), new Rod(), 0, ones(), 2);
    Run wrapped = Run.of(new Ode15s(settings), counted, 0, ones(), 2);
    assertThat(wrapped.atEnd()).isEqualTo(plain.atEnd());
    assertThat(wrapped.statistics()).isEqualTo(plain.statistics());
    assertThat(counted.count).isEqualTo(plain.statistics().evaluations());
  }

  @Test
  void residualMadeOfAnotherProblemIsDifferencedByItsBand() {
    Ode15sR integrator = new Ode15sR(new IntegratorSettings(1e-6, 1e-9));
    integrator.start(new CountedResidual(new Rod()), 0, ones(), new double[N], 0.5);
    // y' and y in three groups of columns each, and F itself, instead of N + 1 evaluations.
    assertThat(integrator.statistics().evaluations()).isLessThan(N);
  }
}
