package org.mechservice.server.admin;

import java.lang.management.ManagementFactory;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.function.ToDoubleFunction;
import org.mechservice.idl.HostLoad;
import org.mechservice.idl.NameValue;
import org.mechservice.orb.tls.TlsIdentity;
import org.mechservice.server.hosts.HostDirectory;
import org.mechservice.server.hosts.MechServerServant;
import org.mechservice.server.hosts.RegisteredHost;

/** The figures of a server and its hosts, in the text format of Prometheus, version 0.0.4. */
public final class Metrics {
  /** Counts of a host that only grow, with their names here. */
  private static final Map<String, String> COUNTERS =
      Map.of(
          "sessionsOpened", "sessions_opened",
          "completed", "runs_completed",
          "failed", "runs_failed",
          "cancelled", "runs_cancelled");

  private static final long ANSWER_NANOS = 1_000_000_000;

  private final HostDirectory directory;
  private final MechServerServant server;
  private final Optional<TlsIdentity> identity;
  private final Optional<AuditLog> audit;
  private Optional<String> trouble = Optional.empty();
  private long triedAt = System.nanoTime() - 2 * ANSWER_NANOS;

  /**
   * @param identity of the server; empty: without TLS
   * @param audit of the server; empty: it writes none
   */
  public Metrics(
      HostDirectory directory,
      MechServerServant server,
      Optional<TlsIdentity> identity,
      Optional<AuditLog> audit) {
    this.directory = directory;
    this.server = server;
    this.identity = identity;
    this.audit = audit;
  }

  /** Returns all figures. */
  public String text() {
    directory.refresh();
    List<RegisteredHost> hosts =
        directory.all().stream().filter(RegisteredHost::reachable).toList();
    StringBuilder text = new StringBuilder();
    Runtime machine = Runtime.getRuntime();
    one(text, "draining", "whether new sessions are refused", server.draining() ? 1 : 0);
    one(text, "hosts", "hosts that are registered", directory.all().size());
    one(text, "hosts_reachable", "hosts that answer", hosts.size());
    one(
        text,
        "uptime_seconds",
        "time since the start",
        (System.currentTimeMillis() - server.getInfo().startedAt) * 1e-3);
    one(text, "heap_bytes", "heap in use", (double) machine.totalMemory() - machine.freeMemory());
    one(text, "threads", "live threads", ManagementFactory.getThreadMXBean().getThreadCount());
    audit.ifPresent(
        log ->
            one(
                text,
                "audit_waiting_events",
                "events that the audit log could not be written for",
                log.waiting()));
    gauge(text, hosts, "sessions", "sessions", load -> load.sessions);
    gauge(text, hosts, "runs_running", "runs that compute or are paused", load -> load.running);
    gauge(text, hosts, "runs_queued", "runs that wait for a place", load -> load.queued);
    gauge(
        text, hosts, "cpu_load", "share of the machine's processors in use", load -> load.cpuLoad);
    gauge(text, hosts, "host_memory_bytes", "memory in use", load -> (double) load.memoryUsed);
    gauge(
        text,
        hosts,
        "process_cpu_load",
        "share of the machine's processors that the host's process uses",
        load -> number(load, "processLoad"));
    identity.ifPresent(
        own -> {
          one(
              text,
              "certificate_expiry_seconds",
              "time at which the server's certificate expires, since 1970",
              own.expires().toEpochMilli() * 1e-3);
          gauge(
              text,
              hosts,
              "host_certificate_expiry_seconds",
              "time at which the certificate of a host expires, since 1970",
              load -> number(load, "certificateExpires") * 1e-3);
        });
    head(text, "host_memory_limit_bytes", "gauge", "memory that the host may use");
    hosts.forEach(
        host -> sample(text, "host_memory_limit_bytes", host, (double) host.memoryBytes()));
    gauge(text, hosts, "spool_bytes", "size of all rows kept", load -> number(load, "spoolBytes"));
    gauge(
        text,
        hosts,
        "disk_free_bytes",
        "space left on the disk of the rows",
        load -> number(load, "freeDisk"));
    gauge(text, hosts, "connections", "connections", load -> number(load, "connections"));
    COUNTERS.entrySet().stream()
        .sorted(Map.Entry.comparingByValue())
        .forEach(
            counter ->
                perHost(
                    text,
                    hosts,
                    counter.getValue() + "_total",
                    "counter",
                    counter.getValue().replace('_', ' ') + " since the start of the host",
                    load -> number(load, counter.getKey())));
    return text.toString();
  }

  private static double number(HostLoad load, String name) {
    for (NameValue statistic : load.statistics) {
      if (statistic.key.equals(name)) {
        return Double.parseDouble(statistic.text);
      }
    }
    return 0;
  }

  private static void head(StringBuilder text, String name, String type, String help) {
    text.append(
        String.format(
            Locale.ROOT,
            "# HELP mechservice_%s %s\n# TYPE mechservice_%s %s\n",
            name,
            help,
            name,
            type));
  }

  private static void one(StringBuilder text, String name, String help, double value) {
    head(text, name, "gauge", help);
    text.append("mechservice_").append(name).append(' ').append(value).append('\n');
  }

  private static void gauge(
      StringBuilder text,
      List<RegisteredHost> hosts,
      String name,
      String help,
      ToDoubleFunction<HostLoad> value) {
    perHost(text, hosts, name, "gauge", help, value);
  }

  private static void perHost(
      StringBuilder text,
      List<RegisteredHost> hosts,
      String name,
      String type,
      String help,
      ToDoubleFunction<HostLoad> value) {
    head(text, name, type, help);
    hosts.forEach(host -> sample(text, name, host, value.applyAsDouble(host.load())));
  }

  private static void sample(StringBuilder text, String name, RegisteredHost host, double value) {
    // Host names have letters, digits, points, hyphens and underscores only.
    text.append("mechservice_").append(name).append("{host=\"").append(host.name());
    text.append("\"} ").append(value).append('\n');
  }

  /**
   * Opens a session and ends it: returns whether that works, and if not, why. An answer is good for
   * a second, however many ask.
   */
  public synchronized MetricsEndpoint.Health health() {
    long now = System.nanoTime();
    if (now - triedAt > ANSWER_NANOS || server.draining()) {
      directory.refresh();
      trouble = server.tryOut();
      triedAt = now;
    }
    return new MetricsEndpoint.Health(trouble.isEmpty(), trouble.orElse("ok") + "\n");
  }
}
