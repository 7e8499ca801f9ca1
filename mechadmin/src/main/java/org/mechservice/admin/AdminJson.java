package org.mechservice.admin;

import com.google.gson.Gson;
import com.google.gson.GsonBuilder;
import com.google.gson.JsonArray;
import com.google.gson.JsonElement;
import com.google.gson.JsonNull;
import com.google.gson.JsonObject;
import com.google.gson.JsonPrimitive;
import java.util.Arrays;
import java.util.List;
import java.util.function.Function;
import org.mechservice.idl.HostStatus;
import org.mechservice.idl.Limit;
import org.mechservice.idl.LogLine;
import org.mechservice.idl.NameValue;
import org.mechservice.idl.Progress;
import org.mechservice.idl.ServerStatus;
import org.mechservice.idl.ServiceEvent;
import org.mechservice.idl.SessionSummary;
import org.mechservice.idl.Severity;
import org.mechservice.idl.SimSummary;

/**
 * The console's data as JSON, under the same names for scripts and for the page. Times are ISO 8601
 * in UTC, sizes in bytes; a number that is not finite is null.
 */
public final class AdminJson {
  private static final Gson PRETTY =
      new GsonBuilder().setPrettyPrinting().serializeNulls().disableHtmlEscaping().create();

  private AdminJson() {}

  /** Returns JSON as text for people and scripts. */
  public static String text(JsonElement json) {
    return PRETTY.toJson(json);
  }

  /** Returns a list. */
  public static <T> JsonArray list(List<T> values, Function<T, ? extends JsonElement> json) {
    JsonArray array = new JsonArray();
    values.forEach(value -> array.add(json.apply(value)));
    return array;
  }

  /** Returns all servers and hosts, and the simulations that have not ended. */
  public static JsonObject status(List<ServerReading> readings) {
    JsonArray servers = new JsonArray();
    for (ServerReading reading : readings) {
      JsonObject server = server(reading);
      if (reading instanceof ServerReading.Answering answering) {
        server.add("hosts", list(answering.hosts(), host -> host(answering.address(), host)));
        List<KnownSimulation> all = KnownSimulation.all(List.of(reading));
        server.add(
            "simulations",
            list(
                all.stream().filter(KnownSimulation::isUnfinished).toList(),
                AdminJson::simulation));
      }
      servers.add(server);
    }
    return named("servers", servers);
  }

  /** Returns the servers. */
  public static JsonObject servers(List<ServerReading> readings) {
    return named("servers", list(readings, AdminJson::server));
  }

  /** Returns the hosts of all servers that answered. */
  public static JsonObject hosts(List<ServerReading> readings) {
    JsonArray hosts = new JsonArray();
    for (ServerReading reading : readings) {
      if (reading instanceof ServerReading.Answering answering) {
        answering.hosts().forEach(host -> hosts.add(host(answering.address(), host)));
      }
    }
    return named("hosts", hosts);
  }

  /** Returns an object with one member. */
  public static JsonObject named(String name, JsonElement member) {
    JsonObject object = new JsonObject();
    object.add(name, member);
    return object;
  }

  /** Returns a server, without its hosts and simulations. */
  public static JsonObject server(ServerReading reading) {
    JsonObject server = new JsonObject();
    server.addProperty("address", reading.address());
    if (reading instanceof ServerReading.Answering answering) {
      describe(server, answering.status());
    } else if (reading instanceof ServerReading.Silent silent) {
      server.addProperty("answers", false);
      server.addProperty("problem", silent.why());
    } else {
      server.addProperty("answers", false);
      server.addProperty("connecting", true);
    }
    return server;
  }

  private static void describe(JsonObject server, ServerStatus status) {
    server.addProperty("answers", true);
    server.addProperty("name", status.info.serverName);
    server.addProperty("version", status.info.serverVersion);
    server.addProperty("apiVersion", status.info.apiVersion);
    server.addProperty("startedAt", QuantityText.instant(status.info.startedAt));
    server.addProperty("draining", status.draining);
    server.addProperty("hostCount", status.hosts);
    server.addProperty("sessions", status.sessions);
    server.addProperty("running", status.running);
    server.addProperty("queued", status.queued);
    server.add("statistics", statistics(status.statistics));
  }

  private static JsonObject statistics(NameValue[] values) {
    JsonObject statistics = new JsonObject();
    for (NameValue value : values) {
      statistics.addProperty(value.key, value.text);
    }
    return statistics;
  }

  /** Returns a host of a server. */
  public static JsonObject host(String server, HostStatus status) {
    JsonObject host = new JsonObject();
    host.addProperty("server", server);
    host.addProperty("name", status.info.name);
    host.addProperty("address", status.info.address);
    host.addProperty("version", status.info.version);
    host.addProperty("state", HostState.of(status).label());
    host.addProperty("reachable", status.reachable);
    host.addProperty("problem", status.text);
    host.addProperty("startedAt", QuantityText.instant(status.info.startedAt));
    host.addProperty("lastSeen", QuantityText.instant(status.lastSeen));
    host.addProperty("draining", status.load.draining);
    host.addProperty("cores", status.info.cores);
    host.addProperty("capacity", status.info.capacity);
    host.addProperty("sessions", status.load.sessions);
    host.addProperty("running", status.load.running);
    host.addProperty("queued", status.load.queued);
    host.add("cpuLoad", status.load.cpuLoad < 0 ? JsonNull.INSTANCE : number(status.load.cpuLoad));
    host.addProperty("memoryUsed", status.load.memoryUsed);
    host.addProperty("memoryBytes", status.info.memoryBytes);
    host.add("statistics", statistics(status.load.statistics));
    return host;
  }

  /** Returns a simulation. */
  public static JsonObject simulation(KnownSimulation known) {
    SimSummary summary = known.summary();
    JsonObject simulation = new JsonObject();
    simulation.addProperty("id", summary.simId);
    simulation.addProperty("server", known.server());
    simulation.addProperty("session", summary.sessionId);
    simulation.addProperty("host", summary.hostName);
    simulation.addProperty("model", summary.modelName);
    simulation.addProperty("owner", summary.owner);
    simulation.addProperty("state", known.state());
    simulation.addProperty("message", summary.text);
    simulation.add("progress", number(known.progress()));
    addProgress(simulation, summary.info);
    simulation.addProperty("createdAt", QuantityText.instant(summary.createdAt));
    simulation.addProperty("startedAt", QuantityText.instant(summary.startedAt));
    simulation.addProperty("endedAt", QuantityText.instant(summary.endedAt));
    return simulation;
  }

  /** Returns a session. */
  public static JsonObject session(SessionSummary session) {
    JsonObject json = new JsonObject();
    json.addProperty("id", session.sessionId);
    json.addProperty("owner", session.owner);
    json.addProperty("host", session.hostName);
    json.addProperty("openedAt", QuantityText.instant(session.openedAt));
    json.addProperty("leaseEndsAt", QuantityText.instant(session.leaseEndsAt));
    json.addProperty("active", session.active);
    json.addProperty("runs", session.runs);
    json.addProperty("modelBytes", session.modelBytes);
    return json;
  }

  private static void addProgress(JsonObject simulation, Progress info) {
    simulation.addProperty("queuePosition", info.queuePosition);
    simulation.add("time", number(info.simTime));
    simulation.add("startTime", number(info.startTime));
    simulation.add("endTime", number(info.endTime));
    simulation.addProperty("steps", info.stepsDone);
    simulation.add("stepSize", number(info.stepSize));
    simulation.addProperty("order", info.stepOrder);
    simulation.add("realTimeFactor", number(info.realTimeFactor));
    simulation.addProperty("rows", info.rowsReady);
  }

  /** Returns a number, or null if it is not finite. */
  static JsonElement number(double value) {
    return Double.isFinite(value) ? new JsonPrimitive(value) : JsonNull.INSTANCE;
  }

  /** Returns an event of a server. */
  public static JsonObject event(String server, ServiceEvent event) {
    JsonObject json = new JsonObject();
    json.addProperty("server", server);
    json.addProperty("number", event.seqNo);
    json.addProperty("at", QuantityText.instant(event.happenedAt));
    json.addProperty("kind", event.kind);
    json.addProperty("level", level(event.level));
    json.addProperty("code", event.code);
    json.addProperty("host", event.hostName);
    json.addProperty("simulation", event.simId);
    json.addProperty("owner", event.owner);
    json.addProperty("text", event.text);
    return json;
  }

  /** Returns the word for a severity. */
  static String level(Severity severity) {
    return switch (severity.value()) {
      case Severity._SEV_ERROR -> "error";
      case Severity._SEV_WARNING -> "warning";
      default -> "info";
    };
  }

  /** Returns a log line. */
  public static JsonObject logLine(LogLine line) {
    JsonObject json = new JsonObject();
    json.addProperty("at", QuantityText.instant(line.writtenAt));
    json.addProperty("level", line.level);
    json.addProperty("source", line.source);
    json.addProperty("text", line.text);
    return json;
  }

  /** Returns the limits of a server or host. */
  public static JsonObject limits(AdminTarget place, List<Limit> limits) {
    JsonObject json = new JsonObject();
    json.addProperty("server", place.server());
    json.addProperty("host", place.host());
    json.add("limits", list(limits, AdminJson::limit));
    return json;
  }

  private static JsonObject limit(Limit limit) {
    JsonObject json = new JsonObject();
    json.addProperty("name", limit.name);
    json.addProperty("value", limit.value);
    json.addProperty("unit", limit.unit);
    json.addProperty("text", limit.text);
    return json;
  }

  /** Returns an array of texts. */
  static JsonArray texts(String... texts) {
    return list(Arrays.asList(texts), JsonPrimitive::new);
  }
}
