package org.mechservice.orb;

import com.sun.net.httpserver.HttpHandler;
import com.sun.net.httpserver.HttpServer;
import java.io.IOException;
import java.net.BindException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.NetworkInterface;
import java.net.SocketException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.SynchronousQueue;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import org.mechservice.solver.catalogue.MessageCode;

/**
 * An HTTP server that no caller can hold up, on the loopback interface unless said otherwise. A
 * request whose head or body does not arrive within {@value #REQUEST_SECONDS} s costs its own
 * connection alone: each is read by a thread of its own, and beyond {@value #MOST_REQUESTS} at once
 * a connection is closed at its first byte.
 */
public final class BoundedHttp implements AutoCloseable {
  /** Longest time for a request to arrive, s. */
  static final int REQUEST_SECONDS = 10;

  /** Requests that are read or answered at once. */
  static final int MOST_REQUESTS = 2000;

  static {
    // The server of the JDK reads its deadline once, when its first class is loaded.
    System.setProperty("sun.net.httpserver.maxReqTime", Integer.toString(REQUEST_SECONDS));
  }

  private final HttpServer server;
  private final ExecutorService threads;

  private BoundedHttp(HttpServer server, ExecutorService threads) {
    this.server = server;
    this.threads = threads;
  }

  /**
   * Opens a port of the loopback interface. Nothing is served before {@link #start}.
   *
   * @param port 0: any free one
   * @param name of its threads
   * @throws PortInUseException if the port is taken
   */
  public static BoundedHttp open(int port, String name) {
    return open(new InetSocketAddress(loopback(), port), name);
  }

  /**
   * Opens a port. Nothing is served before {@link #start}.
   *
   * @param address with port 0: any free one
   * @param name of its threads
   * @throws PortInUseException if the port is taken
   * @throws IllegalArgumentException with code S-004 if the address is none of this machine
   */
  public static BoundedHttp open(InetSocketAddress address, String name) {
    ExecutorService threads =
        new ThreadPoolExecutor(
            0,
            MOST_REQUESTS,
            1,
            TimeUnit.MINUTES,
            new SynchronousQueue<>(),
            task -> {
              Thread thread = new Thread(task, "mechservice-" + name);
              thread.setDaemon(true);
              return thread;
            });
    try {
      HttpServer server = HttpServer.create(address, 0);
      server.setExecutor(threads);
      return new BoundedHttp(server, threads);
    } catch (BindException e) {
      if (isOfThisMachine(address.getAddress())) {
        throw new PortInUseException(
            address.getAddress().getHostAddress() + ":" + address.getPort(), e);
      }
      throw new IllegalArgumentException(
          MessageCode.LISTEN_ADDRESS
              + " cannot listen on "
              + address.getHostString()
              + ": it is no address of this machine",
          e);
    } catch (IOException e) {
      throw new IllegalStateException("no port of " + address + " can be opened", e);
    }
  }

  private static boolean isOfThisMachine(InetAddress address) {
    try {
      return address.isAnyLocalAddress() || NetworkInterface.getByInetAddress(address) != null;
    } catch (SocketException e) {
      return true;
    }
  }

  private static InetAddress loopback() {
    try {
      return InetAddress.getByAddress(new byte[] {127, 0, 0, 1});
    } catch (IOException e) {
      throw new IllegalStateException("four bytes are an address", e);
    }
  }

  /** Serves a path and all below it. */
  public void serve(String path, HttpHandler handler) {
    server.createContext(path, handler);
  }

  public void start() {
    server.start();
  }

  /** Returns the port it listens on. */
  public int port() {
    return server.getAddress().getPort();
  }

  /** Closes the port and all connections. */
  @Override
  public void close() {
    server.stop(0);
    threads.shutdownNow();
  }
}
