package org.mechservice.load;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.nio.ByteBuffer;
import java.nio.channels.SocketChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.mechservice.client.MechConnection;
import org.mechservice.client.MechSession;
import org.mechservice.client.jar.JarCache;
import org.mechservice.orb.tls.TlsIdentity;

/** Connections that say nothing, or a byte now and then, or no more, keep no client out. */
@Tag("slow")
class SlowConnectionsTest {
  private static final long ROUND_MILLIS = 300;
  private static final int SECONDS = 60;
  private static final int SLOW = 1000;
  private static final int CLIENTS = 20;
  private static final String HERE = "127.0.0.1";

  /** Linux takes each address that begins like this for its own. */
  private static final String ELSEWHERE = "127.0.0.2";

  @TempDir Path folder;

  /** A port, and what a connection sends that ends in the middle, or says one thing and no more. */
  @SuppressWarnings("ArrayRecordComponent") // never changed
  private record Target(String name, int port, byte[] dripped, byte[] whole) {
    static Target orb(String name, int port) {
      byte[] asked =
          Giop.requestNow(
              "MechServer".getBytes(StandardCharsets.US_ASCII), "getInfo", 1, new byte[0]);
      return new Target(name, port, asked, asked);
    }

    /** Hands are never shaken: that is half of a first record. */
    static Target tls(String name, int port) {
      byte[] hello = {22, 3, 1, 2, 0, 1, 0, 1, (byte) 0xFC, 3, 3};
      return new Target(name, port, Arrays.copyOf(hello, 200), new byte[0]);
    }

    static Target http(String name, int port) {
      String asked = "GET /health HTTP/1.1\r\nHost: 127.0.0.1:" + port + "\r\n\r\n";
      byte[] bytes = asked.getBytes(StandardCharsets.US_ASCII);
      return new Target(name, port, bytes, bytes);
    }
  }

  /** Work of all clients. */
  private record Work(int sessions, int pages) {}

  /** What somebody does again and again; returns how often. */
  private interface Client {
    int work(long end) throws Exception;
  }

  @Test
  void clientsWorkBesideFourHundredSlowConnections() throws Exception {
    try (ServiceJvm server = ServiceJvm.server(256)) {
      Map<Target, Integer> reopened = new LinkedHashMap<>();
      reopened.put(Target.orb("server", server.port()), 0);
      Client client = end -> sessions(end, server.address(), Optional.empty(), "");
      assertThat(attack(reopened, HERE, 400, 4, 3, client, end -> 0).sessions()).isPositive();
    }
  }

  @Tag("soak")
  @Test
  void clientsWorkBesideAThousandSlowConnectionsToEachPort() throws Exception {
    SoakPage page =
        new SoakPage(
            "Slow connections",
            "A server and a host with 256 MB of heap, each of which takes 280 connections, with the"
                + " server's port for metrics and an admin console beside them. "
                + SLOW
                + " connections are kept open to each port at once, all from an address ("
                + ELSEWHERE
                + ") that is not the clients': a third of them send nothing, a"
                + " third a byte of a message every 0.3 s, and a third send one whole message and"
                + " nothing more (over TLS, where a stranger can send none, half of the first"
                + " record at once). Each that is closed is opened anew within 0.3 s. Meanwhile "
                + CLIENTS
                + " clients connect, open a session on the host, load the pendulum, ask for the"
                + " model, and begin again; another asks for `/health` and for the console's page."
                + " An error of one of them fails the test.",
            0);
    page.line("| | port | slow connections | opened anew in " + SECONDS + " s |");
    page.line("|---|---|---|---|");
    Work plain = plain(page);
    Work encrypted = encrypted(page);
    page.line("%n| | sessions of the %d clients | pages | errors |", CLIENTS);
    page.line("|---|---|---|---|");
    page.line("| plain | %d | %d | 0 |", plain.sessions(), plain.pages());
    page.line("| TLS | %d | %d | 0 |", encrypted.sessions(), encrypted.pages());
    page.write("service-slow-connections.md");
  }

  private static ServiceJvm server(int metrics, String... more) throws IOException {
    List<String> words = new ArrayList<>(List.of("server", "--listen", "127.0.0.1:0"));
    words.addAll(List.of("--capacity", "0", "--metrics-port", Integer.toString(metrics)));
    words.addAll(List.of(more));
    return ServiceJvm.start(List.of(), 256, words.toArray(String[]::new));
  }

  private static ServiceJvm console(ServiceJvm server, String... more) throws IOException {
    List<String> words = new ArrayList<>(List.of("admin", "--server", server.address()));
    words.addAll(List.of(more));
    words.addAll(List.of("web", "--port", "0"));
    return ServiceJvm.start(List.of(), 256, words.toArray(String[]::new));
  }

  private Work plain(SoakPage page) throws Exception {
    int metrics = Relay.freePort();
    try (ServiceJvm server = server(metrics);
        ServiceJvm host = ServiceJvm.host(server.address(), "far", "--capacity", "4");
        ServiceJvm console = console(server)) {
      Map<Target, Integer> reopened = new LinkedHashMap<>();
      reopened.put(Target.orb("server", server.port()), 0);
      reopened.put(Target.orb("host", host.port()), 0);
      reopened.put(Target.http("metrics", metrics), 0);
      reopened.put(Target.http("admin console", console.port()), 0);
      return attacked(page, "plain", reopened, server.address(), Optional.empty());
    }
  }

  private Work encrypted(SoakPage page) throws Exception {
    TlsKeys keys = TlsKeys.make(folder, "ann");
    int metrics = Relay.freePort();
    String[] tls = {"--tls", keys.of("server")};
    try (ServiceJvm server = server(metrics, tls);
        ServiceJvm host =
            ServiceJvm.host(server.address(), "far", "--capacity", "4", tls[0], tls[1]);
        ServiceJvm console = console(server, "--tls", keys.of(TlsKeys.ROOT))) {
      Map<Target, Integer> reopened = new LinkedHashMap<>();
      reopened.put(Target.tls("server", server.port()), 0);
      reopened.put(Target.tls("host", host.port()), 0);
      reopened.put(Target.http("metrics", metrics), 0);
      reopened.put(Target.http("admin console", console.port()), 0);
      return attacked(page, "TLS", reopened, server.address(), keys.identity("ann"));
    }
  }

  private static Work attacked(
      SoakPage page,
      String how,
      Map<Target, Integer> reopened,
      String address,
      Optional<TlsIdentity> identity)
      throws Exception {
    List<Integer> web =
        reopened.keySet().stream()
            .filter(target -> target.dripped()[0] == 'G' && target.dripped()[1] == 'E')
            .map(Target::port)
            .toList();
    Work work =
        attack(
            reopened,
            ELSEWHERE,
            SLOW,
            CLIENTS,
            SECONDS,
            end -> sessions(end, address, identity, "far"),
            end -> pages(end, web));
    reopened.forEach(
        (target, count) -> page.line("| %s | %s | %d | %d |", how, target.name(), SLOW, count));
    assertThat(work.sessions()).isPositive();
    assertThat(work.pages()).isPositive();
    return work;
  }

  private static Work attack(
      Map<Target, Integer> reopened,
      String from,
      int slow,
      int clients,
      int seconds,
      Client client,
      Client other)
      throws Exception {
    AtomicBoolean over = new AtomicBoolean();
    ExecutorService threads = Executors.newCachedThreadPool();
    try {
      Map<Target, Future<Integer>> attacking = new LinkedHashMap<>();
      for (Target target : reopened.keySet()) {
        attacking.put(target, threads.submit(() -> keepOpen(target, from, slow, over)));
      }
      Thread.sleep(1000);
      long end = System.nanoTime() + seconds * 1_000_000_000L;
      List<Future<Integer>> working = new ArrayList<>();
      for (int i = 0; i < clients; i++) {
        working.add(threads.submit(() -> client.work(end)));
      }
      Future<Integer> pages = threads.submit(() -> other.work(end));
      int sessions = 0;
      for (Future<Integer> one : working) {
        sessions += one.get(seconds + 120L, TimeUnit.SECONDS);
      }
      Work work = new Work(sessions, pages.get(1, TimeUnit.MINUTES));
      over.set(true);
      for (Map.Entry<Target, Future<Integer>> attack : attacking.entrySet()) {
        reopened.put(attack.getKey(), attack.getValue().get(1, TimeUnit.MINUTES));
      }
      return work;
    } finally {
      over.set(true);
      threads.shutdownNow();
    }
  }

  private static int sessions(long end, String address, Optional<TlsIdentity> identity, String host)
      throws IOException {
    int sessions = 0;
    while (System.nanoTime() < end) {
      try (MechConnection connection = MechConnection.open(address, JarCache.ofUser(), identity);
          MechSession session = connection.openSession(host)) {
        session.loadModel(Runs.PENDULUM);
        session.model();
        sessions++;
      }
    }
    return sessions;
  }

  private static int pages(long end, List<Integer> ports) throws Exception {
    HttpClient client = HttpClient.newBuilder().connectTimeout(Duration.ofSeconds(10)).build();
    int pages = 0;
    while (System.nanoTime() < end) {
      for (int i = 0; i < ports.size(); i++) {
        URI page = URI.create("http://127.0.0.1:" + ports.get(i) + (i == 0 ? "/health" : "/"));
        HttpRequest asked = HttpRequest.newBuilder(page).timeout(Duration.ofSeconds(30)).build();
        assertThat(client.send(asked, HttpResponse.BodyHandlers.discarding()).statusCode())
            .as(page.toString())
            .isEqualTo(200);
        pages++;
      }
      Thread.sleep(100);
    }
    return pages;
  }

  /** Returns how many connections were opened anew. */
  private static int keepOpen(Target target, String from, int count, AtomicBoolean over)
      throws Exception {
    List<Slow> open = new ArrayList<>();
    int reopened = 0;
    try {
      for (int i = 0; i < count; i++) {
        open.add(new Slow(target, from, i % 3));
      }
      while (!over.get()) {
        for (int i = 0; i < count; i++) {
          if (!open.get(i).isAlive()) {
            open.get(i).close();
            open.set(i, new Slow(target, from, i % 3));
            reopened++;
          }
        }
        Thread.sleep(ROUND_MILLIS);
      }
      return reopened;
    } finally {
      for (Slow slow : open) {
        slow.close();
      }
    }
  }

  /** A connection of one of three kinds. */
  private static final class Slow {
    private static final int SILENT = 0;
    private static final int DRIPPING = 1;

    private final SocketChannel channel = SocketChannel.open();
    private final ByteBuffer rest;
    private final int kind;

    Slow(Target target, String from, int kind) throws IOException {
      this.kind = kind;
      // A message is never finished byte by byte: its last byte is kept back.
      rest =
          kind == DRIPPING || target.whole().length == 0
              ? ByteBuffer.wrap(target.dripped(), 0, target.dripped().length - 1)
              : ByteBuffer.wrap(target.whole());
      channel.bind(new InetSocketAddress(from, 0));
      channel.configureBlocking(false);
      channel.connect(new InetSocketAddress(InetAddress.getLoopbackAddress(), target.port()));
    }

    boolean isAlive() {
      try {
        if (!channel.finishConnect()) {
          return true;
        }
        if (kind != SILENT && rest.hasRemaining()) {
          ByteBuffer now = rest.duplicate();
          now.limit(kind == DRIPPING ? rest.position() + 1 : rest.limit());
          channel.write(now);
          rest.position(now.position());
        }
        return channel.read(ByteBuffer.allocate(1 << 12)) >= 0;
      } catch (IOException e) {
        return false;
      }
    }

    void close() throws IOException {
      channel.close();
    }
  }
}
