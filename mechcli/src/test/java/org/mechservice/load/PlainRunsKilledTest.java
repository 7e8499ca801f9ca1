package org.mechservice.load;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.TimeUnit;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.mechservice.cli.Mech;
import org.mechservice.idl.SimState;
import org.mechservice.orb.ServiceOrb;
import org.omg.CORBA.SystemException;
import org.omg.CORBA.UserException;

/**
 * Somebody who runs {@code mech simulate --server} while parts of the service are killed gets the
 * rows of an undisturbed run to the last bit, or is told how to fetch them.
 */
class PlainRunsKilledTest {
  private static final long SEED = 9_2026_11_25;
  private static final int KILLS = 200;
  private static final int LONGEST_MILLIS = 1500;
  private static final long PATIENCE_SECONDS = 120;
  private static final List<String> HOSTS = List.of("first", "second");
  private static final Pattern IDENTITY = Pattern.compile("simulation ([0-9a-f-]{36})");
  private static final Pattern FETCH =
      Pattern.compile("mech fetch ([0-9a-f-]{36}) --server (\\S+)");

  /** Cut off: the rows up to then are kept. */
  private static final String CUT_OFF = "S-112";

  @TempDir Path folder;

  /** Who is killed. */
  private enum Killed {
    CLIENT("the client itself"),
    WORKER("the process of the run (user code)"),
    HOST("one of two hosts"),
    HOSTS("both hosts"),
    SERVER("the server"),
    ALL("server and hosts");

    private final String label;

    Killed(String label) {
      this.label = label;
    }
  }

  /** How a run ended for its user. */
  private enum Ending {
    RIGHT("right bits at once"),
    FETCHED("named mech fetch: right bits"),
    FETCHED_PART("named mech fetch: the rows up to the kill, named as such");

    private final String label;

    Ending(String label) {
      this.label = label;
    }
  }

  /** A model with the options of a run of a second or so. */
  private record Scene(String model, List<String> options) {}

  private static final Scene PLAIN =
      new Scene(
          "../examples/pendulum/pendulum.xml",
          List.of("--t-end", "200", "--t-step", "0.01", "--rtol", "1e-9"));
  private static final Scene USER_CODE =
      new Scene(
          "../examples/five-point-suspension/five-point-suspension.xml",
          List.of(
              "--user-code",
              "../examples/five-point-suspension",
              "--t-end",
              "40",
              "--t-step",
              "0.01"));

  private final Random random = new Random(SEED);
  private final ExecutorService users = Executors.newCachedThreadPool();
  private final List<ServiceJvm> hosts = new ArrayList<>();
  private ServiceJvm server;
  private byte[] plain = {};
  private byte[] userCode = {};

  @BeforeEach
  void start() throws Exception {
    server = server("0");
    for (String name : HOSTS) {
      hosts.add(host(name));
    }
    plain = undisturbed(PLAIN);
    userCode = undisturbed(USER_CODE);
  }

  @AfterEach
  void end() {
    users.shutdownNow();
    hosts.forEach(ServiceJvm::close);
    server.close();
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
        "--spool",
        folder.resolve(name).toString());
  }

  /** What a command has printed, and its exit status. */
  private record Done(int status, String err) {}

  private static Done mech(StringWriter err, String... words) {
    int status = Mech.run(new PrintWriter(new StringWriter()), new PrintWriter(err, true), words);
    return new Done(status, err.toString());
  }

  private String[] simulate(Scene scene, Path file) {
    List<String> words = new ArrayList<>(List.of("simulate", scene.model()));
    words.addAll(scene.options());
    words.addAll(List.of("--server", server.address(), "--out", file.toString()));
    return words.toArray(String[]::new);
  }

  private byte[] undisturbed(Scene scene) throws IOException {
    Path file = folder.resolve("undisturbed.csv");
    Done done = mech(new StringWriter(), simulate(scene, file));
    assertThat(done.status()).as(done.err()).isZero();
    return Files.readAllBytes(file);
  }

  private interface Condition {
    boolean holds() throws Exception;
  }

  private static void eventually(String what, Condition condition) throws Exception {
    long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(PATIENCE_SECONDS);
    while (!condition.holds()) {
      assertThat(System.nanoTime()).as("in time: " + what).isLessThan(end);
      Thread.sleep(20);
    }
  }

  private void atRandom() throws InterruptedException {
    Thread.sleep(random.nextInt(LONGEST_MILLIS));
  }

  @Tag("soak")
  @Test
  void killedTwoHundredTimes() throws Exception {
    Map<Killed, Map<Ending, Integer>> all = new EnumMap<>(Killed.class);
    for (int i = 0; i < KILLS; i++) {
      Killed killed = Killed.values()[random.nextInt(Killed.values().length)];
      all.computeIfAbsent(killed, k -> new EnumMap<>(Ending.class))
          .merge(in(killed), 1, Integer::sum);
    }
    write(all);
  }

  private static void write(Map<Killed, Map<Ending, Integer>> all) throws IOException {
    SoakPage page =
        new SoakPage(
            "Plain simulations while everything is killed",
            "A server and two hosts with spool folders. "
                + KILLS
                + " times, somebody runs `mech simulate --server` for a second or two, and up to"
                + " 1.5 s after the run was named a part gets `kill -9`, and is started again. Each"
                + " time, the file is compared byte by byte with that of an undisturbed run. Where"
                + " the command ends with status 3 instead, its message must name the `mech fetch`"
                + " that gets the rows, which is then run: it gives the whole file, or, where the"
                + " host that computed was killed and no other was there, the first rows and"
                + " [S-112](../errors/S-112.md). A run whose client is killed is fetched by the id"
                + " that the client had printed. An ending of any other kind fails the test.",
            SEED);
    StringBuilder head = new StringBuilder("| killed | times |");
    StringBuilder rule = new StringBuilder("|---|---|");
    for (Ending ending : Ending.values()) {
      head.append(' ').append(ending.label).append(" |");
      rule.append("---|");
    }
    page.line("%s", head).line("%s", rule);
    for (Killed killed : Killed.values()) {
      Map<Ending, Integer> endings = all.getOrDefault(killed, Map.of());
      StringBuilder row =
          new StringBuilder("| ")
              .append(killed.label)
              .append(" | ")
              .append(endings.values().stream().mapToInt(Integer::intValue).sum())
              .append(" |");
      for (Ending ending : Ending.values()) {
        row.append(' ').append(endings.getOrDefault(ending, 0)).append(" |");
      }
      page.line("%s", row);
    }
    page.write("service-plain-runs-killed.md");
  }

  private Ending in(Killed killed) throws Exception {
    Path file = Files.createTempFile(folder, "run", ".csv");
    Ending ending = killed == Killed.CLIENT ? client(file) : part(killed, file);
    Files.delete(file);
    eventually("all hosts are there", this::allHostsTakeSessions);
    return ending;
  }

  private boolean allHostsTakeSessions() {
    try (ServiceOrb orb = ServiceOrb.client()) {
      for (String name : HOSTS) {
        orb.connect(server.address()).createSession("killing", name, null).destroy();
      }
      return true;
    } catch (UserException | SystemException e) {
      return false;
    }
  }

  private static String identity(StringWriter said, Future<Done> user) throws Exception {
    eventually("the run is named", () -> user.isDone() || IDENTITY.matcher(said.toString()).find());
    Matcher found = IDENTITY.matcher(said.toString());
    assertThat(found.find()).as("named: " + said).isTrue();
    return found.group(1);
  }

  private Ending part(Killed killed, Path file) throws Exception {
    Scene scene = killed == Killed.WORKER ? USER_CODE : PLAIN;
    StringWriter err = new StringWriter();
    Future<Done> user = users.submit(() -> mech(err, simulate(scene, file)));
    String id = identity(err, user);
    eventually("the run has begun", () -> user.isDone() || hasBegun(id));
    if (killed == Killed.WORKER) {
      eventually("a worker is there, or the run over", () -> user.isDone() || hasWorker());
    }
    atRandom();
    kill(killed);
    Done done = user.get(PATIENCE_SECONDS, TimeUnit.SECONDS);
    byte[] right = killed == Killed.WORKER ? userCode : plain;
    if (done.status() == 0) {
      assertThat(Files.readAllBytes(file)).as(done.err()).isEqualTo(right);
      return Ending.RIGHT;
    }
    assertThat(done.status()).as(killed + ": " + done.err()).isEqualTo(3);
    Matcher told = FETCH.matcher(done.err());
    assertThat(told.find()).as(killed + ": " + done.err()).isTrue();
    assertThat(told.group(2)).isEqualTo(server.address());
    return fetched(told.group(1), file, right);
  }

  private boolean hasWorker() {
    return hosts.stream().anyMatch(host -> !host.workers().isEmpty());
  }

  private void kill(Killed killed) throws Exception {
    boolean withServer = killed == Killed.SERVER || killed == Killed.ALL;
    boolean withHosts = killed == Killed.HOSTS || killed == Killed.ALL;
    int one = random.nextInt(HOSTS.size());
    String port = Integer.toString(server.port());
    if (killed == Killed.WORKER) {
      hosts.stream()
          .flatMap(host -> host.workers().stream())
          .forEach(ProcessHandle::destroyForcibly);
    }
    if (withServer) {
      server.kill();
    }
    for (int i = 0; i < HOSTS.size(); i++) {
      if (withHosts || (killed == Killed.HOST && i == one)) {
        hosts.get(i).kill();
      }
    }
    if (withServer) {
      server.close();
      server = server(port);
    }
    for (int i = 0; i < HOSTS.size(); i++) {
      if (!hosts.get(i).alive()) {
        hosts.get(i).close();
        hosts.set(i, host(HOSTS.get(i)));
      }
    }
  }

  private Ending fetched(String id, Path file, byte[] right) throws Exception {
    eventually("all hosts are there", this::allHostsTakeSessions);
    Done done =
        mech(
            new StringWriter(),
            "fetch",
            id,
            "--server",
            server.address(),
            "--out",
            file.toString());
    byte[] rows = Files.readAllBytes(file);
    if (done.status() == 0) {
      assertThat(rows).as(done.err()).isEqualTo(right);
      return Ending.FETCHED;
    }
    assertThat(done.status()).as(done.err()).isEqualTo(1);
    assertThat(done.err()).contains(CUT_OFF);
    assertThat(rows).isEqualTo(java.util.Arrays.copyOf(right, rows.length));
    return Ending.FETCHED_PART;
  }

  /** What was named and not begun is nobody's when its client dies. */
  private boolean hasBegun(String id) {
    try (ServiceOrb orb = ServiceOrb.client()) {
      SimState state = orb.connectAdmin(server.address()).showSimulation(id).summary.info.state;
      return state == SimState.SIM_RUNNING || state == SimState.SIM_DONE;
    } catch (UserException | SystemException e) {
      return false;
    }
  }

  /** Whoever has the id goes on with the run before its lease ends. */
  private Ending client(Path file) throws Exception {
    List<String> command =
        new ArrayList<>(
            List.of(
                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-XX:TieredStopAtLevel=1",
                "-cp",
                System.getProperty("java.class.path"),
                "org.mechservice.cli.Mech"));
    command.addAll(List.of(simulate(PLAIN, file)));
    Process client = new ProcessBuilder(command).start();
    String named;
    try (BufferedReader said =
            new BufferedReader(
                new InputStreamReader(client.getErrorStream(), StandardCharsets.UTF_8));
        Stream<String> lines = said.lines()) {
      String id =
          lines
              .map(IDENTITY::matcher)
              .filter(Matcher::find)
              .map(found -> found.group(1))
              .findFirst()
              .orElseThrow();
      eventually("the run has begun", () -> hasBegun(id));
      atRandom();
      client.destroyForcibly().waitFor();
      named = id;
    }
    // A run is given up only after its file is whole.
    return java.util.Arrays.equals(Files.readAllBytes(file), plain)
        ? Ending.RIGHT
        : fetched(named, file, plain);
  }
}
