package org.mechservice.solver.mechanism.force;

import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.force.law.Condition;

/**
 * A number of a force law, the same during a run.
 *
 * @param name its name in messages
 * @param value of parameters, SI units
 * @param condition what the law needs of it
 */
public record Coefficient(String name, Expression value, Condition condition) {}
