package org.mechservice.sim.model;

import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.SortedSet;
import java.util.TreeSet;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.sim.emit.AnalysisTask;
import org.mechservice.sim.emit.ModelClass;
import org.mechservice.sim.emit.c.CEvents;
import org.mechservice.sim.emit.c.CInputs;
import org.mechservice.sim.emit.c.CLoops;
import org.mechservice.sim.emit.c.CModel;
import org.mechservice.sim.emit.c.CMotion;
import org.mechservice.sim.emit.c.COutputs;
import org.mechservice.sim.emit.c.CVariable;
import org.mechservice.sim.emit.c.CWatch;
import org.mechservice.sim.equations.EnergyEquations;
import org.mechservice.sim.equations.PoseEquations;
import org.mechservice.sim.equations.PowerEquations;
import org.mechservice.sim.equations.loop.LoopCode;
import org.mechservice.sim.scene.FormulationChoice;
import org.mechservice.sim.scene.GenerationLimits;
import org.mechservice.sim.scene.ModelBuildException;
import org.mechservice.solver.api.ModelDescription;
import org.mechservice.solver.api.capability.ModelEvents;
import org.mechservice.solver.api.result.ColumnGroup;
import org.mechservice.solver.api.result.Variable;
import org.mechservice.solver.catalogue.Formulation;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.catalogue.MethodNames;
import org.mechservice.solver.closure.PenaltySettings;
import org.mechservice.solver.closure.assembly.ClosedStart;
import org.mechservice.solver.closure.equations.CoordinateUnits;
import org.mechservice.solver.closure.equations.LoopEquations;
import org.mechservice.solver.closure.equations.LoopRounding;
import org.mechservice.solver.closure.equations.UnwrappedAngles;
import org.mechservice.solver.dynamics.event.StateEvents;
import org.mechservice.solver.dynamics.event.WatchedTape;
import org.mechservice.solver.expression.ClosureCoordinate;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.expression.Tape;
import org.mechservice.solver.kinematics.StateCoordinates;
import org.mechservice.solver.kinematics.TreeGeometry;
import org.mechservice.solver.kinematics.TreeMotion;
import org.mechservice.solver.linear.SparseMatrix;
import org.mechservice.solver.links.Links;
import org.mechservice.solver.mechanism.Body;
import org.mechservice.solver.mechanism.Event;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.Output;
import org.mechservice.solver.mechanism.Overlap;
import org.mechservice.solver.mechanism.Parameter;
import org.mechservice.solver.mechanism.force.UserForceElement;
import org.mechservice.solver.symbol.Program;
import org.mechservice.solver.text.ShortestDecimal;

/**
 * Derives a mechanism's model in C: an open chain by the equations of its class, closed loops by
 * the terms of its class, which {@code mech_loops.c} solves by the penalty closure.
 */
final class MechanismInC {
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

  /** Components of a load on a body, in the order of the programs. */
  private static final List<Variable> WRENCH =
      List.of(
          new Variable("tx", "N*m"),
          new Variable("ty", "N*m"),
          new Variable("tz", "N*m"),
          new Variable("fx", "N"),
          new Variable("fy", "N"),
          new Variable("fz", "N"));

  private final MechmlModel model;
  private final Mechanism mechanism;
  private final BuildOptions options;
  private final FormulationChoice choice;
  private final SortedSet<String> asInputs;

  private MechanismInC(MechmlModel model, BuildOptions options, Set<String> asInputs) {
    this.model = model;
    this.asInputs = new TreeSet<>(asInputs);
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
  static CModel derive(MechmlModel model, BuildOptions options, Set<String> asInputs) {
    MechanismInC inC = new MechanismInC(model, options, asInputs);
    inC.requireExportable();
    return inC.derived();
  }

  private void requireExportable() {
    List<String> beyond = new ArrayList<>();
    if (AnalysisTask.of(model.settings().task()).isPresent()) {
      beyond.add(
          "the simulation <"
              + model.settings().task().element()
              + ">; choose one of kind <dynamic> by --simulation");
    }
    List<String> classes =
        mechanism.forces().stream()
            .flatMap(f -> f instanceof UserForceElement user ? Stream.of(user.name()) : Stream.of())
            .toList();
    requireClasses(classes);
    List<String> left = classes.stream().filter(name -> !asInputs.contains(name)).toList();
    if (!left.isEmpty()) {
      beyond.add(
          "forces written as Java classes ("
              + String.join(", ", left)
              + "); give them as expressions, or make them inputs of an FMU by --class-as-input "
              + String.join(" --class-as-input ", left));
    }
    beyond.addAll(JumpsInC.notExported(mechanism, options.settings()));
    beyond.addAll(turnsOfCutJoints());
    if (!mechanism.closures().isEmpty()
        && !mechanism.motions().isEmpty()
        && options.columns().contains(ColumnGroup.FORCES)) {
      beyond.add("the columns \"forces\" with driven joints in loops");
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
      beyond.addAll(
          GenerationLimits.isRecursive(mechanism)
              ? GenerationLimits.largeWithMassMatrix(mechanism)
              : GenerationLimits.notGenerated(mechanism, choice, () -> 0));
    }
    refuse(beyond);
  }

  private void requireClasses(List<String> classes) {
    for (String name : asInputs) {
      if (!classes.contains(name)) {
        throw new ModelBuildException(
            MessageCode.NO_C_CODE,
            "--class-as-input "
                + name
                + ": model \""
                + mechanism.name()
                + "\" has no force of this name that is written as a class"
                + (classes.isEmpty() ? "" : "; it has " + String.join(", ", classes)));
      }
    }
  }

  /**
   * Returns the inputs of the file, and the loads of the forces written as classes: for each body
   * moment and force in its axes at its link's reference point, for each velocity of a joint a
   * force.
   */
  private CInputs inputs(List<Variable> states) {
    List<CVariable> variables = new ArrayList<>();
    List<Integer> places = new ArrayList<>();
    List<Parameter> parameters = mechanism.parameters();
    int count = model.inputCount();
    for (Parameter input : parameters.subList(parameters.size() - count, parameters.size())) {
      places.add(places.size());
      variables.add(new CVariable(input.name(), input.unit(), "input", input.value()));
    }
    if (asInputs.isEmpty()) {
      return new CInputs(variables, places, count, 0);
    }
    String force = String.join("+", asInputs);
    TreeGeometry tree = new TreeGeometry(mechanism);
    for (int body = 0; body < mechanism.bodies().size(); body++) {
      int link = tree.linkOfBody[body];
      String name = mechanism.bodies().get(body).name();
      String place =
          "%s on body %s in its axes, at its point (%s, %s, %s) m"
              .formatted(
                  force,
                  name,
                  number(-tree.bodyOrigin[3 * link]),
                  number(-tree.bodyOrigin[3 * link + 1]),
                  number(-tree.bodyOrigin[3 * link + 2]));
      for (int k = 0; k < WRENCH.size(); k++) {
        Variable part = WRENCH.get(k);
        variables.add(new CVariable(force + "." + name + "." + part.name(), part.unit(), place, 0));
        places.add(count + 6 * link + k);
      }
    }
    for (int k = 0; k < mechanism.velocityCount(); k++) {
      Variable velocity = states.get(mechanism.positionCount() + k);
      boolean turns = velocity.unit().equals("rad/s");
      variables.add(
          new CVariable(
              force + "." + velocity.name() + ".force",
              turns ? "N*m" : "N",
              force + " along " + velocity.name(),
              0));
      places.add(count + 6 * tree.linkCount + k);
    }
    return new CInputs(variables, places, count, 6 * tree.linkCount + tree.velocityCount);
  }

  private static String number(double value) {
    return ShortestDecimal.format(value + 0.0);
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

  /** Returns what depends on angles of cut joints whose whole turns only the data count. */
  private List<String> turnsOfCutJoints() {
    List<Expression> values = new ArrayList<>(StateEvents.assigned(mechanism));
    mechanism.events().forEach(event -> values.add(event.trigger()));
    if (options.columns().contains(ColumnGroup.OUTPUTS)) {
      model.outputs().forEach(output -> values.add(output.value()));
    }
    List<ClosureCoordinate> counted = UnwrappedAngles.of(mechanism);
    return new Tape(values)
        .leaves().stream()
            .flatMap(
                leaf ->
                    leaf instanceof Expression.CoordinatePosition position
                            && position.coordinate() instanceof ClosureCoordinate cut
                            && UnwrappedAngles.isAngle(mechanism, cut)
                            && !counted.contains(cut)
                        ? Stream.of(UnwrappedAngles.joint(mechanism, cut).name())
                        : Stream.empty())
            .distinct()
            .map(joint -> "events or outputs that use the angle of the cut joint \"" + joint + "\"")
            .toList();
  }

  private CModel derived() {
    Links links = Links.of(mechanism);
    CMotion motion = mechanism.closures().isEmpty() ? tree(links) : loops(links);
    Program energy = EnergyEquations.derive(links);
    ModelDescription description =
        new ModelDescription(
            mechanism.name(),
            choice.formulation(),
            ModelClass.joints(mechanism),
            mechanism.stateVariables(),
            options.settings());
    return new CModel(
        mechanism,
        description,
        start(),
        motion,
        energy,
        outputs(links, energy),
        events(links),
        inputs(description.states()),
        watch(links));
  }

  private double[] start() {
    if (!mechanism.closures().isEmpty()) {
      return model.closedStart(options.settings().tStart()).state();
    }
    double[] start = new double[mechanism.stateCount()];
    mechanism.initialState(start);
    return start;
  }

  private CMotion tree(Links links) {
    Program derivative = TreeClass.derivative(links, choice);
    refuse(GenerationLimits.noFaster(choice.formulation(), derivative.operationCount()));
    return new CMotion.Tree(derivative);
  }

  private CMotion loops(Links links) {
    new ModelAssembly(model, options, choice).requireClosedLoops();
    ClosedStart start = model.closedStart(options.settings().tStart());
    LoopEquations equations = new LoopEquations(start.tree());
    TreeMotion motion = new TreeMotion(start.tree());
    // this call sets the sizes of the equations
    motion.sweep(start.time(), start.state());
    equations.place(motion, start.time());
    StateCoordinates coordinates = new StateCoordinates(mechanism);
    LoopRounding rounding = new LoopRounding(start.tree(), equations, coordinates);
    SparseMatrix rows = equations.stateRows(coordinates.velocityCount(), false);
    int count = equations.count();
    List<ClosureCoordinate> angles = UnwrappedAngles.of(mechanism);
    double[] behind = new UnwrappedAngles(start.tree()).behind(new double[0]);
    PenaltySettings penalty =
        PenaltySettings.isPenalty(options.closure())
            ? PenaltySettings.of(options.closure())
            : PenaltySettings.DEFAULT;
    return new CLoops(
        LoopCode.loops(links, count),
        LoopCode.equations(links, count),
        LoopCode.mass(links, count),
        mechanism.furtherStates().isEmpty()
            ? Optional.empty()
            : Optional.of(LoopCode.further(links)),
        angles.isEmpty()
            ? Optional.empty()
            : Optional.of(
                PowerEquations.formulas(
                    links,
                    angles.stream().<Expression>map(Expression.CoordinatePosition::new).toList())),
        DoubleStream.of(behind).boxed().toList(),
        IntStream.of(rows.start).boxed().toList(),
        IntStream.of(rows.column).boxed().toList(),
        IntStream.range(0, count).mapToObj(equations::size).toList(),
        IntStream.range(0, count).mapToObj(rounding::ofPlace).toList(),
        DoubleStream.of(new CoordinateUnits(mechanism, equations.length()).velocities)
            .boxed()
            .toList(),
        penalty,
        start.rank(),
        equations.isHolonomic());
  }

  private CEvents events(Links links) {
    List<Event> events = mechanism.events();
    List<CEvents.Assignment> assignments =
        StateEvents.assignedComponents(mechanism).stream()
            .map(pair -> new CEvents.Assignment(pair[0], pair[1]))
            .toList();
    return new CEvents(
        events.stream()
            .map(e -> new ModelEvents.Kind(e.name(), e.direction(), e.action()))
            .toList(),
        PowerEquations.formulas(links, events.stream().map(Event::trigger).toList()),
        PowerEquations.formulas(links, StateEvents.assigned(mechanism)),
        assignments,
        JumpsInC.of(mechanism, options.settings()),
        mechanism.samplings().stream()
            .map(sampling -> new CEvents.Sampled(sampling.period(), sampling.offset()))
            .toList());
  }

  private Optional<CWatch> watch(Links links) {
    WatchedTape watched = WatchedTape.of(mechanism);
    if (watched.isEmpty()) {
      return Optional.empty();
    }
    List<Expression> quantities = watched.searchedQuantities();
    List<Overlap> overlaps = mechanism.overlaps();
    return Optional.of(
        new CWatch(
            PowerEquations.formulas(links, quantities),
            quantities.size(),
            watched.listing(),
            watched.turns().stream().map(turn -> IntStream.of(turn).boxed().toList()).toList(),
            overlaps.stream().map(Overlap::contact).toList(),
            PowerEquations.formulas(
                links,
                overlaps.stream().flatMap(one -> Stream.of(one.depth(), one.most())).toList())));
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
