package org.mechservice.solver.ode.step;

import org.mechservice.solver.ode.CompletedSystem;
import org.mechservice.solver.ode.ErrorWeightGroups;
import org.mechservice.solver.ode.OdeSystem;
import org.mechservice.solver.ode.ProjectedSystem;
import org.mechservice.solver.ode.ResidualSystem;
import org.mechservice.solver.ode.ResidualSystem.Component;
import org.mechservice.solver.ode.SystemParts;
import org.mechservice.solver.ode.UnitNormGroups;

/**
 * The knowledge of a problem about its states beyond its equations: components that follow from
 * others ({@link CompletedSystem}) or are algebraic ({@link ResidualSystem#component}), and so are
 * not tested for error, the former unless {@link CompletedSystem#tested} names them; components
 * that share a weight ({@link ErrorWeightGroups}); a manifold that the solution stays on ({@link
 * ProjectedSystem}); groups of norm one ({@link UnitNormGroups}). A problem that knows nothing of
 * that kind is left alone.
 */
public final class Manifold {
  private static final Unknown NOTHING = new Unknown();

  private final CompletedSystem completed;
  private final ProjectedSystem projected;
  private final ErrorWeightGroups groups;
  private final UnitNormGroups units;

  /** Per component: algebraic; independent; tested for error and convergence. */
  private final boolean[] algebraic;

  private final boolean[] independent;
  private final boolean[] tested;
  private boolean anyAlgebraic;

  /**
   * @param system the problem, asked for its parts
   */
  public Manifold(OdeSystem system) {
    this(system, system.dimension());
    choose();
  }

  /**
   * @param system the problem, asked for its parts
   */
  public Manifold(ResidualSystem system) {
    this(system, system.dimension());
    for (int l = 0; l < algebraic.length; l++) {
      algebraic[l] = system.component(l) == Component.ALGEBRAIC;
      anyAlgebraic |= algebraic[l];
    }
    choose();
  }

  private Manifold(SystemParts system, int dimension) {
    completed = system.part(CompletedSystem.class).orElse(NOTHING);
    projected = system.part(ProjectedSystem.class).orElse(NOTHING);
    groups = system.part(ErrorWeightGroups.class).orElse(NOTHING);
    units = system.part(UnitNormGroups.class).orElse(NOTHING);
    algebraic = new boolean[dimension];
    independent = new boolean[dimension];
    tested = new boolean[dimension];
  }

  /** Takes over which components are independent at present, after a saved state was taken up. */
  public void refresh() {
    choose();
  }

  private void choose() {
    for (int l = 0; l < tested.length; l++) {
      independent[l] = completed.independent(l);
      tested[l] = completed.tested(l) && !algebraic[l];
    }
  }

  public int dimension() {
    return tested.length;
  }

  /** Returns whether some components may follow from the others. */
  public boolean completes() {
    return completed != NOTHING;
  }

  /** Returns whether a component has an equation of its own at present. */
  public boolean independent(int component) {
    return independent[component];
  }

  /** Returns whether a component's derivative does not appear in the equations. */
  public boolean algebraic(int component) {
    return algebraic[component];
  }

  public boolean anyAlgebraic() {
    return anyAlgebraic;
  }

  /** Returns whether a component is in the tests of error and convergence at present. */
  boolean tested(int component) {
    return tested[component];
  }

  /** Enlarges the sizes of passive components. */
  void enlarge(double[] sizes) {
    completed.enlarge(sizes);
  }

  /** Returns whether all components are always tested, each by its own size. */
  boolean weighsBySizeAlone() {
    return completed == NOTHING && groups == NOTHING && !anyAlgebraic;
  }

  /** Returns whether a state may be changed by {@link #complete} or {@link #project}. */
  public boolean changesStates() {
    return completed != NOTHING || projected != NOTHING;
  }

  ErrorWeightGroups groups() {
    return groups;
  }

  /** Sets the passive components of a vector to zero. */
  public void clearPassive(double[] x) {
    for (int l = 0; l < independent.length; l++) {
      if (!independent[l]) {
        x[l] = 0;
      }
    }
  }

  /** Makes the passive components fit; returns false if that is not possible. */
  public boolean complete(double t, double[] y) {
    return completed.complete(t, y);
  }

  /** Moves a state onto its manifold; returns false if that is not possible. */
  public boolean project(double t, double[] y) {
    return projected.project(t, y);
  }

  /** Removes the part of an error across the manifold; returns false if it is not known. */
  public boolean projectError(double t, double[] y, double[] error) {
    return projected.projectError(t, y, error);
  }

  /** Takes note of an accepted step; returns whether other components are independent now. */
  public boolean accepted(double t, double[] y) {
    projected.projectionAccepted(t, y);
    if (!completed.accepted(t, y)) {
      return false;
    }
    choose();
    return true;
  }

  /** Scales groups that have left norm one back to it, with their history. */
  public void restoreUnitGroups(double[] y, History history) {
    for (int group = 0; group < units.groupCount(); group++) {
      int start = units.groupStart(group);
      int size = units.groupSize(group);
      double norm = norm(y, start, size);
      if (Math.abs(norm - 1) > UnitNormGroups.NORM_DRIFT) {
        history.scale(start, size, 1 / norm);
      }
    }
  }

  private static double norm(double[] y, int start, int size) {
    double squares = 0;
    for (int l = start; l < start + size; l++) {
      squares += y[l] * y[l];
    }
    return Math.sqrt(squares);
  }

  /** State and differences of a method. */
  public interface History {
    /** Multiplies some components by a factor. */
    void scale(int start, int size, double factor);
  }

  /** Stands in for what a problem does not know. */
  private static final class Unknown implements CompletedSystem, ProjectedSystem, UnitNormGroups {
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
