package org.mechservice.server.admin;

import com.sun.net.httpserver.HttpExchange;
import java.io.IOException;
import java.net.InetSocketAddress;
import java.nio.charset.StandardCharsets;
import java.util.concurrent.RejectedExecutionException;
import java.util.function.Supplier;
import org.mechservice.orb.BoundedHttp;
import org.mechservice.orb.GuardedServant;
import org.mechservice.solver.catalogue.MessageCode;

/**
 * Figures for a monitoring system, over HTTP: {@code /metrics} in the text format of Prometheus,
 * {@code /health} with status 200 as long as sessions can be opened and 503 otherwise.
 */
public final class MetricsEndpoint implements AutoCloseable {
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
    server.serve("/metrics", exchange -> answer(exchange, () -> ok(metrics.get())));
    server.serve("/health", exchange -> answer(exchange, health));
    server.start();
    return new MetricsEndpoint(server);
  }

  private static Health ok(String text) {
    return new Health(true, text);
  }

  private static void answer(HttpExchange exchange, Supplier<Health> content) throws IOException {
    try (exchange) {
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
