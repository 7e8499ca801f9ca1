package org.mechservice.solver.integration;

import org.mechservice.solver.integration.ResidualSystem.Component;

/**
 * What a system tells of itself besides its equations: which components are tested for error, which
 * share a weight, which follow from the others, and onto what states are projected.
 */
final class SystemTraits {
  private static final CompletedSystem NOTHING_PASSIVE =
      new CompletedSystem() {
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
      };

  private static final WeightGroups NO_GROUPS =
      new WeightGroups() {
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
      };

  private final CompletedSystem completed;
  private final ProjectedSystem projected;
  private final WeightGroups groups;

  /** Per component: algebraic; independent; tested for error and convergence. */
  private final boolean[] algebraic;

  private final boolean[] independent;
  private final boolean[] tested;
  private boolean anyAlgebraic;

  private SystemTraits(Object system, int dimension) {
    completed = system instanceof CompletedSystem some ? some : NOTHING_PASSIVE;
    projected = system instanceof ProjectedSystem some ? some : (t, y) -> true;
    groups = system instanceof WeightGroups some ? some : NO_GROUPS;
    algebraic = new boolean[dimension];
    independent = new boolean[dimension];
    tested = new boolean[dimension];
  }

  static SystemTraits of(OdeSystem system) {
    SystemTraits traits = new SystemTraits(system, system.dimension());
    traits.choose();
    return traits;
  }

  static SystemTraits of(ResidualSystem system) {
    SystemTraits traits = new SystemTraits(system, system.dimension());
    for (int l = 0; l < traits.algebraic.length; l++) {
      traits.algebraic[l] = system.component(l) == Component.ALGEBRAIC;
      traits.anyAlgebraic |= traits.algebraic[l];
    }
    traits.choose();
    return traits;
  }

  /** Takes over which components are independent at present. */
  private void choose() {
    for (int l = 0; l < tested.length; l++) {
      independent[l] = completed.independent(l);
      tested[l] = independent[l] && !algebraic[l];
    }
  }

  int dimension() {
    return tested.length;
  }

  /** Returns whether some components may follow from the others. */
  boolean completes() {
    return completed != NOTHING_PASSIVE;
  }

  /** Returns whether a component has an equation of its own at present. */
  boolean independent(int component) {
    return independent[component];
  }

  /** Returns whether a component's derivative does not appear in the equations. */
  boolean algebraic(int component) {
    return algebraic[component];
  }

  boolean anyAlgebraic() {
    return anyAlgebraic;
  }

  /** Returns whether a component is in the tests of error and convergence at present. */
  boolean tested(int component) {
    return tested[component];
  }

  WeightGroups groups() {
    return groups;
  }

  /** Sets the passive components of a vector to zero. */
  void clearPassive(double[] x) {
    for (int l = 0; l < independent.length; l++) {
      if (!independent[l]) {
        x[l] = 0;
      }
    }
  }

  /** Makes the passive components fit; returns false if that is not possible. */
  boolean complete(double t, double[] y) {
    return completed.complete(t, y);
  }

  /** Moves a state onto its manifold; returns false if that is not possible. */
  boolean project(double t, double[] y) {
    return projected.project(t, y);
  }

  /** Takes note of an accepted step; returns whether other components are independent now. */
  boolean accepted(double t, double[] y) {
    if (!completed.accepted(t, y)) {
      return false;
    }
    choose();
    return true;
  }
}
