package org.mechservice.solver.simulation;

import java.io.IOException;
import java.util.Optional;
import org.mechservice.solver.api.Model;
import org.mechservice.solver.api.capability.DependentStates;
import org.mechservice.solver.api.capability.ModelState;
import org.mechservice.solver.api.run.Checkpoints;
import org.mechservice.solver.api.run.RunRequest;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.ode.SavedState;

/** Writes checkpoints of a run, and restores one if it belongs to exactly this run. */
final class CheckpointWriter {
  private static final double NANOSECONDS = 1e9;
  private static final String AROUND_COMPONENTS = "[\\[\\], ]+";

  private final Model model;
  private final RunRequest request;
  private final Checkpoints store;
  private long lastAt = System.nanoTime();

  /**
   * @throws IllegalArgumentException if checkpoints are requested and the model cannot be saved
   */
  CheckpointWriter(Model model, RunRequest request, Checkpoints store) {
    this.model = model;
    this.request = request;
    this.store = store;
    boolean asked = store.saved().isPresent() || Double.isFinite(store.secondsBetween());
    if (asked && !canBeSaved(model)) {
      throw new IllegalArgumentException(
          MessageCode.MODEL_CANNOT_BE_SAVED
              + " model \""
              + model.description().name()
              + "\" does not tell the state of its loops, so a run of it cannot be saved; run it"
              + " without checkpoints");
    }
  }

  /** Returns whether a run of a model can be resumed with the same bits. */
  static boolean canBeSaved(Model model) {
    return !(model instanceof DependentStates) || model instanceof ModelState;
  }

  Optional<byte[]> saved() {
    return store.saved();
  }

  /**
   * Restores a checkpoint.
   *
   * @throws IllegalArgumentException S-071 if it does not belong to this run
   */
  void restore(byte[] saved, SavedState.Part run) {
    try {
      SavedState.restore(saved, state -> transfer(state, run));
    } catch (IllegalArgumentException e) {
      throw new IllegalArgumentException(MessageCode.CHECKPOINT_UNUSABLE + " " + e.getMessage(), e);
    }
  }

  /**
   * Stores a checkpoint if it is due.
   *
   * @param stands whether the run ends or is paused here and may be resumed later
   * @return whether it was due
   */
  boolean keepIfDue(boolean stands, SavedState.Part run) throws IOException {
    double distance = store.secondsBetween();
    double since = (System.nanoTime() - lastAt) / NANOSECONDS;
    boolean due = since >= distance || (stands && Double.isFinite(distance));
    if (due) {
      store.keep(save(run));
      lastAt = System.nanoTime();
    }
    return due;
  }

  /** Returns a checkpoint. */
  byte[] save(SavedState.Part run) {
    return SavedState.save(state -> transfer(state, run));
  }

  private void transfer(SavedState state, SavedState.Part run) {
    state.require("model", model.description().name());
    state.require("formulation", model.description().formulation());
    state.require("hash of the model", store.modelHash());
    state.require("solver version", SolverVersion.CURRENT);
    requireSettings(state, request.settings().toString());
    state.require("list of column groups", request.columns().stream().sorted().toList());
    state.require("energy balance", request.maxDrift().isPresent() ? "watched" : "not watched");
    run.transfer(state);
  }

  /**
   * Compares the settings as the text of their record, which has the same components in the same
   * order within one version of the solver; the message names those that differ.
   */
  private static void requireSettings(SavedState state, String here) {
    String[] now = here.split(AROUND_COMPONENTS, -1);
    String[] saved = state.text(here).split(AROUND_COMPONENTS, -1);
    String different = "";
    for (int i = 0; i < Math.min(now.length, saved.length); i++) {
      if (!now[i].equals(saved[i])) {
        different += ", " + now[i] + " instead of " + saved[i];
      }
    }
    if (!different.isEmpty()) {
      throw new IllegalArgumentException(
          "the run has other settings than the saved state" + different);
    }
  }
}
