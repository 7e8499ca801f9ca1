package org.mechservice.server;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.mechservice.idl.Limit;
import org.mechservice.idl.MechAdmin;
import org.mechservice.idl.MechAdminOperations;
import org.mechservice.idl.NotAuthorized;
import org.mechservice.idl.ServiceEvent;
import org.mechservice.orb.ServiceOrb;
import org.mechservice.orb.tls.Role;
import org.mechservice.orb.tls.TlsIdentity;
import org.mechservice.server.hosts.PlacementPolicy;
import org.mechservice.server.keys.KeyFolder;
import org.mechservice.sim.host.HostOptions;
import org.mechservice.sim.host.HostSettings;
import org.mechservice.sim.host.SimHostProcess;
import org.omg.CORBA.IntHolder;
import org.omg.CORBA.UserException;

/**
 * Monitors look, administrators look and act, others do neither: asked over real encrypted sockets,
 * one operation of the administration interface after the other. Whoever is refused is written
 * down.
 */
@Tag("slow")
class RightsTest {
  /** Calls an operation in a way that changes nothing that matters here. */
  private interface Call {
    void on(MechAdmin admin) throws UserException;
  }

  private static final Map<String, Call> LOOKING =
      Map.of(
          "getStatus", MechAdmin::getStatus,
          "listHosts", MechAdmin::listHosts,
          "listSimulations", admin -> admin.listSimulations(0, 10, new IntHolder()),
          "showSimulation", admin -> admin.showSimulation("none"),
          "listSessions", MechAdmin::listSessions,
          "events", admin -> admin.events(0, 1, 0),
          "logs", admin -> admin.logs("", 0, 1),
          "getLimits", admin -> admin.getLimits(""),
          "getPlacement", MechAdmin::getPlacement);
  private static final Map<String, Call> ACTING =
      Map.of(
          "killSimulation", admin -> admin.killSimulation("none", "no reason"),
          "endSessions", admin -> admin.endSessions("nobody", "", "no reason"),
          "setLimits", admin -> admin.setLimits("", new Limit[] {new Limit("cursors", "", 9, "")}),
          "setPlacement", admin -> admin.setPlacement("order"),
          "drain", admin -> admin.drain("none"),
          "undrain", admin -> admin.undrain("none"),
          "shutdownServer", admin -> admin.shutdownServer(1000));

  /**
   * One of each caller, who asks over and over; a handshake takes longer than all that is asked.
   */
  private static final Map<String, ServiceOrb> ORBS = new HashMap<>();

  private static final Map<String, MechAdmin> ADMINS = new HashMap<>();

  @TempDir private static Path keys;
  private static Path auditFile;
  private static MechServerProcess server;

  @BeforeAll
  static void start() {
    KeyFolder folder = KeyFolder.open(keys);
    folder.localServer();
    folder.user("alice", Role.CLIENT);
    folder.user("watcher", Role.MONITOR);
    folder.user("root", Role.ADMIN);
    auditFile = keys.resolve("audit.jsonl");
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
                Optional.of(auditFile)),
            Farm.STEADY,
            HostFactory.INSTALLED);
  }

  @AfterAll
  static void stop() {
    ORBS.values().forEach(ServiceOrb::close);
    server.close();
  }

  private static Optional<TlsIdentity> identity(String name) {
    return Optional.of(TlsIdentity.load(keys.resolve(name)));
  }

  private static Set<String> looking() {
    return LOOKING.keySet();
  }

  private static Set<String> acting() {
    return ACTING.keySet();
  }

  @Test
  void everyOperationIsEitherAQuestionOrAnAction() {
    Set<String> known = new TreeSet<>(LOOKING.keySet());
    known.addAll(ACTING.keySet());
    assertThat(known)
        .containsExactlyInAnyOrderElementsOf(
            Arrays.stream(MechAdminOperations.class.getMethods())
                .map(java.lang.reflect.Method::getName)
                .toList());
  }

  private static MechAdmin adminFor(String who) {
    ServiceOrb orb = ORBS.computeIfAbsent(who, each -> ServiceOrb.client(identity(each)));
    return ADMINS.computeIfAbsent(who, each -> orb.connectAdmin(server.url()));
  }

  private static Optional<NotAuthorized> refusalOfANewConnection(String who, Call call) {
    try (ServiceOrb orb = ServiceOrb.client(identity(who))) {
      return refusal(orb.connectAdmin(server.url()), call);
    }
  }

  /** Who may is answered, if only that there is no such simulation. */
  private static Optional<NotAuthorized> refusal(String who, Call call) {
    return refusal(adminFor(who), call);
  }

  private static Optional<NotAuthorized> refusal(MechAdmin admin, Call call) {
    try {
      call.on(admin);
      return Optional.empty();
    } catch (NotAuthorized refused) {
      return Optional.of(refused);
    } catch (UserException answered) {
      return Optional.empty();
    }
  }

  @MethodSource("looking")
  @ParameterizedTest
  void monitorsAndAdministratorsLookAndOthersDoNot(String operation) {
    Call call = Objects.requireNonNull(LOOKING.get(operation));
    assertThat(refusal("watcher", call)).isEmpty();
    assertThat(refusal("root", call)).isEmpty();
    for (String other : List.of("alice", "server")) {
      NotAuthorized refused = refusal(other, call).orElseThrow();
      assertThat(refused.code).isEqualTo("S-153");
      assertThat(refused.text).contains("is no monitor's");
    }
  }

  @MethodSource("acting")
  @ParameterizedTest
  void onlyAdministratorsAct(String operation) {
    Call call = Objects.requireNonNull(ACTING.get(operation));
    for (String other : List.of("watcher", "alice", "server")) {
      NotAuthorized refused = refusal(other, call).orElseThrow();
      assertThat(refused.code).isEqualTo("S-153");
      assertThat(refused.text).contains("is no admin's");
    }
    if (!operation.equals("shutdownServer")) {
      assertThat(refusal("root", call)).isEmpty();
    }
  }

  @Test
  void monitorsNeitherRunSimulationsNorTakeUpThoseOfOthers() {
    try (ServiceOrb watcher = ServiceOrb.client(identity("watcher"))) {
      assertThat(watcher.connect(server.url()).getInfo().serverName).isEqualTo("own");
      NotAuthorized refused =
          catchThrowableOfType(
              NotAuthorized.class,
              () -> watcher.connect(server.url()).createSession("watcher", "", null));
      assertThat(refused.text).contains("\"watcher\" is no client's");
      assertThatThrownBy(() -> watcher.connect(server.url()).findSimulation("x"))
          .isInstanceOfSatisfying(
              NotAuthorized.class, denied -> assertThat(denied.code).isEqualTo("S-153"));
    }
  }

  @Test
  void onlyServersRegisterHosts() {
    HostSettings intruder =
        new HostSettings(
            List.of(server.url()),
            "127.0.0.1",
            0,
            new HostOptions("intruder", 1),
            identity("alice"));
    assertThatThrownBy(() -> SimHostProcess.start(intruder))
        .hasMessageStartingWith("S-153 the certificate of \"alice\" is no server's");
    assertThat(denials())
        .anySatisfy(event -> assertThat(event.text).contains("was refused registerHost(intruder"));
  }

  private static List<ServiceEvent> denials() {
    try {
      return Arrays.stream(adminFor("root").events(0, 5000, 0))
          .filter(event -> event.kind.equals("denied"))
          .toList();
    } catch (UserException e) {
      throw new AssertionError(e);
    }
  }

  @Test
  void whoIsRefusedIsInTheJournalAndTheAuditLogWithWhatHeWanted() throws Exception {
    Call limits = admin -> admin.setLimits("own", new Limit[] {new Limit("queue", "", 7, "")});
    assertThat(refusal("alice", limits)).isPresent();
    assertThat(denials())
        .anySatisfy(
            event -> {
              assertThat(event.code).isEqualTo("S-153");
              assertThat(event.owner).isEqualTo("alice");
              assertThat(event.text)
                  .matches(
                      "\"alice\" \\(client\\) at 127\\.[0-9.:]+ was refused"
                          + " setLimits\\(own, queue=7\\): the certificate of \"alice\" is no"
                          + " admin's; .*");
            });
    assertThat(adminFor("root").logs("", 0, 1000))
        .anySatisfy(line -> assertThat(line.text).contains("refused setLimits(own, queue=7)"));
    List<JsonObject> lines =
        Files.readAllLines(auditFile).stream()
            .map(line -> JsonParser.parseString(line).getAsJsonObject())
            .toList();
    assertThat(lines)
        .anySatisfy(
            line -> {
              assertThat(line.get("kind").getAsString()).isEqualTo("denied");
              assertThat(line.get("owner").getAsString()).isEqualTo("alice");
              assertThat(line.get("time").getAsString()).startsWith("20");
              assertThat(line.get("text").getAsString()).contains("setLimits(own, queue=7)");
            });
  }

  @Test
  void whatIsSentWithARefusedActionMakesNoLinesOfItsOwn() {
    assertThat(refusal("alice", admin -> admin.killSimulation("x\nS-000 fine", "y"))).isPresent();
    assertThat(denials())
        .anySatisfy(event -> assertThat(event.text).contains("killSimulation(x?S-000 fine, y)"))
        .noneSatisfy(event -> assertThat(event.text).contains("\n"));
  }

  @Test
  void refusedQuestionThatIsRepeatedIsWrittenDownOnce() {
    Map<String, Long> before = counts();
    Call question = admin -> admin.getLimits("own");
    Call action = admin -> admin.drain("own");
    for (int i = 0; i < 18; i++) {
      assertThat(refusal("alice", question)).isPresent();
      assertThat(refusal("alice", action)).isPresent();
    }
    for (int i = 0; i < 2; i++) {
      assertThat(refusalOfANewConnection("alice", question)).isPresent();
      assertThat(refusalOfANewConnection("alice", action)).isPresent();
    }
    Map<String, Long> after = counts();
    assertThat(after.getOrDefault("getLimits()", 0L) - before.getOrDefault("getLimits()", 0L))
        .isLessThanOrEqualTo(1);
    assertThat(after.getOrDefault("drain(own)", 0L) - before.getOrDefault("drain(own)", 0L))
        .isEqualTo(20);
  }

  private static Map<String, Long> counts() {
    Map<String, Long> counts = new TreeMap<>();
    for (ServiceEvent event : denials()) {
      counts.merge(event.text.replaceAll(".*refused (\\S+?):.*", "$1"), 1L, Long::sum);
    }
    return counts;
  }
}
