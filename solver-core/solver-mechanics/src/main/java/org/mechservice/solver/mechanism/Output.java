package org.mechservice.solver.mechanism;

import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.text.Origin;

/**
 * A column of results that the model's author defined (docs/mechml.md#outputs).
 *
 * @param name name of the column
 * @param value of time, parameters and the state; written without conversion
 * @param unit unit given by its author; {@code 1} if none
 * @param origin position in the model file
 */
public record Output(String name, Expression value, String unit, Origin origin) {}
