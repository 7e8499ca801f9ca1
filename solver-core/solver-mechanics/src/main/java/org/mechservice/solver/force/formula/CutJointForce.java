package org.mechservice.solver.force.formula;

import java.util.List;
import java.util.function.IntConsumer;
import org.mechservice.solver.expression.ClosureCoordinate;
import org.mechservice.solver.force.applied.AppliedForce;
import org.mechservice.solver.force.applied.Couplings;
import org.mechservice.solver.force.applied.CutCoordinateLaw;
import org.mechservice.solver.force.applied.CutCoordinates;
import org.mechservice.solver.force.applied.ForceJacobian;
import org.mechservice.solver.force.applied.FrameForce;
import org.mechservice.solver.force.applied.FrameMotion;
import org.mechservice.solver.force.applied.NoJacobian;
import org.mechservice.solver.force.applied.OuterProduct;
import org.mechservice.solver.force.applied.ScalarLaw;
import org.mechservice.solver.kinematics.TreeGeometry;
import org.mechservice.solver.kinematics.TreeMotion;
import org.mechservice.solver.kinematics.pair.CutJoint;
import org.mechservice.solver.kinematics.pair.PairFunction;
import org.mechservice.solver.mechanism.force.JointForce;

/**
 * A force τ in a cut joint, given by an expression: the wrench τ g on the two bodies, g the
 * gradient of the coordinate.
 */
public final class CutJointForce extends AppliedForce {
  private final ExpressionInputs inputs;
  private final Given given = new Given();
  private final FrameForce carried;
  private final FrameMotion frames;
  private final PairFunction function;
  private final OuterProduct product = new OuterProduct(NoJacobian.INSTANCE);
  private final double[] on1 = new double[6];
  private final double[] on2 = new double[6];

  public CutJointForce(JointForce element, TreeMotion motion, ClosureCoordinate coordinate) {
    super(element);
    inputs = new ExpressionInputs(motion, List.of(element.force()));
    CutJoint cut = CutCoordinates.joint(motion.tree(), coordinate);
    function = cut.coordinate(coordinate.component());
    frames = CutCoordinates.frames(motion, cut);
    carried =
        new FrameForce(element, frames, new CutCoordinateLaw(motion, cut, function, 0, given));
  }

  @Override
  public boolean parameters(double[] values) {
    inputs.parameters(values);
    return true;
  }

  @Override
  public boolean apply(double t, double[] wrench, double[] tau) {
    inputs.evaluate(t);
    if (!Double.isFinite(inputs.value(0))) {
      return notFinite("joint force", inputs.value(0));
    }
    given.force = inputs.value(0);
    return carried.apply(t, wrench, tau);
  }

  @Override
  public boolean linearise(double t, ForceJacobian sink) {
    if (!carried.linearise(t, sink)) {
      return false;
    }
    inputs.differentiate();
    product.to(sink);
    frames.wrenches(function.gradient, on1, on2);
    for (int leaf = 0; leaf < inputs.leafCount(); leaf++) {
      double slope = inputs.byLeaf(0, leaf);
      if (!Double.isFinite(slope)) {
        return notFinite("derivative", slope);
      }
      if (frames.link1() != TreeGeometry.ROOT) {
        product.wrench(frames.link1(), on1, slope);
        inputs.gradient(leaf, product);
      }
      if (frames.link2() != TreeGeometry.ROOT) {
        product.wrench(frames.link2(), on2, slope);
        inputs.gradient(leaf, product);
      }
    }
    return true;
  }

  @Override
  public void addByState(int state, double[] wrench, double[] tau) {
    inputs.differentiate();
    frames.wrenches(function.gradient, on1, on2);
    add(frames.link1(), on1, inputs.byState(0, state), wrench);
    add(frames.link2(), on2, inputs.byState(0, state), wrench);
  }

  private static void add(int link, double[] on, double factor, double[] wrench) {
    for (int i = 0; link != TreeGeometry.ROOT && i < on.length; i++) {
      wrench[6 * link + i] += factor * on[i];
    }
  }

  @Override
  public double potentialEnergy() {
    return 0;
  }

  @Override
  public double power() {
    return carried.power();
  }

  @Override
  public void values(double[] out, int at) {
    out[at] = inputs.value(0);
  }

  @Override
  public void accepted() {
    inputs.accepted();
    carried.accepted();
  }

  @Override
  public void couplings(Couplings couplings) {
    carried.couplings(couplings);
    IntConsumer taker =
        by -> {
          for (int on : new int[] {frames.link1(), frames.link2()}) {
            if (on != TreeGeometry.ROOT) {
              couplings.couple(on, by);
            }
          }
        };
    inputs.links(taker);
  }

  /** A force that does not depend on the coordinate itself. */
  private static final class Given implements ScalarLaw {
    private double force;
    private double velocity;

    @Override
    public boolean parameters(double[] values, AppliedForce applied) {
      return true;
    }

    @Override
    public double force(double position, double rate) {
      velocity = rate;
      return force;
    }

    @Override
    public void slopes(double[] by) {
      by[0] = 0;
      by[1] = 0;
    }

    @Override
    public double potentialEnergy() {
      return 0;
    }

    @Override
    public double power() {
      return force * velocity;
    }
  }
}
