package org.mechservice.orb.connection;

import java.io.IOException;
import java.net.ConnectException;
import java.net.InetAddress;
import java.net.Socket;
import org.jacorb.config.Configuration;
import org.jacorb.config.ConfigurationException;
import org.jacorb.orb.factory.DefaultSocketFactory;

/**
 * Opens connections to the addresses of an {@link OutboundAllowList} only.
 *
 * <p>Made by the ORB from its properties, hence public.
 */
public final class OutboundSocketFactory extends DefaultSocketFactory {
  /** The property that names the list. */
  public static final String LIST_PROPERTY = "mechservice.outbound";

  private OutboundAllowList list = OutboundAllowList.NONE;

  @Override
  public void configure(Configuration configuration) throws ConfigurationException {
    super.configure(configuration);
    list = OutboundAllowList.byId(configuration.getAttribute(LIST_PROPERTY));
  }

  @Override
  public Socket createSocket(String host, int port) throws IOException {
    requireAllowed(list, InetAddress.getByName(host), port);
    return super.createSocket(host, port);
  }

  @Override
  protected Socket doCreateSocket(String host, int port, int timeout) throws IOException {
    requireAllowed(list, InetAddress.getByName(host), port);
    return super.doCreateSocket(host, port, timeout);
  }

  public static void requireAllowed(OutboundAllowList list, InetAddress address, int port)
      throws IOException {
    if (!list.allows(address, port)) {
      throw new ConnectException("connections to " + address + ":" + port + " are not allowed");
    }
  }
}
