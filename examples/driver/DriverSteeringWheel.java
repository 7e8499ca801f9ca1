package examples.driver;

import org.mechservice.solver.api.ForceBlocks;
import org.mechservice.solver.api.ForceDeclaration;
import org.mechservice.solver.api.ForceLoads;
import org.mechservice.solver.api.ForceState;
import org.mechservice.solver.api.UserForce;

/** The hands hold the steering wheel: springs and dampers along the world's axes. */
public final class DriverSteeringWheel implements UserForce.Derivatives {
  /** N/m. */
  private static final double STIFFNESS = 8000;

  /** N·s/m. */
  private static final double DAMPING = 80;

  private static final String[] SIDES = {"L", "R"};

  /** Block of the derivative by a position and by a velocity: the same along each axis. */
  private static final double[] BY_POSITION = {-STIFFNESS, 0, 0, 0, -STIFFNESS, 0, 0, 0, -STIFFNESS};

  private static final double[] BY_VELOCITY = {-DAMPING, 0, 0, 0, -DAMPING, 0, 0, 0, -DAMPING};

  private final int[] hand = new int[SIDES.length];
  private final int[] place = new int[SIDES.length];
  private final double[] p = new double[3];
  private final double[] at = new double[3];
  private final double[] v = new double[3];

  @Override
  public void declare(ForceDeclaration model) {
    for (int i = 0; i < SIDES.length; i++) {
      String name = "steering wheel " + SIDES[i];
      hand[i] =
          model.point(
              "hand" + SIDES[i],
              name,
              ForceDeclaration.Reads.POSITION,
              ForceDeclaration.Reads.VELOCITY);
      place[i] = model.point("Ground", name, ForceDeclaration.Reads.POSITION);
    }
  }

  @Override
  public void apply(ForceState state, ForceLoads loads) {
    for (int i = 0; i < SIDES.length; i++) {
      state.position(hand[i], p);
      state.position(place[i], at);
      state.velocity(hand[i], v);
      loads.addForce(
          hand[i],
          -STIFFNESS * (p[0] - at[0]) - DAMPING * v[0],
          -STIFFNESS * (p[1] - at[1]) - DAMPING * v[1],
          -STIFFNESS * (p[2] - at[2]) - DAMPING * v[2]);
    }
  }

  /** {@inheritDoc} The places on the ground do not move. */
  @Override
  public void differentiate(ForceState state, ForceBlocks blocks) {
    for (int handPoint : hand) {
      blocks.byPoint(
          ForceBlocks.Load.FORCE,
          handPoint,
          ForceDeclaration.Reads.POSITION,
          handPoint,
          BY_POSITION);
      blocks.byPoint(
          ForceBlocks.Load.FORCE,
          handPoint,
          ForceDeclaration.Reads.VELOCITY,
          handPoint,
          BY_VELOCITY);
    }
  }
}
