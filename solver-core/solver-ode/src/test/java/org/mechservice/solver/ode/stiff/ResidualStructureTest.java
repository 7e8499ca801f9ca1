package org.mechservice.solver.ode.stiff;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.Optional;
import org.assertj.core.data.Offset;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.mechservice.solver.ode.BandedSystem;
import org.mechservice.solver.ode.IntegrationStatistics;
import org.mechservice.solver.ode.IntegratorSettings;
import org.mechservice.solver.ode.IntegratorSettings.Mode;
import org.mechservice.solver.ode.ResidualJacobianSystem;
import org.mechservice.solver.ode.ResidualSystem;
import org.mechservice.solver.ode.SparseSystem;
import org.mechservice.solver.ode.StepResult;
import org.mechservice.solver.ode.TrialOutcome;
import org.mechservice.solver.ode.newton.Residual;
import org.mechservice.solver.ode.newton.ResidualJacobians;
import org.mechservice.solver.ode.step.Manifold;
import org.mechservice.solver.ode.suite.HeatRod;
import org.mechservice.solver.ode.suite.ImplicitOde;
import org.mechservice.solver.ode.suite.Run;

/**
 * In residual form a structure declared gives what the full matrix gives, for fewer evaluations.
 */
class ResidualStructureTest {
  private static final int UNKNOWNS = 100;
  private static final double END = 0.5;

  /** Equations discretised in space, their structure, and consistent values to start from. */
  private enum Problem {
    /** Burgers' equation by linear finite elements, whose mass matrix is a band, too. */
    FINITE_ELEMENTS(3) {
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

      @Override
      ImplicitOde declared() {
        return new Band(full(), 1, 1);
      }
    },

    /** Density and pressure of each cell in turn; the pressure has no derivative. */
    POROUS_MEDIUM(5) {
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

      @Override
      ImplicitOde declared() {
        return new Band(full(), 1, 3);
      }
    },

    /** A ring, whose last element knows the first: its 100 columns take 4 groups. */
    RING(4) {
      @Override
      void residual(double[] y, double[] yDot, double[] f) {
        for (int i = 0; i < UNKNOWNS; i++) {
          int before = (i + UNKNOWNS - 1) % UNKNOWNS;
          int after = (i + 1) % UNKNOWNS;
          double inertia = (yDot[before] + 4 * yDot[i] + yDot[after]) / 6;
          f[i] = inertia + y[i] * y[i] * y[i] - 50 * (y[before] - 2 * y[i] + y[after]);
        }
      }

      @Override
      double initial(int i) {
        return 1 + StrictMath.sin(2 * Math.PI * i / UNKNOWNS);
      }

      @Override
      ImplicitOde declared() {
        return new Pattern(full(), (i, j) -> (i - j + 1 + UNKNOWNS) % UNKNOWNS <= 2);
      }
    };

    private static final double WIDTH = 1.0 / (UNKNOWNS + 1);

    private final int groups;

    Problem(int groups) {
      this.groups = groups;
    }

    abstract void residual(double[] y, double[] yDot, double[] f);

    abstract double initial(int component);

    /** Returns the problem as one that tells its structure. */
    abstract ImplicitOde declared();

    ImplicitOde full() {
      return new ImplicitOde(UNKNOWNS, (t, y, yDot, f) -> residual(y, yDot, f));
    }

    double[] start() {
      double[] y = new double[UNKNOWNS];
      for (int i = 0; i < y.length; i++) {
        y[i] = initial(i);
      }
      return y;
    }

    /** Zero outside of the problem. */
    static double at(int i, double[] y) {
      return i < 0 || i == UNKNOWNS ? 0 : y[i];
    }
  }

  /** A problem that declares its band. */
  private static final class Band extends ImplicitOde implements BandedSystem {
    private final int lower;
    private final int upper;

    Band(ImplicitOde problem, int lower, int upper) {
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

  /** A problem that declares which components each equation has. */
  private static final class Pattern extends ImplicitOde implements SparseSystem {
    private final SparseSystem coupled;

    Pattern(ImplicitOde problem, SparseSystem coupled) {
      super(problem.dimension(), problem::residual);
      this.coupled = coupled;
    }

    @Override
    public boolean couples(int equation, int component) {
      return coupled.couples(equation, component);
    }
  }

  /** A rod in residual form with its band, and its derivatives where the band has them. */
  private static final class KnownRod implements ResidualJacobianSystem {
    private final HeatRod rod = new HeatRod(UNKNOWNS);

    @Override
    public int dimension() {
      return UNKNOWNS;
    }

    @Override
    public void residual(double t, double[] y, double[] yDot, double[] residual) {
      rod.derivative(t, y, residual);
      for (int i = 0; i < UNKNOWNS; i++) {
        residual[i] = yDot[i] - residual[i];
      }
    }

    @Override
    public void jacobians(double t, double[] y, double[] yDot, double[] fy, double[] fyDot) {
      double conduction = (UNKNOWNS + 1.0) * (UNKNOWNS + 1.0);
      for (int i = 0; i < UNKNOWNS; i++) {
        fy[3 * i] = -conduction;
        fy[3 * i + 1] = 2 * conduction;
        fy[3 * i + 2] = -conduction;
        fyDot[3 * i + 1] = 1;
      }
    }

    @Override
    public <T> Optional<T> part(Class<T> kind) {
      return kind.isInstance(this) ? Optional.of(kind.cast(this)) : rod.part(kind);
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

  private static ResidualJacobians linearisation(ResidualSystem system, Residual residual) {
    double[] smallSizes = new double[UNKNOWNS];
    Arrays.fill(smallSizes, 1e-3);
    residual.breakpoints().begin(system, 0, END);
    return new ResidualJacobians(system, residual, smallSizes);
  }

  /** The derivatives at the start, in what they make of a right-hand side. */
  private static double[] solution(
      ResidualJacobians linearisation, Problem problem, double formedFor, double hGamma) {
    double[] slope = new double[UNKNOWNS];
    assertThat(linearisation.form(0, problem.start(), slope)).isEqualTo(TrialOutcome.PASSED);
    if (formedFor != 0) {
      assertThat(linearisation.formMatrix(0, problem.start(), slope, formedFor))
          .isEqualTo(TrialOutcome.PASSED);
    }
    assertThat(linearisation.factor(hGamma)).isTrue();
    double[] r = problem.start();
    linearisation.solve(hGamma, r);
    return r;
  }

  @ParameterizedTest
  @EnumSource(Problem.class)
  void derivativesAreThoseOfTheFullMatrix(Problem problem) {
    for (double hGamma : new double[] {1e-4, 1, 0}) {
      double[] full =
          solution(linearisation(problem.full(), counted(problem.full())), problem, 0, hGamma);
      ImplicitOde declared = problem.declared();
      double[] sparing = solution(linearisation(declared, counted(declared)), problem, 0, hGamma);
      assertThat(sparing).containsExactly(full, roundOff(full));
    }
  }

  @ParameterizedTest
  @EnumSource(Problem.class)
  void derivativesAlongTheStepAreThoseOfTheFullMatrix(Problem problem) {
    double[] full =
        solution(linearisation(problem.full(), counted(problem.full())), problem, 1e-3, 2e-3);
    ImplicitOde declared = problem.declared();
    double[] sparing = solution(linearisation(declared, counted(declared)), problem, 1e-3, 2e-3);
    assertThat(sparing).containsExactly(full, roundOff(full));
  }

  /** The same operations but for zeros, and interchanges that come in another order. */
  private static Offset<Double> roundOff(double[] x) {
    double size = Arrays.stream(x).map(Math::abs).max().orElse(0);
    return within(1e-12 * size);
  }

  @ParameterizedTest
  @EnumSource(Problem.class)
  void derivativesTakeTwoEvaluationsPerGroup(Problem problem) {
    ImplicitOde declared = problem.declared();
    Residual residual = counted(declared);
    linearisation(declared, residual).form(0, problem.start(), new double[UNKNOWNS]);
    assertThat(residual.evaluations()).isEqualTo(1 + 2 * problem.groups);
  }

  @ParameterizedTest
  @EnumSource(Problem.class)
  void derivativesAlongTheStepTakeOneEvaluationPerGroup(Problem problem) {
    ImplicitOde declared = problem.declared();
    Residual residual = counted(declared);
    linearisation(declared, residual).formMatrix(0, problem.start(), new double[UNKNOWNS], 1e-3);
    assertThat(residual.evaluations()).isEqualTo(1 + problem.groups);
  }

  @ParameterizedTest
  @EnumSource(Problem.class)
  void trajectoryIsThatOfTheFullMatrix(Problem problem) {
    Ode15sR full = integrate(problem.full(), problem.start(), Mode.STANDARD);
    Ode15sR sparing = integrate(problem.declared(), problem.start(), Mode.STANDARD);
    assertThat(sparing.statistics().steps()).isEqualTo(full.statistics().steps());
    assertThat(end(sparing)).containsExactly(end(full), roundOff(end(full)));
  }

  @ParameterizedTest
  @EnumSource(Problem.class)
  void runSparesTheColumnsThatShareAnEvaluation(Problem problem) {
    IntegrationStatistics full =
        integrate(problem.full(), problem.start(), Mode.FAITHFUL).statistics();
    IntegrationStatistics sparing =
        integrate(problem.declared(), problem.start(), Mode.FAITHFUL).statistics();
    long spared = 2L * (UNKNOWNS - problem.groups) * full.jacobians();
    // Fewer where changes are lost in round-off: the second differences are shared as well.
    assertThat(sparing.evaluations()).isLessThanOrEqualTo(full.evaluations() - spared);
    assertThat(sparing.jacobians()).isEqualTo(full.jacobians());
  }

  @Test
  void knownDerivativesAreWrittenToTheirPlacesInTheBand() {
    HeatRod rod = new HeatRod(UNKNOWNS);
    double[] end = end(integrate(new KnownRod(), rod.initialState(), Mode.STANDARD));
    assertThat(end).containsExactly(rod.at(END), within(1e-6));
  }

  @Test
  void bandWiderThanTheMatrixIsRefused() {
    Band tooWide = new Band(new ImplicitOde(1, (t, y, yDot, f) -> f[0] = yDot[0]), 1, 0);
    assertThatIllegalArgumentException()
        .isThrownBy(
            () ->
                new Ode15sR(new IntegratorSettings(1e-6, 1e-6))
                    .start(tooWide, 0, new double[] {1}, new double[1], 1))
        .withMessageContaining("number of diagonals below the main one is 1");
  }
}
