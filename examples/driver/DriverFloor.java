package examples.driver;

import org.mechservice.solver.api.ForceBlocks;
import org.mechservice.solver.api.ForceDeclaration;
import org.mechservice.solver.api.ForceLoads;
import org.mechservice.solver.api.ForceState;
import org.mechservice.solver.api.UserForce;

/** The feet stand on the floor: springs and dampers along the world's axes. */
public final class DriverFloor implements UserForce.Derivatives {
  /** N/m. */
  private static final double STIFFNESS = 20000;

  /** N·s/m. */
  private static final double DAMPING = 200;

  private static final String[] SIDES = {"L", "R"};

  /** Block of the derivative by a position and by a velocity: the same along each axis. */
  private static final double[] BY_POSITION = {-STIFFNESS, 0, 0, 0, -STIFFNESS, 0, 0, 0, -STIFFNESS};

  private static final double[] BY_VELOCITY = {-DAMPING, 0, 0, 0, -DAMPING, 0, 0, 0, -DAMPING};

  private final int[] foot = new int[SIDES.length];
  private final int[] place = new int[SIDES.length];
  private final double[] p = new double[3];
  private final double[] at = new double[3];
  private final double[] v = new double[3];

  @Override
  public void declare(ForceDeclaration model) {
    for (int i = 0; i < SIDES.length; i++) {
      String name = "floor " + SIDES[i];
      foot[i] =
          model.point(
              "foot" + SIDES[i],
              name,
              ForceDeclaration.Reads.POSITION,
              ForceDeclaration.Reads.VELOCITY);
      place[i] = model.point("Ground", name, ForceDeclaration.Reads.POSITION);
    }
  }

  @Override
  public void apply(ForceState state, ForceLoads loads) {
    for (int i = 0; i < SIDES.length; i++) {
      state.position(foot[i], p);
      state.position(place[i], at);
      state.velocity(foot[i], v);
      loads.addForce(
          foot[i],
          -STIFFNESS * (p[0] - at[0]) - DAMPING * v[0],
          -STIFFNESS * (p[1] - at[1]) - DAMPING * v[1],
          -STIFFNESS * (p[2] - at[2]) - DAMPING * v[2]);
    }
  }

  /** {@inheritDoc} The places on the ground do not move. */
  @Override
  public void differentiate(ForceState state, ForceBlocks blocks) {
    for (int footPoint : foot) {
      blocks.byPoint(
          ForceBlocks.Load.FORCE,
          footPoint,
          ForceDeclaration.Reads.POSITION,
          footPoint,
          BY_POSITION);
      blocks.byPoint(
          ForceBlocks.Load.FORCE,
          footPoint,
          ForceDeclaration.Reads.VELOCITY,
          footPoint,
          BY_VELOCITY);
    }
  }
}
