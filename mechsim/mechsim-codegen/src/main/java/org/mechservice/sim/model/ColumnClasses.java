package org.mechservice.sim.model;

import static java.util.Map.entry;

import java.util.Map;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.mechservice.solver.api.ColumnGroup;

/**
 * The classes of the solver that compute one group of further columns each. All of them are named
 * where columns are made; those of groups that a model was not built with are never made, so they
 * need not travel with it.
 */
final class ColumnClasses {
  private static final String FOLDER = "org/mechservice/solver/analysis/";

  private static final Map<String, ColumnGroup> GROUPS =
      Map.ofEntries(
          entry(FOLDER + "ConstraintColumns.class", ColumnGroup.CONSTRAINTS),
          entry(FOLDER + "ReactionColumns.class", ColumnGroup.REACTIONS),
          entry(FOLDER + "ForceColumns.class", ColumnGroup.FORCES),
          entry(FOLDER + "OutputColumns.class", ColumnGroup.OUTPUTS),
          entry(FOLDER + "MomentumColumns.class", ColumnGroup.MOMENTUM));

  private ColumnClasses() {}

  /** Returns the paths of these classes. */
  static Set<String> paths() {
    return GROUPS.keySet();
  }

  /** Returns a solver's class file by its path, or null if the model does not need it. */
  static byte @Nullable [] needed(String path, CompiledModel model) {
    ColumnGroup group = GROUPS.get(path);
    boolean unneeded = group != null && !model.generated().dataColumns().contains(group);
    return unneeded ? null : SolverFiles.lean(path);
  }
}
