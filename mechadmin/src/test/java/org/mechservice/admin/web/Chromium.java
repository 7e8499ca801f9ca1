package org.mechservice.admin.web;

import com.google.gson.JsonArray;
import com.google.gson.JsonElement;
import com.google.gson.JsonNull;
import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import java.io.IOException;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse.BodyHandlers;
import java.net.http.WebSocket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Base64;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;

/** A real browser without a window, steered by its own debugging protocol. Needs Chromium. */
final class Chromium implements AutoCloseable {
  private static final int PATIENCE_SECONDS = 120;
  private static final long CHECK_MILLIS = 50;

  private final Path profile;
  private final Process process;
  private final WebSocket socket;
  private final Map<Integer, CompletableFuture<JsonObject>> calls = new ConcurrentHashMap<>();
  private final AtomicInteger lastCall = new AtomicInteger();
  private final List<String> complaints = new CopyOnWriteArrayList<>();

  private Chromium(Path profile, Process process) throws Exception {
    this.profile = profile;
    this.process = process;
    HttpClient http = HttpClient.newHttpClient();
    socket =
        http.newWebSocketBuilder()
            .buildAsync(URI.create(pageOf(http)), new Listener())
            .get(PATIENCE_SECONDS, TimeUnit.SECONDS);
    call("Page.enable", "{}");
    call("Runtime.enable", "{}");
    call("Log.enable", "{}");
  }

  static Chromium start() throws Exception {
    Path profile = Files.createTempDirectory("chromium");
    Process process =
        new ProcessBuilder(
                System.getProperty("chromium", "chromium"),
                "--headless=new",
                "--no-sandbox",
                "--disable-gpu",
                "--hide-scrollbars",
                "--force-color-profile=srgb",
                "--remote-debugging-port=0",
                "--user-data-dir=" + profile,
                "about:blank")
            .redirectErrorStream(true)
            .redirectOutput(profile.resolve("log").toFile())
            .start();
    return new Chromium(profile, process);
  }

  private String pageOf(HttpClient http) throws Exception {
    Path port = profile.resolve("DevToolsActivePort");
    for (int i = 0; i < PATIENCE_SECONDS * 1000 / CHECK_MILLIS; i++) {
      if (Files.exists(port) && !Files.readAllLines(port).isEmpty()) {
        URI list = URI.create("http://127.0.0.1:" + Files.readAllLines(port).get(0) + "/json/list");
        String answer =
            http.send(HttpRequest.newBuilder(list).build(), BodyHandlers.ofString()).body();
        for (JsonElement target : JsonParser.parseString(answer).getAsJsonArray()) {
          if (target.getAsJsonObject().get("type").getAsString().equals("page")) {
            return target.getAsJsonObject().get("webSocketDebuggerUrl").getAsString();
          }
        }
      }
      Thread.sleep(CHECK_MILLIS);
    }
    throw new IOException("Chromium does not start: " + Files.readString(profile.resolve("log")));
  }

  private final class Listener implements WebSocket.Listener {
    private final StringBuilder text = new StringBuilder();

    @Override
    public CompletionStage<?> onText(WebSocket from, CharSequence data, boolean last) {
      text.append(data);
      if (last) {
        JsonObject message = JsonParser.parseString(text.toString()).getAsJsonObject();
        text.setLength(0);
        received(message);
      }
      from.request(1);
      return CompletableFuture.completedStage(null);
    }
  }

  private void received(JsonObject message) {
    if (message.has("id")) {
      CompletableFuture<JsonObject> call = calls.remove(message.get("id").getAsInt());
      if (call != null) {
        call.complete(message);
      }
      return;
    }
    String method = message.get("method").getAsString();
    boolean complaint =
        method.equals("Runtime.exceptionThrown")
            || (method.equals("Log.entryAdded")
                && message.toString().contains("\"level\":\"error\""));
    if (complaint) {
      complaints.add(message.toString());
    }
  }

  JsonObject call(String method, String parameters) throws Exception {
    int id = lastCall.incrementAndGet();
    CompletableFuture<JsonObject> answer = new CompletableFuture<>();
    calls.put(id, answer);
    JsonObject message = new JsonObject();
    message.addProperty("id", id);
    message.addProperty("method", method);
    message.add("params", JsonParser.parseString(parameters));
    var unused = socket.sendText(message.toString(), true).get(PATIENCE_SECONDS, TimeUnit.SECONDS);
    JsonObject result = answer.get(PATIENCE_SECONDS, TimeUnit.SECONDS);
    if (result.has("error")) {
      throw new IOException(method + ": " + result);
    }
    return result.getAsJsonObject("result");
  }

  /** Opens a page; one of the same address but another fragment is loaded anew. */
  void open(String url) throws Exception {
    call("Page.navigate", object("url", "about:blank"));
    call("Page.navigate", object("url", url));
  }

  private static String object(String name, String value) {
    JsonObject json = new JsonObject();
    json.addProperty(name, value);
    return json.toString();
  }

  /** Returns the value of a JavaScript expression. */
  JsonElement evaluate(String expression) throws Exception {
    JsonObject parameters = new JsonObject();
    parameters.addProperty("expression", expression);
    parameters.addProperty("returnByValue", true);
    parameters.addProperty("awaitPromise", true);
    JsonObject result = call("Runtime.evaluate", parameters.toString());
    if (result.has("exceptionDetails")) {
      throw new IOException(expression + ": " + result);
    }
    JsonElement value = result.getAsJsonObject("result").get("value");
    return value == null ? JsonNull.INSTANCE : value;
  }

  /** Waits until a JavaScript expression is true. */
  void await(String expression) throws Exception {
    for (int i = 0; i < PATIENCE_SECONDS * 1000 / CHECK_MILLIS; i++) {
      try {
        JsonElement value = evaluate(expression);
        if (value.isJsonPrimitive() && value.getAsBoolean()) {
          return;
        }
      } catch (IOException e) {
        // The page is about to become another one.
      }
      Thread.sleep(CHECK_MILLIS);
    }
    throw new AssertionError(
        expression + " did not become true on: " + evaluate("document.body.innerText"));
  }

  /** Waits until the page shows a text. */
  void awaitText(String text) throws Exception {
    await("document.body.innerText.includes(" + quoted(text) + ")");
  }

  static String quoted(String text) {
    JsonArray array = new JsonArray();
    array.add(text);
    String json = array.toString();
    return json.substring(1, json.length() - 1);
  }

  /** Clicks the first element that a selector finds and whose text begins with a text. */
  void click(String selector, String text) throws Exception {
    String found =
        "[...document.querySelectorAll(%s)].find(e => e.textContent.startsWith(%s))"
            .formatted(quoted(selector), quoted(text));
    await(found + " !== undefined");
    evaluate(found + ".click()");
  }

  /** Presses a key, such as {@code Tab} or {@code Enter}. */
  void press(String key) throws Exception {
    String text = key.equals("Enter") ? ",\"text\":\"\\r\"" : "";
    int code = key.equals("Enter") ? 13 : key.equals("Escape") ? 27 : 9;
    for (String type : List.of("keyDown", "keyUp")) {
      call(
          "Input.dispatchKeyEvent",
          "{\"type\":\"%s\",\"key\":\"%s\",\"code\":\"%s\",\"windowsVirtualKeyCode\":%d%s}"
              .formatted(type, key, key, code, type.equals("keyDown") ? text : ""));
    }
  }

  /** Makes the window so large, px, with the colours of the night or of the day. */
  void look(int width, int height, boolean dark) throws Exception {
    call(
        "Emulation.setDeviceMetricsOverride",
        "{\"width\":%d,\"height\":%d,\"deviceScaleFactor\":1,\"mobile\":%b}"
            .formatted(width, height, width < 700));
    call(
        "Emulation.setEmulatedMedia",
        "{\"features\":[{\"name\":\"prefers-color-scheme\",\"value\":\"%s\"}]}"
            .formatted(dark ? "dark" : "light"));
  }

  /** Writes what is seen to a PNG file. */
  void screenshot(Path file) throws Exception {
    JsonObject shot = call("Page.captureScreenshot", "{\"format\":\"png\"}");
    Files.createDirectories(file.toAbsolutePath().getParent());
    Files.write(file, Base64.getDecoder().decode(shot.get("data").getAsString()));
  }

  /** Returns what the browser has complained about: errors of scripts, blocked loads. */
  List<String> complaints() {
    return new ArrayList<>(complaints);
  }

  @Override
  public void close() throws IOException {
    socket.abort();
    process.descendants().forEach(ProcessHandle::destroyForcibly);
    process.destroyForcibly();
    var unused = process.onExit().join();
    for (int i = 0; i < 20 && Files.exists(profile); i++) {
      try (var files = Files.walk(profile)) {
        files.sorted(Comparator.reverseOrder()).forEach(file -> file.toFile().delete());
      }
    }
  }
}
