package org.mechservice.orb;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.UnknownHostException;
import java.nio.channels.Selector;
import java.security.cert.X509Certificate;
import java.util.Map;
import java.util.Optional;
import java.util.Properties;
import java.util.concurrent.atomic.AtomicBoolean;
import org.jacorb.util.SelectorManager;
import org.mechservice.idl.HostRegistry;
import org.mechservice.idl.HostRegistryHelper;
import org.mechservice.idl.IMechClient;
import org.mechservice.idl.IMechClientHelper;
import org.mechservice.idl.IMechClientOperations;
import org.mechservice.idl.IMechClientPOATie;
import org.mechservice.idl.MechAdmin;
import org.mechservice.idl.MechAdminHelper;
import org.mechservice.idl.MechServer;
import org.mechservice.idl.MechSim;
import org.mechservice.idl.MechSimHelper;
import org.mechservice.idl.ServerInfo;
import org.mechservice.orb.connection.Endpoint;
import org.mechservice.orb.connection.OrbField;
import org.mechservice.orb.connection.OutboundAllowList;
import org.mechservice.orb.connection.ReplyMemory;
import org.mechservice.orb.tls.TlsIdentity;
import org.mechservice.orb.tls.TlsPeers;
import org.mechservice.solver.catalogue.MessageCode;
import org.omg.CORBA.INITIALIZE;
import org.omg.CORBA.ORB;
import org.omg.CORBA.UserException;
import org.omg.PortableServer.Servant;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * An ORB set up safely for one of three roles.
 *
 * <ul>
 *   <li>A <b>client</b> connects to servers and serves callbacks over its own connections:
 *       <pre>{@code
 * try (ServiceOrb orb = ServiceOrb.client()) {
 *   MechServer server = orb.connect("127.0.0.1:15000");
 *   IMechClient callbacks = orb.export(myCallbacks);
 *   MechSim session = server.createSession("me", "", callbacks);
 * }
 * }</pre>
 *   <li>A <b>server</b> listens on one address and publishes the objects of {@link ServiceKey}.
 *   <li>A <b>host</b> listens on one address and registers at a server.
 * </ul>
 *
 * Servers and hosts connect only to the addresses in {@link #outbound()}. Thread-safe; no thread is
 * left after {@link #close()}.
 */
public final class ServiceOrb implements AutoCloseable {
  private static final Logger LOG = LoggerFactory.getLogger(ServiceOrb.class);
  private static final OrbField<Selector> SELECTOR =
      new OrbField<>(SelectorManager.class, "selector", Selector.class);

  private static final int LONGEST_ADMIN_CALL_SECONDS = 30;

  /** Longest wait for the set-up of a model, s. */
  public static final int LONGEST_SET_UP_SECONDS = 3600;

  private final OrbThreads threads = new OrbThreads();
  private final ORB orb;
  private final ObjectAdapters adapters;
  private final Peers peers;
  private final AtomicBoolean closed = new AtomicBoolean();

  private ServiceOrb(Properties properties, boolean orderedCalls, Peers peers) {
    this.peers = peers;
    OrbLog.quieten();
    orb = threads.call(() -> ORB.init(new String[0], properties));
    boolean opened = false;
    try {
      adapters = threads.call(() -> ObjectAdapters.open(orb, orderedCalls));
      opened = true;
    } finally {
      if (!opened) {
        end(orb);
        peers.close();
      }
    }
  }

  /** Starts an ORB for a client without encryption. */
  public static ServiceOrb client() {
    return client(Optional.empty());
  }

  /**
   * Starts an ORB for a client. Its callbacks are called one at a time, in order.
   *
   * @param identity of the client; empty: its connections are not encrypted
   */
  public static ServiceOrb client(Optional<TlsIdentity> identity) {
    Peers peers = Peers.ofClient(identity);
    return new ServiceOrb(OrbProperties.client(peers), true, peers);
  }

  /**
   * Starts an ORB for a server.
   *
   * @throws PortInUseException if the address is taken or not this machine's
   */
  public static ServiceOrb server(ListenAddress address) {
    Peers peers = Peers.ofServer(address.tls());
    return listening(address, OrbProperties.server(address, peers), peers);
  }

  /**
   * Starts an ORB for a host.
   *
   * @throws PortInUseException if the address is taken or not this machine's
   */
  public static ServiceOrb host(ListenAddress address) {
    Peers peers = Peers.ofServer(address.tls());
    return listening(address, OrbProperties.host(address, peers), peers);
  }

  private static ServiceOrb listening(ListenAddress address, Properties properties, Peers peers) {
    requireFree(address);
    try {
      return new ServiceOrb(properties, false, peers);
    } catch (INITIALIZE e) {
      throw new PortInUseException(address.toString(), e);
    }
  }

  // The ORB's own message names neither the address nor the reason.
  private static void requireFree(ListenAddress address) {
    try (ServerSocket probe =
        new ServerSocket(address.port(), 1, InetAddress.getByName(address.host()))) {
      probe.getLocalPort();
    } catch (IOException e) {
      throw new PortInUseException(address.toString(), e);
    }
  }

  /**
   * Connects to a server and makes sure that it is one.
   *
   * @param url {@code host:port}, {@code corbaloc:iiop:1.2@host:port/MechServer}, {@code
   *     corbaname:iiop:1.2@host:port#MechServer}, {@code IOR:...} or the name of a file that holds
   *     an IOR; without a port, 15000 is meant
   * @throws ServiceUnreachableException if no process answers there within seconds (S-002) or
   *     something that is not a MechService of this API version (S-005), or the naming service does
   *     not know (S-020)
   * @throws IllegalArgumentException with code S-006 if the URL is none
   */
  public MechServer connect(String url) {
    return connectTo(url).server();
  }

  /**
   * A server that answered.
   *
   * @param server its object
   * @param info of the server
   */
  public record Connected(MechServer server, ServerInfo info) {}

  /**
   * Connects to a server like {@link #connect}, and returns its answer too, which took a round
   * trip.
   */
  public Connected connectTo(String url) {
    ServerLocation location = found(url);
    return new Connected(location.connect(), location.requireService());
  }

  /**
   * Connects to the administration of a server. Its calls come back within half a minute, with an
   * answer or with {@link org.omg.CORBA.TIMEOUT}.
   *
   * @throws ServiceUnreachableException as {@link #connect}
   */
  public MechAdmin connectAdmin(String url) {
    org.omg.CORBA.Object admin = located(url).object(ServiceKey.ADMIN);
    return MechAdminHelper.unchecked_narrow(
        CallTimeouts.within(LONGEST_ADMIN_CALL_SECONDS, orb, admin));
  }

  /**
   * Returns the same session, with calls that wait as long as the set-up of a model may take:
   * {@link #LONGEST_SET_UP_SECONDS}.
   */
  public MechSim patient(MechSim session) {
    return MechSimHelper.unchecked_narrow(
        CallTimeouts.within(LONGEST_SET_UP_SECONDS, orb, session));
  }

  /**
   * Connects to the host registry of a server. A host's own address list is widened by the server's
   * address.
   *
   * @throws ServiceUnreachableException as {@link #connect}
   */
  public HostRegistry connectRegistry(String url) {
    return HostRegistryHelper.unchecked_narrow(located(url).object(ServiceKey.REGISTRY));
  }

  private ServerLocation located(String written) {
    ServerLocation location = found(written);
    location.requireService();
    return location;
  }

  private ServerLocation found(String written) {
    ServiceUrl url = ServiceUrl.parse(written);
    url.requireFits(peers.tls().isPresent());
    if (!url.isReference()) {
      allow(url.host(), url.port());
    }
    ServerLocation location = ServerLocation.of(orb, url, peers.tls());
    allow(location.endpoint().host(), location.endpoint().port());
    return location;
  }

  private void allow(String host, int port) {
    try {
      peers.outbound().allow(host, port);
      if (peers.tls().isPresent()) {
        peers.tls().get().calledBy(host);
      }
    } catch (UnknownHostException e) {
      throw new ServiceUnreachableException(
          MessageCode.NO_SERVER_ANSWERS
              + " no server at "
              + host
              + ":"
              + port
              + ": no such host; check the name",
          e);
    }
  }

  /**
   * Makes a published object known at a naming service, under the key's own name, in place of an
   * earlier one.
   *
   * @param naming address of the naming service, {@code host:port}
   * @return takes the name away again
   * @throws ServiceUnreachableException with code S-020 if that is not possible
   */
  public Runnable bind(String naming, ServiceKey key) {
    ServiceUrl url = ServiceUrl.parse(naming);
    allow(url.host(), url.port());
    NamingService service = NamingService.at(orb, url.host(), url.port());
    service.bind(key.key(), adapters.published(key));
    return () -> service.unbind(key.key());
  }

  /** Returns the reference of a published object as text that any ORB can read. */
  public String ior(ServiceKey key) {
    return orb.object_to_string(adapters.published(key));
  }

  /**
   * Makes callbacks callable by the servers that get the reference.
   *
   * @param callbacks called one at a time; must not call the server back from within a callback
   */
  public IMechClient export(IMechClientOperations callbacks) {
    return IMechClientHelper.unchecked_narrow(
        activate(new IMechClientPOATie(callbacks)).reference());
  }

  /** Ends callbacks: calls to them fail from now on. */
  public void withdraw(IMechClient callbacks) {
    try {
      adapters.deactivate(callbacks);
    } catch (UserException e) {
      throw new IllegalArgumentException("not exported by this ORB", e);
    }
  }

  /**
   * Makes a servant callable under a random, unguessable id: the reference is the right to call.
   */
  public ActiveObject activate(Servant servant) {
    try {
      return adapters.activate(servant);
    } catch (UserException e) {
      throw new IllegalStateException("the object cannot be made callable", e);
    }
  }

  /**
   * Returns an object that this ORB has handed out, to be called without a connection: the ORB may
   * not connect to itself.
   *
   * @param operations of its interface
   * @throws IllegalArgumentException if another ORB has handed it out
   */
  public <T> T own(org.omg.CORBA.Object reference, Class<T> operations) {
    try {
      return operations.cast(adapters.servantOf(reference));
    } catch (UserException e) {
      throw new IllegalArgumentException("not handed out by this ORB", e);
    }
  }

  /** Publishes the named objects of a server, all at once. */
  public void publish(Map<ServiceKey, Servant> servants) {
    threads.run(() -> adapters.publish(servants));
  }

  /** Returns the addresses this ORB may connect to. */
  public OutboundAllowList outbound() {
    return peers.outbound();
  }

  /** Returns how many connections others have opened to this ORB and not closed. */
  public int connections() {
    return peers.inbound().count();
  }

  /** Returns how many of these connections are in use, so that none can take their places. */
  public int busyConnections() {
    return peers.inbound().countBusy();
  }

  /** Sets how many connections others may open at once; one too many is closed at once. */
  public void allowConnections(int most) {
    peers.inbound().allow(most);
  }

  /** Returns the memory for answers to calls from others. */
  public ReplyMemory replyRoom() {
    return peers.inbound().room();
  }

  /** Returns where this ORB listens, or listened before it was closed. */
  public Endpoint endpoint() {
    return adapters.endpoint();
  }

  /**
   * Returns the endpoint that a reference names.
   *
   * @throws IllegalArgumentException with code S-006 if the reference names no address
   */
  public Endpoint endpointOf(org.omg.CORBA.Object reference) {
    return Endpoint.of(orb, orb.object_to_string(reference));
  }

  /** Returns the identity of this process, if its connections are encrypted. */
  public Optional<TlsIdentity> identity() {
    return peers.tls().map(TlsPeers::identity);
  }

  /** Returns what the server at an address has shown when it was connected to. */
  public Optional<X509Certificate> certificateAt(Endpoint endpoint) {
    return peers.tls().flatMap(tls -> tls.shownAt(endpoint));
  }

  /** Returns a reference as text that any ORB can read, {@code IOR:...}. */
  public String toIor(org.omg.CORBA.Object reference) {
    return orb.object_to_string(reference);
  }

  /** Returns the reference that {@link #toIor} of any ORB wrote, without connecting to it yet. */
  public org.omg.CORBA.Object fromIor(String ior) {
    return orb.string_to_object(ior);
  }

  /** Returns the URL of a published object. */
  public String url(ServiceKey key) {
    return ServiceUrl.corbaloc(endpoint(), key, peers.tls().isPresent());
  }

  /**
   * Ends the ORB: calls in progress are answered, connections and the port are closed. Idempotent;
   * must not be called from within a servant.
   */
  @Override
  public void close() {
    if (closed.compareAndSet(false, true)) {
      threads.closing();
      try {
        adapters.finishCalls();
        disconnect();
        adapters.awaitSilence();
      } catch (UserException e) {
        throw new IllegalStateException("the ORB was closed by somebody else", e);
      } finally {
        end(orb);
      }
    }
  }

  /** The ORB leaves the selector behind its time-outs open, two file descriptors each. */
  private static void end(ORB orb) {
    orb.shutdown(true);
    orb.destroy();
    try {
      SELECTOR.get(((org.jacorb.orb.ORB) orb).getSelectorManager()).close();
    } catch (IOException e) {
      LOG.warn(MessageCode.UNCLEAN_CLOSE + " a selector does not close: {}", e.toString());
    }
  }

  /**
   * Closes port and connections. An object adapter that is being destroyed must not get new calls:
   * with its queue full, the connection's thread would wait for room, holding the lock that the
   * destruction needs.
   */
  private void disconnect() {
    org.jacorb.orb.ORB own = (org.jacorb.orb.ORB) orb;
    own.getBasicAdapter().stopListeners();
    own.getClientConnectionManager().shutdown();
    peers.close();
  }
}
