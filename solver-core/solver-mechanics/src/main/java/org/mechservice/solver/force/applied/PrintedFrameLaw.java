package org.mechservice.solver.force.applied;

import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.force.law.PairLaw;
import org.mechservice.solver.mechanism.force.ForceElement;

/** A law of the catalogue between two frames. */
public final class PrintedFrameLaw implements FrameLaw {
  private final PairLaw law;
  private final SettledLaw settled;
  private final Coefficients coefficients;
  private double[] x = {};
  private final double[] load = new double[PairLaw.DIRECTION + 1];
  private final double[] results;

  /**
   * @param valueCount number of output values
   * @throws IllegalArgumentException if a coefficient depends on time or the state
   */
  public PrintedFrameLaw(ForceElement element, PairLaw law, int valueCount) {
    this.law = law;
    settled = SettledLaw.of(law);
    coefficients = new Coefficients(element);
    results = new double[PairLaw.VALUES + valueCount];
  }

  @Override
  public boolean parameters(double[] values, AppliedForce force) {
    return settled.update(coefficients, values, force);
  }

  @Override
  public boolean wrench(FrameMotion motion, double[] w, AppliedForce force) {
    x = motion.x;
    settled.load(x, load);
    if (load[PairLaw.DIRECTION] <= 0) {
      results();
      return force.fail(
          MessageCode.FORCE_WITHOUT_DIRECTION,
          law.undirected().cause(results),
          law.undirected().advice());
    }
    System.arraycopy(load, 0, w, 0, w.length);
    return true;
  }

  @Override
  public void slopes(FrameMotion motion, double[] by) {
    settled.slopes(x, by);
  }

  private void results() {
    settled.results(x, results);
  }

  @Override
  public double potentialEnergy() {
    results();
    return results[PairLaw.POTENTIAL];
  }

  @Override
  public double power(FrameMotion motion, double[] w) {
    results();
    return results[PairLaw.POWER];
  }

  @Override
  public void values(FrameMotion motion, double[] out, int at) {
    results();
    System.arraycopy(results, PairLaw.VALUES, out, at, results.length - PairLaw.VALUES);
  }
}
