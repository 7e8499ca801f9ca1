/**
 * A mechanism as a tree of rigid links in computing frames.
 *
 * <p>{@link org.mechservice.solver.links.Links} is the main type: the moving links from the root
 * outwards, the placement of each body in its link, and gravity. {@code LinkLayout} makes it from a
 * {@link org.mechservice.solver.mechanism.Mechanism}: {@code RigidGroups} joins welded bodies,
 * {@code ComputingAxes} chooses the axes of each link, and {@link
 * org.mechservice.solver.links.AxesChange} factors a constant rotation into rotations about
 * coordinate axes.
 *
 * <p>The computing frame of a link has its origin at the joint's point on the body and its z axis
 * along the joint. A joint then rotates about or slides along one coordinate axis, and the terms of
 * the other two axes are separate, so that a program has fewer operations.
 *
 * <p>Depends only on the mechanism of solver-mechanics and on symbolic scalars. The quantities are
 * those of Featherstone 2008, ch. 2 and 7.
 */
package org.mechservice.solver.links;
