package org.mechservice.solver.simulation;

import java.io.IOException;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.mechservice.solver.api.ModelDescription;
import org.mechservice.solver.api.result.ResultSink;
import org.mechservice.solver.api.result.Variable;
import org.mechservice.solver.api.run.RunNotes.Note;
import org.mechservice.solver.api.run.RunReport;
import org.mechservice.solver.api.run.RunRequest;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.catalogue.MessageCode;

/**
 * Measures in the rows of a run the motion of the states. It warns if all states stay below their
 * absolute tolerances: the error test then accepts every step, and a run may miss the motion.
 */
final class MotionObserver implements ResultSink {
  private static final MessageCode CODE = MessageCode.ABSOLUTE_TOLERANCE_TOO_LARGE;

  /** Motion of a position, relative to 1 plus its size, that is rounding of a mechanism at rest. */
  private static final double ROUNDING = 1e-12;

  private final ResultSink sink;
  private final List<Variable> states;
  private final int positions;
  private final double[] start;

  /** Largest distance of positions from their start, and largest size of velocities. */
  private final double[] motion;

  private boolean begun;

  MotionObserver(ResultSink sink, ModelDescription model) {
    this.sink = sink;
    states = model.states();
    positions = model.positionCount();
    start = new double[states.size()];
    motion = new double[states.size()];
  }

  @Override
  public void begin(List<Variable> columns) throws IOException {
    sink.begin(columns);
  }

  @Override
  public void row(double[] values) throws IOException {
    sink.row(values);
    if (!begun) {
      System.arraycopy(values, 1, start, 0, positions);
      begun = true;
    }
    for (int i = 0; i < motion.length; i++) {
      motion[i] = Math.max(motion[i], Math.abs(values[1 + i] - start[i]));
    }
  }

  /** Returns the report of the run with the warning, if there is one to give. */
  RunReport completed(RunReport report, RunRequest request) {
    return warning(report.settings(), report.timeReached())
        .map(warning -> DeferredWarning.added(report, warning, request))
        .orElse(report);
  }

  private Optional<Note> warning(RunSettings settings, double t) {
    boolean moves = false;
    int largest = 0;
    double part = 0;
    for (int i = 0; i < motion.length; i++) {
      double relative = motion[i] / settings.absoluteTolerance(states.get(i).unit());
      moves |= i < positions && motion[i] > ROUNDING * (1 + Math.abs(start[i]));
      if (!(relative <= part)) {
        part = relative;
        largest = i;
      }
    }
    return moves && part <= 1
        ? Optional.of(new Note(CODE, t, true, text(largest, settings)))
        : Optional.empty();
  }

  private String text(int state, RunSettings settings) {
    String unit = states.get(state).unit();
    return String.format(
        Locale.ROOT,
        "The absolute tolerance, %.1e %s, is larger than every motion: the largest motion is"
            + " %.1e %s, of \"%s\". Steps may have missed it; write absTol=\"%.0e\".",
        settings.absoluteTolerance(unit),
        unit,
        motion[state],
        unit,
        states.get(state).name(),
        settings.relativeTolerance() * motion[state]);
  }
}
