import org.mechservice.solver.api.ForceDeclaration;
import org.mechservice.solver.api.ForceLoads;
import org.mechservice.solver.api.ForceState;
import org.mechservice.solver.api.UserForce;

/** Pushes the block along x, harder every second. */
public final class Thrust implements UserForce {
  /** N/s. */
  private static final double RISE = 1;

  private int block;

  @Override
  public void declare(ForceDeclaration model) {
    block = model.point("block", "o");
  }

  @Override
  public void apply(ForceState state, ForceLoads loads) {
    loads.addForce(block, RISE * state.time(), 0, 0);
  }
}
