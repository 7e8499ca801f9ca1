package org.mechservice.solver.simulation;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Locale;
import org.junit.jupiter.api.Test;
import org.mechservice.solver.api.capability.ExplicitModel;
import org.mechservice.solver.api.run.Failure;
import org.mechservice.solver.catalogue.IntegrationMethod;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.ode.IntegrationFailure;
import org.mechservice.solver.ode.IntegrationFailure.Cause;
import org.mechservice.solver.simulation.FailureText.ImplicitLoops;

class FailureTextTest {
  private static Failure told(Cause cause, ImplicitLoops loops) {
    return told(cause, loops, "ode15s");
  }

  private static Failure told(Cause cause, ImplicitLoops loops, String integrator) {
    IntegrationFailure failure = new IntegrationFailure(cause, 0.3, 1e-15, 1, 0, 0, List.of());
    return FailureText.of(
        failure,
        new HarmonicOscillator().description(),
        ExplicitModel.REGULAR,
        "",
        "By itself it swings. ",
        loops,
        integrator);
  }

  @Test
  void stepsThatAreTooShortByPenaltyAreBlamedOnRoundingOfTheLoopsAndNotOnForces() {
    Failure failure = told(Cause.STEP_TOO_SMALL, ImplicitLoops.PENALTY);
    assertThat(failure.code()).isEqualTo(MessageCode.STEP_TOO_SMALL);
    assertThat(failure.advice())
        .startsWith("By itself it swings. By penalty, velocities keep rounding errors of the loops")
        .contains("if the absolute tolerance is finer, loosen it", "closure projection or DSR");
  }

  @Test
  void stepsThatAreTooShortWithoutPenaltyAreBlamedOnTheMotion() {
    for (ImplicitLoops loops : List.of(ImplicitLoops.NONE, ImplicitLoops.PROJECTION)) {
      assertThat(told(Cause.STEP_TOO_SMALL, loops).advice())
          .contains("The motion is singular there; loosen the tolerances")
          .doesNotContain("penalty");
    }
  }

  @Test
  void unsolvableStepsByPenaltyNameTheLoopsAndAlphaBeforeForces() {
    Failure failure = told(Cause.NO_CONVERGENCE, ImplicitLoops.PENALTY);
    assertThat(failure.code()).isEqualTo(MessageCode.NEWTON_DIVERGES);
    assertThat(failure.advice())
        .contains("a position in which the loops lose rank", "alpha is below its default of 1e7")
        .contains("Otherwise look for a force that jumps");
  }

  @Test
  void unsolvableStepsByProjectionNameLongChainsAndPenaltyBeforeForces() {
    assertThat(told(Cause.NO_CONVERGENCE, ImplicitLoops.PROJECTION).advice())
        .contains("as in long chains", "use closure penalty, or DSR")
        .contains("In short loops look for a force that jumps");
  }

  @Test
  void unsolvableStepsWithoutLoopsAreBlamedOnForces() {
    assertThat(told(Cause.NO_CONVERGENCE, ImplicitLoops.NONE).advice())
        .startsWith("By itself it swings. Look for a force that jumps")
        .doesNotContain("loops");
  }

  @Test
  void motionThatIsTooStiffForAnExplicitMethodGetsAnImplicitOneAdvised() {
    for (String explicit : List.of("ode113", "DE")) {
      assertThat(told(Cause.STEP_TOO_SMALL, ImplicitLoops.NONE, explicit).advice())
          .contains("singular or very stiff there; use ode15s, loosen");
      assertThat(told(Cause.TOO_MANY_STEPS, ImplicitLoops.NONE, explicit).advice())
          .contains("add damping and use ode15s");
    }
  }

  /** Every cause, with each method running and each way to close the loops. */
  @Test
  void adviceNeverNamesWhatIsRunning() {
    for (IntegrationMethod running : IntegrationMethod.values()) {
      for (ImplicitLoops loops : ImplicitLoops.values()) {
        for (Cause cause : Cause.values()) {
          String advice = told(cause, loops, running.label()).advice();
          assertThat(words(advice))
              .as("%s, %s, %s", cause, loops, running)
              .doesNotContain(running.label(), "auto");
          if (loops != ImplicitLoops.NONE) {
            String closure = loops.name().toLowerCase(Locale.ROOT);
            assertThat(advice)
                .as("%s, %s", cause, loops)
                .doesNotContain("closure " + closure, closure + " closure", "RR");
          }
        }
      }
    }
  }

  private static List<String> words(String text) {
    return List.of(text.split("[ ,;:.]+"));
  }

  @Test
  void singularInertiaIsNotSaidToBeNoInertia() {
    Failure failure = FailureText.singularStart(0, new HarmonicOscillator().description(), 0);
    assertThat(failure.cause())
        .contains("do not resist its motion, or by less than one part in 7e13");
    assertThat(failure.advice()).contains("axes that coincide", "1e13 times as heavy");
  }
}
