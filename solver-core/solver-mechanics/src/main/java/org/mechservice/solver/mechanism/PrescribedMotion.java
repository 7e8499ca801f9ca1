package org.mechservice.solver.mechanism;

import java.util.List;
import org.mechservice.solver.expression.Expression;

/**
 * The coordinates of a driven joint as functions of time; velocities and accelerations are their
 * derivatives. A driven joint has no states; its driving force is an output.
 *
 * @param joint index among the mechanism's joints
 * @param coordinates one expression of time and parameters per position, rad or m; those of Euler
 *     parameters are a path of unit quaternions
 */
public record PrescribedMotion(int joint, List<Expression> coordinates) {
  public PrescribedMotion {
    coordinates = List.copyOf(coordinates);
  }
}
