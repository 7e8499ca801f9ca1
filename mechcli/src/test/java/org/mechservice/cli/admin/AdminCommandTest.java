package org.mechservice.cli.admin;

import static org.assertj.core.api.Assertions.assertThat;

import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.mechservice.cli.Mech;
import org.mechservice.cli.shell.ExitStatus;
import org.mechservice.client.MechConnection;
import org.mechservice.client.MechSession;
import org.mechservice.client.SimulationOptions;
import org.mechservice.client.failure.RunState;
import org.mechservice.client.run.RemoteRun;
import org.mechservice.orb.testing.Eventually;
import org.mechservice.server.MechServerProcess;
import org.mechservice.server.ServerSettings;
import org.mechservice.sim.host.HostSettings;
import org.mechservice.sim.host.SimHostProcess;

/**
 * What an operator types, against a server "lab" that runs nothing itself and has one host "hut".
 */
@Tag("slow")
class AdminCommandTest {
  private static final Path MODEL = Path.of("../examples/pendulum/pendulum.xml");

  /** No test lasts until then. */
  private static final SimulationOptions ENDLESS =
      SimulationOptions.asInFile().endTime(1e8).outputStep(1e4);

  private static final MechServerProcess SERVER =
      MechServerProcess.start(new ServerSettings("lab", "127.0.0.1", 0, 0));
  private static final SimHostProcess HOST =
      SimHostProcess.start(new HostSettings(SERVER.url(), "hut", "127.0.0.1", 0, 2));
  private static final MechConnection CLIENT = MechConnection.open(SERVER.url());
  private static RemoteRun run;

  private final StringWriter out = new StringWriter();
  private final StringWriter err = new StringWriter();

  @BeforeAll
  static void runForEver() throws Exception {
    run = endless();
    Eventually.holds(() -> run.progress().state() == RunState.RUNNING);
  }

  private static RemoteRun endless() throws IOException {
    MechSession session = CLIENT.openSession();
    session.loadModel(MODEL);
    RemoteRun endless = session.prepareRemoteRun(ENDLESS);
    endless.start();
    return endless;
  }

  @AfterAll
  static void end() {
    CLIENT.close();
    HOST.close();
    SERVER.close();
  }

  private int admin(String... words) {
    out.getBuffer().setLength(0);
    err.getBuffer().setLength(0);
    List<String> line =
        new ArrayList<>(List.of("admin", "--timeout", "60", "--server", SERVER.url()));
    line.addAll(List.of(words));
    return Mech.run(new PrintWriter(out), new PrintWriter(err), line.toArray(String[]::new));
  }

  private JsonObject json(String... words) {
    List<String> line = new ArrayList<>(List.of(words));
    line.add("--json");
    assertThat(admin(line.toArray(String[]::new))).as(err.toString()).isZero();
    return JsonParser.parseString(out.toString()).getAsJsonObject();
  }

  private static JsonObject first(JsonObject object, String list) {
    return object.getAsJsonArray(list).get(0).getAsJsonObject();
  }

  @Test
  void everyListNamesWhatThereIs() {
    assertThat(admin()).isZero();
    assertThat(out.toString()).contains("SERVER", "lab", "HOST", "hut", "FiveBarPendulum");
    admin("servers");
    assertThat(out.toString()).contains("lab").doesNotContain("hut");
    admin("hosts");
    assertThat(out.toString()).contains("hut").doesNotContain("FiveBarPendulum");
    admin("sims");
    assertThat(out.toString()).contains(run.id(), "running");
    admin("logs");
    assertThat(out.toString()).contains("server lab has started", "host hut joined");
    admin("logs", "hut", "--lines", "1");
    assertThat(out.toString()).hasLineCount(2);
  }

  @Test
  void listsAreJsonForScripts() {
    assertThat(first(json("servers"), "servers").get("name").getAsString()).isEqualTo("lab");
    assertThat(first(json("hosts"), "hosts").get("state").getAsString()).isEqualTo("up");
    assertThat(json("logs").getAsJsonArray("lines")).isNotEmpty();
    assertThat(json("placement").getAsJsonObject("placement").get(SERVER.url()).getAsString())
        .isEqualTo("least-loaded");
    assertThat(json("status").getAsJsonArray("servers")).hasSize(1);
  }

  @Test
  void simulationIsShownByTheBeginningOfItsId() {
    admin("show", run.id().substring(0, 8));
    assertThat(out.toString()).contains(run.id(), "FiveBarPendulum", "x real time");
    assertThat(json("show", run.id()).get("modelText").getAsString()).contains("<MechML");
    admin("show", run.id(), "--model");
    assertThat(out.toString()).startsWith("<?xml");
  }

  @Test
  void stoppedSimulationHasEndedWithTheReasonGiven() throws Exception {
    RemoteRun doomed = endless();
    assertThat(admin("stop", doomed.id(), "--reason", "power cut at noon")).isZero();
    assertThat(out.toString()).contains("done at", doomed.id());
    Eventually.holds(
        () -> {
          JsonObject shown = json("show", doomed.id());
          return shown.get("state").getAsString().equals("cancelled")
              && shown.get("events").toString().contains("power cut at noon");
        });
    Eventually.holds(
        () ->
            json("sims", "--state", "cancelled").getAsJsonArray("simulations").asList().stream()
                .map(JsonElement::toString)
                .anyMatch(sim -> sim.contains(doomed.id())));
  }

  @Test
  void hostAndServerAreDrainedAndUndrained() throws Exception {
    assertThat(admin("drain", "hut")).isZero();
    Eventually.holds(
        () -> first(json("hosts"), "hosts").get("state").getAsString().equals("draining"));
    assertThat(admin("undrain", "hut")).isZero();
    Eventually.holds(() -> first(json("hosts"), "hosts").get("state").getAsString().equals("up"));
    assertThat(admin("drain", "lab")).isZero();
    assertThat(first(json("servers"), "servers").get("draining").getAsBoolean()).isTrue();
    assertThat(admin("undrain")).isZero();
    assertThat(first(json("servers"), "servers").get("draining").getAsBoolean()).isFalse();
  }

  @Test
  void limitsAreShownAndSet() {
    assertThat(admin("limits", "cursors=5", "wallTime=unlimited")).isZero();
    admin("limits");
    assertThat(out.toString())
        .containsPattern("cursors +5 ")
        .containsPattern("wallTime +unlimited");
    assertThat(admin("limits", "--host", "hut", "cursors=6")).isZero();
    assertThat(first(json("limits", "--host", "hut"), "places").toString())
        .contains("{\"name\":\"cursors\",\"value\":6");
  }

  @Test
  void placementIsShownAndSet() {
    assertThat(admin("placement", "least-loaded")).isZero();
    admin("placement");
    assertThat(out.toString()).contains("least-loaded");
  }

  @CsvSource(
      delimiter = '|',
      value = {
        "show nosuch | 2 | S-130 there is no simulation nosuch",
        "stop nosuch | 2 | S-130 there is no simulation nosuch",
        "drain nosuch | 2 | S-130 there is no server or host nosuch; there are lab, hut",
        "logs nosuch | 2 | S-130 ",
        "limits --host nosuch | 2 | S-130 ",
        "limits cursors=many | 2 | S-041 cursors takes a whole number or unlimited, not many",
        "limits nosuch=1 | 2 | S-015 there is no limit \"nosuch\"",
        "placement random | 2 | S-008 ",
        "shutdown --grace -1 | 2 | S-135 ",
        "logs --lines -3 | 2 | S-041 --lines is -3; it must be 1 or more",
        "sims --state odd | 2 | S-041 --state takes created or queued or running",
        "watsch | 2 | S-040 unknown command watsch",
        "stop | 2 | S-041 ID is missing (mech admin help stop lists what there is)",
      })
  @ParameterizedTest
  void whatCannotBeDoneIsSaidInOneLine(String line, int status, String message) {
    assertThat(admin(line.split(" "))).isEqualTo(status);
    assertThat(err.toString()).startsWith(message).hasLineCount(1);
  }

  @Test
  void serverThatDoesNotAnswerDoesNotHideTheOthers() {
    assertThat(admin("--server", "127.0.0.1:1", "servers")).isEqualTo(ExitStatus.SERVER);
    assertThat(out.toString()).contains("lab").containsPattern("127\\.0\\.0\\.1:1 +no answer");
    assertThat(err.toString()).startsWith("S-0").contains("127.0.0.1:1").hasLineCount(1);
    assertThat(admin("--server", "127.0.0.1:1", "shutdown")).isEqualTo(ExitStatus.BAD_INPUT);
    assertThat(err.toString()).startsWith("S-131 ");
  }

  @Test
  void serverIsShutDown() throws Exception {
    try (MechServerProcess doomed =
        MechServerProcess.start(new ServerSettings("doomed", "127.0.0.1", 0, 1))) {
      int status = admin("--server", doomed.url(), "shutdown", "doomed", "--grace", "0");
      assertThat(status).as(err.toString()).isZero();
      doomed.awaitShutdown();
    }
  }
}
