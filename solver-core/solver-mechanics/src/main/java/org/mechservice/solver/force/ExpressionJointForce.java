package org.mechservice.solver.force;

import java.util.List;
import org.mechservice.solver.kinematics.TreeMotion;
import org.mechservice.solver.mechanism.force.JointForce;

/** A force in a joint of the tree, given by an expression. */
final class ExpressionJointForce extends AppliedForce {
  private final TreeMotion motion;
  private final int coordinate;
  private final ExpressionInputs inputs;
  private final OuterProduct product = new OuterProduct(NoJacobian.INSTANCE);

  ExpressionJointForce(JointForce element, TreeMotion motion, TreeCoordinate coordinate) {
    super(element);
    this.motion = motion;
    this.coordinate = coordinate.velocity();
    inputs = new ExpressionInputs(motion, List.of(element.force()));
  }

  @Override
  boolean parameters(double[] values) {
    inputs.parameters(values);
    return true;
  }

  @Override
  boolean apply(double t, double[] wrench, double[] tau) {
    inputs.evaluate(t);
    double force = inputs.value(0);
    if (!Double.isFinite(force)) {
      return notFinite("joint force", force);
    }
    tau[coordinate] += force;
    return true;
  }

  @Override
  boolean linearise(double t, ForceJacobian sink) {
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
  double potentialEnergy() {
    return 0;
  }

  @Override
  double power() {
    return inputs.value(0) * motion.v[coordinate];
  }

  @Override
  void values(double[] out, int at) {
    out[at] = inputs.value(0);
  }

  @Override
  void accepted() {
    inputs.accepted();
  }

  @Override
  void couplings(Couplings couplings) {
    int on = motion.tree().linkOfVelocity[coordinate];
    inputs.links(by -> couplings.couple(on, by));
  }
}
