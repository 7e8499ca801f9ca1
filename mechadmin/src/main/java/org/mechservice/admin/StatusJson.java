package org.mechservice.admin;

import com.google.gson.Gson;
import com.google.gson.GsonBuilder;
import com.google.gson.JsonArray;
import com.google.gson.JsonObject;
import java.time.Instant;
import java.util.List;
import org.mechservice.idl.HostStatus;
import org.mechservice.idl.NameValue;
import org.mechservice.idl.ServerStatus;
import org.mechservice.idl.SimState;
import org.mechservice.idl.SimSummary;

/** Writes servers, their hosts and their running simulations as one JSON object for scripts. */
public final class StatusJson {
  private static final Gson GSON =
      new GsonBuilder().setPrettyPrinting().disableHtmlEscaping().create();

  private static final String[] STATES = {
    "created", "queued", "running", "paused", "done", "failed", "cancelled"
  };

  private StatusJson() {}

  /** Returns the state's name in small letters. */
  static String stateName(SimState state) {
    return STATES[state.value()];
  }

  /** Returns {@code {"servers": [...]}}. Times are ISO 8601 in UTC, sizes in bytes. */
  public static String write(List<ServerReading> readings) {
    JsonArray servers = new JsonArray();
    for (ServerReading reading : readings) {
      JsonObject server = new JsonObject();
      server.addProperty("address", reading.address());
      if (reading instanceof ServerReading.Answering answering) {
        describe(server, answering);
      } else if (reading instanceof ServerReading.Silent silent) {
        server.addProperty("answers", false);
        server.addProperty("problem", silent.why());
      }
      servers.add(server);
    }
    JsonObject all = new JsonObject();
    all.add("servers", servers);
    return GSON.toJson(all);
  }

  private static void describe(JsonObject server, ServerReading.Answering reading) {
    ServerStatus status = reading.status();
    server.addProperty("answers", true);
    server.addProperty("name", status.info.serverName);
    server.addProperty("version", status.info.serverVersion);
    server.addProperty("apiVersion", status.info.apiVersion);
    server.addProperty("startedAt", time(status.info.startedAt));
    server.addProperty("draining", status.draining);
    server.addProperty("sessions", status.sessions);
    server.addProperty("running", status.running);
    server.addProperty("queued", status.queued);
    JsonObject statistics = new JsonObject();
    for (NameValue statistic : status.statistics) {
      statistics.addProperty(statistic.key, statistic.text);
    }
    server.add("statistics", statistics);
    JsonArray hosts = new JsonArray();
    reading.hosts().forEach(host -> hosts.add(host(host)));
    server.add("hosts", hosts);
    JsonArray simulations = new JsonArray();
    reading.simulations().forEach(simulation -> simulations.add(simulation(simulation)));
    server.add("simulations", simulations);
  }

  private static JsonObject host(HostStatus status) {
    JsonObject host = new JsonObject();
    host.addProperty("name", status.info.name);
    host.addProperty("address", status.info.address);
    host.addProperty("version", status.info.version);
    host.addProperty("reachable", status.reachable);
    host.addProperty("lastSeen", time(status.lastSeen));
    host.addProperty("draining", status.load.draining);
    host.addProperty("cores", status.info.cores);
    host.addProperty("capacity", status.info.capacity);
    host.addProperty("sessions", status.load.sessions);
    host.addProperty("running", status.load.running);
    host.addProperty("queued", status.load.queued);
    if (status.load.cpuLoad >= 0) {
      host.addProperty("cpuLoad", status.load.cpuLoad);
    }
    host.addProperty("memoryUsed", status.load.memoryUsed);
    host.addProperty("memoryBytes", status.info.memoryBytes);
    return host;
  }

  private static JsonObject simulation(SimSummary summary) {
    JsonObject simulation = new JsonObject();
    simulation.addProperty("id", summary.simId);
    simulation.addProperty("session", summary.sessionId);
    simulation.addProperty("host", summary.hostName);
    simulation.addProperty("model", summary.modelName);
    simulation.addProperty("owner", summary.owner);
    simulation.addProperty("state", stateName(summary.info.state));
    simulation.addProperty("queuePosition", summary.info.queuePosition);
    if (Double.isFinite(summary.info.simTime)) {
      simulation.addProperty("time", summary.info.simTime);
    }
    simulation.addProperty("endTime", summary.info.endTime);
    simulation.addProperty("steps", summary.info.stepsDone);
    simulation.addProperty("rows", summary.info.rowsReady);
    simulation.addProperty("createdAt", time(summary.createdAt));
    return simulation;
  }

  private static String time(long millis) {
    return Instant.ofEpochMilli(millis).toString();
  }
}
