package org.mechservice.server;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.LocalDate;
import java.time.ZoneOffset;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.TreeMap;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.mechservice.guard.worker.WorkerMain;
import org.mechservice.idl.IMechSimRemote;
import org.mechservice.idl.JarInfoHolder;
import org.mechservice.idl.MechServer;
import org.mechservice.idl.MechSim;
import org.mechservice.idl.ModelFile;
import org.mechservice.idl.NameValue;
import org.mechservice.idl.ResultBlockHolder;
import org.mechservice.idl.ResultCursor;
import org.mechservice.orb.ServiceOrb;
import org.mechservice.server.hosts.ServerTuning;
import org.mechservice.sim.host.SimHost;
import org.mechservice.sim.service.limits.CurrentLimits;
import org.mechservice.solver.api.Solver;
import org.mechservice.solver.api.run.Outcome;
import org.mechservice.solver.api.run.RunReport;
import org.mechservice.solver.simulation.Simulation;
import org.omg.CORBA.UserException;

/** Measures the service over loopback and writes docs/reports/service-speed.md. */
@Tag("soak")
class ServiceSpeedTest {
  private static final int ROWS = 2_000_000;
  private static final int PINGS = 5000;
  private static final int OPENED = 1000;
  private static final int PROCESSES = 9;
  private static final int PING_BYTES = 60;
  private static final int BLOCK_BYTES = 1 << 20;
  private static final int BLOCKS = 200;

  /** What a client gets at least of blocks of 1 MiB, MB/s. */
  private static final double LEAST_STREAMING = 50;

  private static final NameValue[] AS_IN_FILE = new NameValue[0];

  private final List<String> report = new ArrayList<>();

  /** Puts out rows as fast as they are kept. */
  private static final Solver FAST =
      (model, request, sink, control) -> {
        var columns = Simulation.columns(model, request.columns());
        sink.begin(columns);
        double[] row = new double[columns.size()];
        for (int i = 0; i < ROWS; i++) {
          row[0] = i;
          sink.row(row);
        }
        return new RunReport(
            new Outcome.Completed(),
            model.description().name(),
            "",
            request.settings(),
            ROWS,
            0,
            0,
            ROWS,
            ROWS,
            1,
            OptionalDouble.empty(),
            OptionalDouble.empty(),
            false,
            "fast");
      };

  private static SimHost fastHost(
      ServiceOrb orb, ServerSettings settings, CurrentLimits limits, Runnable shutdown) {
    return new SimHost(orb, settings.host(), limits, FAST, shutdown);
  }

  @Test
  void serviceIsMeasured() throws Exception {
    report.add("# Speed of the service over loopback\n");
    report.add(
        "Measured on "
            + LocalDate.now(ZoneOffset.UTC)
            + " by `mvn verify -Psoak`: JDK "
            + Runtime.version()
            + ", "
            + System.getProperty("os.name")
            + ", "
            + Runtime.getRuntime().availableProcessors()
            + " processors; client and server in one JVM, each with its own ORB. Raw TCP: as many"
            + " bytes over a socket of the same loopback interface, in the same run, two threads of"
            + " the same JVM, nothing encoded. gRPC is not measured: it would add a dozen"
            + " dependencies to the build for one table.\n");
    report.add(
        "No MechSims are kept in stock: opening one is the row `MechSim`, of which the row `ping`"
            + " is the call itself, so a stock would spare the difference. What makes a first"
            + " client wait is that the first model of a process loads its classes (`cold` against"
            + " `warm`). `mech server` and `mech simhost` therefore build and pack a small model of"
            + " their own as soon as they have started, so that their MechSims are ready. Processes"
            + " for classes of users are not kept in stock either: each would hold its memory all"
            + " the time, for less than the last step of a build that such a run has behind it.\n");
    report.add("| what | measured |\n|---|---|");
    try (MechServerProcess server =
            MechServerProcess.start(
                new ServerSettings("own", "127.0.0.1", 0, 2),
                ServerTuning.DEFAULT,
                ServiceSpeedTest::fastHost);
        ServiceOrb orb = ServiceOrb.client()) {
      MechServer service = orb.connect(server.url());
      setUp(service, "cold");
      pings(service);
      readiness(service);
      rawTcp();
      for (int i = 0; i < 5; i++) {
        setUp(service, i < 4 ? "" : "warm");
      }
      blocks(service);
    }
    Files.createDirectories(Path.of("../docs/reports"));
    Files.writeString(
        Path.of("../docs/reports/service-speed.md"), String.join("\n", report) + "\n");
    assertThat(report).hasSizeGreaterThan(8);
  }

  private void pings(MechServer service) {
    double[] micros = new double[PINGS];
    for (int i = 0; i < PINGS; i++) {
      long start = System.nanoTime();
      service.getInfo();
      micros[i] = (System.nanoTime() - start) * 1e-3;
    }
    Arrays.sort(micros);
    line("ping (getInfo), median of " + PINGS, micros[PINGS / 2], "µs");
  }

  /** What a stock of opened MechSims, or of idle processes, would spare a client. */
  private void readiness(MechServer service)
      throws UserException, IOException, InterruptedException {
    double[] micros = new double[OPENED];
    for (int i = 0; i < OPENED; i++) {
      long start = System.nanoTime();
      MechSim session = service.createSession("speed", "", null);
      micros[i] = (System.nanoTime() - start) * 1e-3;
      session.destroy();
    }
    Arrays.sort(micros);
    line("MechSim (createSession), median of " + OPENED, micros[OPENED / 2], "µs");
    double[] seconds = new double[PROCESSES];
    for (int i = 0; i < PROCESSES; i++) {
      seconds[i] = processSeconds();
    }
    Arrays.sort(seconds);
    line(
        "process for classes of users, from start to end, median of " + PROCESSES,
        1e3 * seconds[PROCESSES / 2],
        "ms");
  }

  /** It is given no order, so it ends as soon as it has started. */
  private static double processSeconds() throws IOException, InterruptedException {
    long start = System.nanoTime();
    Process worker =
        new ProcessBuilder(
                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-XX:+UseSerialGC",
                "-Xshare:auto",
                "-cp",
                System.getProperty("java.class.path"),
                WorkerMain.class.getName())
            .redirectError(ProcessBuilder.Redirect.DISCARD)
            .start();
    worker.getOutputStream().close();
    worker.waitFor();
    return (System.nanoTime() - start) * 1e-9;
  }

  /** The same work over a bare socket: a question of 60 bytes and its answer, and blocks. */
  private void rawTcp() throws IOException, InterruptedException {
    try (ServerSocket port = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
      Thread echo = new Thread(() -> answerRaw(port), "raw-tcp");
      echo.start();
      long start = System.nanoTime();
      try (Socket socket = new Socket(port.getInetAddress(), port.getLocalPort())) {
        socket.setTcpNoDelay(true);
        line("raw TCP: connection", (System.nanoTime() - start) * 1e-6, "ms");
        byte[] question = new byte[PING_BYTES];
        double[] micros = new double[PINGS];
        for (int i = 0; i < PINGS; i++) {
          start = System.nanoTime();
          socket.getOutputStream().write(question);
          assertThat(socket.getInputStream().readNBytes(PING_BYTES)).hasSize(PING_BYTES);
          micros[i] = (System.nanoTime() - start) * 1e-3;
        }
        Arrays.sort(micros);
        line("raw TCP: round trip, median of " + PINGS, micros[PINGS / 2], "µs");
        socket.shutdownOutput();
        start = System.nanoTime();
        byte[] buffer = new byte[BLOCK_BYTES];
        long bytes = 0;
        for (int n = socket.getInputStream().read(buffer); n >= 0; ) {
          bytes += n;
          n = socket.getInputStream().read(buffer);
        }
        line("raw TCP: blocks of 1 MiB", bytes * 1e3 / (System.nanoTime() - start), "MB/s");
      }
      echo.join();
    }
  }

  private static void answerRaw(ServerSocket port) {
    try (Socket socket = port.accept()) {
      socket.setTcpNoDelay(true);
      byte[] question = new byte[PING_BYTES];
      while (socket.getInputStream().readNBytes(question, 0, PING_BYTES) == PING_BYTES) {
        socket.getOutputStream().write(question);
      }
      byte[] block = new byte[BLOCK_BYTES];
      for (int i = 0; i < BLOCKS; i++) {
        socket.getOutputStream().write(block);
      }
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** A different file each time, so that nothing comes from what is kept. */
  private void setUp(MechServer service, String how) throws UserException {
    ModelFile file = Pendulum.file();
    file.content = Arrays.copyOf(file.content, file.content.length + 1);
    file.content[file.content.length - 1] = '\n';
    file.fileName = "p" + report.size() + System.nanoTime() + ".xml";
    long start = System.nanoTime();
    MechSim session = service.createSession("speed", "", null);
    session.loadModel(file, new ModelFile[0]);
    long loaded = System.nanoTime();
    session.createSimulation(AS_IN_FILE, null);
    long ready = System.nanoTime();
    session.compileToJar(AS_IN_FILE, new JarInfoHolder());
    session.fetchRuntime(session.getRuntimeInfo().sha256);
    long fetched = System.nanoTime();
    Map<String, String> times = new TreeMap<>();
    for (NameValue time : session.timings()) {
      times.put(time.key, time.text);
    }
    session.destroy();
    if (!how.isEmpty()) {
      line("t1c, " + how + " (session and model)", (loaded - start) * 1e-6, "ms");
      line("t1s, " + how, 1e3 * Double.parseDouble(times.getOrDefault("t1s", "0")), "ms");
      line("tcc, " + how, 1e3 * Double.parseDouble(times.getOrDefault("tcc", "0")), "ms");
      line("remote set-up, " + how, (ready - start) * 1e-6, "ms");
      line("t2c, " + how + " (JARs, class kept)", (fetched - ready) * 1e-6, "ms");
      line("t2s, " + how, 1e3 * Double.parseDouble(times.getOrDefault("t2s", "0")), "ms");
    }
  }

  private void blocks(MechServer service) throws UserException, IOException {
    MechSim session = service.createSession("speed", "", null);
    session.loadModel(Pendulum.file(), new ModelFile[0]);
    IMechSimRemote run = session.createSimulation(AS_IN_FILE, null);
    run.start();
    ResultCursor cursor = run.openResults(new String[0]);
    throughput("blocks of 1 MiB, while the run goes on", cursor, 0);
    for (int rows : new int[] {0, 0, 1000, 100}) {
      cursor.seekRow(0);
      throughput("blocks of " + (rows == 0 ? "1 MiB" : rows + " rows"), cursor, rows);
    }
    cursor.seekRow(0);
    ResultBlockHolder block = new ResultBlockHolder();
    long start = System.nanoTime();
    for (int i = 0; i < PINGS; i++) {
      cursor.nextBlock(1, 0, block);
    }
    line("step by step, one row a call", (System.nanoTime() - start) * 1e-3 / PINGS, "µs per row");
    session.destroy();
  }

  private void throughput(String what, ResultCursor cursor, int maxRows) throws UserException {
    ResultBlockHolder block = new ResultBlockHolder();
    long bytes = 0;
    long start = System.nanoTime();
    do {
      cursor.nextBlock(maxRows, 1000, block);
      bytes += 8L * block.value.values.length;
    } while (!block.value.endOfData);
    double megabytesPerSecond = bytes * 1e3 / (System.nanoTime() - start);
    line(what, megabytesPerSecond, "MB/s");
    if (maxRows == 0) {
      assertThat(megabytesPerSecond).as(what).isGreaterThan(LEAST_STREAMING);
    }
  }

  private void line(String what, double value, String unit) {
    report.add(String.format(Locale.ROOT, "| %s | %.3g %s |", what, value, unit));
  }
}
