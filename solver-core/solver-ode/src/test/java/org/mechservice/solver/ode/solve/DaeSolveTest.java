package org.mechservice.solver.ode.solve;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.concurrent.atomic.AtomicLong;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.solver.ode.BandedSystem;
import org.mechservice.solver.ode.ResidualSystem;

/** Problems in residual form are solved in one call. */
class DaeSolveTest {
  /** y0' = −y0 and y1 = y0². */
  private static final DaeFunction SQUARE =
      (t, y, yDot, r) -> {
        r[0] = yDot[0] + y[0];
        r[1] = y[1] - y[0] * y[0];
      };

  private static final DaeProblem PROBLEM = Dae.system(2, SQUARE).withAlgebraic(1);

  private static final OdeOptions OPTIONS = OdeOptions.standard().rtol(1e-8).atol(1e-10);

  private static OdeSolution solve(ResidualSystem problem) {
    return Dae.solve(problem, 0, new double[] {1, 0.5}, new double[2], 2, OPTIONS);
  }

  @Test
  void solutionObeysItsEquationsAndStartsConsistently() {
    OdeSolution solution = solve(PROBLEM);
    assertThat(solution.startState()[1]).isCloseTo(1, within(1e-12));
    for (double t = 0; t <= 2; t += 0.1) {
      double[] y = solution.at(t);
      assertThat(y[0]).isCloseTo(StrictMath.exp(-t), within(1e-6));
      assertThat(y[1]).isCloseTo(y[0] * y[0], within(1e-6));
    }
  }

  @Test
  void lambdaIsEnough() {
    OdeSolution solution = Dae.solve(SQUARE, 0, new double[] {1, 1}, new double[2], 2);
    assertThat(solution.endState()[1]).isCloseTo(StrictMath.exp(-4), within(1e-4));
  }

  /**
   * A double pendulum of unit masses and rods, damped in its first hinge: M depends on the angle.
   */
  @Test
  void declaredMovingMassMatrixSavesJacobians() {
    DaeProblem pendulum =
        Dae.system(
            4,
            (t, y, yDot, r) -> {
              double c = StrictMath.cos(y[0] - y[1]);
              double s = StrictMath.sin(y[0] - y[1]);
              r[0] = yDot[0] - y[2];
              r[1] = yDot[1] - y[3];
              r[2] =
                  2 * yDot[2]
                      + c * yDot[3]
                      + s * y[3] * y[3]
                      + 2 * 9.81 * StrictMath.sin(y[0])
                      + 100 * y[2];
              r[3] = c * yDot[2] + yDot[3] - s * y[2] * y[2] + 9.81 * StrictMath.sin(y[1]);
            });
    double[] start = {2, 1, 0, 0};
    OdeSolution plain = Dae.solve(pendulum, 0, start, new double[4], 20, OPTIONS);
    OdeSolution declared =
        Dae.solve(pendulum.withMovingMassMatrix(), 0, start, new double[4], 20, OPTIONS);
    assertThat(declared.statistics().jacobians()).isLessThan(plain.statistics().jacobians());
    // ten times the tolerance of a step, since the damped motion forgets errors
    assertThat(declared.endState()[0]).isCloseTo(plain.endState()[0], within(1e-7));
  }

  @Test
  void movingMassMatrixIsToldOnAndChangesNoSolution() {
    DaeProblem moving = PROBLEM.withMovingMassMatrix().withBand(1, 0).withFunction(f -> f);
    assertThat(moving.massMatrixMoves()).isTrue();
    assertThat(solve(moving).endState()[0]).isCloseTo(StrictMath.exp(-2), within(1e-6));
  }

  @Test
  void backwardsTheSolutionComesToItsStart() {
    double[] end = solve(PROBLEM).endState();
    OdeSolution back = Dae.solve(PROBLEM, 2, end, new double[2], 0, OPTIONS);
    assertThat(back.endState()[0]).isCloseTo(1, within(1e-5));
  }

  @Test
  void derivativesAndTheirProductGiveTheSameBitsAndStayWhenWrapped() {
    AtomicLong count = new AtomicLong();
    DaeProblem known =
        PROBLEM.withJacobians(
            (t, y, yDot, fy, fyDot) -> {
              fy[0] = 1;
              fy[2] = -2 * y[0];
              fy[3] = 1;
              fyDot[0] = 1;
            });
    DaeProblem product =
        PROBLEM.withJacobianProduct(
            (t, y, yDot, v, w, out) -> {
              out[0] = w[0] + v[0];
              out[1] = v[1] - 2 * y[0] * v[0];
            });
    DaeProblem counted =
        product.withFunction(
            f ->
                (t, y, yDot, r) -> {
                  count.incrementAndGet();
                  f.evaluate(t, y, yDot, r);
                });
    OdeSolution analytic = solve(known);
    assertThat(solve(product).endState()).isEqualTo(analytic.endState());
    assertThat(solve(counted).endState()).isEqualTo(analytic.endState());
    assertThat(count.get()).isEqualTo(analytic.statistics().evaluations());
    assertThat(analytic.statistics().evaluations())
        .isLessThan(solve(PROBLEM).statistics().evaluations());
  }

  @Test
  void systemOfAnotherClassKeepsItsPartsInsideAProblem() {
    DaeProblem outer = Dae.system((ResidualSystem) PROBLEM.withBand(1, 0)).withBreakpoints(0.5);
    assertThat(outer.part(BandedSystem.class)).isPresent();
    assertThat(outer.component(1)).isEqualTo(ResidualSystem.Component.ALGEBRAIC);
    assertThat(solve(outer).times()).contains(0.5);
  }

  @Test
  void patternSavesEvaluations() {
    int n = 40;
    DaeProblem chain =
        Dae.system(
            n,
            (t, y, yDot, r) -> {
              for (int i = 0; i < n; i++) {
                r[i] = yDot[i] + 50 * y[i] - (i == 0 ? 0 : y[i - 1]);
              }
            });
    double[] y0 = new double[n];
    y0[0] = 1;
    long full = Dae.solve(chain, 0, y0, new double[n], 1).statistics().evaluations();
    DaeProblem known = chain.withPattern((i, j) -> j == i || j == i - 1);
    long sparse = Dae.solve(known, 0, y0, new double[n], 1).statistics().evaluations();
    long banded =
        Dae.solve(chain.withBand(1, 0), 0, y0, new double[n], 1).statistics().evaluations();
    assertThat(sparse).isLessThan(full);
    assertThat(banded).isEqualTo(sparse);
  }

  @Test
  void eventChangesTheDifferentialPartAndTheRestFollows() {
    OdeEvent half =
        OdeEvent.when((t, y) -> y[0] - 0.5).falling().then((t, y) -> y[0] = 1).terminalAfter(2);
    OdeSolution solution =
        Dae.solve(PROBLEM, 0, new double[] {1, 1}, new double[2], 9, OPTIONS.event(half));
    assertThat(solution.endReason()).isEqualTo(EndReason.EVENT);
    assertThat(solution.end()).isCloseTo(2 * StrictMath.log(2), within(1e-6));
    assertThat(solution.at(1)[1])
        .isCloseTo(StrictMath.exp(-2 * (1 - StrictMath.log(2))), within(1e-5));
  }

  @ParameterizedTest
  @EnumSource(names = {"ODE113", "DE", "ODE15S"})
  void methodsForExplicitProblemsRefuseResiduals(OdeMethod method) {
    assertThatIllegalArgumentException()
        .isThrownBy(
            () -> Dae.solve(PROBLEM, 0, new double[2], new double[2], 1, OPTIONS.method(method)))
        .withMessageContaining(method + " integrates y' = f(t, y) only")
        .withMessageContaining("ODE15SR or AUTO");
  }

  @Test
  void componentDeclaredAlgebraicWhoseDerivativeAppearsIsRefused() {
    assertThatIllegalArgumentException()
        .isThrownBy(() -> solve(PROBLEM.withAlgebraic(0)))
        .withMessageContaining("component 0 is declared ALGEBRAIC");
  }

  /** Of three unknowns only the last is algebraic. */
  @ParameterizedTest
  @ValueSource(strings = {"0", "1", "0 2", "1 2", "0 1 2"})
  void eachWrongDeclarationIsRefused(String declared) {
    int[] components = Arrays.stream(declared.split(" ")).mapToInt(Integer::parseInt).toArray();
    DaeProblem oscillator =
        Dae.system(
                3,
                (t, y, yDot, r) -> {
                  r[0] = yDot[0] + 1e-3 * yDot[1] - y[1];
                  r[1] = yDot[1] + y[0];
                  r[2] = y[2] - y[0] - y[1];
                })
            .withAlgebraic(components);
    assertThatIllegalArgumentException()
        .isThrownBy(
            () ->
                Dae.solve(
                    oscillator, 0, new double[] {1, 0, 0}, new double[3], 1, OdeOptions.standard()))
        .withMessageContaining("component " + components[0] + " is declared ALGEBRAIC")
        .withMessageContaining("at t = 0.0");
  }

  @Test
  void derivativeThatAppearsLaterIsNoticedThere() {
    DaeProblem changing =
        Dae.system(
                2,
                (t, y, yDot, r) -> {
                  r[0] = yDot[0] + y[1];
                  r[1] = y[1] - y[0] + (t > 0.5 ? yDot[1] : 0);
                })
            .withAlgebraic(1);
    assertThatIllegalArgumentException()
        .isThrownBy(
            () ->
                Dae.solve(
                    changing, 0, new double[] {1, 1}, new double[2], 1, OdeOptions.standard()))
        .withMessageContaining("component 1 is declared ALGEBRAIC")
        .withMessageContaining("at t = 0.5");
  }

  @Test
  void badInputIsRefused() {
    assertThatIllegalArgumentException()
        .isThrownBy(() -> Dae.solve(PROBLEM, 0, new double[2], new double[3], 1))
        .withMessageContaining("length of yDot0 is 3");
    assertThatIllegalArgumentException()
        .isThrownBy(() -> PROBLEM.withAlgebraic(2))
        .withMessageContaining("component 2")
        .withMessageContaining("0 to 1");
    assertThatIllegalArgumentException()
        .isThrownBy(() -> Dae.solve(PROBLEM, 0, new double[2], new double[] {0, Double.NaN}, 1))
        .withMessageContaining("initial derivative's component 1 is NaN");
  }
}
