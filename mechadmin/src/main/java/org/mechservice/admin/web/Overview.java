package org.mechservice.admin.web;

import com.google.gson.JsonArray;
import com.google.gson.JsonObject;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.mechservice.admin.AdminJson;
import org.mechservice.admin.KnownSimulation;
import org.mechservice.admin.ServerReading;
import org.mechservice.admin.live.LiveView;

/**
 * Servers, hosts, simulations and events as pages receive them: everything once, and then only
 * changes. The work is done once for all pages. Thread-safe.
 */
final class Overview {
  private final LiveView view;
  private final RowTable servers = new RowTable();
  private final RowTable hosts = new RowTable();
  private final RowTable simulations = new RowTable();
  private long version;

  Overview(LiveView view) {
    this.view = view;
  }

  /**
   * Returns the changes since the page's last update.
   *
   * @param known the version it knows; 0: nothing
   */
  synchronized JsonObject after(long known) {
    refresh();
    JsonObject update = new JsonObject();
    update.addProperty("version", version);
    update.add("servers", servers.after(known));
    update.add("hosts", hosts.after(known));
    update.add("simulations", simulations.after(known));
    return update;
  }

  /**
   * Returns the events a page does not know yet.
   *
   * @param known number of the last event it knows; 0: none
   */
  JsonArray eventsAfter(long known) {
    JsonArray events = new JsonArray();
    view.events().stream()
        .filter(seen -> seen.number() > known)
        .forEach(
            seen -> {
              JsonObject event = AdminJson.event(seen.server(), seen.event());
              event.addProperty("seen", seen.number());
              events.add(event);
            });
    return events;
  }

  private void refresh() {
    long heard = view.version();
    if (heard == version) {
      return;
    }
    List<ServerReading> readings = view.readings();
    Map<String, JsonObject> serverRows = new LinkedHashMap<>();
    Map<String, JsonObject> hostRows = new LinkedHashMap<>();
    Map<String, JsonObject> simulationRows = new LinkedHashMap<>();
    for (ServerReading reading : readings) {
      serverRows.put(reading.address(), server(reading));
      if (reading instanceof ServerReading.Answering answering) {
        answering
            .hosts()
            .forEach(
                host -> {
                  JsonObject row = AdminJson.host(reading.address(), host);
                  row.addProperty("key", reading.address() + " " + host.info.name);
                  hostRows.put(row.get("key").getAsString(), row);
                });
      }
    }
    for (KnownSimulation known : KnownSimulation.all(readings)) {
      simulationRows.put(known.summary().simId, AdminJson.simulation(known));
    }
    servers.replace(serverRows, heard);
    hosts.replace(hostRows, heard);
    simulations.replace(simulationRows, heard);
    version = heard;
  }

  /** What grows all the time by itself would make a server's row new in every update. */
  private static JsonObject server(ServerReading reading) {
    JsonObject row = AdminJson.server(reading);
    if (row.remove("statistics") instanceof JsonObject all && all.has("certificateExpires")) {
      row.add("certificateExpires", all.get("certificateExpires"));
    }
    return row;
  }
}
