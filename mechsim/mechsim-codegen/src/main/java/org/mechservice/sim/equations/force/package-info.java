/**
 * Applied forces as equations.
 *
 * <p>{@link org.mechservice.sim.equations.force.AppliedForces} is the main type: it makes one
 * {@link org.mechservice.sim.equations.force.ForceTerm} for each force of the mechanism, in the
 * order of the file, and adds the wrenches and joint forces of all terms to the loads of a sweep. A
 * term also has potential energy, power and output values.
 *
 * <p>Terms: {@link org.mechservice.sim.equations.force.SpringTerm}, {@link
 * org.mechservice.sim.equations.force.BushingTerm}, {@link
 * org.mechservice.sim.equations.force.ContactTerm}, {@link
 * org.mechservice.sim.equations.force.CoordinateTerm} and {@link
 * org.mechservice.sim.equations.force.ExternalForceTerm}. {@link
 * org.mechservice.sim.equations.force.UserForceInputs} represents user force classes: their loads
 * are inputs of the program. {@link org.mechservice.sim.equations.force.MassiveRodTerms} are the
 * inertia forces of rods between two bodies.
 *
 * <p>Depends on {@code links}, {@code kinematics}, {@code recursion} and {@code coordinates}. The
 * laws are those of docs/mechml.md#forces; the data-driven implementation of the same laws is
 * {@link org.mechservice.solver.force}.
 */
@NullMarked
package org.mechservice.sim.equations.force;

import org.jspecify.annotations.NullMarked;
