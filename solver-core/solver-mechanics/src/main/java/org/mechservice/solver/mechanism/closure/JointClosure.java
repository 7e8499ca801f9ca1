package org.mechservice.solver.mechanism.closure;

import java.util.List;
import java.util.Optional;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.mechanism.joint.Joint;
import org.mechservice.solver.mechanism.joint.StartRole;
import org.mechservice.solver.text.Origin;

/**
 * A joint of any type that was cut to open a loop: it constrains the relative motion of its two
 * bodies (docs/mechml.md#joints). Its coordinates are not states; they follow from the poses of the
 * two bodies.
 *
 * @param joint the joint; either of its bodies may be the root. Its start values are not part of
 *     the state
 * @param startRole freedom of assembly to change the start values
 * @param motion prescribed motion: one expression of time per coordinate, rad or m; empty if the
 *     joint moves freely
 */
public record JointClosure(Joint joint, StartRole startRole, List<Expression> motion)
    implements LoopClosure {

  /**
   * @throws IllegalArgumentException if the number of motions is neither zero nor one per
   *     coordinate, or the joint has Euler parameters (S, F)
   */
  public JointClosure {
    motion = List.copyOf(motion);
    problem(joint, motion)
        .ifPresent(
            text -> {
              throw new IllegalArgumentException(text);
            });
  }

  private static Optional<String> problem(Joint joint, List<Expression> motion) {
    int positions = joint.type().positionCount();
    if (motion.isEmpty()) {
      return Optional.empty();
    }
    if (positions != joint.type().velocityCount()) {
      return Optional.of(
          "joint "
              + joint.name()
              + " of type "
              + joint.type()
              + " cannot be driven by coordinates");
    }
    return motion.size() == positions
        ? Optional.empty()
        : Optional.of(
            "joint "
                + joint.name()
                + " has "
                + positions
                + " coordinates but "
                + motion.size()
                + " motions");
  }

  /** A joint without prescribed motion that starts near its start values. */
  public JointClosure(Joint joint) {
    this(joint, StartRole.PREFERRED, List.of());
  }

  @Override
  public String name() {
    return joint.name();
  }

  @Override
  public Origin origin() {
    return joint.origin();
  }

  /** Returns whether assembly must keep the joint's start values. */
  public boolean keepsStart() {
    return startRole == StartRole.FIXED && !isDriven();
  }

  /** Returns whether the joint's coordinates follow prescribed motions. */
  public boolean isDriven() {
    return !motion.isEmpty();
  }
}
