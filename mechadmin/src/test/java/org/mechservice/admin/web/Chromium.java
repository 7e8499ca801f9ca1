package org.mechservice.admin.web;

import com.google.gson.Gson;
import com.google.gson.JsonArray;
import com.google.gson.JsonElement;
import com.google.gson.JsonNull;
import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import java.io.File;
import java.io.IOException;
import java.io.InputStream;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.WebSocket;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Base64;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;

/**
 * The system's Chromium without a window, driven by its DevTools protocol; one page. The tests of
 * all pages share it.
 */
public final class Chromium implements AutoCloseable, WebSocket.Listener {
  /** So long that a browser which draws in software beside busy processes is waited for. */
  private static final long PATIENCE_SECONDS = 240;

  /** The numbers by which browsers know keys that type nothing. */
  private static final Map<String, Integer> NAMED_KEYS =
      Map.of("Tab", 9, "Enter", 13, "Escape", 27);

  private final Process process;
  private final HttpClient client = HttpClient.newHttpClient();
  private final AtomicInteger ids = new AtomicInteger();
  private final Map<Integer, CompletableFuture<JsonObject>> answers = new ConcurrentHashMap<>();
  private final List<JsonObject> events = new CopyOnWriteArrayList<>();
  private final StringBuilder message = new StringBuilder();
  private final WebSocket socket;
  private String session = "";

  private Chromium(String program, Path profile) throws Exception {
    process =
        new ProcessBuilder(
                program,
                "--headless",
                "--no-sandbox",
                "--disable-quic",
                "--no-first-run",
                "--disable-background-networking",
                "--disable-component-update",
                "--disable-sync",
                "--use-gl=angle",
                "--use-angle=swiftshader",
                "--enable-unsafe-swiftshader",
                // Without a graphics processor, texts and boxes are drawn faster as they are.
                "--disable-gpu-rasterization",
                "--window-size=1000,700",
                "--remote-debugging-port=0",
                "--user-data-dir=" + profile,
                "about:blank")
            .redirectErrorStream(true)
            .redirectOutput(ProcessBuilder.Redirect.DISCARD)
            .start();
    List<String> port = port(profile.resolve("DevToolsActivePort"));
    socket =
        client
            .newWebSocketBuilder()
            .buildAsync(URI.create("ws://127.0.0.1:" + port.get(0) + port.get(1)), this)
            .get(PATIENCE_SECONDS, TimeUnit.SECONDS);
    String target =
        call("Target.createTarget", Map.of("url", "about:blank")).get("targetId").getAsString();
    session =
        call("Target.attachToTarget", Map.of("targetId", target, "flatten", true))
            .get("sessionId")
            .getAsString();
    for (String domain : List.of("Page", "Runtime", "Network", "Log")) {
      call(domain + ".enable", Map.of());
    }
  }

  /** Starts the browser; empty if the system has none. */
  public static Optional<Chromium> start(Path profile) throws Exception {
    for (String folder : System.getenv("PATH").split(File.pathSeparator, -1)) {
      for (String name : List.of("chromium", "chromium-browser", "google-chrome")) {
        Path program = Path.of(folder, name);
        if (Files.isExecutable(program)) {
          return Optional.of(new Chromium(program.toString(), profile));
        }
      }
    }
    return Optional.empty();
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

  /** Calls a method of DevTools in the page and returns its answer. */
  public JsonObject call(String method, Map<String, Object> parameters) throws Exception {
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
    socket.sendText(order.toString(), true).get(PATIENCE_SECONDS, TimeUnit.SECONDS);
    return answer.get(PATIENCE_SECONDS, TimeUnit.SECONDS);
  }

  /** Opens a file with a player and forgets what was heard before. */
  public void open(Path file) throws Exception {
    open(file.toUri().toString(), "Boolean(globalThis.mechPlayer)");
  }

  /**
   * Opens a page and forgets what was heard before.
   *
   * @param ready expression that is true when the page can be used
   */
  public void open(String address, String ready) throws Exception {
    call("Page.navigate", Map.of("url", "about:blank"));
    events.clear();
    call("Page.navigate", Map.of("url", address));
    waitFor("document.readyState === 'complete' && " + ready);
  }

  /** Sets the window's size, px, and the colours of day or night. */
  public void look(int width, int height, boolean dark) throws Exception {
    call(
        "Emulation.setDeviceMetricsOverride",
        Map.of("width", width, "height", height, "deviceScaleFactor", 1, "mobile", width < 700));
    Map<String, String> scheme =
        Map.of("name", "prefers-color-scheme", "value", dark ? "dark" : "light");
    call("Emulation.setEmulatedMedia", Map.of("features", List.of(scheme)));
  }

  /** Returns what is seen, as a PNG file's bytes. */
  public byte[] screenshot() throws Exception {
    JsonObject shot = call("Page.captureScreenshot", Map.of("format", "png"));
    return Base64.getDecoder().decode(shot.get("data").getAsString());
  }

  /** Writes what is seen to a PNG file. */
  void screenshot(Path file) throws Exception {
    Files.createDirectories(file.toAbsolutePath().getParent());
    Files.write(file, screenshot());
  }

  /** Returns the serious and critical findings of axe-core on the page that is open. */
  public List<String> accessibilityFindings() throws Exception {
    String axe = "META-INF/resources/webjars/axe-core/4.6.3/axe.min.js";
    try (InputStream script =
        Objects.requireNonNull(Chromium.class.getClassLoader().getResourceAsStream(axe))) {
      evaluate(new String(script.readAllBytes(), StandardCharsets.UTF_8) + "; 0");
    }
    JsonArray found =
        evaluate(
                "axe.run().then(r => r.violations"
                    + ".filter(v => ['serious', 'critical'].includes(v.impact))"
                    + ".flatMap(v => v.nodes.slice(0, 5).map(n => v.id + ': ' + v.help + ': '"
                    + " + n.html.slice(0, 160) + ' ' + (n.any[0]?.message || ''))))")
            .getAsJsonArray();
    return found.asList().stream().map(JsonElement::getAsString).toList();
  }

  /** Waits until a JavaScript expression is true. */
  public void waitFor(String condition) throws Exception {
    long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(PATIENCE_SECONDS);
    while (!isTrue(condition)) {
      if (System.nanoTime() > end) {
        throw new AssertionError(
            "does not come true: "
                + condition
                + " "
                + evaluate("document.body.innerText")
                + problems());
      }
      Thread.sleep(20);
    }
  }

  /** A page that is about to become another one has no values. */
  private boolean isTrue(String condition) throws Exception {
    JsonObject answer = ask(condition);
    JsonElement value = answer.getAsJsonObject("result").get("value");
    return !answer.has("exceptionDetails") && value != null && value.getAsBoolean();
  }

  /** Waits until the page shows a text. */
  void awaitText(String text) throws Exception {
    waitFor("document.body.innerText.includes(" + quoted(text) + ")");
  }

  /** Returns a text as JavaScript has it. */
  static String quoted(String text) {
    return new Gson().toJson(text);
  }

  /** Clicks the first element that a selector finds and whose text begins with a text. */
  void click(String selector, String text) throws Exception {
    String found =
        "[...document.querySelectorAll(%s)].find(e => e.textContent.startsWith(%s))"
            .formatted(quoted(selector), quoted(text));
    waitFor(found + " !== undefined");
    evaluate(found + ".click()");
  }

  /** Returns the value of an expression in the page. */
  public JsonElement evaluate(String expression) throws Exception {
    JsonObject answer = ask(expression);
    if (answer.has("exceptionDetails")) {
      throw new AssertionError(answer.get("exceptionDetails").toString());
    }
    JsonElement value = answer.getAsJsonObject("result").get("value");
    return value == null ? JsonNull.INSTANCE : value;
  }

  private JsonObject ask(String expression) throws Exception {
    return call(
        "Runtime.evaluate",
        Map.of("expression", expression, "returnByValue", true, "awaitPromise", true));
  }

  /** Returns the text of an element. */
  public String text(String id) throws Exception {
    return evaluate("document.getElementById('" + id + "').textContent").getAsString();
  }

  /** Presses a key in the page. */
  public void press(String key) throws Exception {
    String typed = key.equals("Enter") ? "\r" : key.length() == 1 ? key : "";
    int code = NAMED_KEYS.getOrDefault(key, 0);
    for (String type : List.of("keyDown", "keyUp")) {
      Map<String, Object> event = new HashMap<>();
      event.putAll(Map.of("type", type, "key", key, "text", type.equals("keyDown") ? typed : ""));
      if (code != 0) {
        event.putAll(Map.of("code", key, "windowsVirtualKeyCode", code));
      }
      call("Input.dispatchKeyEvent", event);
    }
  }

  /** Returns errors of the page, and what it put on the console. */
  public List<String> problems() {
    return events.stream()
        .filter(
            event ->
                List.of("Runtime.exceptionThrown", "Runtime.consoleAPICalled", "Log.entryAdded")
                    .contains(event.get("method").getAsString()))
        .map(JsonObject::toString)
        .toList();
  }

  /** Returns the addresses that were asked for. */
  public List<String> requests() {
    return events.stream()
        .filter(event -> event.get("method").getAsString().equals("Network.requestWillBeSent"))
        .map(event -> event.getAsJsonObject("params").getAsJsonObject("request"))
        .map(request -> request.get("url").getAsString())
        .toList();
  }

  /** Returns the numbers of an array in the page. */
  public double[] numbers(String expression) throws Exception {
    JsonArray array = evaluate(expression).getAsJsonArray();
    double[] numbers = new double[array.size()];
    for (int i = 0; i < numbers.length; i++) {
      numbers[i] = array.get(i).getAsDouble();
    }
    return numbers;
  }

  @Override
  public CompletionStage<?> onText(WebSocket from, CharSequence data, boolean last) {
    message.append(data);
    if (last) {
      JsonObject heard = JsonParser.parseString(message.toString()).getAsJsonObject();
      message.setLength(0);
      if (heard.has("id")) {
        JsonObject result = heard.has("result") ? heard.getAsJsonObject("result") : heard;
        answers.remove(heard.get("id").getAsInt()).complete(result);
      } else {
        events.add(heard);
      }
    }
    from.request(1);
    return CompletableFuture.completedStage(null);
  }

  @Override
  public void close() {
    process.descendants().forEach(ProcessHandle::destroy);
    process.destroy();
    process.onExit().orTimeout(PATIENCE_SECONDS, TimeUnit.SECONDS).join();
  }
}
