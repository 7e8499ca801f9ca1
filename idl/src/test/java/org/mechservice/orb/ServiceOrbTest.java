package org.mechservice.orb;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import java.io.DataOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.net.SocketException;
import java.net.SocketTimeoutException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.Set;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.idl.API_VERSION;
import org.mechservice.idl.IMechClient;
import org.mechservice.idl.IMechClientHelper;
import org.mechservice.idl.IMechClientPOATie;
import org.mechservice.idl.MechServer;
import org.mechservice.idl.ServerFailure;
import org.omg.CORBA.OBJECT_NOT_EXIST;
import org.omg.CORBA.SystemException;

@Tag("slow")
class ServiceOrbTest {
  private static final int SEED = 20260;

  @TempDir private Path folder;

  @Test
  void serverIsReachedByEveryFormOfItsAddress() throws IOException {
    try (EchoServer server = EchoServer.start();
        ServiceOrb client = ServiceOrb.client()) {
      Path file = folder.resolve("server.url");
      Files.writeString(file, "corbaloc:iiop:1.2@" + server.address() + "/MechServer\n");
      for (String url :
          new String[] {
            server.address(),
            "localhost:" + server.port(),
            "corbaloc::" + server.address() + "/MechServer",
            "corbaloc:iiop:1.2@" + server.address() + "/MechServer",
            file.toString(),
            file.toUri().toString()
          }) {
        assertThat(client.connect(url).getInfo().serverName).as(url).isEqualTo("echo €");
      }
    }
  }

  @Test
  void serverIsReachedByItsReference() {
    try (EchoServer server = EchoServer.start();
        ServiceOrb client = ServiceOrb.client()) {
      MechServer byAddress = client.connect(server.address());
      assertThat(client.connect(client.toIor(byAddress)).getInfo().serverName).isEqualTo("echo €");
    }
  }

  @Test
  void callbacksComeOverTheClientsOwnConnection() {
    try (EchoServer server = EchoServer.start();
        ServiceOrb client = ServiceOrb.client()) {
      CountingClient callbacks = new CountingClient();
      IMechClient exported = client.export(callbacks);
      ServerFailure answer = askToBeCalledBack(client.connect(server.address()), exported);
      assertThat(answer.code).isEqualTo("called back");
      assertThat(callbacks.heartbeats).hasValue(1);
    }
  }

  @Test
  void withdrawnCallbacksAreGone() {
    try (EchoServer server = EchoServer.start();
        ServiceOrb client = ServiceOrb.client()) {
      IMechClient exported = client.export(new CountingClient());
      client.withdraw(exported);
      ServerFailure answer = askToBeCalledBack(client.connect(server.address()), exported);
      assertThat(answer.text).contains(OBJECT_NOT_EXIST.class.getSimpleName());
    }
  }

  @Test
  void serverConnectsToNobodyWhoIsNotRegistered() throws IOException {
    try (EchoServer server = EchoServer.start();
        EchoServer stranger = EchoServer.start();
        ServiceOrb client = ServiceOrb.client()) {
      // A reference to somebody else, passed off as the caller's own callback.
      IMechClient foreign = IMechClientHelper.unchecked_narrow(client.connect(stranger.address()));
      ServerFailure answer = askToBeCalledBack(client.connect(server.address()), foreign);
      assertThat(answer.text).contains("TRANSIENT");
    }
  }

  private static ServerFailure askToBeCalledBack(MechServer server, IMechClient callbacks) {
    return catchThrowableOfType(
        ServerFailure.class, () -> server.createSession("me", "", callbacks));
  }

  @Test
  void takenPortIsNamed() throws IOException {
    try (ServerSocket taken = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
      ListenAddress address = new ListenAddress("127.0.0.1", taken.getLocalPort());
      assertThatThrownBy(() -> ServiceOrb.server(address))
          .isInstanceOf(PortInUseException.class)
          .hasMessageStartingWith("S-003 cannot listen on " + address + ":");
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"0.0.0.0", "192.0.2.1", "no.such.host.invalid", ""})
  void addressOtherMachinesCouldReachIsRefused(String host) {
    assertThatThrownBy(() -> new ListenAddress(host, 0))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageStartingWith("S-004 cannot listen on " + host);
  }

  @Test
  void silentPortIsUnreachable() throws IOException {
    int port;
    try (ServerSocket closedAtOnce = new ServerSocket(0)) {
      port = closedAtOnce.getLocalPort();
    }
    try (ServiceOrb client = ServiceOrb.client()) {
      assertThatThrownBy(() -> client.connect("127.0.0.1:" + port))
          .isInstanceOf(ServiceUnreachableException.class)
          .hasMessageStartingWith("S-002 no server answers at 127.0.0.1:" + port);
    }
  }

  @Test
  void unknownHostIsUnreachable() {
    try (ServiceOrb client = ServiceOrb.client()) {
      assertThatThrownBy(() -> client.connect("no.such.host.invalid:15000"))
          .isInstanceOf(ServiceUnreachableException.class)
          .hasMessageStartingWith("S-002 no server at no.such.host.invalid:15000: no such host");
    }
  }

  @Test
  void somethingElseThatAnswersIsNoService() throws IOException {
    try (ServerSocket web = new ServerSocket(0, 5, InetAddress.getLoopbackAddress());
        ServiceOrb client = ServiceOrb.client()) {
      String address = "127.0.0.1:" + web.getLocalPort();
      ExecutorService answering = Executors.newSingleThreadExecutor();
      answering.execute(() -> answerLikeAWebServer(web));
      assertThatThrownBy(() -> client.connect(address))
          .isInstanceOf(ServiceUnreachableException.class)
          .hasMessageStartingWith("S-005 what answers at " + address + " is not a MechService");
      answering.shutdown();
    }
  }

  private static void answerLikeAWebServer(ServerSocket web) {
    while (!web.isClosed()) {
      try (Socket socket = web.accept()) {
        socket
            .getOutputStream()
            .write("HTTP/1.1 400 Bad Request\r\n\r\n".getBytes(StandardCharsets.US_ASCII));
        socket.getOutputStream().flush();
      } catch (IOException e) {
        assertThat(e).isNotNull(); // the test is over, or the client has gone
      }
    }
  }

  @Test
  void somethingThatNeverAnswersIsUnreachable() throws IOException {
    try (ServerSocket hanging = new ServerSocket(0, 5, InetAddress.getLoopbackAddress());
        ServiceOrb client = ServiceOrb.client()) {
      String address = "127.0.0.1:" + hanging.getLocalPort();
      assertThatThrownBy(() -> client.connect(address))
          .isInstanceOf(ServiceUnreachableException.class)
          .hasMessageStartingWith("S-002 no answer from " + address);
    }
  }

  @Test
  void serverOfAnotherApiIsRefusedByName() {
    try (EchoServer server = EchoServer.start("2.0");
        ServiceOrb client = ServiceOrb.client()) {
      assertThatThrownBy(() -> client.connect(server.address()))
          .isInstanceOf(ServiceUnreachableException.class)
          .hasMessageContaining("speaks API 2.0, this client " + API_VERSION.value);
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"", "http://127.0.0.1:80/", "127.0.0.1:99999", "a b", "IOR:00ff"})
  void whatIsNoAddressIsRefused(String url) {
    try (ServiceOrb client = ServiceOrb.client()) {
      assertThatThrownBy(() -> client.connect(url))
          .isInstanceOf(IllegalArgumentException.class)
          .hasMessageStartingWith("S-006");
    }
  }

  /** Some say nothing, some begin a message; a client that has called once keeps its place. */
  @Test
  void connectionsThatSayNothingKeepNobodyOut() throws IOException {
    List<Socket> silent = new ArrayList<>();
    try (EchoServer server = EchoServer.start();
        ServiceOrb early = ServiceOrb.client();
        ServiceOrb late = ServiceOrb.client()) {
      server.allowConnections(50);
      MechServer asked = early.connect(server.address());
      for (int i = 0; i < 200; i++) {
        Socket socket = new Socket(InetAddress.getLoopbackAddress(), server.port());
        silent.add(socket);
        if (i % 2 == 0) {
          socket.getOutputStream().write("GIOP".getBytes(StandardCharsets.US_ASCII));
        }
      }
      assertThat(late.connect(server.address()).getInfo().serverName).isEqualTo("echo €");
      assertThat(asked.getInfo().serverName).isEqualTo("echo €");
      assertThat(server.connections()).isEqualTo(2);
    } finally {
      for (Socket socket : silent) {
        socket.close();
      }
    }
  }

  /** All call once and then say nothing more; only one has an object that lives by its calls. */
  @Test
  void idleConnectionsGiveTheirPlacesToNewOnes() {
    List<ServiceOrb> idle = new ArrayList<>();
    List<MechServer> asked = new ArrayList<>();
    try (EchoServer server = EchoServer.start();
        ServiceOrb owner = ServiceOrb.client()) {
      server.allowConnections(10);
      List<IMechClient> back = new CopyOnWriteArrayList<>();
      server.onSession(back::add);
      CountingClient callbacks = new CountingClient();
      askToBeCalledBack(owner.connect(server.address()), owner.export(callbacks));
      IMechClientHelper.unchecked_narrow(owner.fromIor(server.object())).heartbeat();
      for (int i = 0; i < 30; i++) {
        ServiceOrb other = ServiceOrb.client();
        idle.add(other);
        asked.add(other.connect(server.address()));
      }
      assertThat(server.connections()).isEqualTo(10);
      assertThat(server.busyConnections()).isOne(); // the owner's
      back.get(0).heartbeat(); // over the owner's connection
      assertThat(callbacks.heartbeats).hasValue(1);
      assertThat(asked.get(0).getInfo().serverName).isEqualTo("echo €");
    } finally {
      idle.forEach(ServiceOrb::close);
    }
  }

  @Test
  void garbageLeavesTheServerServing() throws IOException {
    Random random = new Random(SEED);
    try (EchoServer server = EchoServer.start();
        ServiceOrb client = ServiceOrb.client()) {
      for (int i = 0; i < 50; i++) {
        byte[] garbage = new byte[1 + random.nextInt(4000)];
        random.nextBytes(garbage);
        send(server.port(), garbage);
      }
      assertThat(client.connect(server.address()).getInfo().serverName).isEqualTo("echo €");
    }
  }

  @ParameterizedTest
  @ValueSource(ints = {0x7FFFFFFF, 0x7FFFFFF0, 1_500_000_000, 200_000_000, -1})
  void lyingLengthTakesNoMemoryAndLeavesTheServerServing(int length) throws IOException {
    try (EchoServer server = EchoServer.start();
        ServiceOrb client = ServiceOrb.client()) {
      try (Socket socket = new Socket(InetAddress.getLoopbackAddress(), server.port())) {
        DataOutputStream out = new DataOutputStream(socket.getOutputStream());
        out.write(new byte[] {'G', 'I', 'O', 'P', 1, 2, 0, 0});
        out.writeInt(length);
        out.flush();
        if (length > 0) {
          // Refused before the body: the connection is closed at once.
          assertThat(closedByServer(socket)).isTrue();
        }
      }
      assertThat(client.connect(server.address()).getInfo().serverName).isEqualTo("echo €");
    }
  }

  private static boolean closedByServer(Socket socket) throws IOException {
    socket.setSoTimeout(10_000);
    try {
      socket.getInputStream().transferTo(OutputStream.nullOutputStream());
      return true;
    } catch (SocketTimeoutException stillOpen) {
      return false;
    } catch (SocketException reset) {
      return true;
    }
  }

  private static void send(int port, byte[] bytes) throws IOException {
    try (Socket socket = new Socket(InetAddress.getLoopbackAddress(), port)) {
      socket.getOutputStream().write(bytes);
    } catch (SocketException closedByServer) {
      assertThat(closedByServer).isNotNull();
    }
  }

  @Test
  void noThreadIsLeftAfterClosing() throws InterruptedException {
    Set<Thread> before = Thread.getAllStackTraces().keySet();
    try (EchoServer server = EchoServer.start();
        ServiceOrb client = ServiceOrb.client()) {
      askToBeCalledBack(client.connect(server.address()), client.export(new CountingClient()));
    }
    Set<Thread> left =
        Thread.getAllStackTraces().keySet().stream()
            .filter(thread -> !before.contains(thread))
            .collect(Collectors.toSet());
    for (Thread thread : left) {
      thread.join(5000);
    }
    assertThat(left).noneMatch(Thread::isAlive);
  }

  @Test
  void closedServerIsUnreachableAndItsPortIsFree() {
    EchoServer server = EchoServer.start();
    int port = server.port();
    server.close();
    try (ServiceOrb client = ServiceOrb.client()) {
      assertThatThrownBy(() -> client.connect("127.0.0.1:" + port))
          .isInstanceOf(ServiceUnreachableException.class);
    }
    try (ServiceOrb next = ServiceOrb.server(new ListenAddress("127.0.0.1", port))) {
      assertThat(next.endpoint().port()).isEqualTo(port);
    }
  }

  @Test
  void twoClientsOfOneProcessGetTheirOwnCallbacks() {
    try (EchoServer server = EchoServer.start();
        ServiceOrb first = ServiceOrb.client();
        ServiceOrb second = ServiceOrb.client()) {
      CountingClient callbacksOfFirst = new CountingClient();
      CountingClient callbacksOfSecond = new CountingClient();
      MechServer seenByFirst = first.connect(server.address());
      MechServer seenBySecond = second.connect(server.address());
      askToBeCalledBack(seenByFirst, first.export(callbacksOfFirst));
      askToBeCalledBack(seenBySecond, second.export(callbacksOfSecond));
      askToBeCalledBack(seenBySecond, second.export(callbacksOfSecond));
      assertThat(callbacksOfFirst.heartbeats).hasValue(1);
      assertThat(callbacksOfSecond.heartbeats).hasValue(2);
    }
  }

  @Test
  void endedObjectDoesNotExist() {
    try (ServiceOrb host = ServiceOrb.host(new ListenAddress("127.0.0.1", 0));
        ServiceOrb client = ServiceOrb.client()) {
      ActiveObject object = host.activate(new IMechClientPOATie(new CountingClient()));
      IMechClient seen =
          IMechClientHelper.unchecked_narrow(client.fromIor(host.toIor(object.reference())));
      seen.heartbeat();
      object.close();
      assertThatThrownBy(seen::heartbeat)
          .isInstanceOf(SystemException.class)
          .isInstanceOf(OBJECT_NOT_EXIST.class);
    }
  }
}
