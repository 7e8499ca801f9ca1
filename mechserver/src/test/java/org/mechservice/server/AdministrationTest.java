package org.mechservice.server;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.catchThrowable;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import java.lang.reflect.Proxy;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.FutureTask;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.mechservice.idl.DiagnosticSeqHolder;
import org.mechservice.idl.HostInfo;
import org.mechservice.idl.HostLoad;
import org.mechservice.idl.IMechSimRemote;
import org.mechservice.idl.InvalidOption;
import org.mechservice.idl.Limit;
import org.mechservice.idl.LimitExceeded;
import org.mechservice.idl.MechServer;
import org.mechservice.idl.MechSim;
import org.mechservice.idl.MechSimHostHelper;
import org.mechservice.idl.MechSimHostOperations;
import org.mechservice.idl.MechSimHostPOATie;
import org.mechservice.idl.ModelFile;
import org.mechservice.idl.NameValue;
import org.mechservice.idl.NotAvailable;
import org.mechservice.idl.NotFound;
import org.mechservice.idl.ServerStatus;
import org.mechservice.idl.ServiceEvent;
import org.mechservice.idl.SimDetail;
import org.mechservice.idl.SimState;
import org.mechservice.idl.SimSummary;
import org.mechservice.orb.ListenAddress;
import org.mechservice.orb.ServiceOrb;
import org.mechservice.orb.testing.Eventually;
import org.mechservice.server.hosts.ServerTuning;
import org.omg.CORBA.IntHolder;
import org.omg.CORBA.OBJECT_NOT_EXIST;

@Tag("slow")
class AdministrationTest {
  @Test
  void statusAddsUpAllHosts() throws Exception {
    try (Farm farm = new Farm(1)) {
      farm.host("h", 1);
      Farm.running(farm.session("h"));
      Farm.running(farm.session("h"));
      Farm.running(farm.session("own"));
      Eventually.holds(() -> farm.admin.getStatus().running == 2);
      ServerStatus status = farm.admin.getStatus();
      assertThat(status.hosts).isEqualTo(2);
      assertThat(status.sessions).isEqualTo(3);
      assertThat(status.queued).isEqualTo(1);
      assertThat(status.info.serverName).isEqualTo("own");
    }
  }

  @Test
  void simulationsOfAllHostsAreListedInPages() throws Exception {
    try (Farm farm = new Farm(2)) {
      farm.host("h", 2);
      Farm.running(farm.session("h"));
      Farm.running(farm.session("own"));
      Farm.running(farm.session("own"));
      IntHolder total = new IntHolder();
      SimSummary[] page = farm.admin.listSimulations(0, 2, total);
      assertThat(total.value).isEqualTo(3);
      assertThat(page).hasSize(2);
      assertThat(farm.admin.listSimulations(2, 100, total)).hasSize(1);
      assertThat(page[0].modelName).isEqualTo("FiveBarPendulum");
      assertThat(page[0].owner).isEqualTo("test");
      assertThat(page[0].hostName).isEqualTo("h");
      assertThat(page[0].leaseEndsAt).isGreaterThan(page[0].createdAt);
    }
  }

  @Test
  void simulationIsKilledWhereverItRuns() throws Exception {
    try (Farm farm = new Farm(1)) {
      farm.host("h", 1);
      MechSim session = farm.session("h");
      IMechSimRemote run = Farm.running(session);
      farm.admin.killSimulation(run.simId(), "maintenance");
      Eventually.holds(() -> run.getProgress().state == SimState.SIM_CANCELLED);
      assertThat(
              Arrays.stream(session.pollEvents(0, 100, 0)).flatMap(e -> Arrays.stream(e.messages)))
          .anySatisfy(said -> assertThat(said.text).contains("maintenance"));
      assertThatThrownBy(() -> farm.admin.killSimulation("none", "x")).isInstanceOf(NotFound.class);
    }
  }

  @Test
  void drainedHostAndDrainedServerTakeNothingNew() throws Exception {
    try (Farm farm = new Farm(1)) {
      farm.host("h", 8);
      farm.admin.drain("h");
      assertThat(farm.session("").hostName()).isEqualTo("own");
      assertThatThrownBy(() -> farm.session("h")).isInstanceOf(LimitExceeded.class);
      farm.admin.undrain("h");
      assertThat(farm.session("").hostName()).isEqualTo("h");
      farm.admin.drain("");
      assertThat(farm.admin.getStatus().draining).isTrue();
      assertThatThrownBy(() -> farm.session("")).isInstanceOf(LimitExceeded.class);
      farm.admin.undrain("");
      assertThat(farm.session("").hostName()).isEqualTo("h");
      assertThatThrownBy(() -> farm.admin.drain("x")).isInstanceOf(NotFound.class);
    }
  }

  /** The server asks its hosts from time to time only; this one, never by itself. */
  @Test
  void hostThatIsNotEmptiedAnyMoreTakesTheNextSession() throws Exception {
    ServerTuning asksNobody =
        new ServerTuning(Duration.ofHours(1), Duration.ofHours(1), Duration.ofMinutes(1));
    try (Farm farm = new Farm(1, asksNobody)) {
      farm.host("h", 8);
      farm.admin.drain("h");
      assertThat(farm.admin.listHosts()).anyMatch(host -> host.load.draining);
      farm.admin.undrain("h");
      assertThat(farm.session("").hostName()).isEqualTo("h");
    }
  }

  @Test
  void serverEndsWhenItIsTold() throws Exception {
    try (Farm farm = new Farm(1)) {
      Farm.running(farm.session(""));
      farm.admin.shutdownServer(0);
      farm.server.awaitShutdown();
      assertThatThrownBy(() -> farm.orb.connect(farm.server.url())).hasMessageStartingWith("S-002");
    }
  }

  /** The server closes its port while the reply is on its way. */
  @Test
  void everyShutdownIsAnswered() throws Exception {
    for (int i = 0; i < 50; i++) {
      try (Farm farm = new Farm(0)) {
        farm.admin.shutdownServer(0);
        farm.server.awaitShutdown();
      }
    }
  }

  @Test
  void whatThisVersionDoesNotDoIsSaid() throws Exception {
    try (Farm farm = new Farm(1)) {
      ModelFile drawing = new ModelFile("robot.step", Pendulum.file().content);
      assertThatThrownBy(() -> farm.service.importModel(drawing, new DiagnosticSeqHolder()))
          .isInstanceOf(NotAvailable.class);
    }
  }

  /** A robot of so many links is read for minutes, unless somebody ends that. */
  private static ModelFile longRobot() {
    StringBuilder text = new StringBuilder("<robot name=\"r\"><link name=\"l0\"/>");
    for (int i = 1; i < 100_000; i++) {
      text.append(
          ("<link name=\"l%1$d\"/><joint name=\"j%1$d\" type=\"revolute\"><parent link=\"l%2$d\"/>"
                  + "<child link=\"l%1$d\"/><axis xyz=\"0 0 1\"/><limit lower=\"-1\" upper=\"1\""
                  + " effort=\"1\" velocity=\"1\"/></joint>")
              .formatted(i, i - 1));
    }
    return new ModelFile("r.urdf", text.append("</robot>").toString().getBytes(UTF_8));
  }

  private static long readers() {
    return ProcessHandle.current()
        .descendants()
        .filter(process -> process.info().commandLine().orElse("").contains("SetUpMain"))
        .count();
  }

  /** A process whose answer is read waits for the next request; one that was ended does not. */
  @Test
  void importEndsWithItsClient() throws Exception {
    try (Farm farm = new Farm(0)) {
      FutureTask<Throwable> client;
      try (ServiceOrb other = ServiceOrb.client()) {
        MechServer service = other.connect(farm.server.url());
        client =
            new FutureTask<>(
                () ->
                    catchThrowable(
                        () -> service.importModel(longRobot(), new DiagnosticSeqHolder())));
        new Thread(client).start();
        Eventually.holds(() -> readers() == 1);
      }
      Eventually.holds(() -> readers() == 0);
      assertThat(client.get()).isInstanceOf(org.omg.CORBA.SystemException.class);
      assertThat(farm.service.getInfo().serverName).isNotEmpty();
    }
  }

  @Test
  void importEndsWithItsServer() throws Exception {
    try (Farm farm = new Farm(0)) {
      FutureTask<Throwable> client =
          new FutureTask<>(
              () ->
                  catchThrowable(
                      () -> farm.service.importModel(longRobot(), new DiagnosticSeqHolder())));
      new Thread(client).start();
      Eventually.holds(() -> readers() == 1);
      farm.server.close();
      assertThat(readers()).isZero();
      assertThat(client.get()).isInstanceOf(OBJECT_NOT_EXIST.class);
    }
  }

  @Test
  void simulationIsShownInFull() throws Exception {
    try (Farm farm = new Farm(0)) {
      farm.host("h", 1);
      IMechSimRemote run = Farm.running(farm.session("h"));
      String simId = run.simId();
      Eventually.holds(() -> farm.admin.showSimulation(simId).curves.length > 2);
      Eventually.holds(() -> !farm.admin.showSimulation(simId).checkReportJson.isEmpty());
      SimDetail going = farm.admin.showSimulation(simId);
      assertThat(going.summary.simId).isEqualTo(simId);
      assertThat(going.summary.text).isEqualTo("running");
      assertThat(going.modelText).contains("<!DOCTYPE");
      assertThat(going.checkReportJson).startsWith("{");
      assertThat(going.failed.code).isEmpty();
      assertThat(going.events).isNotEmpty();
      run.destroy();
      SimDetail gone = farm.admin.showSimulation(simId);
      assertThat(gone.summary.info.state).isEqualTo(SimState.SIM_CANCELLED);
      assertThat(gone.reportJson).contains("\"outcome\":\"stopped\"");
      assertThatThrownBy(() -> farm.admin.showSimulation("none")).isInstanceOf(NotFound.class);
    }
  }

  @Test
  void whatHappensOnAnyHostIsHeardOfInOrder() throws Exception {
    try (Farm farm = new Farm(1)) {
      farm.host("h", 1);
      IMechSimRemote run = Farm.running(farm.session("h"));
      Eventually.holds(() -> run.getProgress().state == SimState.SIM_RUNNING);
      run.cancel();
      List<String> kinds = new ArrayList<>();
      long[] last = {0};
      Eventually.holds(
          () -> {
            for (ServiceEvent event : farm.admin.events(last[0], 100, 200)) {
              assertThat(event.seqNo).isEqualTo(last[0] + 1);
              last[0] = event.seqNo;
              kinds.add(event.kind);
            }
            return kinds.contains("sim-cancelled");
          });
      assertThat(kinds)
          .containsSubsequence(
              "server-started",
              "host-joined",
              "session-opened",
              "sim-queued",
              "sim-running",
              "sim-cancelled");
    }
  }

  @Test
  void limitsSetForAllHoldOnEveryHostAlsoOnThoseThatJoinLater() throws Exception {
    try (Farm farm = new Farm(1)) {
      farm.host("early", 1);
      farm.admin.setLimits("", new Limit[] {new Limit("cursors", "", 3, "")});
      farm.host("late", 1);
      for (String host : List.of("", "own", "early", "late")) {
        assertThat(limit(farm, host, "cursors")).as(host).isEqualTo(3);
      }
      farm.admin.setLimits("early", new Limit[] {new Limit("cursors", "", 5, "")});
      assertThat(limit(farm, "early", "cursors")).isEqualTo(5);
      assertThat(limit(farm, "late", "cursors")).isEqualTo(3);
      for (Limit wrong : List.of(new Limit("lease", "", 0, ""), new Limit("nosuch", "", 1, ""))) {
        for (String host : List.of("", "early")) {
          InvalidOption refusal =
              catchThrowableOfType(
                  InvalidOption.class, () -> farm.admin.setLimits(host, new Limit[] {wrong}));
          assertThat(refusal.code).isEqualTo("S-015");
          assertThat(refusal.optionName).isEqualTo(wrong.name);
        }
      }
    }
  }

  private static long limit(Farm farm, String host, String name) throws Exception {
    return Arrays.stream(farm.admin.getLimits(host))
        .filter(limit -> limit.name.equals(name))
        .mapToLong(limit -> limit.value)
        .sum();
  }

  @Test
  void placementIsChangedWhileTheServerRuns() throws Exception {
    try (Farm farm = new Farm(0)) {
      assertThat(farm.admin.getPlacement()).isEqualTo("least-loaded");
      farm.admin.setPlacement("pinned");
      assertThat(farm.admin.getPlacement()).isEqualTo("pinned");
      assertThatThrownBy(() -> farm.admin.setPlacement("random"))
          .isInstanceOfSatisfying(
              InvalidOption.class,
              refusal -> assertThat(refusal.text).contains("order, least-loaded, pinned"));
    }
  }

  /** Answers who it is, and then nothing any more. */
  private static MechSimHostOperations hanging(HostInfo info, CountDownLatch end) {
    return (MechSimHostOperations)
        Proxy.newProxyInstance(
            MechSimHostOperations.class.getClassLoader(),
            new Class<?>[] {MechSimHostOperations.class},
            (proxy, method, arguments) -> {
              if (!method.getName().equals("getInfo")) {
                end.await();
              }
              return method.getReturnType() == HostLoad.class
                  ? new HostLoad(0, 0, 0, 0, 0, false, new NameValue[0])
                  : info;
            });
  }

  /** On a machine under heavy load even the server's own host may be late once. */
  private static boolean isOpenedOnOwnHost(Farm farm) throws Exception {
    try {
      return farm.session("").hostName().equals("own");
    } catch (LimitExceeded late) {
      return false;
    }
  }

  @Test
  void hostThatHangsHoldsUpNoAdministratorAndNoClient() throws Exception {
    CountDownLatch end = new CountDownLatch(1);
    ServerTuning longLease =
        new ServerTuning(Duration.ofHours(1), Duration.ofHours(1), Duration.ofSeconds(2));
    try (Farm farm = new Farm(1, longLease);
        ServiceOrb orb = ServiceOrb.host(new ListenAddress("127.0.0.1", 0))) {
      HostInfo info = new HostInfo("hanging", "0", orb.endpoint().toString(), 1, 1, 5, 0);
      orb.connectRegistry(farm.server.url())
          .registerHost(
              info,
              MechSimHostHelper.unchecked_narrow(
                  orb.activate(new MechSimHostPOATie(hanging(info, end))).reference()));
      assertThat(farm.admin.getStatus().sessions).isZero();
      Eventually.holds(() -> isOpenedOnOwnHost(farm));
      assertThat(farm.admin.listSimulations(0, 10, new IntHolder())).isEmpty();
      assertThat(farm.admin.listHosts())
          .anySatisfy(
              host -> {
                assertThat(host.reachable).isFalse();
                assertThat(host.text).contains("no answer within 2.0 s");
              });
      end.countDown();
    }
  }
}
