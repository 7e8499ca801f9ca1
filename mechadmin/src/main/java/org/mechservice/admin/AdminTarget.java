package org.mechservice.admin;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import org.mechservice.admin.AdminFailure.Reason;
import org.mechservice.idl.HostStatus;
import org.mechservice.solver.catalogue.MessageCode;

/**
 * A server or one of its hosts.
 *
 * @param server address of the server
 * @param host name of the host; empty: the server itself
 */
public record AdminTarget(String server, String host) {
  private static final String HOST = "host:";
  private static final String SERVER = "server:";

  /**
   * Returns the server or host of a name.
   *
   * @param name name or address of a server, or name of a host; {@code server:NAME} and {@code
   *     host:NAME} say which of the two is meant
   * @throws AdminFailure if there is none (S-130) or more than one (S-131)
   */
  public static AdminTarget named(List<ServerReading> readings, String name) {
    List<AdminTarget> found = new ArrayList<>();
    if (!name.startsWith(HOST)) {
      found.addAll(
          servers(readings, name.substring(name.startsWith(SERVER) ? SERVER.length() : 0)));
    }
    if (!name.startsWith(SERVER)) {
      found.addAll(hosts(readings, name.substring(name.startsWith(HOST) ? HOST.length() : 0)));
    }
    if (found.isEmpty()) {
      throw notFound("server or host " + PlainText.of(name), names(readings), readings);
    } else if (found.size() > 1) {
      throw new AdminFailure(
          Reason.NOT_USABLE,
          MessageCode.AMBIGUOUS_NAME
              + " "
              + PlainText.of(name)
              + " may be "
              + found.stream().map(AdminTarget::toString).collect(Collectors.joining(" or "))
              + "; write host:NAME or server:NAME, and name one server with --server");
    }
    return found.get(0);
  }

  private static List<AdminTarget> servers(List<ServerReading> readings, String name) {
    return readings.stream()
        .filter(reading -> reading.name().equals(name) || reading.address().equals(name))
        .map(reading -> new AdminTarget(reading.address(), ""))
        .toList();
  }

  /** A host that serves several servers is one host. */
  private static List<AdminTarget> hosts(List<ServerReading> readings, String name) {
    Map<String, AdminTarget> byAddress = new LinkedHashMap<>();
    for (ServerReading reading : readings) {
      if (reading instanceof ServerReading.Answering answering) {
        for (HostStatus host : answering.hosts()) {
          if (host.info.name.equals(name)) {
            byAddress.putIfAbsent(host.info.address, new AdminTarget(reading.address(), name));
          }
        }
      }
    }
    return List.copyOf(byAddress.values());
  }

  private static List<String> names(List<ServerReading> readings) {
    List<String> names = new ArrayList<>();
    for (ServerReading reading : readings) {
      names.add(reading.name());
      if (reading instanceof ServerReading.Answering answering) {
        answering.hosts().forEach(host -> names.add(host.info.name));
      }
    }
    return names.stream().distinct().map(PlainText::of).toList();
  }

  /**
   * Servers that do not answer may be the ones that know; that is said. Where we may not look, it
   * is not said what is there.
   */
  static AdminFailure notFound(String what, List<String> there, List<ServerReading> readings) {
    Optional<ServerReading.Silent> refusal =
        readings.stream()
            .filter(ServerReading.Silent.class::isInstance)
            .map(ServerReading.Silent.class::cast)
            .filter(ServerReading.Silent::refused)
            .findFirst();
    if (refusal.isPresent()) {
      return new AdminFailure(Reason.NOT_ALLOWED, refusal.get().why());
    }
    List<String> silent =
        readings.stream()
            .filter(ServerReading.Silent.class::isInstance)
            .map(ServerReading::address)
            .toList();
    String known = there.isEmpty() ? "" : "; there are " + String.join(", ", there);
    String missing = silent.isEmpty() ? "" : "; no answer from " + String.join(", ", silent);
    return new AdminFailure(
        Reason.NOT_FOUND,
        MessageCode.NOTHING_OF_THAT_NAME + " there is no " + what + known + missing);
  }

  /** Returns the name as the operator reads it. */
  @Override
  public String toString() {
    return host.isEmpty()
        ? "the server at " + server
        : "host " + PlainText.of(host) + " of the server at " + server;
  }
}
