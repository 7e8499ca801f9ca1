package org.mechservice.server.admin;

import com.sun.net.httpserver.HttpExchange;
import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.UnknownHostException;
import java.nio.charset.StandardCharsets;
import java.util.HashSet;
import java.util.Locale;
import java.util.Set;
import java.util.concurrent.RejectedExecutionException;
import java.util.function.Supplier;
import java.util.regex.Pattern;
import org.mechservice.orb.BoundedHttp;
import org.mechservice.orb.GuardedServant;
import org.mechservice.solver.catalogue.MessageCode;

/**
 * Figures for a monitoring system, over HTTP: {@code /metrics} in the text format of Prometheus,
 * {@code /health} with status 200 as long as sessions can be opened and 503 otherwise.
 */
public final class MetricsEndpoint implements AutoCloseable {
  /** An address of version 4, or one of version 6 in brackets. */
  private static final Pattern ADDRESS =
      Pattern.compile("[0-9]{1,3}(?:\\.[0-9]{1,3}){3}|\\[[0-9a-f:.]+]");

  private static final String TEXT = "text/plain; version=0.0.4; charset=utf-8";

  /**
   * The health of the service.
   *
   * @param good whether it works
   * @param text why, for people
   */
  public record Health(boolean good, String text) {}

  private final BoundedHttp server;

  private MetricsEndpoint(BoundedHttp server) {
    this.server = server;
  }

  /**
   * Opens the port.
   *
   * @param address with port 0: any free one
   * @param metrics writes the figures
   * @param health returns the state of the service
   * @throws org.mechservice.orb.PortInUseException if the port is taken
   * @throws IllegalArgumentException with code S-004 if the address is none of this machine
   */
  public static MetricsEndpoint open(
      InetSocketAddress address, Supplier<String> metrics, Supplier<Health> health) {
    BoundedHttp server = BoundedHttp.open(address, "metrics");
    Set<String> names = ownNames(address);
    server.serve("/metrics", exchange -> answer(exchange, names, () -> ok(metrics.get())));
    server.serve("/health", exchange -> answer(exchange, names, health));
    server.start();
    return new MetricsEndpoint(server);
  }

  private static Health ok(String text) {
    return new Health(true, text);
  }

  /** Returns the names under which others know this machine. */
  private static Set<String> ownNames(InetSocketAddress address) {
    Set<String> names = new HashSet<>(Set.of("localhost"));
    names.add(address.getHostString().toLowerCase(Locale.ROOT));
    try {
      InetAddress machine = InetAddress.getLocalHost();
      names.add(machine.getHostName().toLowerCase(Locale.ROOT));
      names.add(machine.getCanonicalHostName().toLowerCase(Locale.ROOT));
    } catch (UnknownHostException e) {
      // A machine without a name has its addresses.
    }
    return names;
  }

  /**
   * Returns whether a request asks for this machine: by an address, or by a name of it. A site that
   * gives its own name our address, so that a browser here reads the figures for it, does not.
   */
  private static boolean isForUs(HttpExchange exchange, Set<String> names) {
    String asked = exchange.getRequestHeaders().getFirst("Host");
    if (asked == null) {
      return false;
    }
    String host = asked.toLowerCase(Locale.ROOT).replaceFirst(":[0-9]{1,5}$", "");
    return names.contains(host) || ADDRESS.matcher(host).matches();
  }

  private static void answer(HttpExchange exchange, Set<String> names, Supplier<Health> content)
      throws IOException {
    try (exchange) {
      if (!isForUs(exchange, names)) {
        exchange.sendResponseHeaders(403, -1);
        return;
      }
      Health said = checked(content);
      byte[] body = said.text().getBytes(StandardCharsets.UTF_8);
      exchange.getResponseHeaders().set("Content-Type", TEXT);
      exchange.sendResponseHeaders(said.good() ? 200 : 503, body.length);
      exchange.getResponseBody().write(body);
    }
  }

  private static Health checked(Supplier<Health> content) {
    try {
      return content.get();
    } catch (RejectedExecutionException e) {
      return new Health(false, "the server is closing\n");
    } catch (RuntimeException e) {
      return new Health(
          false,
          MessageCode.INTERNAL_SERVER_ERROR
              + " incident "
              + GuardedServant.record("metrics", e)
              + "\n");
    }
  }

  public int port() {
    return server.port();
  }

  @Override
  public void close() {
    server.close();
  }
}
