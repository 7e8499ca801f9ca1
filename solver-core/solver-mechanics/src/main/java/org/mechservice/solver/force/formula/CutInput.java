package org.mechservice.solver.force.formula;

import java.util.Arrays;
import java.util.function.IntConsumer;
import org.mechservice.solver.expression.ClosureCoordinate;
import org.mechservice.solver.force.applied.CutCoordinates;
import org.mechservice.solver.force.applied.ForceJacobian;
import org.mechservice.solver.force.applied.FrameMotion;
import org.mechservice.solver.force.applied.GradientSink;
import org.mechservice.solver.kinematics.TreeGeometry;
import org.mechservice.solver.kinematics.TreeMotion;
import org.mechservice.solver.kinematics.pair.CutJoint;
import org.mechservice.solver.kinematics.pair.PairFunction;
import org.mechservice.solver.kinematics.pair.PairLinearisation;

/**
 * A position or velocity of a cut joint: x with gradient g by the relative pose, ẋ = g · twist with
 * gradient C twist.
 */
final class CutInput extends LeafInput {
  private final TreeMotion motion;
  private final CutJoint cut;
  private final FrameMotion frames;
  private final PairFunction function;
  private final boolean velocity;
  private final double[] curvature = new double[36];
  private final double[] xi = new double[6];
  private final double[] place = new double[6];
  private final double[] twist = new double[6];
  private final double[] byPlace = new double[6];
  private final double[] byVelocity = new double[6];
  private final double[] still = new double[36];
  private final PairLinearisation linearisation = new PairLinearisation();

  /** The position at the last accepted step, in {@link TreeMotion#counted}. */
  private final int reference;

  private double value;

  CutInput(TreeMotion motion, ClosureCoordinate coordinate, boolean velocity) {
    this.motion = motion;
    this.velocity = velocity;
    cut = CutCoordinates.joint(motion.tree(), coordinate);
    frames = CutCoordinates.frames(motion, cut);
    int component =
        velocity
            ? coordinate.component()
            : CutCoordinates.velocityOfPosition(cut, coordinate.component());
    function = cut.coordinate(component);
    reference =
        motion.counted.add(velocity ? 0 : CutCoordinates.start(cut, coordinate.component()));
  }

  @Override
  double value(double t) {
    frames.read();
    cut.relative().place(motion);
    double found = function.evaluate(cut.relative());
    if (!velocity) {
      double before = motion.counted.get(reference);
      value = before + function.difference(found, before);
      return value;
    }
    double rate = 0;
    for (int i = 0; i < 6; i++) {
      rate += function.gradient[i] * frames.twist(i);
    }
    return rate;
  }

  @Override
  public void gradient(GradientSink sink) {
    Arrays.fill(curvature, 0);
    if (velocity) {
      function.addCurvature(cut.relative(), 1, curvature);
    }
    gradient(true, frames.link1(), sink);
    gradient(false, frames.link2(), sink);
  }

  private void gradient(boolean first, int link, GradientSink sink) {
    if (link == TreeGeometry.ROOT) {
      return;
    }
    for (int j = 0; j < 6; j++) {
      Arrays.fill(xi, 0);
      xi[j] = 1;
      frames.changeByPlace(first, xi, place, twist);
      if (velocity) {
        double sum = dot(function.gradient, twist);
        for (int i = 0; i < 6; i++) {
          for (int k = 0; k < 6; k++) {
            sum += frames.twist(i) * curvature[6 * i + k] * place[k];
          }
        }
        byPlace[j] = sum;
        frames.changeByVelocity(first, xi, twist);
        byVelocity[j] = dot(function.gradient, twist);
      } else {
        byPlace[j] = dot(function.gradient, place);
      }
    }
    sink.byLink(link, byPlace, byVelocity);
  }

  @Override
  void addCurvature(double force, ForceJacobian sink) {
    Arrays.fill(curvature, 0);
    function.addCurvature(cut.relative(), force, curvature);
    for (int i = 0; i < 6; i++) {
      xi[i] = force * function.gradient[i];
    }
    linearisation.blocks(
        cut.relative(),
        xi,
        curvature,
        (on, by, blocks) -> sink.wrenchByLink(on, by, blocks, still));
  }

  private static double dot(double[] a, double[] b) {
    double sum = 0;
    for (int i = 0; i < 6; i++) {
      sum += a[i] * b[i];
    }
    return sum;
  }

  @Override
  void accepted() {
    motion.counted.set(reference, value);
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
