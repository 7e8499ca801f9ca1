package org.mechservice.solver.mechanism;

import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.text.Origin;

/**
 * A state besides positions and velocities, s' = f(t, q, v, s): of a controller, a filter, an
 * actuator.
 *
 * @param name name in the model file
 * @param start value at the start of the run, in the state's own unit
 * @param derivative f, per second; of time, parameters, coordinates, points and further states
 * @param unit unit given by the model's author, {@code 1} if none; values are not converted
 * @param absoluteTolerance tolerance of the error test in that unit; 0 if the run's tolerance for
 *     angles applies
 * @param origin position in the model file
 */
public record FurtherState(
    String name,
    double start,
    Expression derivative,
    String unit,
    double absoluteTolerance,
    Origin origin) {}
