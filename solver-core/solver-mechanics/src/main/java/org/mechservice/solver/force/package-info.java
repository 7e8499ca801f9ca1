/**
 * Applied forces of a mechanism: wrenches and joint forces at a state, with their derivatives,
 * energy, power and output values.
 *
 * <p>{@link org.mechservice.solver.force.ForceSet} is the entry point: it holds all forces of one
 * run and adds them up. {@link org.mechservice.solver.force.ForceAssembly} creates its forces from
 * the descriptions in {@code mechanism.force}, which define the laws. The packages below it:
 *
 * <ul>
 *   <li>{@code force.applied}: how a force enters the equations of motion, and its derivatives;
 *   <li>{@code force.law}: springs, bushings, contacts, friction;
 *   <li>{@code force.formula}: forces given as formulas of the state;
 *   <li>{@code force.user}: user force classes.
 * </ul>
 *
 * <p>Nothing here allocates during a run.
 */
package org.mechservice.solver.force;
