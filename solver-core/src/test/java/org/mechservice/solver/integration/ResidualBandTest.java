package org.mechservice.solver.integration;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import org.assertj.core.data.Offset;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.mechservice.solver.integration.IntegratorSettings.Mode;

/** In residual form a band gives what the full matrix gives, at the cost of its diagonals. */
class ResidualBandTest {
  private static final int UNKNOWNS = 100;
  private static final double END = 0.5;

  /** Equations of a line discretised in space, their band, and consistent values to start from. */
  private enum Line {
    /** Burgers' equation by linear finite elements, whose mass matrix is a band, too. */
    FINITE_ELEMENTS(1, 1) {
      @Override
      void residual(double[] y, double[] yDot, double[] f) {
        for (int i = 0; i < UNKNOWNS; i++) {
          double before = at(i - 1, y);
          double after = at(i + 1, y);
          double inertia = (at(i - 1, yDot) + 4 * yDot[i] + at(i + 1, yDot)) / 6;
          double flow = (after - before) * (before + y[i] + after) / 6;
          double friction = 0.01 * (before - 2 * y[i] + after) / WIDTH;
          f[i] = WIDTH * inertia + flow - friction;
        }
      }

      @Override
      double initial(int i) {
        return StrictMath.sin(Math.PI * (i + 1) * WIDTH);
      }
    },

    /** Density and pressure of each cell in turn; the pressure has no derivative. */
    POROUS_MEDIUM(1, 3) {
      @Override
      void residual(double[] y, double[] yDot, double[] f) {
        for (int i = 0; i < UNKNOWNS; i += 2) {
          double before = i == 0 ? y[1] : y[i - 1];
          double after = i == UNKNOWNS - 2 ? y[i + 1] : y[i + 3];
          f[i] = yDot[i] - 25 * (before - 2 * y[i + 1] + after);
          f[i + 1] = y[i + 1] - y[i] * y[i];
        }
      }

      @Override
      double initial(int i) {
        double density = 1 + StrictMath.sin(0.1 * (i - i % 2));
        return i % 2 == 0 ? density : density * density;
      }
    };

    private static final double WIDTH = 1.0 / (UNKNOWNS + 1);

    private final int lower;
    private final int upper;

    Line(int lower, int upper) {
      this.lower = lower;
      this.upper = upper;
    }

    abstract void residual(double[] y, double[] yDot, double[] f);

    abstract double initial(int component);

    int diagonals() {
      return lower + upper + 1;
    }

    Implicit full() {
      return new Implicit(UNKNOWNS, (t, y, yDot, f) -> residual(y, yDot, f));
    }

    Implicit banded() {
      return new Band(full(), lower, upper);
    }

    double[] start() {
      double[] y = new double[UNKNOWNS];
      for (int i = 0; i < y.length; i++) {
        y[i] = initial(i);
      }
      return y;
    }

    /** Zero outside of the line. */
    static double at(int i, double[] y) {
      return i < 0 || i == UNKNOWNS ? 0 : y[i];
    }
  }

  /** A problem that declares its band. */
  private static final class Band extends Implicit implements BandedSystem {
    private final int lower;
    private final int upper;

    Band(Implicit problem, int lower, int upper) {
      super(problem.dimension(), problem::residual);
      this.lower = lower;
      this.upper = upper;
    }

    @Override
    public int lowerBandwidth() {
      return lower;
    }

    @Override
    public int upperBandwidth() {
      return upper;
    }
  }

  /** y_i' = y_{i−1} − 2 y_i + y_{i+1} of a band, and its derivatives where the band has them. */
  private static final class KnownBand extends Implicit
      implements BandedSystem, ResidualJacobianSystem {
    KnownBand() {
      super(
          UNKNOWNS,
          (t, y, yDot, f) -> {
            for (int i = 0; i < UNKNOWNS; i++) {
              f[i] = yDot[i] - Line.at(i - 1, y) + 2 * y[i] - Line.at(i + 1, y);
            }
          });
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
    public void jacobians(double t, double[] y, double[] yDot, double[] fy, double[] fyDot) {
      for (int i = 0; i < UNKNOWNS; i++) {
        fy[3 * i] = -1;
        fy[3 * i + 1] = 2;
        fy[3 * i + 2] = -1;
        fyDot[3 * i + 1] = 1;
      }
    }
  }

  private static Ode15sR integrate(ResidualSystem system, double[] start, Mode mode) {
    IntegratorSettings settings = new IntegratorSettings(1e-6, 1e-6).withMode(mode);
    Ode15sR integrator = new Ode15sR(settings);
    StepResult result = integrator.start(system, 0, start, new double[UNKNOWNS], END);
    while (result == StepResult.ADVANCED) {
      result = integrator.step();
    }
    assertThat(result).isEqualTo(StepResult.REACHED_END);
    return integrator;
  }

  private static double[] end(Ode15sR integrator) {
    return Run.state(integrator, END, UNKNOWNS);
  }

  private static Residual counted(ResidualSystem system) {
    return new Residual(system, new Manifold(system), () -> false);
  }

  private static StoredLinearisation linearisation(ResidualSystem system, Residual residual) {
    double[] smallSizes = new double[UNKNOWNS];
    Arrays.fill(smallSizes, 1e-3);
    residual.breakpoints().begin(system, 0, END);
    return new StoredLinearisation(system, residual, smallSizes);
  }

  /** The derivatives at the start, in what they make of a right-hand side. */
  private static double[] solution(
      StoredLinearisation linearisation, Line line, double formedFor, double hGamma) {
    double[] slope = new double[UNKNOWNS];
    assertThat(linearisation.form(0, line.start(), slope)).isEqualTo(Attempt.PASSED);
    if (formedFor != 0) {
      assertThat(linearisation.formMatrix(0, line.start(), slope, formedFor))
          .isEqualTo(Attempt.PASSED);
    }
    assertThat(linearisation.factor(hGamma)).isTrue();
    double[] r = line.start();
    linearisation.solve(hGamma, r);
    return r;
  }

  @ParameterizedTest
  @EnumSource(Line.class)
  void derivativesAreThoseOfTheFullMatrix(Line line) {
    for (double hGamma : new double[] {1e-4, 1, 0}) {
      double[] dense = solution(linearisation(line.full(), counted(line.full())), line, 0, hGamma);
      Implicit band = line.banded();
      double[] banded = solution(linearisation(band, counted(band)), line, 0, hGamma);
      assertThat(banded).containsExactly(dense, roundOff(dense));
    }
  }

  @ParameterizedTest
  @EnumSource(Line.class)
  void derivativesAlongTheStepAreThoseOfTheFullMatrix(Line line) {
    double[] dense = solution(linearisation(line.full(), counted(line.full())), line, 1e-3, 2e-3);
    Implicit band = line.banded();
    double[] banded = solution(linearisation(band, counted(band)), line, 1e-3, 2e-3);
    assertThat(banded).containsExactly(dense, roundOff(dense));
  }

  /** The same operations but for zeros, and interchanges that come in another order. */
  private static Offset<Double> roundOff(double[] x) {
    double size = Arrays.stream(x).map(Math::abs).max().orElse(0);
    return within(1e-12 * size);
  }

  @ParameterizedTest
  @EnumSource(Line.class)
  void derivativesTakeTwoEvaluationsPerDiagonal(Line line) {
    Implicit band = line.banded();
    Residual residual = counted(band);
    linearisation(band, residual).form(0, line.start(), new double[UNKNOWNS]);
    assertThat(residual.evaluations()).isEqualTo(1 + 2 * line.diagonals());
  }

  @ParameterizedTest
  @EnumSource(Line.class)
  void derivativesAlongTheStepTakeOneEvaluationPerDiagonal(Line line) {
    Implicit band = line.banded();
    Residual residual = counted(band);
    linearisation(band, residual).formMatrix(0, line.start(), new double[UNKNOWNS], 1e-3);
    assertThat(residual.evaluations()).isEqualTo(1 + line.diagonals());
  }

  @ParameterizedTest
  @EnumSource(Line.class)
  void trajectoryIsThatOfTheFullMatrix(Line line) {
    Ode15sR dense = integrate(line.full(), line.start(), Mode.STANDARD);
    Ode15sR banded = integrate(line.banded(), line.start(), Mode.STANDARD);
    assertThat(banded.statistics().steps()).isEqualTo(dense.statistics().steps());
    assertThat(end(banded)).containsExactly(end(dense), roundOff(end(dense)));
  }

  @ParameterizedTest
  @EnumSource(Line.class)
  void runSparesTheColumnsThatShareAnEvaluation(Line line) {
    IntegrationStatistics dense = integrate(line.full(), line.start(), Mode.FAITHFUL).statistics();
    IntegrationStatistics banded =
        integrate(line.banded(), line.start(), Mode.FAITHFUL).statistics();
    long spared = 2L * (UNKNOWNS - line.diagonals()) * dense.jacobians();
    assertThat(banded.evaluations()).isEqualTo(dense.evaluations() - spared);
  }

  @Test
  void knownDerivativesAreWrittenToTheirPlacesInTheBand() {
    double[] start = Line.FINITE_ELEMENTS.start();
    double[] banded = end(integrate(new KnownBand(), start, Mode.STANDARD));
    // The start is the slowest mode: it dies out with its own rate, 2 − 2 cos(π/101).
    double rate = 2 - 2 * StrictMath.cos(Math.PI * Line.WIDTH);
    for (int i = 0; i < UNKNOWNS; i++) {
      assertThat(banded[i]).isCloseTo(start[i] * StrictMath.exp(-rate * END), within(1e-6));
    }
  }

  @Test
  void bandWiderThanTheMatrixIsRefused() {
    Band tooWide = new Band(new Implicit(1, (t, y, yDot, f) -> f[0] = yDot[0]), 1, 0);
    assertThatIllegalArgumentException()
        .isThrownBy(
            () ->
                new Ode15sR(new IntegratorSettings(1e-6, 1e-6))
                    .start(tooWide, 0, new double[] {1}, new double[1], 1))
        .withMessageContaining("number of diagonals below the main one is 1");
  }
}
