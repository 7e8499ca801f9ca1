package org.mechservice.orb.tls;

import java.io.IOException;
import java.net.Socket;
import java.security.cert.Certificate;
import java.security.cert.X509Certificate;
import java.util.Optional;
import javax.net.ssl.SSLPeerUnverifiedException;
import javax.net.ssl.SSLSession;
import javax.net.ssl.SSLSocket;
import org.jacorb.orb.giop.GIOPConnection;
import org.jacorb.orb.iiop.IIOPConnection;
import org.jacorb.orb.portableInterceptor.ServerRequestInfoImpl;
import org.mechservice.orb.connection.InboundCall;
import org.mechservice.orb.connection.ReplyMemory;
import org.mechservice.solver.catalogue.MessageCode;
import org.omg.CORBA.INITIALIZE;
import org.omg.CORBA.LocalObject;
import org.omg.PortableInterceptor.ORBInitInfo;
import org.omg.PortableInterceptor.ORBInitInfoPackage.DuplicateName;
import org.omg.PortableInterceptor.ORBInitializer;
import org.omg.PortableInterceptor.ServerRequestInfo;
import org.omg.PortableInterceptor.ServerRequestInterceptor;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Sets {@link Caller#current} before each call, and follows it in {@link InboundCall}; the ORB runs
 * interceptors and servant in one thread.
 *
 * <p>Made by the ORB from its properties, hence public.
 */
public final class CallerInterceptor extends LocalObject
    implements ORBInitializer, ServerRequestInterceptor {
  private static final long serialVersionUID = 1L;
  private static final Logger LOG = LoggerFactory.getLogger(CallerInterceptor.class);

  @Override
  public void pre_init(ORBInitInfo info) {
    // There is nothing to be done so early.
  }

  @Override
  public void post_init(ORBInitInfo info) {
    try {
      info.add_server_request_interceptor(this);
    } catch (DuplicateName e) {
      throw (INITIALIZE) new INITIALIZE("caller").initCause(e);
    }
  }

  @Override
  public void receive_request_service_contexts(ServerRequestInfo request) {
    ReplyMemory.made();
    GIOPConnection connection = ((ServerRequestInfoImpl) request).getConnection();
    Caller.isNow(callerAt(connection));
    if (connection != null && connection.getTransport() instanceof IIOPConnection over) {
      InboundCall.begins(accepted(over.getSocket()), request.request_id());
    }
  }

  private static Socket accepted(Socket socket) {
    return socket instanceof EncryptedConnection encrypted ? encrypted.accepted() : socket;
  }

  private static Caller callerAt(GIOPConnection connection) {
    if (connection == null || !(connection.getTransport() instanceof IIOPConnection over)) {
      return Caller.inThisProcess();
    }
    Socket socket = over.getSocket();
    String address = socket.getInetAddress().getHostAddress() + ":" + socket.getPort();
    Optional<SSLSession> session = session(socket);
    Optional<X509Certificate> shown = session.map(CallerInterceptor::certificate);
    if (socket instanceof EncryptedConnection opened
        && shown.filter(opened.owner()::revoked).isPresent()) {
      refuse(opened, shown.get());
    }
    return new Caller(shown, session.flatMap(CallerInterceptor::own), address);
  }

  /** Returns what the two sides of an encrypted connection have agreed on. */
  private static Optional<SSLSession> session(Socket socket) {
    if (socket instanceof EncryptedConnection opened) {
      return Optional.of(opened.session());
    }
    return socket instanceof SSLSocket ours ? Optional.of(ours.getSession()) : Optional.empty();
  }

  /** Ends a connection that was made before its caller's certificate was taken back. */
  private static void refuse(EncryptedConnection connection, X509Certificate revoked) {
    LOG.warn(
        MessageCode.CERTIFICATE_REVOKED
            + " a connection of \"{}\" is closed: its certificate has been revoked",
        TlsIdentity.nameOf(revoked));
    try {
      connection.close();
    } catch (IOException e) {
      LOG.debug("the connection is closed already", e);
    }
    throw new org.omg.CORBA.NO_PERMISSION("the certificate has been revoked");
  }

  private static Optional<X509Certificate> own(SSLSession session) {
    Certificate[] chain = session.getLocalCertificates();
    return chain != null && chain[0] instanceof X509Certificate own
        ? Optional.of(own)
        : Optional.empty();
  }

  private static X509Certificate certificate(SSLSession session) {
    try {
      return (X509Certificate) session.getPeerCertificates()[0];
    } catch (SSLPeerUnverifiedException e) {
      // Such connections are not accepted.
      throw (org.omg.CORBA.NO_PERMISSION)
          new org.omg.CORBA.NO_PERMISSION("no certificate").initCause(e);
    }
  }

  @Override
  public void receive_request(ServerRequestInfo request) {
    // The caller is known already.
  }

  @Override
  public void send_reply(ServerRequestInfo request) {
    ReplyMemory.made();
    InboundCall.ends();
  }

  @Override
  public void send_exception(ServerRequestInfo request) {
    ReplyMemory.made();
    InboundCall.ends();
  }

  @Override
  public void send_other(ServerRequestInfo request) {
    ReplyMemory.made();
    InboundCall.ends();
  }

  @Override
  public String name() {
    return "caller";
  }

  @Override
  public void destroy() {
    // It holds nothing.
  }
}
