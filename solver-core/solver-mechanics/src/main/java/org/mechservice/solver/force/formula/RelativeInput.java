package org.mechservice.solver.force.formula;

import java.util.Arrays;
import java.util.function.IntConsumer;
import org.mechservice.solver.expression.Expression.RelativeMotion;
import org.mechservice.solver.force.applied.FrameMotion;
import org.mechservice.solver.force.applied.GradientSink;
import org.mechservice.solver.kinematics.TreeGeometry;
import org.mechservice.solver.kinematics.TreeMotion;

/** A component of the pose or velocity of a frame relative to another one. */
final class RelativeInput extends LeafInput {
  private final FrameMotion frames;
  private final int component;
  private final double[] xi = new double[6];
  private final double[] place = new double[6];
  private final double[] velocity = new double[6];
  private final double[] byPlace = new double[6];
  private final double[] byVelocity = new double[6];

  RelativeInput(TreeMotion motion, RelativeMotion relative) {
    frames = new FrameMotion(motion, relative.frame1(), relative.frame2());
    component = relative.component();
  }

  @Override
  double value(double t) {
    frames.read();
    return frames.component(component);
  }

  @Override
  public void gradient(GradientSink sink) {
    gradient(true, frames.link1(), sink);
    gradient(false, frames.link2(), sink);
  }

  private void gradient(boolean first, int link, GradientSink sink) {
    if (link == TreeGeometry.ROOT) {
      return;
    }
    int ofTwist = component - RelativeMotion.ANGULAR_VELOCITY;
    for (int j = 0; j < 6; j++) {
      Arrays.fill(xi, 0);
      xi[j] = 1;
      frames.changeByPlace(first, xi, place, velocity);
      byPlace[j] = ofTwist < 0 ? frames.changeOf(component, place) : velocity[ofTwist];
      frames.changeByVelocity(first, xi, velocity);
      byVelocity[j] = ofTwist < 0 ? 0 : velocity[ofTwist];
    }
    sink.byLink(link, byPlace, byVelocity);
  }

  @Override
  public void links(IntConsumer taker) {
    for (int link : new int[] {frames.link1(), frames.link2()}) {
      if (link != TreeGeometry.ROOT) {
        taker.accept(link);
      }
    }
  }
}
