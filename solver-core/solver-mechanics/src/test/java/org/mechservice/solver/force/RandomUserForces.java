package org.mechservice.solver.force;

import org.mechservice.solver.api.ForceBlocks;
import org.mechservice.solver.api.ForceDeclaration;
import org.mechservice.solver.api.ForceDeclaration.Reads;
import org.mechservice.solver.api.ForceLoads;
import org.mechservice.solver.api.ForceState;
import org.mechservice.solver.api.UserForce;
import org.mechservice.solver.mechanism.force.UserForceElement;

/** User forces that read and act on everything there is, with and without derivatives. */
public final class RandomUserForces {
  private RandomUserForces() {}

  public static UserForce create(UserForceElement element) {
    String[] words = element.className().split(" ", -1);
    int component = Integer.parseInt(words[2]);
    return words[0].equals("derivatives")
        ? new Linear(words[1], component)
        : new Nonlinear(words[1], component);
  }

  /** Reads all there is to read of two points and acts on three. */
  static final class Nonlinear implements UserForce {
    private final String jointName;
    private final int component;
    private int a;
    private int b;
    private int c;
    private int joint;
    private final double[] p = new double[3];
    private final double[] u = new double[3];
    private final double[] w = new double[3];
    private final double[] r = new double[9];

    Nonlinear(String jointName, int component) {
      this.jointName = jointName;
      this.component = component;
    }

    @Override
    public void declare(ForceDeclaration model) {
      a = model.point("A", "p", Reads.POSITION, Reads.ROTATION);
      b = model.point("B", "p", Reads.VELOCITY, Reads.ANGULAR_VELOCITY);
      c = model.point("C", "p");
      joint = model.coordinate(jointName, component);
      model.value("speed", "m/s");
    }

    @Override
    public void apply(ForceState state, ForceLoads loads) {
      state.position(a, p);
      state.rotation(a, r);
      state.velocity(b, u);
      state.angularVelocity(b, w);
      double s = Math.sin(state.time() + state.rate(joint));
      loads.addForce(a, u[0] * p[1], r[5] * s, p[2] * p[2]);
      loads.addForce(c, r[0] + w[1], u[1] * u[2], p[0]);
      loads.addTorque(b, r[3] * w[0], r[7], w[2] * p[0]);
      loads.addTorque(c, u[0], p[1] * r[1], s);
      loads.addJointForce(joint, p[0] * r[8] - u[2] + w[1] * s);
      loads.setValue(0, u[0]);
    }
  }

  /** A spring and damper between A and B in all directions, and a torque against turning. */
  static final class Linear implements UserForce.Derivatives {
    private final String jointName;
    private final int component;
    private int a;
    private int b;
    private int joint;
    private final double[] p = new double[3];
    private final double[] r = new double[3];
    private final double[] u = new double[3];
    private final double[] w = new double[3];
    private final double[] rotation = new double[9];

    Linear(String jointName, int component) {
      this.jointName = jointName;
      this.component = component;
    }

    @Override
    public void declare(ForceDeclaration model) {
      a = model.point("A", "p", Reads.POSITION, Reads.VELOCITY, Reads.ROTATION);
      b = model.point("B", "p", Reads.POSITION, Reads.ANGULAR_VELOCITY);
      joint = model.coordinate(jointName, component);
    }

    @Override
    public void apply(ForceState state, ForceLoads loads) {
      state.position(a, p);
      state.position(b, r);
      state.velocity(a, u);
      state.angularVelocity(b, w);
      state.rotation(a, rotation);
      double k = 3;
      loads.addForce(
          b, k * (p[0] - r[0]) + u[0], k * (p[1] - r[1]) + u[1], k * (p[2] - r[2]) + u[2]);
      loads.addTorque(b, -2 * w[0], -2 * w[1], -2 * w[2]);
      // the third axis of the body, as a torque on it and in the joint
      loads.addTorque(a, rotation[2], rotation[5], rotation[8]);
      loads.addJointForce(joint, rotation[2] - 0.5 * state.rate(joint) + p[1]);
    }

    @Override
    public void differentiate(ForceState state, ForceBlocks blocks) {
      state.rotation(a, rotation);
      double[] k = {3, 0, 0, 0, 3, 0, 0, 0, 3};
      double[] minusK = {-3, 0, 0, 0, -3, 0, 0, 0, -3};
      double[] one = {1, 0, 0, 0, 1, 0, 0, 0, 1};
      double[] damping = {-2, 0, 0, 0, -2, 0, 0, 0, -2};
      blocks.byPoint(ForceBlocks.Load.FORCE, b, Reads.POSITION, a, k);
      blocks.byPoint(ForceBlocks.Load.FORCE, b, Reads.POSITION, b, minusK);
      blocks.byPoint(ForceBlocks.Load.FORCE, b, Reads.VELOCITY, a, one);
      blocks.byPoint(ForceBlocks.Load.TORQUE, b, Reads.ANGULAR_VELOCITY, b, damping);
      double x = rotation[2];
      double y = rotation[5];
      double z = rotation[8];
      // δ × n = −[n]× δ
      double[] turned = {0, z, -y, -z, 0, x, y, -x, 0};
      blocks.byPoint(ForceBlocks.Load.TORQUE, a, Reads.ROTATION, a, turned);
      blocks.byPoint(
          ForceBlocks.Load.JOINT_FORCE, joint, Reads.ROTATION, a, new double[] {0, z, -y});
      blocks.byPoint(
          ForceBlocks.Load.JOINT_FORCE, joint, Reads.POSITION, a, new double[] {0, 1, 0});
      blocks.byCoordinate(
          ForceBlocks.Load.JOINT_FORCE, joint, joint, new double[] {0}, new double[] {-0.5});
    }
  }
}
