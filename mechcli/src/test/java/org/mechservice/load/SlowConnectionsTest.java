package org.mechservice.load;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.ByteBuffer;
import java.nio.channels.SocketChannel;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.mechservice.client.MechConnection;
import org.mechservice.client.MechSession;

/** Connections that say nothing, or a byte now and then, keep no client out. */
class SlowConnectionsTest {
  private static final long ROUND_MILLIS = 300;

  /** Work of all clients, and how often a slow connection was closed and opened anew. */
  private record Counts(int sessions, int reopened) {}

  @Test
  void clientsWorkBesideFourHundredSlowConnections() throws Exception {
    assertThat(attack(400, 4, 3).sessions()).isPositive();
  }

  @Tag("soak")
  @Test
  void clientsWorkBesideAThousandSlowConnections() throws Exception {
    int seconds = 60;
    Counts counts = attack(1000, 20, seconds);
    new SoakPage(
            "Slow connections",
            "A server with `-Xmx256m`, which takes 300 connections. A thousand connections are kept"
                + " open to it: half of them send nothing, the others a byte of a message's header"
                + " every 0.3 s; each that the server closes is opened anew at once. Meanwhile 20"
                + " clients connect, open a session, load the pendulum, ask for the model, and"
                + " begin again. An error of one of them fails the test.",
            0)
        .line("| | |")
        .line("|---|---|")
        .line("| duration | %d s |", seconds)
        .line("| sessions of the clients | %d |", counts.sessions())
        .line("| errors | 0 |")
        .line("| slow connections opened anew | %d |", counts.reopened())
        .write("service-slow-connections.md");
  }

  private static Counts attack(int slow, int clients, int seconds) throws Exception {
    AtomicBoolean over = new AtomicBoolean();
    ExecutorService threads = Executors.newFixedThreadPool(clients + 1);
    try (ServiceJvm server = ServiceJvm.server(256)) {
      Future<Integer> attacking = threads.submit(() -> keepOpen(server.port(), slow, over));
      Thread.sleep(1000);
      List<Future<Integer>> working = new ArrayList<>();
      for (int i = 0; i < clients; i++) {
        working.add(threads.submit(() -> work(server.address(), seconds)));
      }
      int sessions = 0;
      for (Future<Integer> client : working) {
        sessions += client.get(seconds + 120L, TimeUnit.SECONDS);
      }
      over.set(true);
      return new Counts(sessions, attacking.get(1, TimeUnit.MINUTES));
    } finally {
      over.set(true);
      threads.shutdownNow();
    }
  }

  private static int work(String address, int seconds) throws IOException {
    long end = System.nanoTime() + seconds * 1_000_000_000L;
    int sessions = 0;
    while (System.nanoTime() < end) {
      try (MechConnection connection = MechConnection.open(address);
          MechSession session = connection.openSession()) {
        session.loadModel(Runs.PENDULUM);
        session.model();
        sessions++;
      }
    }
    return sessions;
  }

  /** Returns how many connections were opened anew. */
  private static int keepOpen(int port, int count, AtomicBoolean over) throws Exception {
    List<SocketChannel> open = new ArrayList<>();
    int reopened = 0;
    try {
      for (int i = 0; i < count; i++) {
        open.add(connect(port));
      }
      while (!over.get()) {
        for (int i = 0; i < count; i++) {
          if (!isAlive(open.get(i), i % 2 == 0)) {
            open.get(i).close();
            open.set(i, connect(port));
            reopened++;
          }
        }
        Thread.sleep(ROUND_MILLIS);
      }
      return reopened;
    } finally {
      for (SocketChannel channel : open) {
        channel.close();
      }
    }
  }

  private static SocketChannel connect(int port) throws IOException {
    SocketChannel channel = SocketChannel.open();
    channel.configureBlocking(false);
    channel.connect(new InetSocketAddress(InetAddress.getLoopbackAddress(), port));
    return channel;
  }

  private static boolean isAlive(SocketChannel channel, boolean talks) {
    try {
      if (!channel.finishConnect()) {
        return true;
      }
      if (talks) {
        channel.write(ByteBuffer.wrap("G".getBytes(StandardCharsets.US_ASCII)));
      }
      return channel.read(ByteBuffer.allocate(1)) >= 0;
    } catch (IOException e) {
      return false;
    }
  }
}
