package org.mechservice.sim.model;

import java.util.EnumSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.mechml.SimulationSettings;
import org.mechservice.mechml.SimulationTask;
import org.mechservice.sim.scene.FormulationChoice;
import org.mechservice.solver.api.result.ColumnGroup;
import org.mechservice.solver.closure.assembly.ClosedStart;
import org.mechservice.solver.closure.equations.LoopEquations;
import org.mechservice.solver.compact.CompactModel;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.closure.CoordinateClosure;
import org.mechservice.solver.mechanism.closure.JointClosure;
import org.mechservice.solver.mechanism.closure.RollingClosure;

/**
 * Column groups of a model: those that it can output, those that its results show, and those
 * computed from data in addition to the code.
 */
public final class ModelColumns {
  private ModelColumns() {}

  /**
   * Returns the groups that the model can output: some always, the others if it was built with
   * them.
   */
  public static Set<ColumnGroup> of(CompiledModel model) {
    Set<ColumnGroup> built =
        EnumSet.of(ColumnGroup.JOINTS, ColumnGroup.ACCELERATIONS, ColumnGroup.ENERGY);
    built.addAll(model.options().columns());
    return built;
  }

  /** Returns the groups that the model file selects among them. */
  public static Set<ColumnGroup> shown(CompiledModel model) {
    Set<ColumnGroup> shown = shown(model.source().settings());
    shown.retainAll(of(model));
    return shown;
  }

  /**
   * Returns the default groups of a simulation: those that its file selects; otherwise the joints,
   * and for inverse dynamics the forces. A linearisation takes the outputs of its system from them.
   */
  public static Set<ColumnGroup> shown(SimulationSettings settings) {
    Set<ColumnGroup> shown = EnumSet.of(ColumnGroup.JOINTS);
    settings.columns().stream().map(ColumnGroup::of).forEach(shown::addAll);
    if (settings.columns().isEmpty() && settings.task() instanceof SimulationTask.InverseDynamic) {
      shown.add(ColumnGroup.ACCELERATIONS);
      shown.add(ColumnGroup.FORCES);
    }
    if (settings.task() instanceof SimulationTask.Linearization) {
      shown.add(ColumnGroup.OUTPUTS);
    }
    return shown;
  }

  /** Returns the labels of groups, separated by commas. */
  public static String labels(Set<ColumnGroup> groups) {
    return groups.stream().sorted().map(ColumnGroup::label).collect(Collectors.joining(","));
  }

  /**
   * Returns the requested groups that are computed from data: those that the code does not compute
   * and that have columns in this scene.
   *
   * @param hasForces whether the code computes the values of forces
   */
  static Set<ColumnGroup> fromData(MechmlModel model, BuildOptions options, boolean hasForces) {
    Set<ColumnGroup> groups = EnumSet.noneOf(ColumnGroup.class);
    for (ColumnGroup group : ColumnGroup.values()) {
      boolean some =
          switch (group) {
            case CONSTRAINTS -> !model.mechanism().closures().isEmpty();
            case REACTIONS -> !model.mechanism().joints().isEmpty();
            case FORCES -> !hasForces;
            case OUTPUTS -> !model.outputs().isEmpty();
            case MOMENTUM -> model.settings().task() instanceof SimulationTask.Dynamic;
            case DRIVES -> isDriven(model.mechanism());
            case JOINTS, ACCELERATIONS, BODIES, ENERGY -> false;
          };
      boolean watched =
          group == ColumnGroup.CONSTRAINTS
              && model.settings().task() instanceof SimulationTask.Dynamic
              && hasOneSided(model.mechanism());
      if (some && (watched || options.columns().contains(group))) {
        groups.add(group);
      }
    }
    return groups;
  }

  /** Returns whether ropes or wheels push or pull only, so that their multipliers are watched. */
  private static boolean hasOneSided(Mechanism mechanism) {
    return mechanism.closures().stream()
        .anyMatch(
            closure ->
                closure instanceof RollingClosure
                    || (closure instanceof CoordinateClosure rope && !rope.points().isEmpty()));
  }

  private static boolean isDriven(Mechanism mechanism) {
    return !mechanism.motions().isEmpty()
        || mechanism.closures().stream()
            .anyMatch(closure -> closure instanceof JointClosure cut && cut.isDriven());
  }

  /** Returns whether a trim problem, whose conditions may be of outputs, is to be solved. */
  private static boolean isTrimmed(MechmlModel model) {
    SimulationTask task = model.settings().task();
    return (task instanceof SimulationTask.StaticEquilibrium rest && rest.trim().isPresent())
        || (task instanceof SimulationTask.Linearization linear && linear.trim().isPresent());
  }

  /** Returns the mechanism as data, with the outputs if they are requested or conditions. */
  static CompactModel data(
      MechmlModel model, BuildOptions options, FormulationChoice choice, Set<ColumnGroup> groups) {
    return new CompactModel(
        model.watchedMechanism(),
        choice.formulation(),
        choice.closure(),
        options.settings(),
        groups.contains(ColumnGroup.OUTPUTS) || isTrimmed(model) ? model.outputs() : List.of(),
        start(model, options));
  }

  /**
   * Returns the closed start of a mechanism that takes long to close; a small one is closed anew.
   */
  private static Optional<Record> start(MechmlModel model, BuildOptions options) {
    Mechanism mechanism = model.mechanism();
    boolean large =
        !mechanism.closures().isEmpty() && mechanism.velocityCount() > LoopEquations.LARGE;
    return large
        ? Optional.of(model.closedStart(options.settings().tStart()))
            .filter(ClosedStart::isAssembled)
            .map(ClosedStart::found)
        : Optional.empty();
  }
}
