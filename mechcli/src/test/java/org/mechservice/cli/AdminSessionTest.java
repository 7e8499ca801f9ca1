package org.mechservice.cli;

import static org.assertj.core.api.Assertions.assertThat;

import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import java.io.BufferedReader;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.lang.management.ManagementFactory;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.time.LocalDate;
import java.time.ZoneOffset;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.mechservice.admin.AdminConsole;
import org.mechservice.admin.web.AccessTokens;
import org.mechservice.admin.web.AdminWeb;
import org.mechservice.client.MechConnection;
import org.mechservice.client.MechSession;
import org.mechservice.client.SimulationOptions;
import org.mechservice.orb.testing.Eventually;
import org.mechservice.server.MechServerProcess;
import org.mechservice.server.ServerSettings;
import org.mechservice.sim.host.HostSettings;
import org.mechservice.sim.host.SimHostProcess;

/**
 * An operator's day on both faces of the console.
 *
 * <pre>
 * server north   host n1            five runs: three that come to their end, one that fails, one endless
 *                host n2 (a process of its own, killed)   the same
 * server south   host s1            the same
 * server east    host e1            the same
 * </pre>
 */
@Tag("slow")
class AdminSessionTest {
  private static final Path MODEL = Path.of("../examples/pendulum/pendulum.xml");

  /** Below 1e11 steps, from which a run is given up (N-005). */
  private static final SimulationOptions ENDLESS =
      SimulationOptions.asInFile().endTime(1e8).outputStep(1e4);

  private static final int CAPACITY = 5;

  /** On a machine that is busy with other things, answers take long. */
  private static final Duration PATIENCE = Duration.ofSeconds(60);

  private final Deque<AutoCloseable> parts = new ArrayDeque<>();
  private final AccessTokens tokens = AccessTokens.random();
  private final List<String> servers = new ArrayList<>();
  private Process killed;
  private PageFeed page;

  private <T extends AutoCloseable> T part(T part) {
    parts.push(part);
    return part;
  }

  @BeforeEach
  void start() throws Exception {
    String north = server("north");
    host(north, "n1");
    killed = hostProcess(north, "n2");
    host(server("south"), "s1");
    host(server("east"), "e1");
    AdminConsole console = part(new AdminConsole(servers, PATIENCE));
    AdminWeb web = part(new AdminWeb(console, 0, tokens, Optional.empty()));
    page = part(new PageFeed(web.port(), tokens.monitor()));
  }

  private String server(String name) {
    String url = part(MechServerProcess.start(new ServerSettings(name, "127.0.0.1", 0, 0))).url();
    servers.add(url);
    return url;
  }

  private void host(String server, String name) {
    part(SimHostProcess.start(new HostSettings(server, name, "127.0.0.1", 0, CAPACITY)));
  }

  private Process hostProcess(String server, String name) throws IOException {
    Process process =
        new ProcessBuilder(
                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-cp",
                System.getProperty("java.class.path"),
                Mech.class.getName(),
                "simhost",
                "--server",
                server,
                "--listen",
                "127.0.0.1:0",
                "--name",
                name,
                "--capacity",
                Integer.toString(CAPACITY))
            .redirectError(ProcessBuilder.Redirect.DISCARD)
            .start();
    parts.push(() -> process.destroyForcibly().waitFor());
    try (BufferedReader out = process.inputReader()) {
      assertThat(out.readLine()).contains("127.0.0.1:");
    }
    return process;
  }

  @AfterEach
  void end() throws Exception {
    while (!parts.isEmpty()) {
      parts.pop().close();
    }
  }

  private void fiveRuns(String server, String host) throws IOException {
    MechConnection client = part(MechConnection.open(server));
    MechSession session = client.openSession(host);
    session.loadModel(MODEL);
    for (int i = 0; i < 3; i++) {
      session.prepareRemoteRun(SimulationOptions.asInFile()).start();
    }
    session.prepareRemoteRun(ENDLESS).start();
    // Velocities whose squares are beyond the range of numbers come within the first step.
    byte[] heavy =
        Files.readString(MODEL).replace("-9.81", "-1e300").getBytes(StandardCharsets.UTF_8);
    MechSession doomed = client.openSession(host);
    doomed.loadModel("heavy.xml", heavy);
    doomed.prepareRemoteRun(SimulationOptions.asInFile()).start();
  }

  private static String admin(List<String> servers, String... words) {
    StringWriter out = new StringWriter();
    List<String> line = new ArrayList<>(List.of("admin", "--json", "--timeout", "60"));
    servers.forEach(server -> line.addAll(List.of("--server", server)));
    line.addAll(List.of(words));
    int status =
        Mech.run(
            new PrintWriter(out), new PrintWriter(new StringWriter()), line.toArray(String[]::new));
    assertThat(status).isZero();
    return out.toString();
  }

  /** Returns how many simulations the terminal shows in each state. */
  private Map<String, Integer> statesOnTheTerminal() {
    return states(
        JsonParser.parseString(admin(servers, "sims", "--all"))
            .getAsJsonObject()
            .getAsJsonArray("simulations")
            .asList());
  }

  /** Returns what the terminal shows of a run on a host, in full. */
  private String shownOf(String host, String state) {
    for (JsonElement element :
        JsonParser.parseString(admin(servers, "sims", "--state", state))
            .getAsJsonObject()
            .getAsJsonArray("simulations")) {
      JsonObject simulation = element.getAsJsonObject();
      if (simulation.get("host").getAsString().equals(host)
          && !simulation.get("message").getAsString().startsWith("N-")) {
        return admin(servers, "show", simulation.get("id").getAsString());
      }
    }
    throw new AssertionError("nothing " + state + " on " + host);
  }

  private static Map<String, Integer> states(Iterable<? extends JsonElement> simulations) {
    Map<String, Integer> counts = new TreeMap<>();
    for (JsonElement simulation : simulations) {
      counts.merge(simulation.getAsJsonObject().get("state").getAsString(), 1, Integer::sum);
    }
    return counts;
  }

  private void session() throws Exception {
    fiveRuns(servers.get(0), "n1");
    fiveRuns(servers.get(0), "n2");
    fiveRuns(servers.get(1), "s1");
    fiveRuns(servers.get(2), "e1");
    Map<String, Integer> settled = Map.of("done", 12, "failed", 4, "running", 4);
    Eventually.holds(() -> states(page.simulations()).equals(settled));
    assertThat(statesOnTheTerminal()).isEqualTo(settled);
    assertThat(page.simulations().toString()).contains("N-0");

    // A server has what it has shown; what else it has read by then depends on the machine.
    assertThat(shownOf("n2", "done")).contains("<MechML");
    assertThat(shownOf("n2", "running")).contains("<MechML");
    killed.destroyForcibly().waitFor();
    // What had ended on the host is still shown; what was going on has failed.
    Map<String, Integer> after = Map.of("done", 12, "failed", 5, "running", 3);
    Eventually.holds(() -> states(page.simulations()).equals(after));
    assertThat(statesOnTheTerminal()).isEqualTo(after);
    assertThat(shownOf("n2", "done")).contains("<MechML", "\"outcome\": \"completed\"");
    assertThat(shownOf("n2", "failed")).contains("<MechML", "S-113");
    Eventually.holds(() -> page.host("n2").get("state").getAsString().equals("lost"));
    assertThat(admin(servers, "hosts")).contains("\"state\": \"lost\"");
    assertThat(admin(servers, "sims", "--state", "failed")).contains("S-113 ", "n2");
    Eventually.holds(() -> page.latencies().containsKey("host-lost"));
  }

  @Test
  void bothFacesShowWhatTheServersKnow() throws Exception {
    session();
  }

  @Tag("soak")
  @Test
  void howSoonTheFacesShowWhatTheServersKnow() throws Exception {
    session();
    StringBuilder rows = new StringBuilder();
    page.latencies()
        .forEach(
            (kind, millis) ->
                rows.append(
                    String.format(
                        Locale.ROOT,
                        "| %s | %d | %d ms | %d ms |%n",
                        kind,
                        millis.size(),
                        millis.get(millis.size() / 2),
                        millis.get(millis.size() - 1))));
    long asked = System.nanoTime();
    admin(servers, "status");
    long terminal = (System.nanoTime() - asked) / 1_000_000;
    Files.writeString(
        Path.of("../docs/reports/admin-latency.md"),
        String.format(
            Locale.ROOT,
            """
            # How soon the admin console knows

            Measured on %s by `mvn verify -Psoak`: JDK %s, %d processors, load average %.1f; three servers, four hosts, twenty runs, one host killed, all on one machine. The time is counted from the event's own, taken by the server or host where it happened, to the page's update that shows it.

            | event | how often | median | longest |
            |---|---|---|---|
            %s
            `mech admin status` for the three servers, with its start: %d ms within a running JVM.
            """,
            LocalDate.now(ZoneOffset.UTC),
            Runtime.version(),
            Runtime.getRuntime().availableProcessors(),
            ManagementFactory.getOperatingSystemMXBean().getSystemLoadAverage(),
            rows,
            terminal));
  }
}
