package org.mechservice.orb;

import java.util.Locale;
import org.mechservice.idl.API_VERSION;
import org.mechservice.idl.MechServer;
import org.mechservice.idl.MechServerHelper;
import org.mechservice.idl.ServerInfo;
import org.omg.CORBA.Any;
import org.omg.CORBA.COMM_FAILURE;
import org.omg.CORBA.ORB;
import org.omg.CORBA.Policy;
import org.omg.CORBA.PolicyError;
import org.omg.CORBA.SetOverrideType;
import org.omg.CORBA.SystemException;
import org.omg.CORBA.TIMEOUT;
import org.omg.CORBA.TRANSIENT;
import org.omg.Messaging.RELATIVE_RT_TIMEOUT_POLICY_TYPE;

/** Where a server is said to be, and the check that it is there. */
final class ServerLocation {
  private static final int ANSWER_SECONDS = 5;
  private static final long TIME_UNITS_PER_SECOND = 10_000_000; // CORBA counts in 100 ns

  private final ORB orb;
  private final ServiceUrl url;
  private final Endpoint endpoint;

  private ServerLocation(ORB orb, ServiceUrl url, Endpoint endpoint) {
    this.orb = orb;
    this.url = url;
    this.endpoint = endpoint;
  }

  static ServerLocation of(ORB orb, String written) {
    ServiceUrl url = ServiceUrl.parse(written);
    if (!url.isReference()) {
      return new ServerLocation(orb, url, new Endpoint(url.host(), url.port()));
    }
    return new ServerLocation(orb, url, Endpoint.of(orb, url.reference()));
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
          "S-002 no answer from " + this + " within " + ANSWER_SECONDS + " s", e);
    } catch (SystemException e) {
      throw new ServiceUnreachableException(
          "S-005 what answers at " + this + " is not a MechService", e);
    }
  }

  private ServerInfo askOnce() {
    MechServer server =
        MechServerHelper.unchecked_narrow(
            connect()._set_policy_override(answerInTime(), SetOverrideType.ADD_OVERRIDE));
    try {
      return server.getInfo();
    } catch (COMM_FAILURE e) {
      // A connection of an earlier call whose other end has gone: the next call opens a new one.
      return server.getInfo();
    }
  }

  private Policy[] answerInTime() {
    Any time = orb.create_any();
    time.insert_ulonglong(ANSWER_SECONDS * TIME_UNITS_PER_SECOND);
    try {
      return new Policy[] {orb.create_policy(RELATIVE_RT_TIMEOUT_POLICY_TYPE.value, time)};
    } catch (PolicyError e) {
      throw new IllegalStateException(e);
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
