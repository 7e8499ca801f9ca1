package org.mechservice.orb.connection;

import static org.assertj.core.api.Assertions.assertThat;

import java.lang.reflect.Proxy;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.util.concurrent.FutureTask;
import org.jacorb.config.Configuration;
import org.junit.jupiter.api.Test;

class LastRepliesTest {
  /** More than a socket takes at once: the rest waits in the queue of the connection. */
  private static final int BYTES = 1 << 23;

  private static InboundSocketFactory factory(InboundConnections connections) throws Exception {
    InboundSocketFactory factory = new InboundSocketFactory();
    factory.configure(
        (Configuration)
            Proxy.newProxyInstance(
                Configuration.class.getClassLoader(),
                new Class<?>[] {Configuration.class},
                (proxy, asked, arguments) -> connections.id()));
    return factory;
  }

  /** The ORB ends the output before it closes; the reply of a shutdown must not be lost there. */
  @Test
  void whatWasWrittenIsReadAfterTheOutputHasEnded() throws Exception {
    InboundConnections connections = new InboundConnections();
    InetAddress here = InetAddress.getLoopbackAddress();
    try (ServerSocket port = factory(connections).createServerSocket(0, 1, here);
        Socket peer = new Socket(here, port.getLocalPort())) {
      connections.allow(1);
      try (Socket accepted = port.accept()) {
        accepted.getOutputStream().write(new byte[BYTES]);
        FutureTask<Integer> read =
            new FutureTask<>(() -> peer.getInputStream().readAllBytes().length);
        new Thread(read).start();
        accepted.shutdownOutput();
        assertThat(read.get()).isEqualTo(BYTES);
      }
    } finally {
      connections.closeAll();
    }
  }
}
