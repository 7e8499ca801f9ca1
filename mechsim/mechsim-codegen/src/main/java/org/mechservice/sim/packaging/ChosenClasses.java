package org.mechservice.sim.packaging;

import static java.util.Map.entry;

import java.util.Arrays;
import java.util.HashSet;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import org.jspecify.annotations.Nullable;
import org.mechservice.guard.SolverClasses;
import org.mechservice.sim.model.CompiledModel;
import org.mechservice.solver.api.result.ColumnGroup;
import org.mechservice.solver.closure.equations.LoopEquations;
import org.mechservice.solver.links.Link;
import org.mechservice.solver.links.Links;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.step.StepKind;
import org.mechservice.solver.step.printed.PrintedSteps;

/**
 * The solver classes from which another one chooses: those that each compute one additional group
 * of columns, and the printed steps of each kind of joint. A standalone JAR omits those that its
 * model never chooses, because no instance of them is ever created.
 */
final class ChosenClasses {
  private static final String FOLDER = "org/mechservice/solver/analysis/column/";

  private static final Map<String, ColumnGroup> GROUPS =
      Map.ofEntries(
          entry(FOLDER + "ConstraintColumns.class", ColumnGroup.CONSTRAINTS),
          entry(FOLDER + "ReactionColumns.class", ColumnGroup.REACTIONS),
          entry(FOLDER + "ForceColumns.class", ColumnGroup.FORCES),
          entry(FOLDER + "OutputColumns.class", ColumnGroup.OUTPUTS),
          entry(FOLDER + "MomentumColumns.class", ColumnGroup.MOMENTUM),
          entry(FOLDER + "DriveColumns.class", ColumnGroup.DRIVES));

  private static final Set<String> STEPS = stepsOf(Arrays.asList(StepKind.values()));

  private final Set<String> unneeded;

  private ChosenClasses(Set<String> unneeded) {
    this.unneeded = unneeded;
  }

  /** Returns the choice of a model. */
  static ChosenClasses of(CompiledModel model) {
    Set<String> unneeded = new HashSet<>();
    GROUPS.forEach(
        (path, group) -> {
          if (!model.generated().dataColumns().contains(group)) {
            unneeded.add(path);
          }
        });
    // a parameter may give an armature or other axes to a joint
    if (model.classes().describing().parameters().isEmpty()) {
      unneeded.addAll(STEPS);
      unneeded.removeAll(stepsOf(kinds(model.source().mechanism())));
    }
    return new ChosenClasses(unneeded);
  }

  private static Set<StepKind> kinds(Mechanism mechanism) {
    Set<StepKind> kinds = new HashSet<>();
    // large loops add inertia to joints that move none
    boolean arms =
        !mechanism.closures().isEmpty() && mechanism.velocityCount() > LoopEquations.LARGE;
    for (Link link : Links.of(mechanism).links()) {
      kinds.add(StepKind.of(link));
      if (arms) {
        kinds.add(StepKind.of(link, true));
      }
      link.axes().turn().ifPresent(turn -> kinds.add(StepKind.ofTurn(turn.axis())));
    }
    return kinds;
  }

  private static Set<String> stepsOf(Iterable<StepKind> kinds) {
    Set<String> paths = new TreeSet<>();
    for (StepKind kind : kinds) {
      paths.add(PrintedSteps.of(kind).getClass().getName().replace('.', '/') + ".class");
    }
    return paths;
  }

  /** Returns the paths of all such classes. */
  static Set<String> paths() {
    Set<String> all = new TreeSet<>(STEPS);
    all.addAll(GROUPS.keySet());
    return all;
  }

  /** Returns the paths of the classes of columns. */
  static Set<String> ofColumns() {
    return GROUPS.keySet();
  }

  /** Returns a solver's class file by its path, or null if the model does not need it. */
  byte @Nullable [] needed(String path) {
    return unneeded.contains(path) ? null : SolverClasses.file(path);
  }
}
