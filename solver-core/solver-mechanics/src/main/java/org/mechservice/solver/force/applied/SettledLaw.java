package org.mechservice.solver.force.applied;

import org.mechservice.solver.force.law.CoordinateLaw;
import org.mechservice.solver.force.law.PairLaw;
import org.mechservice.solver.force.law.PrintedLaw;
import org.mechservice.solver.force.law.printed.PrintedLaws;

/** A printed law with its coefficients, in the form that these call for: plain or smooth. */
final class SettledLaw {
  private final PrintedLaw plain;
  private final PrintedLaw smooth;
  private final int smoothing;
  private final double[] c;
  private PrintedLaw law;

  private SettledLaw(PrintedLaw plain, PrintedLaw smooth, int smoothing) {
    this.plain = plain;
    this.smooth = smooth;
    this.smoothing = smoothing;
    c = new double[Math.max(plain.size(), smooth.size())];
    law = plain;
  }

  static SettledLaw of(PairLaw law) {
    return new SettledLaw(PrintedLaws.of(law, false), PrintedLaws.of(law, true), law.smoothing());
  }

  static SettledLaw of(CoordinateLaw law) {
    return new SettledLaw(PrintedLaws.of(law, false), PrintedLaws.of(law, true), law.smoothing());
  }

  /**
   * Evaluates the coefficients and what depends on them alone.
   *
   * @param parameters values of all parameters, SI units; not modified
   * @param force receives the defect of a coefficient that cannot be used
   * @return false if there is one
   */
  boolean update(Coefficients coefficients, double[] parameters, AppliedForce force) {
    if (!coefficients.update(parameters, c, force)) {
      return false;
    }
    law = smoothing >= 0 && c[smoothing] > 0 ? smooth : plain;
    law.settle(c, c);
    return true;
  }

  /** Returns the coefficients; those that a state decides may be overwritten. */
  double[] coefficients() {
    return c;
  }

  /** {@link PrintedLaw#load}. */
  void load(double[] x, double[] out) {
    law.load(x, c, out);
  }

  /** {@link PrintedLaw#slopes}. */
  void slopes(double[] x, double[] out) {
    law.slopes(x, c, out);
  }

  /** {@link PrintedLaw#results}. */
  void results(double[] x, double[] out) {
    law.results(x, c, out);
  }
}
