package org.mechservice.orb.connection;

import org.jacorb.orb.ParsedIOR;
import org.jacorb.orb.iiop.IIOPAddress;
import org.jacorb.orb.iiop.IIOPProfile;
import org.mechservice.solver.catalogue.MessageCode;
import org.omg.CORBA.ORB;
import org.omg.ETF.Profile;

/**
 * The network address of an object.
 *
 * @param host numeric address
 * @param port TCP port
 */
public record Endpoint(String host, int port) {
  /**
   * Reads the endpoint a reference names.
   *
   * @throws IllegalArgumentException with code S-006 if it names none
   */
  public static Endpoint of(ORB orb, String reference) {
    try {
      for (Profile profile : new ParsedIOR((org.jacorb.orb.ORB) orb, reference).getProfiles()) {
        if (profile instanceof IIOPProfile iiop && iiop.getAddress() instanceof IIOPAddress at) {
          return new Endpoint(at.getIP(), port(iiop, at));
        }
      }
    } catch (RuntimeException e) {
      // The ORB's decoder answers damaged bytes with whatever happens to break.
      throw new IllegalArgumentException(MessageCode.SERVER_ADDRESS + " the IOR is damaged", e);
    }
    throw new IllegalArgumentException(
        MessageCode.SERVER_ADDRESS + " the IOR names no address that can be connected to");
  }

  private static int port(IIOPProfile profile, IIOPAddress plain) {
    return profile.getSSL() == null ? plain.getPort() : profile.getSSLPort();
  }

  /** Returns {@code host:port}. */
  @Override
  public String toString() {
    return host + ":" + port;
  }
}
