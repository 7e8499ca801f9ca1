package org.mechservice.sim.equations.coordinates;

import java.util.List;
import org.mechservice.sim.equations.kinematics.Coordinates;
import org.mechservice.sim.equations.recursion.Loads;
import org.mechservice.solver.api.JointType;
import org.mechservice.solver.expression.JointCoordinate;
import org.mechservice.solver.links.Link;
import org.mechservice.solver.links.Links;
import org.mechservice.solver.symbol.Expressions;
import org.mechservice.solver.symbol.Scalar;
import org.mechservice.solver.symbol.ScalarVector;

/** Coordinates of tree joints through their links. */
public final class JointLinks {
  private final Expressions expressions;
  private final Links mechanism;
  private final Coordinates coordinates;

  public JointLinks(Expressions expressions, Links mechanism, Coordinates coordinates) {
    this.expressions = expressions;
    this.mechanism = mechanism;
    this.coordinates = coordinates;
  }

  private JointType type(JointCoordinate coordinate) {
    return mechanism.mechanism().joints().get(coordinate.joint()).type();
  }

  /**
   * Returns the difference between the numbers of positions and velocities of a coordinate's joint.
   */
  private int surplus(JointCoordinate coordinate) {
    return type(coordinate).positionCount() - type(coordinate).velocityCount();
  }

  /** Returns a position, rad or m, or an Euler parameter of e/|e|. */
  public Scalar position(JointCoordinate coordinate) {
    if (surplus(coordinate) > 0 && coordinate.component() < 4) {
      Link ball = mechanism.links().get(ball(coordinate.joint()));
      return coordinates.eulerParameters(ball).normalised().at(coordinate.component());
    }
    int component = coordinate.component() - surplus(coordinate);
    return coordinates.position(scalarLink(coordinate.joint(), component));
  }

  /** Returns a velocity, rad/s or m/s. */
  Scalar velocity(JointCoordinate coordinate) {
    if (ofBall(coordinate)) {
      Link ball = mechanism.links().get(ball(coordinate.joint()));
      return coordinates.ballVelocity(ball).at(coordinate.component());
    }
    return coordinates.velocity(scalarLink(coordinate.joint(), coordinate.component()));
  }

  /** Returns the velocity that is the rate of a position. */
  public JointCoordinate velocityOf(JointCoordinate position) {
    int euler = surplus(position);
    return new JointCoordinate(position.joint(), position.component() - euler);
  }

  private boolean ofBall(JointCoordinate coordinate) {
    return surplus(coordinate) > 0 && coordinate.component() < 3;
  }

  /** Returns the link of a position that is not an Euler parameter. */
  public Link link(JointCoordinate position) {
    JointCoordinate velocity = velocityOf(position);
    return scalarLink(velocity.joint(), velocity.component());
  }

  private Link scalarLink(int joint, int component) {
    return mechanism.links().get(scalarIndex(joint, component));
  }

  private int scalarIndex(int joint, int component) {
    List<Link> links = mechanism.links();
    for (int i = 0; i < links.size(); i++) {
      Link link = links.get(i);
      if (link.joint() == joint && !link.isBall() && link.component() == component) {
        return i;
      }
    }
    throw new IllegalArgumentException("joint " + joint + " has no component " + component);
  }

  private int ball(int joint) {
    List<Link> links = mechanism.links();
    for (int i = 0; i < links.size(); i++) {
      if (links.get(i).joint() == joint && links.get(i).isBall()) {
        return i;
      }
    }
    throw new IllegalArgumentException("joint " + joint + " has no Euler parameters");
  }

  /** Adds a force on a velocity coordinate to the loads. */
  public void addForce(JointCoordinate coordinate, Scalar force, Loads loads) {
    if (!ofBall(coordinate)) {
      int index = scalarIndex(coordinate.joint(), coordinate.component());
      loads.addJointForce(index, 2, force);
      return;
    }
    int index = ball(coordinate.joint());
    Link ball = mechanism.links().get(index);
    ScalarVector onBody2 = unit(coordinate.component(), force);
    // the moment is given in body 1's axes: those of the parent, or, backwards, the link's own
    ScalarVector onLink =
        ball.inverse()
            ? onBody2.map(Scalar::negated)
            : coordinates.ballRotation(ball).transposed().times(onBody2);
    for (int axis = 0; axis < 3; axis++) {
      loads.addJointForce(index, axis, onLink.at(axis));
    }
  }

  private ScalarVector unit(int axis, Scalar size) {
    Scalar zero = expressions.zero();
    return new ScalarVector(
        axis == 0 ? size : zero, axis == 1 ? size : zero, axis == 2 ? size : zero);
  }
}
