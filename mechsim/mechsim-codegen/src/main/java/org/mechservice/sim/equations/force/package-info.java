/**
 * Applied forces as equations.
 *
 * <p>{@link org.mechservice.sim.equations.force.AppliedForces} is the main type: it makes one
 * {@link org.mechservice.sim.equations.force.ForceTerm} for each force of the mechanism, in the
 * order of the file, and adds the wrenches and joint forces of all terms to the loads of a sweep. A
 * term also has potential energy, power and output values.
 *
 * <p>Terms: {@link org.mechservice.sim.equations.force.PairTerm} of the laws between two frames,
 * {@link org.mechservice.sim.equations.force.SpringTerm}, {@link
 * org.mechservice.sim.equations.force.CouplingTerm}, {@link
 * org.mechservice.sim.equations.force.CoordinateTerm}, {@link
 * org.mechservice.sim.equations.force.PairForceTerm} and {@link
 * org.mechservice.sim.equations.force.ExternalForceTerm}. {@link
 * org.mechservice.sim.equations.force.UserForceInputs} represents user force classes: their loads
 * are inputs of the program. {@link org.mechservice.sim.equations.force.MassiveRodTerms} are the
 * inertia forces of rods between two bodies.
 *
 * <p>Depends on {@code links}, {@code kinematics}, {@code recursion} and {@code coordinates}. The
 * laws are the formulas of {@code org.mechservice.solver.force.law}, described in
 * docs/mechml.md#forces.
 */
@NullMarked
package org.mechservice.sim.equations.force;

import org.jspecify.annotations.NullMarked;
