package org.mechservice.cli.picture;

import static org.assertj.core.api.Assertions.assertThat;

import com.google.gson.JsonArray;
import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import java.io.IOException;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpHeaders;
import java.net.http.HttpRequest;
import java.net.http.HttpRequest.BodyPublishers;
import java.net.http.HttpResponse;
import java.net.http.HttpResponse.BodyHandlers;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.mechservice.cli.model.SceneReader;
import org.mechservice.cli.shell.ServerOption;
import org.mechservice.cli.shell.ServiceConnection;
import org.mechservice.guard.UserCode;
import org.mechservice.mechml.document.Document;
import org.mechservice.view.web.UserWeb;

/** The requests of the page for users, against an embedded server. */
@Tag("slow")
class UserWebTest {
  private static ServiceConnection service;
  private static UserWeb web;
  private static String token = "";
  private static String pendulum = "";

  @BeforeAll
  static void start() throws IOException {
    service = ServiceConnection.open(new ServerOption(), 4, UserCode.NONE);
    web =
        new UserWeb(
            service.connection(), SceneReader::read, new WebExports(), Map.of(), Document.dtd(), 0);
    token = web.url().replaceFirst(".*#token=", "");
    pendulum = Files.readString(Path.of("..", "examples", "pendulum", "pendulum.xml"));
  }

  @AfterAll
  static void end() {
    web.close();
    service.close();
  }

  private static final HttpClient HTTP = HttpClient.newHttpClient();

  /** An answer of the page's server. */
  private static final class Answer {
    private final HttpResponse<byte[]> response;

    Answer(HttpResponse<byte[]> response) {
      this.response = response;
    }

    int status() {
      return response.statusCode();
    }

    byte[] content() {
      return response.body();
    }

    HttpHeaders headers() {
      return response.headers();
    }

    JsonObject json() {
      return JsonParser.parseString(text()).getAsJsonObject();
    }

    String text() {
      return new String(content(), StandardCharsets.UTF_8);
    }
  }

  private static Answer ask(String path, String bearer, String body, String site)
      throws IOException {
    HttpRequest.Builder request =
        HttpRequest.newBuilder(URI.create("http://127.0.0.1:" + web.port() + path))
            .header("Authorization", "Bearer " + bearer)
            .header("Sec-Fetch-Site", site);
    if (!body.isEmpty()) {
      request.header("Content-Type", "application/json").POST(BodyPublishers.ofString(body));
    }
    try {
      return new Answer(HTTP.send(request.build(), BodyHandlers.ofByteArray()));
    } catch (InterruptedException e) {
      throw new IOException("interrupted", e);
    }
  }

  private static Answer get(String path) throws IOException {
    return ask(path, token, "", "same-origin");
  }

  private static Answer post(String what, JsonObject body) throws IOException {
    return ask("/api/" + what, token, body.toString(), "same-origin");
  }

  private static JsonObject model(String text) {
    JsonObject body = new JsonObject();
    body.addProperty("name", "model.xml");
    body.addProperty("text", text);
    return body;
  }

  private static String run(JsonObject body) throws IOException {
    Answer answer = post("run", body);
    assertThat(answer.status()).as(answer.text()).isEqualTo(200);
    return answer.json().get("run").getAsString();
  }

  @Test
  void goodModelIsCheckedAndDrawn() throws IOException {
    JsonObject answer = post("check", model(pendulum)).json();

    assertThat(answer.get("ok").getAsBoolean()).isTrue();
    assertThat(answer.get("report").getAsString()).contains("freedom");
    assertThat(answer.get("drawing").getAsString()).startsWith("<svg");
  }

  @Test
  void badModelIsToldAtItsLine() throws IOException {
    String bad = pendulum.replaceFirst("<body name=\"bar2\"", "<bdoy name=\"bar2\"");
    JsonObject answer = post("check", model(bad)).json();

    JsonArray messages = answer.getAsJsonArray("messages");
    assertThat(answer.get("ok").getAsBoolean()).isFalse();
    assertThat(messages.get(0).getAsJsonObject().get("line").getAsInt()).isPositive();
  }

  @Test
  void runIsWatchedToItsEndAndDownloaded() throws IOException {
    JsonObject order = model(pendulum);
    order.addProperty("tEnd", "0.5");
    String id = run(order);

    String told = get("/api/watch?run=" + id).text();

    assertThat(told).contains("event: begin", "event: rows", "\"outcome\":\"done\"");
    assertThat(get("/api/result?run=" + id + "&format=csv").text()).startsWith("t,");
    assertThat(get("/api/result?run=" + id + "&format=mat").content()).startsWith('M', 'A', 'T');
    assertThat(get("/api/result?run=" + id + "&format=glb").content()).startsWith('g', 'l', 'T');
    assertThat(get("/api/result?run=" + id + "&format=html").text()).contains("FiveBarPendulum");
    assertThat(get("/api/result?run=" + id + "&format=jar").content()).startsWith('P', 'K');
    assertThat(get("/api/result?run=" + id + "&format=exe").status()).isEqualTo(400);
  }

  @Test
  void cancelledRunKeepsItsRows() throws IOException {
    JsonObject order = model(pendulum);
    order.addProperty("tEnd", "100000");
    String id = run(order);
    JsonObject which = new JsonObject();
    which.addProperty("run", id);

    assertThat(post("cancel", which).status()).isEqualTo(200);

    assertThat(get("/api/watch?run=" + id).text()).contains("\"outcome\":\"cancelled\"");
  }

  @Test
  void optionThatTheServerRefusesIsToldAsItSaysIt() throws IOException {
    JsonObject order = model(pendulum);
    order.addProperty("integrator", "euler");

    assertThat(get("/api/watch?run=" + run(order)).text()).contains("failed", "euler");
    order.addProperty("tEnd", "soon");
    assertThat(post("run", order).text()).contains("tEnd must be a number");
  }

  @Test
  void strangersAreRefused() throws IOException {
    assertThat(ask("/api/start", "guess", "", "same-origin").status()).isEqualTo(401);
    assertThat(ask("/api/start", token, "", "cross-site").status()).isEqualTo(403);
    assertThat(get("/api/watch?run=guess").status()).isEqualTo(404);
    assertThat(get("/web.class").status()).isEqualTo(404);
    assertThat(get("/player/../UserWeb.class").status()).isEqualTo(404);
  }

  @Test
  void twoRunsAreComparedAndAModelLeavesAsUnit() throws IOException {
    JsonObject order = model(pendulum);
    order.addProperty("tEnd", "0.5");
    String first = run(order);
    order.addProperty("relTol", "1e-2");
    order.addProperty("absTol", "1e-2");
    String second = run(order);
    get("/api/watch?run=" + first);
    get("/api/watch?run=" + second);

    String names = "&name=Run+1&other=%3Cb%3E";
    JsonObject same = get("/api/differences?first=" + first + "&second=" + first + names).json();
    assertThat(same.get("equal").getAsBoolean()).isTrue();
    JsonObject other = get("/api/differences?first=" + first + "&second=" + second + names).json();
    assertThat(other.get("equal").getAsBoolean()).isFalse();
    assertThat(other.getAsJsonArray("notes").get(0).getAsString()).contains("largest difference");
    assertThat(other.get("picture").getAsString()).startsWith("<svg").contains("&lt;b&gt;");
    byte[] unit = get("/api/result?run=" + first + "&format=fmu").content();
    assertThat(new String(unit, StandardCharsets.ISO_8859_1))
        .startsWith("PK")
        .contains("modelDescription.xml");
  }

  @Test
  void measurementTellsHowFarItIsAndIsCancelled() throws IOException {
    JsonObject order = new JsonObject();
    order.addProperty("text", pendulum);
    String id = post("measure", order).json().get("report").getAsString();
    assertThat(get("/api/report?report=" + id).json().get("state").getAsString()).isEqualTo("runs");
    assertThat(post("measure", order).status()).isEqualTo(503);
    JsonObject which = new JsonObject();
    which.addProperty("report", id);
    post("unmeasure", which);
    assertThat(get("/api/report?report=" + id).json().get("state").getAsString())
        .isEqualTo("cancelled");
    assertThat(get("/report/" + id + "/model.html").status()).isEqualTo(404);
    assertThat(get("/report/" + id + "/..%2fx.html").status()).isEqualTo(404);
    assertThat(get("/report/nobody/model.html").status()).isEqualTo(404);
  }

  @Test
  void pageRunsNoScriptsButItsOwn() throws IOException {
    Answer page = get("/");

    assertThat(page.headers().firstValue("Content-Security-Policy").orElse(""))
        .contains("default-src 'none'", "script-src 'self'", "trusted-types 'none'")
        .doesNotContain("unsafe");
    assertThat(page.text()).doesNotContain("http://", "https://", "onclick");
    assertThat(get("/player/space.js").status()).isEqualTo(200);
    assertThat(get("/api.js").status()).isEqualTo(200);
  }
}
