package org.mechservice.mechml.resolve.force;

import java.util.ArrayList;
import java.util.List;
import org.mechservice.solver.expression.BodyFrame;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.expression.Expression.RelativeMotion;

/**
 * The motion of frame 2 relative to frame 1 as expressions, in the axes of frame 1.
 *
 * @param frame1 on body 1
 * @param frame2 on body 2
 * @param components all components, each one object
 */
record RelativeFrames(BodyFrame frame1, BodyFrame frame2, List<Expression> components) {
  static RelativeFrames of(BodyFrame frame1, BodyFrame frame2) {
    List<Expression> components = new ArrayList<>();
    for (int i = 0; i < RelativeMotion.COUNT; i++) {
      components.add(new RelativeMotion(frame1, frame2, i));
    }
    return new RelativeFrames(frame1, frame2, List.copyOf(components));
  }

  private ExpressionVector from(int first, int stride) {
    return new ExpressionVector(
        components.get(first), components.get(first + stride), components.get(first + 2 * stride));
  }

  /** Returns the origin of frame 2, m. */
  ExpressionVector displacement() {
    return from(0, 1);
  }

  /** Returns the axis x, y or z of frame 2. */
  ExpressionVector axis2(int axis) {
    return from(RelativeMotion.ROTATION + axis, 3);
  }

  /** Returns the angular velocity of frame 2, rad/s. */
  ExpressionVector omega() {
    return from(RelativeMotion.ANGULAR_VELOCITY, 1);
  }

  /** Returns the velocity of the origin of frame 2, m/s. */
  ExpressionVector rate() {
    return from(RelativeMotion.RATE, 1);
  }

  /** Returns the velocity of a point of body 2, given from the origin of frame 2. */
  ExpressionVector velocityAt(ExpressionVector arm) {
    return rate().plus(omega().cross(arm));
  }
}
