package org.mechservice.report.stability;

import org.mechservice.report.measure.MeasuredRun;
import org.mechservice.report.method.SimulationMethod;

/**
 * The outcome of one method for a case.
 *
 * @param method the method
 * @param verdict how that is judged
 * @param measured error or change of energy; NaN where nothing moved
 * @param run counts and costs
 */
public record MethodOutcome(
    SimulationMethod method, Verdict verdict, double measured, MeasuredRun run) {
  private static final String CODED = "(?s).*\\b[MNS]-\\d{3}\\b.*";

  /** The verdict on an outcome. */
  public enum Verdict {
    /** The bound is met. */
    MET,
    /** It ended with a message that has a code. */
    SAID_WHY,
    /** It was stopped when its time was over. */
    TOO_LONG,
    /** It moved, and nothing can judge it. */
    NOT_JUDGED,
    /** The run ended without a message and its result is wrong, which must never happen. */
    SILENTLY_WRONG,
    /** It ended without a message that has a code. */
    ANONYMOUS
  }

  /** Judges a run. */
  static MethodOutcome of(SimulationMethod method, MeasuredRun run, ExtremeCase wanted) {
    if (!run.completed()) {
      boolean late = run.cause().startsWith("not finished");
      Verdict verdict =
          late
              ? Verdict.TOO_LONG
              : run.cause().matches(CODED) ? Verdict.SAID_WHY : Verdict.ANONYMOUS;
      return new MethodOutcome(method, verdict, Double.NaN, run);
    }
    double measured =
        wanted.judge() == ExtremeCase.JudgedBy.REFERENCE
            ? run.errors().largest()
            : run.energyDrift();
    return new MethodOutcome(method, verdict(measured, wanted.bound()), measured, run);
  }

  private static Verdict verdict(double measured, double bound) {
    if (Double.isNaN(measured)) {
      return Verdict.NOT_JUDGED;
    }
    return measured <= bound ? Verdict.MET : Verdict.SILENTLY_WRONG;
  }
}
