package org.mechservice.orb.connection;

import java.io.IOException;
import java.net.Socket;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.UUID;
import java.util.concurrent.ConcurrentHashMap;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The connections that others have opened to an ORB. The ORB itself forgets those that it accepts
 * while it closes; they would stay open unread, and their peers would wait for an answer. Here all
 * of them are closed.
 */
public final class InboundConnections {
  private static final Logger LOG = LoggerFactory.getLogger(InboundConnections.class);

  /** The ORB makes its socket factory itself and hands it properties only: this finds the set. */
  private static final Map<String, InboundConnections> BY_ID = new ConcurrentHashMap<>();

  private final String id = UUID.randomUUID().toString();
  private final Set<Socket> open = new HashSet<>();
  private final ReplyMemory room = new ReplyMemory();
  private final RequestMemory requests = new RequestMemory();
  private int most = Integer.MAX_VALUE;
  private boolean closed;

  public InboundConnections() {
    BY_ID.put(id, this);
  }

  static InboundConnections byId(String id) {
    InboundConnections connections = BY_ID.get(id);
    if (connections == null) {
      throw new IllegalArgumentException("no connections " + id);
    }
    return connections;
  }

  public String id() {
    return id;
  }

  /** Returns the memory for answers to those connected. */
  public ReplyMemory room() {
    return room;
  }

  /** Returns the memory for large messages from those connected. */
  RequestMemory requests() {
    return requests;
  }

  /** Sets how many connections there may be; those there are stay. */
  public synchronized void allow(int connections) {
    most = connections;
  }

  /** Takes a connection in; one too many, or when all have been closed, is closed at once. */
  void add(Socket connection) throws IOException {
    synchronized (this) {
      if (!closed && open.size() < most) {
        open.add(connection);
        return;
      }
    }
    connection.close();
  }

  synchronized void remove(Socket connection) {
    open.remove(connection);
  }

  public synchronized int count() {
    return open.size();
  }

  /** Closes all connections, and those to come. */
  public void closeAll() {
    List<Socket> all;
    synchronized (this) {
      closed = true;
      all = List.copyOf(open);
    }
    for (Socket connection : all) {
      try {
        connection.close();
      } catch (IOException e) {
        LOG.debug("a connection does not close in order: {}", e.toString());
      }
    }
    BY_ID.remove(id);
    room.close();
  }
}
