package org.mechservice.client;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.security.PublicKey;
import java.security.cert.Certificate;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.function.Function;
import org.mechservice.client.failure.InvalidModelException;
import org.mechservice.client.failure.InvalidOptionException;
import org.mechservice.client.failure.LimitExceededException;
import org.mechservice.client.failure.ModelMessage;
import org.mechservice.client.failure.NotFoundException;
import org.mechservice.client.failure.RemoteCalls;
import org.mechservice.client.failure.ServerLostException;
import org.mechservice.client.failure.ServiceException;
import org.mechservice.client.failure.SetUpCalls;
import org.mechservice.client.jar.AcceptedSolvers;
import org.mechservice.client.jar.JarCache;
import org.mechservice.client.jar.JarOrigin;
import org.mechservice.client.run.LeaseRenewal;
import org.mechservice.client.run.ListenerCallbacks;
import org.mechservice.client.run.ReattachedRun;
import org.mechservice.client.run.RemoteRun;
import org.mechservice.guard.UserCode;
import org.mechservice.idl.DiagnosticSeqHolder;
import org.mechservice.idl.IMechClient;
import org.mechservice.idl.IMechSimRemote;
import org.mechservice.idl.MechSim;
import org.mechservice.idl.ModelFile;
import org.mechservice.orb.ServiceOrb;
import org.mechservice.orb.connection.Endpoint;
import org.mechservice.orb.tls.TlsIdentity;

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
 * <p>{@link #read} returns a model with the verbs of the library in process instead, so that a
 * program that simulates and analyses models here does so at a server when this one line changes:
 *
 * <pre>{@code
 * RemoteModel car = service.read(Path.of("car.xml")).set("k", 2.1e4).until(5);
 * double[] height = car.simulate().column("height.q");
 * }</pre>
 *
 * <p>Errors are {@link ServiceException}s: refusals with the server's own code and text, and {@link
 * ServerLostException} as soon as the server cannot be reached.
 */
public final class MechConnection implements AutoCloseable {
  private final ServiceOrb orb;
  private final ServerSelection servers;
  private final JarCache cache;
  private final AcceptedSolvers solvers = new AcceptedSolvers();
  private final LeaseRenewal leases = new LeaseRenewal();
  private final double connectSeconds;

  /** Sessions of models, which end with the connection. */
  private final Queue<MechSession> models = new ConcurrentLinkedQueue<>();

  /** Whether the server is part of this program. */
  private final boolean own;

  private MechConnection(String address, JarCache cache, ServiceOrb orb, boolean own) {
    this.orb = orb;
    this.cache = cache;
    this.own = own;
    Stopwatch watch = new Stopwatch();
    servers = new ServerSelection(orb, address);
    connectSeconds = watch.lap();
  }

  /**
   * Connects to a server without encryption; fetched JARs are kept in the user's cache.
   *
   * @param address {@code host:port} or a URL such as {@code
   *     corbaloc:iiop:1.2@host:port/MechServer}; several, separated by commas, where the next is
   *     used when one is gone
   * @throws ServerLostException if no MechService answers there
   * @throws InvalidOptionException if the address is none
   */
  public static MechConnection open(String address) {
    return open(address, JarCache.ofUser());
  }

  /**
   * Connects to a server without encryption.
   *
   * @param address {@code host:port} or a URL, or several
   * @param cache keeps fetched JARs
   * @throws ServerLostException if no MechService answers there
   * @throws InvalidOptionException if the address is none
   */
  public static MechConnection open(String address, JarCache cache) {
    return open(address, cache, Optional.empty());
  }

  /**
   * Connects to a server.
   *
   * @param address {@code host:port} or a URL, or several
   * @param cache keeps fetched JARs
   * @param identity identity of the client for TLS; JARs are then accepted only with the server's
   *     signature. Empty for a connection without encryption
   * @throws ServerLostException if no MechService answers there
   * @throws InvalidOptionException if the address is none
   */
  public static MechConnection open(
      String address, JarCache cache, Optional<TlsIdentity> identity) {
    return open(address, cache, identity, false);
  }

  /**
   * Connects to a server that is part of this program: the models that it generates are the
   * program's own, and a local run computes them in this process.
   *
   * @param address URL on the loopback interface
   * @throws ServerLostException if it does not answer
   */
  public static MechConnection openOwn(String address) {
    return open(address, JarCache.ofUser(), Optional.empty(), true);
  }

  private static MechConnection open(
      String address, JarCache cache, Optional<TlsIdentity> identity, boolean own) {
    ServiceOrb orb = ServiceOrb.client(identity);
    try {
      return new MechConnection(address, cache, orb, own);
    } catch (ServiceException e) {
      orb.close();
      throw e;
    }
  }

  /** Returns whether the server is part of this program. */
  boolean isOwn() {
    return own;
  }

  /** Returns the description that the server in use gave when the connection was made. */
  public ServiceDescription service() {
    return servers.chosen().description();
  }

  /**
   * Returns the number of simulations that the hosts of the server run at once.
   *
   * @throws ServerLostException if the server is lost
   */
  public int places() {
    return callServer(server -> ServiceDescription.of(server.calls().get(server.server()::getInfo)))
        .places();
  }

  /**
   * Opens a session on any host with a free place.
   *
   * @throws LimitExceededException if the server takes no more sessions
   */
  public MechSession openSession() {
    return openSession("");
  }

  /**
   * Opens a session on a host.
   *
   * @param hostName the host's name at the server; empty for any host with a free place
   * @throws NotFoundException if the server knows no such host
   * @throws LimitExceededException if the server takes no more sessions
   */
  public MechSession openSession(String hostName) {
    Stopwatch watch = new Stopwatch();
    return callServer(
        server -> {
          MechSim session = createSession(server, hostName);
          return opened(server, session, connectSeconds + watch.lap());
        });
  }

  /**
   * Sends a model without classes of users to the server and returns it.
   *
   * @see #read(Path, UserCode)
   */
  public RemoteModel read(Path file) throws IOException {
    return read(file, UserCode.NONE);
  }

  /**
   * Sends a model to the server and returns it with the verbs of the library in process.
   *
   * @param file MechML file
   * @param consent the folders whose classes of forces are sent, and run there or here
   * @throws IOException if a file cannot be read
   * @throws InvalidModelException if the model cannot be used; says what, where and what to write
   *     instead
   * @throws LimitExceededException if the server takes no more sessions
   */
  public RemoteModel read(Path file, UserCode consent) throws IOException {
    MechSession session = openSession();
    models.add(session);
    session.loadModel(file, consent);
    return new RemoteModel(session, file.toString());
  }

  /**
   * Sends a model that is no file.
   *
   * @param name its name in messages
   * @param mechml its text
   * @throws InvalidModelException if the model cannot be used
   * @throws LimitExceededException if the server takes no more sessions
   */
  public RemoteModel of(String name, String mechml) {
    MechSession session = openSession();
    models.add(session);
    session.loadModel(name, mechml.getBytes(StandardCharsets.UTF_8));
    return new RemoteModel(session, name);
  }

  /** Calls the server in use, or the next one if that server is lost. */
  private <T> T callServer(Function<ServerSelection.Chosen, T> question) {
    ServerSelection.Chosen server = servers.chosen();
    try {
      return question.apply(server);
    } catch (ServerLostException e) {
      return question.apply(servers.instead(server, e));
    }
  }

  /** Returns the calls of a session that set a model up, which may take long. */
  SetUpCalls setUpCalls(RemoteCalls calls, MechSim session) {
    return new SetUpCalls(
        calls,
        session,
        orb.patient(session),
        Duration.ofSeconds(ServiceOrb.LONGEST_SET_UP_SECONDS),
        SetUpCalls.INTERVAL);
  }

  private MechSession opened(ServerSelection.Chosen server, MechSim session, double seconds) {
    return new MechSession(this, callsTo(session, server), server.description(), session, seconds);
  }

  /**
   * Opens a session for a run that leaves its host: at the server in use or, if that has no free
   * place or is lost, at the next server of this connection.
   *
   * @throws ServiceException if none has a free place; the refusal of the first server
   */
  MechSession openSessionAnywhere() {
    Stopwatch watch = new Stopwatch();
    ServerSelection.Chosen first = servers.chosen();
    try {
      return opened(first, createSession(first, ""), watch.lap());
    } catch (LimitExceededException | ServerLostException refused) {
      for (ServerSelection.Chosen next : servers.others(first)) {
        try {
          return opened(next, createSession(next, ""), watch.lap());
        } catch (LimitExceededException | ServerLostException e) {
          refused.addSuppressed(e);
        }
      }
      throw refused;
    }
  }

  /**
   * Attaches to a run by its id, on any host of any server: a run in progress, or one that has
   * ended and is kept. A run that has moved is also found by its earlier ids.
   *
   * @param simId the run's {@linkplain RemoteRun#id identity}
   * @throws NotFoundException if there is no such run, or it is no longer kept
   * @throws LimitExceededException if the host takes no more sessions
   */
  public ReattachedRun reattach(String simId) {
    Found found = callServer(server -> findAnywhere(server, simId));
    return new ReattachedRun(callsTo(found.run(), found.by()), leases, found.run());
  }

  /**
   * A run and the server that has found it; the server may be reachable when the host of the run is
   * not.
   */
  private record Found(ServerSelection.Chosen by, IMechSimRemote run) {}

  private Found findAnywhere(ServerSelection.Chosen first, String simId) {
    try {
      return find(first, simId);
    } catch (NotFoundException notThere) {
      for (ServerSelection.Chosen next : servers.others(first)) {
        try {
          return find(next, simId);
        } catch (NotFoundException | ServerLostException e) {
          notThere.addSuppressed(e);
        }
      }
      throw notThere;
    }
  }

  private static Found find(ServerSelection.Chosen server, String simId) {
    return new Found(server, server.calls().get(() -> server.server().findSimulation(simId)));
  }

  /**
   * Translates a model of another format into MechML at the server.
   *
   * @param file a robot in URDF, SDF or MJCF
   * @throws IOException if the file cannot be read
   * @throws InvalidModelException if it cannot be used; the messages name the places
   * @throws NotAvailableException if the server does not support its format
   */
  public ImportedModel importModel(Path file) throws IOException {
    String name = String.valueOf(file.getFileName());
    ModelFile foreign = new ModelFile(name, NamedFile.of(file));
    DiagnosticSeqHolder losses = new DiagnosticSeqHolder();
    try {
      ModelFile model =
          callServer(
              server -> server.calls().get(() -> server.server().importModel(foreign, losses)));
      return new ImportedModel(
          new String(model.content, StandardCharsets.UTF_8),
          located(ModelMessage.listOf(losses.value), name, file));
    } catch (InvalidModelException e) {
      throw new InvalidModelException(
          e.code(), String.valueOf(e.getMessage()), located(e.messages(), name, file));
    }
  }

  /** Replaces the file's name in messages, which the server knows, by the user's path. */
  private static List<ModelMessage> located(List<ModelMessage> said, String name, Path file) {
    return said.stream()
        .map(m -> m.fileName().equals(name) ? m.inFile(file.toString()) : m)
        .toList();
  }

  private static MechSim createSession(ServerSelection.Chosen server, String hostName) {
    String user = System.getProperty("user.name");
    return server.calls().get(() -> server.server().createSession(user, hostName, null));
  }

  /**
   * Returns the calls to a session, whose host may have its own address, which messages then name.
   */
  private RemoteCalls callsTo(org.omg.CORBA.Object object, ServerSelection.Chosen server) {
    Endpoint place = orb.endpointOf(object);
    return place.equals(orb.endpointOf(server.server()))
        ? server.calls()
        : new RemoteCalls(place.toString());
  }

  /** Returns the check that a JAR comes from the host of a session. */
  JarOrigin originOf(MechSim session) {
    return new JarOrigin(
        orb.identity().isPresent(),
        orb.certificateAt(orb.endpointOf(session)).map(Certificate::getPublicKey));
  }

  /**
   * Accepts the solver of a server for runs in this process where it differs from the one here, if
   * it is signed with a key. Its classes run with all rights of the user.
   *
   * @param key of the server or host that builds the models
   */
  public void acceptSolversOf(PublicKey key) {
    solvers.accept(key);
  }

  AcceptedSolvers acceptedSolvers() {
    return solvers;
  }

  LeaseRenewal leases() {
    return leases;
  }

  JarCache cache() {
    return cache;
  }

  IMechClient export(ListenerCallbacks listener) {
    return orb.export(listener);
  }

  /**
   * Ends the connection and the sessions of its models. The server destroys other open sessions
   * when their leases expire.
   */
  @Override
  public void close() {
    models.forEach(MechSession::close);
    leases.close();
    orb.close();
  }
}
