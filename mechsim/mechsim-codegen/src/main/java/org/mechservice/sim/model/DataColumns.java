package org.mechservice.sim.model;

import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.mechml.SimulationTask;
import org.mechservice.sim.scene.FormulationChoice;
import org.mechservice.solver.api.ColumnGroup;
import org.mechservice.solver.compact.CompactModel;

/** Columns that are computed from the mechanism as data, whatever the model itself is. */
final class DataColumns {
  private DataColumns() {}

  /**
   * Returns the groups asked for that the model has not of itself, and that are not empty.
   *
   * @param hasForces whether it puts out the values of forces itself
   */
  static Set<ColumnGroup> of(MechmlModel model, BuildOptions options, boolean hasForces) {
    Set<ColumnGroup> groups = EnumSet.noneOf(ColumnGroup.class);
    for (ColumnGroup group : ColumnGroup.values()) {
      boolean some =
          switch (group) {
            case CONSTRAINTS -> !model.mechanism().closures().isEmpty();
            case REACTIONS -> !model.mechanism().joints().isEmpty();
            case FORCES -> !hasForces;
            case OUTPUTS -> !model.outputs().isEmpty();
            case MOMENTUM -> model.settings().task() instanceof SimulationTask.Dynamic;
            case JOINTS, ACCELERATIONS, BODIES, ENERGY -> false;
          };
      if (some && options.columns().contains(group)) {
        groups.add(group);
      }
    }
    return groups;
  }

  /** Returns the mechanism as data, with the outputs if they are asked for. */
  static CompactModel data(
      MechmlModel model, BuildOptions options, FormulationChoice choice, Set<ColumnGroup> groups) {
    return new CompactModel(
        model.watchedMechanism(),
        choice.formulation(),
        choice.closure(),
        options.settings(),
        groups.contains(ColumnGroup.OUTPUTS) ? model.outputs() : List.of());
  }
}
