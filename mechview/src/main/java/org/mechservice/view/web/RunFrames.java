package org.mechservice.view.web;

import java.util.ArrayList;
import java.util.List;
import org.mechservice.solver.api.result.ResultSink;
import org.mechservice.solver.api.result.Variable;

/** The frames of a run while it runs: rows at least a share of the simulated time apart. */
final class RunFrames implements ResultSink {
  private static final int MOST_FRAMES = 1500;
  private static final int FEWEST_FRAMES = 100;

  /** Numbers kept, of all columns together. */
  private static final int MOST_NUMBERS = 1_000_000;

  private final double span;
  private final List<double[]> frames = new ArrayList<>();
  private List<Variable> columns = List.of();
  private double interval;

  /**
   * @param span simulated time of the run, s
   */
  RunFrames(double span) {
    this.span = span;
  }

  @Override
  public synchronized void begin(List<Variable> announced) {
    columns = List.copyOf(announced);
    int most = Math.max(FEWEST_FRAMES, Math.min(MOST_FRAMES, MOST_NUMBERS / columns.size()));
    interval = Math.abs(span) / most;
  }

  @Override
  public synchronized void row(double[] values) {
    if (frames.isEmpty()
        || Math.abs(values[0] - frames.get(frames.size() - 1)[0]) >= interval * (1 - 1e-9)) {
      frames.add(values.clone());
    }
  }

  synchronized List<Variable> columns() {
    return columns;
  }

  /** Returns the frames from one on, at most so many. */
  synchronized List<double[]> from(int first, int most) {
    return List.copyOf(frames.subList(first, Math.min(frames.size(), first + most)));
  }
}
