package org.mechservice.server;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Proxy;
import java.time.Duration;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.mechservice.idl.HostStatus;
import org.mechservice.idl.IMechSimRemote;
import org.mechservice.idl.Limit;
import org.mechservice.idl.MechSimHostHelper;
import org.mechservice.idl.MechSimHostOperations;
import org.mechservice.idl.MechSimHostPOATie;
import org.mechservice.idl.NotFound;
import org.mechservice.idl.SimDetail;
import org.mechservice.idl.SimState;
import org.mechservice.idl.SimSummary;
import org.mechservice.orb.ListenAddress;
import org.mechservice.orb.ServiceOrb;
import org.mechservice.orb.testing.Eventually;
import org.mechservice.server.hosts.ServerTuning;
import org.mechservice.sim.host.HostOptions;
import org.mechservice.sim.host.SimHost;
import org.mechservice.sim.service.testing.PacedSolver;
import org.omg.CORBA.IntHolder;

/** A host that still has its connection but answers nothing, beside one that does answer. */
@Tag("slow")
class SilentHostTest {
  /** Nobody is dropped; who has not answered for two seconds is silent. */
  private static final ServerTuning PATIENT =
      new ServerTuning(
          Duration.ofHours(1),
          Duration.ofMillis(100),
          Duration.ofSeconds(2),
          Duration.ofSeconds(2));

  private final Farm farm = new Farm(1, PATIENT);
  private final ServiceOrb orb = ServiceOrb.host(new ListenAddress("127.0.0.1", 0));
  private final SimHost host =
      new SimHost(orb, new HostOptions("moody", 2), PacedSolver.endless(), () -> {});
  private final AtomicInteger waiting = new AtomicInteger();
  private volatile boolean silent;

  @BeforeEach
  void register() throws Exception {
    orb.connectRegistry(farm.server.url())
        .registerHost(
            host.getInfo(),
            MechSimHostHelper.unchecked_narrow(
                orb.activate(new MechSimHostPOATie(moody())).reference()));
  }

  private MechSimHostOperations moody() {
    return (MechSimHostOperations)
        Proxy.newProxyInstance(
            MechSimHostOperations.class.getClassLoader(),
            new Class<?>[] {MechSimHostOperations.class},
            (proxy, method, arguments) -> {
              awaitGoodMood();
              try {
                return method.invoke(host, arguments);
              } catch (InvocationTargetException e) {
                throw e.getCause();
              }
            });
  }

  private synchronized void awaitGoodMood() throws InterruptedException {
    waiting.incrementAndGet();
    while (silent) {
      wait();
    }
    waiting.decrementAndGet();
  }

  private synchronized void turn(boolean into) {
    silent = into;
    notifyAll();
  }

  @AfterEach
  void close() {
    turn(false);
    farm.close();
    host.close();
    orb.close();
  }

  private HostStatus status() throws Exception {
    return Arrays.stream(farm.admin.listHosts())
        .filter(known -> known.info.name.equals("moody"))
        .findFirst()
        .orElseThrow();
  }

  private List<SimSummary> simulations() throws Exception {
    return List.of(farm.admin.listSimulations(0, 100, new IntHolder()));
  }

  private IMechSimRemote runningThere() throws Exception {
    IMechSimRemote run = Farm.running(farm.session("moody"));
    Eventually.holds(() -> simulations().get(0).info.state == SimState.SIM_RUNNING);
    Eventually.holds(() -> status().load.running == 1);
    return run;
  }

  private void turnSilent() throws Exception {
    turn(true);
    Eventually.holds(() -> !status().reachable);
  }

  @Test
  void isShownAsSilentSinceWhenWithWhatWasKnownLast() throws Exception {
    String simId = runningThere().simId();
    turnSilent();
    HostStatus status = status();
    assertThat(status.text).matches("silent since 20\\S+Z: no answer within 2\\.0 s");
    assertThat(status.load.running).isEqualTo(1);
    assertThat(farm.admin.getStatus().running).isEqualTo(1);
    SimSummary run = simulations().get(0);
    assertThat(run.simId).isEqualTo(simId);
    assertThat(run.info.state).isEqualTo(SimState.SIM_RUNNING);
    assertThat(run.text).startsWith("host moody is silent since 20").endsWith("known: running");
    SimDetail detail = farm.admin.showSimulation(simId);
    assertThat(detail.summary.text).startsWith("host moody is silent since 20");
  }

  @Test
  void isAskedInTheBackgroundOnly() throws Exception {
    runningThere();
    turnSilent();
    Eventually.holds(() -> waiting.get() > 0);
    int questions = waiting.get();
    for (int i = 0; i < 50; i++) {
      farm.admin.getStatus();
      simulations();
      farm.admin.listHosts();
    }
    // 150 answers were given; in the background it is asked again when the ORB has given up.
    assertThat(waiting.get()).isLessThan(questions + 5);
  }

  @Test
  void refusesAtOnceWhatItIsAskedByName() throws Exception {
    String simId = runningThere().simId();
    turnSilent();
    for (NotFound refusal :
        List.of(
            catchThrowableOfType(NotFound.class, () -> farm.admin.logs("moody", 0, 1)),
            catchThrowableOfType(NotFound.class, () -> farm.admin.drain("moody")))) {
      assertThat(refusal.text).startsWith("host moody does not answer; silent since 20");
    }
    assertThatThrownBy(() -> farm.admin.killSimulation(simId, "x"))
        .isInstanceOfSatisfying(
            NotFound.class,
            refusal -> assertThat(refusal.text).contains("it may be on moody, which does not"));
  }

  @Test
  void isShownAsItIsOnceItAnswersAgain() throws Exception {
    IMechSimRemote run = runningThere();
    turnSilent();
    turn(false);
    Eventually.holds(() -> status().reachable);
    assertThat(status().text).isEmpty();
    run.cancel();
    Eventually.holds(() -> simulations().get(0).info.state == SimState.SIM_CANCELLED);
  }

  @Test
  void limitsSetMeanwhileHoldOnceItAnswersAgain() throws Exception {
    turnSilent();
    farm.admin.setLimits("", new Limit[] {new Limit("cursors", "", 3, "")});
    turn(false);
    Eventually.holds(() -> status().reachable);
    Eventually.holds(
        () ->
            Arrays.stream(farm.admin.getLimits("moody"))
                .anyMatch(limit -> limit.name.equals("cursors") && limit.value == 3));
  }

  /** It was asked where something is that it does not have, which is an answer. */
  @Test
  void hostThatKnowsNoSuchSessionIsNotSilent() throws Exception {
    assertThatThrownBy(() -> farm.service.findSession("none")).isInstanceOf(NotFound.class);
    assertThat(status().reachable).isTrue();
    assertThat(farm.session("moody").hostName()).isEqualTo("moody");
  }
}
