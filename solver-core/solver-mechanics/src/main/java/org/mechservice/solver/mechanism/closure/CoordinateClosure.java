package org.mechservice.solver.mechanism.closure;

import java.util.List;
import org.mechservice.solver.expression.BodyPoint;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.text.Origin;

/**
 * A coupling of positions, such as a gear, a rack or a rope (docs/mechml.md#constraints,
 * CoordConstraint): the expression is zero. It may contain time, parameters, positions of
 * coordinates, of tree joints and of cut ones, and places of points, but no velocities.
 *
 * @param name name in the model file
 * @param relation expression that is zero during the motion; coordinates in SI units
 * @param points what a rope passes, in this order, for pictures; empty for other couplings
 * @param origin position in the model file
 */
public record CoordinateClosure(
    String name, Expression relation, List<BodyPoint> points, Origin origin)
    implements LoopClosure {
  public CoordinateClosure {
    points = List.copyOf(points);
  }

  /** Makes a coupling that is at no place. */
  public CoordinateClosure(String name, Expression relation, Origin origin) {
    this(name, relation, List.of(), origin);
  }
}
