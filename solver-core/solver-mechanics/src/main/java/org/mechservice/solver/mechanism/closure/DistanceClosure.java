package org.mechservice.solver.mechanism.closure;

import org.mechservice.solver.expression.BodyPoint;
import org.mechservice.solver.text.Origin;

/**
 * Two points keep their distance, as the ends of a rod with ball joints do
 * (docs/mechml.md#constraints, DISTConstraint).
 *
 * @param name name in the model file
 * @param point1 end on the file's body 1
 * @param point2 end on the file's body 2
 * @param distance m, positive; two points that coincide are a {@link JointClosure} of type S
 * @param rodMass mass of a uniform slender rod between the points, kg, not negative; 0 for none.
 *     The rod has no inertia about its own axis (docs/theory/motion.md#bodies)
 * @param origin position in the model file
 */
public record DistanceClosure(
    String name, BodyPoint point1, BodyPoint point2, double distance, double rodMass, Origin origin)
    implements LoopClosure {

  /**
   * @throws IllegalArgumentException if the distance is not positive and finite, or the mass is
   *     negative or not finite
   */
  public DistanceClosure {
    if (!(distance > 0 && Double.isFinite(distance))) {
      throw new IllegalArgumentException(
          "constraint "
              + name
              + " has the distance "
              + distance
              + " m; it must be positive (points that coincide are a joint of type S)");
    }
    if (!(rodMass >= 0 && Double.isFinite(rodMass))) {
      throw new IllegalArgumentException(
          "the rod of constraint " + name + " has the mass " + rodMass + " kg; it must not be so");
    }
  }

  /** Returns whether a rod with mass joins the points. */
  public boolean hasRod() {
    return rodMass > 0;
  }
}
