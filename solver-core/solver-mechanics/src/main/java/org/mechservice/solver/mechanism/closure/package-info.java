/**
 * The closures of a mechanism's loops: cut joints, constant distances with or without a rod's mass,
 * couplings of coordinates, points on planes and lines, wheels that roll and edges that do not
 * slip.
 *
 * <p>{@link org.mechservice.solver.mechanism.closure.LoopClosure} is a sealed family of immutable
 * records. The tree of a {@link org.mechservice.solver.mechanism.Mechanism} contains one joint per
 * body; every further joint of the model file is a {@link
 * org.mechservice.solver.mechanism.closure.JointClosure}. {@link
 * org.mechservice.solver.mechanism.closure.DistanceClosure} may carry the mass of a uniform rod,
 * {@link org.mechservice.solver.mechanism.closure.CoordinateClosure} couples coordinates by an
 * expression. {@link org.mechservice.solver.mechanism.closure.RollingClosure} and {@link
 * org.mechservice.solver.mechanism.closure.KnifeEdgeClosure} restrict velocities without
 * restricting positions (non-holonomic equations). The author of a model may write redundant
 * closures.
 *
 * <p>Package {@code org.mechservice.solver.closure} turns the closures into the equations Φ(q, t) =
 * 0, finds their rank and solves the equations of motion under them; {@code sim.equations.loop}
 * generates code for the same equations. Definitions: docs/mechml.md#joints and
 * docs/mechml.md#constraints.
 */
package org.mechservice.solver.mechanism.closure;
