package org.mechservice.load;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.net.BindException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.ThreadLocalRandom;
import java.util.concurrent.TimeUnit;

/**
 * Stands between clients and a server: delays what passes, both ways, counts how often a side waits
 * for the other, remembers what clients have sent, and can be cut like a cable.
 */
final class Relay implements AutoCloseable {
  private static final int CHUNK_BYTES = 1 << 16;
  private static final int CHUNKS_UNDER_WAY = 1024;

  private final ServerSocket port;
  private final CompletableFuture<InetSocketAddress> target = new CompletableFuture<>();
  private final long delayNanos;
  private final List<Socket> sockets = new CopyOnWriteArrayList<>();
  private final List<byte[]> sent = new ArrayList<>();
  private volatile boolean cut;
  private int turns;
  private int connections;
  private boolean answered;

  @SuppressWarnings("ArrayRecordComponent") // handed on, never changed
  private record Chunk(byte[] bytes, long due) {}

  /**
   * @param address where it listens
   * @param delay of each way, so that a round trip takes twice as long, ms
   */
  Relay(InetSocketAddress address, InetSocketAddress target, double delay) throws IOException {
    this(address, delay);
    this.target.complete(target);
  }

  /**
   * Listens, and keeps who comes waiting until it knows where to lead them: a server that is to
   * name this port as its own can only be started afterwards.
   *
   * @param address where it listens
   * @param delay of each way, ms
   */
  Relay(InetSocketAddress address, double delay) throws IOException {
    delayNanos = (long) (delay * 1e6);
    port = new ServerSocket();
    port.bind(address);
    daemon(this::accept);
  }

  private interface Work {
    void run() throws IOException, InterruptedException;
  }

  private static void daemon(Work work) {
    Thread thread =
        new Thread(
            () -> {
              try {
                work.run();
              } catch (IOException e) {
                return; // closed by one side, which the other is told by closing it
              } catch (InterruptedException e) {
                Thread.currentThread().interrupt();
              }
            },
            "relay");
    thread.setDaemon(true);
    thread.start();
  }

  /** Says where connections lead to: to this port of the loopback interface. */
  void leadTo(int serverPort) {
    target.complete(new InetSocketAddress(InetAddress.getLoopbackAddress(), serverPort));
  }

  int port() {
    return port.getLocalPort();
  }

  private void accept() throws IOException, InterruptedException {
    while (true) {
      Socket client = port.accept();
      try {
        join(client, new Socket());
      } catch (IOException e) {
        client.close(); // cut before it had begun, or nobody is there; the next one may do better
      }
    }
  }

  private void join(Socket client, Socket server) throws IOException, InterruptedException {
    // The peer's answer to a new connection is a round trip, too.
    TimeUnit.NANOSECONDS.sleep(2 * delayNanos);
    sockets.add(client);
    sockets.add(server);
    if (!cut) {
      server.connect(target.join());
    }
    synchronized (this) {
      connections++;
      answered = true;
    }
    client.setTcpNoDelay(true);
    if (!cut) {
      server.setTcpNoDelay(true);
      pass(client, server, true);
      pass(server, client, false);
    }
  }

  private void pass(Socket from, Socket to, boolean asking) {
    BlockingQueue<Chunk> underWay = new LinkedBlockingQueue<>(CHUNKS_UNDER_WAY);
    daemon(() -> read(from, underWay, asking));
    daemon(() -> write(to, underWay));
  }

  private void read(Socket from, BlockingQueue<Chunk> underWay, boolean asking)
      throws IOException, InterruptedException {
    byte[] buffer = new byte[CHUNK_BYTES];
    try {
      InputStream in = from.getInputStream();
      for (int n = in.read(buffer); n >= 0; n = in.read(buffer)) {
        byte[] bytes = Arrays.copyOf(buffer, n);
        note(bytes, asking);
        underWay.put(new Chunk(bytes, System.nanoTime() + delayNanos));
      }
    } finally {
      underWay.put(new Chunk(new byte[0], System.nanoTime() + delayNanos));
    }
  }

  private void write(Socket to, BlockingQueue<Chunk> underWay)
      throws IOException, InterruptedException {
    OutputStream out = to.getOutputStream();
    while (true) {
      Chunk chunk = underWay.take();
      TimeUnit.NANOSECONDS.sleep(chunk.due() - System.nanoTime());
      if (chunk.bytes().length == 0 && !cut) {
        to.close();
        return;
      }
      if (!cut) {
        out.write(chunk.bytes());
      }
    }
  }

  private synchronized void note(byte[] bytes, boolean asking) {
    if (asking) {
      sent.add(bytes);
    }
    if (asking && isBackground(bytes)) {
      return;
    }
    turns += asking && answered ? 1 : 0;
    answered = !asking;
  }

  /**
   * A lease is renewed by a thread of its own, and a server that takes long is asked whether it is
   * there: nobody waits for either, and how often it happens depends on the machine.
   */
  private static boolean isBackground(byte[] question) {
    String text = new String(question, StandardCharsets.ISO_8859_1);
    return text.contains("renewLease") || text.contains("_get_sessionId");
  }

  /** Returns the round trips so far: connections opened, and questions asked after answers. */
  synchronized int roundTrips() {
    return connections + turns;
  }

  /** Returns what clients have sent, as it arrived: each a message or several. */
  synchronized List<byte[]> sent() {
    return List.copyOf(sent);
  }

  /** From now on nothing passes, and nobody is told. */
  void cut() {
    cut = true;
  }

  /** Ends the connections there are, of which both sides are told; new ones pass. */
  void cutConnections() throws IOException {
    for (Socket socket : sockets) {
      socket.close();
    }
    sockets.removeIf(Socket::isClosed);
  }

  /** Lets new connections pass again; those that were cut stay so. */
  void mend() throws IOException {
    for (Socket socket : sockets) {
      socket.close();
    }
    cut = false;
  }

  /** Returns an address of this machine whose port is free on the loopback address too. */
  static InetSocketAddress anyPortOf(String address) throws IOException {
    return new InetSocketAddress(InetAddress.getByName(address), freePort());
  }

  /** Returns a loopback port that was free a moment ago, none of those given to connections. */
  static int freePort() throws IOException {
    while (true) {
      int port = ThreadLocalRandom.current().nextInt(20_000, 30_000);
      try (ServerSocket socket = new ServerSocket(port, 1, InetAddress.getLoopbackAddress())) {
        return socket.getLocalPort();
      } catch (BindException e) {
        // Somebody has it: another one.
      }
    }
  }

  @Override
  public void close() throws IOException {
    target.cancel(false);
    port.close();
    for (Socket socket : sockets) {
      socket.close();
    }
  }
}
