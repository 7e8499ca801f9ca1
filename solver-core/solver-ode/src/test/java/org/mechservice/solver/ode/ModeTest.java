package org.mechservice.solver.ode;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Named;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.solver.ode.IntegratorSettings.Mode;
import org.mechservice.solver.ode.adams.De;
import org.mechservice.solver.ode.adams.Ode113;
import org.mechservice.solver.ode.stiff.Ode15s;
import org.mechservice.solver.ode.stiff.Ode15sR;
import org.mechservice.solver.ode.suite.Run;
import org.mechservice.solver.ode.suite.SuiteProblem;

/** What the modes promise beyond, or in spite of, the published programs. */
class ModeTest {
  /** Runs of a method over problems and tolerances: digits delivered, and cost. */
  private record Runs(int count, int withDigitsLessOne, double logEvaluations) {
    static Runs of(IntegratorFactory integrators, List<SuiteProblem> problems, Mode mode) {
      int count = 0;
      int delivered = 0;
      double cost = 0;
      for (SuiteProblem problem : problems) {
        for (int k = 3; k <= 10; k++) {
          IntegratorSettings settings = Run.settings(problem, StrictMath.pow(10, -k));
          Run run = Run.of(integrators.create(settings.withMode(mode)), problem);
          double digits = problem.reference().mixedDigits(run.atEnd(), problem.reference().atEnd());
          count++;
          delivered += digits >= k - 1 ? 1 : 0;
          cost += StrictMath.log((double) run.statistics().evaluations());
        }
      }
      return new Runs(count, delivered, cost);
    }

    double share() {
      return (double) withDigitsLessOne / count;
    }

    /** Returns the geometric mean of the evaluations relative to those of other runs. */
    double costRelativeTo(Runs other) {
      return StrictMath.exp((logEvaluations - other.logEvaluations) / count);
    }
  }

  static Stream<Named<IntegratorFactory>> adamsMethods() {
    return Stream.of(Named.of("ode113", Ode113::new), Named.of("DE", De::new));
  }

  @ParameterizedTest
  @MethodSource("adamsMethods")
  void adamsMethodsDeliverTheDigitsAskedForLessOneInAccurateMode(IntegratorFactory method) {
    List<SuiteProblem> problems = SuiteProblem.nonstiff();
    Runs accurate = Runs.of(method, problems, Mode.STRICT);
    assertThat(accurate.share()).isGreaterThanOrEqualTo(0.70);
    assertThat(accurate.costRelativeTo(Runs.of(method, problems, Mode.STANDARD)))
        .isLessThanOrEqualTo(1.35);
  }

  @Test
  void ode15sDeliversTheDigitsAskedForLessOneInAccurateMode() {
    List<SuiteProblem> problems = SuiteProblem.stiff();
    Runs accurate = Runs.of(Ode15s::new, problems, Mode.STRICT);
    assertThat(accurate.share()).isGreaterThanOrEqualTo(0.80);
    assertThat(accurate.costRelativeTo(Runs.of(Ode15s::new, problems, Mode.STANDARD)))
        .isLessThanOrEqualTo(1.6);
  }

  @ParameterizedTest
  @ValueSource(doubles = {1e-3, 1e-6, 1e-9, 1e-12})
  void standardModeOfTheAdamsMethodsIsFaithfulWhereNothingJumps(double tolerance) {
    for (IntegratorFactory integrators : List.<IntegratorFactory>of(Ode113::new, De::new)) {
      for (SuiteProblem problem : SuiteProblem.nonstiff()) {
        IntegratorSettings settings = Run.settings(problem, tolerance);
        Run standard = Run.of(integrators.create(settings.withMode(Mode.STANDARD)), problem);
        Run faithful = Run.of(integrators.create(settings.withMode(Mode.FAITHFUL)), problem);
        assertThat(standard.atEnd()).as(problem.name()).isEqualTo(faithful.atEnd());
        assertThat(standard.statistics()).isEqualTo(faithful.statistics());
      }
    }
  }

  @Test
  void internalToleranceIsToldInSettingsAndStatistics() {
    IntegratorSettings settings = new IntegratorSettings(1e-6, 1e-6);
    assertThat(settings.toleranceFactor()).isEqualTo(1);
    assertThat(settings.withMode(Mode.FAITHFUL).toleranceFactor()).isEqualTo(1);
    IntegratorSettings accurate = settings.withMode(Mode.STRICT);
    assertThat(accurate.toleranceFactor()).isEqualTo(0.05);
    SuiteProblem problem = SuiteProblem.named("EulerRigidBody");
    for (IntegratorFactory integrators :
        List.<IntegratorFactory>of(Ode113::new, De::new, Ode15s::new, Ode15sR::new)) {
      assertThat(Run.of(integrators.create(settings), problem).statistics().toleranceFactor())
          .isEqualTo(1);
      assertThat(Run.of(integrators.create(accurate), problem).statistics().toleranceFactor())
          .isEqualTo(0.05);
    }
  }

  @Test
  void internalToleranceStaysAboveTheLimitOfTheArithmetic() {
    IntegratorSettings tight = new IntegratorSettings(1e-13, 1e-13).withMode(Mode.STRICT);
    assertThat(tight.toleranceFactor())
        .isCloseTo(IntegratorSettings.SMALLEST_RELATIVE_TOLERANCE / 1e-13, within(1e-12));
    Run run = Run.of(new Ode113(tight), SuiteProblem.named("EulerRigidBody"));
    assertThat(run.result()).isEqualTo(StepResult.REACHED_END);
  }
}
