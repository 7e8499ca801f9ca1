package org.mechservice.study.identify;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.mechservice.library.MechModel;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.result.SignalTable;
import org.mechservice.solver.api.result.Variable;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.study.PointModel;
import org.mechservice.study.Reduction;
import org.mechservice.study.gradient.RowGradients;
import org.mechservice.study.optimise.Derivatives;
import org.mechservice.study.optimise.DesignVariable;
import org.mechservice.study.optimise.ModelDesign;
import org.mechservice.study.optimise.PointFailedException;
import org.mechservice.study.optimise.Response;

/**
 * Measured values of outputs at times, with standard deviations.
 *
 * <p>The first column of the table is the time. A column {@code x.sigma} has the standard
 * deviations of the values of column {@code x}; without it all values of {@code x} have the same
 * one. A value that is NaN was not measured.
 */
public final class Measurements {
  private static final String DEVIATION = ".sigma";

  /**
   * Relative tolerance of the steps of derivatives. Those of the arm of 24 parameters are known to
   * 6e-6 of the largest with it, those of differences of its runs to some 1e-4.
   */
  private static final double ENOUGH = 1e-4;

  /**
   * One measured value.
   *
   * @param output column of the model
   * @param time s
   * @param value in the column's unit
   * @param deviation its standard deviation, or the size that counts as 1
   */
  public record Sample(String output, double time, double value, double deviation) {}

  private final List<Sample> samples;

  private Measurements(List<Sample> samples) {
    this.samples = List.copyOf(samples);
  }

  /**
   * Takes the columns of a table.
   *
   * @param outputs names of measured columns with the outputs of the model that they measure; empty
   *     for all columns under their own names
   * @param deviations standard deviations by the names of measured columns
   * @throws IllegalArgumentException if a column does not exist or a standard deviation is not
   *     positive
   */
  public static Measurements of(
      SignalTable table, Map<String, String> outputs, Map<String, Double> deviations) {
    List<String> names = table.columns().stream().map(Variable::name).toList();
    Map<String, String> wanted = new LinkedHashMap<>(outputs);
    if (wanted.isEmpty()) {
      names.stream()
          .skip(1)
          .filter(name -> !name.endsWith(DEVIATION))
          .forEach(name -> wanted.put(name, name));
    }
    for (String name : deviations.keySet()) {
      if (!wanted.containsKey(name)) {
        throw new IllegalArgumentException(
            "a standard deviation is given for \""
                + name
                + "\", which is none of the measured"
                + " columns "
                + String.join(", ", wanted.keySet()));
      }
    }
    List<Sample> samples = new ArrayList<>();
    wanted.forEach(
        (column, output) -> {
          int at = names.indexOf(column);
          if (at < 1) {
            throw new IllegalArgumentException(
                "the measurements have no column \""
                    + column
                    + "\"; they have "
                    + String.join(", ", names.subList(1, names.size())));
          }
          int sigma = names.indexOf(column + DEVIATION);
          double same = deviations.getOrDefault(column, 1.0);
          for (int row = 0; row < table.rows(); row++) {
            double value = table.values().get(at)[row];
            double deviation = sigma < 0 ? same : table.values().get(sigma)[row];
            if (!Double.isNaN(value)) {
              if (!(deviation > 0 && Double.isFinite(deviation))) {
                throw new IllegalArgumentException(
                    "the standard deviation of "
                        + column
                        + " in row "
                        + (row + 1)
                        + " is "
                        + deviation
                        + "; it must be more than 0");
              }
              samples.add(new Sample(output, table.time()[row], value, deviation));
            }
          }
        });
    if (samples.isEmpty()) {
      throw new IllegalArgumentException("the measurements have no values");
    }
    return new Measurements(samples);
  }

  /** Returns the measured values. */
  public List<Sample> samples() {
    return samples;
  }

  /**
   * Returns the weighted residuals of a model, (computed − measured) / standard deviation, in the
   * order of the samples. Between two rows of a run an output is taken as a straight line.
   *
   * @throws MechmlException if the model cannot be used
   * @throws IllegalArgumentException if it has no such output or parameter, or a measured time is
   *     outside its run
   */
  public Response residuals(MechModel model, List<DesignVariable> variables)
      throws MechmlException {
    List<Reduction> reductions =
        samples.stream()
            .map(each -> new Reduction(each.output(), Reduction.Kind.AT, each.time()))
            .toList();
    List<String> names = variables.stream().map(DesignVariable::name).toList();
    PointModel points = PointModel.of(model, names, reductions);
    return point -> {
      Map<String, Double> set = new HashMap<>();
      for (int j = 0; j < point.length; j++) {
        set.put(names.get(j), point[j]);
      }
      try {
        return weighted(ModelDesign.reduced(points, set));
      } catch (PointFailedException e) {
        throw PointFailedException.at(variables, point, "the run", String.valueOf(e.getMessage()));
      }
    };
  }

  /**
   * Returns the derivatives of the residuals by the variables, from the equations: exact for the
   * steps, whose relative tolerance is {@link #ENOUGH} or that of the run where this is larger. A
   * fit needs no more: an error of this size moves what it finds by as much of a standard
   * deviation.
   *
   * @throws MechmlException if the model cannot be used
   * @throws IllegalArgumentException if there are none; says why
   */
  public Derivatives slopes(MechModel model, List<DesignVariable> variables)
      throws MechmlException {
    List<Reduction> reductions =
        samples.stream()
            .map(each -> new Reduction(each.output(), Reduction.Kind.AT, each.time()))
            .toList();
    RowGradients gradients =
        RowGradients.of(
            loosened(model), variables.stream().map(DesignVariable::name).toList(), reductions);
    return point -> {
      double[][] slopes;
      try {
        slopes = gradients.at(point);
      } catch (IllegalArgumentException e) {
        throw PointFailedException.at(
            variables, point, "the gradient", String.valueOf(e.getMessage()));
      }
      for (int i = 0; i < slopes.length; i++) {
        for (int j = 0; j < slopes[i].length; j++) {
          slopes[i][j] /= samples.get(i).deviation();
        }
      }
      return slopes;
    };
  }

  private static MechModel loosened(MechModel model) {
    RunSettings run = model.request().settings();
    double factor = ENOUGH / run.relativeTolerance();
    return factor <= 1
        ? model
        : model.tolerances(
            ENOUGH,
            factor * run.absoluteTolerance(),
            factor * run.angleTolerance(),
            factor * run.velocityTolerance(),
            factor * run.angularVelocityTolerance());
  }

  private double[] weighted(double[] computed) throws PointFailedException {
    double[] residuals = new double[computed.length];
    for (int i = 0; i < residuals.length; i++) {
      Sample sample = samples.get(i);
      residuals[i] = (computed[i] - sample.value()) / sample.deviation();
      if (!Double.isFinite(residuals[i])) {
        throw new PointFailedException(
            sample.output() + " has no value at " + sample.time() + " s");
      }
    }
    return residuals;
  }
}
