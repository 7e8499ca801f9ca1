package org.mechservice.client;

import java.time.Instant;
import java.util.List;
import org.mechservice.idl.OPT_CONTINUES;
import org.mechservice.idl.ServerInfo;

/**
 * The description of a server.
 *
 * @param name the server's name
 * @param apiVersion version of the service's contract, such as {@code 1.0}
 * @param version version of the server
 * @param startedAt when it was started
 * @param capabilities supported formulations, integrators and formats
 */
public record ServiceDescription(
    String name, String apiVersion, String version, Instant startedAt, List<String> capabilities) {
  private static final String PLACES = "places=";

  public ServiceDescription {
    capabilities = List.copyOf(capabilities);
  }

  /** Returns the number of simulations that the server's hosts run at once; 1 if unknown. */
  int places() {
    return capabilities.stream()
        .filter(capability -> capability.matches(PLACES + "\\d{1,6}"))
        .mapToInt(capability -> Integer.parseInt(capability.substring(PLACES.length())))
        .findFirst()
        .orElse(1);
  }

  /** Returns whether a run that has moved can be found by its earlier ids. */
  boolean findsMovedRuns() {
    return capabilities.contains("option=" + OPT_CONTINUES.value);
  }

  static ServiceDescription of(ServerInfo info) {
    return new ServiceDescription(
        info.serverName,
        info.apiVersion,
        info.serverVersion,
        Instant.ofEpochMilli(info.startedAt),
        List.of(info.capabilities));
  }
}
