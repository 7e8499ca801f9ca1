package org.mechservice.solver.force.applied;

import org.mechservice.solver.force.law.CoordinateLaw;
import org.mechservice.solver.force.law.PairLaw;
import org.mechservice.solver.mechanism.force.ForceElement;

/** A law of the catalogue on one coordinate. */
public final class PrintedScalarLaw implements ScalarLaw {
  private final SettledLaw settled;
  private final Coefficients coefficients;
  private final double[] x = new double[CoordinateLaw.VARIABLES];
  private final double[] load = new double[1];
  private final double[] results = new double[PairLaw.VALUES];

  /**
   * @throws IllegalArgumentException if a coefficient depends on time or the state
   */
  public PrintedScalarLaw(ForceElement element, CoordinateLaw law) {
    settled = SettledLaw.of(law);
    coefficients = new Coefficients(element);
  }

  @Override
  public boolean parameters(double[] values, AppliedForce force) {
    return settled.update(coefficients, values, force);
  }

  @Override
  public double force(double position, double velocity) {
    x[0] = position;
    x[1] = velocity;
    settled.load(x, load);
    return load[0];
  }

  @Override
  public void slopes(double[] by) {
    by[0] = 0;
    by[1] = 0;
    settled.slopes(x, by);
  }

  @Override
  public double potentialEnergy() {
    settled.results(x, results);
    return results[PairLaw.POTENTIAL];
  }

  @Override
  public double power() {
    settled.results(x, results);
    return results[PairLaw.POWER];
  }
}
