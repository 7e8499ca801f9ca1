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
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.mechservice.cli.Mech;
import org.mechservice.cli.model.SceneReader;
import org.mechservice.client.MechConnection;
import org.mechservice.load.SoakPage;
import org.mechservice.mechml.document.Document;
import org.mechservice.server.MechServerProcess;
import org.mechservice.server.ServerSettings;
import org.mechservice.view.web.UserWeb;

/** The page for users with many users, and with hosts that are lost. */
@Tag("soak")
class WebLoadTest {
  private static final HttpClient HTTP = HttpClient.newHttpClient();

  private static final SoakPage PAGE =
      new SoakPage(
          "The page for users: ten at once, and a host killed while runs are watched",
          "The server of the page is a client of one server, over CORBA. Ten users order a run of"
              + " the pendulum at the same moment, each watches it by server-sent events from the"
              + " first row to the last and then takes it as CSV; the server has two places, so"
              + " that the others wait. Then two runs are watched, one at the server and one at"
              + " another host, whose process is killed 1.5 s later: both go on to their end, the"
              + " lost one at the host that is left, and have the same bytes.",
          0);

  @AfterAll
  static void writePage() throws Exception {
    PAGE.write("web-users.md");
  }

  private static HttpRequest.Builder request(UserWeb web, String path) {
    return HttpRequest.newBuilder(URI.create("http://127.0.0.1:" + web.port() + path))
        .header("Authorization", "Bearer " + web.url().replaceFirst(".*#token=", ""))
        .header("Sec-Fetch-Site", "same-origin");
  }

  private static String get(UserWeb web, String path) throws Exception {
    return HTTP.send(request(web, path).build(), BodyHandlers.ofString()).body();
  }

  private static double secondsSince(long begun) {
    return (System.nanoTime() - begun) * 1e-9;
  }

  private static int times(String text, String part) {
    return text.split(part, -1).length - 1;
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
      List<Double> seconds = Collections.synchronizedList(new ArrayList<>());
      List<Integer> pieces = Collections.synchronizedList(new ArrayList<>());
      Callable<String> user =
          () -> {
            long begun = System.nanoTime();
            String id = run(web, "20");
            String told = get(web, "/api/watch?run=" + id);
            assertThat(told).contains("event: rows", "\"outcome\":\"done\"");
            seconds.add(secondsSince(begun));
            pieces.add(times(told, "event: rows"));
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
      Collections.sort(seconds);
      Collections.sort(pieces);
      PAGE.line("| ten users at once | |")
          .line("|---|---|")
          .line(
              "| users whose CSV is equal to the first one's, byte by byte | %d |", results.size())
          .line("| rows of each | %d |", times(first, "\n") - 1)
          .line(
              "| order to last row, shortest and longest | %.2f and %.2f s |",
              seconds.get(0), seconds.get(9))
          .line(
              "| pieces in which the rows came, fewest and most | %d and %d |%n",
              pieces.get(0), pieces.get(9));
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
      long killed = System.nanoTime();
      List<String> results = new ArrayList<>();
      for (int i = 0; i < 2; i++) {
        assertThat(watched.get(i).get()).contains("\"outcome\":\"done\"");
        results.add(get(web, "/api/result?run=" + ids.get(i) + "&format=csv"));
      }
      assertThat(String.join("", watched.get(0).get(), watched.get(1).get()))
          .contains("after host far was lost");
      assertThat(results.get(0)).isEqualTo(results.get(1)).contains("\n2000,");
      PAGE.line("| a host killed | |")
          .line("|---|---|")
          .line("| runs watched, and ended with equal bytes | 2 |")
          .line("| rows of each | %d |", times(results.get(0), "\n") - 1)
          .line("| from the kill to the end of both runs | %.1f s |", secondsSince(killed));
      pages.shutdownNow();
    } finally {
      host.ifPresent(Process::destroyForcibly);
    }
  }
}
