package org.mechservice.cli.simulate;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Consumer;
import java.util.function.Supplier;
import org.mechservice.client.failure.ModelMessage;
import org.mechservice.client.run.LocalRun;
import org.mechservice.client.run.PreparedRun;
import org.mechservice.client.run.RunListener;
import org.mechservice.client.run.RunProgress;
import org.mechservice.solver.catalogue.MessageCode;

/** Progress and warnings of a run: sent by the server, or read from the local run. */
final class RunFollower implements RunListener {
  /** Codes of the messages about a run whose host is drained or lost, or that was cancelled. */
  private static final Set<String> TOLD_AT_ONCE =
      Set.of(
          MessageCode.CANCELLED_BY_OPERATOR.code(),
          MessageCode.RUN_STAYS_ON_DRAINING_HOST.code(),
          MessageCode.RUN_MOVED.code(),
          MessageCode.RUN_PLACED_AGAIN.code());

  private final Consumer<String> aloud;
  private final List<ModelMessage> warnings = new CopyOnWriteArrayList<>();
  private boolean hasWaited;
  private volatile Optional<RunProgress> told = Optional.empty();
  private volatile Supplier<Optional<RunProgress>> latest = () -> told;

  /**
   * @param aloud receives at once that the run has moved, has to wait or was cancelled by an
   *     operator
   */
  RunFollower(Consumer<String> aloud) {
    this.aloud = aloud;
  }

  /** Follows a local run, which sends no progress by itself. */
  PreparedRun watch(LocalRun run) {
    latest = () -> Optional.of(run.progress());
    return run;
  }

  @Override
  public void onProgress(RunProgress progress) {
    if (progress.queuePosition() > 0 && !hasWaited) {
      hasWaited = true;
      aloud.accept("waiting for room, place " + progress.queuePosition() + " in the queue");
    }
    told = Optional.of(progress);
  }

  @Override
  public void onMessages(List<ModelMessage> messages) {
    messages.stream()
        .filter(message -> TOLD_AT_ONCE.contains(message.code()))
        .map(ModelMessage::toString)
        .forEach(aloud);
    messages.stream()
        .filter(message -> message.severity() == ModelMessage.Severity.WARNING)
        .forEach(warnings::add);
  }

  /** Returns the latest progress; empty if there is none yet. */
  Optional<RunProgress> latest() {
    return latest.get();
  }

  /** Returns the warnings of the run so far. */
  List<ModelMessage> warnings() {
    return warnings;
  }
}
