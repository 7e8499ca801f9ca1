package org.mechservice.admin;

import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import org.mechservice.admin.AdminFailure.Reason;
import org.mechservice.admin.ServerCalls.Pending;
import org.mechservice.idl.HostStatus;
import org.mechservice.idl.Limit;
import org.mechservice.idl.LogLine;
import org.mechservice.idl.MechAdmin;
import org.mechservice.idl.NotAuthorized;
import org.mechservice.idl.ServerStatus;
import org.mechservice.idl.ServiceEvent;
import org.mechservice.idl.SessionSummary;
import org.mechservice.idl.SimDetail;
import org.mechservice.idl.SimSummary;
import org.mechservice.orb.tls.TlsIdentity;
import org.mechservice.solver.catalogue.MessageCode;
import org.omg.CORBA.IntHolder;

/**
 * Monitors and controls a fixed set of servers. Everything the terminal and the page show or do
 * goes through here, and from here through the administration interface of the servers. No call
 * waits longer than the patience, whatever the servers do. Thread-safe.
 */
public final class AdminConsole implements AutoCloseable {
  /** A server asks its hosts for two seconds at most before it answers. */
  public static final Duration PATIENCE = Duration.ofSeconds(4);

  /** Simulations in one answer; one or two answers list a busy farm. */
  private static final int PAGE = 2000;

  private final List<String> servers;
  private final ServerCalls calls;

  /**
   * Opens a console for servers that are reached without encryption.
   *
   * @param servers {@code host:port} or URL of each; said twice is said once
   * @param patience longest wait for an answer
   */
  public AdminConsole(List<String> servers, Duration patience) {
    this(servers, patience, Optional.empty());
  }

  /**
   * Opens a console.
   *
   * @param servers {@code host:port} or URL of each; said twice is said once
   * @param patience longest wait for an answer
   * @param identity certificate of the operator; empty: connections are not encrypted
   */
  public AdminConsole(List<String> servers, Duration patience, Optional<TlsIdentity> identity) {
    this.servers = List.copyOf(new LinkedHashSet<>(servers));
    calls = new ServerCalls(patience, identity);
  }

  /** Returns the addresses of the servers, in the order they were given. */
  public List<String> servers() {
    return servers;
  }

  /** Reads the state of all servers at the same time; one reading each, in their order. */
  public List<ServerReading> read() {
    List<Questions> asked = servers.stream().map(Questions::new).toList();
    return asked.stream().map(Questions::await).toList();
  }

  /** Reads the state of one server. */
  public ServerReading read(String server) {
    return new Questions(require(server)).await();
  }

  /** The calls of a reading, which run at the same time. */
  private final class Questions {
    private final String server;
    private final Pending<ServerStatus> status;
    private final Pending<HostStatus[]> hosts;
    private final Pending<List<SimSummary>> simulations;

    Questions(String server) {
      this.server = server;
      status = calls.begin(server, MechAdmin::getStatus);
      hosts = calls.begin(server, MechAdmin::listHosts);
      simulations = calls.begin(server, AdminConsole::allSimulations);
    }

    ServerReading await() {
      try {
        return new ServerReading.Answering(
            server, status.await(), Arrays.asList(hosts.await()), simulations.await());
      } catch (AdminFailure failure) {
        return new ServerReading.Silent(
            server, failure.text(), failure.reason() == Reason.NOT_ALLOWED);
      }
    }
  }

  private static List<SimSummary> allSimulations(MechAdmin admin) throws NotAuthorized {
    List<SimSummary> all = new ArrayList<>();
    IntHolder total = new IntHolder();
    do {
      SimSummary[] page = admin.listSimulations(all.size(), PAGE, total);
      if (page.length == 0) {
        return all;
      }
      all.addAll(Arrays.asList(page));
    } while (all.size() < total.value);
    return all;
  }

  /**
   * Returns everything about a simulation.
   *
   * @throws AdminFailure if the server does not answer, refuses, or knows none of this id
   */
  public SimDetail show(String server, String simId) {
    return calls.begin(require(server), admin -> admin.showSimulation(simId)).await();
  }

  /**
   * Returns the sessions at a server and its hosts, the oldest first.
   *
   * @throws AdminFailure if the server does not answer or refuses
   */
  public List<SessionSummary> sessions(String server) {
    return Arrays.asList(calls.begin(require(server), MechAdmin::listSessions).await());
  }

  /**
   * Returns log lines, oldest first.
   *
   * @param host whose; empty: the server's own
   * @param since UTC, ms since 1970-01-01
   * @param maxCount most lines to return
   * @throws AdminFailure if the server does not answer, refuses, or knows no such host
   */
  public List<LogLine> logs(String server, String host, long since, int maxCount) {
    return Arrays.asList(
        calls.begin(require(server), admin -> admin.logs(host, since, maxCount)).await());
  }

  /**
   * Waits for events of a server and its hosts and returns them.
   *
   * @param after number of the last event already known
   * @param maxCount most events to return
   * @param waitMillis longest wait, ms
   * @throws AdminFailure if the server does not answer or refuses
   */
  public List<ServiceEvent> events(String server, long after, int maxCount, int waitMillis) {
    return Arrays.asList(
        calls.begin(require(server), admin -> admin.events(after, maxCount, waitMillis)).await());
  }

  /**
   * Returns the limits in force.
   *
   * @param host whose; empty: the server's
   * @throws AdminFailure if the server does not answer, refuses, or knows no such host
   */
  public List<Limit> limits(String server, String host) {
    return Arrays.asList(calls.begin(require(server), admin -> admin.getLimits(host)).await());
  }

  /**
   * Returns how the server chooses hosts.
   *
   * @throws AdminFailure if the server does not answer or refuses
   */
  public String placement(String server) {
    return calls.begin(require(server), MechAdmin::getPlacement).await();
  }

  /**
   * Performs an action on a server, once.
   *
   * @throws AdminFailure if the server does not answer, refuses, or what it is about is not there
   */
  public void perform(String server, AdminAction action) {
    var unused =
        calls
            .beginOnce(
                require(server),
                admin -> {
                  action.perform(admin);
                  return true;
                })
            .await();
  }

  /** Returns the address of a server that the operator named; no other server is connected to. */
  private String require(String server) {
    if (!servers.contains(server)) {
      throw new AdminFailure(
          Reason.NOT_FOUND,
          MessageCode.NOTHING_OF_THAT_NAME
              + " "
              + PlainText.of(server)
              + " is none of the servers of this console");
    }
    return server;
  }

  @Override
  public void close() {
    calls.close();
  }
}
