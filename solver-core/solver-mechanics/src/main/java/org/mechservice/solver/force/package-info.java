/**
 * Applied forces at work: wrenches and joint forces from a swept motion, their derivatives, energy,
 * power and values.
 *
 * <p>{@link org.mechservice.solver.force.ForceSet} is the way in. A force between two bodies is a
 * law of their relative motion ({@code FrameLaw}), a force in a joint a law of its coordinate
 * ({@code ScalarLaw}); carrying them to links and joints, and differentiating that, is done once.
 * What a law means is said at its description in {@code mechanism.force}.
 */
package org.mechservice.solver.force;
