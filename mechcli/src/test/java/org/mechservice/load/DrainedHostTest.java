package org.mechservice.load;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.ByteBuffer;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.time.Duration;
import java.util.ArrayDeque;
import java.util.Arrays;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.mechservice.client.MechConnection;
import org.mechservice.client.MechSession;
import org.mechservice.client.SimulationOptions;
import org.mechservice.client.failure.ModelMessage;
import org.mechservice.client.run.ReattachedRun;
import org.mechservice.client.run.RemoteRun;
import org.mechservice.client.run.RunListener;
import org.mechservice.client.run.RunResult;
import org.mechservice.idl.MechAdmin;
import org.mechservice.orb.ServiceOrb;
import org.mechservice.server.MechServerProcess;
import org.mechservice.server.ServerSettings;
import org.mechservice.sim.host.HostSettings;
import org.mechservice.sim.host.SimHostProcess;
import org.mechservice.solver.api.result.ResultSink;
import org.mechservice.solver.api.result.Variable;
import org.mechservice.solver.api.run.Outcome;

/** What becomes of runs on a host that an operator empties. */
@Tag("slow")
class DrainedHostTest {
  /** Goes on for as long as a test needs. */
  private static final SimulationOptions LONG =
      SimulationOptions.asInFile().endTime(1e7).outputStep(5);

  /** 250 s of the pendulum, in which a wrong last bit has long become a wrong row. */
  private static final int ROWS_AFTERWARDS = 50;

  private final Deque<AutoCloseable> parts = new ArrayDeque<>();
  private final MechServerProcess server =
      opened(MechServerProcess.start(new ServerSettings("s", "127.0.0.1", 0, 0)));
  private final MechAdmin admin = opened(ServiceOrb.client()).connectAdmin(server.url());
  private final News news = new News();

  private <T extends AutoCloseable> T opened(T part) {
    parts.push(part);
    return part;
  }

  @AfterEach
  void close() throws Exception {
    while (!parts.isEmpty()) {
      parts.pop().close();
    }
  }

  private void host(String name, int capacity) {
    opened(SimHostProcess.start(new HostSettings(server.url(), name, "127.0.0.1", 0, capacity)));
  }

  private MechSession session(String hostName) throws Exception {
    MechConnection connection = opened(MechConnection.open(server.url()));
    MechSession session = opened(connection.openSession(hostName));
    session.loadModel(Runs.PENDULUM);
    return session;
  }

  /** The server knows the load of a host as it was when it asked last. */
  private void awaitEmpty(String hostName) throws Exception {
    long end = System.nanoTime() + TimeUnit.MINUTES.toNanos(1);
    while (running(hostName) > 0) {
      assertThat(System.nanoTime()).as(hostName + " is not empty").isLessThan(end);
      Thread.sleep(50);
    }
  }

  private int running(String hostName) throws Exception {
    return Arrays.stream(admin.listHosts())
        .filter(host -> host.info.name.equals(hostName))
        .mapToInt(host -> host.load.running + host.load.queued)
        .sum();
  }

  /** What a run says of itself. */
  private static final class News implements RunListener {
    private final List<ModelMessage> said = new CopyOnWriteArrayList<>();

    @Override
    public void onMessages(List<ModelMessage> messages) {
      said.addAll(messages);
    }

    boolean has(String code) {
      return said.stream().anyMatch(message -> message.code().equals(code));
    }

    String text(String code) {
      return said.stream()
          .filter(message -> message.code().equals(code))
          .map(ModelMessage::text)
          .reduce("", (before, text) -> text);
    }
  }

  /** Acts when the first row has come; ends the run when enough have come after a message. */
  private static final class Watch implements ResultSink {
    private final RemoteRun run;
    private final Action atFirst;
    private final News news;
    private final String code;
    private final Digest digest = new Digest(Long.MAX_VALUE, () -> {});
    private Optional<Long> enough = Optional.empty();

    interface Action {
      void act() throws Exception;
    }

    Watch(RemoteRun run, Action atFirst, News news, String code) {
      this.run = run;
      this.atFirst = atFirst;
      this.news = news;
      this.code = code;
    }

    @Override
    public void begin(List<Variable> columns) {}

    @Override
    public void row(double[] values) {
      if (digest.rows() == 0) {
        try {
          atFirst.act();
        } catch (Exception e) {
          throw new IllegalStateException(e);
        }
      }
      if (enough.isEmpty() && news.has(code)) {
        enough = Optional.of(digest.rows() + ROWS_AFTERWARDS);
      }
      if (enough.isEmpty() || digest.rows() < enough.get()) {
        digest.row(values);
      } else {
        run.cancel();
      }
    }
  }

  /** The bits of the first rows of a run. */
  private static final class Digest implements ResultSink {
    private final MessageDigest bits;
    private final long limit;
    private final Runnable full;
    private long rows;

    /**
     * @param limit how many rows
     * @param full acts when they are there
     */
    Digest(long limit, Runnable full) {
      this.limit = limit;
      this.full = full;
      try {
        bits = MessageDigest.getInstance("SHA-256");
      } catch (NoSuchAlgorithmException e) {
        throw new IllegalStateException(e);
      }
    }

    long rows() {
      return rows;
    }

    @Override
    public void begin(List<Variable> columns) {}

    @Override
    public void row(double[] values) {
      if (rows < limit) {
        rows++;
        ByteBuffer bytes = ByteBuffer.allocate(values.length * Double.BYTES);
        bytes.asDoubleBuffer().put(values);
        bits.update(bytes.array());
      } else {
        full.run();
      }
    }
  }

  private static byte[] undisturbed(MechSession session, long rows) throws Exception {
    try (RemoteRun run = session.prepareRemoteRun(LONG)) {
      Digest digest = new Digest(rows, run::cancel);
      run.toEnd(digest);
      return digest.bits.digest();
    }
  }

  @Test
  void runGoesOnOnAnotherHostToTheSameBits() throws Exception {
    host("a", 1);
    host("b", 2);
    RemoteRun run = opened(session("a").prepareRemoteRun(LONG, news));
    Watch watch = new Watch(run, () -> admin.drain("a"), news, "S-117");
    RunResult result = run.toEnd(watch);

    assertThat(result.outcome()).isInstanceOf(Outcome.Stopped.class);
    assertThat(result.report().get("where"))
        .asString()
        .matches("remote, host b from t=.* s on, before on host a");
    assertThat(run.progress().rows()).isGreaterThanOrEqualTo(watch.digest.rows());
    awaitEmpty("a");
    assertThat(watch.digest.bits.digest())
        .isEqualTo(undisturbed(session("b"), watch.digest.rows()));
  }

  @Test
  void runWhoseRowsAreTakenOneByOneMovesToo() throws Exception {
    host("a", 1);
    host("b", 2);
    RemoteRun run = opened(session("a").prepareRemoteRun(LONG, news));
    Digest digest = new Digest(Long.MAX_VALUE, () -> {});
    run.start();
    admin.drain("a");
    while (!news.has("S-117")) {
      run.nextRow(Duration.ofMillis(50)).ifPresent(digest::row);
    }
    for (long end = digest.rows() + ROWS_AFTERWARDS; digest.rows() < end; ) {
      run.nextRow(Duration.ofMillis(50)).ifPresent(digest::row);
    }

    awaitEmpty("a");
    run.close();
    assertThat(digest.bits.digest()).isEqualTo(undisturbed(session("b"), digest.rows()));
  }

  @Test
  void runThatHasMovedIsFoundUnderTheIdItHad() throws Exception {
    host("a", 1);
    host("b", 2);
    RemoteRun run = opened(session("a").prepareRemoteRun(LONG, news));
    run.start();
    String before = run.id();
    admin.drain("a");
    followUntilMoved(run);

    assertThat(run.id()).isNotEqualTo(before);
    MechConnection other = opened(MechConnection.open(server.url()));
    try (ReattachedRun found = other.reattach(before)) {
      assertThat(found.id()).isEqualTo(run.id());
    }
    run.close();
  }

  private void followUntilMoved(RemoteRun run) {
    while (!news.has("S-117")) {
      run.nextRow(Duration.ofMillis(50));
    }
  }

  private MechServerProcess another(String name) {
    return opened(MechServerProcess.start(new ServerSettings(name, "127.0.0.1", 0, 1)));
  }

  @Test
  void runsOfAServerThatIsEmptiedGoOnAtAnotherThatTheirClientKnows() throws Exception {
    MechServerProcess first = another("first");
    MechServerProcess second = another("second");
    MechAdmin ofFirst = opened(ServiceOrb.client()).connectAdmin(first.url());
    MechConnection both = opened(MechConnection.open(first.url() + "," + second.url()));
    MechSession session = opened(both.openSession());
    session.loadModel(Runs.PENDULUM);
    RemoteRun run = opened(session.prepareRemoteRun(LONG, news));
    Watch watch = new Watch(run, () -> ofFirst.drain(""), news, "S-117");
    String before = run.id();
    RunResult result = run.toEnd(watch);

    assertThat(result.report().get("where"))
        .asString()
        .matches("remote, host second from t=.* s on, before on host first");
    try (ReattachedRun found = both.reattach(before)) {
      assertThat(found.id()).isEqualTo(run.id());
    }
    ofFirst.undrain("");
    assertThat(watch.digest.bits.digest()).isEqualTo(undisturbed(session, watch.digest.rows()));
  }

  @Test
  void runsOfAServerThatIsEmptiedStayAndSaySoIfTheirClientKnowsNoOther() throws Exception {
    MechServerProcess only = another("only");
    MechAdmin ofOnly = opened(ServiceOrb.client()).connectAdmin(only.url());
    MechSession session = opened(opened(MechConnection.open(only.url())).openSession());
    session.loadModel(Runs.PENDULUM);
    RemoteRun run = opened(session.prepareRemoteRun(LONG, news));
    RunResult result = run.toEnd(new Watch(run, () -> ofOnly.drain(""), news, "S-116"));

    assertThat(result.report().get("where")).isEqualTo("remote, host only");
    assertThat(news.text("S-116"))
        .contains("finishes on host only", "server only is being emptied and takes no new");
  }

  /** It is a process of its own, may serve other servers, and outlives this one. */
  @Test
  void hostOfAServerThatIsEmptiedKeepsItsRuns() throws Exception {
    host("a", 1);
    admin.drain("");
    assertThat(admin.listHosts()[0].load.draining).isFalse();
    assertThatThrownBy(() -> session("a")).hasMessageContaining("is being emptied");
    admin.undrain("");
    assertThat(session("a").hostName()).isEqualTo("a");
  }

  @Test
  void runThatItsUserHoldsMovesWhenItIsLetGo() throws Exception {
    host("a", 1);
    host("b", 2);
    RemoteRun run = opened(session("a").prepareRemoteRun(LONG, news));
    Digest digest = new Digest(Long.MAX_VALUE, () -> {});
    run.runTo(100);
    admin.drain("a");
    for (int i = 0; i < 60; i++) {
      run.nextRow(Duration.ofMillis(50)).ifPresent(digest::row);
    }
    assertThat(news.has("S-117")).isFalse();
    run.resume();
    while (!news.has("S-117")) {
      run.nextRow(Duration.ofMillis(50)).ifPresent(digest::row);
    }
    run.cancel();
    run.toEnd(new Digest(0, () -> {}));

    assertThat(run.result().outcome()).isInstanceOf(Outcome.Stopped.class);
  }

  @Test
  void runStaysWhereItIsIfNoOtherHostTakesIt() throws Exception {
    host("a", 1);
    RemoteRun run = opened(session("a").prepareRemoteRun(LONG, news));
    Watch watch = new Watch(run, () -> admin.drain("a"), news, "S-116");
    String id = run.id();
    RunResult result = run.toEnd(watch);

    assertThat(result.outcome()).isInstanceOf(Outcome.Stopped.class);
    assertThat(run.id()).isEqualTo(id);
    assertThat(news.text("S-116")).contains("finishes on host a");
    assertThat(news.said).extracting(ModelMessage::code).contains("S-115").doesNotContain("S-117");
  }

  @Test
  void runStaysWhereItIsIfItWouldHaveToWaitElsewhere() throws Exception {
    host("a", 1);
    host("b", 1);
    RemoteRun other = opened(session("b").prepareRemoteRun(LONG));
    other.start();
    RemoteRun run = opened(session("a").prepareRemoteRun(LONG, news));
    Watch watch = new Watch(run, () -> admin.drain("a"), news, "S-116");
    RunResult result = run.toEnd(watch);

    assertThat(result.report().get("where")).isEqualTo("remote, host a");
    assertThat(news.text("S-116")).contains("host b has no room");
    other.close();
    admin.undrain("a");
    assertThat(watch.digest.bits.digest())
        .isEqualTo(undisturbed(session("a"), watch.digest.rows()));
  }
}
