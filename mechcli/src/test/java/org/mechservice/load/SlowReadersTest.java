package org.mechservice.load;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.nio.file.Files;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.mechservice.idl.IMechSimRemote;
import org.mechservice.idl.MechServer;
import org.mechservice.idl.MechSim;
import org.mechservice.idl.ModelFile;
import org.mechservice.idl.NameValue;
import org.mechservice.idl.ResultBlockHolder;
import org.mechservice.idl.ResultCursor;
import org.mechservice.orb.ServiceOrb;

/**
 * Readers who ask for blocks of results and then do not read them neither fill the server's memory
 * nor keep others waiting.
 */
@Tag("slow")
class SlowReadersTest {
  private static final int CURSORS_PER_RUN = 16;
  private static final int BLOCKS_ASKED = 4;
  private static final int PINGS = 200;

  /** Enough rows for blocks of a MiB: 11 columns, 8 bytes each. */
  private static final NameValue[] LONG = {
    new NameValue("t-end", "500"), new NameValue("t-step", "0.01"), new NameValue("rtol", "1e-4")
  };

  /** What an honest client saw meanwhile. */
  private record Seen(double medianMillis, double longestMillis, double runSeconds, long heap) {}

  @Test
  void someStalledReadersHarmNobody() throws Exception {
    Seen seen = stalled(80, 96, null);
    assertThat(seen.heap()).isLessThan(96L << 20);
  }

  @Tag("soak")
  @Test
  void thousandStalledReadersHarmNobody() throws Exception {
    SoakPage page =
        new SoakPage(
            "A thousand stalled readers",
            "A server with `-Xmx256m`. A thousand readers, each with a connection and a cursor of"
                + " its own over a run of 50001 rows, ask for 4 blocks of 1 MiB at once, through a"
                + " receive buffer of 4 KiB, and read nothing. Meanwhile an honest client asks 200"
                + " times who the server is, and runs the pendulum. Heap after a full collection.",
            0);
    page.line(
        "| stalled readers | heap in use | ping, median | ping, longest | honest run, set-up to last row |");
    page.line("|---|---|---|---|---|");
    stalled(1000, 256, page);
    page.write("service-slow-readers.md");
  }

  private static Seen stalled(int readers, int heapMegabytes, @Nullable SoakPage page)
      throws Exception {
    List<Socket> sockets = new ArrayList<>();
    try (ServiceJvm server =
            ServiceJvm.server(
                heapMegabytes,
                "--limit",
                "connections=" + (readers + 20),
                "--limit",
                "simulations=-1",
                "--limit",
                "clientRuns=-1");
        ServiceOrb orb = ServiceOrb.client()) {
      MechServer service = orb.connect(server.address());
      MechSim session = service.createSession("slow", "", null);
      session.loadModel(
          new ModelFile("p.xml", Files.readAllBytes(Runs.PENDULUM)), new ModelFile[0]);
      note(page, "none", honest(server, service));
      List<String> cursors = cursors(orb, session, readers);
      for (String cursor : cursors) {
        sockets.add(ask(server.port(), Giop.objectKey(cursor)));
      }
      Thread.sleep(500); // the server has begun to answer
      Seen seen = honest(server, service);
      note(page, readers + ", just now", seen);
      note(page, readers + ", later", honest(server, service));
      assertThat(server.messages()).doesNotContain("OutOfMemoryError");
      return seen;
    } finally {
      for (Socket socket : sockets) {
        socket.close();
      }
    }
  }

  private static void note(@Nullable SoakPage page, String readers, Seen seen) {
    String line =
        String.format(
            Locale.ROOT,
            "| %s | %.1f MB | %.2f ms | %.1f ms | %.2f s |",
            readers,
            seen.heap() * 1e-6,
            seen.medianMillis(),
            seen.longestMillis(),
            seen.runSeconds());
    if (page != null) {
      page.line("%s", line);
    }
  }

  /** Opens cursors over finished runs; returns their references. */
  private static List<String> cursors(ServiceOrb orb, MechSim session, int count) throws Exception {
    List<String> cursors = new ArrayList<>();
    while (cursors.size() < count) {
      IMechSimRemote run = session.createSimulation(LONG, null);
      run.start();
      toEnd(run.openResults(new String[0]));
      for (int i = 1; i < CURSORS_PER_RUN && cursors.size() < count; i++) {
        cursors.add(orb.toIor(run.openResults(new String[0])));
      }
    }
    return cursors;
  }

  private static void toEnd(ResultCursor cursor) throws Exception {
    ResultBlockHolder block = new ResultBlockHolder();
    do {
      cursor.nextBlock(0, 1000, block);
    } while (!block.value.endOfData);
    cursor.destroy();
  }

  /** Asks for blocks over a connection of its own that takes hardly any bytes. */
  private static Socket ask(int port, byte[] cursor) throws IOException {
    Socket socket = new Socket();
    socket.setReceiveBufferSize(4096);
    socket.connect(new InetSocketAddress(InetAddress.getLoopbackAddress(), port));
    for (int id = 1; id <= BLOCKS_ASKED; id++) {
      socket.getOutputStream().write(Giop.request(cursor, "nextBlock", id, Giop.numbers(0, 0)));
    }
    return socket;
  }

  private static Seen honest(ServiceJvm server, MechServer service) throws Exception {
    double[] millis = new double[PINGS];
    for (int i = 0; i < PINGS; i++) {
      long start = System.nanoTime();
      service.getInfo();
      millis[i] = (System.nanoTime() - start) * 1e-6;
    }
    Arrays.sort(millis);
    long start = System.nanoTime();
    MechSim session = service.createSession("honest", "", null);
    session.loadModel(new ModelFile("p.xml", Files.readAllBytes(Runs.PENDULUM)), new ModelFile[0]);
    IMechSimRemote run = session.createSimulation(new NameValue[0], null);
    run.start();
    toEnd(run.openResults(new String[0]));
    double seconds = (System.nanoTime() - start) * 1e-9;
    session.destroy();
    return new Seen(millis[PINGS / 2], millis[PINGS - 1], seconds, server.inside().heapBytes());
  }
}
