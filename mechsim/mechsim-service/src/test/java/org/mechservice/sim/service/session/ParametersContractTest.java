package org.mechservice.sim.service.session;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowableOfType;
import static org.assertj.core.api.Assertions.within;
import static org.mechservice.sim.service.session.HostedClient.ALL;

import java.nio.charset.StandardCharsets;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.mechservice.idl.IMechSimRemote;
import org.mechservice.idl.InvalidOption;
import org.mechservice.idl.InvalidState;
import org.mechservice.idl.MechSim;
import org.mechservice.idl.ModelFile;
import org.mechservice.idl.NameValue;
import org.mechservice.idl.Parameter;
import org.mechservice.orb.testing.CursorRows;
import org.omg.CORBA.UserException;

/** Parameters of a simulation may be set until it starts: those that stayed inputs, to numbers. */
@Tag("slow")
class ParametersContractTest {
  /** A block of 1 kg, pushed by "push" newtons from "place": x = place + push t^2 / 2. */
  private static final String PUSHED =
      """
      <MechML>
        <MBSsimulation><dynamic><timeSet tini="0" tend="1" tstep="0.5"/>
          <integrator name="ode113" relTol="1e-9" absTol="1e-9"/></dynamic></MBSsimulation>
        <MBSmodel name="Pushed" massUnits="kg" lengthUnits="m">
          <Parameters>
            <parameter name="push" value="2" tunable="true"/>
            <parameter name="drag" value="0" tunable="true"/>
            <parameter name="place" value="0"/>
          </Parameters>
          <Bodies>
            <body name="Ground"><point name="p" x="0" y="0" z="0"/>
              <vector name="x" vx="1" vy="0" vz="0"/></body>
            <body name="block"><point name="p" x="0" y="0" z="0"/>
              <vector name="x" vx="1" vy="0" vz="0"/><mass value="1"/></body>
          </Bodies>
          <Joints><joint name="slide" type="P">
            <body1 name="Ground" point="p" vector="x"/>
            <body2 name="block" point="p" vector="x"/>
          </joint></Joints>
          <Forces><jointForce name="f" joint="slide" expression="push - drag"/></Forces>
          <topology><root name="Ground"/>
            <relCoorVals><jointVal name="slide" posVals="place"/></relCoorVals></topology>
        </MBSmodel>
      </MechML>
      """;

  private static IMechSimRemote simulation(HostedClient there) throws UserException {
    MechSim session = there.emptySession();
    session.loadModel(
        new ModelFile("pushed.xml", PUSHED.getBytes(StandardCharsets.UTF_8)), new ModelFile[0]);
    return session.createSimulation(new NameValue[0], null);
  }

  private static void set(IMechSimRemote run, String... namesAndValues) throws UserException {
    NameValue[] values = new NameValue[namesAndValues.length / 2];
    for (int i = 0; i < values.length; i++) {
      values[i] = new NameValue(namesAndValues[2 * i], namesAndValues[2 * i + 1]);
    }
    run.setParameters(values);
  }

  /** Runs to 1 s and returns the way gone. */
  private static double way(IMechSimRemote run) throws UserException {
    run.start();
    List<double[]> rows = CursorRows.toEnd(run.openResults(ALL), 0);
    return rows.get(rows.size() - 1)[1];
  }

  @Test
  void tunableParametersAreListedWithTheirValues() throws UserException {
    try (HostedClient there = HostedClient.withInstalledSolver()) {
      Parameter[] parameters = simulation(there).parameters();
      assertThat(parameters).extracting(p -> p.name).containsExactly("push", "drag");
      assertThat(parameters[0].value).isEqualTo(2);
    }
  }

  @Test
  void valueSetBeforeTheStartIsTheOneThatActs() throws UserException {
    try (HostedClient there = HostedClient.withInstalledSolver()) {
      IMechSimRemote run = simulation(there);
      set(run, "push", "6");
      assertThat(run.parameters()[0].value).isEqualTo(6);
      assertThat(way(run)).isCloseTo(3, within(1e-8));
    }
  }

  @Test
  void valuesSetEarlierStayAndAnotherSimulationHasTheFiles() throws UserException {
    try (HostedClient there = HostedClient.withInstalledSolver()) {
      IMechSimRemote run = simulation(there);
      set(run, "push", "6");
      set(run, "drag", "1");
      set(run, "push", "5");
      assertThat(way(run)).isCloseTo(2, within(1e-8));
      assertThat(way(simulation(there))).isCloseTo(1, within(1e-8));
    }
  }

  @Test
  void whatCannotBeSetIsRefusedAndNothingIsSet() throws UserException {
    try (HostedClient there = HostedClient.withInstalledSolver()) {
      IMechSimRemote run = simulation(there);
      assertRefused(run, "S-125", "push", "6", "place", "1");
      assertRefused(run, "S-125", "pusch", "6");
      assertRefused(run, "S-126", "drag", "6", "push", "fast");
      assertRefused(run, "S-126", "push", "NaN");
      assertRefused(run, "S-126", "push", "1e999");
      assertThat(way(run)).isCloseTo(1, within(1e-8));
    }
  }

  private static void assertRefused(IMechSimRemote run, String code, String... namesAndValues) {
    InvalidOption refused =
        catchThrowableOfType(InvalidOption.class, () -> set(run, namesAndValues));
    assertThat(refused.code).isEqualTo(code);
  }

  @Test
  void nothingIsSetAfterTheStart() throws UserException {
    try (HostedClient there = HostedClient.withInstalledSolver()) {
      IMechSimRemote run = simulation(there);
      way(run);
      assertThat(catchThrowableOfType(InvalidState.class, () -> set(run, "push", "6"))).isNotNull();
    }
  }
}
