package org.mechservice.load;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.stream.Stream;
import org.mechservice.client.MechConnection;
import org.mechservice.client.MechSession;
import org.mechservice.client.SimulationOptions;
import org.mechservice.client.failure.RunState;
import org.mechservice.client.jar.JarCache;
import org.mechservice.client.run.RemoteRun;
import org.mechservice.guard.UserCode;
import org.mechservice.idl.FailureRecord;
import org.mechservice.idl.IMechSimRemote;
import org.mechservice.idl.MechAdmin;
import org.mechservice.idl.MechServer;
import org.mechservice.idl.NotFound;
import org.mechservice.idl.ResultBlock;
import org.mechservice.idl.ResultBlockHolder;
import org.mechservice.idl.ResultCursor;
import org.mechservice.idl.SimState;
import org.mechservice.orb.ServiceOrb;
import org.mechservice.solver.api.run.Outcome;
import org.omg.CORBA.OBJECT_NOT_EXIST;
import org.omg.CORBA.SystemException;

/**
 * A server with two hosts, of which one, the victim, and its server, clients and workers are
 * killed, and the other works for somebody who must not notice.
 */
final class Killing implements AutoCloseable {
  static final String WITNESS = "witness";
  static final String VICTIM = "victim";

  /** Something runs for a second or so. */
  private static final SimulationOptions LONG =
      SimulationOptions.asInFile().endTime(200).outputStep(0.01).relativeTolerance(1e-9);

  private static final Path USER_CODE =
      Path.of("../examples/five-point-suspension/five-point-suspension.xml");
  private static final int LONGEST_MILLIS = 1500;
  private static final long PATIENCE_MILLIS = 60_000;

  /** Of objects that are taken up here without the library, which would renew them. */
  static final int LEASE_SECONDS = 6;

  /** What a run that was cut off says of itself. */
  private static final String CUT_OFF = "S-112";

  private static final String WORKER_LOST = "S-178";

  private final Random random;
  private final Path folder;
  private final List<Long> whole;
  private final List<Long> witnessed;
  private final ServiceJvm witness;
  private final MechConnection other;
  private final MechSession otherSession;
  private ServiceJvm server;
  private ServiceJvm victim;
  private int completed;
  private int cutOff;

  Killing(long seed, Path folder) throws Exception {
    random = new Random(seed);
    this.folder = folder;
    server = server("0");
    witness = host(WITNESS);
    victim = host(VICTIM);
    other = MechConnection.open(server.address(), JarCache.ofUser());
    otherSession = other.openSession(WITNESS);
    otherSession.loadModel(Runs.PENDULUM);
    whole = Runs.bits(otherSession, LONG, false);
    witnessed = Runs.bits(otherSession, SimulationOptions.asInFile(), false);
  }

  private static ServiceJvm server(String port) throws IOException {
    return ServiceJvm.start(List.of(), 128, "server", "--port", port, "--capacity", "0");
  }

  private ServiceJvm host(String name) throws IOException {
    return ServiceJvm.host(
        server.address(),
        name,
        "--capacity",
        "2",
        "--allow-user-code=unconfined",
        "--limit",
        "lease=" + LEASE_SECONDS,
        "--spool",
        folder.resolve(name).toString());
  }

  /** Returns how many runs had ended well before their host was killed. */
  int completed() {
    return completed;
  }

  /** Returns how many runs were cut off. */
  int cutOff() {
    return cutOff;
  }

  private void atRandom() throws InterruptedException {
    Thread.sleep(random.nextInt(LONGEST_MILLIS));
  }

  private interface Condition {
    boolean holds() throws Exception;
  }

  private static void eventually(String what, Condition condition) throws Exception {
    long end = System.nanoTime() + PATIENCE_MILLIS * 1_000_000;
    while (!condition.holds()) {
      assertThat(System.nanoTime()).as("in time: " + what).isLessThan(end);
      Thread.sleep(50);
    }
  }

  /** The other client goes on as if nothing had happened. */
  void assertWitnessSawNothing() throws IOException {
    assertThat(Runs.bits(otherSession, SimulationOptions.asInFile(), false)).isEqualTo(witnessed);
  }

  /** Its run is cancelled, and nothing of it is left but what is kept for it. */
  void client() throws Exception {
    Process client =
        new ProcessBuilder(
                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-XX:TieredStopAtLevel=1",
                "-cp",
                System.getProperty("java.class.path"),
                EndlessClient.class.getName(),
                server.address(),
                VICTIM)
            .redirectError(ProcessBuilder.Redirect.INHERIT)
            .start();
    String id;
    try (BufferedReader said =
        new BufferedReader(
            new InputStreamReader(client.getInputStream(), StandardCharsets.UTF_8))) {
      id = String.valueOf(said.readLine());
      assertThat(id).as("the run of the client").hasSize(36);
      atRandom();
      client.destroyForcibly().waitFor();
    }
    try (ServiceOrb orb = ServiceOrb.client()) {
      MechAdmin admin = orb.connectAdmin(server.address()); // whose looking renews no lease
      eventually("the run of the dead client " + id + " ends", () -> isCancelled(admin, id));
      giveUp(orb.connect(server.address()).findSimulation(id));
    }
  }

  /** On a machine under heavy load its lease may be over before. */
  private static void giveUp(IMechSimRemote run) {
    try {
      run.destroy();
    } catch (OBJECT_NOT_EXIST alreadyGone) {
      return;
    }
  }

  private static boolean isCancelled(MechAdmin admin, String id) throws Exception {
    try {
      return admin.showSimulation(id).summary.info.state == SimState.SIM_CANCELLED;
    } catch (NotFound e) {
      return false; // a host that does not answer in time is not asked
    }
  }

  /** The run says that it lost its worker; its rows so far are right, and others go on. */
  void worker() throws Exception {
    try (MechConnection connection = MechConnection.open(server.address(), JarCache.ofUser());
        MechSession session = connection.openSession(VICTIM)) {
      session.loadModel(USER_CODE, UserCode.in(USER_CODE.resolveSibling(".")));
      try (RemoteRun run =
          session.prepareRemoteRun(SimulationOptions.asInFile().endTime(1e5).outputStep(1e-2))) {
        run.start();
        eventually("a worker starts", () -> !victim.workers().isEmpty());
        atRandom();
        victim.workers().forEach(ProcessHandle::destroyForcibly);
        eventually("the run ends", () -> run.progress().state() == RunState.FAILED);
        assertThat(run.result().outcome())
            .isInstanceOfSatisfying(
                Outcome.Failed.class,
                failed -> assertThat(failed.failure().code()).hasToString(WORKER_LOST));
      }
    }
    eventually("no worker is left", () -> victim.workers().isEmpty());
  }

  /** What was completed is there again with the host, to the last bit; what was not is said so. */
  void hostProcess() throws Exception {
    String id;
    boolean done;
    try (MechConnection connection = MechConnection.open(server.address(), JarCache.ofUser())) {
      MechSession session = connection.openSession(VICTIM);
      session.loadModel(Runs.PENDULUM);
      RemoteRun run = session.prepareRemoteRun(LONG);
      id = run.id();
      run.start();
      atRandom();
      done = run.progress().state() == RunState.DONE;
      victim.kill();
    }
    victim.close();
    victim = host(VICTIM);
    try (ServiceOrb orb = ServiceOrb.client()) {
      MechServer service = orb.connect(server.address());
      Optional<IMechSimRemote> found = found(service, id);
      if (found.isEmpty()) {
        assertThat(done).as("a completed run is found again").isFalse();
        return; // it had not begun
      }
      assertIsWhatItWas(found.get(), done);
      giveUp(found.get());
    }
    assertThat(spooled()).as("in the spool").allMatch(Killing::isOfKeptRun);
  }

  private static Optional<IMechSimRemote> found(MechServer service, String id) throws Exception {
    eventually(
        "the host is back",
        () -> {
          try {
            service.createSession("killing", VICTIM, null).destroy();
            return true;
          } catch (NotFound | SystemException e) {
            return false;
          }
        });
    try {
      return Optional.of(service.findSimulation(id));
    } catch (NotFound e) {
      return Optional.empty();
    }
  }

  private void assertIsWhatItWas(IMechSimRemote run, boolean wasDone) throws Exception {
    List<Long> rows = rows(run.openResults(new String[0]));
    SimState state = run.getProgress().state;
    if (wasDone || state == SimState.SIM_DONE) {
      completed++;
      assertThat(state).isEqualTo(SimState.SIM_DONE);
      assertThat(rows).isEqualTo(whole);
      assertThat(run.report()).contains("\"completed\"");
    } else {
      cutOff++;
      FailureRecord failure = run.failure();
      assertThat(failure.code).isEqualTo(CUT_OFF);
      assertThat(rows).isEqualTo(whole.subList(0, rows.size()));
    }
  }

  private static List<Long> rows(ResultCursor cursor) throws Exception {
    List<Long> bits = new ArrayList<>();
    ResultBlockHolder holder = new ResultBlockHolder();
    do {
      cursor.nextBlock(0, 1000, holder);
      ResultBlock block = holder.value;
      for (double value : block.values) {
        bits.add(Double.doubleToRawLongBits(value));
      }
    } while (!holder.value.endOfData);
    cursor.destroy();
    return bits;
  }

  /** Runs that were taken up again are kept all the same; nothing half-written is. */
  private static boolean isOfKeptRun(String file) {
    return file.matches("lock|.+\\.(json|rows)");
  }

  private List<String> spooled() throws IOException {
    try (Stream<Path> files = Files.list(folder.resolve(VICTIM))) {
      return files.map(file -> file.getFileName().toString()).toList();
    }
  }

  /** Clients of hosts do not notice; hosts register at the new one, which finds their runs. */
  void serverProcess() throws Exception {
    int port = server.port();
    try (MechConnection connection = MechConnection.open(server.address(), JarCache.ofUser());
        MechSession session = connection.openSession(VICTIM)) {
      session.loadModel(Runs.PENDULUM);
      try (RemoteRun run = session.prepareRemoteRun(LONG)) {
        String id = run.id();
        run.start();
        atRandom();
        server.kill();
        Runs.Kept rows = new Runs.Kept();
        run.toEnd(rows);
        assertThat(rows.bits()).isEqualTo(whole);
        server.close();
        server = server(Integer.toString(port));
        try (ServiceOrb orb = ServiceOrb.client()) {
          MechServer service = orb.connect(server.address());
          Optional<IMechSimRemote> found = found(service, id);
          assertThat(found).isPresent();
          assertThat(rows(found.orElseThrow().openResults(new String[0]))).isEqualTo(whole);
        }
        eventually("all hosts are back", () -> hosts() == 2);
      }
    }
  }

  private int hosts() {
    int hosts = 0;
    try (ServiceOrb orb = ServiceOrb.client()) {
      for (String name : List.of(WITNESS, VICTIM)) {
        orb.connect(server.address()).createSession("killing", name, null).destroy();
        hosts++;
      }
    } catch (org.omg.CORBA.UserException | SystemException e) {
      return hosts;
    }
    return hosts;
  }

  /** What is in the processes that have lived all the time, when nobody asks them for anything. */
  ServiceJvm.Inside insideWitness() throws Exception {
    return witness.inside();
  }

  ServiceJvm.Inside insideVictim() throws Exception {
    return victim.inside();
  }

  ServiceJvm.Inside insideServer() throws Exception {
    return server.inside();
  }

  @Override
  public void close() {
    otherSession.close();
    other.close();
    List.of(victim, witness, server).forEach(ServiceJvm::close);
  }
}
