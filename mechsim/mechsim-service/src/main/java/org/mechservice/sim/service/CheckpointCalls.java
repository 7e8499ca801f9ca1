package org.mechservice.sim.service;

import java.util.Optional;
import org.mechservice.idl.InvalidState;
import org.mechservice.idl.MAX_WAIT_MILLIS;
import org.mechservice.idl.NotAvailable;
import org.mechservice.idl.SimState;
import org.mechservice.solver.catalogue.MessageCode;

/**
 * What clients ask about the checkpoints of a run.
 *
 * @param run the run
 */
record CheckpointCalls(SimulationRun run) {
  private static final long SLICE_MILLIS = 5;

  /**
   * Makes a checkpoint of a run after its current step. A run that has been cancelled has left one.
   *
   * @throws InvalidState if there is nothing to save yet or any more, or the run stands still
   * @throws NotAvailable if the run cannot be saved
   */
  byte[] make() throws InvalidState, NotAvailable, InterruptedException {
    RunCheckpoints checkpoints = requirePossible();
    if (run.state() == SimState.SIM_CREATED || run.state() == SimState.SIM_QUEUED) {
      throw Refusal.state(run.state(), "the simulation has not begun: there is nothing to save");
    }
    long request = checkpoints.ask();
    long slices = MAX_WAIT_MILLIS.value / SLICE_MILLIS;
    for (long i = 0; i < slices && !checkpoints.answers(request) && !stands(); i++) {
      Thread.sleep(SLICE_MILLIS);
    }
    Optional<byte[]> found =
        checkpoints.answers(request) || isSavedWhereItStands(checkpoints)
            ? checkpoints.latest()
            : Optional.empty();
    return found.orElseThrow(
        () ->
            Refusal.state(
                run.state(),
                run.ended()
                    ? "the simulation has ended: there is no checkpoint of it"
                    : "the simulation takes no step just now; it is saved after its next one"));
  }

  /** Whoever stops or holds a run finds it saved where it stands. */
  private boolean stands() {
    return (run.ended() && !run.computes()) || run.state() == SimState.SIM_PAUSED;
  }

  private boolean isSavedWhereItStands(RunCheckpoints checkpoints) {
    return run.ended() || (run.state() == SimState.SIM_PAUSED && checkpoints.isWithoutRowsSince());
  }

  /**
   * Takes a checkpoint for a run to go on from; whether it fits shows when the run is started.
   *
   * @throws InvalidState if the run was started before
   * @throws NotAvailable if the run cannot be saved
   */
  void restore(byte[] checkpoint) throws InvalidState, NotAvailable {
    if (run.state() != SimState.SIM_CREATED) {
      throw Refusal.state(run.state(), "the simulation was started before; create another one");
    }
    requirePossible().goOnFrom(checkpoint);
  }

  private RunCheckpoints requirePossible() throws NotAvailable {
    return run.checkpoints()
        .orElseThrow(
            () ->
                new NotAvailable(
                    MessageCode.MODEL_CANNOT_BE_SAVED.code(),
                    "a run of the model cannot be saved: its loops do not tell their state"));
  }
}
