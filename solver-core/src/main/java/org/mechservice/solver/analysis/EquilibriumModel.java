package org.mechservice.solver.analysis;

import java.util.List;
import org.mechservice.solver.api.ColumnGroup;
import org.mechservice.solver.api.Model;
import org.mechservice.solver.compact.CompactModel;
import org.mechservice.solver.compact.LoadedUserForces;
import org.mechservice.solver.force.UserForceSource;

/** A mechanism at rest: one state, in which all forces balance. */
public final class EquilibriumModel extends FoundModel {
  private final StaticEquilibrium equilibrium;

  /**
   * @param data the model
   * @param tolerance largest force left over relative to the largest in play
   * @param most corrections allowed
   * @param userForces makes the forces that users have written
   */
  EquilibriumModel(CompactModel data, double tolerance, int most, UserForceSource userForces) {
    super(data, HeldMotions.at(data.mechanism(), data.settings().tStart()), userForces);
    equilibrium = new StaticEquilibrium(mechanism, userForces, tolerance, most);
  }

  /**
   * Makes the model of a class.
   *
   * @param loader finds the classes of user forces
   * @param options tolerance and most corrections, separated by a blank
   * @param groups column groups that are computed apart from it, separated by commas
   * @param texts of the {@link CompactModel}
   */
  public static Model model(ClassLoader loader, String options, String groups, String... texts) {
    CompactModel data = CompactModel.of(List.of(texts));
    UserForceSource userForces = new LoadedUserForces(loader);
    String[] numbers = options.split(" ", -1);
    EquilibriumModel model =
        new EquilibriumModel(
            data, Double.parseDouble(numbers[0]), Integer.parseInt(numbers[1]), userForces);
    return FurtherColumns.extend(model, data, model.mechanism, ColumnGroup.of(groups), userForces);
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
