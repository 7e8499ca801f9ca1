package org.mechservice.sim.equations.derivatives;

import java.util.List;
import org.mechservice.sim.equations.kinematics.Coordinates;
import org.mechservice.sim.equations.kinematics.JointSubspace;
import org.mechservice.sim.equations.kinematics.LinkKinematics;
import org.mechservice.sim.equations.recursion.ForceSweep;
import org.mechservice.solver.links.Link;
import org.mechservice.solver.step.Motion;
import org.mechservice.solver.step.Twist;
import org.mechservice.solver.symbol.Expressions;
import org.mechservice.solver.symbol.Scalar;
import org.mechservice.solver.symbol.ScalarVector;

/**
 * The columns S of the velocities and their derivatives in the axes of their links, at the links'
 * origins: ψ' = V_p × S, ψ'' = A_p × S + V_p × ψ', and ψ' + S' with S' = V × S, where V_p and A_p
 * are velocity and acceleration of the parent, gravity included (Singh, Russell and Wensing 2022).
 */
final class JointColumns {
  private final Expressions expressions;
  private final Coordinates coordinates;
  private final LinkKinematics kinematics;
  private final ForceSweep sweep;
  private final JointSubspace subspace;

  /**
   * @param sweep swept with accelerations
   */
  JointColumns(
      Expressions expressions,
      Coordinates coordinates,
      LinkKinematics kinematics,
      ForceSweep sweep) {
    this.expressions = expressions;
    this.coordinates = coordinates;
    this.kinematics = kinematics;
    this.sweep = sweep;
    this.subspace = new JointSubspace(expressions, coordinates);
  }

  /**
   * One column with its derivatives.
   *
   * @param itself S
   * @param first ψ'
   * @param second ψ''
   * @param both ψ' + S'
   */
  record Column(Twist itself, Twist first, Twist second, Twist both) {}

  /** Returns the velocity of a link. */
  Twist velocity(int link) {
    return new Twist(kinematics.omega(link), kinematics.velocity(link));
  }

  /** Returns S of each velocity of a link, in the order and axes of the state. */
  List<Twist> subspace(Link link) {
    return subspace.of(link);
  }

  /** Returns the columns of a link's velocities. */
  List<Column> of(Link link) {
    Twist velocity = velocityOfParent(link);
    Twist acceleration = accelerationOfParent(link);
    return subspace.of(link).stream().map(s -> column(link, s, velocity, acceleration)).toList();
  }

  private Column column(Link link, Twist s, Twist velocity, Twist acceleration) {
    Twist first = velocity.cross(s);
    Twist second = acceleration.cross(s).plus(velocity.cross(first));
    Twist both = first.plus(first);
    return new Column(
        s, first, second, link.isBall() ? both.plus(relativeVelocity(link).cross(s)) : both);
  }

  private Twist relativeVelocity(Link ball) {
    ScalarVector v = coordinates.ballVelocity(ball);
    ScalarVector inLink =
        ball.inverse()
            ? v.map(Scalar::negated)
            : coordinates.ballRotation(ball).transposed().times(v);
    return new Twist(inLink, ScalarVector.zero(expressions));
  }

  private Twist velocityOfParent(Link link) {
    ScalarVector omega = kinematics.omega(link.parent());
    ScalarVector u = kinematics.velocity(link.parent());
    return seenFrom(link, omega, u);
  }

  private Twist accelerationOfParent(Link link) {
    Motion parent = sweep.motion(link.parent());
    ScalarVector omega = kinematics.omega(link.parent());
    // spatial, not classical, acceleration of the body's point at the origin
    ScalarVector there =
        parent.acceleration().minus(omega.cross(kinematics.velocity(link.parent())));
    return seenFrom(link, parent.alpha(), there);
  }

  private Twist seenFrom(Link link, ScalarVector angular, ScalarVector linear) {
    ScalarVector moved = linear.plus(angular.cross(kinematics.origin(link)));
    return new Twist(kinematics.toLink(link, angular), kinematics.toLink(link, moved));
  }
}
