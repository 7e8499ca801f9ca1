package org.mechservice.orb;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.net.InetAddress;
import java.net.NetworkInterface;
import java.net.Socket;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse.BodyHandlers;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** A caller that never ends its request costs its own connection, and nobody else waits. */
class BoundedHttpTest {
  private static final Duration PATIENCE = Duration.ofSeconds(60);

  private final List<Socket> halfSent = new ArrayList<>();
  private BoundedHttp server;

  @BeforeEach
  void open() {
    server = BoundedHttp.open(0, "test");
    server.serve(
        "/health",
        exchange -> {
          try (exchange) {
            byte[] body = "well".getBytes(StandardCharsets.US_ASCII);
            exchange.sendResponseHeaders(200, body.length);
            exchange.getResponseBody().write(body);
          }
        });
    server.start();
  }

  @AfterEach
  void close() throws IOException {
    for (Socket socket : halfSent) {
      socket.close();
    }
    server.close();
  }

  private Socket halfSent() throws IOException {
    Socket socket = new Socket(InetAddress.getLoopbackAddress(), server.port());
    socket
        .getOutputStream()
        .write("GET /health HTTP/1.1\r\nHost: x\r\n".getBytes(StandardCharsets.US_ASCII));
    halfSent.add(socket);
    return socket;
  }

  private String health() throws IOException, InterruptedException {
    HttpRequest request =
        HttpRequest.newBuilder(URI.create("http://127.0.0.1:" + server.port() + "/health"))
            .timeout(PATIENCE)
            .build();
    return HttpClient.newHttpClient().send(request, BodyHandlers.ofString()).body();
  }

  @Test
  void halfSentRequestsHoldNobodyUp() throws Exception {
    for (int i = 0; i < 50; i++) {
      halfSent();
    }
    assertThat(health()).isEqualTo("well");
  }

  @Test
  @Tag("soak")
  void aThousandHalfSentRequestsHoldNobodyUp() throws Exception {
    for (int i = 0; i < 1000; i++) {
      halfSent();
    }
    assertThat(health()).isEqualTo("well");
  }

  @Test
  @Tag("soak")
  void halfSentRequestLosesItsConnection() throws Exception {
    Socket socket = halfSent();
    socket.setSoTimeout((int) PATIENCE.toMillis());
    assertThat(socket.getInputStream().read()).isEqualTo(-1);
  }

  /** Not even at the other addresses of this machine. */
  @Test
  void onlyTheLoopbackAddressIsListenedAt() throws Exception {
    List<InetAddress> others =
        NetworkInterface.networkInterfaces()
            .flatMap(NetworkInterface::inetAddresses)
            .filter(address -> !address.getHostAddress().equals("127.0.0.1"))
            .toList();
    for (InetAddress other : others) {
      assertThatThrownBy(() -> new Socket(other, server.port()).close())
          .as(other.getHostAddress())
          .isInstanceOf(IOException.class);
    }
    assertThat(health()).isEqualTo("well");
  }

  @Test
  void portInUseIsNamed() {
    assertThatThrownBy(() -> BoundedHttp.open(server.port(), "second"))
        .isInstanceOf(PortInUseException.class)
        .hasMessageContaining("127.0.0.1:" + server.port());
  }
}
