package org.mechservice.solver.catalogue;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/**
 * Formulations, closures, integrators and accuracies are found by their published names, and
 * documented.
 */
class MethodNamesTest {
  private static final Path LANGUAGE = Path.of("..", "..", "docs", "mechml.md");

  @ParameterizedTest
  @EnumSource(Formulation.class)
  void formulationIsFoundByItsNameAndDocumented(Formulation formulation) throws IOException {
    assertThat(Formulation.of(formulation.label())).isSameAs(formulation);
    assertThat(formulation).hasToString(formulation.label());
    assertThat(Files.readString(LANGUAGE)).contains(formulation.label());
  }

  @ParameterizedTest
  @EnumSource(ClosureMethod.class)
  void closureIsFoundByItsNameAndDocumented(ClosureMethod closure) throws IOException {
    assertThat(ClosureMethod.of(closure.label())).isSameAs(closure);
    assertThat(closure).hasToString(closure.label());
    assertThat(Files.readString(LANGUAGE)).contains(closure.label());
  }

  @ParameterizedTest
  @EnumSource(IntegrationMethod.class)
  void integratorIsFoundByItsNameAndDocumented(IntegrationMethod method) throws IOException {
    assertThat(IntegrationMethod.of(method.label())).isSameAs(method);
    assertThat(method).hasToString(method.label());
    assertThat(Files.readString(LANGUAGE)).contains(method.label());
  }

  @ParameterizedTest
  @EnumSource(Accuracy.class)
  void accuracyIsFoundByItsNameAndDocumented(Accuracy accuracy) throws IOException {
    assertThat(Accuracy.of(accuracy.label())).isSameAs(accuracy);
    assertThat(accuracy).hasToString(accuracy.label());
    assertThat(Files.readString(LANGUAGE)).contains("`" + accuracy.label() + "`");
  }

  @Test
  void unknownNamesAreRefusedWithTheKnownOnes() {
    assertThatThrownBy(() -> Formulation.of("rr"))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessage("there is no formulation \"rr\"; there are DTR, DSR, RR, RR-JF");
    assertThatThrownBy(() -> ClosureMethod.of("glue"))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessage("there is no closure \"glue\"; there are projection, penalty");
    assertThatThrownBy(() -> IntegrationMethod.of("ode45"))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessage(
            "S-063 integrator \"ode45\" is unknown; there are ode113, DE, ode15s, ode15sR and"
                + " switching");
    assertThatThrownBy(() -> Accuracy.of("sharp"))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessage("accuracy is \"sharp\"; it must be standard or strict");
  }

  @Test
  void onlyAResidualIntegratorTakesAResidual() {
    assertThat(IntegrationMethod.values())
        .filteredOn(IntegrationMethod::takesResidual)
        .containsExactly(IntegrationMethod.ODE15SR);
    assertThat(Formulation.values())
        .filteredOn(Formulation::isResidual)
        .containsExactly(Formulation.RR, Formulation.RR_JF);
  }
}
