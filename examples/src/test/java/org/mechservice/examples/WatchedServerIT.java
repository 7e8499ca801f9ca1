package org.mechservice.examples;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** What an operator and his monitoring see of a server, as he starts it. */
class WatchedServerIT {
  private static final String PENDULUM = WorkingTree.PENDULUM.toString();

  @TempDir private Path folder;

  /** A run that goes on until it is ended. */
  private static String[] longRun(int port) {
    return new String[] {
      "simulate", PENDULUM, "--server", Service.url(port), "--t-end", "1e7", "--t-step", "100"
    };
  }

  private static HttpResponse<String> get(int port, String page) {
    URI address = URI.create("http://127.0.0.1:" + port + page);
    try {
      return HttpClient.newHttpClient()
          .send(HttpRequest.newBuilder(address).build(), HttpResponse.BodyHandlers.ofString());
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new AssertionError("interrupted", e);
    }
  }

  /** A client who has the only session: nobody else gets one, and /health says so. */
  @Test
  void healthFailsWhereNoSessionCanBeOpened() {
    int port = Service.freePort();
    int metrics = Service.freePort();
    String[] options = {"--metrics-port", Integer.toString(metrics), "--limit", "sessions=1"};
    Terminal terminal = new Terminal(folder);
    try (Terminal.Running server = Service.startServer(folder, port, options)) {
      assertThat(server.stdout()).contains(Service.url(port));
      assertThat(get(metrics, "/health").statusCode()).isEqualTo(200);
      try (Terminal.Running run = terminal.startMech(longRun(port))) {
        // a look at /health takes the only session, too, for a moment
        run.awaitThat("a word of the run", () -> !(run.stdout() + run.stderr()).isBlank());
        server.awaitThat("503", () -> get(metrics, "/health").statusCode() == 503);
        assertThat(get(metrics, "/health").body()).contains("S-100");
        assertThat(run.stderr()).doesNotContain("S-100");
      }
      server.awaitThat("200", () -> get(metrics, "/health").statusCode() == 200);
    }
  }

  /** The run goes on, and every event that the log has not taken is on the terminal in the end. */
  @Test
  void auditThatCannotBeWrittenIsToldAndLosesNoEvent() {
    int port = Service.freePort();
    int metrics = Service.freePort();
    String[] options = {"--metrics-port", Integer.toString(metrics), "--audit", "/dev/full"};
    try (Terminal.Running server = Service.startServer(folder, port, options)) {
      new Terminal(folder)
          .mech("simulate", PENDULUM, "--server", Service.url(port), "--out", "r.csv", "--quiet")
          .orFail();
      server.awaitThat("a word of the audit log", () -> server.stderr().contains("S-163"));
      assertThat(get(metrics, "/metrics").body().lines())
          .anyMatch(line -> line.matches("mechservice_audit_waiting_events [1-9].*"));
      server.terminate();
      assertThat(server.awaitEnd().stderr())
          .contains(
              "\"kind\":\"sim-running\"", "\"kind\":\"sim-done\"", "\"kind\":\"session-ended\"");
    }
  }

  @Test
  void whatIsKeptOfRunsIsForItsOwnerAlone() throws Exception {
    int port = Service.freePort();
    Path spool = folder.resolve("spool");
    try (Terminal.Running server = Service.startServer(folder, port, "--spool", spool.toString())) {
      assertThat(server.stdout()).contains(Service.url(port));
      try (Terminal.Running run = new Terminal(folder).startMech(longRun(port))) {
        server.awaitThat("files of the run", () -> kept(spool) > 1);
        assertThat(run.stderr()).doesNotContain("S-");
        assertThat(modes(spool)).hasSizeGreaterThan(1).allMatch(mode -> mode.endsWith("------"));
      }
    }
  }

  /** Returns the modes of a folder and of what is in it; a part file may be renamed meanwhile. */
  private static List<String> modes(Path folder) throws IOException {
    List<Path> files = new ArrayList<>(List.of(folder));
    try (Stream<Path> inside = Files.list(folder)) {
      inside.forEach(files::add);
    }
    List<String> modes = new ArrayList<>();
    for (Path file : files) {
      try {
        modes.add(PosixFilePermissions.toString(Files.getPosixFilePermissions(file)));
      } catch (NoSuchFileException e) {
        // has its final name now
      }
    }
    return modes;
  }

  private static long kept(Path spool) {
    try (Stream<Path> files = Files.list(spool)) {
      return files.count();
    } catch (IOException e) {
      return 0;
    }
  }

  /** A tree as large as the limits allow passes the set-up of a server with its defaults. */
  @Tag("soak")
  @Test
  void treeOfFiftyThousandBodiesRuns() throws Exception {
    Files.writeString(folder.resolve("large.xml"), tree(49_999));
    int port = Service.freePort();
    Terminal terminal = new Terminal(folder);
    try (Terminal.Running server = Service.startServer(folder, port)) {
      assertThat(server.stdout()).contains(Service.url(port));
      terminal.mech("check", "large.xml", "--server", Service.url(port)).orFail();
      terminal
          .mech("simulate", "large.xml", "--server", Service.url(port), "--out", "r.csv")
          .orFail();
    }
    assertThat(Files.readAllLines(folder.resolve("r.csv"))).hasSize(4);
  }

  private static String tree(int links) {
    Random random = new Random(5);
    StringBuilder text =
        new StringBuilder(
            "<MechML><MBSsimulation><dynamic><timeSet tini='0' tend='0.002' tstep='0.001'/>"
                + "<integrator name='ode113' relTol='1e-4' absTol='1e-6'/></dynamic>"
                + "</MBSsimulation><MBSmodel name='large' massUnits='kg' lengthUnits='m'><Bodies>"
                + "<body name='G'><point name='e' x='0' y='0' z='0'/><vector name='y' vx='0'"
                + " vy='1' vz='0'/></body>");
    for (int i = 0; i < links; i++) {
      text.append("<body name='b")
          .append(i)
          .append("'><point name='o' x='0' y='0' z='0'/><point name='e' x='0.1' y='0' z='0.02'/>")
          .append("<vector name='y' vx='0' vy='1' vz='0'/><cog x='0.05' y='0' z='0'/><mass")
          .append(" value='0.2'/><inertiaTensor Ixx='1e-3' Iyy='1e-3' Izz='1e-3' Ixy='0' Ixz='0'")
          .append(" Iyz='0'/></body>");
    }
    text.append("</Bodies><Joints>");
    for (int i = 0; i < links; i++) {
      String parent = i == 0 ? "G" : "b" + random.nextInt(Math.max(0, i - 1000), i);
      text.append("<joint name='j")
          .append(i)
          .append("' type='R'><body1 name='")
          .append(parent)
          .append("' point='e' vector='y'/><body2 name='b")
          .append(i)
          .append("' point='o' vector='y'/></joint>");
    }
    return text.append("</Joints><Forces><gravity gx='0' gy='0' gz='-9.81'/></Forces><topology>")
        .append("<root name='G'/></topology></MBSmodel></MechML>")
        .toString();
  }
}
