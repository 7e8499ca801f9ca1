package org.mechservice.sim.model;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.solver.api.ColumnGroup;

/** Says what a generated model computes from data beside its code, and why. */
final class FromData {
  private static final String ONCE_A_ROW =
      "one sweep over the mechanism gives them once for each row of results";

  private FromData() {}

  /**
   * Lists it.
   *
   * @param further groups of columns computed beside the model
   * @param values why events and outputs are not code, if there are some and they are not
   * @param derivatives why those of the residual are not code, if they are wanted and are not
   */
  static List<Omission> of(
      MechmlModel model,
      Set<ColumnGroup> further,
      Optional<String> values,
      Optional<String> derivatives) {
    List<Omission> all = new ArrayList<>();
    derivatives.ifPresent(why -> all.add(new Omission("derivatives of the residual", why)));
    if (!model.watchedMechanism().events().isEmpty()) {
      values.ifPresent(why -> all.add(new Omission("events", why)));
    }
    for (ColumnGroup group : further) {
      Optional<String> why = group == ColumnGroup.OUTPUTS ? values : Optional.of(ONCE_A_ROW);
      why.ifPresent(reason -> all.add(new Omission(group.label(), reason)));
    }
    return all;
  }
}
