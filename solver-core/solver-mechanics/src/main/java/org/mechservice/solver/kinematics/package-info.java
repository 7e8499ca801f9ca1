/**
 * Poses, velocities and accelerations of the bodies of a tree: the outward sweep at the start of
 * every recursion, shared by forces, loops and dynamics.
 *
 * <p>A joint is a chain of elementary links with massless links between them ({@link
 * org.mechservice.solver.kinematics.LinkKind}), so that one scheme serves all nine joints of
 * MechML. {@link org.mechservice.solver.kinematics.TreeGeometry} holds the constants of a tree,
 * made from a {@link org.mechservice.solver.mechanism.Mechanism}; all threads share it. {@link
 * org.mechservice.solver.kinematics.TreeMotion} is the workspace of one thread: a sweep writes
 * poses and velocities of all links, an acceleration sweep their accelerations. {@link
 * org.mechservice.solver.kinematics.PointMotion} computes the motion of points of the links from
 * it, {@link org.mechservice.solver.kinematics.LinkWrenches} transfers forces to the root. {@link
 * org.mechservice.solver.kinematics.StateCoordinates} holds the kinematic equation q' = N(q) v of
 * the state.
 *
 * <p>Quantities of a link are in link axes at the link's reference point. Source: Featherstone
 * 2008, chapters 2 to 4.
 */
package org.mechservice.solver.kinematics;
