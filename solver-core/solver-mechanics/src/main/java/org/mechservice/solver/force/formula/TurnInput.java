package org.mechservice.solver.force.formula;

import static org.mechservice.solver.spatial.Blocks.cross;

import java.util.Arrays;
import java.util.function.IntConsumer;
import org.mechservice.solver.force.applied.GradientSink;
import org.mechservice.solver.kinematics.TreeGeometry;
import org.mechservice.solver.kinematics.TreeMotion;

/**
 * A component of a body's small rotation, or of its angular velocity, in world axes. With the
 * world's axis e in link axes: e · δθ, and e · ω changes by e · (δθ × ω) at held velocity
 * components.
 */
public final class TurnInput extends LeafInput {
  private final TreeMotion motion;
  private final int link;
  private final boolean velocity;
  private final double[] unit = new double[3];
  private final double[] e = new double[3];
  private final double[] byPlace = new double[6];
  private final double[] byVelocity = new double[6];

  public TurnInput(TreeMotion motion, int link, int axis, boolean velocity) {
    this.motion = motion;
    this.link = link;
    this.velocity = velocity;
    unit[axis] = 1;
  }

  /** Returns zero: a small rotation has no value, only a gradient. */
  @Override
  double value(double t) {
    return 0;
  }

  @Override
  public void gradient(GradientSink sink) {
    if (link == TreeGeometry.ROOT) {
      return;
    }
    motion.fromWorld(link, unit, 0, e, 0);
    System.arraycopy(e, 0, velocity ? byVelocity : byPlace, 0, 3);
    if (velocity) {
      Arrays.fill(byPlace, 0);
      cross(motion.angularVelocity, 3 * link, e, 0, byPlace, 0);
    }
    sink.byLink(link, byPlace, byVelocity);
  }

  @Override
  public void links(IntConsumer taker) {
    if (link != TreeGeometry.ROOT) {
      taker.accept(link);
    }
  }
}
