package org.mechservice.study.optimise;

import java.nio.DoubleBuffer;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;

/**
 * All points of one start, each computed once. Methods ask for them on the unit cube; objectives
 * and constraints come scaled, so that 1 is a value of common size.
 */
final class Trials {
  /** More runs than a start may have. */
  static final class OutOfRunsException extends RuntimeException {
    private static final long serialVersionUID = 1L;

    OutOfRunsException() {
      super("the runs of this start are used up");
    }
  }

  /** A failing point ends a start whose user gave no value for such points. */
  static final class StartFailedException extends RuntimeException {
    private static final long serialVersionUID = 1L;

    StartFailedException(String message) {
      super(message);
    }
  }

  private final DesignProblem problem;
  private final int start;
  private final int mostRuns;
  private final OptionalDouble failedAs;
  private final List<Trial> all = new ArrayList<>();
  private final Map<DoubleBuffer, Trial> known = new HashMap<>();
  private final double[] scales;
  private Optional<Trial> best = Optional.empty();
  private double objectiveScale = 1;
  private boolean measured;

  Trials(DesignProblem problem, int start, int mostRuns, OptionalDouble failedAs) {
    this.problem = problem;
    this.start = start;
    this.mostRuns = mostRuns;
    this.failedAs = failedAs;
    scales = problem.aims().stream().mapToDouble(Aim::scale).toArray();
  }

  /** Returns the points in the order in which they were computed. */
  List<Trial> all() {
    return all;
  }

  Optional<Trial> best() {
    return best;
  }

  /** Returns the runs that are left. */
  int left() {
    return mostRuns - all.size();
  }

  /** Returns the scaled objective. */
  double objective(double[] parts) {
    return at(parts).objective() / objectiveScale;
  }

  /** Returns the size of an aim that counts as 1, that of the objective for objectives. */
  double scale(int aim) {
    return switch (problem.aims().get(aim).kind()) {
      case MINIMISE, RESIDUAL -> objectiveScale;
      case AT_MOST_ZERO, ZERO -> scales[aim];
    };
  }

  /** Returns the residuals, without the other aims. */
  double[] residuals(double[] parts) throws PointFailedException {
    return chosen(computed(parts), Aim.Kind.RESIDUAL, false);
  }

  /** Returns the scaled constraints of one kind; all hold at a point that failed. */
  double[] constraints(double[] parts, Aim.Kind kind) {
    Trial trial = at(parts);
    int count = count(kind);
    return trial.failure().isPresent() ? new double[count] : chosen(trial, kind, true);
  }

  int count(Aim.Kind kind) {
    return (int) problem.aims().stream().filter(aim -> aim.kind() == kind).count();
  }

  /**
   * Returns the scaled objective, then the scaled constraints that are to be at most zero, then
   * those that are to be zero.
   */
  double[] scaled(double[] parts) throws PointFailedException {
    Trial trial = computed(parts);
    double[] atMost = chosen(trial, Aim.Kind.AT_MOST_ZERO, true);
    double[] zero = chosen(trial, Aim.Kind.ZERO, true);
    double[] values = new double[1 + atMost.length + zero.length];
    values[0] = trial.objective() / objectiveScale;
    System.arraycopy(atMost, 0, values, 1, atMost.length);
    System.arraycopy(zero, 0, values, 1 + atMost.length, zero.length);
    return values;
  }

  /**
   * Returns the derivatives of {@link #residuals}, or of {@link #scaled}, on the unit cube.
   *
   * @param step of differences, where the problem has no derivatives
   */
  Derivatives slopes(boolean ofResiduals, double step) {
    if (problem.slopes().isEmpty()) {
      return new CentralDifferences(ofResiduals ? this::residuals : this::scaled, step);
    }
    Derivatives known = problem.slopes().get();
    return parts -> {
      computed(parts);
      double[][] all = known.at(problem.point(parts));
      List<double[]> rows = new ArrayList<>();
      if (!ofResiduals) {
        add(all, Aim.Kind.MINIMISE, rows);
        add(all, Aim.Kind.AT_MOST_ZERO, rows);
        add(all, Aim.Kind.ZERO, rows);
      } else {
        add(all, Aim.Kind.RESIDUAL, rows);
      }
      return rows.toArray(double[][]::new);
    };
  }

  private void add(double[][] all, Aim.Kind kind, List<double[]> rows) {
    for (int i = 0; i < all.length; i++) {
      if (problem.aims().get(i).kind() == kind) {
        double scale =
            switch (kind) {
              case MINIMISE -> objectiveScale;
              case RESIDUAL -> 1;
              case AT_MOST_ZERO, ZERO -> scales[i];
            };
        double[] row = new double[all[i].length];
        for (int j = 0; j < row.length; j++) {
          row[j] = all[i][j] * problem.range(j) / scale;
        }
        rows.add(row);
      }
    }
  }

  private Trial computed(double[] parts) throws PointFailedException {
    Trial trial = at(parts);
    if (trial.failure().isPresent()) {
      throw new PointFailedException(trial.failure().get());
    }
    return trial;
  }

  private double[] chosen(Trial trial, Aim.Kind kind, boolean scaled) {
    double[] values = new double[count(kind)];
    int k = 0;
    for (int i = 0; i < scales.length; i++) {
      if (problem.aims().get(i).kind() == kind) {
        values[k++] = scaled ? trial.values()[i] / scales[i] : trial.values()[i];
      }
    }
    return values;
  }

  /** Returns the trial at a point of the unit cube; points outside are moved to its faces. */
  Trial at(double[] parts) {
    double[] point = problem.point(parts);
    DoubleBuffer key = DoubleBuffer.wrap(point);
    Trial trial = known.get(key);
    if (trial == null) {
      if (all.size() >= mostRuns) {
        throw new OutOfRunsException();
      }
      trial = run(point);
      known.put(key, trial);
      all.add(trial);
      if (best.isEmpty() || trial.isBetterThan(best.get())) {
        best = Optional.of(trial);
      }
    }
    return trial;
  }

  private Trial run(double[] point) {
    int number = all.size() + 1;
    try {
      double[] values = problem.response().at(point.clone());
      for (int i = 0; i < values.length; i++) {
        if (!Double.isFinite(values[i])) {
          throw new PointFailedException(
              problem.aims().get(i).text() + " is " + values[i] + ", which is no finite number");
        }
      }
      double objective = minimised(values);
      if (!measured) {
        measure(values, objective);
        measured = true;
      }
      return new Trial(
          start, number, point, values, objective, violation(values), Optional.empty());
    } catch (PointFailedException e) {
      String why = String.valueOf(e.getMessage());
      if (failedAs.isEmpty()) {
        throw new StartFailedException(
            String.valueOf(
                PointFailedException.at(problem.variables(), point, "the run", why).getMessage()));
      }
      double[] none = new double[scales.length];
      Arrays.fill(none, Double.NaN);
      return new Trial(
          start,
          number,
          point,
          none,
          failedAs.getAsDouble(),
          Double.POSITIVE_INFINITY,
          Optional.of(why));
    }
  }

  /** The first point says what size quantities have. */
  private void measure(double[] values, double objective) {
    objectiveScale = objective == 0 ? 1 : Math.abs(objective);
    for (int i = 0; i < scales.length; i++) {
      if (scales[i] == 0) {
        scales[i] = values[i] == 0 ? 1 : Math.abs(values[i]);
      }
    }
  }

  private double minimised(double[] values) {
    double sum = 0;
    for (int i = 0; i < values.length; i++) {
      switch (problem.aims().get(i).kind()) {
        case MINIMISE -> sum += values[i];
        case RESIDUAL -> sum += values[i] * values[i];
        case AT_MOST_ZERO, ZERO -> {}
      }
    }
    return sum;
  }

  private double violation(double[] values) {
    double largest = 0;
    for (int i = 0; i < values.length; i++) {
      double scaled = values[i] / scales[i];
      switch (problem.aims().get(i).kind()) {
        case AT_MOST_ZERO -> largest = Math.max(largest, scaled);
        case ZERO -> largest = Math.max(largest, Math.abs(scaled));
        case MINIMISE, RESIDUAL -> {}
      }
    }
    return largest;
  }
}
