package org.mechservice.solver.analysis;

import java.util.List;
import org.mechservice.solver.compact.CompactModel;
import org.mechservice.solver.force.user.UserForceSource;

/** A mechanism at rest: one state, in which all forces balance. */
final class EquilibriumModel extends AnalysisModel {
  private final StaticEquilibrium equilibrium;

  /**
   * @param data the model with its motions held constant
   * @param tolerance largest residual force relative to the largest force
   * @param most largest number of corrections
   * @param userForces creates the user forces
   */
  EquilibriumModel(CompactModel data, double tolerance, int most, UserForceSource userForces) {
    super(data, userForces);
    equilibrium = new StaticEquilibrium(mechanism, userForces, tolerance, most);
  }

  @Override
  public int find(double t, double[] y) {
    if (!equilibrium.find(t)) {
      return fail(equilibrium.defect());
    }
    System.arraycopy(equilibrium.state(), 0, y, 0, y.length);
    return REGULAR;
  }

  @Override
  public long iterations() {
    return equilibrium.iterations();
  }

  @Override
  public List<Note> notes() {
    return equilibrium.notes();
  }
}
