package org.mechservice.study;

import java.util.Arrays;
import java.util.List;
import org.mechservice.solver.api.result.ResultSink;
import org.mechservice.solver.api.result.Variable;

/**
 * Reduces the rows of one run after another as they come; keeps none of them. Of one thread at a
 * time; {@link PointModel#reducer} makes them.
 */
public final class Reducer implements ResultSink {
  private final List<Reduction> reductions;
  private final int[] column;
  private final double[] value;
  private List<Variable> columns = List.of();
  private double[] before = new double[0];
  private double start;
  private int rows;

  /**
   * @param reductions without series: these are single values at their times
   */
  Reducer(List<Reduction> reductions) {
    this.reductions = reductions;
    column = new int[reductions.size()];
    value = new double[reductions.size()];
  }

  @Override
  public void begin(List<Variable> announced) {
    if (!announced.equals(columns)) {
      columns = List.copyOf(announced);
      before = new double[columns.size()];
      List<String> names = columns.stream().map(Variable::name).toList();
      Arrays.setAll(column, i -> names.indexOf(reductions.get(i).column()));
    }
    rows = 0;
    Arrays.fill(value, Double.NaN);
  }

  @Override
  public void row(double[] row) {
    for (int i = 0; i < value.length; i++) {
      if (column[i] >= 0) {
        take(i, row, row[column[i]]);
      }
    }
    if (rows == 0) {
      start = row[0];
    }
    rows++;
    System.arraycopy(row, 0, before, 0, before.length);
  }

  private void take(int i, double[] row, double x) {
    boolean first = rows == 0;
    double x0 = first ? x : before[column[i]];
    double t = row[0];
    double dt = first ? 0 : t - before[0];
    Reduction wanted = reductions.get(i);
    switch (wanted.kind()) {
      case LAST -> value[i] = x;
      case MIN -> value[i] = first ? x : Math.min(value[i], x);
      case MAX -> value[i] = first ? x : Math.max(value[i], x);
      case MEAN, INTEGRAL -> value[i] = first ? 0 : value[i] + dt * (x0 + x) / 2;
      case RMS -> value[i] = first ? 0 : value[i] + dt * (x0 * x0 + x0 * x + x * x) / 3;
      case AT, SERIES -> at(i, wanted.argument(), t, dt, x0, x);
      case CROSSING -> crossing(i, wanted.argument(), t, dt, x0, x);
    }
  }

  private void at(int i, double time, double t, double dt, double x0, double x) {
    if (t == time) {
      value[i] = x;
    } else if (t > time && t - dt < time && dt > 0) {
      value[i] = x - (t - time) / dt * (x - x0);
    }
  }

  private void crossing(int i, double level, double t, double dt, double x0, double x) {
    if (!Double.isNaN(value[i])) {
      return;
    }
    if (x == level) {
      value[i] = t;
    } else if ((x0 < level && x > level) || (x0 > level && x < level)) {
      value[i] = t - dt * ((x - level) / (x - x0));
    }
  }

  /** Returns the values of the run that has ended, in the order of the reductions. */
  public double[] values() {
    double[] all = value.clone();
    double time = rows == 0 ? Double.NaN : before[0] - start;
    for (int i = 0; i < all.length; i++) {
      double last = rows == 0 || column[i] < 0 ? Double.NaN : before[column[i]];
      switch (reductions.get(i).kind()) {
        case MEAN -> all[i] = time > 0 ? all[i] / time : last;
        case RMS -> all[i] = time > 0 ? Math.sqrt(all[i] / time) : Math.abs(last);
        case LAST, MIN, MAX, INTEGRAL, AT, SERIES, CROSSING -> {
          // complete
        }
      }
    }
    return all;
  }
}
