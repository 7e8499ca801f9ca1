/**
 * What a model can compute: one interface for each capability, so that a generated class contains
 * only those that its scene needs.
 *
 * <p>A model supplies its equations in one of four forms: {@link ExplicitModel} (y' = f(t, y)),
 * {@link ResidualModel} (F(t, y, y') = 0), {@link AlgebraicModel} (a state at every instant) or
 * {@link ResultTable} (rows that are no states). {@link LinearisedModel} adds the Jacobian.
 *
 * <p>The others are added where a scene has something to add: {@link DependentStates} and {@link
 * ProjectedStates} for closed loops, {@link ModelEvents} and {@link StateJumps} for contacts and
 * switches, {@link ModelState} for whatever the equations depend on beside t and y, {@link
 * BodyPoses}, {@link Energies}, {@link PowerInput} and {@link MomentumBalance} for what is recorded
 * and watched. {@link Defects} and {@link DirectedForces} name what went wrong in an evaluation.
 *
 * <p>{@link ModelParts} joins equations with events and with columns that are computed beside them,
 * and takes any model apart into these.
 */
package org.mechservice.solver.api.capability;
