package org.mechservice.solver.simulation;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.mechservice.solver.catalogue.IntegrationMethod;
import org.mechservice.solver.ode.Integrator;

class IntegratorClassTest {
  @ParameterizedTest
  @EnumSource(IntegrationMethod.class)
  void catalogueNamesTheClassOfEachIntegrator(IntegrationMethod method) throws Exception {
    assertThat(Integrator.class).isAssignableFrom(Class.forName(method.className()));
  }
}
