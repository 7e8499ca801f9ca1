package org.mechservice.admin;

import java.time.Instant;
import java.util.List;
import java.util.stream.Stream;
import org.mechservice.idl.HostLoad;
import org.mechservice.idl.HostStatus;
import org.mechservice.idl.ServerStatus;
import org.mechservice.idl.SessionSummary;
import org.mechservice.idl.SimSummary;

/** Shows servers, their hosts and simulations as tables. */
public final class StatusText {
  private final Instant now;

  /**
   * @param now the time from which ages are counted
   */
  public StatusText(Instant now) {
    this.now = now;
  }

  /** Returns servers, hosts and active simulations; a table without rows is left out. */
  public String all(List<ServerReading> readings) {
    StringBuilder text = new StringBuilder().append(servers(readings));
    TextTable hosts = hosts(readings);
    TextTable simulations =
        simulations(
            KnownSimulation.all(readings).stream().filter(KnownSimulation::isUnfinished).toList());
    for (TextTable table : List.of(hosts, simulations)) {
      if (!table.isEmpty()) {
        text.append('\n').append(table);
      }
    }
    return text.toString();
  }

  /** Returns the servers. */
  public TextTable servers(List<ServerReading> readings) {
    TextTable table =
        new TextTable(
            "SERVER",
            "ADDRESS",
            "STATE",
            "UP",
            "HOSTS",
            "SESSIONS",
            "RUNNING",
            "QUEUED",
            "VERSION",
            "CERTIFICATE");
    for (ServerReading reading : readings) {
      if (reading instanceof ServerReading.Answering answering) {
        addServer(table, answering);
      } else if (reading instanceof ServerReading.Silent silent) {
        table.add("-", silent.address(), silent.label());
      }
    }
    return table;
  }

  private void addServer(TextTable table, ServerReading.Answering reading) {
    ServerStatus status = reading.status();
    table.add(
        status.info.serverName,
        reading.address(),
        status.draining ? "draining" : "up",
        QuantityText.age(status.info.startedAt, now),
        Integer.toString(status.hosts),
        Integer.toString(status.sessions),
        Integer.toString(status.running),
        Integer.toString(status.queued),
        status.info.serverVersion,
        QuantityText.certificate(status.statistics, now));
  }

  /** Returns the hosts of all servers that answered. */
  public TextTable hosts(List<ServerReading> readings) {
    TextTable table =
        new TextTable(
            "HOST",
            "SERVER",
            "ADDRESS",
            "STATE",
            "CORES",
            "RUNNING",
            "QUEUED",
            "CPU",
            "MEMORY",
            "USER CODE",
            "CERTIFICATE",
            "LAST MESSAGE");
    for (ServerReading reading : readings) {
      if (reading instanceof ServerReading.Answering answering) {
        answering.hosts().forEach(host -> addHost(table, answering, host));
      }
    }
    return table;
  }

  private void addHost(TextTable table, ServerReading.Answering server, HostStatus host) {
    HostLoad load = host.load;
    table.add(
        host.info.name,
        server.name(),
        host.info.address,
        HostState.of(host).label(),
        Integer.toString(host.info.cores),
        load.running + " of " + host.info.capacity,
        Integer.toString(load.queued),
        QuantityText.load(load.cpuLoad),
        QuantityText.memory(load.memoryUsed),
        userCode(load),
        QuantityText.certificate(load.statistics, now),
        host.text);
  }

  /** Returns in a word whether classes of users run on a host; empty if the host is older. */
  private static String userCode(HostLoad load) {
    return Stream.of(load.statistics)
        .filter(statistic -> statistic.key.equals("userCode"))
        .map(statistic -> statistic.text.split(":", 2)[0])
        .findFirst()
        .orElse("");
  }

  /** Returns sessions with what they hold. */
  public TextTable sessions(List<SessionSummary> sessions) {
    TextTable table =
        new TextTable("SESSION", "HOST", "OWNER", "AGE", "ACTIVE", "RUNS", "MODEL BYTES");
    for (SessionSummary session : sessions) {
      table.add(
          session.sessionId,
          session.hostName,
          session.owner,
          QuantityText.age(session.openedAt, now),
          Integer.toString(session.active),
          Integer.toString(session.runs),
          Long.toString(session.modelBytes));
    }
    return table;
  }

  /** Returns simulations, in the order given. */
  public TextTable simulations(List<KnownSimulation> simulations) {
    TextTable table =
        new TextTable(
            "SIMULATION",
            "HOST",
            "MODEL",
            "OWNER",
            "STATE",
            "TIME",
            "STEPS",
            "STEP SIZE",
            "X REAL TIME",
            "AGE",
            "LAST MESSAGE");
    for (KnownSimulation known : simulations) {
      SimSummary summary = known.summary();
      table.add(
          summary.simId,
          summary.hostName,
          summary.modelName,
          summary.owner,
          known.state(),
          QuantityText.time(summary.info),
          Long.toString(summary.info.stepsDone),
          QuantityText.number(summary.info.stepSize),
          QuantityText.number(summary.info.realTimeFactor),
          QuantityText.age(summary.createdAt, now),
          summary.text);
    }
    return table;
  }
}
