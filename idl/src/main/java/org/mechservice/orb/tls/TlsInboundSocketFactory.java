package org.mechservice.orb.tls;

import java.io.IOException;
import java.net.Socket;
import javax.net.ssl.SSLSocket;
import org.jacorb.config.Configuration;
import org.jacorb.config.ConfigurationException;
import org.jspecify.annotations.Nullable;
import org.mechservice.orb.connection.InboundConnections;
import org.mechservice.orb.connection.InboundSocketFactory;

/**
 * Opens ports whose connections are encrypted, from callers who show a certificate, and known to an
 * {@link InboundConnections}. Hands are shaken when the connection is first read, in its own
 * thread.
 *
 * <p>Made by the ORB from its properties, hence public.
 */
public final class TlsInboundSocketFactory extends InboundSocketFactory {
  private @Nullable TlsPeers peers;

  @Override
  public void configure(Configuration configuration) throws ConfigurationException {
    super.configure(configuration);
    peers = TlsPeers.byId(configuration.getAttribute(TlsOutboundSocketFactory.PEERS_PROPERTY));
  }

  @Override
  protected Socket ready(Accepted accepted) throws IOException {
    if (peers == null) {
      throw new IllegalStateException("used before it was configured");
    }
    SSLSocket socket =
        (SSLSocket)
            peers
                .identity()
                .context()
                .getSocketFactory()
                .createSocket(
                    accepted, accepted.getInetAddress().getHostAddress(), accepted.getPort(), true);
    socket.setUseClientMode(false);
    socket.setNeedClientAuth(true);
    socket.setEnabledProtocols(TlsOutboundSocketFactory.PROTOCOLS);
    return new EncryptedConnection(
        peers.identity(), accepted, socket, accepted.readAsMessages(socket.getInputStream()));
  }
}
