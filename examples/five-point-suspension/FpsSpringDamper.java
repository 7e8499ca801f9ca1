package examples.fivepointsuspension;

import org.mechservice.solver.api.ForceDeclaration;
import org.mechservice.solver.api.ForceLoads;
import org.mechservice.solver.api.ForceState;
import org.mechservice.solver.api.UserForce;

/**
 * The strut between frame and carrier: tension F0 + k (L - L0) + c L'. The model names no points at
 * its ends, so they are found from the bodies' own points and rotations.
 */
public final class FpsSpringDamper implements UserForce {
  /** Ends from p1 of the frame and of the carrier, in their axes, m. */
  private static final double[] ON_FRAME = {0.064, 0.137, 0.123};

  private static final double[] ON_CARRIER = {0.103, 0.187, -0.137};

  /** N/m, N·s/m. */
  private static final double STIFFNESS = 30000;

  private static final double DAMPING = 1500;

  /** Length at the start, m, and tension there, N: the strut carries the frame. */
  private static final double LENGTH = 0.5099019513592785;

  private static final double PRELOAD = -3971.6;

  private final End top = new End(ON_FRAME);
  private final End bottom = new End(ON_CARRIER);
  private int tension;

  @Override
  public void declare(ForceDeclaration model) {
    top.declare(model, "Frame");
    bottom.declare(model, "Carrier");
    tension = model.value("tension", "N");
  }

  @Override
  public void apply(ForceState state, ForceLoads loads) {
    top.read(state);
    bottom.read(state);
    double dx = bottom.place[0] - top.place[0];
    double dy = bottom.place[1] - top.place[1];
    double dz = bottom.place[2] - top.place[2];
    double length = Math.sqrt(dx * dx + dy * dy + dz * dz);
    double ux = dx / length;
    double uy = dy / length;
    double uz = dz / length;
    double rate =
        ux * (bottom.velocity[0] - top.velocity[0])
            + uy * (bottom.velocity[1] - top.velocity[1])
            + uz * (bottom.velocity[2] - top.velocity[2]);
    double force = PRELOAD + STIFFNESS * (length - LENGTH) + DAMPING * rate;
    top.pull(loads, force * ux, force * uy, force * uz);
    bottom.pull(loads, -force * ux, -force * uy, -force * uz);
    loads.setValue(tension, force);
  }

  /** One end of the strut. */
  private static final class End {
    /** From the body's p1, in body axes. */
    private final double[] own;

    /** From the body's p1, in world axes. */
    private final double[] arm = new double[3];

    private final double[] place = new double[3];
    private final double[] velocity = new double[3];
    private final double[] rotation = new double[9];
    private final double[] spin = new double[3];
    private int point;

    End(double[] own) {
      this.own = own;
    }

    void declare(ForceDeclaration model, String body) {
      point =
          model.point(
              body,
              "p1",
              ForceDeclaration.Reads.POSITION,
              ForceDeclaration.Reads.ROTATION,
              ForceDeclaration.Reads.VELOCITY,
              ForceDeclaration.Reads.ANGULAR_VELOCITY);
    }

    void read(ForceState state) {
      state.rotation(point, rotation);
      state.position(point, place);
      state.velocity(point, velocity);
      state.angularVelocity(point, spin);
      for (int i = 0; i < 3; i++) {
        arm[i] =
            rotation[3 * i] * own[0] + rotation[3 * i + 1] * own[1] + rotation[3 * i + 2] * own[2];
        place[i] += arm[i];
      }
      velocity[0] += spin[1] * arm[2] - spin[2] * arm[1];
      velocity[1] += spin[2] * arm[0] - spin[0] * arm[2];
      velocity[2] += spin[0] * arm[1] - spin[1] * arm[0];
    }

    /** A force at the end is one at p1 and a moment. */
    void pull(ForceLoads loads, double fx, double fy, double fz) {
      loads.addForce(point, fx, fy, fz);
      loads.addTorque(
          point,
          arm[1] * fz - arm[2] * fy,
          arm[2] * fx - arm[0] * fz,
          arm[0] * fy - arm[1] * fx);
    }
  }
}
