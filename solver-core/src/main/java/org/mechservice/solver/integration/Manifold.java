package org.mechservice.solver.integration;

/**
 * What a problem knows about its states beyond its equations: components that follow from others
 * ({@link CompletedSystem}), a manifold that the solution stays on ({@link ProjectedSystem}),
 * groups of norm one ({@link UnitGroups}). A problem that knows nothing of that kind is left alone.
 */
final class Manifold {
  private static final Unknown NOTHING = new Unknown();

  private final CompletedSystem completed;
  private final ProjectedSystem projected;
  private final UnitGroups units;

  /**
   * @param system the problem, asked for what it implements
   */
  Manifold(Object system) {
    completed = system instanceof CompletedSystem known ? known : NOTHING;
    projected = system instanceof ProjectedSystem known ? known : NOTHING;
    units = system instanceof UnitGroups known ? known : NOTHING;
  }

  /** Returns whether a state may be changed by {@link #complete} or {@link #project}. */
  boolean changesStates() {
    return completed != NOTHING || projected != NOTHING;
  }

  /** Fits the passive components to the independent ones; returns false if nothing fits. */
  boolean complete(double t, double[] y) {
    return completed.complete(t, y);
  }

  /** Moves a completed state onto the manifold; returns false if there is no way. */
  boolean project(double t, double[] y) {
    return projected.project(t, y);
  }

  /** Takes the passive components out of a norm that has just been weighed. */
  void leaveOutPassive(ErrorNorm norm, int dimension) {
    if (completed == NOTHING) {
      return;
    }
    for (int l = 0; l < dimension; l++) {
      if (!completed.independent(l)) {
        norm.leaveOut(l);
      }
    }
  }

  /** Lets the problem take note of an accepted step. */
  void accepted(double t, double[] y) {
    completed.accepted(t, y);
  }

  int unitGroupCount() {
    return units.groupCount();
  }

  /** Returns the first component of a group of norm one. */
  int unitGroupStart(int group) {
    return units.groupStart(group);
  }

  /** Returns the number of components of a group of norm one. */
  int unitGroupSize(int group) {
    return units.groupSize(group);
  }

  /** Returns the factor that brings a group back to norm one; 1 while it has hardly left it. */
  double unitFactor(int group, double[] y) {
    int start = units.groupStart(group);
    double squares = 0;
    for (int l = start; l < start + units.groupSize(group); l++) {
      squares += y[l] * y[l];
    }
    double norm = Math.sqrt(squares);
    return Math.abs(norm - 1) > UnitGroups.NORM_DRIFT ? 1 / norm : 1;
  }

  /** Stands in for what a problem does not know. */
  private static final class Unknown implements CompletedSystem, ProjectedSystem, UnitGroups {
    @Override
    public boolean independent(int component) {
      return true;
    }

    @Override
    public boolean complete(double t, double[] y) {
      return true;
    }

    @Override
    public boolean accepted(double t, double[] y) {
      return false;
    }

    @Override
    public boolean project(double t, double[] y) {
      return true;
    }

    @Override
    public int groupCount() {
      return 0;
    }

    @Override
    public int groupStart(int group) {
      return 0;
    }

    @Override
    public int groupSize(int group) {
      return 0;
    }
  }
}
