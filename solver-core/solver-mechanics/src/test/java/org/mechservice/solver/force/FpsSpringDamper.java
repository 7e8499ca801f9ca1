package org.mechservice.solver.force;

import org.mechservice.solver.api.ForceBlocks;
import org.mechservice.solver.api.ForceBlocks.Load;
import org.mechservice.solver.api.ForceDeclaration;
import org.mechservice.solver.api.ForceDeclaration.Reads;
import org.mechservice.solver.api.ForceLoads;
import org.mechservice.solver.api.ForceState;
import org.mechservice.solver.api.UserForce;

/**
 * The strut of the five-point suspension, from the frame to the carrier: tension T = F0 + k (L −
 * L0) + c L′ along its line. An example of a force that gives its derivatives.
 */
public final class FpsSpringDamper implements UserForce.Derivatives {
  private static final double STIFFNESS = 30000;
  private static final double DAMPING = 1500;
  private static final double LENGTH = 0.5099019513592785;
  private static final double PRELOAD = -3971.6;

  private int frame;
  private int carrier;
  private final double[] d = new double[3];
  private final double[] u = new double[3];
  private final double[] other = new double[3];
  private final double[] byPosition = new double[9];
  private final double[] byVelocity = new double[9];
  private double length;
  private double rate;
  private double tension;

  @Override
  public void declare(ForceDeclaration model) {
    frame = model.pointAt("Frame", 0.064, 0.137, 0.123, Reads.POSITION, Reads.VELOCITY);
    carrier = model.pointAt("Carrier", 0.103, 0.187, -0.137, Reads.POSITION, Reads.VELOCITY);
    model.value("tension", "N");
  }

  @Override
  public void apply(ForceState state, ForceLoads loads) {
    evaluate(state);
    double pull = tension / length;
    loads.addForce(frame, pull * d[0], pull * d[1], pull * d[2]);
    loads.addForce(carrier, -pull * d[0], -pull * d[1], -pull * d[2]);
    loads.setValue(0, tension);
  }

  private void evaluate(ForceState state) {
    state.position(carrier, d);
    state.position(frame, other);
    subtract(d);
    state.velocity(carrier, u);
    state.velocity(frame, other);
    subtract(u);
    length = Math.sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
    rate = (d[0] * u[0] + d[1] * u[1] + d[2] * u[2]) / length;
    tension = PRELOAD + STIFFNESS * (length - LENGTH) + DAMPING * rate;
  }

  private void subtract(double[] from) {
    for (int i = 0; i < 3; i++) {
      from[i] -= other[i];
    }
  }

  @Override
  public void differentiate(ForceState state, ForceBlocks blocks) {
    evaluate(state);
    for (int i = 0; i < 3; i++) {
      for (int j = 0; j < 3; j++) {
        double along = d[i] * d[j] / (length * length);
        double across = (i == j ? 1 : 0) - along;
        double turning = (u[j] - rate * d[j] / length) / length;
        byPosition[3 * i + j] =
            STIFFNESS * along + tension / length * across + DAMPING * d[i] / length * turning;
        byVelocity[3 * i + j] = DAMPING * along;
      }
    }
    give(blocks, frame, carrier, 1);
    give(blocks, frame, frame, -1);
    give(blocks, carrier, carrier, -1);
    give(blocks, carrier, frame, 1);
  }

  private void give(ForceBlocks blocks, int on, int by, int sign) {
    double[] position = byPosition.clone();
    double[] velocity = byVelocity.clone();
    for (int i = 0; i < 9; i++) {
      position[i] *= sign;
      velocity[i] *= sign;
    }
    blocks.byPoint(Load.FORCE, on, Reads.POSITION, by, position);
    blocks.byPoint(Load.FORCE, on, Reads.VELOCITY, by, velocity);
  }
}
