package org.mechservice.mechml;

import java.util.List;
import java.util.OptionalInt;
import org.mechservice.solver.spatial.Vector3;

/**
 * Shapes that a body has in pictures, without a part in its mass.
 *
 * @param solids the shapes, in axes of the look, m
 * @param origin of the axes of the look, from the body's origin in body axes, m
 * @param axis unit vector in body axes, about which the axes of the look are turned
 * @param angle by which they are turned, rad
 * @param colour 0xRRGGBB; empty for the body's own
 * @param opacity from 0, which is not seen, to 1
 */
public record Look(
    List<Solid> solids,
    Vector3 origin,
    Vector3 axis,
    double angle,
    OptionalInt colour,
    double opacity) {
  public Look {
    solids = List.copyOf(solids);
  }
}
