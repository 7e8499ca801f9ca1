package org.mechservice.cli.picture;

import static org.assertj.core.api.Assertions.assertThat;

import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import java.io.BufferedReader;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpRequest.BodyPublishers;
import java.net.http.HttpResponse.BodyHandlers;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.mechservice.cli.Mech;
import org.mechservice.cli.model.SceneReader;
import org.mechservice.client.MechConnection;
import org.mechservice.mechml.document.Document;
import org.mechservice.server.MechServerProcess;
import org.mechservice.server.ServerSettings;
import org.mechservice.view.web.UserWeb;

/** The page for users with many users, and with hosts that are lost. */
@Tag("soak")
class WebLoadTest {
  private static final HttpClient HTTP = HttpClient.newHttpClient();

  private static HttpRequest.Builder request(UserWeb web, String path) {
    return HttpRequest.newBuilder(URI.create("http://127.0.0.1:" + web.port() + path))
        .header("Authorization", "Bearer " + web.url().replaceFirst(".*#token=", ""))
        .header("Sec-Fetch-Site", "same-origin");
  }

  private static String get(UserWeb web, String path) throws Exception {
    return HTTP.send(request(web, path).build(), BodyHandlers.ofString()).body();
  }

  private static String run(UserWeb web, String end) throws Exception {
    JsonObject order = new JsonObject();
    order.addProperty(
        "text", Files.readString(Path.of("..", "examples", "pendulum", "pendulum.xml")));
    order.addProperty("tEnd", end);
    HttpRequest post =
        request(web, "/api/run")
            .header("Content-Type", "application/json")
            .POST(BodyPublishers.ofString(order.toString()))
            .build();
    String answer = HTTP.send(post, BodyHandlers.ofString()).body();
    return JsonParser.parseString(answer).getAsJsonObject().get("run").getAsString();
  }

  @Test
  void tenUsersAtOnceGetTheSameResult() throws Exception {
    ExecutorService users = Executors.newFixedThreadPool(10);
    try (MechServerProcess server =
            MechServerProcess.start(new ServerSettings("s", "127.0.0.1", 0, 2));
        MechConnection service = MechConnection.open(server.url());
        UserWeb web =
            new UserWeb(
                service, SceneReader::read, new WebExports(), Map.of(), Document.dtd(), 0)) {
      Callable<String> user =
          () -> {
            String id = run(web, "20");
            String told = get(web, "/api/watch?run=" + id);
            assertThat(told).contains("event: rows", "\"outcome\":\"done\"");
            return get(web, "/api/result?run=" + id + "&format=csv");
          };
      List<Future<String>> results = new ArrayList<>();
      for (int i = 0; i < 10; i++) {
        results.add(users.submit(user));
      }
      String first = results.get(0).get();
      assertThat(first).startsWith("t,").contains("\n20,");
      for (Future<String> result : results) {
        assertThat(result.get()).isEqualTo(first);
      }
    } finally {
      users.shutdownNow();
    }
  }

  @Test
  void runsThatAreWatchedGoOnWhenAHostIsKilled() throws Exception {
    Optional<Process> host = Optional.empty();
    try (MechServerProcess server =
            MechServerProcess.start(new ServerSettings("s", "127.0.0.1", 0, 1));
        MechConnection service = MechConnection.open(server.url());
        UserWeb web =
            new UserWeb(
                service, SceneReader::read, new WebExports(), Map.of(), Document.dtd(), 0)) {
      Process far =
          new ProcessBuilder(
                  Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                  "-cp",
                  System.getProperty("java.class.path"),
                  Mech.class.getName(),
                  "simhost",
                  "--server",
                  server.url(),
                  "--listen",
                  "127.0.0.1:0",
                  "--name",
                  "far",
                  "--capacity",
                  "1")
              .redirectError(ProcessBuilder.Redirect.DISCARD)
              .start();
      host = Optional.of(far);
      BufferedReader out = far.inputReader();
      assertThat(out.readLine()).contains("127.0.0.1");
      List<String> ids = List.of(run(web, "2000"), run(web, "2000"));
      List<Future<String>> watched = new ArrayList<>();
      ExecutorService pages = Executors.newFixedThreadPool(2);
      for (String id : ids) {
        watched.add(pages.submit(() -> get(web, "/api/watch?run=" + id)));
      }
      Thread.sleep(1500);
      far.destroyForcibly().waitFor();
      List<String> results = new ArrayList<>();
      for (int i = 0; i < 2; i++) {
        assertThat(watched.get(i).get()).contains("\"outcome\":\"done\"");
        results.add(get(web, "/api/result?run=" + ids.get(i) + "&format=csv"));
      }
      assertThat(String.join("", watched.get(0).get(), watched.get(1).get()))
          .contains("after host far was lost");
      assertThat(results.get(0)).isEqualTo(results.get(1)).contains("\n2000,");
      pages.shutdownNow();
    } finally {
      host.ifPresent(Process::destroyForcibly);
    }
  }
}
