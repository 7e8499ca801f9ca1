package org.mechservice.solver.simulation;

import java.io.IOException;
import java.util.Optional;
import org.mechservice.solver.api.ModelDescription;
import org.mechservice.solver.api.run.Checkpoints;
import org.mechservice.solver.api.run.Outcome;
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
  private final double[] unknowns;
  private Optional<Outcome> ended = Optional.empty();
  private final int coordinates;
  private boolean changed;
  private boolean moved;

  SteppedRun(Simulation.Run run) {
    this.run = run;
    ModelDescription description = run.equations().model().description();
    coordinates = description.positionCount() + description.velocityCount();
    unknowns = new double[run.equations().dimension()];
  }

  @Override
  public void begin() throws IOException {
    ended = run.begin();
    run.copyUnknowns(unknowns);
  }

  @Override
  public void state(double[] y) {
    System.arraycopy(unknowns, 0, y, 0, y.length);
  }

  @Override
  public void set(int component, double value) {
    boolean another = unknowns[component] != value;
    changed |= another;
    moved |= another && component < coordinates;
    unknowns[component] = value;
  }

  @Override
  public boolean step() throws IOException {
    if (ended.isPresent()) {
      throw new IllegalStateException("the run has ended at " + run.timeReached() + " s");
    }
    if (changed) {
      ended = run.goOnFrom(unknowns, moved);
      changed = false;
      moved = false;
    }
    if (ended.isEmpty()) {
      ended = run.stepToRow();
    }
    run.copyUnknowns(unknowns);
    return ended.isEmpty();
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
  }

  private void transfer(SavedState state) {
    state.numbers(unknowns);
    changed = state.flag(changed);
    moved = state.flag(moved);
  }
}
