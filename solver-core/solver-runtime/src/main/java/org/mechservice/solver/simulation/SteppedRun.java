package org.mechservice.solver.simulation;

import java.io.IOException;
import java.util.Optional;
import org.mechservice.solver.api.ModelDescription;
import org.mechservice.solver.api.run.Checkpoints;
import org.mechservice.solver.api.run.Outcome;
import org.mechservice.solver.api.run.RunReport;
import org.mechservice.solver.ode.SavedState;

/**
 * A run that advances by steps of communication: from one output time to the next. Between two
 * steps the state may be changed, in particular the inputs of the model, which are constant within
 * a step; the integration then begins anew from there. Without a change it goes on as a run that
 * ends a step of the integrator at each row.
 *
 * <p>Begun by {@link RuntimeSolver#stepped}. Workspace of one thread.
 */
public final class SteppedRun {
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

  /** Begins: writes the row of the start. */
  public void begin() throws IOException {
    ended = run.begin();
    run.copyUnknowns(unknowns);
  }

  /**
   * Returns the state from which the next step begins.
   *
   * @param y state [q; v; s], length of the model's state; overwritten
   */
  public void state(double[] y) {
    System.arraycopy(unknowns, 0, y, 0, y.length);
  }

  /**
   * Sets a component of the state from which the next step begins; loops are closed again.
   *
   * @param component index in [q; v; s]
   */
  public void set(int component, double value) {
    boolean another = unknowns[component] != value;
    changed |= another;
    moved |= another && component < coordinates;
    unknowns[component] = value;
  }

  /**
   * Advances to the next output time and writes its row.
   *
   * @return whether the run goes on from there; not if the loops cannot be closed at a state that
   *     was set, which is a failure like those of the integration
   * @throws IllegalStateException if the run has ended
   * @throws IOException if the sink throws it
   */
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

  /** Returns the time reached, s. */
  public double time() {
    return run.timeReached();
  }

  /** Returns how the run has ended; empty if it goes on. */
  public Optional<Outcome> ended() {
    return ended;
  }

  /** Returns the report so far; a run that goes on counts as stopped. */
  public RunReport report() {
    return run.report(ended.orElseGet(Outcome.Stopped::new));
  }

  /**
   * Returns the run between two steps as bytes, with changes for the next step.
   *
   * @throws IllegalStateException if it has not begun or has failed
   */
  public byte[] save() {
    byte[] inner = run.save();
    return SavedState.save(
        state -> {
          state.bytes(inner);
          transfer(state);
        });
  }

  /**
   * Goes on with a saved run of the same model and settings instead of {@link #begin}; its rows are
   * then the same to the bit.
   *
   * @throws IllegalArgumentException S-071 if the bytes do not belong to such a run
   */
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
