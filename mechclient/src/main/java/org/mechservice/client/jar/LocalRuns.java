package org.mechservice.client.jar;

import java.io.IOException;
import java.io.InterruptedIOException;
import java.time.Duration;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import org.mechservice.client.failure.JarRefusedException;
import org.mechservice.client.run.ComputationHere;
import org.mechservice.client.run.ConfinedComputation;
import org.mechservice.client.run.LocalComputation;
import org.mechservice.client.run.LocalRun;
import org.mechservice.client.run.ReportReader;
import org.mechservice.client.run.RunResult;
import org.mechservice.guard.Confinement;
import org.mechservice.guard.UserCode;
import org.mechservice.guard.WorkerBounds;
import org.mechservice.guard.worker.WorkerDescription;
import org.mechservice.guard.worker.WorkerLostException;
import org.mechservice.guard.worker.WorkerModel;
import org.mechservice.guard.worker.WorkerOrder;
import org.mechservice.guard.worker.WorkerProcess;
import org.mechservice.guard.worker.WorkerResult;
import org.mechservice.solver.api.Model;
import org.mechservice.solver.api.ModelSource;
import org.mechservice.solver.api.program.SteppedModel;
import org.mechservice.solver.api.result.ColumnGroup;
import org.mechservice.solver.api.run.RunNotes;
import org.mechservice.solver.api.run.RunReport;
import org.mechservice.solver.api.run.RunRequest;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.catalogue.MessageCode;

/**
 * Runs on this machine of a model that was fetched and verified. Where the model comes from
 * elsewhere, its classes run behind the walls of classes of users and are never loaded in this
 * process.
 *
 * @param columns column groups asked for; empty: those its file selects
 * @param strict whether the first warning ends the run
 * @param maxDrift drift of the energy balance, over the energy scale, that ends it
 * @param silenced warnings that it does not give
 * @param consent whether classes may run where they cannot be confined
 */
public record LocalRuns(
    Optional<Set<ColumnGroup>> columns,
    boolean strict,
    OptionalDouble maxDrift,
    Set<MessageCode> silenced,
    UserCode consent) {

  /** Longest time of a step of a run that is stepped from outside. */
  private static final Duration LONGEST_STEP = Duration.ofMinutes(10);

  /** A model that can run. */
  public interface Prepared {
    /** Returns the reason for the model's formulation; empty if unknown. */
    Optional<String> formulationReason();

    /** Returns its run, with what the client adds to the report. */
    LocalRun run(Map<String, Object> facts);
  }

  private record Ready(VerifiedJar jar, LocalComputation computation, RunRequest request)
      implements Prepared {
    @Override
    public Optional<String> formulationReason() {
      return jar.formulationReason();
    }

    @Override
    public LocalRun run(Map<String, Object> facts) {
      return new LocalRun(computation, jar.sha256(), request, facts);
    }
  }

  /**
   * Begins to start the process of a model that is on its way; it is there when its future is done.
   */
  public static CompletableFuture<WorkerProcess> beginWorker() {
    CompletableFuture<WorkerProcess> ready = new CompletableFuture<>();
    Thread starting =
        new Thread(
            () -> {
              try {
                WorkerProcess worker = new WorkerProcess(Confinement.ofThisMachine(), bounds());
                worker.begin();
                if (!ready.complete(worker)) {
                  worker.close();
                }
              } catch (IOException e) {
                ready.completeExceptionally(e);
              }
            },
            "mech-worker-start");
    starting.setDaemon(true);
    starting.start();
    return ready;
  }

  /** Returns the memory of this process, which its user can change; processor time has no bound. */
  private static WorkerBounds bounds() {
    return new WorkerBounds(Runtime.getRuntime().maxMemory(), -1);
  }

  /** Ends a process that is not needed. */
  public static void end(CompletableFuture<WorkerProcess> begun) {
    if (!begun.cancel(false) && !begun.isCompletedExceptionally()) {
      begun.join().close();
    }
  }

  /** A model that its process has described. */
  private record Described(
      VerifiedJar jar, WorkerProcess worker, WorkerModel model, WorkerDescription said) {}

  /**
   * Prepares a run in a process behind the walls, with the solver of this program.
   *
   * @param begun the process, which has no model yet; ends if there is no run of it
   * @throws JarRefusedException if a class uses what it must not (S-232, S-156), the model cannot
   *     be made, or this machine cannot confine it and there is no consent to that (S-168)
   * @throws IOException if the process cannot be started
   */
  public Prepared confined(BuiltJar modelJar, CompletableFuture<WorkerProcess> begun)
      throws IOException {
    Described in = described(modelJar, begun);
    RunRequest request = request(in.jar(), in.said().settings());
    return new Ready(
        in.jar(),
        new ConfinedComputation(in.worker(), in.model(), in.said(), request, unconfinedNote()),
        request);
  }

  /**
   * Prepares a run that is stepped from outside, as {@link #confined} does.
   *
   * @throws JarRefusedException likewise
   * @throws IOException if the process cannot be started
   */
  public SteppedModel.Source confinedSteps(
      BuiltJar modelJar, CompletableFuture<WorkerProcess> begun) throws IOException {
    Described in = described(modelJar, begun);
    RunRequest request = request(in.jar(), in.said().settings());
    WorkerOrder order = new WorkerOrder(in.model(), Map.of(), request);
    return new SteppedModel.Source(
        rows ->
            in.worker()
                .steps(
                    order,
                    in.jar().sha256(),
                    rows,
                    LONGEST_STEP,
                    told -> report(told, request.settings())),
        in.said().coordinates(),
        in.said().furtherStates(),
        modelJar.inputs());
  }

  private RunReport report(WorkerResult told, RunSettings settings) {
    WorkerResult noted = unconfinedNote().map(told::with).orElse(told);
    return ReportReader.of(
        new RunResult(noted.outcome(), noted.report()),
        settings.tStart(),
        settings.tEnd(),
        settings.tStep());
  }

  private Optional<RunNotes.Note> unconfinedNote() {
    return unconfined(consent.warning(Confinement.ofThisMachine()));
  }

  private Described described(BuiltJar modelJar, CompletableFuture<WorkerProcess> begun)
      throws IOException {
    VerifiedJar jar = VerifiedJar.of(modelJar);
    if (!jar.generated().containsKey(jar.mainClass())) {
      throw VerifiedJar.refused("names " + jar.mainClass() + ", which it does not contain");
    }
    Confinement wall = Confinement.ofThisMachine();
    if (!wall.stands() && !consent.isUnconfined()) {
      throw new JarRefusedException(
          MessageCode.NO_CONFINEMENT.code(),
          "the classes of the model come from the server and run here confined or not at all; "
              + wall.remedy("this machine")
              + "; or compute at the server, without --mode local");
    }
    WorkerModel model = new WorkerModel(jar.mainClass(), jar.generated(), jar.ofUsers());
    try {
      WorkerProcess worker = begun.get();
      return new Described(jar, worker, model, worker.describe(model));
    } catch (WorkerLostException | IllegalArgumentException e) {
      throw VerifiedJar.refused("cannot be loaded: " + e.getMessage());
    } catch (ExecutionException e) {
      throw new IOException(e.getCause());
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new InterruptedIOException("the start of the model's process was not awaited");
    }
  }

  /**
   * Prepares a run in this process: of a model that this program has generated itself, or for whose
   * solver there is consent.
   *
   * @param runtimeJar the solver that came with it; empty: that of this process
   * @throws JarRefusedException if the JARs do not fit this client or each other, or a class uses
   *     what it must not (S-232; of a user: S-156)
   */
  public Prepared here(BuiltJar modelJar, Optional<byte[]> runtimeJar) {
    FetchedModel fetched = FetchedModel.load(VerifiedJar.of(modelJar), runtimeJar, consent);
    ModelSource source = fetched.newSource();
    RunRequest request = request(fetched.jar(), source.model().description().defaults());
    Optional<String> warning = fetched.userCode().filter(text -> !text.isEmpty());
    return new Ready(
        fetched.jar(),
        new ComputationHere(source, fetched.solver(), request, unconfined(warning)),
        request);
  }

  /**
   * Prepares a run that is stepped from outside in this process, as {@link #here} does.
   *
   * @throws JarRefusedException likewise
   */
  public SteppedModel.Source stepsHere(BuiltJar modelJar, Optional<byte[]> runtimeJar) {
    FetchedModel fetched = FetchedModel.load(VerifiedJar.of(modelJar), runtimeJar, consent);
    Model model = fetched.newSource().model();
    RunRequest request = request(fetched.jar(), model.description().defaults());
    return SteppedModel.Source.of(
        fetched.solver(), model, request, fetched.jar().sha256(), modelJar.inputs());
  }

  private RunRequest request(VerifiedJar jar, RunSettings settings) {
    return new RunRequest(settings, columns.orElseGet(jar::shown), strict, maxDrift, silenced);
  }

  private static Optional<RunNotes.Note> unconfined(Optional<String> warning) {
    return warning.map(text -> new RunNotes.Note(MessageCode.USER_CODE_UNCONFINED, 0, true, text));
  }
}
