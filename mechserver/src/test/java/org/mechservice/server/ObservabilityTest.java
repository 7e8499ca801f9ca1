package org.mechservice.server;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import java.io.File;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.mechservice.idl.IMechSimRemote;
import org.mechservice.idl.Limit;
import org.mechservice.idl.MechSim;
import org.mechservice.idl.SimState;
import org.mechservice.orb.ServiceOrb;
import org.mechservice.orb.testing.Eventually;
import org.mechservice.server.hosts.PlacementPolicy;
import org.mechservice.sim.host.HostOptions;

/** What a monitoring system and an auditor learn of a server. */
@Tag("slow")
class ObservabilityTest {
  @TempDir private Path folder;

  private ServerSettings watched(Path audit) {
    return new ServerSettings(
        "127.0.0.1",
        0,
        new HostOptions("own", 1),
        PlacementPolicy.LEAST_LOADED,
        Optional.empty(),
        Optional.empty(),
        Optional.empty(),
        Optional.of(new InetSocketAddress(InetAddress.getLoopbackAddress(), 0)),
        Optional.of(audit));
  }

  private static HttpResponse<String> get(MechServerProcess server, String path) throws Exception {
    URI address = URI.create("http://127.0.0.1:" + server.metricsPort().orElseThrow() + path);
    return HttpClient.newHttpClient()
        .send(HttpRequest.newBuilder(address).build(), HttpResponse.BodyHandlers.ofString());
  }

  @Test
  void figuresFollowWhatGoesOn() throws Exception {
    try (MechServerProcess server =
            MechServerProcess.start(
                watched(folder.resolve("audit")), Farm.STEADY, Farm.ENDLESS_HOST);
        ServiceOrb orb = ServiceOrb.client()) {
      IMechSimRemote run = Farm.running(orb.connect(server.url()).createSession("ann", "", null));
      Eventually.holds(
          () ->
              get(server, "/metrics")
                  .body()
                  .contains("mechservice_runs_running{host=\"own\"} 1.0"));
      run.cancel();
      Eventually.holds(
          () ->
              get(server, "/metrics")
                  .body()
                  .contains("mechservice_runs_cancelled_total{host=\"own\"} 1.0"));
      List<String> lines = get(server, "/metrics").body().lines().toList();
      assertThat(lines)
          .allMatch(
              line ->
                  line.matches("# (HELP|TYPE) mechservice_[a-z_]+ .+")
                      || line.matches("mechservice_[a-z_]+(\\{host=\"own\"\\})? [-0-9.E]+"));
      assertThat(lines)
          .contains("mechservice_hosts_reachable 1.0", "# TYPE mechservice_hosts gauge");
    }
  }

  @Test
  void alertRulesNameFiguresThatThereAre() throws Exception {
    String rules = Files.readString(Path.of("../dist/prometheus/mechservice.rules.yml"));
    Set<String> named =
        Pattern.compile("mechservice_[a-z_]+")
            .matcher(rules)
            .results()
            .map(MatchResult::group)
            .collect(Collectors.toSet());
    try (MechServerProcess server = MechServerProcess.start(watched(folder.resolve("audit")))) {
      List<String> there =
          get(server, "/metrics")
              .body()
              .lines()
              .filter(line -> !line.startsWith("#"))
              .map(line -> line.split("[{ ]", 2)[0])
              .toList();
      assertThat(named).hasSizeGreaterThan(8);
      // Those of certificates are there with TLS only (CertificatesTest).
      assertThat(there)
          .containsAll(named.stream().filter(name -> !name.contains("certificate")).toList());
    }
  }

  @Test
  void prometheusReadsTheAlertRules() throws Exception {
    boolean found =
        Stream.of(System.getenv().getOrDefault("PATH", "").split(File.pathSeparator, -1))
            .anyMatch(path -> new File(path, "promtool").canExecute());
    assumeTrue(found, "this machine has no promtool (Debian: prometheus)");
    Process promtool =
        new ProcessBuilder("promtool", "check", "rules", "../dist/prometheus/mechservice.rules.yml")
            .redirectErrorStream(true)
            .start();
    String said = new String(promtool.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    assertThat(promtool.waitFor()).as(said).isZero();
  }

  @Test
  void healthSaysWhetherSessionsCanBeOpened() throws Exception {
    try (MechServerProcess server = MechServerProcess.start(watched(folder.resolve("audit")));
        ServiceOrb orb = ServiceOrb.client()) {
      assertThat(get(server, "/health").statusCode()).isEqualTo(200);
      orb.connectAdmin(server.url()).drain("");
      assertThat(get(server, "/health").statusCode()).isEqualTo(503);
      assertThat(get(server, "/health").body()).isEqualTo("the server is being emptied\n");
    }
  }

  /** Somebody who has all sessions: nobody else gets one, and the monitoring system learns it. */
  @Test
  void healthOpensASessionAndTellsWhenThatFails() throws Exception {
    Path audit = folder.resolve("audit");
    try (MechServerProcess server = MechServerProcess.start(watched(audit));
        ServiceOrb orb = ServiceOrb.client()) {
      orb.connectAdmin(server.url()).setLimits("", new Limit[] {new Limit("sessions", "", 1, "")});
      for (int i = 0; i < 3; i++) {
        assertThat(get(server, "/health").statusCode()).isEqualTo(200);
        Thread.sleep(1100); // an answer is good for a second
      }
      MechSim taken = orb.connect(server.url()).createSession("ann", "", null);
      HttpResponse<String> full = get(server, "/health");
      assertThat(full.statusCode()).isEqualTo(503);
      assertThat(full.body()).contains("S-100", "no more than 1 sessions");
      taken.destroy();
      Eventually.holds(() -> get(server, "/health").statusCode() == 200);
      assertThat(orb.connectAdmin(server.url()).listSessions()).isEmpty();
    }
    assertThat(Files.readString(audit)).contains("ann").doesNotContain("(health)");
  }

  /** What a browser sends for a page of a site that has given its name our address. */
  @Test
  void figuresAreForThoseWhoAskForThisMachine() throws Exception {
    try (MechServerProcess server = MechServerProcess.start(watched(folder.resolve("audit")))) {
      int port = server.metricsPort().orElseThrow();
      for (String path : List.of("/metrics", "/health")) {
        assertThat(status(port, path, "evil.example:" + port)).isEqualTo(403);
        assertThat(status(port, path, "127.0.0.1.evil.example")).isEqualTo(403);
        assertThat(status(port, path, "127.0.0.1:" + port)).isEqualTo(200);
        assertThat(status(port, path, "LOCALHOST:" + port)).isEqualTo(200);
        assertThat(status(port, path, "[::1]:" + port)).isEqualTo(200);
      }
    }
  }

  private static int status(int port, String path, String host) throws Exception {
    try (Socket socket = new Socket(InetAddress.getLoopbackAddress(), port)) {
      String request =
          "GET " + path + " HTTP/1.1\r\nHost: " + host + "\r\nConnection: close\r\n\r\n";
      socket.getOutputStream().write(request.getBytes(StandardCharsets.US_ASCII));
      String answer = new String(socket.getInputStream().readAllBytes(), StandardCharsets.US_ASCII);
      return Integer.parseInt(answer.split(" ", 3)[1]);
    }
  }

  @Test
  void auditTellsWhoRanWhat() throws Exception {
    Path file = folder.resolve("audit.jsonl");
    Files.writeString(file, "{\"kind\":\"earlier\"}\n");
    String simId;
    try (MechServerProcess server =
            MechServerProcess.start(watched(file), Farm.STEADY, HostFactory.INSTALLED);
        ServiceOrb orb = ServiceOrb.client()) {
      IMechSimRemote run = Farm.running(orb.connect(server.url()).createSession("ann", "", null));
      simId = run.simId();
      Eventually.holds(() -> run.getProgress().state == SimState.SIM_DONE);
      Eventually.holds(() -> Files.readString(file).contains("sim-done"));
    }
    List<JsonObject> lines =
        Files.readAllLines(file).stream()
            .map(line -> JsonParser.parseString(line).getAsJsonObject())
            .toList();
    assertThat(lines)
        .extracting(line -> line.get("kind").getAsString())
        .startsWith("earlier", "server-started")
        .containsSubsequence("session-opened", "sim-queued", "sim-running", "sim-done");
    JsonObject done =
        lines.stream()
            .filter(line -> line.get("kind").getAsString().equals("sim-done"))
            .findFirst()
            .orElseThrow();
    assertThat(done.get("owner").getAsString()).isEqualTo("ann");
    assertThat(done.get("simulation").getAsString()).isEqualTo(simId);
    assertThat(done.get("text").getAsString()).contains("FiveBarPendulum");
  }

  /** Nobody else loses events by it, and the figures tell. */
  @Test
  void clientNameThatIsNoTextLeavesTheAuditOfOthers() throws Exception {
    Path file = folder.resolve("audit.jsonl");
    try (MechServerProcess server =
            MechServerProcess.start(watched(file), Farm.STEADY, HostFactory.INSTALLED);
        ServiceOrb orb = ServiceOrb.client()) {
      for (String name : List.of("\ud800 \u0000 \u202e", "bob")) {
        try {
          orb.connect(server.url()).createSession(name, "", null).destroy();
        } catch (org.omg.CORBA.SystemException e) {
          // Such a name may be no text of the wire either.
        }
      }
      Eventually.holds(() -> Files.readString(file).contains("\"bob\""));
      assertThat(get(server, "/metrics").body()).contains("mechservice_audit_waiting_events 0.0");
    }
  }

  @Test
  void auditThatCannotBeWrittenKeepsTheServerFromStarting() {
    assertThatThrownBy(() -> MechServerProcess.start(watched(folder.resolve("no/such/audit"))))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageStartingWith("S-163")
        .hasMessageEndingWith("the folder it is to be in does not exist");
  }
}
