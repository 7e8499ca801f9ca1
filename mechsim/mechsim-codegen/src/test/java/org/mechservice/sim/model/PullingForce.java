package org.mechservice.sim.model;

import java.util.ArrayList;
import java.util.List;
import org.mechservice.solver.api.ForceDeclaration;
import org.mechservice.solver.api.ForceDeclaration.Reads;
import org.mechservice.solver.api.ForceLoads;
import org.mechservice.solver.api.ForceState;
import org.mechservice.solver.api.UserForce;

/** A force written as a class that reads all there is to read and acts on points and all joints. */
public final class PullingForce implements UserForce {
  private static final int MOST_JOINTS = 20;
  private static final int MOST_COMPONENTS = 6;

  private final List<Integer> coordinates = new ArrayList<>();
  private final double[] p = new double[3];
  private final double[] u = new double[3];
  private final double[] w = new double[3];
  private final double[] r = new double[9];
  private int a;
  private int b;
  private int c;

  @Override
  public void declare(ForceDeclaration model) {
    a = model.point("A", "p", Reads.POSITION, Reads.ROTATION);
    b = model.point("B", "p", Reads.VELOCITY, Reads.ANGULAR_VELOCITY);
    c = model.point("C", "p");
    for (int joint = 0; joint < MOST_JOINTS; joint++) {
      for (int component = 0; component < MOST_COMPONENTS; component++) {
        try {
          coordinates.add(model.coordinate("j" + joint, component));
        } catch (IllegalArgumentException e) {
          // The model has none of that name; the force acts on those it has.
          break;
        }
      }
    }
    model.value("speed", "m/s");
  }

  @Override
  public void apply(ForceState state, ForceLoads loads) {
    state.position(a, p);
    state.rotation(a, r);
    state.velocity(b, u);
    state.angularVelocity(b, w);
    double s = StrictMath.sin(state.time() + p[0]);
    loads.addForce(a, u[0] * p[1], r[5] * s, p[2] * p[2]);
    loads.addForce(c, r[0] + w[1], u[1] * u[2], p[0]);
    loads.addTorque(b, r[3] * w[0], r[7], w[2] * p[0]);
    loads.addTorque(c, u[0], p[1] * r[1], s);
    for (int i = 0; i < coordinates.size(); i++) {
      int coordinate = coordinates.get(i);
      loads.addJointForce(coordinate, s - 0.3 * state.rate(coordinate));
    }
    loads.setValue(0, u[0]);
  }
}
