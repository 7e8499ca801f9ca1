package org.mechservice.sim.service;

/**
 * Follows the energy and the constraint residuals of a run by its rows, as far as it puts them out.
 * One thread writes, any number read.
 */
final class RunColumnsWatch {
  private final int kinetic;
  private final int potential;
  private final int work;
  private final int residual;
  private double initialEnergy = Double.NaN;
  private volatile double drift = Double.NaN;
  private volatile double lastResidual = Double.NaN;

  RunColumnsWatch(RunColumns columns) {
    kinetic = columns.indexOf("energy.kinetic");
    potential = columns.indexOf("energy.potential");
    work = columns.indexOf("energy.work");
    residual = columns.indexOf("constraint.position");
  }

  /**
   * Looks at a row.
   *
   * @param values not modified
   */
  void row(double[] values) {
    if (kinetic >= 0 && potential >= 0) {
      double energy = values[kinetic] + values[potential] - (work >= 0 ? values[work] : 0);
      if (Double.isNaN(initialEnergy)) {
        initialEnergy = energy;
      }
      drift = energy - initialEnergy;
    }
    if (residual >= 0) {
      lastResidual = values[residual];
    }
  }

  /** Returns the energy beyond that of the start and the work done, J; NaN if not known. */
  double energyDrift() {
    return drift;
  }

  /** Returns the largest position residual of the constraints; NaN if not known. */
  double residual() {
    return lastResidual;
  }
}
