/**
 * Where the bodies of a tree are and how they move: the outward sweep that every recursion begins
 * with, shared by forces, loops and dynamics.
 *
 * <p>A joint is a chain of elementary links with massless links between them ({@link
 * org.mechservice.solver.kinematics.LinkKind}), so that one scheme serves all nine joints of
 * MechML. {@link org.mechservice.solver.kinematics.TreeGeometry} holds the constants, {@link
 * org.mechservice.solver.kinematics.TreeMotion} what changes, with {@link
 * org.mechservice.solver.kinematics.PointMotion} for points of the links and {@link
 * org.mechservice.solver.kinematics.LinkWrenches} for the way of forces to the root.
 */
package org.mechservice.solver.kinematics;
