package org.mechservice.sim.service.session;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.catchThrowableOfType;
import static org.mechservice.sim.service.session.HostedClient.ALL;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.HashMap;
import java.util.Map;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.mechservice.idl.IMechSimRemote;
import org.mechservice.idl.InvalidModel;
import org.mechservice.idl.InvalidOption;
import org.mechservice.idl.InvalidState;
import org.mechservice.idl.JarInfo;
import org.mechservice.idl.JarInfoHolder;
import org.mechservice.idl.LimitExceeded;
import org.mechservice.idl.MechSim;
import org.mechservice.idl.ModelFile;
import org.mechservice.idl.ModelInfo;
import org.mechservice.idl.NameValue;
import org.mechservice.idl.NotFound;
import org.mechservice.idl.Severity;
import org.mechservice.idl.SimEvent;
import org.mechservice.idl.SimState;
import org.mechservice.orb.testing.CursorRows;
import org.mechservice.sim.service.limits.HostLimit;
import org.mechservice.sim.service.limits.HostLimits;
import org.mechservice.sim.service.testing.PacedSolver;
import org.omg.CORBA.OBJECT_NOT_EXIST;
import org.omg.CORBA.UserException;

@Tag("slow")
class SessionContractTest {
  private static final NameValue[] AS_IN_FILE = new NameValue[0];
  private static final ModelFile[] NO_FILES = new ModelFile[0];

  @Test
  void nothingCanBeAskedOfASessionWithoutModel() throws UserException {
    try (HostedClient there = HostedClient.withInstalledSolver()) {
      MechSim session = there.emptySession();
      assertThatThrownBy(session::getModelInfo).isInstanceOf(InvalidState.class);
      assertThatThrownBy(session::roadmap).isInstanceOf(InvalidState.class);
      assertThatThrownBy(() -> session.checkReport(true)).isInstanceOf(InvalidState.class);
      assertThatThrownBy(() -> session.createSimulation(AS_IN_FILE, null))
          .isInstanceOf(InvalidState.class);
    }
  }

  @Test
  void brokenModelIsAnsweredWithItsPlaces() throws UserException {
    try (HostedClient there = HostedClient.withInstalledSolver()) {
      String text = HostedClient.pendulumText().replace("name=\"j3\" type=\"R\"", "name=\"j3\"");
      ModelFile broken = new ModelFile("b.xml", text.getBytes(StandardCharsets.UTF_8));
      InvalidModel refusal =
          catchThrowableOfType(
              InvalidModel.class, () -> there.emptySession().loadModel(broken, NO_FILES));
      assertThat(refusal.code).isEqualTo("S-016");
      assertThat(refusal.diagnostics).isNotEmpty();
      assertThat(refusal.diagnostics[0].level).isEqualTo(Severity.SEV_ERROR);
      assertThat(refusal.diagnostics[0].fileName).isEqualTo("b.xml");
      assertThat(refusal.diagnostics[0].lineNo).isPositive();
      assertThat(refusal.diagnostics[0].code).startsWith("M-");
    }
  }

  @Test
  void modelThatIsTooLargeIsRefusedUnread() throws UserException {
    HostLimits limits = HostLimits.DEFAULT.with(HostLimit.MODEL_BYTES, 1000);
    try (HostedClient there = new HostedClient(PacedSolver.endless(), limits, 1)) {
      LimitExceeded refusal = catchThrowableOfType(LimitExceeded.class, there::session);
      assertThat(refusal.limitName).isEqualTo("modelBytes");
      assertThat(refusal.limitValue).isEqualTo(1000);
    }
  }

  @Test
  void modelIsDescribedBeforeItIsBuilt() throws UserException {
    try (HostedClient there = HostedClient.withInstalledSolver()) {
      MechSim session = there.session();
      ModelInfo info = session.getModelInfo();
      assertThat(info.modelName).isEqualTo("FiveBarPendulum");
      assertThat(info.formulation).isEqualTo("DTR");
      assertThat(info.formulationReason).isNotEmpty();
      assertThat(Arrays.stream(info.states).map(state -> state.name)).startsWith("j1.q", "j2.q");
      assertThat(Arrays.stream(info.settings).map(setting -> setting.key + "=" + setting.text))
          .contains("integrator=DE", "t-end=3.0");
      assertThat(
              Arrays.stream(session.roadmap()).map(joint -> joint.jointName + joint.velocityIndex))
          .containsExactly("j10", "j21", "j32", "j43", "j54");
      assertThat(session.checkReport(true)).startsWith("{");
      assertThat(session.checkReport(false)).contains("Degrees of freedom: 5");
      ModelFile source = session.generatedSource(AS_IN_FILE);
      assertThat(source.fileName).endsWith(".java");
      assertThat(new String(source.content, StandardCharsets.UTF_8)).contains("class ");
      assertThat(session.generatedSource(part("1")).fileName).isEmpty();
      assertThatThrownBy(() -> session.generatedSource(part("first")))
          .isInstanceOfSatisfying(
              InvalidOption.class,
              refusal -> assertThat(refusal.optionName).isEqualTo("source-part"));
    }
  }

  private static NameValue[] part(String number) {
    return new NameValue[] {new NameValue("source-part", number)};
  }

  @Test
  void modelTravelsAsJar() throws UserException {
    try (HostedClient there = HostedClient.withInstalledSolver()) {
      MechSim session = there.session();
      JarInfoHolder holder = new JarInfoHolder();
      byte[] jar = session.compileToJar(AS_IN_FILE, holder);
      JarInfo info = holder.value;
      assertThat(info.sizeBytes).isEqualTo(jar.length);
      assertThat(info.runtimeSha256).isEqualTo(session.getRuntimeInfo().sha256);
      byte[] runtime = session.fetchRuntime(info.runtimeSha256);
      assertThat(runtime.length).isEqualTo((int) session.getRuntimeInfo().sizeBytes);
      assertThatThrownBy(() -> session.fetchRuntime("00")).isInstanceOf(NotFound.class);
    }
  }

  @Test
  void standaloneJarNeedsNoRuntime() throws UserException {
    try (HostedClient there = HostedClient.withInstalledSolver()) {
      JarInfoHolder holder = new JarInfoHolder();
      there.session().compileToJar(new NameValue[] {new NameValue("standalone", "true")}, holder);
      assertThat(holder.value.runtimeSha256).isEmpty();
      assertThat(holder.value.sizeBytes).isGreaterThan(holder.value.modelBytes);
    }
  }

  @Test
  void optionsThatDoNotFitAreRefusedByName() throws UserException {
    try (HostedClient there = HostedClient.withInstalledSolver()) {
      MechSim session = there.session();
      for (String[] option :
          new String[][] {{"formulation", "RR"}, {"integrator", "rk4"}, {"colour", "red"}}) {
        InvalidOption refusal =
            catchThrowableOfType(
                InvalidOption.class,
                () ->
                    session.createSimulation(
                        new NameValue[] {new NameValue(option[0], option[1])}, null));
        assertThat(refusal.optionName).isEqualTo(option[0]);
        assertThat(refusal.text).doesNotStartWith("S-");
      }
    }
  }

  @Test
  void secondRunOfTheSameModelIsNotBuiltAgain() throws UserException {
    try (HostedClient there = HostedClient.with(new PacedSolver(3, 0))) {
      MechSim first = there.session();
      first.createSimulation(AS_IN_FILE, null);
      assertThat(times(first).get("tcc")).isPositive();
      MechSim second = there.session();
      second.createSimulation(new NameValue[] {new NameValue("t-end", "2")}, null);
      assertThat(times(second).get("tcc")).isZero();
      assertThat(times(second).get("t1s")).isPositive();
    }
  }

  private static Map<String, Double> times(MechSim session) {
    Map<String, Double> times = new HashMap<>();
    for (NameValue time : session.timings()) {
      times.put(time.key, Double.valueOf(time.text));
    }
    return times;
  }

  @Test
  void eventsTellARunsWholeStory() throws UserException {
    try (HostedClient there = HostedClient.withInstalledSolver()) {
      MechSim session = there.session();
      IMechSimRemote run = session.createSimulation(AS_IN_FILE, null);
      run.start();
      CursorRows.toEnd(run.openResults(ALL), 0);
      SimEvent[] events = session.pollEvents(0, 100, 0);
      assertThat(Arrays.stream(events).map(event -> event.seqNo)).isSorted();
      assertThat(Arrays.stream(events).map(event -> event.text))
          .containsSubsequence("waiting for a place", "running", "done");
      assertThat(events[0].messages[0].code).isEqualTo("S-017");
      assertThat(events[events.length - 1].info.state).isEqualTo(SimState.SIM_DONE);
      long last = events[events.length - 1].seqNo;
      assertThat(session.pollEvents(last, 100, 1)).isEmpty();
    }
  }

  @Test
  void destroyedSessionTakesAllItOwnsWithIt() throws UserException {
    try (HostedClient there = HostedClient.with(PacedSolver.endless())) {
      MechSim session = there.session();
      IMechSimRemote run = session.createSimulation(AS_IN_FILE, null);
      run.start();
      session.destroy();
      assertThatThrownBy(run::getProgress).isInstanceOf(OBJECT_NOT_EXIST.class);
      assertThatThrownBy(session::hostName).isInstanceOf(OBJECT_NOT_EXIST.class);
      assertThat(there.host.getLoad().sessions).isZero();
    }
  }

  @Test
  void sessionIsFoundAgainWhileItLives() throws UserException {
    try (HostedClient there = HostedClient.with(PacedSolver.endless())) {
      MechSim session = there.session();
      String id = session.sessionId();
      assertThat(there.seenByClient(there.host.findSession(id, "")).sessionId()).isEqualTo(id);
      session.destroy();
      assertThatThrownBy(() -> there.host.findSession(id, "")).isInstanceOf(NotFound.class);
    }
  }

  @Test
  void sessionsAndSimulationsAreLimited() throws UserException {
    HostLimits limits =
        HostLimits.DEFAULT.with(HostLimit.SESSIONS, 1).with(HostLimit.SIMULATIONS, 1);
    try (HostedClient there = new HostedClient(PacedSolver.endless(), limits, 1)) {
      MechSim session = there.session();
      session.createSimulation(AS_IN_FILE, null);
      LimitExceeded simulations =
          catchThrowableOfType(
              LimitExceeded.class, () -> session.createSimulation(AS_IN_FILE, null));
      assertThat(simulations.limitName).isEqualTo("simulations");
      LimitExceeded sessions = catchThrowableOfType(LimitExceeded.class, there::session);
      assertThat(sessions.limitName).isEqualTo("sessions");
    }
  }
}
