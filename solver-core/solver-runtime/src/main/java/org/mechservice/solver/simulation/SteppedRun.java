package org.mechservice.solver.simulation;

import java.io.IOException;
import java.util.Arrays;
import java.util.Optional;
import org.mechservice.solver.api.run.Checkpoints;
import org.mechservice.solver.api.run.Outcome;
import org.mechservice.solver.api.run.RunControl;
import org.mechservice.solver.api.run.RunReport;
import org.mechservice.solver.api.run.StepwiseRun;
import org.mechservice.solver.ode.SavedState;

/** A run of {@link Simulation} by steps of communication. Workspace of one thread. */
final class SteppedRun implements StepwiseRun {
  /** Checkpoints that are asked for, not stored. */
  record Saving(String modelHash) implements Checkpoints {
    @Override
    public Optional<byte[]> saved() {
      return Optional.empty();
    }

    @Override
    public double secondsBetween() {
      return Double.POSITIVE_INFINITY;
    }

    @Override
    public void keep(byte[] checkpoint) {}
  }

  private final Simulation.Run run;
  private final RunControl control;

  /** The unknowns that the run has reached, and those from which it goes on. */
  private final double[] present;

  private final double[] unknowns;
  private Optional<Outcome> ended = Optional.empty();
  private volatile boolean stepping;

  /**
   * @param control that of the run
   */
  SteppedRun(Simulation.Run run, RunControl control) {
    this.run = run;
    this.control = control;
    present = new double[run.equations().dimension()];
    unknowns = new double[present.length];
  }

  @Override
  public void begin() throws IOException {
    ended = run.begin();
    run.copyUnknowns(present);
    setBack();
  }

  private void setBack() {
    System.arraycopy(present, 0, unknowns, 0, present.length);
  }

  @Override
  public void state(double[] y) {
    System.arraycopy(unknowns, 0, y, 0, y.length);
  }

  @Override
  public void set(int component, double value) {
    unknowns[component] = value;
  }

  @Override
  public void settle() throws IOException {
    requireGoesOn();
    takeOver();
    if (ended.isEmpty()) {
      ended = run.writeRow(unknowns);
    }
  }

  /** Goes on from what was set, if anything was. */
  private void takeOver() {
    if (Arrays.equals(present, unknowns)) {
      return;
    }
    try {
      ended = run.goOnFrom(present, unknowns);
    } catch (IllegalArgumentException e) {
      setBack();
      throw e;
    }
    System.arraycopy(unknowns, 0, present, 0, present.length);
  }

  private void requireGoesOn() {
    if (ended.isPresent()) {
      throw new IllegalStateException("the run has ended at " + run.timeReached() + " s");
    }
  }

  @Override
  public boolean step() throws IOException {
    requireGoesOn();
    stepping = true;
    try {
      takeOver();
      if (ended.isEmpty()) {
        ended = run.stepToRow();
      }
    } finally {
      stepping = false;
    }
    run.copyUnknowns(present);
    setBack();
    return ended.isEmpty();
  }

  @Override
  public void interrupt() {
    if (stepping) {
      control.stop();
    }
  }

  @Override
  public double time() {
    return run.timeReached();
  }

  @Override
  public Optional<Outcome> ended() {
    return ended;
  }

  @Override
  public RunReport report() {
    return run.report(ended.orElseGet(Outcome.Stopped::new));
  }

  @Override
  public byte[] save() {
    byte[] inner = run.save();
    return SavedState.save(
        state -> {
          state.bytes(inner);
          transfer(state);
        });
  }

  @Override
  public void restore(byte[] saved) {
    SavedState.restore(
        saved,
        state -> {
          run.restore(state.bytes(new byte[0]));
          transfer(state);
        });
    ended = Optional.empty();
  }

  private void transfer(SavedState state) {
    state.numbers(present);
    state.numbers(unknowns);
  }
}
