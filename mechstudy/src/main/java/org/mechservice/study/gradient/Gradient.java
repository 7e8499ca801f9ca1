package org.mechservice.study.gradient;

import java.util.List;

/**
 * Values with their derivatives.
 *
 * @param outputs what was differentiated, such as {@code max(height.q)}
 * @param units SI units of the outputs
 * @param parameters by what it was differentiated
 * @param parameterUnits their units: of a parameter that of its file, of a start value SI
 * @param values values of the outputs, SI
 * @param derivatives of each output by each parameter
 * @param method how they were computed: forward or adjoint
 * @param reason why so
 * @param steps steps of the integration of the motion
 * @param differenced parameters that are no inputs of the equations, such as masses and points:
 *     derivatives of the equations by them are differences at fixed states
 */
@SuppressWarnings("ArrayRecordComponent") // never compared
public record Gradient(
    List<String> outputs,
    List<String> units,
    List<String> parameters,
    List<String> parameterUnits,
    double[] values,
    double[][] derivatives,
    GradientMethod method,
    String reason,
    long steps,
    List<String> differenced) {
  public Gradient {
    outputs = List.copyOf(outputs);
    units = List.copyOf(units);
    parameters = List.copyOf(parameters);
    parameterUnits = List.copyOf(parameterUnits);
    differenced = List.copyOf(differenced);
  }
}
