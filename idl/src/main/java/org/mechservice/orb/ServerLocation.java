package org.mechservice.orb;

import java.net.InetAddress;
import java.net.UnknownHostException;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.locks.LockSupport;
import org.mechservice.idl.API_VERSION;
import org.mechservice.idl.MechServer;
import org.mechservice.idl.MechServerHelper;
import org.mechservice.idl.ServerInfo;
import org.mechservice.orb.connection.Endpoint;
import org.mechservice.orb.tls.TlsPeers;
import org.mechservice.orb.tls.TlsProbe;
import org.mechservice.solver.catalogue.MessageCode;
import org.omg.CORBA.COMM_FAILURE;
import org.omg.CORBA.NO_PERMISSION;
import org.omg.CORBA.ORB;
import org.omg.CORBA.SystemException;
import org.omg.CORBA.TIMEOUT;
import org.omg.CORBA.TRANSIENT;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** The address of a server, and the check that a MechService answers there. */
final class ServerLocation {
  private static final Logger LOG = LoggerFactory.getLogger(ServerLocation.class);

  /** Pauses between attempts; what is no MechService is known after the sum of them. */
  private static final long[] PAUSES_MILLIS = {0, 50, 200, 500};

  private final ORB orb;
  private final ServiceUrl url;
  private final Endpoint endpoint;
  private final Optional<TlsPeers> tls;

  private ServerLocation(ORB orb, ServiceUrl url, Endpoint endpoint, Optional<TlsPeers> tls) {
    this.tls = tls;
    this.orb = orb;
    this.url = url;
    this.endpoint = endpoint;
  }

  /**
   * Finds out where a server is.
   *
   * @throws IllegalArgumentException with code S-006 if the reference names no address
   * @throws ServiceUnreachableException with code S-020 if the naming service does not know
   */
  static ServerLocation of(ORB orb, ServiceUrl url, Optional<TlsPeers> tls) {
    if (url.isName()) {
      org.omg.CORBA.Object named =
          NamingService.at(orb, url.host(), url.port()).resolve(url.name());
      return of(orb, ServiceUrl.parse(orb.object_to_string(named)), tls);
    } else if (url.isReference()) {
      return new ServerLocation(orb, url, Endpoint.of(orb, url.reference()), tls);
    }
    return new ServerLocation(orb, url, new Endpoint(url.host(), url.port()), tls);
  }

  Endpoint endpoint() {
    return endpoint;
  }

  /** Returns the server itself. */
  MechServer connect() {
    return MechServerHelper.unchecked_narrow(object(ServiceKey.SERVER));
  }

  /** Returns a reference to one of the server's named objects. */
  org.omg.CORBA.Object object(ServiceKey key) {
    if (url.isReference() && key == ServiceKey.SERVER) {
      return orb.string_to_object(url.reference());
    }
    return orb.string_to_object(ServiceUrl.corbaloc(endpoint, key, tls.isPresent()));
  }

  /**
   * Requests the info of the server.
   *
   * @throws ServiceUnreachableException if no process answers in time, or not a MechService that
   *     speaks this API
   */
  ServerInfo requireService() {
    ServerInfo info = requestInfo();
    if (!major(info.apiVersion).equals(major(API_VERSION.value))) {
      throw new ServiceUnreachableException(
          String.format(
              Locale.ROOT,
              MessageCode.WRONG_SERVER_VERSION
                  + " the server at %s speaks API %s, this client %s; use the client of server"
                  + " version %s",
              this,
              info.apiVersion,
              API_VERSION.value,
              info.serverVersion),
          null);
    }
    return info;
  }

  private ServerInfo requestInfo() {
    try {
      return requestInfoPatiently();
    } catch (COMM_FAILURE | TRANSIENT | NO_PERMISSION e) {
      throw noConnection(e);
    } catch (TIMEOUT e) {
      throw new ServiceUnreachableException(
          MessageCode.NO_SERVER_ANSWERS
              + " no answer from "
              + this
              + " within "
              + CallTimeouts.SECONDS
              + " s",
          e);
    } catch (SystemException e) {
      throw new ServiceUnreachableException(
          MessageCode.WRONG_SERVER_VERSION + " what answers at " + this + " is not a MechService",
          e);
    }
  }

  private ServiceUnreachableException noConnection(SystemException e) {
    Optional<String> refusal = tls.flatMap(peers -> peers.refusedAt(numeric()));
    boolean mixed = e instanceof COMM_FAILURE || refusal.isPresent();
    if (mixed && TlsProbe.speaksTls(endpoint) != tls.isPresent()) {
      return new ServiceUnreachableException(
          tls.isPresent()
              ? MessageCode.TLS_MISMATCH
                  + " this process uses TLS and the server at "
                  + this
                  + " does not; give both certificates with --tls FOLDER, or neither"
              : MessageCode.TLS_MISMATCH
                  + " the server at "
                  + this
                  + " uses TLS and this process does not; name your certificates with --tls FOLDER",
          e);
    } else if (refusal.isPresent()) {
      return new ServiceUnreachableException(
          MessageCode.NO_TRUST
              + " no trust between this process and the server at "
              + this
              + ": "
              + refusal.get(),
          e);
    } else if (e instanceof TRANSIENT) {
      return new ServiceUnreachableException(
          MessageCode.NO_SERVER_ANSWERS
              + " no server answers at "
              + this
              + "; is it running, and is the address right?",
          e);
    } else if (e instanceof NO_PERMISSION) {
      return new ServiceUnreachableException(
          MessageCode.TLS_MISMATCH
              + " one of this process and the server at "
              + this
              + " uses TLS and the other does not; give both certificates with --tls",
          e);
    }
    return new ServiceUnreachableException(
        MessageCode.WRONG_SERVER_VERSION
            + " what answers at "
            + this
            + " is not a MechService, or it is just closing"
            + (tls.isPresent() ? ", or it does not accept this process's certificate" : ""),
        e);
  }

  /** Returns the address as sockets have it. */
  private Endpoint numeric() {
    try {
      return new Endpoint(InetAddress.getByName(endpoint.host()).getHostAddress(), endpoint.port());
    } catch (UnknownHostException e) {
      return endpoint;
    }
  }

  /**
   * Requests the info, and again where the connection breaks: it may be that of an earlier call,
   * whose other end has gone, or the server gave its place to another connection before this
   * process got a word in.
   */
  private ServerInfo requestInfoPatiently() {
    MechServer server = MechServerHelper.unchecked_narrow(CallTimeouts.inTime(orb, connect()));
    for (long pause : PAUSES_MILLIS) {
      try {
        return server.getInfo();
      } catch (COMM_FAILURE e) {
        LOG.debug("{} closed the connection; trying again in {} ms", this, pause);
        LockSupport.parkNanos(pause * 1_000_000);
      }
    }
    return server.getInfo();
  }

  private static String major(String version) {
    int dot = version.indexOf('.');
    return dot < 0 ? version : version.substring(0, dot);
  }

  /** Returns the address as messages show it. */
  @Override
  public String toString() {
    return endpoint.toString();
  }
}
