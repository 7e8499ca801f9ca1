/**
 * Distances of solids: of two convex shapes, and the least one along a motion with proved bounds.
 *
 * <p>{@link org.mechservice.solver.distance.ShapeDistance} finds the distance of two {@link
 * org.mechservice.solver.distance.ConvexShape}s by the method of Gilbert, Johnson and Keerthi
 * (1988). {@link org.mechservice.solver.distance.Clearance} bounds the least distance of two bodies
 * between the rows of a run, with their paths in {@link
 * org.mechservice.solver.distance.RelativePath}.
 *
 * <p>Only + − × ÷ √ are used, so that all machines find the same bits. Sources: van den Bergen
 * 2001; Ericson 2005, ch. 5; Montanari and Petrinic 2018 (signed volumes). docs/theory/distance.md.
 */
package org.mechservice.solver.distance;
