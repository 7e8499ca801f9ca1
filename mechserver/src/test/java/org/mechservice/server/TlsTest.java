package org.mechservice.server;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.net.Inet4Address;
import java.net.InetAddress;
import java.net.NetworkInterface;
import java.net.Socket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.mechservice.idl.IMechSimRemote;
import org.mechservice.idl.JarInfoHolder;
import org.mechservice.idl.MechSim;
import org.mechservice.idl.ModelFile;
import org.mechservice.idl.NameValue;
import org.mechservice.orb.ServiceOrb;
import org.mechservice.orb.ServiceUnreachableException;
import org.mechservice.orb.testing.CursorRows;
import org.mechservice.orb.tls.DetachedSignature;
import org.mechservice.orb.tls.Role;
import org.mechservice.orb.tls.TlsIdentity;
import org.mechservice.server.hosts.PlacementPolicy;
import org.mechservice.server.keys.KeyFolder;
import org.mechservice.sim.host.HostOptions;
import org.mechservice.sim.host.HostSettings;
import org.mechservice.sim.host.SimHostProcess;
import org.omg.CORBA.UserException;

/** Server, host and clients over real encrypted sockets, all who they say they are. */
@Tag("slow")
class TlsTest {
  private static final NameValue[] AS_IN_FILE = new NameValue[0];

  @TempDir private static Path keys;
  @TempDir private static Path others;
  private static MechServerProcess server;
  private static SimHostProcess host;

  @BeforeAll
  static void start() {
    KeyFolder folder = KeyFolder.open(keys);
    folder.localServer();
    folder.server(List.of("elsewhere.invalid"));
    folder.user("alice", Role.CLIENT);
    folder.user("root", Role.ADMIN);
    KeyFolder foreign = KeyFolder.open(others);
    foreign.localServer();
    foreign.user("mallory", Role.ADMIN);
    server = MechServerProcess.start(settings("server"), Farm.STEADY, HostFactory.INSTALLED);
    host = SimHostProcess.start(hostSettings("h", "server"));
  }

  @AfterAll
  static void stop() {
    host.close();
    server.close();
  }

  private static Optional<TlsIdentity> identity(String name) {
    return Optional.of(TlsIdentity.load(keys.resolve(name)));
  }

  private static ServerSettings settings(String identity) {
    return new ServerSettings(
        "127.0.0.1",
        0,
        new HostOptions("own", 1),
        PlacementPolicy.LEAST_LOADED,
        Optional.empty(),
        Optional.empty(),
        identity(identity));
  }

  private static HostSettings hostSettings(String name, String identity) {
    return new HostSettings(
        List.of(server.url()), "127.0.0.1", 0, new HostOptions(name, 2), identity(identity));
  }

  private static String address() {
    return server.url().replaceAll(".*@(.*)/.*", "$1");
  }

  private static List<double[]> run(MechSim session) throws UserException {
    session.loadModel(Pendulum.file(), new ModelFile[0]);
    IMechSimRemote run = session.createSimulation(AS_IN_FILE, null);
    run.start();
    return CursorRows.toEnd(run.openResults(new String[0]), 0);
  }

  @Test
  void clientRunsOnServerAndHostUnderTheNameInItsCertificate() throws Exception {
    assertThat(server.url()).startsWith("corbaloc:ssliop:1.2@127.0.0.1:");
    try (ServiceOrb alice = ServiceOrb.client(identity("alice"));
        ServiceOrb root = ServiceOrb.client(identity("root"))) {
      for (String url : List.of(server.url(), address())) {
        MechSim there = alice.connect(url).createSession("mallory", "h", null);
        MechSim here = alice.connect(url).createSession("mallory", "own", null);
        assertThat(run(there)).usingElementComparator(Arrays::compare).isEqualTo(run(here));
      }
      assertThat(
              root.connectAdmin(server.url())
                  .listSimulations(0, 100, new org.omg.CORBA.IntHolder()))
          .isNotEmpty()
          .allSatisfy(sim -> assertThat(sim.owner).isEqualTo("alice"));
    }
  }

  @Test
  void clientIsCalledBackOverItsOwnConnection() throws Exception {
    RecordedCallbacks callbacks = new RecordedCallbacks();
    try (ServiceOrb alice = ServiceOrb.client(identity("alice"))) {
      MechSim session =
          alice.connect(server.url()).createSession("", "h", alice.export(callbacks.client()));
      run(session);
      callbacks.awaitDone();
    }
  }

  /** They hold places from before TLS has begun; nobody is kept out. */
  @Test
  void fourHundredConnectionsThatSayNothingKeepNobodyOut() throws Exception {
    List<Socket> silent = new ArrayList<>();
    int port = Integer.parseInt(address().replaceAll(".*:", ""));
    try (ServiceOrb alice = ServiceOrb.client(identity("alice"))) {
      for (int i = 0; i < 400; i++) {
        silent.add(new Socket(InetAddress.getLoopbackAddress(), port));
      }
      assertThat(run(alice.connect(server.url()).createSession("", "own", null))).isNotEmpty();
    } finally {
      for (Socket socket : silent) {
        socket.close();
      }
    }
  }

  @Test
  void strangerIsTurnedAway() {
    Optional<TlsIdentity> mallory = Optional.of(TlsIdentity.load(others.resolve("mallory")));
    try (ServiceOrb stranger = ServiceOrb.client(mallory)) {
      assertThatThrownBy(() -> stranger.connect(server.url()))
          .isInstanceOf(ServiceUnreachableException.class)
          .hasMessageStartingWith("S-152 no trust between this process and the server at 127.0.0.1")
          .hasMessageEndingWith("of another authority than this process's, or not valid now");
    }
  }

  @Test
  void serverIsTurnedAwayUnderAnotherName() {
    try (MechServerProcess misnamed = MechServerProcess.start(settings("elsewhere.invalid"));
        ServiceOrb alice = ServiceOrb.client(identity("alice"))) {
      assertThatThrownBy(() -> alice.connect(misnamed.url()))
          .isInstanceOf(ServiceUnreachableException.class)
          .hasMessageStartingWith("S-152")
          .hasMessageContaining("made out to elsewhere.invalid, not to 127.0.0.1");
    }
  }

  @Test
  void userDoesNotPassForAServer() {
    try (MechServerProcess impostor = MechServerProcess.start(settings("alice"));
        ServiceOrb root = ServiceOrb.client(identity("root"))) {
      assertThatThrownBy(() -> root.connect(impostor.url()))
          .isInstanceOf(ServiceUnreachableException.class)
          .hasMessageStartingWith("S-152");
    }
  }

  @Test
  void encryptedAndPlainDoNotMixAndSaySo() throws Exception {
    try (ServiceOrb plain = ServiceOrb.client();
        ServiceOrb alice = ServiceOrb.client(identity("alice"));
        MechServerProcess open =
            MechServerProcess.start(new ServerSettings("open", "127.0.0.1", 0, 1))) {
      assertThatThrownBy(() -> plain.connect(server.url())).hasMessageStartingWith("S-151");
      assertThatThrownBy(() -> alice.connect(open.url())).hasMessageStartingWith("S-151");
      assertThatThrownBy(() -> plain.connect(address()))
          .isInstanceOf(ServiceUnreachableException.class)
          .hasMessageStartingWith("S-151 the server at " + address() + " uses TLS");
      assertThatThrownBy(() -> alice.connect(open.url().replaceAll(".*@(.*)/.*", "$1")))
          .isInstanceOf(ServiceUnreachableException.class)
          .hasMessageStartingWith("S-151 this process uses TLS and the server at 127.0.0.1");
    }
  }

  @Test
  void jarIsSignedByTheHostThatTheClientIsConnectedTo() throws Exception {
    try (ServiceOrb alice = ServiceOrb.client(identity("alice"))) {
      MechSim session = alice.connect(server.url()).createSession("", "h", null);
      session.loadModel(Pendulum.file(), new ModelFile[0]);
      JarInfoHolder info = new JarInfoHolder();
      byte[] jar = session.compileToJar(AS_IN_FILE, info);
      var key = alice.certificateAt(alice.endpointOf(session)).orElseThrow().getPublicKey();
      assertThat(DetachedSignature.fits(key, jar, info.value.signature)).isTrue();
      jar[jar.length / 2] ^= 1;
      assertThat(DetachedSignature.fits(key, jar, info.value.signature)).isFalse();
    }
  }

  @Test
  void silentConnectionsHoldUpNobody() throws Exception {
    int port = Integer.parseInt(address().replaceAll(".*:", ""));
    Socket[] silent = new Socket[60];
    try (ServiceOrb alice = ServiceOrb.client(identity("alice"))) {
      for (int i = 0; i < silent.length; i++) {
        silent[i] = new Socket(InetAddress.getLoopbackAddress(), port);
      }
      assertThat(alice.connect(server.url()).getInfo().serverName).isEqualTo("own");
    } finally {
      for (Socket socket : silent) {
        socket.close();
      }
    }
  }

  @Test
  void networkIsServedOverTls() throws Exception {
    Optional<InetAddress> outside =
        Collections.list(NetworkInterface.getNetworkInterfaces()).stream()
            .flatMap(card -> card.inetAddresses())
            .filter(Inet4Address.class::isInstance)
            .filter(address -> !address.isLoopbackAddress())
            .findFirst();
    org.junit.jupiter.api.Assumptions.assumeTrue(outside.isPresent(), "no network card");
    String address = outside.get().getHostAddress();
    KeyFolder.open(keys).server(List.of(address));
    ServerSettings network =
        new ServerSettings(
            address,
            0,
            new HostOptions("net", 1),
            PlacementPolicy.LEAST_LOADED,
            Optional.empty(),
            Optional.empty(),
            identity(address.replace(':', '-')));
    try (MechServerProcess reachable = MechServerProcess.start(network);
        ServiceOrb alice = ServiceOrb.client(identity("alice"))) {
      assertThat(alice.connect(reachable.url()).createSession("", "", null).hostName())
          .isEqualTo("net");
    }
  }

  @Test
  void everyAddressAtOnceIsNoAddress() {
    ServerSettings any =
        new ServerSettings(
            "0.0.0.0",
            0,
            new HostOptions("any", 1),
            PlacementPolicy.LEAST_LOADED,
            Optional.empty(),
            Optional.empty(),
            identity("server"));
    assertThatThrownBy(() -> MechServerProcess.start(any))
        .hasMessageStartingWith("S-004 cannot listen on 0.0.0.0, which stands for every address");
  }

  @Test
  void keysAreKeptAndReadableByTheirOwnerOnly() throws Exception {
    byte[] before = Files.readAllBytes(keys.resolve("alice/identity.p12"));
    KeyFolder again = KeyFolder.open(keys);
    again.user("alice", Role.CLIENT);
    assertThat(again.made()).isEmpty();
    assertThat(Files.readAllBytes(keys.resolve("alice/identity.p12"))).isEqualTo(before);
    assertThat(Files.getPosixFilePermissions(keys.resolve("ca/identity.p12"))).hasSize(2);
    assertThatThrownBy(() -> again.user("../alice", Role.CLIENT)).hasMessageStartingWith("S-155");
    assertThatThrownBy(() -> TlsIdentity.load(keys))
        .hasMessageStartingWith("S-150")
        .hasMessageContaining("password");
  }
}
