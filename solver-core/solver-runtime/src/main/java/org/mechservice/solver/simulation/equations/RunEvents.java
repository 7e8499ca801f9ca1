package org.mechservice.solver.simulation.equations;

import java.util.List;
import java.util.Optional;
import org.mechservice.solver.api.capability.MomentumBalance;
import org.mechservice.solver.api.run.Failure;
import org.mechservice.solver.api.run.RunNotes.Note;
import org.mechservice.solver.ode.Integrator;

/** What happens along a run besides its equations: here, nothing. */
public class RunEvents {
  RunEvents() {}

  /** Returns the integrator that notices what happens. */
  public Integrator watch(Integrator integrator) {
    return integrator;
  }

  /**
   * Returns the next instant of the last step that is to be a row, s; infinite if there is none.
   */
  public double dueRow() {
    return Double.POSITIVE_INFINITY;
  }

  /** Takes note of the row of {@link #dueRow}. */
  public void rowWritten() {}

  /** Returns the energy that changes of the state have put in since this was asked last, J. */
  public double workOfEvents() {
    return 0;
  }

  /** Returns where to evaluate instead of at {@code t}, at which a prescribed motion may jump. */
  double evaluationTime(double t) {
    return t;
  }

  /** Takes the balance of momentum, which is told what changes of the state do to it. */
  public void setMomentumBalance(MomentumBalance momentum) {}

  /** Returns what happened, for the report. */
  public List<Note> notes() {
    return List.of();
  }

  /** Returns why the run cannot go on, if an event could not do what it says. */
  public Optional<Failure> failure() {
    return Optional.empty();
  }

  /** Returns the event that a failure of the integrator lies at; empty if none can be named. */
  public String part() {
    return "";
  }
}
