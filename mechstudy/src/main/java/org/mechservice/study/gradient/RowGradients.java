package org.mechservice.study.gradient;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import org.mechservice.library.MechModel;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.solver.ode.solve.IntegrationException;
import org.mechservice.study.Reduction;

/**
 * Derivatives of reductions as studies compute them: of the rows of a run, with straight lines
 * between. Optimisers need them, since the derivatives of a motion's integrals and extremes are
 * those of other numbers than the values that rows give. Thread-safe: each thread has a workspace
 * of its own.
 */
public final class RowGradients {
  private final List<Reduction> reductions;
  private final List<String> by;
  private final List<String> columns;
  private final ThreadLocal<Gradients> workplaces;

  private RowGradients(List<String> by, List<Reduction> reductions, ThreadLocal<Gradients> places) {
    this.by = by;
    this.reductions = reductions;
    columns = new ArrayList<>(columnsOf(reductions));
    workplaces = places;
  }

  private static Set<String> columnsOf(List<Reduction> reductions) {
    Set<String> columns = new LinkedHashSet<>();
    reductions.forEach(reduction -> columns.add(reduction.column()));
    return columns;
  }

  /**
   * Prepares derivatives of reductions by parameters.
   *
   * @throws MechmlException if the model cannot be read with the parameters as inputs
   * @throws IllegalArgumentException if there are none: the model has events, a part without
   *     derivative, or masses and points that depend on the parameters; says which
   */
  public static RowGradients of(MechModel model, List<String> by, List<Reduction> reductions)
      throws MechmlException {
    if (!model.content().watchedMechanism().events().isEmpty()) {
      throw new IllegalArgumentException("the model has events, which add rows to its runs");
    }
    List<Reduction> series =
        columnsOf(reductions).stream()
            .map(column -> new Reduction(column, Reduction.Kind.SERIES, Double.NaN))
            .toList();
    List<Reduction> times =
        reductions.stream().allMatch(r -> r.kind() == Reduction.Kind.AT) ? reductions : series;
    Gradients first = Gradients.of(model, by, times);
    if (first.tunable().size() < by.size()) {
      List<String> others = new ArrayList<>(by);
      others.removeAll(first.tunable());
      throw new IllegalArgumentException(
          "masses, points or settings depend on " + String.join(", ", others));
    }
    ThreadLocal<Gradients> places =
        ThreadLocal.withInitial(
            () -> {
              try {
                return Gradients.of(model, by, times);
              } catch (MechmlException e) {
                throw new IllegalStateException("the model was read before", e);
              }
            });
    places.set(first);
    return new RowGradients(List.copyOf(by), List.copyOf(reductions), places);
  }

  /**
   * Returns the derivatives at values of the parameters.
   *
   * @param values in the units of the file, in the order of the parameters
   * @return a row for each reduction
   * @throws IllegalArgumentException if there are none there, or the motion cannot be computed
   */
  public double[][] at(double[] values) {
    Gradients gradients = workplaces.get();
    for (int k = 0; k < values.length; k++) {
      gradients.set(by.get(k), values[k]);
    }
    Gradient rows;
    try {
      rows = gradients.compute(GradientMethod.FORWARD);
    } catch (IntegrationException e) {
      throw new IllegalArgumentException(e.getMessage(), e);
    }
    if (reductions.equals(gradients.outputs())) {
      return rows.derivatives();
    }
    double[][] slopes = new double[reductions.size()][];
    List<Reduction> at = gradients.outputs();
    int count = at.size() / columns.size();
    for (int i = 0; i < slopes.length; i++) {
      int from = columns.indexOf(reductions.get(i).column()) * count;
      double[] time = new double[count];
      double[] value = new double[count];
      double[][] slope = new double[count][];
      for (int row = 0; row < count; row++) {
        time[row] = at.get(from + row).argument();
        value[row] = rows.values()[from + row];
        slope[row] = rows.derivatives()[from + row];
      }
      slopes[i] = reduced(reductions.get(i), time, value, slope);
    }
    return slopes;
  }

  private double[] reduced(Reduction wanted, double[] time, double[] value, double[][] slope) {
    double[] weight = new double[time.length];
    int last = time.length - 1;
    double length = time[last] - time[0];
    switch (wanted.kind()) {
      case LAST -> weight[last] = 1;
      case MIN, MAX -> weight[extreme(wanted.kind(), value)] = 1;
      case INTEGRAL -> trapezoids(time, weight, 1);
      case MEAN -> trapezoids(time, weight, 1 / length);
      case RMS -> squares(time, value, weight);
      case AT -> between(time, wanted.argument(), weight);
      case CROSSING -> crossing(wanted.argument(), time, value, weight);
      case SERIES -> throw new IllegalArgumentException("a series is not one number");
    }
    double[] sum = new double[by.size()];
    for (int row = 0; row <= last; row++) {
      for (int k = 0; k < sum.length && weight[row] != 0; k++) {
        sum[k] += weight[row] * slope[row][k];
      }
    }
    return sum;
  }

  private static int extreme(Reduction.Kind kind, double[] value) {
    int best = 0;
    for (int row = 1; row < value.length; row++) {
      if (kind == Reduction.Kind.MIN ? value[row] < value[best] : value[row] > value[best]) {
        best = row;
      }
    }
    return best;
  }

  private static void trapezoids(double[] time, double[] weight, double factor) {
    for (int row = 1; row < time.length; row++) {
      double half = factor * (time[row] - time[row - 1]) / 2;
      weight[row - 1] += half;
      weight[row] += half;
    }
  }

  /** √(Σ dt (a² + ab + b²) / 3 / T), differentiated by a and b. */
  private static void squares(double[] time, double[] value, double[] weight) {
    double sum = 0;
    for (int row = 1; row < time.length; row++) {
      double a = value[row - 1];
      double b = value[row];
      double third = (time[row] - time[row - 1]) / 3;
      sum += third * (a * a + a * b + b * b);
      weight[row - 1] += third * (2 * a + b);
      weight[row] += third * (a + 2 * b);
    }
    double length = time[time.length - 1] - time[0];
    double rms = Math.sqrt(sum / length);
    for (int row = 0; row < weight.length; row++) {
      weight[row] /= 2 * length * rms;
    }
  }

  private static void between(double[] time, double at, double[] weight) {
    for (int row = 0; row < time.length; row++) {
      if (time[row] >= at) {
        double part = row == 0 ? 0 : (time[row] - at) / (time[row] - time[row - 1]);
        weight[row] += 1 - part;
        if (row > 0) {
          weight[row - 1] += part;
        }
        return;
      }
    }
  }

  /** t = t1 − dt (x1 − level) / (x1 − x0), differentiated by x0 and x1. */
  private static void crossing(double level, double[] time, double[] value, double[] weight) {
    for (int row = 1; row < time.length; row++) {
      double before = value[row - 1] - level;
      double after = value[row] - level;
      if (before * after <= 0 && before != after) {
        double dt = time[row] - time[row - 1];
        double way = after - before;
        weight[row] = dt * before / (way * way);
        weight[row - 1] = -dt * after / (way * way);
        return;
      }
    }
  }
}
