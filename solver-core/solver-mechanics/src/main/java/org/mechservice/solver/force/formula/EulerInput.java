package org.mechservice.solver.force.formula;

import java.util.function.IntConsumer;
import org.mechservice.solver.expression.JointCoordinate;
import org.mechservice.solver.force.applied.GradientSink;
import org.mechservice.solver.kinematics.LinkKind;
import org.mechservice.solver.kinematics.TreeGeometry;
import org.mechservice.solver.kinematics.TreeMotion;
import org.mechservice.solver.spatial.EulerParameters;

/** An Euler parameter e_i / |e|; a small rotation δ changes it by ½ ((0, δ) ∘ e)_i / |e|. */
final class EulerInput extends LeafInput {
  private final TreeMotion motion;
  private final int first;
  private final int velocity;
  private final int component;
  private final double[] unit = new double[3];
  private final double[] rate = new double[4];

  /**
   * @param first index of the first of the four parameters among the extended positions
   */
  EulerInput(TreeMotion motion, int first, JointCoordinate coordinate) {
    this.motion = motion;
    this.first = first;
    component = coordinate.component();
    TreeGeometry tree = motion.tree();
    int found = -1;
    for (int link = 0; link < tree.linkCount; link++) {
      if (tree.kind[link] == LinkKind.BALL && tree.joint[link] == coordinate.joint()) {
        found = tree.velocityAt[link];
      }
    }
    velocity = found;
  }

  @Override
  double value(double t) {
    return motion.q[first + component] / EulerParameters.norm(motion.q, first);
  }

  @Override
  public void gradient(GradientSink sink) {
    double norm = EulerParameters.norm(motion.q, first);
    for (int k = 0; k < 3; k++) {
      for (int i = 0; i < 3; i++) {
        unit[i] = i == k ? 1 : 0;
      }
      EulerParameters.rate(motion.q, first, unit, 0, rate, 0);
      sink.byCoordinate(velocity + k, rate[component] / norm, 0);
    }
  }

  @Override
  public void links(IntConsumer taker) {
    taker.accept(motion.tree().linkOfVelocity[velocity]);
  }
}
