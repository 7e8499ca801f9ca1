package org.mechservice.sim.service.session;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowableOfType;
import static org.assertj.core.api.Assertions.within;

import java.nio.charset.StandardCharsets;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.mechservice.guard.UserCodePolicy;
import org.mechservice.idl.IMechSimRemote;
import org.mechservice.idl.InvalidModel;
import org.mechservice.idl.JarInfoHolder;
import org.mechservice.idl.MechSim;
import org.mechservice.idl.ModelFile;
import org.mechservice.idl.NameValue;
import org.mechservice.idl.NotAvailable;
import org.mechservice.idl.SimState;
import org.mechservice.orb.testing.CursorRows;
import org.mechservice.orb.testing.Eventually;
import org.mechservice.sim.host.HostOptions;
import org.mechservice.sim.host.SimHost;
import org.mechservice.sim.user.PushedCart;
import org.mechservice.sim.user.UserFile;
import org.omg.CORBA.UserException;

/** Classes of users run where the operator allows it; elsewhere nothing of theirs is loaded. */
@Tag("slow")
class UserCodeContractTest {
  private static final NameValue[] AS_IN_FILE = new NameValue[0];
  private static final ModelFile MODEL = new ModelFile("pushed.xml", PushedCart.file());

  /** Mass of the cart, kg, and end of the run, s. */
  private static final double MASS = 2;

  private static final double END = 1;

  private static HostedClient host(boolean userCode) {
    HostOptions options =
        new HostOptions("here", 1)
            .withUserCode(userCode ? UserCodePolicy.UNCONFINED : UserCodePolicy.REFUSED);
    return new HostedClient(SimHost.installedSolver(), options);
  }

  private static ModelFile[] source(String text) {
    return new ModelFile[] {new ModelFile("car/Push.java", text.getBytes(StandardCharsets.UTF_8))};
  }

  private static ModelFile[] classFile() {
    UserFile file = PushedCart.compiled("Push", PushedCart.source(), "17");
    return new ModelFile[] {new ModelFile(file.name(), file.content())};
  }

  @Test
  void hostThatMayRunsTheForceTheUserHasWritten() throws UserException {
    try (HostedClient there = host(true)) {
      MechSim session = there.emptySession();
      session.loadModel(MODEL, source(PushedCart.harmlessSource()));
      IMechSimRemote run = session.createSimulation(AS_IN_FILE, null);
      run.start();
      List<double[]> rows = CursorRows.toEnd(run.openResults(HostedClient.ALL), 100);
      double[] last = rows.get(rows.size() - 1);
      assertThat(last[2]).isCloseTo(PushedCart.FORCE / MASS * END, within(1e-8));
    }
  }

  /** Time, q and v; a; 13 of the pose and the velocity; T, U, work; 6 reactions; 12 of momentum. */
  @Test
  void runWithUserCodePutsOutEveryColumnThatTheModelHas() throws UserException {
    try (HostedClient there = host(true)) {
      MechSim session = there.emptySession();
      session.loadModel(MODEL, source(PushedCart.harmlessSource()));
      NameValue[] all = {new NameValue("columns", "all")};
      IMechSimRemote run = session.createSimulation(all, null);
      run.start();
      List<double[]> rows = CursorRows.toEnd(run.openResults(HostedClient.ALL), 100);
      assertThat(rows.get(0)).hasSize(3 + 1 + 13 + 3 + 6 + 12);
    }
  }

  /** Nothing moves the cart back: two eigenvalues of zero, each in the eight columns of a mode. */
  @Test
  void smallMotionsWithUserCodeAreATable() throws UserException {
    try (HostedClient there = host(true)) {
      MechSim session = there.emptySession();
      String dynamic = new String(PushedCart.file(), StandardCharsets.UTF_8);
      String linear = dynamic.replaceFirst("(?s)<dynamic>.*</dynamic>", "<linearize/>");
      byte[] file = linear.getBytes(StandardCharsets.UTF_8);
      session.loadModel(new ModelFile("pushed.xml", file), source(PushedCart.harmlessSource()));
      IMechSimRemote run = session.createSimulation(AS_IN_FILE, null);
      run.start();
      List<double[]> rows = CursorRows.toEnd(run.openResults(HostedClient.ALL), 100);
      assertThat(rows).hasSize(2).allSatisfy(mode -> assertThat(mode).hasSize(8));
      assertThat(rows).allSatisfy(mode -> assertThat(mode[2]).isZero());
    }
  }

  @Test
  void runWithUserCodeMayLeaveAHostThatIsBeingEmptied() throws UserException {
    try (HostedClient there = host(true)) {
      MechSim session = there.emptySession();
      session.loadModel(MODEL, source(PushedCart.harmlessSource()));
      session.createSimulation(AS_IN_FILE, null);
      there.host.drain();
      assertThat(session.pollEvents(0, 100, 0))
          .flatExtracting(event -> List.of(event.messages))
          .extracting(message -> message.code)
          .contains("S-115")
          .doesNotContain("S-116");
      assertThat(there.host.events(0, 100, 0)).extracting(event -> event.code).contains("S-115");
    }
  }

  @Test
  void missingClassesAreAskedFor() throws UserException {
    try (HostedClient there = host(true)) {
      InvalidModel refusal =
          catchThrowableOfType(
              InvalidModel.class, () -> there.emptySession().loadModel(MODEL, new ModelFile[0]));
      assertThat(refusal.diagnostics).hasSize(1);
      assertThat(refusal.diagnostics[0].code).isEqualTo("S-121");
      assertThat(refusal.diagnostics[0].fileName).isEqualTo("car/Push.class");
    }
  }

  @Test
  void hostThatMayNotCompilesNothing() throws UserException {
    try (HostedClient there = host(false)) {
      InvalidModel refusal =
          catchThrowableOfType(
              InvalidModel.class,
              () -> there.emptySession().loadModel(MODEL, source(PushedCart.source())));
      assertThat(refusal.diagnostics).hasSize(1);
      assertThat(refusal.diagnostics[0].code).isEqualTo("S-120");
    }
  }

  @Test
  void hostThatMayNotBuildsJarsOfClassFilesAndLoadsNone() throws UserException {
    System.clearProperty(PushedCart.TRACE);
    try (HostedClient there = host(false)) {
      MechSim session = there.emptySession();
      session.loadModel(MODEL, classFile());
      assertThat(session.checkReport(false)).contains("class car.Push");
      assertThat(session.compileToJar(AS_IN_FILE, new JarInfoHolder())).isNotEmpty();
      NameValue[] standalone = {new NameValue("standalone", "true")};
      assertThat(session.compileToJar(standalone, new JarInfoHolder())).isNotEmpty();
      NotAvailable refusal =
          catchThrowableOfType(
              NotAvailable.class, () -> session.createSimulation(AS_IN_FILE, null));
      assertThat(refusal.code).isEqualTo("S-120");
      assertThat(refusal.text).contains("--allow-user-code", "--mode local");
    }
    assertThat(System.getProperty(PushedCart.TRACE)).isNull();
  }

  @Test
  void classThatAsksForWhatTheModelLacksEndsTheRunAtItsStart() throws Exception {
    try (HostedClient there = host(true)) {
      MechSim session = there.emptySession();
      session.loadModel(
          MODEL, source(PushedCart.harmlessSource().replace("\"slide\"", "\"slid\"")));
      IMechSimRemote run = session.createSimulation(AS_IN_FILE, null);
      run.start();
      Eventually.holds(() -> run.getProgress().state == SimState.SIM_FAILED);
      assertThat(run.failure().code).isEqualTo("S-068");
      assertThat(run.failure().text).contains("\"slid\"");
    }
  }

  @Test
  void sameModelWithAnotherClassIsAnotherModel() throws UserException {
    try (HostedClient there = host(true)) {
      for (double force : new double[] {3, 6}) {
        MechSim session = there.emptySession();
        session.loadModel(
            MODEL,
            source(PushedCart.harmlessSource().replace("(slide, 3)", "(slide, " + force + ")")));
        IMechSimRemote run = session.createSimulation(AS_IN_FILE, null);
        run.start();
        List<double[]> rows = CursorRows.toEnd(run.openResults(HostedClient.ALL), 100);
        assertThat(rows.get(rows.size() - 1)[2]).isCloseTo(force / MASS * END, within(1e-8));
      }
    }
  }
}
