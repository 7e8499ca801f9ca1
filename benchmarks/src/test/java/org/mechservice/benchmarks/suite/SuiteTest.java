package org.mechservice.benchmarks.suite;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;

class SuiteTest {
  private static Stream<ProblemFile> files() {
    return Stream.of(
            ProblemFile.all(), ProblemFile.further(), ProblemFile.unseen(), ProblemFile.fresh())
        .flatMap(List::stream);
  }

  private static Stream<String> problems() {
    return files().map(problem -> problem.id);
  }

  private static Stream<String> comparedProblems() {
    return Stream.of(ProblemFile.further(), ProblemFile.unseen(), ProblemFile.fresh())
        .flatMap(List::stream)
        .map(problem -> problem.id);
  }

  private static ProblemFile named(String id) {
    return files().filter(p -> p.id.equals(id)).findFirst().orElseThrow();
  }

  @ParameterizedTest
  @CsvSource({
    "2*3+4, 10",
    "-2**2, -4",
    "2**-1, 0.5",
    "2**3**2, 512",
    "1e-3*(1-5/2)*2, -0.003",
    "sqrt(16)+exp(0)-cos(0)+sin(pi/2)+log(1)+asin(1)*2/pi, 6",
    "- -3, 3"
  })
  void expressionsMeanWhatPythonTakesThemFor(String text, double value) {
    assertThat(Formula.of(text, name -> -1).at(new double[0])).isEqualTo(value);
  }

  @ParameterizedTest
  @MethodSource("problems")
  void explicitFormHasNoResidual(String id) {
    ProblemFile problem = named(id);
    SuiteEquations equations = new SuiteEquations(problem);
    double[] y = ProblemFile.numbers(problem.y0);
    double[] slope = ProblemFile.numbers(problem.yp0);
    if (problem.isExplicit()) {
      slope = new double[y.length];
      equations.derivative(equations.number(problem.t0), y, slope);
    }
    double[] residual = new double[y.length];
    equations.residual(equations.number(problem.t0), y, slope, residual);
    // Given to 25 digits and read as double; equations have coefficients up to 1e9.
    for (double value : residual) {
      assertThat(Math.abs(value)).isLessThan(1e-7);
    }
  }

  @ParameterizedTest
  @CsvSource({
    "rigid, ode113",
    "rigid, DE",
    "chain6, ode113",
    "hires, ode15s",
    "weissinger, ode15sR",
    "rigid, Hipparchus DormandPrince853",
    "rigid, Hipparchus GraggBulirschStoer",
    "rigid, Hipparchus AdamsMoulton 8"
  })
  void integratorsReachTheVerifiedEnd(String id, String integrator) {
    SuiteRun run = SuiteRunner.runs(named(id), integrator, new double[] {1e-8}, 60).get(0);
    assertThat(run.cause()).isEmpty();
    // Global over local error: two digits at most on these problems.
    assertThat(run.error()).isLessThan(1e-6);
  }

  @ParameterizedTest
  @MethodSource("comparedProblems")
  void stiffMethodsReachTheEndsOfTheProblemsThatPeersAreComparedOn(String id) {
    ProblemFile problem = named(id);
    String method = problem.algebraic.isEmpty() ? "ode15s" : "ode15sR";
    SuiteRun run = SuiteRunner.runs(problem, method, new double[] {1e-6}, 60).get(0);
    assertThat(run.cause()).isEmpty();
    // Two digits less than asked for. The rod's force is its length's
    // error times its stiffness, 1e4 weights per unit of length.
    assertThat(run.error()).isLessThan(id.equals("rod_pendulum") ? 1e-2 : 1e-4);
  }

  @ParameterizedTest
  @CsvSource({"vdp1000, 0", "robertson, 0"})
  void whatTakesTooLongIsAFailureWithItsCause(String id, double limit) {
    List<SuiteRun> runs = SuiteRunner.runs(named(id), "ode113", new double[] {1e-6}, limit);
    assertThat(runs.get(0).cause()).isNotEmpty();
    assertThat(runs.get(0).error()).isNaN();
  }
}
