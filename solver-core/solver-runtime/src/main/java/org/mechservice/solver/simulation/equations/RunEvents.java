package org.mechservice.solver.simulation.equations;

import java.util.List;
import java.util.Optional;
import org.mechservice.solver.api.capability.MomentumBalance;
import org.mechservice.solver.api.run.Failure;
import org.mechservice.solver.api.run.RunNotes.Note;
import org.mechservice.solver.ode.Integrator;

/** The events of a run; this class has none. */
public class RunEvents {
  RunEvents() {}

  /** Returns an integrator that locates the events. */
  public Integrator watch(Integrator integrator) {
    return integrator;
  }

  /**
   * Applies what happens at the start of the run to the state.
   *
   * @param t start, s
   * @param y state there; may be overwritten
   */
  public void begin(double t, double[] y) {}

  /**
   * Returns the next instant of the last step that is to be a row, s; infinite if there is none.
   */
  public double dueRow() {
    return Double.POSITIVE_INFINITY;
  }

  /** Records that the row of {@link #dueRow} was written. */
  public void rowWritten() {}

  /** Returns the energy that changes of the state have added since the last call, J. */
  public double workOfEvents() {
    return 0;
  }

  /**
   * Writes the unknowns after the changes at a time.
   *
   * @param t time, s
   * @param unknowns overwritten if there are changes
   * @return whether there are
   */
  public boolean stateAfter(double t, double[] unknowns) {
    return false;
  }

  /** Records that the run continues from a time with a state given from outside. */
  public void continueFrom(double t) {}

  /** Returns the time for evaluations at {@code t}, at which a prescribed motion may jump. */
  double evaluationTime(double t) {
    return t;
  }

  /** Sets the balance of momentum, to which changes of the state are added. */
  public void setMomentumBalance(MomentumBalance momentum) {}

  /** Returns notes on the events, for the report. */
  public List<Note> notes() {
    return List.of();
  }

  /** Returns the failure of the run if the action of an event failed. */
  public Optional<Failure> failure() {
    return Optional.empty();
  }

  /** Returns the event at which the integrator failed; empty if none can be named. */
  public String part() {
    return "";
  }
}
