package org.mechservice.orb.tls;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.net.SocketException;
import java.security.cert.CertPathBuilderException;
import java.security.cert.CertPathValidatorException;
import java.security.cert.CertificateParsingException;
import java.security.cert.X509Certificate;
import java.util.Collection;
import java.util.List;
import java.util.Set;
import javax.net.ssl.SSLException;
import javax.net.ssl.SSLHandshakeException;
import javax.net.ssl.SSLSocket;
import org.jacorb.config.Configuration;
import org.jacorb.config.ConfigurationException;
import org.jacorb.orb.factory.AbstractSocketFactory;
import org.jspecify.annotations.Nullable;
import org.mechservice.orb.connection.OutboundAllowList;
import org.mechservice.orb.connection.OutboundSocketFactory;

/**
 * Opens encrypted connections to the addresses of an {@link OutboundAllowList} only, and only to
 * servers whose certificate names the address, or the name the user wrote.
 *
 * <p>Made by the ORB from its properties, hence public.
 */
public final class TlsOutboundSocketFactory extends AbstractSocketFactory {
  /** The property that names the {@link TlsPeers}. */
  public static final String PEERS_PROPERTY = "mechservice.tls";

  static final String[] PROTOCOLS = {"TLSv1.3", "TLSv1.2"};

  private static final int NO_TIMEOUT = 0;
  private static final int HANDSHAKE_MILLIS = 10_000;

  private OutboundAllowList list = OutboundAllowList.NONE;
  private @Nullable TlsPeers peers;

  @Override
  public void configure(Configuration configuration) throws ConfigurationException {
    super.configure(configuration);
    list = OutboundAllowList.byId(configuration.getAttribute(OutboundSocketFactory.LIST_PROPERTY));
    peers = TlsPeers.byId(configuration.getAttribute(PEERS_PROPERTY));
  }

  @Override
  public Socket createSocket(String host, int port) throws IOException {
    return doCreateSocket(host, port, NO_TIMEOUT);
  }

  @Override
  protected Socket doCreateSocket(String host, int port, int timeout) throws IOException {
    TlsPeers known = known();
    InetAddress address = InetAddress.getByName(host);
    OutboundSocketFactory.requireAllowed(list, address, port);
    Socket plain = new Socket();
    try {
      plain.connect(new InetSocketAddress(address, port), timeout);
      SSLSocket socket =
          (SSLSocket)
              known.identity().context().getSocketFactory().createSocket(plain, host, port, true);
      socket.setEnabledProtocols(PROTOCOLS);
      shakeHands(socket);
      X509Certificate shown = (X509Certificate) socket.getSession().getPeerCertificates()[0];
      requireName(shown, address, known.namesOf(address.getHostAddress()));
      known.accepted(address.getHostAddress(), port, shown);
      return socket;
    } catch (SSLException e) {
      known.refused(address.getHostAddress(), port, why(e));
      plain.close();
      throw e;
    } catch (IOException e) {
      plain.close();
      throw e;
    }
  }

  private static String why(SSLException refusal) {
    for (Throwable cause = refusal; cause != null; cause = cause.getCause()) {
      if (cause instanceof RevocationCheck.RevokedException) {
        return String.valueOf(cause.getMessage());
      }
      if (cause instanceof CertPathBuilderException
          || cause instanceof CertPathValidatorException) {
        return "its certificate is of another authority than this process's, or not valid now";
      }
    }
    return String.valueOf(refusal.getMessage());
  }

  /**
   * A server that refuses this process's certificate closes the connection while this side still
   * sends: the alert that says so is lost.
   */
  private static void shakeHands(SSLSocket socket) throws IOException {
    socket.setSoTimeout(HANDSHAKE_MILLIS);
    try {
      socket.startHandshake();
    } catch (SocketException e) {
      SSLException refused =
          new SSLHandshakeException(
              "it closed the connection when this process showed its certificate, which may be"
                  + " revoked, out of date or of another authority");
      refused.initCause(e);
      throw refused;
    }
    socket.setSoTimeout(NO_TIMEOUT);
  }

  private TlsPeers known() {
    if (peers == null) {
      throw new IllegalStateException("used before it was configured");
    }
    return peers;
  }

  /** A certificate of the right authority is not enough: it must be this server's. */
  private static void requireName(X509Certificate shown, InetAddress address, Set<String> names)
      throws SSLException {
    List<String> own = alternativeNames(shown);
    boolean named =
        own.contains(address.getHostAddress())
            || names.stream().anyMatch(name -> own.stream().anyMatch(name::equalsIgnoreCase));
    if (!named) {
      throw new SSLHandshakeException(
          "its certificate is made out to "
              + String.join(", ", own)
              + ", not to "
              + address.getHostAddress()
              + (names.isEmpty() ? "" : " or " + String.join(", ", names)));
    }
  }

  private static List<String> alternativeNames(X509Certificate shown) throws SSLException {
    try {
      Collection<List<?>> names = shown.getSubjectAlternativeNames();
      return names == null
          ? List.of()
          : names.stream().map(name -> String.valueOf(name.get(1))).toList();
    } catch (CertificateParsingException e) {
      throw new SSLHandshakeException("its certificate cannot be read");
    }
  }

  @Override
  public boolean isSSL(Socket socket) {
    return socket instanceof SSLSocket;
  }
}
