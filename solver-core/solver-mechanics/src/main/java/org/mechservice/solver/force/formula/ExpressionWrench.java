package org.mechservice.solver.force.formula;

import static org.mechservice.solver.spatial.Blocks.addCross;
import static org.mechservice.solver.spatial.Blocks.dot;

import java.util.Arrays;
import org.mechservice.solver.force.applied.AppliedForce;
import org.mechservice.solver.force.applied.Couplings;
import org.mechservice.solver.force.applied.ForceJacobian;
import org.mechservice.solver.force.applied.NoJacobian;
import org.mechservice.solver.force.applied.OuterProduct;
import org.mechservice.solver.kinematics.TreeGeometry;
import org.mechservice.solver.kinematics.TreeMotion;
import org.mechservice.solver.mechanism.force.ForceTorque;

/**
 * A force at a point of a body and a torque on it, given by six expressions. Legend: f, m force and
 * torque in link axes; the wrench is [m + r × f; f].
 */
public final class ExpressionWrench extends AppliedForce {
  private final TreeMotion motion;
  private final int link;
  private final boolean inWorld;
  private final ExpressionInputs inputs;
  private final double[] r = new double[3];
  private final double[] given = new double[6];
  private final double[] turned = new double[6];
  private final double[] unit = new double[6];
  private final double[] wrench = new double[6];
  private final double[] column = new double[6];
  private final double[] byPlace = new double[36];
  private final double[] nothing = new double[36];
  private final OuterProduct product = new OuterProduct(NoJacobian.INSTANCE);

  public ExpressionWrench(ForceTorque element, TreeMotion motion) {
    super(element);
    this.motion = motion;
    link = motion.tree().linkOf(element.point().body());
    inWorld = element.axes() == ForceTorque.Axes.WORLD;
    inputs = new ExpressionInputs(motion, element.components());
    motion.tree().fromReference(element.point(), r, 0);
  }

  @Override
  public boolean parameters(double[] values) {
    inputs.parameters(values);
    return true;
  }

  @Override
  public boolean apply(double t, double[] wrenches, double[] tau) {
    inputs.evaluate(t);
    for (int i = 0; i < 6; i++) {
      given[i] = inputs.value(i);
      if (!Double.isFinite(given[i])) {
        return notFinite(i < 3 ? "force" : "torque", given[i]);
      }
    }
    toWrench(given, wrench);
    if (link != TreeGeometry.ROOT) {
      for (int i = 0; i < 6; i++) {
        wrenches[6 * link + i] += wrench[i];
      }
    }
    return true;
  }

  /** Converts the given components [force; torque] to [moment; force] in link axes. */
  private void toWrench(double[] components, double[] out) {
    if (inWorld) {
      motion.fromWorld(link, components, 0, turned, 0);
      motion.fromWorld(link, components, 3, turned, 3);
    } else {
      System.arraycopy(components, 0, turned, 0, 6);
    }
    for (int i = 0; i < 3; i++) {
      out[i] = turned[3 + i];
      out[3 + i] = turned[i];
    }
    addCross(r, 0, turned, 0, out, 0);
  }

  @Override
  public boolean linearise(double t, ForceJacobian sink) {
    if (link == TreeGeometry.ROOT) {
      return true;
    }
    inputs.differentiate();
    product.to(sink);
    for (int leaf = 0; leaf < inputs.leafCount(); leaf++) {
      for (int i = 0; i < 6; i++) {
        column[i] = inputs.byLeaf(i, leaf);
        if (!Double.isFinite(column[i])) {
          return notFinite("derivative", column[i]);
        }
      }
      toWrench(column, unit);
      product.wrench(link, unit, 1);
      inputs.gradient(leaf, product);
    }
    if (inWorld) {
      turnAgainstLink(sink);
    }
    return true;
  }

  /**
   * Adds the derivative of a load with constant world components: in link axes f changes by −δθ ×
   * f, m likewise.
   */
  private void turnAgainstLink(ForceJacobian sink) {
    toWrench(given, wrench);
    Arrays.fill(byPlace, 0);
    for (int j = 0; j < 3; j++) {
      Arrays.fill(unit, 0);
      unit[j] = 1;
      Arrays.fill(column, 0);
      addCross(turned, 3, unit, 0, column, 0);
      addCross(turned, 0, unit, 0, column, 3);
      addCross(r, 0, column, 3, column, 0);
      for (int i = 0; i < 6; i++) {
        byPlace[6 * i + j] = column[i];
      }
    }
    sink.wrenchByLink(link, link, byPlace, nothing);
  }

  @Override
  public void addByState(int state, double[] wrenches, double[] tau) {
    if (link == TreeGeometry.ROOT) {
      return;
    }
    inputs.differentiate();
    for (int i = 0; i < 6; i++) {
      unit[i] = inputs.byState(i, state);
    }
    toWrench(unit, column);
    for (int i = 0; i < 6; i++) {
      wrenches[6 * link + i] += column[i];
    }
  }

  @Override
  public double potentialEnergy() {
    return 0;
  }

  @Override
  public double power() {
    if (link == TreeGeometry.ROOT) {
      return 0;
    }
    return dot(wrench, 0, motion.angularVelocity, 3 * link)
        + dot(wrench, 3, motion.linearVelocity, 3 * link);
  }

  @Override
  public void values(double[] out, int at) {
    System.arraycopy(given, 0, out, at, 6);
  }

  @Override
  public void accepted() {
    inputs.accepted();
  }

  @Override
  public void couplings(Couplings couplings) {
    if (link != TreeGeometry.ROOT) {
      inputs.links(by -> couplings.couple(link, by));
    }
  }
}
