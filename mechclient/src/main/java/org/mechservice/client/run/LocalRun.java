package org.mechservice.client.run;

import java.io.IOException;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.mechservice.client.failure.InvalidOptionException;
import org.mechservice.client.failure.InvalidStateException;
import org.mechservice.client.failure.JarRefusedException;
import org.mechservice.client.failure.RunState;
import org.mechservice.client.failure.ServiceException;
import org.mechservice.solver.api.ModelSource;
import org.mechservice.solver.api.TunableParameter;
import org.mechservice.solver.api.result.ResultSink;
import org.mechservice.solver.api.run.Checkpoints;
import org.mechservice.solver.api.run.RunControl;
import org.mechservice.solver.api.run.RunRequest;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.catalogue.MessageCode;

/**
 * A run on this machine with the model class that was fetched from the server. It no longer needs
 * the server. It runs once.
 */
public final class LocalRun implements PreparedRun {
  /** Longest wait of a cancel for the end of a step, ms. */
  private static final long LONGEST_STEP_MILLIS = 1000;

  private final LocalComputation computation;
  private final Map<String, String> parameters = new LinkedHashMap<>();
  private final String modelSha256;
  private final RunRequest request;
  private final Map<String, Object> facts;
  private final RunControl control = new RunControl();
  private volatile RunState state = RunState.CREATED;

  /** Whether the run leaves checkpoints. */
  private volatile boolean saved;

  /**
   * @param computation what computes it, in this process or in one of its own
   * @param modelSha256 of the JAR the model came in
   */
  public LocalRun(
      LocalComputation computation,
      String modelSha256,
      RunRequest request,
      Map<String, Object> facts) {
    this.computation = computation;
    this.modelSha256 = modelSha256;
    this.request = request;
    this.facts = facts;
  }

  @Override
  public List<TunableParameter> parameters() {
    return computation.parameters().stream()
        .map(
            p ->
                parameters.containsKey(p.name())
                    ? new TunableParameter(
                        p.name(), p.unit(), Double.parseDouble(parameters.get(p.name())))
                    : p)
        .toList();
  }

  @Override
  public void setParameters(Map<String, String> values) {
    if (state != RunState.CREATED) {
      throw new InvalidStateException(
          MessageCode.WRONG_STATE.code(),
          "parameters are set before the start; prepare another run",
          state);
    }
    Map<String, String> all = new LinkedHashMap<>(parameters);
    values.forEach((name, value) -> all.put(name, value.strip()));
    try {
      ModelSource.numbers(computation.parameters(), all);
    } catch (IllegalArgumentException e) {
      String text = String.valueOf(e.getMessage());
      throw new InvalidOptionException(
          ServiceException.codeOf(text, MessageCode.SOLVER_REFUSED.code()), text, "set");
    }
    parameters.putAll(all);
  }

  @Override
  public RunResult toEnd(ResultSink sink, CheckpointStore store) throws IOException {
    saved = Double.isFinite(store.secondsBetween());
    state = RunState.RUNNING;
    try {
      RunResult done = computation.run(parameters, sink, control, checkpoints(store));
      Map<String, Object> report = new LinkedHashMap<>(done.report());
      facts.forEach(report::putIfAbsent);
      return new RunResult(done.outcome(), report);
    } catch (IllegalArgumentException e) {
      String text = String.valueOf(e.getMessage());
      throw new InvalidOptionException(
          ServiceException.codeOf(text, MessageCode.SOLVER_REFUSED.code()), text, "");
    } catch (LinkageError e) {
      throw new JarRefusedException(
          MessageCode.JAR_REFUSED.code(),
          "the model JAR does not fit the runtime JAR it came with: " + e);
    } finally {
      state = RunState.DONE;
    }
  }

  private Checkpoints checkpoints(CheckpointStore store) {
    return new Checkpoints() {
      @Override
      public String modelHash() {
        return parameters.isEmpty() ? modelSha256 : modelSha256 + " with " + parameters;
      }

      @Override
      public double secondsBetween() {
        return store.secondsBetween();
      }

      @Override
      public Optional<byte[]> saved() {
        return store.saved();
      }

      @Override
      public void keep(byte[] checkpoint) throws IOException {
        store.keep(checkpoint);
      }
    };
  }

  /** {@inheritDoc} A run with checkpoints stops after its step, if that does not take long. */
  @Override
  public void cancel() {
    try {
      if (saved && state == RunState.RUNNING) {
        control.stopAfterStep(LONGEST_STEP_MILLIS, () -> state != RunState.RUNNING);
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    } finally {
      control.stop();
    }
  }

  @Override
  public RunProgress progress() {
    RunSettings settings = request.settings();
    return new RunProgress(
        state,
        0,
        control.time(),
        settings.tStart(),
        settings.tEnd(),
        control.steps(),
        control.stepSize(),
        control.order(),
        0,
        0);
  }

  @Override
  public void close() {
    cancel();
    computation.close();
  }
}
