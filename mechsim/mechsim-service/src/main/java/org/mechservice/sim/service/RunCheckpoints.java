package org.mechservice.sim.service;

import java.util.List;
import java.util.Optional;
import java.util.function.LongSupplier;
import java.util.function.Supplier;
import org.mechservice.solver.api.Checkpoints;
import org.mechservice.solver.api.TunableParameter;

/**
 * The checkpoint of one run: what it is to go on from, and the latest it has left, made when a
 * client asks and when the run is cancelled. Thread-safe.
 */
final class RunCheckpoints implements Checkpoints {
  /** Finite, so that one is left when the run is cancelled; otherwise only when asked for. */
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
   * @param modelHash finds what identifies the model, when it is needed first
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

  /** Takes the values of the parameters, which identify the model beside its code. */
  synchronized void ofParameters(List<TunableParameter> values) {
    parameters = List.copyOf(values);
  }

  /** Takes what the run is to go on from. */
  synchronized void goOnFrom(byte[] checkpoint) {
    saved = Optional.of(checkpoint.clone());
  }

  /** Takes what counts the rows the run has put out. */
  synchronized void countRowsWith(LongSupplier counter) {
    rows = counter;
  }

  /**
   * Returns whether the run has put out no row since the latest checkpoint: who goes on from there
   * repeats none. A hold that is asked for while the solver is between a step and its look at the
   * control may leave none.
   */
  synchronized boolean isWithoutRowsSince() {
    return latest.isPresent() && rowsAtLatest == rows.getAsLong();
  }

  /** Asks for a checkpoint after the next step; returns the number of the request. */
  synchronized long ask() {
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
