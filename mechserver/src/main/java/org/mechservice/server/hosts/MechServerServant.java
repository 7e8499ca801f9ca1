package org.mechservice.server.hosts;

import java.util.Arrays;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.concurrent.atomic.AtomicBoolean;
import org.jspecify.annotations.Nullable;
import org.mechservice.idl.API_VERSION;
import org.mechservice.idl.DiagnosticSeqHolder;
import org.mechservice.idl.IMechClient;
import org.mechservice.idl.IMechSimRemote;
import org.mechservice.idl.InvalidModel;
import org.mechservice.idl.Limit;
import org.mechservice.idl.LimitExceeded;
import org.mechservice.idl.MechServerOperations;
import org.mechservice.idl.MechSim;
import org.mechservice.idl.ModelFile;
import org.mechservice.idl.NotAuthorized;
import org.mechservice.idl.NotAvailable;
import org.mechservice.idl.NotFound;
import org.mechservice.idl.ServerFailure;
import org.mechservice.idl.ServerInfo;
import org.mechservice.orb.ServiceVersion;
import org.mechservice.orb.connection.InboundCall;
import org.mechservice.orb.tls.Caller;
import org.mechservice.sim.service.contract.ContractErrors;
import org.mechservice.sim.service.contract.ShortText;
import org.mechservice.sim.service.library.ClassLibrary;
import org.mechservice.sim.service.limits.CurrentLimits;
import org.mechservice.sim.service.limits.HostLimit;
import org.mechservice.sim.service.limits.SetUpPlaces;
import org.mechservice.sim.service.session.SessionNames;
import org.mechservice.sim.service.setup.SetUpWorkers;
import org.mechservice.sim.service.setup.SetUps;
import org.omg.CORBA.OBJECT_NOT_EXIST;

/** The servant of the interface for clients. */
public final class MechServerServant implements MechServerOperations {
  private static final String[] CAPABILITIES = {
    "formulation=DTR",
    "formulation=DSR",
    "formulation=RR",
    "formulation=RR-JF",
    "closure=projection",
    "closure=penalty",
    "integrator=ode113",
    "integrator=DE",
    "integrator=ode15s",
    "integrator=ode15sR",
    "integrator=switching",
    "jar=model",
    "jar=standalone",
    "import=urdf",
    "option=continues",
    "option=analysis",
    "option=inputs",
    "option=silence"
  };

  private final String name;
  private final HostDirectory directory;
  private final Placement placement;
  private final CurrentLimits limits;
  private final SetUpWorkers setUps;
  private final SetUpPlaces places;
  private final long startedAt = System.currentTimeMillis();
  private final AtomicBoolean draining = new AtomicBoolean();

  public MechServerServant(
      String name, HostDirectory directory, Placement placement, CurrentLimits limits) {
    this.name = name;
    this.directory = directory;
    this.placement = placement;
    this.limits = limits;
    setUps = new SetUpWorkers(limits, new ClassLibrary());
    places = new SetUpPlaces(limits);
  }

  /** Ends the processes that read models of other formats. */
  public void close() {
    setUps.close();
  }

  /** Takes no new sessions, or takes them again. */
  public void setDraining(boolean drain) {
    draining.set(drain);
  }

  public boolean draining() {
    return draining.get();
  }

  @Override
  public ServerInfo getInfo() {
    int places =
        directory.all().stream()
            .filter(RegisteredHost::open)
            .mapToInt(RegisteredHost::capacity)
            .sum();
    String[] capabilities = Arrays.copyOf(CAPABILITIES, CAPABILITIES.length + 1);
    capabilities[CAPABILITIES.length] = "places=" + places;
    return new ServerInfo(name, API_VERSION.value, ServiceVersion.CURRENT, startedAt, capabilities);
  }

  /**
   * Opens a session as clients do, and ends it.
   *
   * @return why it did not work; empty if it did
   */
  public Optional<String> tryOut() {
    return draining.get()
        ? Optional.of("the server is being emptied")
        : placement.tryOut(SessionNames.HEALTH_CHECK);
  }

  @Override
  public MechSim createSession(String claimedName, String hostName, @Nullable IMechClient client)
      throws LimitExceeded, NotFound, ServerFailure {
    String clientName = SessionNames.ofClient(Caller.current().name(ShortText.name(claimedName)));
    if (draining.get()) {
      throw ContractErrors.noPlace(
          "server " + name + " is being emptied and takes no new sessions");
    }
    return hostName.isEmpty()
        ? placement.anywhere(clientName, client)
        : placement.on(hostName, clientName, client);
  }

  @Override
  public MechSim findSession(String sessionId) throws NotAuthorized, NotFound {
    String user = Caller.current().confinedTo().orElse("");
    return directory
        .search(host -> host.findSession(sessionId, user))
        .orElseThrow(
            () ->
                ContractErrors.notFound(
                    "there is no session " + sessionId + directory.silentHosts()));
  }

  @Override
  public IMechSimRemote findSimulation(String simId) throws NotAuthorized, NotFound {
    String user = Caller.current().confinedTo().orElse("");
    return directory
        .search(host -> host.findSimulation(simId, user))
        .orElseThrow(() -> ContractErrors.notFound(absence(simId)));
  }

  private String absence(String simId) {
    return directory
        .runs()
        .endOf(simId)
        .map(fate -> simId + ": " + fate + "; if the host comes back with its folder, try again")
        .orElseGet(() -> "there is no simulation " + simId + directory.silentHosts());
  }

  @Override
  public ModelFile importModel(ModelFile foreign, DiagnosticSeqHolder losses)
      throws InvalidModel, NotAvailable, LimitExceeded {
    long most = limits.now().of(HostLimit.MODEL_BYTES);
    int bytes = foreign.content.length;
    if (bytes > most) {
      throw HostLimit.MODEL_BYTES.refusal(
          most, bytes, "the file has " + bytes + " bytes; this server takes at most " + most);
    }
    InboundCall.Bond bond = InboundCall.boundToCaller();
    try {
      SetUps.Translated translated = translate(foreign);
      losses.value = translated.losses();
      return translated.model();
    } catch (CancellationException e) {
      throw new OBJECT_NOT_EXIST("the client has gone, or the server is closing");
    } finally {
      bond.release();
    }
  }

  private SetUps.Translated translate(ModelFile foreign)
      throws InvalidModel, NotAvailable, LimitExceeded {
    SetUpPlaces.Place place = places.enter(SessionNames.ofClient(Caller.current().name("")));
    try {
      return setUps.setUps().translate(foreign);
    } finally {
      places.leave(place);
    }
  }

  @Override
  public Limit[] limits() {
    return limits.now().toLimits();
  }
}
