package org.mechservice.study.gradient;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import org.mechservice.library.MechModel;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.solver.api.ModelParameter;
import org.mechservice.solver.ode.solve.IntegrationException;
import org.mechservice.study.Reduction;

/**
 * Derivatives of reductions as studies compute them: of the rows of a run, with straight lines
 * between. Optimisers need them, since the derivatives of a motion's integrals and extremes are
 * those of other numbers than the values that rows give. Parameters that masses and points depend
 * on have equations of their own for each of their values. Thread-safe: each thread has a workspace
 * of its own.
 */
public final class RowGradients {
  private final List<Reduction> reductions;
  private final List<String> by;
  private final List<String> columns;
  private final ThreadLocal<Workplace> workplaces;

  /** The workspace of one thread: the equations at the latest values of settled parameters. */
  private static final class Workplace {
    private final MechModel model;
    private final List<String> by;
    private final List<Reduction> times;
    private Gradients gradients;
    private Map<String, Double> settled;

    Workplace(MechModel model, List<String> by, List<Reduction> times) throws MechmlException {
      this.model = model;
      this.by = by;
      this.times = times;
      gradients = Gradients.of(model, by, times);
      settled =
          model.parameters().stream()
              .filter(p -> by.contains(p.name()) && !gradients.tunable().contains(p.name()))
              .collect(Collectors.toMap(ModelParameter::name, ModelParameter::value));
    }

    /** Returns the equations at values of the parameters. */
    Gradients at(double[] values) throws MechmlException {
      Map<String, Double> here = new LinkedHashMap<>();
      for (String name : settled.keySet()) {
        here.put(name, values[by.indexOf(name)]);
      }
      if (!here.equals(settled)) {
        gradients = Gradients.of(model.set(here), by, times);
        settled = here;
      }
      for (String name : gradients.tunable()) {
        gradients.set(name, values[by.indexOf(name)]);
      }
      return gradients;
    }
  }

  private RowGradients(List<String> by, List<Reduction> reductions, ThreadLocal<Workplace> places) {
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
   *     derivative, or rows whose times depend on the parameters; says which
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
    List<String> names = List.copyOf(by);
    Workplace first = new Workplace(model, names, times);
    for (Map.Entry<String, Double> settled : first.settled.entrySet()) {
      requireSameRows(model, settled.getKey(), settled.getValue());
    }
    ThreadLocal<Workplace> places =
        ThreadLocal.withInitial(
            () -> {
              try {
                return new Workplace(model, names, times);
              } catch (MechmlException e) {
                throw new IllegalStateException("the model was read before", e);
              }
            });
    places.set(first);
    return new RowGradients(names, List.copyOf(reductions), places);
  }

  private static void requireSameRows(MechModel model, String name, double value)
      throws MechmlException {
    double moved = value == 0 ? Gradients.STEP : value * (1 + Gradients.STEP);
    if (model.set(name, moved).request().settings().tStep() != model.request().settings().tStep()) {
      throw new IllegalArgumentException("the times of the rows depend on " + name);
    }
  }

  /**
   * Returns the derivatives at values of the parameters.
   *
   * @param values in the units of the file, in the order of the parameters
   * @return a row for each reduction
   * @throws IllegalArgumentException if there are none there, or the motion cannot be computed
   */
  public double[][] at(double[] values) {
    Gradients gradients;
    Gradient rows;
    try {
      gradients = workplaces.get().at(values);
      rows = gradients.compute(GradientMethod.FORWARD);
    } catch (MechmlException | IntegrationException e) {
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
