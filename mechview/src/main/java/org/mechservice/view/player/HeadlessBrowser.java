package org.mechservice.view.player;

import com.google.gson.Gson;
import com.google.gson.JsonElement;
import com.google.gson.JsonNull;
import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import java.io.File;
import java.io.IOException;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.WebSocket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.Stream;

/**
 * The Chromium of this machine without a window, with one page, driven by its DevTools protocol.
 */
final class HeadlessBrowser implements AutoCloseable {
  private static final List<String> NAMES =
      List.of("chromium", "chromium-browser", "google-chrome", "google-chrome-stable", "chrome");

  /** A picture without a graphics processor takes seconds on a busy machine. */
  private static final long PATIENCE_SECONDS = 120;

  private final Path profile;
  private final Process process;
  private final WebSocket socket;
  private final AtomicInteger ids = new AtomicInteger();
  private final Map<Integer, CompletableFuture<JsonObject>> answers = new ConcurrentHashMap<>();
  private String session = "";

  private HeadlessBrowser(Path program) throws IOException, InterruptedException {
    profile = Files.createTempDirectory("mech-film");
    process =
        new ProcessBuilder(
                program.toString(),
                "--headless",
                "--no-sandbox",
                "--no-first-run",
                "--disable-quic",
                "--disable-background-networking",
                "--disable-component-update",
                "--disable-sync",
                "--enable-unsafe-swiftshader",
                "--remote-debugging-port=0",
                "--user-data-dir=" + profile,
                "about:blank")
            .redirectErrorStream(true)
            .redirectOutput(ProcessBuilder.Redirect.DISCARD)
            .start();
    try {
      List<String> port = port(profile.resolve("DevToolsActivePort"));
      socket =
          HttpClient.newHttpClient()
              .newWebSocketBuilder()
              .buildAsync(URI.create("ws://127.0.0.1:" + port.get(0) + port.get(1)), new Listener())
              .get(PATIENCE_SECONDS, TimeUnit.SECONDS);
      String target =
          call("Target.createTarget", Map.of("url", "about:blank")).get("targetId").getAsString();
      session =
          call("Target.attachToTarget", Map.of("targetId", target, "flatten", true))
              .get("sessionId")
              .getAsString();
    } catch (ExecutionException | TimeoutException e) {
      close();
      throw new IOException("Chromium does not open its DevTools", e);
    } catch (IOException | InterruptedException e) {
      close();
      throw e;
    }
  }

  /** Returns the first program of these names on the path of this process. */
  static Optional<Path> program(List<String> names) {
    String path = Optional.ofNullable(System.getenv("PATH")).orElse("");
    return Stream.of(path.split(File.pathSeparator, -1))
        .flatMap(folder -> names.stream().map(name -> Path.of(folder, name)))
        .filter(Files::isExecutable)
        .findFirst();
  }

  /** Returns where the browser is; empty if this machine has none. */
  static Optional<Path> installed() {
    return program(NAMES);
  }

  /**
   * Starts the browser.
   *
   * @param program the browser's
   * @throws IOException if it does not start
   */
  static HeadlessBrowser start(Path program) throws IOException, InterruptedException {
    return new HeadlessBrowser(program);
  }

  private static List<String> port(Path file) throws IOException, InterruptedException {
    long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(PATIENCE_SECONDS);
    while (System.nanoTime() < end) {
      List<String> lines = Files.exists(file) ? Files.readAllLines(file) : List.of();
      if (lines.size() >= 2) {
        return lines;
      }
      Thread.sleep(20);
    }
    throw new IOException("Chromium does not open its DevTools");
  }

  private final class Listener implements WebSocket.Listener {
    private final StringBuilder message = new StringBuilder();

    @Override
    public CompletionStage<?> onText(WebSocket from, CharSequence data, boolean last) {
      message.append(data);
      if (last) {
        JsonObject heard = JsonParser.parseString(message.toString()).getAsJsonObject();
        message.setLength(0);
        if (heard.has("id")) {
          CompletableFuture<JsonObject> waiting = answers.remove(heard.get("id").getAsInt());
          if (waiting != null) {
            waiting.complete(heard.has("result") ? heard.getAsJsonObject("result") : heard);
          }
        }
      }
      from.request(1);
      return CompletableFuture.completedStage(null);
    }
  }

  private JsonObject call(String method, Map<String, Object> parameters)
      throws IOException, InterruptedException {
    JsonObject order = new JsonObject();
    int id = ids.incrementAndGet();
    order.addProperty("id", id);
    order.addProperty("method", method);
    order.add("params", new Gson().toJsonTree(parameters));
    if (!session.isEmpty()) {
      order.addProperty("sessionId", session);
    }
    CompletableFuture<JsonObject> answer = new CompletableFuture<>();
    answers.put(id, answer);
    try {
      socket.sendText(order.toString(), true).get(PATIENCE_SECONDS, TimeUnit.SECONDS);
      return answer.get(PATIENCE_SECONDS, TimeUnit.SECONDS);
    } catch (ExecutionException | TimeoutException e) {
      throw new IOException("Chromium does not answer " + method, e);
    }
  }

  /** Sets the window's size, px, and the colours of day or night. */
  void look(int width, int height, boolean dark) throws IOException, InterruptedException {
    call(
        "Emulation.setDeviceMetricsOverride",
        Map.of("width", width, "height", height, "deviceScaleFactor", 1, "mobile", false));
    Map<String, String> scheme =
        Map.of("name", "prefers-color-scheme", "value", dark ? "dark" : "light");
    Map<String, String> still = Map.of("name", "prefers-reduced-motion", "value", "reduce");
    call("Emulation.setEmulatedMedia", Map.of("features", List.of(scheme, still)));
  }

  /**
   * Opens a page and waits until it can be used.
   *
   * @param ready expression that is true then
   */
  void open(URI page, String ready) throws IOException, InterruptedException {
    call("Page.navigate", Map.of("url", page.toString()));
    long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(PATIENCE_SECONDS);
    JsonElement is = JsonNull.INSTANCE;
    while (!is.isJsonPrimitive() || !is.getAsBoolean()) {
      if (System.nanoTime() > end) {
        throw new IOException("the page does not open in Chromium");
      }
      Thread.sleep(50);
      is = evaluate("document.readyState === 'complete' && " + ready);
    }
  }

  /** Returns the value of an expression in the page; null of one that fails. */
  JsonElement evaluate(String expression) throws IOException, InterruptedException {
    JsonObject answer =
        call(
            "Runtime.evaluate",
            Map.of("expression", expression, "returnByValue", true, "awaitPromise", true));
    JsonElement value =
        answer.has("result") ? answer.getAsJsonObject("result").get("value") : JsonNull.INSTANCE;
    return value == null ? JsonNull.INSTANCE : value;
  }

  /** Ends the browser and removes what it has stored. */
  @Override
  public void close() {
    process.descendants().forEach(ProcessHandle::destroy);
    process.destroy();
    try {
      if (!process.waitFor(PATIENCE_SECONDS, TimeUnit.SECONDS)) {
        process.destroyForcibly();
      }
      try (Stream<Path> files = Files.walk(profile)) {
        for (Path file : files.sorted(Comparator.reverseOrder()).toList()) {
          Files.deleteIfExists(file);
        }
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    } catch (IOException e) {
      // what is left lies in the system's folder for temporary files
      profile.toFile().deleteOnExit();
    }
  }
}
