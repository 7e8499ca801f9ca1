package org.mechservice.server;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import java.lang.reflect.Proxy;
import java.time.Duration;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.UnaryOperator;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.mechservice.idl.HostInfo;
import org.mechservice.idl.HostRegistration;
import org.mechservice.idl.HostRegistry;
import org.mechservice.idl.IMechSimRemote;
import org.mechservice.idl.InvalidOption;
import org.mechservice.idl.MechSimHost;
import org.mechservice.idl.MechSimHostHelper;
import org.mechservice.idl.MechSimHostOperations;
import org.mechservice.idl.MechSimHostPOATie;
import org.mechservice.orb.ListenAddress;
import org.mechservice.orb.ServiceOrb;
import org.mechservice.orb.ServiceUnreachableException;
import org.mechservice.orb.testing.Eventually;
import org.mechservice.server.hosts.ServerTuning;
import org.mechservice.sim.host.HostOptions;
import org.mechservice.sim.host.HostSettings;
import org.mechservice.sim.host.SimHost;
import org.mechservice.sim.host.SimHostProcess;
import org.mechservice.sim.service.testing.PacedSolver;
import org.omg.CORBA.BAD_OPERATION;
import org.omg.CORBA.OBJECT_NOT_EXIST;

@Tag("slow")
class HostRegistryTest {
  private static List<String> reachableHosts(Farm farm) throws Exception {
    return Arrays.stream(farm.admin.listHosts())
        .filter(host -> host.reachable)
        .map(host -> host.info.name)
        .toList();
  }

  /** A host that registers by hand, so that it can forget to renew. */
  private static final class Careless implements AutoCloseable {
    final ServiceOrb orb = ServiceOrb.host(new ListenAddress("127.0.0.1", 0));
    final SimHost host;
    final MechSimHost reference;
    final HostRegistry registry;

    Careless(Farm farm, String name) {
      this(farm, name, host -> host);
    }

    /**
     * @param seen how others see the host
     */
    Careless(Farm farm, String name, UnaryOperator<MechSimHostOperations> seen) {
      host = new SimHost(orb, new HostOptions(name, 1), PacedSolver.endless(), () -> {});
      MechSimHostOperations operations = seen.apply(host);
      reference =
          MechSimHostHelper.unchecked_narrow(
              orb.activate(new MechSimHostPOATie(operations)).reference());
      registry = orb.connectRegistry(farm.server.url());
    }

    HostRegistration register(HostInfo info) throws Exception {
      return registry.registerHost(info, reference);
    }

    InvalidOption refusalOf(HostInfo info) {
      return catchThrowableOfType(InvalidOption.class, () -> register(info));
    }

    @Override
    public void close() {
      host.close();
      orb.close();
    }
  }

  @Test
  void hostThatDoesNotRenewIsDroppedAndReported() throws Exception {
    try (Farm farm = new Farm(1, Farm.BRISK);
        Careless careless = new Careless(farm, "careless")) {
      HostRegistration registration = careless.register(careless.host.getInfo());
      assertThat(farm.admin.logs("", 0, 100))
          .anySatisfy(line -> assertThat(line.text).contains("host careless joined"));
      Eventually.holds(() -> !reachableHosts(farm).contains("careless"));
      assertThat(farm.admin.listHosts())
          .anySatisfy(host -> assertThat(host.text).contains("dropped: it has not renewed"));
      assertThat(farm.admin.logs("", 0, 100))
          .anySatisfy(line -> assertThat(line.text).contains("S-019 host careless dropped"));
      assertThatThrownBy(registration::renewLease).isInstanceOf(OBJECT_NOT_EXIST.class);
    }
  }

  @Test
  void hostWhoseConnectionFailsIsDroppedBeforeItsLeaseEnds() throws Exception {
    try (Farm farm = new Farm(1)) {
      try (Careless vanishing = new Careless(farm, "vanishing")) {
        vanishing.register(vanishing.host.getInfo());
        assertThat(reachableHosts(farm)).contains("vanishing");
      }
      Eventually.holds(() -> !reachableHosts(farm).contains("vanishing"));
      assertThat(farm.session("").hostName()).isEqualTo("own");
    }
  }

  @Test
  void hostThatRenewsStays() throws Exception {
    try (Farm farm = new Farm(1, Farm.BRISK)) {
      farm.host("h", 1);
      long severalLeases = System.currentTimeMillis() + 3 * Farm.BRISK.hostLease().toMillis();
      Eventually.holds(
          () ->
              Arrays.stream(farm.admin.listHosts())
                  .anyMatch(
                      known ->
                          known.info.name.equals("h")
                              && known.reachable
                              && known.lastSeen > severalLeases));
    }
  }

  @Test
  void hostThatClosesSignsOff() throws Exception {
    try (Farm farm = new Farm(1)) {
      SimHostProcess host = farm.host("h", 1);
      assertThat(reachableHosts(farm)).contains("h");
      host.close();
      assertThat(Arrays.stream(farm.admin.listHosts()).map(known -> known.info.name))
          .containsExactly("own");
    }
  }

  @Test
  void hostRegistersAgainAtARestartedServer() throws Exception {
    ServerSettings settings = new ServerSettings("own", "127.0.0.1", 0, 1);
    MechServerProcess first = MechServerProcess.start(settings, Farm.BRISK, Farm.ENDLESS_HOST);
    int port = Integer.parseInt(first.url().replaceAll(".*:(\\d+)/.*", "$1"));
    try (SimHostProcess host =
            SimHostProcess.start(new HostSettings(first.url(), "h", "127.0.0.1", 0, 1));
        ServiceOrb orb = ServiceOrb.client()) {
      first.close();
      try (MechServerProcess second =
          MechServerProcess.start(
              new ServerSettings("own", "127.0.0.1", port, 1), Farm.BRISK, Farm.ENDLESS_HOST)) {
        Eventually.holds(
            () ->
                Arrays.stream(orb.connectAdmin(second.url()).listHosts())
                    .anyMatch(known -> known.info.address.equals(host.address())));
      }
    }
  }

  @Test
  void nameOfALivingHostIsRefused() throws Exception {
    try (Farm farm = new Farm(1)) {
      farm.host("h", 1);
      for (String name : List.of("h", "own")) {
        HostSettings settings = new HostSettings(farm.server.url(), name, "127.0.0.1", 0, 1);
        assertThatThrownBy(() -> SimHostProcess.start(settings))
            .isInstanceOf(IllegalArgumentException.class)
            .hasMessageStartingWith("S-013 there is a host \"" + name + "\"");
      }
    }
  }

  /** As a process that has just started may, on a machine under heavy load. */
  @Test
  void hostThatAnswersItsFirstCallLateIsTakenIn() throws Exception {
    ServerTuning impatient =
        new ServerTuning(Duration.ofHours(1), Duration.ofMillis(200), Duration.ofSeconds(2));
    try (Farm farm = new Farm(1, impatient);
        Careless slow = new Careless(farm, "slow", HostRegistryTest::lateOnce)) {
      slow.register(slow.host.getInfo());
      assertThat(reachableHosts(farm)).contains("slow");
    }
  }

  private static MechSimHostOperations lateOnce(MechSimHostOperations host) {
    AtomicBoolean asked = new AtomicBoolean();
    return (MechSimHostOperations)
        Proxy.newProxyInstance(
            MechSimHostOperations.class.getClassLoader(),
            new Class<?>[] {MechSimHostOperations.class},
            (proxy, method, arguments) -> {
              if (method.getName().equals("getInfo") && asked.compareAndSet(false, true)) {
                Thread.sleep(3000); // longer than the server waits
              }
              return method.invoke(host, arguments);
            });
  }

  /** What a server notes of the runs of a host computes nothing there that nobody has asked for. */
  @Test
  void recordsOfRunsOnOtherHostsAreReadWithoutCheckReports() throws Exception {
    for (boolean earlier : new boolean[] {false, true}) {
      List<String> called = new CopyOnWriteArrayList<>();
      try (Farm farm = new Farm(1);
          Careless far = new Careless(farm, "far", host -> noting(host, called, earlier))) {
        far.register(far.host.getInfo());
        IMechSimRemote run = Farm.running(farm.session("far"));
        Eventually.holds(() -> called.contains(earlier ? "showSimulation" : "recordOf"));
        assertThat(reachableHosts(farm)).contains("far");
        assertThat(called.contains("showSimulation")).isEqualTo(earlier);
        assertThat(farm.admin.showSimulation(run.simId()).modelText).contains("MechML");
        assertThat(called).contains("showSimulation");
      }
    }
  }

  /**
   * @param earlier whether the host is of the contract before 1.5
   */
  private static MechSimHostOperations noting(
      MechSimHostOperations host, List<String> called, boolean earlier) {
    return (MechSimHostOperations)
        Proxy.newProxyInstance(
            MechSimHostOperations.class.getClassLoader(),
            new Class<?>[] {MechSimHostOperations.class},
            (proxy, method, arguments) -> {
              if (earlier && method.getName().equals("recordOf")) {
                throw new BAD_OPERATION();
              }
              called.add(method.getName());
              return method.invoke(host, arguments);
            });
  }

  @Test
  void hostThatLiesAboutItselfIsRefused() throws Exception {
    try (Farm farm = new Farm(1);
        Careless liar = new Careless(farm, "liar")) {
      HostInfo elsewhere = liar.host.getInfo();
      elsewhere.address = "127.0.0.1:9";
      assertThat(liar.refusalOf(elsewhere).optionName).isEqualTo("address");
      HostInfo otherName = liar.host.getInfo();
      otherName.name = "other";
      assertThat(liar.refusalOf(otherName).text).contains("cannot reach host other");
      HostInfo noPlaces = liar.host.getInfo();
      noPlaces.capacity = 0;
      assertThat(liar.refusalOf(noPlaces).optionName).isEqualTo("capacity");
      HostInfo oddName = liar.host.getInfo();
      oddName.name = "a\nb";
      assertThat(liar.refusalOf(oddName).optionName).isEqualTo("name");
    }
  }

  @Test
  void hostWithoutServerDoesNotStart() {
    HostSettings settings = new HostSettings("127.0.0.1:1", "h", "127.0.0.1", 0, 1);
    assertThatThrownBy(() -> SimHostProcess.start(settings))
        .isInstanceOf(ServiceUnreachableException.class)
        .hasMessageStartingWith("S-002");
  }
}
