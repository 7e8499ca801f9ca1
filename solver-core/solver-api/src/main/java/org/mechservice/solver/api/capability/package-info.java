/**
 * What a model can compute: one interface for each capability, so that a generated class contains
 * only those that its scene needs.
 *
 * <p>A model supplies its equations in one of four forms: {@link ExplicitModel} (y' = f(t, y)),
 * {@link ResidualModel} (F(t, y, y') = 0), {@link AlgebraicModel} (a state at every instant) or
 * {@link ResultTable} (rows that are not states). {@link LinearisedModel} adds the Jacobian.
 *
 * <p>A model implements the others if its scene needs them: {@link DependentStates} and {@link
 * ProjectedStates} for closed loops, {@link ModelEvents} and {@link StateJumps} for contacts and
 * switches, {@link ModelState} for an internal state of the equations besides t and y, {@link
 * BodyPoses}, {@link Energies}, {@link PowerInput} and {@link MomentumBalance} for quantities that
 * are recorded and monitored, {@link ResultColumns} for columns beyond the state. {@link Defects}
 * and {@link DirectedForces} give the reason of a failed evaluation.
 *
 * <p>{@link ModelParts} combines equations with events and further columns, and returns these parts
 * of any model.
 */
package org.mechservice.solver.api.capability;
