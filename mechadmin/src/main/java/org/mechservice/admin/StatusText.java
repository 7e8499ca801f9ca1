package org.mechservice.admin;

import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Locale;
import org.mechservice.idl.HostLoad;
import org.mechservice.idl.HostStatus;
import org.mechservice.idl.Progress;
import org.mechservice.idl.ServerStatus;
import org.mechservice.idl.SimSummary;

/** Shows servers, their hosts and their running simulations as tables. */
public final class StatusText {
  private static final double MEBIBYTE = 1024.0 * 1024.0;

  private final Instant now;

  /**
   * @param now what ages are counted from
   */
  public StatusText(Instant now) {
    this.now = now;
  }

  /** Returns the tables, ending with a line feed; a table without rows is left out. */
  public String format(List<ServerReading> readings) {
    TextTable servers =
        new TextTable(
            "SERVER",
            "ADDRESS",
            "STATE",
            "UP",
            "HOSTS",
            "SESSIONS",
            "RUNNING",
            "QUEUED",
            "VERSION");
    TextTable hosts =
        new TextTable(
            "HOST", "SERVER", "ADDRESS", "STATE", "CORES", "RUNNING", "QUEUED", "CPU", "MEMORY");
    TextTable simulations =
        new TextTable("SIMULATION", "HOST", "MODEL", "OWNER", "STATE", "TIME", "STEPS", "AGE");
    for (ServerReading reading : readings) {
      if (reading instanceof ServerReading.Answering answering) {
        addServer(servers, answering);
        answering.hosts().forEach(host -> addHost(hosts, answering, host));
        answering.simulations().forEach(simulation -> addSimulation(simulations, simulation));
      } else if (reading instanceof ServerReading.Silent quiet) {
        servers.add("-", quiet.address(), "no answer");
      }
    }
    StringBuilder text = new StringBuilder().append(servers);
    append(text, hosts);
    append(text, simulations);
    return text.toString();
  }

  private static void append(StringBuilder text, TextTable table) {
    if (!table.isEmpty()) {
      text.append('\n').append(table);
    }
  }

  private void addServer(TextTable table, ServerReading.Answering reading) {
    ServerStatus status = reading.status();
    table.add(
        status.info.serverName,
        reading.address(),
        status.draining ? "draining" : "up",
        age(status.info.startedAt),
        Integer.toString(status.hosts),
        Integer.toString(status.sessions),
        Integer.toString(status.running),
        Integer.toString(status.queued),
        status.info.serverVersion);
  }

  private static void addHost(TextTable table, ServerReading.Answering server, HostStatus host) {
    HostLoad load = host.load;
    String state = load.draining ? "draining" : "up";
    table.add(
        host.info.name,
        server.status().info.serverName,
        host.info.address,
        host.reachable ? state : "no answer",
        Integer.toString(host.info.cores),
        load.running + " of " + host.info.capacity,
        Integer.toString(load.queued),
        load.cpuLoad < 0 ? "-" : format("%.0f %%", 100 * load.cpuLoad),
        format("%.0f MiB", load.memoryUsed / MEBIBYTE));
  }

  private void addSimulation(TextTable table, SimSummary simulation) {
    Progress info = simulation.info;
    String time =
        Double.isFinite(info.simTime)
            ? format("%.4g of %.4g s", info.simTime, info.endTime)
            : format("- of %.4g s", info.endTime);
    table.add(
        simulation.simId,
        simulation.hostName,
        simulation.modelName,
        simulation.owner,
        StatusJson.stateName(info.state),
        time,
        Long.toString(info.stepsDone),
        age(simulation.createdAt));
  }

  private static String format(String pattern, Object... values) {
    return String.format(Locale.ROOT, pattern, values);
  }

  private String age(long sinceMillis) {
    Duration age = Duration.between(Instant.ofEpochMilli(sinceMillis), now);
    if (age.toDays() > 0) {
      return age.toDays() + " d " + age.toHoursPart() + " h";
    } else if (age.toHours() > 0) {
      return age.toHours() + " h " + age.toMinutesPart() + " min";
    } else if (age.toMinutes() > 0) {
      return age.toMinutes() + " min";
    }
    return Math.max(0, age.toSeconds()) + " s";
  }
}
