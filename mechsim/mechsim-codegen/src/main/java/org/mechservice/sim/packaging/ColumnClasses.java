package org.mechservice.sim.packaging;

import static java.util.Map.entry;

import java.util.Map;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.mechservice.guard.SolverClasses;
import org.mechservice.sim.model.CompiledModel;
import org.mechservice.solver.api.result.ColumnGroup;

/**
 * The solver classes that each compute one additional group of columns. One class refers to all of
 * them. A standalone JAR omits the classes of groups that its model was not built with, because no
 * instance of them is ever created.
 */
final class ColumnClasses {
  private static final String FOLDER = "org/mechservice/solver/analysis/column/";

  private static final Map<String, ColumnGroup> GROUPS =
      Map.ofEntries(
          entry(FOLDER + "ConstraintColumns.class", ColumnGroup.CONSTRAINTS),
          entry(FOLDER + "ReactionColumns.class", ColumnGroup.REACTIONS),
          entry(FOLDER + "ForceColumns.class", ColumnGroup.FORCES),
          entry(FOLDER + "OutputColumns.class", ColumnGroup.OUTPUTS),
          entry(FOLDER + "MomentumColumns.class", ColumnGroup.MOMENTUM),
          entry(FOLDER + "DriveColumns.class", ColumnGroup.DRIVES));

  private ColumnClasses() {}

  /** Returns the paths of these classes. */
  static Set<String> paths() {
    return GROUPS.keySet();
  }

  /** Returns a solver's class file by its path, or null if the model does not need it. */
  static byte @Nullable [] needed(String path, CompiledModel model) {
    ColumnGroup group = GROUPS.get(path);
    boolean unneeded = group != null && !model.generated().dataColumns().contains(group);
    return unneeded ? null : SolverClasses.file(path);
  }
}
