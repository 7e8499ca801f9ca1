package org.mechservice.sim.service;

import java.util.ArrayList;
import java.util.List;
import org.mechservice.idl.CurveSample;
import org.mechservice.solver.api.RunControl;

/**
 * How a run goes: a few hundred samples over all of it, however long it is. When there are too
 * many, every other one is dropped and half as many are taken from then on.
 */
final class RunCurves {
  private static final int MOST = 600;

  private final List<CurveSample> samples = new ArrayList<>();
  private int period = 1;
  private int sinceLast;

  /** Takes a sample, if it is time for one. */
  synchronized void sample(RunControl control, double energyDrift, double residual) {
    sinceLast++;
    if (sinceLast < period) {
      return;
    }
    sinceLast = 0;
    samples.add(
        new CurveSample(
            System.currentTimeMillis(),
            control.time(),
            control.stepSize(),
            control.order(),
            energyDrift,
            residual));
    if (samples.size() > MOST) {
      thinOut();
    }
  }

  private void thinOut() {
    for (int i = samples.size() - 1; i > 0; i -= 2) {
      samples.remove(i);
    }
    period *= 2;
  }

  synchronized List<CurveSample> all() {
    return List.copyOf(samples);
  }
}
