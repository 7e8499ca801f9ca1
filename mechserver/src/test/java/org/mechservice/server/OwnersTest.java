package org.mechservice.server;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Method;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.mechservice.idl.IMechSimRemote;
import org.mechservice.idl.IMechSimRemoteHelper;
import org.mechservice.idl.IMechSimRemoteOperations;
import org.mechservice.idl.MechSim;
import org.mechservice.idl.MechSimHelper;
import org.mechservice.idl.MechSimHost;
import org.mechservice.idl.MechSimHostHelper;
import org.mechservice.idl.MechSimHostOperations;
import org.mechservice.idl.MechSimOperations;
import org.mechservice.idl.ModelFile;
import org.mechservice.idl.NameValue;
import org.mechservice.idl.NotAuthorized;
import org.mechservice.idl.OPT_CONTINUES;
import org.mechservice.idl.ResultCursor;
import org.mechservice.idl.ResultCursorHelper;
import org.mechservice.idl.ResultCursorOperations;
import org.mechservice.idl.ServiceEvent;
import org.mechservice.idl.SimState;
import org.mechservice.orb.ServiceOrb;
import org.mechservice.orb.testing.AnyOperation;
import org.mechservice.orb.testing.Eventually;
import org.mechservice.orb.tls.Role;
import org.mechservice.orb.tls.TlsIdentity;
import org.mechservice.server.hosts.PlacementPolicy;
import org.mechservice.server.keys.KeyFolder;
import org.mechservice.sim.host.HostOptions;
import org.mechservice.sim.host.HostSettings;
import org.mechservice.sim.host.SimHostProcess;
import org.mechservice.sim.service.testing.PacedSolver;
import org.omg.CORBA.NO_PERMISSION;
import org.omg.CORBA.UserException;

/**
 * Over TLS everything in a session belongs to the user who opened it. Another user who holds every
 * reference and knows every id is refused by every operation, on the server and on its host, and
 * written down.
 */
@Tag("slow")
class OwnersTest {
  @TempDir private static Path keys;
  private static MechServerProcess server;
  private static SimHostProcess host;
  private static ServiceOrb alice;
  private static ServiceOrb bob;
  private static ServiceOrb root;
  private static MechSim session;
  private static IMechSimRemote run;
  private static ResultCursor rows;

  @BeforeAll
  static void start() throws Exception {
    KeyFolder folder = KeyFolder.open(keys);
    folder.localServer();
    folder.user("alice", Role.CLIENT);
    folder.user("bob", Role.CLIENT);
    folder.user("root", Role.ADMIN);
    server =
        MechServerProcess.start(
            new ServerSettings(
                "127.0.0.1",
                0,
                new HostOptions("own", 1),
                PlacementPolicy.LEAST_LOADED,
                Optional.empty(),
                Optional.empty(),
                identity("server"),
                Optional.empty(),
                Optional.empty()),
            Farm.STEADY,
            Farm.ENDLESS_HOST);
    host =
        SimHostProcess.start(
            new HostSettings(
                List.of(server.url()),
                "127.0.0.1",
                0,
                new HostOptions("other", 2),
                identity("server")),
            PacedSolver.endless());
    alice = ServiceOrb.client(identity("alice"));
    bob = ServiceOrb.client(identity("bob"));
    root = ServiceOrb.client(identity("root"));
    session = alice.connect(server.url()).createSession("x", "other", null);
    run = Farm.running(session);
    rows = run.openResults(new String[0]);
  }

  @AfterAll
  static void stop() {
    alice.close();
    bob.close();
    root.close();
    host.close();
    server.close();
  }

  private static Optional<TlsIdentity> identity(String name) {
    return Optional.of(TlsIdentity.load(keys.resolve(name)));
  }

  /** The same object as another user sees it who was handed the reference. */
  private static <T> T handedTo(
      ServiceOrb other, org.omg.CORBA.Object reference, Function<org.omg.CORBA.Object, T> narrow) {
    return narrow.apply(other.fromIor(alice.toIor(reference)));
  }

  /** Calls every operation and returns the names of those that were not refused. */
  private static List<String> allowed(Class<?> operations, Object object) throws Exception {
    List<String> allowed = new ArrayList<>();
    for (Method operation : operations.getMethods()) {
      Object[] arguments = AnyOperation.arguments(operation);
      try {
        operation.invoke(object, arguments);
        allowed.add(operation.getName());
      } catch (InvocationTargetException e) {
        if (!AnyOperation.isRefusal(e.getCause())) {
          allowed.add(operation.getName() + ": " + e.getCause());
        }
      }
    }
    return allowed;
  }

  @Test
  void noOperationOfAnothersSessionIsAllowed() throws Exception {
    MechSim others = handedTo(bob, session, MechSimHelper::unchecked_narrow);
    assertThat(allowed(MechSimOperations.class, others)).isEmpty();
    assertThat(session.sessionId()).isNotEmpty();
  }

  @Test
  void noOperationOfAnothersSimulationIsAllowed() throws Exception {
    IMechSimRemote others = handedTo(bob, run, IMechSimRemoteHelper::unchecked_narrow);
    assertThat(allowed(IMechSimRemoteOperations.class, others)).isEmpty();
    assertThat(run.getProgress().state).isEqualTo(SimState.SIM_RUNNING);
  }

  @Test
  void noOperationOfAnothersCursorIsAllowed() throws Exception {
    ResultCursor others = handedTo(bob, rows, ResultCursorHelper::unchecked_narrow);
    assertThat(allowed(ResultCursorOperations.class, others)).isEmpty();
    assertThat(rows.channels()).isNotEmpty();
  }

  @Test
  void idsGiveNoRightEither() throws Exception {
    String sessionId = session.sessionId();
    String simId = run.simId();
    for (ServiceOrb user : List.of(alice, root)) {
      assertThat(user.connect(server.url()).findSession(sessionId).sessionId())
          .isEqualTo(sessionId);
      assertThat(user.connect(server.url()).findSimulation(simId).simId()).isEqualTo(simId);
    }
    assertThatThrownBy(() -> bob.connect(server.url()).findSession(sessionId))
        .isInstanceOfSatisfying(
            NotAuthorized.class, refused -> assertThat(refused.code).isEqualTo("S-167"));
    assertThatThrownBy(() -> bob.connect(server.url()).findSimulation(simId))
        .isInstanceOfSatisfying(
            NotAuthorized.class, refused -> assertThat(refused.code).isEqualTo("S-167"));
    assertThat(denials())
        .anySatisfy(
            event -> {
              assertThat(event.owner).isEqualTo("bob");
              assertThat(event.text).contains("was refused findSimulation(" + simId + ")");
            });
  }

  /** A client that moves a run says which earlier run it goes on with; that proves nothing. */
  @Test
  void nobodyHidesAnothersRunByClaimingItsId() throws Exception {
    String simId = run.simId();
    MechSim own = bob.connect(server.url()).createSession("bob", "own", null);
    own.loadModel(Pendulum.file(), new ModelFile[0]);
    own.createSimulation(new NameValue[] {new NameValue(OPT_CONTINUES.value, simId)}, null);
    for (int i = 0; i < 20; i++) {
      assertThat(alice.connect(server.url()).findSimulation(simId).simId()).isEqualTo(simId);
    }
    own.destroy();
  }

  @Test
  void administratorsMayUseWhatBelongsToUsers() {
    IMechSimRemote seen = handedTo(root, run, IMechSimRemoteHelper::unchecked_narrow);
    assertThat(seen.getProgress().state).isEqualTo(SimState.SIM_RUNNING);
  }

  @Test
  void onlyServersCallHosts() throws Exception {
    // The reference that a host gives the server, as somebody gets it who registers it. An answer
    // other than a refusal, as of a host that is not there, counts as allowed.
    MechSimHost stolen =
        MechSimHostHelper.unchecked_narrow(bob.fromIor(alice.toIor(host.reference())));
    assertThat(allowed(MechSimHostOperations.class, stolen)).isEmpty();
  }

  @Test
  void refusalsNameWhoWasRefused() throws Exception {
    IMechSimRemote others = handedTo(bob, run, IMechSimRemoteHelper::unchecked_narrow);
    assertThatThrownBy(others::cancel).isInstanceOf(NO_PERMISSION.class);
    String refusal = "\"bob\" \\(client\\) at 127\\.[0-9.:]+ was refused cancel\\(\\): .*";
    Eventually.holds(
        () ->
            denials().stream()
                .anyMatch(
                    event ->
                        event.code.equals("S-167")
                            && event.owner.equals("bob")
                            && event.text.matches(refusal)));
  }

  private static List<ServiceEvent> denials() throws UserException {
    return Arrays.stream(root.connectAdmin(server.url()).events(0, 5000, 0))
        .filter(event -> event.kind.equals("denied"))
        .toList();
  }
}
