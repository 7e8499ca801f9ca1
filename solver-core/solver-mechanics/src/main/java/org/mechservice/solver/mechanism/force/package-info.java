/**
 * The immutable description of applied forces: points of application, laws and coefficients. SI
 * units throughout.
 *
 * <p>Coefficients such as a stiffness are {@link org.mechservice.solver.expression.Expression}s of
 * constants and tunable parameters and are therefore constant during a run. The documentation of
 * each record states which quantities depend on time and state, the sign of its law, its potential
 * energy if it has one, and its output values; a positive power of a damper is a loss.
 *
 * <p>pos(x) = (x + √(x² + ε²)) / 2 is the smooth positive part of x, ε in the unit of x; pos′ its
 * derivative, between 0 and 1. For ε = 0 they are the positive part and the step, 1/2 at zero.
 */
package org.mechservice.solver.mechanism.force;
