package org.mechservice.study.optimise;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** Known optima are found by every method, and nothing that happens on the way is lost. */
class OptimiserTest {
  private static final OptimiserSettings SETTINGS = OptimiserSettings.DEFAULT;

  /** Rosenbrock 1960: least at (1, 1), at the end of a bent valley. */
  private static double rosenbrock(double[] x) {
    return 100 * Math.pow(x[1] - x[0] * x[0], 2) + Math.pow(1 - x[0], 2);
  }

  private static final List<DesignVariable> PLANE =
      List.of(new DesignVariable("x", -2, 2, -1.2), new DesignVariable("y", -2, 2, 1));

  private static DesignProblem minimise(Response response, Aim... constraints) {
    List<Aim> aims = new ArrayList<>(List.of(new Aim(Aim.Kind.MINIMISE, "f")));
    aims.addAll(List.of(constraints));
    return new DesignProblem(PLANE, aims, response);
  }

  /** Central differences with steps of 4e-4 bend the valley by about h² f'''/6 = 6e-5. */
  @ParameterizedTest
  @EnumSource(names = {"SQP", "BOBYQA", "CMAES"})
  void valleyOfRosenbrockIsFollowedToItsEnd(Method method) throws Exception {
    DesignProblem problem = minimise(x -> new double[] {rosenbrock(x)});
    Optimum optimum =
        Optimiser.minimise(
            problem, new OptimiserSettings(method, 1, 1, 8000, 1e-4, OptionalDouble.empty(), 1));
    assertThat(optimum.best().point()).containsExactly(new double[] {1, 1}, within(2e-3));
    assertThat(optimum.best().objective()).isLessThan(1e-6);
  }

  @Test
  void residualsOfRosenbrockVanish() throws Exception {
    DesignProblem problem =
        new DesignProblem(
            PLANE,
            List.of(new Aim(Aim.Kind.RESIDUAL, "a"), new Aim(Aim.Kind.RESIDUAL, "b")),
            x -> new double[] {10 * (x[1] - x[0] * x[0]), 1 - x[0]});
    Optimum optimum = Optimiser.minimise(problem, SETTINGS);
    assertThat(optimum.method()).isEqualTo(Method.LM);
    assertThat(optimum.best().point()).containsExactly(new double[] {1, 1}, within(1e-6));
    assertThat(optimum.runs()).isLessThan(200);
  }

  /** The least x + y on the disc x² + y² <= 2 is at (-1, -1), with f = -2. */
  @ParameterizedTest
  @EnumSource(names = {"SQP", "BOBYQA", "CMAES"})
  void constraintsHoldWhereTheObjectivePressesAgainstThem(Method method) throws Exception {
    DesignProblem problem =
        minimise(
            x -> new double[] {x[0] + x[1], x[0] * x[0] + x[1] * x[1] - 2},
            new Aim(Aim.Kind.AT_MOST_ZERO, "disc", 2));
    Optimum optimum =
        Optimiser.minimise(
            problem, new OptimiserSettings(method, 1, 1, 30000, 1e-4, OptionalDouble.empty(), 1));
    assertThat(optimum.best().isFeasible()).isTrue();
    assertThat(optimum.best().point()).containsExactly(new double[] {-1, -1}, within(2e-3));
    assertThat(optimum.best().objective()).isCloseTo(-2, within(1e-5));
    assertThat(optimum.isActive(1)).isTrue();
    assertThat(optimum.isActive(0)).isFalse();
  }

  /** x² + y² on the line x + y = 1 is least at (1/2, 1/2). */
  @ParameterizedTest
  @EnumSource(names = {"SQP", "BOBYQA"})
  void equationsHold(Method method) throws Exception {
    DesignProblem problem =
        minimise(
            x -> new double[] {x[0] * x[0] + x[1] * x[1], x[0] + x[1] - 1},
            new Aim(Aim.Kind.ZERO, "line", 1));
    Optimum optimum = Optimiser.minimise(problem, SETTINGS.with(method));
    assertThat(optimum.best().point()).containsExactly(new double[] {0.5, 0.5}, within(1e-4));
  }

  /** The optimum beyond a bound is at the bound. */
  @ParameterizedTest
  @EnumSource(names = {"SQP", "BOBYQA", "CMAES"})
  void boundsHoldAndAreNamed(Method method) throws Exception {
    DesignProblem problem =
        minimise(x -> new double[] {Math.pow(x[0] - 5, 2) + Math.pow(x[1] - 0.5, 2)});
    Optimum optimum = Optimiser.minimise(problem, SETTINGS.with(method));
    assertThat(optimum.best().point()).containsExactly(new double[] {2, 0.5}, within(1e-4));
    assertThat(optimum.bound(0)).isEqualTo(1);
    assertThat(optimum.bound(1)).isZero();
  }

  /** On the unit cube such a start is 0, which is no measure of a step. */
  @Test
  void leastSquaresLeaveAStartAtTheLowerBounds() throws Exception {
    DesignProblem problem =
        new DesignProblem(
            List.of(new DesignVariable("x", -2, 2, -2), new DesignVariable("y", -2, 2, -2)),
            List.of(new Aim(Aim.Kind.RESIDUAL, "a"), new Aim(Aim.Kind.RESIDUAL, "b")),
            x -> new double[] {10 * (x[1] - x[0] * x[0]), 1 - x[0]});
    Optimum optimum = Optimiser.minimise(problem, SETTINGS);
    assertThat(optimum.best().point()).containsExactly(new double[] {1, 1}, within(1e-6));
    assertThat(optimum.runs()).isLessThan(200);
  }

  @Test
  void leastSquaresHoldBoundsToo() throws Exception {
    DesignProblem problem =
        new DesignProblem(
            PLANE,
            List.of(
                new Aim(Aim.Kind.RESIDUAL, "a"),
                new Aim(Aim.Kind.RESIDUAL, "b"),
                new Aim(Aim.Kind.RESIDUAL, "c")),
            x -> new double[] {x[0] - 5, x[1] - 0.5, x[0] - 2 * x[1]});
    Optimum optimum = Optimiser.minimise(problem, SETTINGS);
    // With x = 2: (y - 0.5) + 2 (2 y - 2) = 0.
    assertThat(optimum.best().point()).containsExactly(new double[] {2, 0.9}, within(1e-6));
    assertThat(optimum.bound(0)).isEqualTo(1);
  }

  @Test
  void oneVariableIsEnough() throws Exception {
    for (Method method : List.of(Method.BOBYQA, Method.SQP, Method.CMAES)) {
      DesignProblem problem =
          new DesignProblem(
              List.of(DesignVariable.between("c", 0, 10)),
              List.of(new Aim(Aim.Kind.MINIMISE, "f")),
              x -> new double[] {Math.cosh(x[0] - 3)});
      Optimum optimum = Optimiser.minimise(problem, SETTINGS.with(method));
      assertThat(optimum.best().point()[0]).as(method.label()).isCloseTo(3, within(1e-3));
    }
  }

  /** sin has its least value in [0, 20] three times; the slope makes the last one the lowest. */
  @Test
  void severalStartsFindTheLowestOfSeveralMinimaWhateverTheThreads() throws Exception {
    DesignProblem problem =
        new DesignProblem(
            List.of(new DesignVariable("x", 0, 20, 1), new DesignVariable("y", -1, 1, 0.5)),
            List.of(new Aim(Aim.Kind.MINIMISE, "f")),
            x -> new double[] {Math.sin(x[0]) - 0.02 * x[0] + x[1] * x[1]});
    OptimiserSettings one =
        new OptimiserSettings(Method.BOBYQA, 12, 7, 500, 1e-4, OptionalDouble.empty(), 1);
    OptimiserSettings two =
        new OptimiserSettings(Method.BOBYQA, 12, 7, 500, 1e-4, OptionalDouble.empty(), 2);
    Optimum optimum = Optimiser.minimise(problem, one);
    assertThat(optimum.best().point()[0]).isCloseTo(5.5 * Math.PI + 0.02, within(1e-3));
    assertThat(Optimiser.minimise(problem, two).best().point()).isEqualTo(optimum.best().point());
  }

  @Test
  void pointThatFailsEndsTheStartUnlessItsObjectiveIsGiven() throws Exception {
    Response holed =
        x -> {
          if (x[0] > 0.5) {
            throw new PointFailedException("N-013 no convergence");
          }
          return new double[] {Math.pow(x[0] - 0.4, 2) + x[1] * x[1]};
        };
    Optimum stopped = Optimiser.minimise(minimise(holed), SETTINGS.with(Method.CMAES));
    assertThat(stopped.starts().get(0).ended().orElse("")).contains("x=", "N-013 no convergence");

    OptimiserSettings goingOn =
        new OptimiserSettings(Method.CMAES, 1, 1, 3000, 1e-4, OptionalDouble.of(100), 1);
    Optimum optimum = Optimiser.minimise(minimise(holed), goingOn);
    assertThat(optimum.best().point()).containsExactly(new double[] {0.4, 0}, within(1e-3));
    assertThat(optimum.failures()).isPositive();
    assertThat(optimum.history())
        .filteredOn(trial -> trial.failure().isPresent())
        .allMatch(trial -> trial.objective() == 100);
  }

  @Test
  void whatCannotBeAskedIsRefused() {
    DesignProblem constrained =
        minimise(x -> new double[] {x[0], x[1]}, new Aim(Aim.Kind.AT_MOST_ZERO, "y"));
    assertThatThrownBy(() -> Optimiser.minimise(constrained, SETTINGS.with(Method.LM)))
        .hasMessageContaining("lm needs residuals");
    assertThatThrownBy(() -> new DesignVariable("c", 2, 1, 1.5))
        .hasMessageContaining("the bounds of c are 2.0 and 1.0");
    assertThatThrownBy(() -> new DesignVariable("c", 0, 1, 3))
        .hasMessageContaining("start value 3.0 of c");
    DesignProblem nowhere =
        minimise(
            x -> {
              throw new PointFailedException("N-001 never");
            });
    assertThatThrownBy(() -> Optimiser.minimise(nowhere, SETTINGS))
        .isInstanceOf(PointFailedException.class)
        .hasMessageContaining("N-001 never");
  }

  /** Schittkowski's subproblem has no end where constraints have no common point. */
  @Test
  void searchWithoutFeasiblePointEnds() throws Exception {
    DesignProblem problem =
        minimise(
            x -> new double[] {1000 * x[0], 3 + x[1] * x[1]},
            new Aim(Aim.Kind.AT_MOST_ZERO, "3 + y² <= 0", 3));
    Optimum optimum = Optimiser.minimise(problem, SETTINGS.with(Method.SQP));
    assertThat(optimum.best().isFeasible()).isFalse();
    assertThat(optimum.best().point()[1]).isCloseTo(0, within(0.05));
    assertThat(optimum.runs()).isLessThan(500);
  }

  /** A start outside is moved to where the constraints hold, and the search goes on from there. */
  @Test
  void startOutsideTheConstraintsIsMovedInside() throws Exception {
    DesignProblem problem =
        minimise(
            x -> new double[] {1e4 * rosenbrock(x), 1.5 + x[0], x[1] * x[1] - 0.25},
            new Aim(Aim.Kind.AT_MOST_ZERO, "x <= -1.5"),
            new Aim(Aim.Kind.AT_MOST_ZERO, "y² <= 1/4"));
    Optimum optimum = Optimiser.minimise(problem, SETTINGS.with(Method.SQP));
    assertThat(optimum.best().isFeasible()).isTrue();
    assertThat(optimum.best().point()).containsExactly(new double[] {-1.5, 0.5}, within(1e-4));
  }
}
