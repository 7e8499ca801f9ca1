package org.mechservice.sim.equations.kinematics;

import java.util.List;
import java.util.stream.IntStream;
import org.mechservice.solver.links.Link;
import org.mechservice.solver.step.Twist;
import org.mechservice.solver.symbol.Expressions;
import org.mechservice.solver.symbol.Scalar;
import org.mechservice.solver.symbol.ScalarMatrix;
import org.mechservice.solver.symbol.ScalarVector;

/** The motions S of links for each of their velocities, in link axes at the links' origins. */
public final class JointSubspace {
  private final Expressions expressions;
  private final Coordinates coordinates;

  public JointSubspace(Expressions expressions, Coordinates coordinates) {
    this.expressions = expressions;
    this.coordinates = coordinates;
  }

  /** Returns S of each velocity of a link, in the order and axes of the state. */
  public List<Twist> of(Link link) {
    ScalarVector none = ScalarVector.zero(expressions);
    if (link.isBall()) {
      ScalarMatrix toState = coordinates.ballRotation(link);
      return IntStream.range(0, 3)
          .mapToObj(c -> new Twist(link.inverse() ? along(c, -1) : toState.row(c), none))
          .toList();
    }
    return List.of(new Twist(link.turns() ? along(2, 1) : none, along(2, link.way())));
  }

  private ScalarVector along(int axis, double size) {
    Scalar zero = expressions.zero();
    Scalar length = expressions.constant(size);
    return new ScalarVector(
        axis == 0 ? length : zero, axis == 1 ? length : zero, axis == 2 ? length : zero);
  }
}
