package org.mechservice.admin.web;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import com.google.gson.JsonArray;
import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import java.io.IOException;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.Socket;
import java.net.http.HttpResponse;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.admin.AdminConsole;
import org.mechservice.admin.ScriptedAdmin;
import org.mechservice.idl.Severity;
import org.mechservice.idl.SimState;
import org.mechservice.orb.PortInUseException;

/** What the page is served, and to whom. */
@Tag("slow")
class AdminWebTest {
  private static final AccessTokens TOKENS =
      new AccessTokens("monitor-monitor-monitor", "admin-admin-admin-admin");

  /** Long for a server that answers on a busy machine, short for one that hangs. */
  private static final Duration PATIENCE = Duration.ofSeconds(8);

  @TempDir private static Path folder;

  private static ScriptedAdmin server;
  private static AdminConsole console;
  private static AdminWeb web;
  private static Page admin;
  private static Page monitor;

  @BeforeAll
  static void start() throws IOException {
    server = new ScriptedAdmin("lab");
    server.host("big", 0.25, true, "");
    server.simulation("sim-1", "big", "arm", SimState.SIM_RUNNING);
    console = new AdminConsole(List.of(server.address()), PATIENCE);
    web = new AdminWeb(console, 0, TOKENS, Optional.of(folder.resolve("audit.jsonl")));
    admin = new Page(web.port(), TOKENS.admin());
    monitor = new Page(web.port(), TOKENS.monitor());
  }

  @BeforeEach
  void nothingHasBeenDone() {
    server.calls().clear();
  }

  @AfterAll
  static void end() throws IOException {
    web.close();
    console.close();
    server.close();
  }

  @Test
  void serverThatHasNotAnsweredYetIsConnectingNotSilent() throws Exception {
    try (ScriptedAdmin slow = new ScriptedAdmin("slow")) {
      slow.hang();
      try (AdminConsole asking = new AdminConsole(List.of(slow.address()), PATIENCE);
          AdminWeb page = new AdminWeb(asking, 0, TOKENS, Optional.empty())) {
        JsonObject row =
            new Page(page.port(), TOKENS.monitor())
                .awaitEvent("/api/updates", update -> update.has("servers"))
                .getAsJsonObject("servers")
                .getAsJsonArray("changed")
                .get(0)
                .getAsJsonObject();
        assertThat(row.get("connecting").getAsBoolean()).isTrue();
        assertThat(row.has("problem")).isFalse();
        slow.goOn();
      }
    }
  }

  private String action(String rest) {
    return "{\"server\":\"" + server.address() + "\"," + rest + "}";
  }

  private String drain() {
    return action("\"action\":\"drain\",\"host\":\"big\"");
  }

  private List<String> auditFile() throws IOException {
    return Files.readAllLines(folder.resolve("audit.jsonl"));
  }

  @Test
  void buttonsDoWhatTheirCommandLinesSay() throws Exception {
    for (String[] pair :
        new String[][] {
          {"\"action\":\"drain\",\"host\":\"big\"", "drain big", "drain host:big"},
          {"\"action\":\"undrain\",\"host\":\"\"", "undrain ", "undrain"},
          {
            "\"action\":\"stop\",\"id\":\"sim-1\",\"reason\":\"no more\"",
            "kill sim-1 no more",
            "stop sim-1 --reason 'no more'"
          },
          {
            "\"action\":\"limits\",\"host\":\"\",\"limits\":{\"queue\":4}",
            "limit  queue=4",
            "limits queue=4"
          },
          {"\"action\":\"placement\",\"policy\":\"order\"", "placement order", "placement order"},
          {"\"action\":\"shutdown\",\"grace\":9", "shutdown 9", "shutdown --grace 9"},
        }) {
      HttpResponse<String> answer = admin.post("/api/actions", action(pair[0]));
      assertThat(answer.statusCode()).as(answer.body()).isEqualTo(200);
      assertThat(
              JsonParser.parseString(answer.body()).getAsJsonObject().get("command").getAsString())
          .isEqualTo("mech admin --server " + server.address() + " " + pair[2]);
      assertThat(server.calls()).last().isEqualTo(pair[1]);
      assertThat(auditFile()).last().asString().contains("\"right\":\"admin\"", "\"done\"");
    }
  }

  @Test
  void previewDoesNothing() throws Exception {
    assertThat(admin.post("/api/preview", drain()).body()).contains("drain host big");
    assertThat(server.calls()).isEmpty();
  }

  @Test
  void monitorMayLookButNotActAndItIsAudited() throws Exception {
    assertThat(monitor.get("/api/session").body()).contains("\"right\":\"monitor\"");
    for (String path : List.of("/api/actions", "/api/preview")) {
      HttpResponse<String> refusal = monitor.post(path, drain());
      assertThat(refusal.statusCode()).isEqualTo(403);
      assertThat(refusal.body()).contains("S-133 ");
      assertThat(auditFile()).last().asString().contains("monitor", "drain host big", "S-133 ");
    }
    assertThat(server.calls()).isEmpty();
  }

  @ValueSource(strings = {"", "guess", "monitor-monitor-monitoR"})
  @ParameterizedTest
  void withoutTokenNothingIsSeenOrDoneAndItIsAudited(String token) throws Exception {
    Page stranger = new Page(web.port(), token);
    for (String what : List.of("session", "updates", "simulation", "logs", "limits", "audit")) {
      assertThat(stranger.get("/api/" + what).statusCode()).as(what).isEqualTo(401);
    }
    assertThat(stranger.post("/api/actions", drain()).statusCode()).isEqualTo(401);
    assertThat(auditFile()).last().asString().contains("nobody", "S-132 ");
    assertThat(server.calls()).isEmpty();
  }

  @CsvSource({
    "Origin, https://evil.example",
    "Origin, null",
    "Origin, http://127.0.0.1:1",
    "Sec-Fetch-Site, cross-site",
    "Sec-Fetch-Site, same-site"
  })
  @ParameterizedTest
  void requestOfAnotherSiteIsRefusedWhateverItCarries(String header, String value)
      throws Exception {
    HttpResponse<String> refusal = admin.post("/api/actions", drain(), header, value);
    assertThat(refusal.statusCode()).isEqualTo(403);
    assertThat(refusal.body()).contains("S-134 ");
    assertThat(admin.get("/api/session", header, value).statusCode()).isEqualTo(403);
    assertThat(server.calls()).isEmpty();
    assertThat(auditFile()).isNotEmpty();
  }

  @Test
  void nameOfAnotherSiteThatLeadsHereIsRefused() throws IOException {
    try (Socket socket = new Socket(InetAddress.getLoopbackAddress(), web.port())) {
      OutputStream out = socket.getOutputStream();
      out.write(
          "GET / HTTP/1.1\r\nHost: evil.example\r\nConnection: close\r\n\r\n"
              .getBytes(StandardCharsets.US_ASCII));
      out.flush();
      assertThat(new String(socket.getInputStream().readAllBytes(), StandardCharsets.UTF_8))
          .startsWith("HTTP/1.1 403 ")
          .contains("S-134 ");
    }
  }

  @Test
  void formOfAnotherSiteCannotSpeakJson() throws Exception {
    Page page = new Page(web.port(), TOKENS.admin());
    assertThat(page.post("/api/actions", "action=drain").statusCode()).isEqualTo(400);
    assertThat(page.get("/api/actions").statusCode()).isEqualTo(404);
  }

  @Test
  void everyAnswerForbidsScriptsFromElsewhere() throws Exception {
    for (String path :
        List.of("/", "/page/app.js", "/docs/errors/N-003.md", "/api/session", "/x")) {
      HttpResponse<String> answer = admin.get(path);
      assertThat(answer.headers().firstValue("Content-Security-Policy").orElse(""))
          .as(path)
          .contains("default-src 'none'", "script-src 'self';", "frame-ancestors 'none'")
          .doesNotContain("unsafe");
      assertThat(answer.headers().firstValue("X-Content-Type-Options")).contains("nosniff");
      assertThat(answer.headers().firstValue("Set-Cookie")).isEmpty();
    }
  }

  @CsvSource(
      delimiter = '|',
      value = {
        "{\"action\":\"explode\"}",
        "{\"action\":\"shutdown\",\"grace\":-1}",
        "{\"action\":\"shutdown\",\"grace\":\"soon\"}",
        "{\"action\":\"shutdown\",\"grace\":1e99}",
        "{\"action\":\"limits\",\"host\":\"\",\"limits\":{}}",
        "{\"action\":\"limits\",\"host\":\"\",\"limits\":{\"queue\":1.5}}",
        "{\"action\":[]}",
        "[]",
        "{"
      })
  @ParameterizedTest
  void requestThatMakesNoSenseIsRefused(String body) throws Exception {
    String named = body.replace("{\"action", "{\"server\":\"s\",\"action");
    HttpResponse<String> refusal = admin.post("/api/actions", named);
    assertThat(refusal.statusCode()).isEqualTo(400);
    assertThat(refusal.body()).contains("S-135 ");
  }

  @Test
  void limitThatIsNoNumberIsNamedWithItsValue() throws Exception {
    HttpResponse<String> refusal =
        admin.post(
            "/api/preview",
            "{\"server\":\"s\",\"action\":\"limits\",\"host\":\"\",\"limits\":{\"queue\":\"abc\"}}");
    assertThat(refusal.statusCode()).isEqualTo(400);
    assertThat(refusal.body())
        .contains("S-135 the request cannot be used: queue takes a whole number, not \\\"abc\\\"");
  }

  @Test
  void serversOutsideTheConsoleAreNotToBeReached() throws Exception {
    HttpResponse<String> refusal =
        admin.post(
            "/api/actions", "{\"server\":\"10.0.0.1:22\",\"action\":\"drain\",\"host\":\"\"}");
    assertThat(refusal.statusCode()).isEqualTo(404);
    assertThat(refusal.body()).contains("S-130 ");
    assertThat(admin.get("/api/logs?server=10.0.0.1:22&host=").statusCode()).isEqualTo(404);
  }

  @ValueSource(
      strings = {
        "/page/../AdminWeb.class",
        "/page/..%2f..%2fAdminWeb.class",
        "/docs/errors/..%2f..%2fpom.md",
        "/docs/errors/S-999.md",
        "/AdminWeb.class",
        "/page/app.js.map"
      })
  @ParameterizedTest
  void nothingButThePageIsServed(String path) throws Exception {
    assertThat(admin.get(path).statusCode()).isEqualTo(404);
  }

  @Test
  void pagesOfTheMessagesAreServedWithoutANetwork() throws Exception {
    assertThat(admin.get("/docs/errors/N-003.md").body())
        .contains("<h1>N-003: the step became too small</h1>");
    assertThat(admin.get("/docs/errors/README.md").body()).contains("href=\"S-130.md\">S-130</a>");
  }

  @Test
  void pageHearsOfEverythingOnceAndThenOfWhatChanges() throws Exception {
    JsonObject first =
        monitor.awaitEvent("/api/updates", update -> !changed(update, "simulations").isEmpty());
    assertThat(changed(first, "simulations").toString()).contains("\"model\":\"arm\"");
    server.happened("sim-queued", Severity.SEV_INFO, "", "something happened");
    server.simulation("sim-2", "big", "leg", SimState.SIM_QUEUED);
    JsonObject second =
        monitor.awaitEvent(
            "/api/updates", update -> changed(update, "simulations").toString().contains("leg"));
    assertThat(second.get("version").getAsLong()).isGreaterThan(first.get("version").getAsLong());
  }

  private static JsonArray changed(JsonObject update, String table) {
    return update.getAsJsonObject(table).getAsJsonArray("changed");
  }

  @Test
  void simulationIsToldWithItsModelAndCurves() throws Exception {
    server.curves("sim-1", 3);
    JsonObject detail =
        monitor.awaitEvent(
            "/api/simulation?server=" + server.address() + "&id=sim-1", said -> true);
    assertThat(detail.get("modelText").getAsString()).contains("<MechML>");
    assertThat(detail.getAsJsonObject("curves").getAsJsonArray("stepSize")).hasSize(3);
  }

  /** The report of a large model takes longer than an answer may, and perhaps than its run. */
  @Test
  void checkReportThatIsMadeLaterReachesThePageOfAnEndedRun() throws Exception {
    server.simulation("sim-large", "big", "tree", SimState.SIM_DONE);
    server.checkReport("sim-large", "");
    List<JsonObject> told = new ArrayList<>();
    monitor.awaitEvent(
        "/api/simulation?server=" + server.address() + "&id=sim-large",
        said -> {
          told.add(said);
          server.checkReport("sim-large", "{\"degreesOfFreedom\":9}");
          return told.size() == 2;
        });
    assertThat(told.get(0).get("checkReport").isJsonNull()).isTrue();
    assertThat(told.get(1).getAsJsonObject("checkReport").get("degreesOfFreedom").getAsInt())
        .isEqualTo(9);
    assertThat(told.get(1).has("modelText")).isFalse();
  }

  @Test
  void serverThatHangsIsShownAsSilentWhileThePageGoesOn() throws Exception {
    server.hang();
    JsonObject update =
        monitor.awaitEvent(
            "/api/updates", said -> changed(said, "servers").toString().contains("S-032 "));
    assertThat(changed(update, "servers").toString()).contains("\"answers\":false");
    assertThat(admin.post("/api/actions", drain()).statusCode()).isEqualTo(504);
    assertThat(admin.get("/").statusCode()).isEqualTo(200);
    server.goOn();
    monitor.awaitEvent(
        "/api/updates", said -> changed(said, "servers").toString().contains("\"answers\":true"));
  }

  @Test
  void portInUseIsNamed() {
    assertThatThrownBy(() -> new AdminWeb(console, web.port(), TOKENS, Optional.empty()))
        .isInstanceOf(PortInUseException.class)
        .hasMessageStartingWith("S-003 ");
  }

  @Test
  void tokensAreKeptForTheirOwnerAlone() throws IOException {
    Path file = folder.resolve("tokens");
    AccessTokens made = AccessTokens.kept(file);
    assertThat(AccessTokens.kept(file)).isEqualTo(made);
    assertThat(Files.getPosixFilePermissions(file)).hasSize(2);
    assertThat(made.toString()).doesNotContain(made.admin());
    Files.writeString(file, "monitor=same-same-same-same\nadmin=same-same-same-same\n");
    assertThatThrownBy(() -> AccessTokens.kept(file)).hasMessageStartingWith("S-136 ");
  }
}
