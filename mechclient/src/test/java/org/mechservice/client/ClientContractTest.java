package org.mechservice.client;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.BufferedReader;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.mechservice.client.failure.InvalidModelException;
import org.mechservice.client.failure.InvalidOptionException;
import org.mechservice.client.failure.JarRefusedException;
import org.mechservice.client.failure.LimitExceededException;
import org.mechservice.client.failure.ModelMessage;
import org.mechservice.client.failure.RunState;
import org.mechservice.client.failure.ServerLostException;
import org.mechservice.client.jar.JarCache;
import org.mechservice.client.run.RemoteRun;
import org.mechservice.client.run.RunListener;
import org.mechservice.client.run.RunProgress;
import org.mechservice.client.run.RunResult;
import org.mechservice.guard.Confinement;
import org.mechservice.guard.SolverClasses;
import org.mechservice.idl.SimState;
import org.mechservice.solver.api.result.ColumnGroup;
import org.mechservice.solver.api.result.ResultSink;
import org.mechservice.solver.api.result.Variable;
import org.mechservice.solver.api.run.Outcome;
import org.mechservice.solver.catalogue.MessageCode;

/** What the client library promises, against a server whose answers are written down. */
@Tag("slow")
class ClientContractTest {
  private static final byte[] MODEL = {'<'};

  private final Path cacheFolder;
  private final ScriptedServer server = new ScriptedServer();
  private final MechConnection connection;
  private final MechSession session;

  ClientContractTest(@TempDir Path cacheFolder) {
    this.cacheFolder = cacheFolder;
    connection = MechConnection.open(server.address(), new JarCache(cacheFolder));
    session = connection.openSession();
  }

  @BeforeEach
  void loadModel() {
    connection.acceptSolversOf(server.key.getPublic());
    session.loadModel("square.xml", MODEL);
  }

  @Test
  void modelThatFitsIntoNoMessageIsRefusedByItsSizeAndTheSessionGoesOn() {
    assertThatThrownBy(() -> session.loadModel("large.xml", new byte[50_000_000]))
        .isInstanceOf(LimitExceededException.class)
        .hasMessageContaining("the model has 50000000 bytes; servers take at most 25165824");
    session.loadModel("square.xml", MODEL);
  }

  @Test
  void reportThatFitsIntoNoMessageIsFetchedInParts() {
    assertThat(session.checkReport(true)).isEqualTo("{\"a\":1}");
    assertThat(server.happened).contains("text-part=0", "text-part=1", "text-part=2");
  }

  @AfterEach
  void close() {
    session.close();
    connection.close();
    server.close();
  }

  @Test
  void blocksGiveTheSameRowsAsSingleSteps() throws IOException {
    Rows inBlocks = new Rows();
    session.prepareRemoteRun(SimulationOptions.asInFile()).toEnd(inBlocks);
    Rows oneByOne = new Rows();
    RemoteRun run = session.prepareRemoteRun(SimulationOptions.asInFile());
    oneByOne.begin(run.columns());
    run.start();
    while (!run.ended()) {
      Optional<double[]> row = run.nextRow(Duration.ofSeconds(1));
      row.ifPresent(oneByOne::row);
    }
    assertThat(inBlocks.columns).extracting(Variable::name).containsExactly("t", "j.q");
    assertThat(inBlocks.rows).hasSize(ScriptedServer.ROWS);
    assertThat(oneByOne.rows).usingRecursiveComparison().isEqualTo(inBlocks.rows);
  }

  @Test
  void rowsOneByOneTakeNoCallEach() {
    RemoteRun run = session.prepareRemoteRun(SimulationOptions.asInFile());
    run.start();
    int rows = 0;
    while (!run.ended()) {
      rows += run.nextRow(Duration.ofSeconds(1)).isPresent() ? 1 : 0;
    }
    assertThat(rows).isEqualTo(ScriptedServer.ROWS);
    assertThat(server.blocksSent).hasValue(3);
  }

  @Test
  void rowsTakenOneByOneAreNotPutOutAgain() throws IOException {
    RemoteRun run = session.prepareRemoteRun(SimulationOptions.asInFile());
    run.start();
    assertThat(run.nextRow(Duration.ofSeconds(1))).hasValue(new double[] {0, 0});
    Rows rest = new Rows();
    run.toEnd(rest);
    assertThat(rest.rows).hasSize(ScriptedServer.ROWS - 1).first().isEqualTo(new double[] {1, 1});
  }

  @Test
  void localRunGivesTheRowsOfTheServersSolver() throws IOException {
    Rows rows = new Rows();
    RunResult result = session.prepareLocalRun(SimulationOptions.asInFile()).toEnd(rows);
    assertThat(rows.rows).hasSize(25).last().isEqualTo(new double[] {24, 576});
    assertThat(result.outcome()).isEqualTo(new Outcome.Completed());
  }

  @Test
  void fetchedSolverIsLoadedApartFromTheClientsOwn() throws IOException {
    RunResult result = session.prepareLocalRun(SimulationOptions.asInFile()).toEnd(new Rows());
    assertThat(result.report()).containsEntry("solverVersion", "fetched");
  }

  @Test
  void solverOfTheSameBitsIsThisProgramsAndNoneIsFetched() throws IOException {
    server.fingerprint = SolverClasses.fingerprint();
    assertThatThrownBy(() -> session.fetchModel(SimulationOptions.asInFile()))
        .isInstanceOf(JarRefusedException.class)
        .hasMessageContaining("S-168");
    assumeTrue(Confinement.ofThisMachine().stands(), "this machine cannot confine");
    session.prepareLocalRun(SimulationOptions.asInFile()).close();
    assertThat(server.runtimeFetches).hasValue(0);
    assertThat(cacheFolder).isEmptyDirectory();
  }

  @Test
  void otherSolverIsRefusedUnlessItsKeyIsAccepted() throws IOException {
    try (ScriptedServer other = new ScriptedServer();
        MechConnection careful = MechConnection.open(other.address(), new JarCache(cacheFolder));
        MechSession open = careful.openSession()) {
      open.loadModel("square.xml", MODEL);
      assertThatThrownBy(() -> open.prepareLocalRun(SimulationOptions.asInFile()))
          .isInstanceOf(JarRefusedException.class)
          .hasMessageStartingWith("S-231 the server has another solver")
          .hasMessageContaining("--trust-solver");
      assertThat(other.runtimeFetches).hasValue(0);
      careful.acceptSolversOf(TestJars.newKey().getPublic());
      assertThatThrownBy(() -> open.prepareLocalRun(SimulationOptions.asInFile()))
          .isInstanceOf(JarRefusedException.class)
          .hasMessageStartingWith("S-231")
          .hasMessageContaining("signed with no key that you have accepted");
      careful.acceptSolversOf(other.key.getPublic());
      assertThat(open.prepareLocalRun(SimulationOptions.asInFile())).isNotNull();
    }
  }

  @Test
  void hostileClassOfAModelIsRefusedBeforeItIsLoaded() {
    server.jars = TestJars.hostile();
    server.modelClass = HostileModel.class.getName();
    for (String solver : List.of(SolverClasses.fingerprint(), "another")) {
      server.fingerprint = solver;
      assertThatThrownBy(() -> session.prepareLocalRun(SimulationOptions.asInFile()))
          .isInstanceOf(JarRefusedException.class)
          .hasMessageStartingWith("S-232")
          .hasMessageContaining("java.lang.System.setProperty");
      assertThatThrownBy(() -> session.fetchModel(SimulationOptions.asInFile()))
          .isInstanceOf(JarRefusedException.class);
    }
    assertThat(System.getProperty(HostileModel.DONE)).isNull();
  }

  /** Where it ran in this process, its appetite would be this process's. */
  @Test
  void modelOfAServerRunsInAProcessOfItsOwn() {
    assumeTrue(Confinement.ofThisMachine().stands(), "this machine cannot confine");
    server.jars = TestJars.of(GreedyModel.class);
    server.modelClass = GreedyModel.class.getName();
    server.fingerprint = SolverClasses.fingerprint();
    assertThatThrownBy(() -> session.prepareLocalRun(SimulationOptions.asInFile()))
        .isInstanceOf(JarRefusedException.class)
        .hasMessageStartingWith("S-036 the model JAR cannot be loaded")
        .hasMessageContaining("memory");
  }

  @Test
  void classesThatSwellAreRefusedByNameBeforeTheyFillTheMemory() {
    server.jars = TestJars.swelling();
    assertThatThrownBy(() -> session.prepareLocalRun(SimulationOptions.asInFile()))
        .isInstanceOf(JarRefusedException.class)
        .hasMessageStartingWith("S-036")
        .hasMessageContaining("more than");
  }

  @Test
  void classOfThisProgramIsNoModelOfAServer() {
    server.fingerprint = SolverClasses.fingerprint();
    server.modelClass = HostileModel.class.getName();
    assertThatThrownBy(() -> session.prepareLocalRun(SimulationOptions.asInFile()))
        .isInstanceOf(JarRefusedException.class)
        .hasMessageContaining("which it does not contain");
    assertThat(System.getProperty(HostileModel.DONE)).isNull();
  }

  @Test
  void runtimeJarIsFetchedOnce() throws IOException {
    session.prepareLocalRun(SimulationOptions.asInFile());
    session.prepareLocalRun(SimulationOptions.asInFile());
    assertThat(server.runtimeFetches).hasValue(1);
  }

  @Test
  void changedFileInTheCacheIsFetchedAgain() throws IOException {
    session.prepareLocalRun(SimulationOptions.asInFile());
    Path kept = onlyFileOf(cacheFolder);
    Files.write(kept, new byte[] {1, 2, 3});
    session.prepareLocalRun(SimulationOptions.asInFile());
    assertThat(server.runtimeFetches).hasValue(2);
    assertThat(kept).hasBinaryContent(server.jars.runtime());
  }

  @Test
  void runtimeJarThatIsNotTheOneAnnouncedIsRefusedAndNotKept() {
    server.sendsWrongRuntime = true;
    assertThatThrownBy(() -> session.prepareLocalRun(SimulationOptions.asInFile()))
        .isInstanceOf(JarRefusedException.class)
        .hasMessageContaining("S-036")
        .hasMessageContaining("the runtime JAR was changed on its way");
    assertThat(cacheFolder).isEmptyDirectory();
  }

  @Test
  void modelBuiltForAnotherApiIsRefused() {
    server.jars = TestJars.make("99");
    assertThatThrownBy(() -> session.prepareLocalRun(SimulationOptions.asInFile()))
        .isInstanceOf(JarRefusedException.class)
        .hasMessageContaining("solver API version 99; this client has 1");
  }

  @Test
  void runtimeForAnotherApiIsRefusedByItsVersion() {
    server.jars = TestJars.withRuntimeFor("99");
    assertThatThrownBy(() -> session.prepareLocalRun(SimulationOptions.asInFile()))
        .isInstanceOf(JarRefusedException.class)
        .hasMessageContaining("the runtime JAR was built for solver API version 99");
  }

  @Test
  void serverThatDiesInTheMiddleIsReportedWithItsAddressAndTheRowsSoFarAreKept()
      throws IOException {
    Process process = startScriptedServer();
    Rows rows = new Rows();
    try (BufferedReader said = process.inputReader()) {
      String address = said.readLine();
      try (MechConnection doomed = MechConnection.open(address, new JarCache(cacheFolder))) {
        MechSession last = doomed.openSession();
        last.loadModel("square.xml", MODEL);
        RemoteRun run = last.prepareRemoteRun(SimulationOptions.asInFile());
        assertThatThrownBy(() -> run.toEnd(rows))
            .isInstanceOf(ServerLostException.class)
            .hasMessage("S-031 the connection to the server at " + address + " is lost");
      }
    } finally {
      process.destroyForcibly();
    }
    assertThat(rows.rows).hasSize(10);
  }

  private static Process startScriptedServer() throws IOException {
    return new ProcessBuilder(
            Path.of(System.getProperty("java.home"), "bin", "java").toString(),
            "-cp",
            System.getProperty("java.class.path"),
            ScriptedServer.class.getName())
        .redirectError(ProcessBuilder.Redirect.DISCARD)
        .start();
  }

  @Test
  void addressWhereNobodyAnswersIsReported() {
    String dead = "127.0.0.1:1";
    assertThatThrownBy(() -> MechConnection.open(dead))
        .isInstanceOf(ServerLostException.class)
        .hasMessageContaining(dead);
  }

  @Test
  void serverOfAnotherContractIsRefused() {
    server.apiVersion = "2.0";
    assertThatThrownBy(() -> MechConnection.open(server.address()))
        .isInstanceOf(ServerLostException.class)
        .hasMessageStartingWith("S-005")
        .hasMessageContaining("2.0");
  }

  @Test
  void invalidModelIsReportedUnderThePathTheUserGave() throws IOException {
    Path file = cacheFolder.resolve("bad.xml");
    Files.writeString(file, "bad");
    assertThatThrownBy(() -> session.loadModel(file))
        .isInstanceOf(InvalidModelException.class)
        .hasMessage(file + ":3:5: M-014 no such joint");
  }

  @Test
  void optionsTravelInTheKeysOfTheContract() {
    session.prepareRemoteRun(
        SimulationOptions.asInFile()
            .relativeTolerance(1e-9)
            .columns(java.util.Set.of(ColumnGroup.ENERGY)));
    assertThat(server.happened).contains("rtol=1.0E-9", "columns=joints,energy");
  }

  @Test
  void reportHasTheServersEntriesAndTheTimesTheClientSaw() throws IOException {
    RunResult result = session.prepareRemoteRun(SimulationOptions.asInFile()).toEnd(new Rows());
    assertThat(result.report())
        .containsEntry("scene", "square")
        .containsEntry("steps", 7L)
        .containsEntry("energyDrift", 1.5e-7)
        .containsEntry("t1s", 0.5)
        .containsEntry("modelSha256", "abc")
        .containsEntry("where", "remote, host here")
        .containsKeys("t1c", "tR")
        .doesNotContainKeys("t2c", "tL");
  }

  @Test
  void localReportHasTheTimesAndSizesOfTheJars() throws IOException {
    RunResult result = session.prepareLocalRun(SimulationOptions.asInFile()).toEnd(new Rows());
    assertThat(result.report())
        .containsEntry("runtimeJarBytes", (long) server.jars.runtime().length)
        .containsKeys("t1c", "t1s", "t2c", "t2s", "tcc", "tL", "modelJarBytes", "modelClassBytes");
  }

  @Test
  void failureOfTheRunIsAnOutcome() throws IOException {
    server.endsAs = SimState.SIM_FAILED;
    RunResult result = session.prepareRemoteRun(SimulationOptions.asInFile()).toEnd(new Rows());
    assertThat(result.outcome())
        .isInstanceOfSatisfying(
            Outcome.Failed.class,
            failed -> assertThat(failed.failure().message()).startsWith("N-001 t=0.5 s"));
  }

  @Test
  void limitThatWasReachedIsAFailureAndTheRowsUpToItAreKept() throws IOException {
    server.endsAs = SimState.SIM_FAILED;
    server.failureCode = "S-108";
    Rows rows = new Rows();
    RunResult result = session.prepareRemoteRun(SimulationOptions.asInFile()).toEnd(rows);
    assertThat(result.outcome())
        .isInstanceOfSatisfying(
            Outcome.Failed.class,
            failed -> assertThat(failed.failure().code()).isEqualTo(MessageCode.RUN_TOO_LONG));
    assertThat(rows.rows).isNotEmpty();
  }

  @Test
  void settingsThatTheSolverRefusesAreNoFailureOfTheRun() {
    server.endsAs = SimState.SIM_FAILED;
    server.failureCode = "S-066";
    RemoteRun run = session.prepareRemoteRun(SimulationOptions.asInFile());
    assertThatThrownBy(() -> run.toEnd(new Rows()))
        .isInstanceOf(InvalidOptionException.class)
        .hasMessageContaining("S-066");
  }

  @Test
  void runIsCancelledWhenItsRowsCannotBeKept() {
    ResultSink full =
        new ResultSink() {
          @Override
          public void begin(List<Variable> columns) {}

          @Override
          public void row(double[] values) throws IOException {
            throw new IOException("disk full");
          }
        };
    RemoteRun run = session.prepareRemoteRun(SimulationOptions.asInFile());
    assertThatThrownBy(() -> run.toEnd(full)).isInstanceOf(IOException.class);
    assertThat(server.happened).contains("cancel");
  }

  @Test
  void listenerHearsProgressStatusAndMessages() throws Exception {
    CountDownLatch heard = new CountDownLatch(3);
    List<Object> news = new ArrayList<>();
    RunListener listener =
        new RunListener() {
          @Override
          public void onStatus(RunState state, String text) {
            news.add(text);
            heard.countDown();
          }

          @Override
          public void onProgress(RunProgress progress) {
            news.add(progress.fraction());
            heard.countDown();
          }

          @Override
          public void onMessages(List<ModelMessage> messages) {
            news.add(messages.get(0).toString());
            heard.countDown();
          }
        };
    session.prepareRemoteRun(SimulationOptions.asInFile(), listener).toEnd(new Rows());
    assertThat(heard.await(1, TimeUnit.MINUTES)).isTrue();
    assertThat(news).containsExactly(0.5, "off we go", "N-000 easy");
  }

  @Test
  void leaseIsRenewedInTheBackground() throws InterruptedException {
    // The first renewal comes after half a second; a minute is for a busy machine.
    for (int i = 0; i < 600 && !server.happened.contains("renew session"); i++) {
      Thread.sleep(100);
    }
    assertThat(server.happened).contains("renew session");
  }

  @Test
  void closingDestroysWhatIsHeldAtTheServer() {
    RemoteRun run = session.prepareRemoteRun(SimulationOptions.asInFile());
    run.close();
    session.close();
    assertThat(server.happened).containsSubsequence("destroy run", "destroy session");
  }

  @Test
  void closedSessionIsReportedAsForgotten() {
    session.close();
    assertThatThrownBy(session::model)
        .isInstanceOf(ServerLostException.class)
        .hasMessageStartingWith("S-033");
  }

  private static Path onlyFileOf(Path folder) throws IOException {
    try (Stream<Path> files = Files.list(folder)) {
      return files
          .reduce(
              (one, other) -> {
                throw new AssertionError("two files");
              })
          .orElseThrow();
    }
  }
}
