/**
 * The immutable description of applied forces: what acts where, by which law, with which numbers.
 * SI units throughout.
 *
 * <p>Coefficients such as a stiffness are {@link org.mechservice.solver.expression.Expression}s of
 * constants and tunable parameters alone: they keep their value during a run. What may change with
 * time and state is said at each record. Every record states the sign of its law, its potential
 * energy if it has one, and the values it can put out; positive powers of a damper are power lost.
 *
 * <p>pos(x) = (x + √(x² + ε²)) / 2 is the smooth positive part of x, ε in the unit of x; pos′ its
 * derivative, between 0 and 1. For ε = 0 they are the positive part and the step, 1/2 at zero.
 */
package org.mechservice.solver.mechanism.force;
