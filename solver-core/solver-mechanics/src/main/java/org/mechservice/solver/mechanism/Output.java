package org.mechservice.solver.mechanism;

import org.mechservice.solver.expression.Expression;

/**
 * A column of results that the model's author defined (MECHML §5).
 *
 * @param name name of the column
 * @param value of time, parameters and the state; put out as it is
 * @param unit unit its author gave the value; {@code 1} if none
 * @param origin where it was written down
 */
public record Output(String name, Expression value, String unit, Origin origin) {}
