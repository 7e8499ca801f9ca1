package org.mechservice.orb.connection;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import org.jacorb.config.Configuration;
import org.jacorb.config.ConfigurationException;
import org.jacorb.orb.ORB;
import org.jacorb.orb.giop.ClientConnection;
import org.jacorb.orb.giop.ClientConnectionManager;
import org.jacorb.orb.giop.GIOPConnection;
import org.jacorb.orb.giop.GIOPConnectionManager;
import org.jacorb.orb.giop.MessageReceptorPool;
import org.jacorb.orb.giop.RequestListener;
import org.jacorb.orb.iiop.IIOPProfile;
import org.jspecify.annotations.Nullable;
import org.omg.ETF.Profile;

/**
 * The connections that calls use, kept so that both ends can close them at once.
 *
 * <p>The ORB's own table locks itself and then the connection when a call fails, and the connection
 * and then itself when the peer has closed it. A client that dies while it is being called back
 * makes both happen at once, the two threads wait for each other, and every other client waits for
 * them. Here the next use of the table removes connections that the peer has closed. So no thread
 * that holds a connection waits for the table, and no thread that holds the table closes a
 * connection, which may take long.
 */
final class ConnectionTable extends ClientConnectionManager {
  private final ORB orb;
  private final GIOPConnectionManager opened;
  private final MessageReceptorPool readers;
  private final Map<Profile, ClientConnection> connections = new HashMap<>();
  private final Queue<ClientConnection> closedByPeer = new ConcurrentLinkedQueue<>();
  private @Nullable RequestListener callbacks;

  /**
   * @param opened makes the connections themselves
   */
  ConnectionTable(ORB orb, GIOPConnectionManager opened, Configuration configuration)
      throws ConfigurationException {
    super(orb, orb.getTransportManager(), opened);
    this.orb = orb;
    this.opened = opened;
    readers = new MessageReceptorPool("client", "ClientMessageReceptor", configuration);
  }

  /** Sets the receiver of calls that arrive over connections opened here. */
  @Override
  public synchronized void setRequestListener(RequestListener listener) {
    callbacks = listener;
  }

  /** Returns the connection to a place, opening it if need be, for one more user. */
  @Override
  public synchronized ClientConnection getConnection(Profile profile) {
    forgetClosed();
    ClientConnection present = find(profile);
    if (present == null || present.isClosed()) {
      present = open(profile);
      connections.put(profile, present);
    }
    present.incClients();
    return present;
  }

  private @Nullable ClientConnection find(Profile profile) {
    ClientConnection present = connections.get(profile);
    if (present == null && profile instanceof IIOPProfile iiop && iiop.getSSL() != null) {
      // A client that is called back names the address of its connection without that.
      present = connections.get(iiop.toNonSSL());
    }
    return present;
  }

  private ClientConnection open(Profile profile) {
    GIOPConnection connection =
        opened.createClientGIOPConnection(
            profile,
            orb.getTransportManager().getFactories(profile.tag()).create_connection(null),
            callbacks,
            null);
    readers.connectionCreated(connection);
    return new CallConnection(connection, orb, this, profile, true);
  }

  /** Takes one user away from a connection, and closes it after the last. */
  @Override
  @SuppressWarnings("UnsynchronizedOverridesSynchronized") // locks itself, but not while it closes
  public void releaseConnection(ClientConnection connection) {
    synchronized (this) {
      forgetClosed();
      if (!connection.decClients() && !connection.isClosed()) {
        return;
      }
      forget(connection);
    }
    connection.close();
  }

  /** Adds the connection of a peer that is called back over it. */
  @Override
  public synchronized void addConnection(GIOPConnection connection, Profile profile) {
    forgetClosed();
    if (!connections.containsKey(profile)) {
      ClientConnection back = new CallConnection(connection, orb, this, profile, false);
      back.incClients(); // it stays as long as its peer wants
      connections.put(profile, back);
    }
  }

  /** Called by a connection that is closing, which is locked meanwhile. */
  @Override
  @SuppressWarnings("UnsynchronizedOverridesSynchronized") // this is the point
  public void removeConnection(ClientConnection connection) {
    closedByPeer.add(connection);
  }

  private void forgetClosed() {
    for (ClientConnection closed = closedByPeer.poll();
        closed != null;
        closed = closedByPeer.poll()) {
      forget(closed);
    }
  }

  private void forget(ClientConnection connection) {
    connections.remove(connection.getRegisteredProfile(), connection);
  }

  /**
   * Closes all connections, after those that others have opened and wait for nothing have been told
   * so. Idempotent.
   */
  @Override
  @SuppressWarnings("UnsynchronizedOverridesSynchronized") // locks itself, but not while it closes
  public void shutdown() {
    opened.shutdown();
    List<ClientConnection> all;
    synchronized (this) {
      all = new ArrayList<>(connections.values());
      connections.clear();
    }
    all.forEach(ClientConnection::close);
    readers.shutdown();
  }
}
