package org.mechservice.study.optimise;

import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;

/**
 * A problem of optimisation: variables with bounds, an objective or residuals, constraints.
 *
 * @param variables what may be changed; at least one
 * @param aims what is wanted: one objective, two for a {@linkplain Front front}, or any number of
 *     residuals; and constraints
 * @param response values of the aims as functions of the variables
 * @param slopes their derivatives by the variables; empty if methods are to take differences
 * @param composition what aims with corners are made of; empty if it is not known
 */
public record DesignProblem(
    List<DesignVariable> variables,
    List<Aim> aims,
    Response response,
    Optional<Derivatives> slopes,
    Optional<Composition> composition) {
  /** A problem without derivatives. */
  public DesignProblem(List<DesignVariable> variables, List<Aim> aims, Response response) {
    this(variables, aims, response, Optional.empty(), Optional.empty());
  }

  /**
   * @throws IllegalArgumentException if there is nothing to change, or nothing or more than two
   *     things to minimise
   */
  public DesignProblem {
    variables = List.copyOf(variables);
    aims = List.copyOf(aims);
    if (variables.isEmpty()) {
      throw new IllegalArgumentException("there is no variable to change");
    }
    if (variables.stream().map(DesignVariable::name).distinct().count() < variables.size()) {
      throw new IllegalArgumentException("a variable is given twice");
    }
    long objectives = aims.stream().filter(aim -> aim.kind() == Aim.Kind.MINIMISE).count();
    boolean residuals = aims.stream().anyMatch(aim -> aim.kind() == Aim.Kind.RESIDUAL);
    if (objectives > 2 || (objectives > 0) == residuals) {
      throw new IllegalArgumentException(
          "a problem has one objective, two for a front, or residuals, not both and not neither; it has "
              + objectives
              + " objectives and "
              + (residuals ? "residuals" : "no residuals"));
    }
  }

  /** Returns the values of the variables at a point of the unit cube. */
  double[] point(double[] parts) {
    double[] values = new double[parts.length];
    for (int j = 0; j < values.length; j++) {
      values[j] = variables.get(j).value(parts[j]);
    }
    return values;
  }

  /** Returns the range of a variable, by which a part of the unit cube is multiplied. */
  double range(int variable) {
    return variables.get(variable).upper() - variables.get(variable).lower();
  }

  /** Returns the start as a point of the unit cube. */
  double[] start() {
    return variables.stream().mapToDouble(variable -> variable.part(variable.start())).toArray();
  }

  /** Returns the places of the objectives among the aims. */
  int[] objectives() {
    return IntStream.range(0, aims.size())
        .filter(i -> aims.get(i).kind() == Aim.Kind.MINIMISE)
        .toArray();
  }

  boolean hasConstraints() {
    return aims.stream().anyMatch(Aim::isConstraint);
  }

  /** Returns whether aims are made of extremes. */
  boolean hasCorners() {
    return composition.isPresent() && !composition.get().extremes().isEmpty();
  }

  boolean hasResiduals() {
    return aims.stream().anyMatch(aim -> aim.kind() == Aim.Kind.RESIDUAL);
  }
}
