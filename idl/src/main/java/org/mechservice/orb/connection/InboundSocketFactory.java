package org.mechservice.orb.connection;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.util.HashSet;
import java.util.Set;
import java.util.concurrent.atomic.AtomicInteger;
import org.jacorb.config.Configurable;
import org.jacorb.config.Configuration;
import org.jacorb.config.ConfigurationException;
import org.jacorb.orb.factory.ServerSocketFactory;
import org.jspecify.annotations.Nullable;

/**
 * Opens ports whose connections are known to an {@link InboundConnections}.
 *
 * <p>Made by the ORB from its properties, hence public.
 */
public class InboundSocketFactory implements ServerSocketFactory, Configurable {
  /** The property that names the set of connections. */
  public static final String CONNECTIONS_PROPERTY = "mechservice.inbound";

  /** Clients that connect in the same moment wait here; beyond it they must try again. */
  private static final int BACKLOG = 1024;

  private @Nullable InboundConnections connections;

  @Override
  public void configure(Configuration configuration) throws ConfigurationException {
    connections = InboundConnections.byId(configuration.getAttribute(CONNECTIONS_PROPERTY));
  }

  @Override
  public ServerSocket createServerSocket(int port) throws IOException {
    return new Port(port, null);
  }

  @Override
  public ServerSocket createServerSocket(int port, int backlog) throws IOException {
    return createServerSocket(port);
  }

  @Override
  public ServerSocket createServerSocket(int port, int backlog, InetAddress address)
      throws IOException {
    return new Port(port, address);
  }

  private InboundConnections known() {
    if (connections == null) {
      throw new IllegalStateException("used before it was configured");
    }
    return connections;
  }

  /** Returns what the ORB reads from and writes to, of a connection that was accepted. */
  protected Socket ready(Accepted accepted) throws IOException {
    accepted.readAsMessages();
    return accepted;
  }

  private final class Port extends ServerSocket {
    Port(int port, @Nullable InetAddress address) throws IOException {
      super(port, BACKLOG, address);
    }

    @Override
    public Socket accept() throws IOException {
      Accepted accepted = new Accepted(known());
      implAccept(accepted);
      known().add(accepted);
      return ready(accepted);
    }
  }

  /** An inbound connection. */
  protected static final class Accepted extends Socket {
    private final InboundConnections connections;
    private @Nullable ReplyQueue replies;
    private @Nullable RequestStream requests;
    private volatile boolean plain;
    private final AtomicInteger calls = new AtomicInteger();
    private volatile boolean leased;
    private final Set<Thread> working = new HashSet<>();
    private boolean ended;

    public Accepted(InboundConnections connections) {
      this.connections = connections;
    }

    @Override
    public OutputStream getOutputStream() throws IOException {
      synchronized (connections) {
        if (replies == null) {
          replies = new ReplyQueue(this, super.getOutputStream(), connections.room());
        }
        return replies;
      }
    }

    /** What comes in are messages, not something else that holds them. */
    void readAsMessages() throws IOException {
      synchronized (connections) {
        plain = true;
        requests = new RequestStream(this, super.getInputStream(), connections.requests());
      }
    }

    /**
     * Returns the input of a connection whose messages are encrypted, which is watched like one
     * that is not.
     *
     * @param decrypted the messages
     */
    public InputStream readAsMessages(InputStream decrypted) {
      synchronized (connections) {
        requests = new RequestStream(this, decrypted, connections.requests());
        return requests;
      }
    }

    @Override
    public InputStream getInputStream() throws IOException {
      RequestStream messages = requests();
      return plain && messages != null ? messages : super.getInputStream();
    }

    @Nullable RequestStream requests() {
      synchronized (connections) {
        return requests;
      }
    }

    /** Returns whether a whole message has come. */
    boolean isUsed() {
      RequestStream messages = requests();
      return messages != null && messages.isUsed();
    }

    /** Returns how long nothing has come, ns. */
    long stalledNanos() {
      RequestStream messages = requests();
      return messages == null ? 0 : messages.stalledNanos();
    }

    void callBegins() {
      calls.incrementAndGet();
    }

    void callEnds() {
      calls.decrementAndGet();
    }

    /** Has the end of this connection interrupt a thread, at once if it has ended. */
    void interruptsAtItsEnd(Thread thread) {
      synchronized (working) {
        if (ended) {
          thread.interrupt();
        } else {
          working.add(thread);
        }
      }
    }

    /** Has it not do that any more. A thread that was interrupted by it is so no longer. */
    void leavesAlone(Thread current) {
      synchronized (working) {
        if (!working.remove(current)) {
          boolean unused = Thread.interrupted();
        }
      }
    }

    private void interruptWorking() {
      synchronized (working) {
        ended = true;
        working.forEach(Thread::interrupt);
        working.clear();
      }
    }

    /** Sets whether the peer has something here that lives as long as it calls. */
    void setLeased(boolean leased) {
      this.leased = leased;
    }

    /** Returns whether nothing is lost if the peer has to connect anew for its next call. */
    boolean isIdle() {
      return !leased && calls.get() == 0;
    }

    /** Returns the size of a request of which the beginning alone was passed on, or 0. */
    long takeRefused(int request) {
      RequestStream messages = requests();
      return messages == null ? 0 : messages.takeRefused(request);
    }

    /** Returns whether the peer is late with a message. */
    boolean isOverdue() {
      RequestStream messages = requests();
      return messages != null && messages.isOverdue(System.nanoTime());
    }

    /** Closes the connection without its last replies. */
    void abandon() {
      ReplyQueue last = replies();
      if (last != null) {
        last.abandon();
      }
      RequestStream messages = requests();
      if (messages != null) {
        messages.abandon();
      }
    }

    private @Nullable ReplyQueue replies() {
      synchronized (connections) {
        return replies;
      }
    }

    /** The ORB says so before it closes: the last replies come first. */
    @Override
    public void shutdownOutput() throws IOException {
      ReplyQueue last = replies();
      if (last != null) {
        last.finish();
      }
      if (!isClosed()) {
        super.shutdownOutput();
      }
    }

    @Override
    @SuppressWarnings(
        "UnsynchronizedOverridesSynchronized") // must not wait for a thread that waits for this one
    public void close() throws IOException {
      connections.remove(this);
      interruptWorking();
      ReplyQueue last = replies();
      if (last != null && !isClosed()) {
        last.finish();
      }
      super.close();
      if (last != null) {
        last.abandon();
      }
      RequestStream messages = requests();
      if (messages != null) {
        messages.ended();
      }
    }
  }
}
