package org.mechservice.orb;

import java.util.Locale;
import org.mechservice.idl.API_VERSION;
import org.mechservice.idl.MechServer;
import org.mechservice.idl.MechServerHelper;
import org.mechservice.idl.ServerInfo;
import org.omg.CORBA.COMM_FAILURE;
import org.omg.CORBA.ORB;
import org.omg.CORBA.SystemException;
import org.omg.CORBA.TIMEOUT;
import org.omg.CORBA.TRANSIENT;

/** Where a server is said to be, and the check that it is there. */
final class ServerLocation {
  private final ORB orb;
  private final ServiceUrl url;
  private final Endpoint endpoint;

  private ServerLocation(ORB orb, ServiceUrl url, Endpoint endpoint) {
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
  static ServerLocation of(ORB orb, ServiceUrl url) {
    if (url.isName()) {
      org.omg.CORBA.Object named =
          NamingService.at(orb, url.host(), url.port()).resolve(url.name());
      return of(orb, ServiceUrl.parse(orb.object_to_string(named)));
    } else if (url.isReference()) {
      return new ServerLocation(orb, url, Endpoint.of(orb, url.reference()));
    }
    return new ServerLocation(orb, url, new Endpoint(url.host(), url.port()));
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
    return orb.string_to_object(ServiceUrl.corbaloc(endpoint, key));
  }

  /**
   * Asks the server who it is.
   *
   * @throws ServiceUnreachableException if nobody answers in time, or not a MechService that speaks
   *     this API
   */
  void requireService() {
    ServerInfo info = ask();
    if (!major(info.apiVersion).equals(major(API_VERSION.value))) {
      throw new ServiceUnreachableException(
          String.format(
              Locale.ROOT,
              "S-005 the server at %s speaks API %s, this client %s; use the client of server"
                  + " version %s",
              this,
              info.apiVersion,
              API_VERSION.value,
              info.serverVersion),
          null);
    }
  }

  private ServerInfo ask() {
    try {
      return askOnce();
    } catch (COMM_FAILURE e) {
      throw new ServiceUnreachableException(
          "S-005 what answers at " + this + " is not a MechService, or it is just closing", e);
    } catch (TRANSIENT e) {
      throw new ServiceUnreachableException(
          "S-002 no server answers at " + this + "; is it running, and is the address right?", e);
    } catch (TIMEOUT e) {
      throw new ServiceUnreachableException(
          "S-002 no answer from " + this + " within " + Answers.SECONDS + " s", e);
    } catch (SystemException e) {
      throw new ServiceUnreachableException(
          "S-005 what answers at " + this + " is not a MechService", e);
    }
  }

  private ServerInfo askOnce() {
    MechServer server = MechServerHelper.unchecked_narrow(Answers.inTime(orb, connect()));
    try {
      return server.getInfo();
    } catch (COMM_FAILURE e) {
      // A connection of an earlier call whose other end has gone: the next call opens a new one.
      return server.getInfo();
    }
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
