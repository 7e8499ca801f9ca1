package org.mechservice.load;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.TreeMap;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.mechservice.client.MechConnection;
import org.mechservice.client.MechSession;
import org.mechservice.client.SimulationOptions;
import org.mechservice.client.jar.JarCache;
import org.mechservice.load.ServiceJvm.Inside;

/** Whatever bytes arrive at its port, the server goes on serving and its memory stays bounded. */
@Tag("slow")
class HostileBytesTest {
  private static final long SEED = 20261122;
  private static final int HEAP_MEGABYTES = 128;
  private static final int GIANT = 0x7FFFFFF0;

  /** Java's own bookkeeping goes up and down by this much, and a class is loaded now and then. */
  private static final long NOISE_BYTES = 4_000_000;

  /** Something to send, made anew each time. */
  private interface Kind {
    byte[] next(Random random);
  }

  @Test
  void serverSurvivesSomeOfEachKind() throws Exception {
    attack(40, 20, null);
  }

  @Tag("soak")
  @Test
  void serverSurvivesThousandsOfEachKind() throws Exception {
    SoakPage page =
        new SoakPage(
            "Hostile byte streams",
            "A server with `-Xmx128m` gets byte streams of each kind, one connection each, none of"
                + " which it can have expected; mutations are valid messages of a client's whole"
                + " way through the service, recorded on the wire, with bytes changed, cut out, or"
                + " put in; those that are still valid open sessions, which end with"
                + " their lease. After each kind an honest client, who is connected all the time,"
                + " simulates and gets its rows to the last bit. Heap after a full collection.",
            SEED);
    page.line("| kind | streams | heap in use | CORBA objects | threads | open files |");
    page.line("|---|---|---|---|---|---|");
    attack(3000, 200, page);
    page.write("service-hostile-bytes.md");
  }

  private static byte[] joined(byte[] first, byte[] second) {
    byte[] all = Arrays.copyOf(first, first.length + second.length);
    System.arraycopy(second, 0, all, first.length, second.length);
    return all;
  }

  private static byte[] random(Random random, int most) {
    byte[] bytes = new byte[random.nextInt(most) + 1];
    random.nextBytes(bytes);
    return bytes;
  }

  private static Map<String, Kind> kinds(List<byte[]> valid) {
    Map<String, Kind> kinds = new TreeMap<>();
    kinds.put("garbage", r -> random(r, 4000));
    kinds.put("HTTP", r -> "GET / HTTP/1.1\r\nHost: x\r\n\r\n".getBytes(StandardCharsets.US_ASCII));
    kinds.put(
        "TLS hello to the plain port", r -> joined(new byte[] {22, 3, 1, 2, 0, 1}, random(r, 500)));
    kinds.put("truncated", r -> cut(valid.get(r.nextInt(valid.size())), r));
    kinds.put(
        "giant length",
        r -> joined(Giop.header(r.nextInt(8), GIANT + r.nextInt(16)), random(r, 100)));
    kinds.put(
        "large length, nothing follows", r -> Giop.header(0, (20 << 20) + r.nextInt(12 << 20)));
    kinds.put("negative length", r -> joined(Giop.header(0, -1 - r.nextInt(1000)), random(r, 100)));
    kinds.put(
        "wrong version",
        r -> joined(Giop.header(r.nextInt(256), r.nextInt(256), r.nextInt(8), 50), random(r, 100)));
    kinds.put("wrong type", r -> joined(Giop.header(8 + r.nextInt(248), 20), random(r, 40)));
    kinds.put("fragments of nothing", HostileBytesTest::fragments);
    kinds.put("lying length of a sequence", r -> lying(r, valid));
    kinds.put("mutation", r -> mutated(valid.get(r.nextInt(valid.size())), r));
    return kinds;
  }

  private static byte[] cut(byte[] message, Random random) {
    return Arrays.copyOf(message, random.nextInt(message.length));
  }

  private static byte[] fragments(Random random) {
    byte[] all = new byte[0];
    for (int i = 0; i < 20; i++) {
      byte[] fragment = Giop.header(7, 104);
      fragment[6] = 2; // more fragments follow
      all = joined(all, joined(fragment, joined(Giop.numbers(random.nextInt(3)), new byte[100])));
    }
    return all;
  }

  private static byte[] lying(Random random, List<byte[]> valid) {
    byte[] message = valid.get(random.nextInt(valid.size())).clone();
    if (message.length > 40) {
      int place = Giop.HEADER_BYTES + 4 * random.nextInt((message.length - 16) / 4);
      ByteBuffer.wrap(message).putInt(place, GIANT - random.nextInt(1 << 20));
    }
    return message;
  }

  private static byte[] mutated(byte[] message, Random random) {
    byte[] changed = message.clone();
    for (int i = random.nextInt(6); i >= 0 && changed.length > 1; i--) {
      int place = random.nextInt(changed.length);
      switch (random.nextInt(4)) {
        case 0 -> changed[place] = (byte) random.nextInt(256);
        case 1 -> changed[place] ^= (byte) (1 << random.nextInt(8));
        case 2 -> // a piece is missing
            changed =
                joined(
                    Arrays.copyOf(changed, place),
                    Arrays.copyOfRange(
                        changed, Math.min(changed.length, place + 4), changed.length));
        default -> // a piece too much
            changed =
                joined(
                    Arrays.copyOf(changed, place),
                    joined(random(random, 8), Arrays.copyOfRange(changed, place, changed.length)));
      }
    }
    return changed;
  }

  /**
   * @param each streams of each kind
   * @param slow connections that send a byte now and then, or nothing
   * @param page gets a line for each kind; null: none
   */
  private static void attack(int each, int slow, @org.jspecify.annotations.Nullable SoakPage page)
      throws Exception {
    Random random = new Random(SEED);
    try (ServiceJvm server = ServiceJvm.server(HEAP_MEGABYTES);
        MechConnection honest = MechConnection.open(server.address(), JarCache.ofUser());
        MechSession session = honest.openSession()) {
      session.loadModel(Runs.PENDULUM);
      List<Long> alone = Runs.bits(session, SimulationOptions.asInFile(), false);
      List<byte[]> valid = recorded(server);
      Inside before = server.inside();
      for (Map.Entry<String, Kind> kind : kinds(valid).entrySet()) {
        for (int i = 0; i < each; i++) {
          send(server.port(), kind.getValue().next(random));
        }
        assertServes(session, alone);
        note(page, kind.getKey(), each, server, before);
      }
      slowloris(server.port(), slow, valid, () -> assertServes(session, alone));
      note(page, "a byte now and then, or none", slow, server, before);
      announced(server.port(), slow, () -> assertServes(session, alone));
      note(page, "large lengths announced at once, nothing follows", slow, server, before);
      assertThat(server.messages()).doesNotContain("OutOfMemoryError");
    }
  }

  private static void assertServes(MechSession session, List<Long> alone) throws IOException {
    assertThat(Runs.bits(session, SimulationOptions.asInFile(), false)).isEqualTo(alone);
  }

  private static void note(
      @org.jspecify.annotations.Nullable SoakPage page,
      String kind,
      int streams,
      ServiceJvm server,
      Inside before)
      throws Exception {
    if (page == null) {
      assertThat(server.alive()).as(kind).isTrue();
      return;
    }
    Thread.sleep(1000);
    Inside now =
        server.insideOnce(
            each ->
                each.heapBytes() < before.heapBytes() + NOISE_BYTES
                    && each.files() <= before.files() + 5);
    page.line(
        "| %s | %d | %.2f MB | %d | %d | %d |",
        kind, streams, now.heapBytes() * 1e-6, now.objects(), now.threads(), now.files());
    assertThat(now.heapBytes()).as(kind).isLessThan(before.heapBytes() + NOISE_BYTES);
    assertThat(now.files()).as(kind).isLessThanOrEqualTo(before.files() + 5);
  }

  /** Returns the messages of an honest client's whole way, as they went over the wire. */
  private static List<byte[]> recorded(ServiceJvm server) throws Exception {
    InetSocketAddress target =
        new InetSocketAddress(InetAddress.getLoopbackAddress(), server.port());
    try (Relay relay = new Relay(Relay.anyPortOf("127.0.0.1"), target, 0);
        MechConnection client =
            MechConnection.open("127.0.0.1:" + relay.port(), JarCache.ofUser())) {
      client.openSession().close();
      List<byte[]> messages = new ArrayList<>(relay.sent());
      messages.addAll(handmade());
      return messages;
    }
  }

  /** Requests to the published objects, whose keys anybody knows. */
  private static List<byte[]> handmade() throws IOException {
    List<byte[]> messages = new ArrayList<>();
    byte[] server = "MechServer".getBytes(StandardCharsets.US_ASCII);
    byte[] admin = "MechAdmin".getBytes(StandardCharsets.US_ASCII);
    byte[] registry = "HostRegistry".getBytes(StandardCharsets.US_ASCII);
    byte[] model = Files.readAllBytes(Runs.PENDULUM);
    messages.add(Giop.request(server, "getInfo", 1, new byte[0]));
    messages.add(Giop.request(server, "limits", 2, new byte[0]));
    messages.add(Giop.request(server, "findSession", 3, Giop.text("x")));
    messages.add(
        Giop.request(server, "importModel", 4, joined(Giop.text("robot.u"), bytes(model))));
    messages.add(Giop.request(server, "noSuchThing", 5, Giop.numbers(1, 2, 3)));
    messages.add(Giop.request(admin, "getStatus", 6, new byte[0]));
    messages.add(Giop.request(admin, "listSimulations", 7, Giop.numbers(0, 100)));
    messages.add(
        Giop.request(registry, "registerHost", 8, joined(Giop.text("far"), Giop.numbers(1, 2))));
    return messages;
  }

  private static byte[] bytes(byte[] content) {
    return joined(Giop.numbers(content.length), content);
  }

  private static void send(int port, byte[] bytes) throws IOException {
    try (Socket socket = new Socket(InetAddress.getLoopbackAddress(), port)) {
      socket.setSoTimeout(1);
      socket.getOutputStream().write(bytes);
      socket.shutdownOutput();
    } catch (IOException closedByServer) {
      assertThat(closedByServer).isNotNull();
    }
  }

  private interface Check {
    void run() throws Exception;
  }

  private static void slowloris(int port, int count, List<byte[]> valid, Check meanwhile)
      throws Exception {
    List<Socket> open = new ArrayList<>();
    try {
      for (int i = 0; i < count; i++) {
        open.add(new Socket(InetAddress.getLoopbackAddress(), port));
      }
      for (int sent = 0; sent < 30; sent++) {
        for (int i = 0; i < count; i += 2) { // the others never say anything
          drip(open.get(i), valid.get(i % valid.size()), sent);
        }
      }
      meanwhile.run();
    } finally {
      for (Socket socket : open) {
        socket.close();
      }
    }
  }

  /** Every one of them announces as much as a message may have. */
  private static void announced(int port, int count, Check meanwhile) throws Exception {
    List<Socket> open = new ArrayList<>();
    try {
      for (int i = 0; i < count; i++) {
        Socket socket = new Socket(InetAddress.getLoopbackAddress(), port);
        open.add(socket);
        socket.getOutputStream().write(Giop.header(0, 30 << 20));
      }
      meanwhile.run();
    } finally {
      for (Socket socket : open) {
        socket.close();
      }
    }
  }

  private static void drip(Socket socket, byte[] message, int place) {
    try {
      OutputStream out = socket.getOutputStream();
      out.write(message[place % message.length]);
    } catch (IOException closedByServer) {
      assertThat(closedByServer).isNotNull();
    }
  }
}
