package org.mechservice.solver.ode.stiff;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.mechservice.solver.linear.DenseLu;
import org.mechservice.solver.linear.LinearSolver;
import org.mechservice.solver.ode.Integrator;
import org.mechservice.solver.ode.IntegratorSettings;
import org.mechservice.solver.ode.IntegratorSettings.Mode;
import org.mechservice.solver.ode.LinearisedSystem;
import org.mechservice.solver.ode.StepResult;
import org.mechservice.solver.ode.suite.Brusselator;
import org.mechservice.solver.ode.suite.Hires;
import org.mechservice.solver.ode.suite.Run;
import org.mechservice.solver.ode.suite.StiffChain;
import org.mechservice.solver.ode.suite.StiffVanDerPol;
import org.mechservice.solver.ode.suite.SuiteProblem;
import org.mechservice.solver.ode.suite.VerifiedValues;

/**
 * Systems that bring their own linear algebra, as mechanisms do, none of whose states is algebraic.
 */
class UserLinearisationTest {
  /** y' = f(t, y) times a full matrix, which stands for the mass matrix; it counts its factors. */
  private static final class Multiplied implements LinearisedSystem {
    final SuiteProblem problem;
    final boolean keepsDerivative;
    final int n;
    private final LinearSolver solver;
    private final LinearSolver mass;
    private final double[] fy;
    private final double[] fyDot;
    private final double[] rate;
    private final double[] moved;
    int factorisations;
    private int singular;

    Multiplied(SuiteProblem problem, boolean keepsDerivative) {
      this.problem = problem;
      this.keepsDerivative = keepsDerivative;
      n = problem.dimension();
      solver = new DenseLu(n);
      mass = new DenseLu(n);
      fy = new double[n * n];
      fyDot = new double[n * n];
      rate = new double[n];
      moved = new double[n];
      for (int i = 0; i < n; i++) {
        for (int j = 0; j < n; j++) {
          fyDot[n * i + j] = i == j ? 2 : 1.0 / (1 + i + n * j);
        }
      }
      assertThat(mass.factor(fyDot)).isEqualTo(LinearSolver.NONSINGULAR);
    }

    @Override
    public int dimension() {
      return n;
    }

    @Override
    public void residual(double t, double[] y, double[] yDot, double[] residual) {
      problem.derivative(t, y, rate);
      Arrays.fill(residual, 0);
      for (int i = 0; i < n; i++) {
        for (int j = 0; j < n; j++) {
          residual[i] += fyDot[n * i + j] * (yDot[j] - rate[j]);
        }
      }
    }

    @Override
    public boolean linearise(double t, double[] y, double[] yDot) {
      double[] at = y.clone();
      double[] value = new double[n];
      residual(t, y, yDot, value);
      for (int j = 0; j < n; j++) {
        double step = 1e-8 * Math.max(1e-3, Math.abs(y[j]));
        at[j] = y[j] + step;
        residual(t, at, yDot, moved);
        at[j] = y[j];
        for (int i = 0; i < n; i++) {
          fy[n * i + j] = (moved[i] - value[i]) / step;
        }
      }
      return true;
    }

    @Override
    public boolean factor(double hGamma) {
      factorisations++;
      double[] matrix = new double[n * n];
      Arrays.setAll(matrix, i -> hGamma * fy[i] + fyDot[i]);
      singular = solver.factor(matrix);
      return singular == LinearSolver.NONSINGULAR;
    }

    @Override
    public void solve(double[] r) {
      solver.solve(r);
    }

    @Override
    public boolean solveForDerivative(double[] r) {
      if (keepsDerivative) {
        mass.solve(r);
      }
      return keepsDerivative;
    }

    @Override
    public int singularComponent() {
      return singular;
    }
  }

  static Stream<Arguments> runs() {
    return Stream.of(new Hires(), new StiffVanDerPol(), new StiffChain(), new Brusselator())
        .flatMap(problem -> Stream.of(1e-4, 1e-6).map(rtol -> Arguments.of(problem, rtol)));
  }

  private static Ode15sR run(Multiplied system, double tolerance) {
    return run(system, Run.settings(system.problem, tolerance));
  }

  private static Ode15sR run(Multiplied system, IntegratorSettings settings) {
    VerifiedValues reference = system.problem.reference();
    double[] yDot = new double[system.n];
    system.problem.derivative(0, reference.initialState(), yDot);
    Ode15sR integrator = new Ode15sR(settings);
    StepResult result =
        integrator.start(system, 0, reference.initialState(), yDot, reference.end());
    while (result == StepResult.ADVANCED) {
      result = integrator.step();
    }
    assertThat(result).isEqualTo(StepResult.REACHED_END);
    return integrator;
  }

  private static double digits(Multiplied system, Integrator integrator) {
    VerifiedValues reference = system.problem.reference();
    double[] end = Run.state(integrator, reference.end(), system.n);
    return reference.mixedDigits(end, reference.atEnd());
  }

  @MethodSource("runs")
  @ParameterizedTest
  void whatAStepLeavesIsJudgedWithoutFurtherFactors(SuiteProblem problem, double tolerance) {
    Multiplied system = new Multiplied(problem, true);
    Ode15sR integrator = run(system, tolerance);
    assertThat((long) system.factorisations).isEqualTo(integrator.statistics().factorisations());
  }

  @MethodSource("runs")
  @ParameterizedTest
  void stepsAreTheSameWhetherTheDerivativeIsKeptByItselfOrNot(
      SuiteProblem problem, double tolerance) {
    Multiplied kept = new Multiplied(problem, true);
    Multiplied not = new Multiplied(problem, false);
    assertThat(run(kept, tolerance).statistics()).isEqualTo(run(not, tolerance).statistics());
    assertThat(not.factorisations).isGreaterThanOrEqualTo(kept.factorisations);
  }

  /**
   * In the faithful mode, what differs from the explicit form is only which equations are iterated;
   * in the others the explicit form also renews its derivatives earlier.
   */
  @MethodSource("runs")
  @ParameterizedTest
  void iterationsAreAsFewAsInTheExplicitForm(SuiteProblem problem, double tolerance) {
    Multiplied system = new Multiplied(problem, true);
    IntegratorSettings settings = Run.settings(system.problem, tolerance).withMode(Mode.FAITHFUL);
    Ode15sR residual = run(system, settings);
    Ode15s explicit = new Ode15s(settings);
    VerifiedValues reference = problem.reference();
    StepResult result = explicit.start(problem, 0, reference.initialState(), reference.end());
    while (result == StepResult.ADVANCED) {
      result = explicit.step();
    }
    assertThat(digits(system, residual)).isGreaterThan(digits(system, explicit) - 0.5);
    assertThat((double) residual.statistics().solutions())
        .isLessThanOrEqualTo(1.1 * explicit.statistics().solutions());
  }
}
