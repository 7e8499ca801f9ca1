package examples.fivepointsuspension;

import org.mechservice.solver.api.ForceDeclaration;
import org.mechservice.solver.api.ForceLoads;
import org.mechservice.solver.api.ForceState;
import org.mechservice.solver.api.UserForce;

/**
 * What the road and the rest of the car do: the tyre rolls over a staircase of three steps up, and
 * the car drives at 30 m/s and pulls the frame along.
 */
public final class FpsFBody implements UserForce {
  /** Radius of the loaded tyre, m, and what the free one is larger by. */
  private static final double LOADED_RADIUS = 0.27797931277954296;

  private static final double DEFLECTION = 0.02;

  /** N/m, N·s/m, and N·s/m along the road. */
  private static final double TYRE_STIFFNESS = 200000;

  private static final double TYRE_DAMPING = 300;
  private static final double TRACTION = 2000;

  /** Smoothing of the contact, m. */
  private static final double SMOOTHING = 1e-4;

  /** Height and half width of a step, and where the steps are, m. */
  private static final double STEP = 0.015;

  private static final double WIDTH = 0.15;
  private static final double[] STEPS = {10, 25, 40};

  /** Speed of the car, m/s, and how it pulls, N/m and N·s/m. */
  private static final double SPEED = 30;

  private static final double PULL_STIFFNESS = 100000;
  private static final double PULL_DAMPING = 3000;

  private final double[] centre = new double[3];
  private final double[] u = new double[3];
  private int wheel;
  private int spin;
  private int car;
  private int load;

  @Override
  public void declare(ForceDeclaration model) {
    wheel =
        model.point(
            "Wheel", "p1", ForceDeclaration.Reads.POSITION, ForceDeclaration.Reads.VELOCITY);
    spin = model.coordinate("j3", 0);
    car = model.coordinate("j1", 0);
    load = model.value("tyreLoad", "N");
  }

  @Override
  public void apply(ForceState state, ForceLoads loads) {
    state.position(wheel, centre);
    state.velocity(wheel, u);
    double height = 0;
    double slope = 0;
    for (double step : STEPS) {
      double rise = Math.tanh((centre[0] - step) / WIDTH);
      height += STEP / 2 * (1 + rise);
      slope += STEP / (2 * WIDTH) * (1 - rise * rise);
    }
    double d = DEFLECTION + height - centre[2];
    double rate = slope * u[0] - u[2];
    double root = Math.sqrt(d * d + SMOOTHING * SMOOTHING);
    double up = TYRE_STIFFNESS * (d + root) / 2 + TYRE_DAMPING * rate * (1 + d / root) / 2;
    double along = TRACTION * (LOADED_RADIUS * state.rate(spin) - u[0]);
    loads.addForce(wheel, along, 0, up);
    // The forces act where the tyre meets the road, below the centre.
    loads.addTorque(wheel, 0, -LOADED_RADIUS * along, 0);
    loads.addJointForce(
        car,
        PULL_STIFFNESS * (SPEED * state.time() - state.coordinate(car))
            + PULL_DAMPING * (SPEED - state.rate(car)));
    loads.setValue(load, up);
  }
}
