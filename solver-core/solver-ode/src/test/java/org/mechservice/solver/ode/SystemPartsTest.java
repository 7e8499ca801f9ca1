package org.mechservice.solver.ode;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.mechservice.solver.ode.stiff.Ode15s;
import org.mechservice.solver.ode.stiff.Ode15sR;
import org.mechservice.solver.ode.suite.HeatRod;
import org.mechservice.solver.ode.suite.Run;

/** A problem wrapped around another keeps what that one tells of itself. */
class SystemPartsTest {
  private static final int N = 40;

  /** A rod with a source of heat that jumps at t = 1; its band is that of the rod. */
  private static final class HeatedRod implements OdeSystem, PiecewiseSystem {
    private final HeatRod rod = new HeatRod(N);

    @Override
    public int dimension() {
      return N;
    }

    @Override
    public void derivative(double t, double[] y, double[] yDot) {
      rod.derivative(t, y, yDot);
      for (int i = 0; i < N; i++) {
        yDot[i] += t < 1 ? 1 : 0;
      }
    }

    @Override
    public List<Double> breakpoints() {
      return List.of(1.0);
    }

    @Override
    public <T> Optional<T> part(Class<T> kind) {
      return kind.isInstance(this) ? Optional.of(kind.cast(this)) : rod.part(kind);
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
    Counted counted = new Counted(new HeatedRod());
    Run plain = Run.of(new Ode15s(settings), new HeatedRod(), 0, ones(), 2);
    Run wrapped = Run.of(new Ode15s(settings), counted, 0, ones(), 2);
    assertThat(wrapped.atEnd()).isEqualTo(plain.atEnd());
    assertThat(wrapped.statistics()).isEqualTo(plain.statistics());
    assertThat(counted.count).isEqualTo(plain.statistics().evaluations());
  }

  @Test
  void residualMadeOfAnotherProblemIsDifferencedByItsBand() {
    Ode15sR integrator = new Ode15sR(new IntegratorSettings(1e-6, 1e-9));
    integrator.start(new CountedResidual(new HeatedRod()), 0, ones(), new double[N], 0.5);
    // y' and y in three groups of columns each, and F itself, instead of N + 1 evaluations.
    assertThat(integrator.statistics().evaluations()).isLessThan(N);
  }
}
