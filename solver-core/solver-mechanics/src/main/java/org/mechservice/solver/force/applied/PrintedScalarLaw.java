package org.mechservice.solver.force.applied;

import org.mechservice.solver.force.law.CoordinateLaw;
import org.mechservice.solver.force.law.PairLaw;
import org.mechservice.solver.force.law.PrintedLaw;
import org.mechservice.solver.force.law.printed.PrintedLaws;
import org.mechservice.solver.mechanism.force.ForceElement;

/** A law of the catalogue on one coordinate. */
public final class PrintedScalarLaw implements ScalarLaw {
  private final CoordinateLaw law;
  private final PrintedLaw plain;
  private final PrintedLaw smooth;
  private PrintedLaw printed;
  private final Coefficients coefficients;
  private final double[] x = new double[CoordinateLaw.VARIABLES];
  private final double[] c;
  private final double[] load = new double[1];
  private final double[] results = new double[PairLaw.VALUES];

  /**
   * @throws IllegalArgumentException if a coefficient depends on time or the state
   */
  public PrintedScalarLaw(ForceElement element, CoordinateLaw law) {
    this.law = law;
    plain = PrintedLaws.of(law, false);
    smooth = PrintedLaws.of(law, true);
    printed = plain;
    coefficients = new Coefficients(element);
    c = new double[Math.max(plain.size(), smooth.size())];
  }

  @Override
  public boolean parameters(double[] values, AppliedForce force) {
    boolean usable = coefficients.update(values, c, force);
    printed = law.smoothing() >= 0 && c[law.smoothing()] > 0 ? smooth : plain;
    printed.settle(c, c);
    return usable;
  }

  @Override
  public double force(double position, double velocity) {
    x[0] = position;
    x[1] = velocity;
    printed.load(x, c, load);
    return load[0];
  }

  @Override
  public void slopes(double[] by) {
    by[0] = 0;
    by[1] = 0;
    printed.slopes(x, c, by);
  }

  @Override
  public double potentialEnergy() {
    printed.results(x, c, results);
    return results[PairLaw.POTENTIAL];
  }

  @Override
  public double power() {
    printed.results(x, c, results);
    return results[PairLaw.POWER];
  }
}
