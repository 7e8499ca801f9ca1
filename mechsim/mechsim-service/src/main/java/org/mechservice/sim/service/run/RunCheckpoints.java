package org.mechservice.sim.service.run;

import java.util.List;
import java.util.Optional;
import java.util.function.LongSupplier;
import java.util.function.Supplier;
import org.mechservice.solver.api.TunableParameter;
import org.mechservice.solver.api.run.Checkpoints;

/**
 * The checkpoints of one run: the one it starts from, and the latest it has made, when a client
 * requested one or when the run was cancelled. Thread-safe.
 */
final class RunCheckpoints implements Checkpoints {
  /** Seconds between checkpoints without a request: finite, so that a cancelled run makes one. */
  private static final double WHEN_ASKED = Double.MAX_VALUE;

  private final Supplier<String> modelHash;
  private final boolean possible;
  private Optional<byte[]> saved = Optional.empty();
  private Optional<byte[]> latest = Optional.empty();
  private List<TunableParameter> parameters = List.of();
  private LongSupplier rows = () -> 0;
  private long rowsAtLatest;
  private long asked;
  private long answered;

  /**
   * @param modelHash computes the hash of the model, when it is needed first
   * @param possible whether the model can be saved
   */
  RunCheckpoints(Supplier<String> modelHash, boolean possible) {
    this.modelHash = modelHash;
    this.possible = possible;
  }

  /** Returns whether the run can be saved at all. */
  boolean possible() {
    return possible;
  }

  /** Sets the values of the parameters; they identify the model together with its code. */
  synchronized void ofParameters(List<TunableParameter> values) {
    parameters = List.copyOf(values);
  }

  /** Sets the checkpoint that the run starts from. */
  synchronized void startFrom(byte[] checkpoint) {
    saved = Optional.of(checkpoint.clone());
  }

  /** Sets the counter of the rows that the run has put out. */
  synchronized void countRowsWith(LongSupplier counter) {
    rows = counter;
  }

  /**
   * Returns whether the run has put out no row since the latest checkpoint, so that a run from
   * there repeats none. A hold that arrives after a step, before the solver looks at its control,
   * may leave no checkpoint.
   */
  synchronized boolean isWithoutRowsSince() {
    return latest.isPresent() && rowsAtLatest == rows.getAsLong();
  }

  /** Requests a checkpoint after the next step; returns the number of the request. */
  synchronized long request() {
    asked++;
    return asked;
  }

  /** Returns whether the latest checkpoint was made after a request. */
  synchronized boolean answers(long request) {
    return answered >= request;
  }

  /** Returns the latest checkpoint. */
  synchronized Optional<byte[]> latest() {
    return latest;
  }

  @Override
  public synchronized String modelHash() {
    return parameters.isEmpty() ? modelHash.get() : modelHash.get() + " with " + parameters;
  }

  @Override
  public synchronized double secondsBetween() {
    if (!possible) {
      return Double.POSITIVE_INFINITY;
    }
    return asked > answered ? 0 : WHEN_ASKED;
  }

  @Override
  public synchronized Optional<byte[]> saved() {
    return saved;
  }

  @Override
  public synchronized void keep(byte[] checkpoint) {
    latest = Optional.of(checkpoint);
    rowsAtLatest = rows.getAsLong();
    answered = asked;
  }
}
