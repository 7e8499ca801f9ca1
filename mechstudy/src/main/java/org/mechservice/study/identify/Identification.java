package org.mechservice.study.identify;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.apache.commons.math3.distribution.TDistribution;
import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.apache.commons.math3.linear.RealMatrix;
import org.apache.commons.math3.linear.SingularValueDecomposition;
import org.mechservice.study.optimise.Derivatives;
import org.mechservice.study.optimise.DesignVariable;
import org.mechservice.study.optimise.LeastSquares;
import org.mechservice.study.optimise.PointFailedException;
import org.mechservice.study.optimise.Response;
import org.mechservice.study.optimise.TallFactors;

/**
 * Parameters identified from weighted residuals, with what the data say about them.
 *
 * <p>With the Jacobian J of the m residuals by the n parameters, each scaled by its range, the
 * covariance is s² (JᵀJ)⁻¹, s² = Σr²/(m − n), and the intervals are those of Student's t with m − n
 * degrees of freedom (Seber and Wild 1989, §5.1). Directions in which J changes the residuals by
 * less than 1e-6 of what it does in its strongest direction, or in which one standard deviation is
 * more than the whole range, are not determined by the data: the parameters in them are named and
 * have no interval.
 *
 * @param variables what was identified
 * @param values found values, in the units of the variables
 * @param deviations standard deviations of the values; infinite where the data determine none
 * @param correlation n by n, -1 to 1; NaN in the rows of parameters that are not determined
 * @param singularValues of the scaled Jacobian, largest first
 * @param undetermined combinations of parameters that the data do not determine, in words
 * @param residuals weighted residuals at the values
 * @param noise s: the size of the weighted residuals, 1 if the weights are right
 * @param runs computed points
 */
@SuppressWarnings("ArrayRecordComponent") // never compared
public record Identification(
    List<DesignVariable> variables,
    double[] values,
    double[] deviations,
    double[][] correlation,
    double[] singularValues,
    List<String> undetermined,
    double[] residuals,
    double noise,
    int runs) {
  private static final double WEAKEST = 1e-6;

  /** Part in a direction from which a parameter counts as belonging to it. */
  private static final double BELONGS = 0.05;

  /** Part of a variable's range within which it counts as at its bound. */
  private static final double AT_BOUND = 1e-6;

  public Identification {
    variables = List.copyOf(variables);
    undetermined = List.copyOf(undetermined);
  }

  /**
   * Fits parameters.
   *
   * @param variables bounds and start values
   * @param response weighted residuals as functions of the variables, in their units
   * @param step of differences, as a part of the ranges
   * @throws PointFailedException if a point on the way cannot be computed
   * @throws IllegalArgumentException if there are not more residuals than variables
   */
  public static Identification of(List<DesignVariable> variables, Response response, double step)
      throws PointFailedException {
    return of(variables, response, step, Optional.empty());
  }

  /**
   * Fits parameters.
   *
   * @param step of differences, as a part of the ranges, where there are no derivatives
   * @param slopes derivatives of the residuals by the variables; empty for differences
   * @throws PointFailedException if a point on the way cannot be computed
   * @throws IllegalArgumentException if there are not more residuals than variables
   */
  public static Identification of(
      List<DesignVariable> variables, Response response, double step, Optional<Derivatives> slopes)
      throws PointFailedException {
    CubeResiduals onCube = new CubeResiduals(parts -> point(variables, parts), response);
    double[] start = variables.stream().mapToDouble(each -> each.part(each.start())).toArray();
    int m = onCube.at(start).length;
    if (m <= variables.size()) {
      throw new IllegalArgumentException(
          "there are "
              + m
              + " measured values for "
              + variables.size()
              + " parameters; more values than parameters are needed");
    }
    LeastSquares.Fit fit =
        onCube.fitted(start, slopes.map(by -> parts -> onCube(variables, by, parts)), step);
    return judged(variables, fit, onCube.runs());
  }

  private static double[] point(List<DesignVariable> variables, double[] parts) {
    double[] point = new double[parts.length];
    for (int j = 0; j < point.length; j++) {
      point[j] = variables.get(j).value(parts[j]);
    }
    return point;
  }

  private static double[][] onCube(
      List<DesignVariable> variables, Derivatives slopes, double[] parts)
      throws PointFailedException {
    double[][] scaled = slopes.at(point(variables, parts));
    for (double[] row : scaled) {
      for (int j = 0; j < row.length; j++) {
        row[j] *= variables.get(j).upper() - variables.get(j).lower();
      }
    }
    return scaled;
  }

  private static Identification judged(
      List<DesignVariable> variables, LeastSquares.Fit fit, int runs) {
    double[] parts = fit.point();
    double[] residuals = fit.residuals();
    int n = parts.length;
    double sum = Arrays.stream(residuals).map(r -> r * r).sum();
    double noise = Math.sqrt(sum / (residuals.length - n));
    // the triangle R of J = Q R has the singular values and the right vectors of J
    RealMatrix triangle =
        new Array2DRowRealMatrix(TallFactors.of(fit.jacobian(), residuals).triangle(), false);
    SingularValueDecomposition svd = new SingularValueDecomposition(triangle);
    double[] sigma = svd.getSingularValues();
    double least = Math.max(WEAKEST * sigma[0], noise);
    double[][] covariance = new double[n][n];
    boolean[] lost = new boolean[n];
    List<String> undetermined = new ArrayList<>();
    for (int k = 0; k < n; k++) {
      double[] direction = svd.getV().getColumn(k);
      // a direction wider than the range adds its share to the parameters that hardly belong to it
      if (sigma[k] > WEAKEST * sigma[0]) {
        for (int i = 0; i < n; i++) {
          for (int j = 0; j < n; j++) {
            covariance[i][j] += direction[i] * direction[j] * Math.pow(noise / sigma[k], 2);
          }
        }
      }
      if (sigma[k] <= least) {
        undetermined.add(words(variables, direction));
        for (int j = 0; j < n; j++) {
          lost[j] |= Math.abs(direction[j]) > BELONGS;
        }
      }
    }
    double[] values = new double[n];
    double[] deviations = new double[n];
    double[][] correlation = new double[n][n];
    for (int i = 0; i < n; i++) {
      DesignVariable variable = variables.get(i);
      values[i] = variable.value(parts[i]);
      deviations[i] =
          lost[i]
              ? Double.POSITIVE_INFINITY
              : Math.sqrt(covariance[i][i]) * (variable.upper() - variable.lower());
      for (int j = 0; j < n; j++) {
        correlation[i][j] =
            lost[i] || lost[j]
                ? Double.NaN
                : i == j ? 1 : covariance[i][j] / Math.sqrt(covariance[i][i] * covariance[j][j]);
      }
    }
    return new Identification(
        variables, values, deviations, correlation, sigma, undetermined, residuals, noise, runs);
  }

  /** Returns a direction of the unit cube in words, in the units of the parameters. */
  private static String words(List<DesignVariable> variables, double[] direction) {
    double[] change = new double[direction.length];
    int largest = 0;
    List<Integer> belonging = new ArrayList<>();
    for (int j = 0; j < change.length; j++) {
      change[j] = direction[j] * (variables.get(j).upper() - variables.get(j).lower());
      if (Math.abs(direction[j]) > BELONGS) {
        belonging.add(j);
        if (Math.abs(direction[j]) > Math.abs(direction[largest])) {
          largest = j;
        }
      }
    }
    if (belonging.size() == 1) {
      return variables.get(belonging.get(0)).name() + " has no visible effect on the data";
    }
    double unit = change[largest];
    StringBuilder names = new StringBuilder();
    StringBuilder changes = new StringBuilder();
    for (int k = 0; k < belonging.size(); k++) {
      int j = belonging.get(k);
      String name = variables.get(j).name();
      String before = k == 0 ? "" : k == belonging.size() - 1 ? " and " : ", ";
      names.append(before).append(name);
      changes
          .append(before)
          .append(name)
          .append(" by ")
          .append(String.format(Locale.ROOT, "%+.3g", change[j] / unit));
    }
    return names + " cannot be told apart: changing " + changes + " has no visible effect";
  }

  /** Returns the degrees of freedom: measured values less parameters. */
  public int freedom() {
    return residuals.length - values.length;
  }

  /**
   * Returns half the width of the confidence interval of a parameter; infinite where the data
   * determine none.
   *
   * @param level such as 0.95
   */
  public double halfWidth(int variable, double level) {
    return deviations[variable]
        * new TDistribution(freedom()).inverseCumulativeProbability(0.5 + level / 2);
  }

  /** Returns which bound a parameter is at: -1 the lower, 1 the upper, 0 none. */
  public int bound(int variable) {
    double part = variables.get(variable).part(values[variable]);
    return part <= AT_BOUND ? -1 : part >= 1 - AT_BOUND ? 1 : 0;
  }
}
