package org.mechservice.sim.build;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.solver.api.ColumnGroup;
import org.mechservice.solver.mechanism.Mechanism;

/** Says what a generated model computes from data beside its code, and why. */
final class FromData {
  private static final String ONCE_A_ROW =
      "one sweep over the mechanism gives them once for each row of results";

  private static final String TURNS =
      "an angle of a cut joint is among what they depend on, whose whole turns the data count";

  private FromData() {}

  /**
   * Lists it.
   *
   * @param further groups of columns computed beside the model
   * @param derivatives why those of the residual are not code, if they are wanted and are not
   */
  static List<Omission> of(
      MechmlModel model,
      BuildOptions options,
      Set<ColumnGroup> further,
      Optional<String> derivatives) {
    List<Omission> all = new ArrayList<>();
    derivatives.ifPresent(why -> all.add(new Omission("derivatives of the residual", why)));
    Mechanism watched = model.watchedMechanism();
    boolean written = !ValuesClass.areFromData(model, options);
    if (!watched.events().isEmpty() && !written) {
      all.add(new Omission("events", TURNS));
    }
    for (ColumnGroup group : further) {
      if (group != ColumnGroup.OUTPUTS) {
        all.add(new Omission(group.label(), ONCE_A_ROW));
      } else if (!written) {
        all.add(new Omission(group.label(), TURNS));
      }
    }
    return all;
  }
}
