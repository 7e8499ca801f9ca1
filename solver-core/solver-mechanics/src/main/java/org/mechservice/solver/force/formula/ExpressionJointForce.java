package org.mechservice.solver.force.formula;

import java.util.List;
import org.mechservice.solver.force.applied.AppliedForce;
import org.mechservice.solver.force.applied.Couplings;
import org.mechservice.solver.force.applied.ForceJacobian;
import org.mechservice.solver.force.applied.NoJacobian;
import org.mechservice.solver.force.applied.OuterProduct;
import org.mechservice.solver.force.applied.TreeCoordinate;
import org.mechservice.solver.kinematics.TreeMotion;
import org.mechservice.solver.mechanism.force.JointForce;

/** A force in a joint of the tree, given by an expression. */
public final class ExpressionJointForce extends AppliedForce {
  private final TreeMotion motion;
  private final int coordinate;
  private final ExpressionInputs inputs;
  private final OuterProduct product = new OuterProduct(NoJacobian.INSTANCE);

  public ExpressionJointForce(JointForce element, TreeMotion motion, TreeCoordinate coordinate) {
    super(element);
    this.motion = motion;
    this.coordinate = coordinate.velocity();
    inputs = new ExpressionInputs(motion, List.of(element.force()));
  }

  @Override
  public boolean parameters(double[] values) {
    inputs.parameters(values);
    return true;
  }

  @Override
  public boolean apply(double t, double[] wrench, double[] tau) {
    inputs.evaluate(t);
    double force = inputs.value(0);
    if (!Double.isFinite(force)) {
      return notFinite("joint force", force);
    }
    tau[coordinate] += force;
    return true;
  }

  @Override
  public boolean linearise(double t, ForceJacobian sink) {
    inputs.differentiate();
    product.to(sink);
    for (int leaf = 0; leaf < inputs.leafCount(); leaf++) {
      double slope = inputs.byLeaf(0, leaf);
      if (!Double.isFinite(slope)) {
        return notFinite("derivative", slope);
      }
      product.force(coordinate, slope);
      inputs.gradient(leaf, product);
    }
    return true;
  }

  @Override
  public void addByState(int state, double[] wrench, double[] tau) {
    inputs.differentiate();
    tau[coordinate] += inputs.byState(0, state);
  }

  @Override
  public double potentialEnergy() {
    return 0;
  }

  @Override
  public double power() {
    return inputs.value(0) * motion.v[coordinate];
  }

  @Override
  public void values(double[] out, int at) {
    out[at] = inputs.value(0);
  }

  @Override
  public void accepted() {
    inputs.accepted();
  }

  @Override
  public void couplings(Couplings couplings) {
    int on = motion.tree().linkOfVelocity[coordinate];
    inputs.links(by -> couplings.couple(on, by));
  }
}
