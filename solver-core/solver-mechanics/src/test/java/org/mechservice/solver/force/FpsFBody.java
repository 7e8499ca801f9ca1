package org.mechservice.solver.force;

import org.mechservice.solver.api.ForceDeclaration;
import org.mechservice.solver.api.ForceDeclaration.Reads;
import org.mechservice.solver.api.ForceLoads;
import org.mechservice.solver.api.ForceState;
import org.mechservice.solver.api.UserForce;

/**
 * What drives the five-point suspension: a road with three steps under the tyre, and the car that
 * pulls the frame along. An example of a force without derivatives.
 */
public final class FpsFBody implements UserForce {
  private static final double STEP_HEIGHT = 0.015;
  private static final double STEP_WIDTH = 0.15;
  private static final double[] STEPS = {10, 25, 40};
  private static final double LOADED_RADIUS = 0.27797931277954296;
  private static final double RADIUS = LOADED_RADIUS + 0.02;
  private static final double TYRE_STIFFNESS = 200000;
  private static final double TYRE_DAMPING = 300;
  private static final double SMOOTHING = 1e-4;
  private static final double SLIP_STIFFNESS = 2000;
  private static final double SPEED = 30;
  private static final double TOW_STIFFNESS = 100000;
  private static final double TOW_DAMPING = 3000;

  private int center;
  private int guide;
  private int spin;
  private final double[] c = new double[3];
  private final double[] u = new double[3];

  @Override
  public void declare(ForceDeclaration model) {
    center = model.point("Wheel", "p1", Reads.POSITION, Reads.VELOCITY);
    guide = model.coordinate("j1", 0);
    spin = model.coordinate("j3", 0);
    model.value("tyre", "N");
    model.value("tow", "N");
  }

  @Override
  public void apply(ForceState state, ForceLoads loads) {
    state.position(center, c);
    state.velocity(center, u);
    double height = 0;
    double slope = 0;
    for (double at : STEPS) {
      double tanh = StrictMath.tanh((c[0] - at) / STEP_WIDTH);
      height += 0.5 * STEP_HEIGHT * (1 + tanh);
      slope += 0.5 * STEP_HEIGHT * (1 - tanh * tanh) / STEP_WIDTH;
    }
    double deflection = RADIUS - (c[2] + LOADED_RADIUS - height);
    double deflectionRate = slope * u[0] - u[2];
    double root = Math.sqrt(deflection * deflection + SMOOTHING * SMOOTHING);
    double push =
        TYRE_STIFFNESS * 0.5 * (deflection + root)
            + TYRE_DAMPING * deflectionRate * 0.5 * (1 + deflection / root);
    double drive = SLIP_STIFFNESS * (LOADED_RADIUS * state.rate(spin) - u[0]);
    // both act at the road, LOADED_RADIUS below the centre: moment (0, 0, −R) × F
    loads.addForce(center, drive, 0, push);
    loads.addTorque(center, 0, -LOADED_RADIUS * drive, 0);
    double tow =
        TOW_STIFFNESS * (SPEED * state.time() - state.coordinate(guide))
            + TOW_DAMPING * (SPEED - state.rate(guide));
    loads.addJointForce(guide, tow);
    loads.setValue(0, push);
    loads.setValue(1, tow);
  }
}
