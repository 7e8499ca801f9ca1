package org.mechservice.orb.tls;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.security.GeneralSecurityException;
import java.security.cert.CertificateException;
import java.security.cert.X509Certificate;
import javax.net.ssl.SSLContext;
import javax.net.ssl.SSLSocket;
import javax.net.ssl.TrustManager;
import javax.net.ssl.X509TrustManager;
import org.mechservice.orb.connection.Endpoint;

/**
 * Finds out whether the process at an address speaks TLS, for the text of a refusal. It trusts no
 * certificate: the attempt ends as soon as one is shown.
 */
public final class TlsProbe implements X509TrustManager {
  private static final int MILLIS = 2000;

  private volatile boolean certificateShown;

  private TlsProbe() {}

  /** Returns whether a certificate is shown at an address. */
  public static boolean speaksTls(Endpoint endpoint) {
    TlsProbe probe = new TlsProbe();
    try (Socket plain = new Socket()) {
      plain.connect(new InetSocketAddress(endpoint.host(), endpoint.port()), MILLIS);
      plain.setSoTimeout(MILLIS);
      SSLContext context = SSLContext.getInstance("TLS");
      context.init(null, new TrustManager[] {probe}, null);
      SSLSocket socket =
          (SSLSocket)
              context
                  .getSocketFactory()
                  .createSocket(plain, endpoint.host(), endpoint.port(), /* autoClose= */ true);
      socket.startHandshake();
    } catch (IOException | GeneralSecurityException e) {
      return probe.certificateShown;
    }
    return probe.certificateShown;
  }

  @Override
  public void checkServerTrusted(X509Certificate[] chain, String type) throws CertificateException {
    certificateShown = true;
    throw new CertificateException("seen enough");
  }

  @Override
  public void checkClientTrusted(X509Certificate[] chain, String type) throws CertificateException {
    throw new CertificateException("nobody is served here");
  }

  @Override
  public X509Certificate[] getAcceptedIssuers() {
    return new X509Certificate[0];
  }
}
