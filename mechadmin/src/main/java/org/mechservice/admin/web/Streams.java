package org.mechservice.admin.web;

import com.google.gson.JsonArray;
import com.google.gson.JsonObject;
import java.io.IOException;
import java.time.Duration;
import java.util.List;
import org.mechservice.admin.AdminConsole;
import org.mechservice.admin.AdminFailure;
import org.mechservice.admin.AdminTarget;
import org.mechservice.admin.DetailJson;
import org.mechservice.admin.live.LiveView;
import org.mechservice.admin.live.LoadSample;
import org.mechservice.orb.http.EventStream;

/** Streams of updates to pages. Each stream ends when its page or the console is closed. */
final class Streams {
  /** Shortest interval between two updates of a page, ms. */
  private static final long PAUSE_MILLIS = 250;

  private static final Duration PING = Duration.ofSeconds(5);
  private static final long DETAIL_PAUSE_MILLIS = 1000;

  /** Answers about an ended simulation in which its check report is awaited: ten minutes. */
  private static final int REPORT_AWAITED = 120;

  /** A server works on the answer for that long at most, as a share of the time. */
  private static final int LEISURE = 10;

  private final AdminConsole console;
  private final LiveView view;
  private final Overview overview;

  Streams(AdminConsole console, LiveView view) {
    this.console = console;
    this.view = view;
    overview = new Overview(view);
  }

  /** Sends the whole state once and then the changes. */
  void overview(EventStream stream) throws IOException, InterruptedException {
    long version = 0;
    long event = 0;
    while (!view.isClosed()) {
      JsonObject update = overview.after(version);
      JsonArray events = overview.eventsAfter(event);
      update.add("events", events);
      stream.send("update", update);
      version = update.get("version").getAsLong();
      if (!events.isEmpty()) {
        event = events.get(events.size() - 1).getAsJsonObject().get("seen").getAsLong();
      }
      Thread.sleep(PAUSE_MILLIS);
      while (view.awaitAfter(version, PING) <= version && !view.isClosed()) {
        stream.ping();
      }
    }
  }

  /** Sends the load history of a host and then each new sample. */
  void host(EventStream stream, AdminTarget host) throws IOException, InterruptedException {
    long last = 0;
    long version = 0;
    while (!view.isClosed()) {
      version = view.version();
      long known = last;
      List<LoadSample> samples =
          view.loads(host).stream().filter(sample -> sample.at() > known).toList();
      if (!samples.isEmpty()) {
        stream.send("loads", loads(samples));
        last = samples.get(samples.size() - 1).at();
      } else {
        stream.ping();
      }
      Thread.sleep(DETAIL_PAUSE_MILLIS);
      view.awaitAfter(version, PING);
    }
  }

  private static JsonArray loads(List<LoadSample> samples) {
    JsonArray all = new JsonArray();
    for (LoadSample sample : samples) {
      JsonObject json = new JsonObject();
      json.addProperty("at", sample.at());
      json.addProperty("cpuLoad", sample.cpuLoad());
      json.addProperty("memoryUsed", sample.memoryUsed());
      json.addProperty("running", sample.running());
      json.addProperty("queued", sample.queued());
      all.add(json);
    }
    return all;
  }

  /**
   * Sends all details of a simulation and then its changes, until it has ended. The check report
   * comes with a later answer if the host is still making it.
   */
  void simulation(EventStream stream, String server, String simId)
      throws IOException, InterruptedException {
    boolean told = false;
    boolean reported = false;
    int ended = 0;
    while (!view.isClosed()) {
      if (ended > 0) {
        stream.ping();
        view.awaitAfter(Long.MAX_VALUE - 1, PING);
        if (reported || ended > REPORT_AWAITED) {
          continue;
        }
      }
      long began = System.nanoTime();
      try {
        JsonObject detail = DetailJson.of(server, console.show(server, simId));
        if (!detail.get("endedAt").getAsString().equals("-")) {
          ended++;
        }
        boolean made = !detail.get("checkReport").isJsonNull();
        if (told) {
          detail.remove("modelText");
        }
        if (told && (reported || !made)) {
          detail.remove("checkReport");
        }
        reported |= made;
        stream.send("detail", detail);
        told = true;
      } catch (AdminFailure e) {
        JsonObject failure = new JsonObject();
        failure.addProperty("error", e.text());
        stream.send("failure", failure);
      }
      long took = (System.nanoTime() - began) / 1_000_000;
      Thread.sleep(Math.max(DETAIL_PAUSE_MILLIS, LEISURE * took));
    }
  }
}
