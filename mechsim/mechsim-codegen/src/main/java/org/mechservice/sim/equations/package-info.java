/**
 * Equations of motion of one mechanism, written once over {@link
 * org.mechservice.solver.symbol.Scalar} and recorded as a {@link
 * org.mechservice.solver.symbol.Program}.
 *
 * <p>Each class here records one program of a generated model. {@link
 * org.mechservice.sim.equations.ArticulatedBodyEquations} is formulation DTR, {@link
 * org.mechservice.sim.equations.CompositeInertiaEquations} DSR and {@link
 * org.mechservice.sim.equations.RecursiveResidualEquations} RR; the Jacobian of RR-JF is in {@code
 * derivatives}, and the terms of a mechanism with loops are in {@code loop}. {@link
 * org.mechservice.sim.equations.EnergyEquations}, {@link
 * org.mechservice.sim.equations.PowerEquations} and {@link
 * org.mechservice.sim.equations.PoseEquations} give further columns of the results.
 *
 * <p>The subpackages depend on one another in this order: {@code links} (the mechanism in computing
 * frames), {@code kinematics} (coordinates, positions and velocities of the links), {@code
 * recursion} (sweeps of forces and inertias along the tree), {@code coordinates} (coordinates of
 * tree and cut joints, relative motion of two frames), {@code force}, {@code loop} and {@code
 * derivatives}. {@link org.mechservice.sim.emit} translates programs to code; this package does not
 * depend on it.
 *
 * <p>The mathematics is in docs/theory/motion.md, docs/theory/formulations.md and
 * docs/theory/loops.md; its sources are Featherstone 2008 (ch. 5-7) and Singh, Russell and Wensing
 * 2022.
 */
@NullMarked
package org.mechservice.sim.equations;

import org.jspecify.annotations.NullMarked;
