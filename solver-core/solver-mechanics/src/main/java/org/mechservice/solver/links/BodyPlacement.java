package org.mechservice.solver.links;

import org.mechservice.solver.spatial.Rotation;
import org.mechservice.solver.spatial.Vector3;

/**
 * The constant pose of a body in its link.
 *
 * @param link index of the link; {@link Links#ROOT} if the body is welded to the root
 * @param toLink from the body's own axes to the link's own axes
 * @param toFrame from the body's own axes to the link's computing axes
 * @param origin the body's origin from the computing origin, in computing axes, m
 * @param label identifier of the body in programs
 */
public record BodyPlacement(
    int link, Rotation toLink, Rotation toFrame, Vector3 origin, String label) {}
