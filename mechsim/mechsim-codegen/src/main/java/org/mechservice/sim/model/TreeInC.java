package org.mechservice.sim.model;

import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.sim.emit.AnalysisTask;
import org.mechservice.sim.emit.ModelClass;
import org.mechservice.sim.emit.c.CModel;
import org.mechservice.sim.emit.c.COutputs;
import org.mechservice.sim.emit.c.CVariable;
import org.mechservice.sim.equations.EnergyEquations;
import org.mechservice.sim.equations.PoseEquations;
import org.mechservice.sim.equations.PowerEquations;
import org.mechservice.sim.equations.links.Links;
import org.mechservice.sim.scene.FormulationChoice;
import org.mechservice.sim.scene.GenerationLimits;
import org.mechservice.sim.scene.ModelBuildException;
import org.mechservice.sim.symbolic.Program;
import org.mechservice.solver.api.ModelDescription;
import org.mechservice.solver.api.result.ColumnGroup;
import org.mechservice.solver.api.result.Variable;
import org.mechservice.solver.catalogue.Formulation;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.catalogue.MethodNames;
import org.mechservice.solver.mechanism.Body;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.Output;

/** Derives an open chain's model in C, by the equations of its class. */
final class TreeInC {
  /** Components of a body's pose and velocity, in the order of the program, with their units. */
  private static final List<Variable> POSE =
      List.of(
          new Variable("x", "m"),
          new Variable("y", "m"),
          new Variable("z", "m"),
          new Variable("e0", "1"),
          new Variable("e1", "1"),
          new Variable("e2", "1"),
          new Variable("e3", "1"),
          new Variable("vx", "m/s"),
          new Variable("vy", "m/s"),
          new Variable("vz", "m/s"),
          new Variable("wx", "rad/s"),
          new Variable("wy", "rad/s"),
          new Variable("wz", "rad/s"));

  private final MechmlModel model;
  private final Mechanism mechanism;
  private final BuildOptions options;
  private final FormulationChoice choice;

  private TreeInC(MechmlModel model, BuildOptions options) {
    this.model = model;
    this.mechanism = model.watchedMechanism();
    this.options = options;
    String formulation =
        options.formulation().equals(Formulation.DSR.label())
            ? Formulation.DSR.label()
            : Formulation.DTR.label();
    this.choice = new FormulationChoice(formulation, MethodNames.NONE, "as C evaluates it");
  }

  /**
   * @throws ModelBuildException S-170 if the model has what C code is not generated for
   */
  static CModel derive(MechmlModel model, BuildOptions options) {
    TreeInC tree = new TreeInC(model, options);
    tree.requireExportable();
    return tree.derived();
  }

  private void requireExportable() {
    List<String> beyond = new ArrayList<>();
    if (AnalysisTask.of(model.settings().task()).isPresent()) {
      beyond.add(
          "the simulation <"
              + model.settings().task().element()
              + ">; choose one of kind <dynamic> by --simulation");
    }
    if (!mechanism.closures().isEmpty()) {
      beyond.add("closed loops (" + mechanism.closures().get(0).name() + " closes one)");
    }
    if (ModelClass.hasUserForces(mechanism)) {
      beyond.add("forces written as Java classes; give them as expressions");
    }
    if (!mechanism.events().isEmpty()) {
      beyond.add("events (" + mechanism.events().get(0).name() + " is one)");
    }
    if (!mechanism.samplings().isEmpty()) {
      beyond.add("sampled states (" + mechanism.samplings().get(0).name() + " is one)");
    }
    if (mechanism.mayJump()) {
      beyond.add("motions or forces that jump at given times");
    }
    Set<ColumnGroup> columns = EnumSet.copyOf(options.columns());
    columns.removeAll(
        EnumSet.of(
            ColumnGroup.JOINTS,
            ColumnGroup.BODIES,
            ColumnGroup.ENERGY,
            ColumnGroup.FORCES,
            ColumnGroup.OUTPUTS));
    columns.forEach(group -> beyond.add("the columns \"" + group.label() + "\""));
    if (beyond.isEmpty()) {
      beyond.addAll(GenerationLimits.notGenerated(mechanism, choice));
    }
    refuse(beyond);
  }

  private void refuse(List<String> beyond) {
    if (!beyond.isEmpty()) {
      throw new ModelBuildException(
          MessageCode.NO_C_CODE,
          "model \""
              + mechanism.name()
              + "\" cannot be exported as C: no C code is generated for "
              + String.join("; ", beyond)
              + ". Build a JAR of it (mech build -o FILE.jar), or leave this out");
    }
  }

  private CModel derived() {
    Links links = Links.of(mechanism);
    Program derivative = TreeClass.derivative(links, choice);
    refuse(GenerationLimits.noFaster(choice.formulation(), derivative.operationCount()));
    Program energy = EnergyEquations.derive(links);
    ModelDescription description =
        new ModelDescription(
            mechanism.name(),
            choice.formulation(),
            ModelClass.joints(mechanism),
            mechanism.stateVariables(),
            options.settings());
    return new CModel(mechanism, description, derivative, energy, outputs(links, energy));
  }

  private List<COutputs> outputs(Links links, Program energy) {
    List<COutputs> groups = new ArrayList<>();
    if (options.columns().contains(ColumnGroup.BODIES)) {
      List<CVariable> poses = new ArrayList<>();
      for (Body body : mechanism.bodies()) {
        POSE.forEach(part -> poses.add(output(body.name() + "." + part.name(), part.unit())));
      }
      groups.add(new COutputs("poses", poses, PoseEquations.derive(links), true));
    }
    if (options.columns().contains(ColumnGroup.ENERGY)) {
      List<CVariable> energies =
          List.of(output("energy.kinetic", "J"), output("energy.potential", "J"));
      groups.add(new COutputs(COutputs.ENERGIES, energies, energy, false));
    }
    List<Variable> forces = ForceColumnNames.of(mechanism);
    if (options.columns().contains(ColumnGroup.FORCES) && !forces.isEmpty()) {
      List<CVariable> values =
          forces.stream().map(force -> output(force.name(), force.unit())).toList();
      groups.add(new COutputs("force_values", values, PowerEquations.values(links), false));
    }
    if (options.columns().contains(ColumnGroup.OUTPUTS) && !model.outputs().isEmpty()) {
      List<CVariable> values =
          model.outputs().stream().map(one -> output(one.name(), one.unit())).toList();
      Program program =
          PowerEquations.formulas(links, model.outputs().stream().map(Output::value).toList());
      groups.add(new COutputs("user_outputs", values, program, false));
    }
    return groups;
  }

  private static CVariable output(String name, String unit) {
    return new CVariable(name, unit, "output", 0);
  }
}
