package org.mechservice.solver.mechanism.closure;

import org.mechservice.solver.expression.BodyPoint;
import org.mechservice.solver.spatial.Vector3;
import org.mechservice.solver.text.Origin;

/**
 * A wheel or a ball rolls without slip on a plane fixed in another body. It touches the plane (one
 * equation of positions), and the material point of the wheel at the contact has no velocity along
 * the plane (two equations of velocities, which are not derivatives of equations of positions). The
 * contact holds in both directions: it also pulls.
 *
 * @param name name in the model file
 * @param plane a point of the plane on the body that carries it
 * @param normal unit vector normal to the plane, towards the wheel, in the axes of that body
 * @param centre centre of the wheel or ball on the body that rolls
 * @param axle unit vector along the wheel's axle in the axes of the body that rolls; zero for a
 *     ball
 * @param radius of the ball, or of the circle in which the centres of the rim's cross-sections lie,
 *     m, positive
 * @param tube radius of the rim's cross-section, m, not negative; 0 for a sharp edge and for a ball
 * @param origin position in the model file
 */
public record RollingClosure(
    String name,
    BodyPoint plane,
    Vector3 normal,
    BodyPoint centre,
    Vector3 axle,
    double radius,
    double tube,
    Origin origin)
    implements LoopClosure {

  /**
   * @throws IllegalArgumentException if the radius is not positive or the tube's is negative
   */
  public RollingClosure {
    if (!(radius > 0 && tube >= 0 && Double.isFinite(radius + tube))) {
      throw new IllegalArgumentException(
          "what rolls at " + name + " has the radii " + radius + " and " + tube + " m");
    }
  }

  /** Returns whether a ball rolls, not a wheel. */
  public boolean isBall() {
    return axle.equals(Vector3.ZERO);
  }

  /** Returns the largest distance of the rim from the centre, m. */
  public double size() {
    return radius + tube;
  }
}
