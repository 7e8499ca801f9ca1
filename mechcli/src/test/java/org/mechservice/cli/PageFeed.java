package org.mechservice.cli;

import com.google.gson.JsonArray;
import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse.BodyHandlers;
import java.nio.charset.StandardCharsets;
import java.time.Instant;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;

/** What the admin page knows, by the updates a browser gets, and how soon it knew. */
final class PageFeed implements AutoCloseable {
  private final InputStream stream;
  private final Thread thread = new Thread(this::read, "page-feed");
  private final Map<String, JsonObject> hosts = new LinkedHashMap<>();
  private final Map<String, JsonObject> simulations = new LinkedHashMap<>();
  private final Map<String, List<Long>> latencies = new TreeMap<>();
  private final Instant opened = Instant.now();

  PageFeed(int port, String token) throws IOException, InterruptedException {
    stream =
        HttpClient.newHttpClient()
            .send(
                HttpRequest.newBuilder(URI.create("http://127.0.0.1:" + port + "/api/updates"))
                    .header("Authorization", "Bearer " + token)
                    .build(),
                BodyHandlers.ofInputStream())
            .body();
    thread.setDaemon(true);
    thread.start();
  }

  private void read() {
    try (BufferedReader in =
        new BufferedReader(new InputStreamReader(stream, StandardCharsets.UTF_8))) {
      for (String line = in.readLine(); line != null; line = in.readLine()) {
        if (line.startsWith("data: ")) {
          apply(JsonParser.parseString(line.substring("data: ".length())).getAsJsonObject());
        }
      }
    } catch (IOException e) {
      // The page was closed.
    }
  }

  private synchronized void apply(JsonObject update) {
    apply(hosts, update.getAsJsonObject("hosts"), "key");
    apply(simulations, update.getAsJsonObject("simulations"), "id");
    Instant now = Instant.now();
    for (JsonElement element : update.getAsJsonArray("events")) {
      JsonObject event = element.getAsJsonObject();
      Instant at = Instant.parse(event.get("at").getAsString());
      if (at.isAfter(opened)) {
        latencies
            .computeIfAbsent(event.get("kind").getAsString(), kind -> new ArrayList<>())
            .add(now.toEpochMilli() - at.toEpochMilli());
      }
    }
  }

  private static void apply(Map<String, JsonObject> rows, JsonObject update, String key) {
    update.getAsJsonArray("gone").forEach(gone -> rows.remove(gone.getAsString()));
    JsonArray changed = update.getAsJsonArray("changed");
    changed.forEach(
        row -> rows.put(row.getAsJsonObject().get(key).getAsString(), row.getAsJsonObject()));
  }

  synchronized List<JsonObject> simulations() {
    return List.copyOf(simulations.values());
  }

  /** Returns a host. */
  synchronized JsonObject host(String name) {
    return hosts.values().stream()
        .filter(host -> host.get("name").getAsString().equals(name))
        .findFirst()
        .orElseThrow();
  }

  /** Returns how long after each event, by its kind, the page heard of it, ms, sorted. */
  synchronized Map<String, List<Long>> latencies() {
    Map<String, List<Long>> sorted = new TreeMap<>();
    latencies.forEach((kind, millis) -> sorted.put(kind, millis.stream().sorted().toList()));
    return sorted;
  }

  @Override
  public void close() throws IOException {
    stream.close();
  }
}
