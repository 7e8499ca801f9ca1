package org.mechservice.solver.dynamics.derivative;

import java.util.List;
import org.mechservice.solver.api.run.RunNotes;

/**
 * The linear equations of an implicit step of an open tree with its further states: those of the
 * mechanism, bordered by those of the states. Workspace of one thread.
 */
public final class TreeStep {
  private final StepReduction mechanism;
  private final BorderedStep bordered;

  /** Whether the last factorisation found pivots for all velocities. */
  private boolean regular;

  /**
   * Makes a workspace.
   *
   * @param mechanism equations of positions and velocities
   * @param further derivatives of the further states, evaluated elsewhere
   */
  public TreeStep(StepReduction mechanism, FurtherDerivatives further) {
    this.mechanism = mechanism;
    bordered = new BorderedStep(mechanism.coordinates, further, mechanism::solve);
  }

  /** Sets the state of the derivatives: y = [q; v; s], not modified. */
  public void setState(double[] y) {
    mechanism.setState(y);
    bordered.setState(y);
  }

  /**
   * Forms and factors the matrix.
   *
   * @param step hγ, s
   * @return whether it is regular
   */
  public boolean factor(double step) {
    regular = mechanism.factor(step);
    return regular && bordered.factor(step);
  }

  /**
   * Solves with the last factors.
   *
   * @param r right-hand side at entry, solution at return
   */
  public void solve(double[] r) {
    bordered.solve(r);
  }

  /**
   * Solves ∂F/∂y' x = r for positions and velocities; the factors of the last matrix stay.
   *
   * @param r right-hand side at entry, solution at return
   * @return false, with r as it was, if M is singular
   */
  public boolean solveForDerivative(double[] r) {
    return mechanism.solveForDerivative(r);
  }

  /** Returns the unknown whose column had no pivot in the last, failed factorisation. */
  public int singularUnknown() {
    return regular ? bordered.singularUnknown() : mechanism.singularUnknown();
  }

  /** Returns notes on the factorisations so far. */
  public List<RunNotes.Note> notes() {
    return mechanism.notes();
  }
}
