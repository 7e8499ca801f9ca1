package org.mechservice.sim.model;

import java.util.EnumSet;
import java.util.Set;
import java.util.stream.Collectors;
import org.mechservice.mechml.SimulationSettings;
import org.mechservice.mechml.SimulationTask;
import org.mechservice.solver.api.ColumnGroup;

/** Which column groups a model that was built has, and which it shows. */
public final class BuiltColumns {
  private BuiltColumns() {}

  /** Returns the groups the model can put out: some always, the others if it was built for them. */
  static Set<ColumnGroup> of(CompiledModel model) {
    Set<ColumnGroup> built =
        EnumSet.of(ColumnGroup.JOINTS, ColumnGroup.ACCELERATIONS, ColumnGroup.ENERGY);
    built.addAll(model.options().columns());
    return built;
  }

  /** Returns those of them that its file selects. */
  static Set<ColumnGroup> shown(CompiledModel model) {
    Set<ColumnGroup> shown = shown(model.source().settings());
    shown.retainAll(of(model));
    return shown;
  }

  /**
   * Returns the groups that a simulation puts out where nothing else is asked for: those its file
   * selects; else the joints, and what inverse dynamics is about.
   */
  public static Set<ColumnGroup> shown(SimulationSettings settings) {
    Set<ColumnGroup> shown = EnumSet.of(ColumnGroup.JOINTS);
    settings.columns().stream().map(ColumnGroup::of).forEach(shown::addAll);
    if (settings.columns().isEmpty() && settings.task() instanceof SimulationTask.InverseDynamic) {
      shown.add(ColumnGroup.ACCELERATIONS);
      shown.add(ColumnGroup.FORCES);
    }
    return shown;
  }

  /** Returns the labels of groups, separated by commas. */
  static String labels(Set<ColumnGroup> groups) {
    return groups.stream().sorted().map(ColumnGroup::label).collect(Collectors.joining(","));
  }
}
