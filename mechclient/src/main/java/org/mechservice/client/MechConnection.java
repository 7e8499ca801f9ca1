package org.mechservice.client;

import org.mechservice.idl.IMechClient;
import org.mechservice.idl.MechServer;
import org.mechservice.idl.MechSim;
import org.mechservice.orb.Endpoint;
import org.mechservice.orb.ServiceOrb;
import org.mechservice.orb.ServiceUnreachableException;

/**
 * A connection to a MechService. Thread-safe.
 *
 * <pre>{@code
 * try (MechConnection service = MechConnection.open("simulations.example.org:15000");
 *     MechSession session = service.openSession()) {
 *   session.loadModel(Path.of("pendulum.xml"));
 *   try (PreparedRun run = session.prepareRemoteRun(SimulationOptions.asInFile());
 *       ResultFile results = new ResultFile(Path.of("pendulum.csv"))) {
 *     System.out.print(ReportText.format(run.toEnd(results).report()));
 *     results.keep();
 *   }
 * }
 * }</pre>
 *
 * <p>Errors are {@link ServiceException}s: refusals with the server's own code and text, and {@link
 * ServerLostException} as soon as the server cannot be reached.
 */
public final class MechConnection implements AutoCloseable {
  private final ServiceOrb orb;
  private final RemoteCalls calls;
  private final MechServer server;
  private final ServiceDescription service;
  private final JarCache cache;
  private final LeaseRenewal leases = new LeaseRenewal();
  private final double connectSeconds;

  private MechConnection(String address, JarCache cache, ServiceOrb orb) {
    this.orb = orb;
    this.cache = cache;
    calls = new RemoteCalls(address);
    Stopwatch watch = new Stopwatch();
    server = orb.connect(address);
    service = ServiceDescription.of(calls.get(server::getInfo));
    connectSeconds = watch.lap();
  }

  /**
   * Connects to a server; fetched JARs are kept in the user's cache.
   *
   * @param address {@code host:port} or a URL such as {@code
   *     corbaloc:iiop:1.2@host:port/MechServer}
   * @throws ServerLostException if nobody answers there, or something else than a MechService
   * @throws InvalidOptionException if the address is none
   */
  public static MechConnection open(String address) {
    return open(address, JarCache.ofUser());
  }

  /**
   * Connects to a server.
   *
   * @param address {@code host:port} or a URL
   * @param cache keeps fetched JARs
   * @throws ServerLostException if nobody answers there, or something else than a MechService
   * @throws InvalidOptionException if the address is none
   */
  public static MechConnection open(String address, JarCache cache) {
    ServiceOrb orb = ServiceOrb.client();
    try {
      return new MechConnection(address, cache, orb);
    } catch (ServiceUnreachableException e) {
      orb.close();
      String text = String.valueOf(e.getMessage());
      throw new ServerLostException(ServiceException.codeOf(text, "S-030"), text, address);
    } catch (IllegalArgumentException e) {
      orb.close();
      String text = String.valueOf(e.getMessage());
      throw new InvalidOptionException(ServiceException.codeOf(text, "S-030"), text, "server");
    } catch (ServiceException e) {
      orb.close();
      throw e;
    }
  }

  /** Returns what the server said of itself when the connection was made. */
  public ServiceDescription service() {
    return service;
  }

  /**
   * Opens a session wherever there is room.
   *
   * @throws LimitExceededException if the server takes no more sessions
   */
  public MechSession openSession() {
    return openSession("");
  }

  /**
   * Opens a session on a host.
   *
   * @param hostName the host's name at the server; empty: wherever there is room
   * @throws NotFoundException if the server knows no such host
   * @throws LimitExceededException if the server takes no more sessions
   */
  public MechSession openSession(String hostName) {
    Stopwatch watch = new Stopwatch();
    String user = System.getProperty("user.name");
    MechSim session = calls.get(() -> server.createSession(user, hostName, null));
    return new MechSession(this, callsTo(session), session, connectSeconds + watch.lap());
  }

  /** A session may live on a host of its own; messages then name that address. */
  private RemoteCalls callsTo(MechSim session) {
    Endpoint place = orb.endpointOf(session);
    return place.equals(orb.endpointOf(server)) ? calls : new RemoteCalls(place.toString());
  }

  LeaseRenewal leases() {
    return leases;
  }

  JarCache cache() {
    return cache;
  }

  IMechClient export(RunListener listener) {
    return orb.export(new ListenerCallbacks(listener));
  }

  /**
   * Ends the connection. Sessions left open are given up by the server when their lease is over.
   */
  @Override
  public void close() {
    leases.close();
    orb.close();
  }
}
