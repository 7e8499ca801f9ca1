package org.mechservice.load;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.Socket;
import java.net.SocketTimeoutException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.function.Supplier;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import javax.net.SocketFactory;
import javax.net.ssl.SSLSocket;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.mechservice.client.MechConnection;
import org.mechservice.client.MechSession;
import org.mechservice.client.SimulationOptions;
import org.mechservice.client.jar.JarCache;
import org.mechservice.idl.IMechSimRemote;
import org.mechservice.idl.MechServer;
import org.mechservice.idl.MechSim;
import org.mechservice.idl.ModelFile;
import org.mechservice.idl.NameValue;
import org.mechservice.idl.ResultCursor;
import org.mechservice.load.ServiceJvm.Inside;
import org.mechservice.orb.ServiceOrb;
import org.omg.CORBA.SystemException;
import org.omg.CORBA.UserException;

/**
 * A million requests with damaged bytes, to a server and to a host, over plain connections and over
 * TLS, from strangers and from users: all go on serving, and keep nothing.
 */
@Tag("soak")
class MutatedMessagesTest {
  private static final long SEED = 20261125;
  private static final int HEAP_MEGABYTES = 192;

  /** Handshakes by the thousand: without the optimising compiler each takes 14 ms. */
  private static final List<String> OPTIMISED = List.of("-XX:TieredStopAtLevel=4");

  private static final int LEASE_SECONDS = 10;
  private static final long LEASES_END_MILLIS = 1000L * (LEASE_SECONDS + 2);

  /** Messages over one connection; most connections are closed before. */
  private static final int PER_CONNECTION = 20;

  /** Connections at once, each with objects of its own to attack. */
  private static final int SENDERS = 4;

  /** Connections after which a sender looks whether what it attacks is still there. */
  private static final int BETWEEN_LOOKS = 10;

  private static final int HANDSHAKE_MILLIS = 30_000;

  /** Longest wait for an answer, or for the other side to close, before the next message. */
  private static final int ANSWER_MILLIS = 2;

  /** Java's own bookkeeping goes up and down by this much, and a class is loaded now and then. */
  private static final long NOISE_BYTES = 6_000_000;

  @TempDir Path folder;

  private final SoakPage page =
      new SoakPage(
          "Mutated messages",
          "Requests to every kind of object (server, administration, registry, session, simulation,"
              + " cursor), of versions 1.0 and 1.2 of the protocol, with bytes changed, cut out or"
              + " put in, up to "
              + PER_CONNECTION
              + " over one connection, over "
              + SENDERS
              + " connections at once, each message when the one before was answered, or "
              + ANSWER_MILLIS
              + " ms after it. They go to the port of a server and to that of its host,"
              + " over plain connections; over TLS by a program that shows no certificate; and over"
              + " TLS by a user. Sessions, simulations and cursors among the targets exist, and are"
              + " made anew when a message has ended them, which is looked at every "
              + BETWEEN_LOOKS
              + " connections. After each row an honest client, who is"
              + " connected all the time, simulates on the host and gets its rows to the last bit."
              + " Heap (with `-Xmx"
              + HEAP_MEGABYTES
              + "m`), objects, threads and files are those of the attacked process after a full"
              + " collection, when the leases have ended; before and after the row. Incidents are"
              + " errors that the service did not expect ([S-001](../errors/S-001.md)).",
          SEED);

  private int sent;
  private int rows;

  @Test
  void everyPortSurvives() throws Exception {
    page.line(
        "| port | sender | messages | answers | connections | heap, MB | objects | threads | files |"
            + " incidents |");
    page.line("|---|---|---|---|---|---|---|---|---|---|");
    attackPlain(330_000);
    TlsKeys keys = TlsKeys.make(folder.resolve("keys"), "ann", "eve");
    attackEncrypted(keys, 20_000, 150_000);
    page.line("%n%d messages in all.", sent);
    assertThat(sent).isGreaterThanOrEqualTo(1_000_000);
    page.write("service-mutated-messages.md");
  }

  private static ServiceJvm server(String... more) throws IOException {
    List<String> words =
        new ArrayList<>(List.of("server", "--listen", "127.0.0.1:0", "--capacity", "0"));
    words.addAll(List.of("--limit", "lease=" + LEASE_SECONDS));
    words.addAll(List.of(more));
    return ServiceJvm.start(List.of(), HEAP_MEGABYTES, OPTIMISED, words.toArray(String[]::new));
  }

  private static ServiceJvm host(ServiceJvm server, String... more) throws IOException {
    List<String> words = new ArrayList<>(List.of("simhost", "--server", server.address()));
    words.addAll(List.of("--listen", "127.0.0.1:0", "--name", "far", "--capacity", "2"));
    words.addAll(List.of("--limit", "lease=" + LEASE_SECONDS));
    words.addAll(List.of(more));
    return ServiceJvm.start(List.of(), HEAP_MEGABYTES, OPTIMISED, words.toArray(String[]::new));
  }

  private void attackPlain(int each) throws Exception {
    try (ServiceJvm server = server();
        ServiceJvm host = host(server);
        ServiceOrb orb = ServiceOrb.client();
        MechConnection honest = MechConnection.open(server.address(), JarCache.ofUser());
        MechSession session = honest.openSession("far")) {
      session.loadModel(Runs.PENDULUM);
      List<Long> alone = Runs.bits(session, SimulationOptions.asInFile(), false);
      Supplier<Targets> ofServer = () -> new Targets(orb, server.address(), false);
      Supplier<Targets> ofHost = () -> new Targets(orb, server.address(), true);
      SocketFactory plain = SocketFactory.getDefault();
      Attacked atServer = new Attacked("server", server);
      Attacked atHost = new Attacked("host", host);
      Thread.sleep(LEASES_END_MILLIS);
      attack(atServer, "anybody, plain", plain, ofServer, each);
      assertServes(session, alone);
      attack(atHost, "anybody, plain", plain, ofHost, each);
      assertServes(session, alone);
    }
  }

  private void attackEncrypted(TlsKeys keys, int strangers, int users) throws Exception {
    String[] tls = {"--tls", keys.of("server")};
    try (ServiceJvm server = server(tls);
        ServiceJvm host = host(server, tls);
        ServiceOrb orb = ServiceOrb.client(keys.identity("eve"));
        MechConnection honest =
            MechConnection.open(
                server.address(), new JarCache(folder.resolve("jars")), keys.identity("ann"));
        MechSession session = honest.openSession("far")) {
      session.loadModel(Runs.PENDULUM);
      List<Long> alone = Runs.bits(session, SimulationOptions.asInFile(), false);
      Supplier<Targets> ofServer = () -> new Targets(orb, server.address(), false);
      Supplier<Targets> ofHost = () -> new Targets(orb, server.address(), true);
      SocketFactory stranger = keys.context("eve", false).getSocketFactory();
      SocketFactory user = keys.context("eve", true).getSocketFactory();
      String without = "a stranger, TLS without a certificate";
      Attacked atServer = new Attacked("server", server);
      Attacked atHost = new Attacked("host", host);
      Thread.sleep(LEASES_END_MILLIS);
      attack(atServer, without, stranger, ofServer, strangers);
      attack(atHost, without, stranger, ofHost, strangers);
      assertServes(session, alone);
      attack(atServer, "a user, TLS", user, ofServer, users);
      assertServes(session, alone);
      attack(atHost, "a user, TLS", user, ofHost, users);
      assertServes(session, alone);
    }
  }

  private static void assertServes(MechSession session, List<Long> alone) throws IOException {
    assertThat(Runs.bits(session, SimulationOptions.asInFile(), false)).isEqualTo(alone);
  }

  /** A process whose port is attacked. */
  private record Attacked(String port, ServiceJvm process) {}

  /** What one sender has sent. */
  private record Sent(int messages, int answers, int connections) {
    Sent and(Sent more) {
      return new Sent(
          messages + more.messages, answers + more.answers, connections + more.connections);
    }
  }

  private void attack(
      Attacked attacked, String sender, SocketFactory sockets, Supplier<Targets> targets, int count)
      throws Exception {
    ServiceJvm process = attacked.process();
    String which = attacked.port() + ", " + sender;
    Inside before = process.inside();
    int incidents = incidents(process);
    Sent all = new Sent(0, 0, 0);
    ExecutorService senders = Executors.newFixedThreadPool(SENDERS);
    try {
      List<Future<Sent>> each = new ArrayList<>();
      for (int i = 0; i < SENDERS; i++) {
        Random random = new Random(SEED + rows++);
        int share = count / SENDERS;
        each.add(senders.submit(() -> sendAll(process.port(), sockets, targets, share, random)));
      }
      for (Future<Sent> one : each) {
        all = all.and(one.get());
      }
    } finally {
      senders.shutdownNow();
    }
    sent += all.messages();
    assertThat(process.alive()).as(which).isTrue();
    Thread.sleep(LEASES_END_MILLIS);
    Inside after =
        process.insideOnce(
            each ->
                each.heapBytes() < before.heapBytes() + NOISE_BYTES
                    && each.files() <= before.files() + 5);
    int found = incidents(process) - incidents;
    page.line(
        "| %s | %s | %d | %d | %d | %.1f, %.1f | %d, %d | %d, %d | %d, %d | %d |",
        attacked.port(),
        sender,
        all.messages(),
        all.answers(),
        all.connections(),
        before.heapBytes() * 1e-6,
        after.heapBytes() * 1e-6,
        before.objects(),
        after.objects(),
        before.threads(),
        after.threads(),
        before.files(),
        after.files(),
        found);
    assertThat(process.messages()).as(which).doesNotContain("OutOfMemoryError");
    assertThat(found).as(which + ": " + kinds(process)).isZero();
    assertThat(after.heapBytes())
        .as(which + ", largest:\n" + process.largest())
        .isLessThan(before.heapBytes() + NOISE_BYTES);
    assertThat(after.files()).as(which).isLessThanOrEqualTo(before.files() + 5);
  }

  private static Sent sendAll(
      int port, SocketFactory sockets, Supplier<Targets> targets, int count, Random random)
      throws Exception {
    Sent all = new Sent(0, 0, 0);
    Targets attacked = targets.get();
    while (all.messages() < count) {
      if (all.connections() % BETWEEN_LOOKS == 0) {
        attacked.renew();
      }
      assertThat(all.connections())
          .as("connections, most of which take a message")
          .isLessThan(2 * count);
      int most = Math.min(PER_CONNECTION, count - all.messages());
      all = all.and(send(port, sockets, attacked.messages(), most, random));
    }
    attacked.end();
    return all;
  }

  private static int incidents(ServiceJvm attacked) throws IOException {
    return attacked.messages().split("S-001", -1).length - 1;
  }

  /** Returns the different incidents: what was thrown, and where. */
  private static String kinds(ServiceJvm attacked) throws IOException {
    return Pattern.compile("S-001[^\\n]* (in [^\\n]*\\n(?:[^\\n]*\\n){1,12})")
        .matcher(attacked.messages())
        .results()
        .map(found -> found.group(1).replaceAll("-?\\d+", "N"))
        .distinct()
        .collect(Collectors.joining("\n"));
  }

  /** Sends messages until the other side closes. */
  private static Sent send(
      int port, SocketFactory sockets, List<byte[]> valid, int most, Random random) {
    int count = 0;
    int answers = 0;
    try (Socket socket = sockets.createSocket(InetAddress.getLoopbackAddress(), port)) {
      if (socket instanceof SSLSocket encrypted) {
        socket.setSoTimeout(HANDSHAKE_MILLIS);
        encrypted.startHandshake();
      }
      socket.setSoTimeout(ANSWER_MILLIS);
      OutputStream out = socket.getOutputStream();
      InputStream in = socket.getInputStream();
      byte[] replies = new byte[1 << 16];
      int read = 0;
      while (read >= 0 && count < most) {
        out.write(mutated(valid.get(random.nextInt(valid.size())), random));
        out.flush();
        count++;
        read = read(in, replies);
        answers += read > 0 ? 1 : 0;
      }
    } catch (IOException closedByServer) {
      return new Sent(count, answers, 1);
    }
    return new Sent(count, answers, 1);
  }

  /** Returns how many bytes have come: 0 if none has yet, -1 if the other side has closed. */
  private static int read(InputStream in, byte[] replies) throws IOException {
    try {
      return in.read(replies);
    } catch (SocketTimeoutException nothingYet) {
      return 0;
    }
  }

  private static byte[] mutated(byte[] message, Random random) {
    byte[] changed = message.clone();
    for (int i = random.nextInt(4); i >= 0 && changed.length > Giop.HEADER_BYTES; i--) {
      // Half of the changes leave the header alone, else most messages would never be looked at.
      int first = random.nextBoolean() ? Giop.HEADER_BYTES : 0;
      int place = first + random.nextInt(changed.length - first);
      switch (random.nextInt(5)) {
        case 0 -> changed[place] = (byte) random.nextInt(256);
        case 1 -> changed[place] ^= (byte) (1 << random.nextInt(8));
        case 2 ->
            ByteBuffer.wrap(changed).putInt(place / 4 * 4 % (changed.length - 4), odd(random));
        case 3 ->
            changed = spliced(changed, place, Math.min(changed.length, place + 4), new byte[0]);
        default -> {
          byte[] more = new byte[1 + random.nextInt(8)];
          random.nextBytes(more);
          changed = spliced(changed, place, place, more);
        }
      }
    }
    if (random.nextBoolean()) { // the length is right again
      ByteBuffer.wrap(changed).putInt(8, changed.length - Giop.HEADER_BYTES);
    }
    return changed;
  }

  /** Returns a number at the edge of something. */
  private static int odd(Random random) {
    int[] all = {0, 1, -1, Integer.MAX_VALUE, Integer.MIN_VALUE, 0x7FFFFFF0, 1 << 20, 1 << 25};
    return all[random.nextInt(all.length)];
  }

  private static byte[] spliced(byte[] bytes, int from, int to, byte[] put) {
    byte[] all = Arrays.copyOf(bytes, from + put.length + bytes.length - to);
    System.arraycopy(put, 0, all, from, put.length);
    System.arraycopy(bytes, to, all, from + put.length, bytes.length - to);
    return all;
  }

  /** Valid messages, to objects that exist. */
  private static final class Targets {
    private static final List<String> SERVER =
        List.of("getInfo", "limits", "findSession", "findSimulation", "createSession", "_is_a");
    private static final List<String> ADMIN =
        List.of("getStatus", "listHosts", "listSimulations", "showSimulation", "events", "limits");
    private static final List<String> SESSION =
        List.of(
            "_get_sessionId",
            "_get_hostName",
            "getModelInfo",
            "parameters",
            "roadmap",
            "checkReport",
            "generatedSource",
            "createSimulation",
            "compileToJar",
            "getRuntimeInfo",
            "fetchRuntime",
            "timings",
            "pollEvents",
            "prepareSimulation",
            "prepareJar",
            "renewLease");
    private static final List<String> SIMULATION =
        List.of(
            "_get_simId",
            "start",
            "pause",
            "resume",
            "stepOnce",
            "runTo",
            "getProgress",
            "stateChannels",
            "getStates",
            "parameters",
            "setParameters",
            "openResults",
            "report",
            "failure",
            "checkpoint",
            "restore",
            "cancel",
            "destroy");
    private static final List<String> CURSOR =
        List.of("channels", "nextBlock", "seekRow", "renewLease", "destroy");

    private static final int ATTEMPTS = 30;

    private final ServiceOrb orb;
    private final MechServer server;
    private final boolean ofHost;
    private List<byte[]> messages = List.of();
    private Optional<MechSim> session = Optional.empty();
    private Optional<IMechSimRemote> run = Optional.empty();
    private Optional<ResultCursor> cursor = Optional.empty();
    private int id;

    Targets(ServiceOrb orb, String address, boolean ofHost) {
      this.orb = orb;
      this.server = orb.connect(address);
      this.ofHost = ofHost;
    }

    List<byte[]> messages() {
      return messages;
    }

    /** Makes what the messages are for, if it is not there or no longer. */
    void renew() throws IOException, UserException {
      if (!ofHost) {
        messages = messages.isEmpty() ? ofServer() : messages;
      } else if (messages.isEmpty() || !isThere()) {
        end();
        messages = ofHostAtLast();
      }
    }

    /** Damaged requests for models come before, and a session may end while its own waits. */
    private List<byte[]> ofHostAtLast() throws IOException, UserException {
      for (int attempt = 1; ; attempt++) {
        try {
          return ofHost();
        } catch (SystemException e) {
          if (attempt == ATTEMPTS) {
            throw e;
          }
        }
      }
    }

    private boolean isThere() {
      try {
        session.orElseThrow().sessionId();
        run.orElseThrow().simId();
        cursor.orElseThrow().renewLease();
        return true;
      } catch (SystemException gone) {
        return false;
      }
    }

    private List<byte[]> ofServer() throws IOException {
      List<byte[]> all = new ArrayList<>();
      addAll(all, "MechServer".getBytes(StandardCharsets.US_ASCII), SERVER);
      addAll(all, "MechAdmin".getBytes(StandardCharsets.US_ASCII), ADMIN);
      byte[] registry = "HostRegistry".getBytes(StandardCharsets.US_ASCII);
      addAll(all, registry, List.of("registerHost"));
      byte[] named = Giop.text("robot.urdf");
      byte[] model = Files.readAllBytes(Runs.PENDULUM);
      add(all, "MechServer".getBytes(StandardCharsets.US_ASCII), "importModel", named, model);
      return all;
    }

    private List<byte[]> ofHost() throws IOException, UserException {
      byte[] model = Files.readAllBytes(Runs.PENDULUM);
      MechSim made = server.createSession("eve", "far", null);
      session = Optional.of(made);
      made.loadModel(new ModelFile("pendulum.xml", model), new ModelFile[0]);
      run = Optional.of(made.createSimulation(new NameValue[0], null));
      cursor = Optional.of(run.get().openResults(new String[0]));
      List<byte[]> all = new ArrayList<>();
      byte[] ofSession = key(made);
      addAll(all, ofSession, SESSION);
      add(all, ofSession, "loadModel", Giop.text("pendulum.xml"), model);
      addAll(all, key(run.get()), SIMULATION);
      addAll(all, key(cursor.get()), CURSOR);
      return all;
    }

    /** Ends what it has made, as far as no message has. */
    void end() {
      try {
        session.ifPresent(MechSim::destroy);
      } catch (SystemException alreadyGone) {
        return;
      }
    }

    private byte[] key(org.omg.CORBA.Object object) {
      return Giop.objectKey(orb.toIor(object));
    }

    /** Each operation without arguments, with numbers and with text. */
    private void addAll(List<byte[]> all, byte[] key, List<String> operations) {
      for (String operation : operations) {
        add(all, key, operation, new byte[0], new byte[0]);
        add(all, key, operation, Giop.numbers(0, 1, 0, 10, 0), new byte[0]);
        add(all, key, operation, Giop.text("x"), new byte[0]);
      }
    }

    private void add(
        List<byte[]> all, byte[] key, String operation, byte[] arguments, byte[] octets) {
      byte[] whole = arguments;
      if (octets.length > 0) {
        whole = spliced(arguments, arguments.length, arguments.length, Giop.numbers(octets.length));
        whole = spliced(whole, whole.length, whole.length, octets);
        whole = Arrays.copyOf(whole, (whole.length + 3) / 4 * 4 + 4); // and nothing else
      }
      all.add(Giop.request(key, operation, id++, whole));
      all.add(Giop.requestNow(key, operation, id++, whole));
    }
  }
}
