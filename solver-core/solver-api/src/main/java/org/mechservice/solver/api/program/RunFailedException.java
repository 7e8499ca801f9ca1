package org.mechservice.solver.api.program;

import java.util.Optional;
import org.mechservice.solver.api.run.Failure;
import org.mechservice.solver.api.run.Outcome;
import org.mechservice.solver.api.run.RunReport;

/** A run or an analysis could not go on. The rows up to there are valid. */
public final class RunFailedException extends RuntimeException {
  private static final long serialVersionUID = 1L;

  private final transient Failure failure;
  private final transient RunReport report;
  private final transient Optional<Trajectory> rows;

  /**
   * @param rows those up to the failure; empty if a sink or a file has taken them
   */
  public RunFailedException(Failure failure, RunReport report, Optional<Trajectory> rows) {
    super(failure.message());
    this.failure = failure;
    this.report = report;
    this.rows = rows;
  }

  /**
   * Throws if a run failed.
   *
   * @param rows those up to its end; empty if a sink or a file has taken them
   * @throws RunFailedException if it did
   */
  public static void throwIfFailed(RunReport report, Optional<Trajectory> rows) {
    if (report.outcome() instanceof Outcome.Failed failed) {
      throw new RunFailedException(failed.failure(), report, rows);
    }
  }

  /** Returns why: its code, when and where it happened, and what to do about it. */
  public Failure failure() {
    return failure;
  }

  /** Returns what happened until then. */
  public RunReport report() {
    return report;
  }

  /** Returns the rows up to the failure; empty if a sink or a file has taken them. */
  public Optional<Trajectory> rows() {
    return rows;
  }
}
