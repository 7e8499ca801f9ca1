package org.mechservice.sim.emit;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.SortedSet;
import java.util.TreeSet;
import java.util.function.Function;
import java.util.stream.Collectors;
import org.mechservice.sim.emit.method.ConstantTable;
import org.mechservice.sim.emit.method.MethodSignature;
import org.mechservice.sim.emit.plan.CodeForm;
import org.mechservice.sim.emit.plan.CodeLayout;
import org.mechservice.sim.emit.plan.ProgramPlan;
import org.mechservice.sim.equations.derivatives.ResidualDerivatives;
import org.mechservice.solver.api.JointVariables;
import org.mechservice.solver.api.StateVariable;
import org.mechservice.solver.api.capability.BodyPoses;
import org.mechservice.solver.api.capability.DirectedForces;
import org.mechservice.solver.api.capability.Energies;
import org.mechservice.solver.api.capability.ExplicitModel;
import org.mechservice.solver.api.capability.PowerInput;
import org.mechservice.solver.api.capability.ResidualModel;
import org.mechservice.solver.api.capability.ResultColumns;
import org.mechservice.solver.api.result.Variable;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.catalogue.Accuracy;
import org.mechservice.solver.dynamics.TreeStepModel;
import org.mechservice.solver.force.formula.WrittenFormulas;
import org.mechservice.solver.mechanism.Body;
import org.mechservice.solver.mechanism.force.ForceElement;
import org.mechservice.solver.symbol.Expressions;
import org.mechservice.solver.symbol.Program;
import org.mechservice.solver.symbol.Scalar;
import org.mechservice.solver.symbol.ScalarOperation;

/**
 * The class of a model, planned: one plan, from which source and class file are printed. Both
 * compute the same operations in the same order, so their results have the same bits.
 */
public final class ModelPlan implements GeneratedClass {
  /** Number of states in one section of the program of start values. */
  private static final int SECTION_OF_START = 100;

  private static final MethodSignature INITIAL_STATE =
      new MethodSignature("initialState", List.of(), "y", false, true);
  private static final MethodSignature DERIVATIVE = ofState("derivative", "yDot", true, true);
  private static final MethodSignature ENERGY = ofState("energy", "energy", false, true);
  private static final MethodSignature POSES = ofState("poses", "poses", false, true);
  private static final MethodSignature POWER = ofState("power", "power", false, true);
  private static final MethodSignature FORMULAS = ofState("formulaValues", "values", false, true);
  private static final MethodSignature FORCES = ofState("forces", "forces", false, false);

  /**
   * A program with the method that runs it.
   *
   * @param head the method
   * @param plan plan of its code
   */
  record Part(MethodSignature head, ProgramPlan plan) {}

  private final ModelClass content;
  private final CodeForm form;
  private final ConstantTable constants = new ConstantTable();
  private final Part start;
  private final List<Part> programs = new ArrayList<>();
  private final Optional<Part> poses;
  private final Optional<Part> power;
  private final Optional<Part> forces;
  private final Optional<Part> formulas;

  private ModelPlan(ModelClass content, CodeForm form) {
    this.content = content;
    this.form = form;
    this.start = part(INITIAL_STATE, startOf(content));
    programs.add(part(DERIVATIVE, content.derivative()));
    if (content.residual().isPresent()) {
      programs.add(part(ofStateAndRate(content, "residual"), content.residual().get()));
    }
    if (content.derivatives().isPresent()) {
      Program derivatives = content.derivatives().get().program();
      programs.add(part(ofStateAndRate(content, "derivatives"), derivatives));
    }
    programs.add(part(ENERGY, content.energy()));
    this.poses = content.poses().map(program -> part(POSES, program));
    this.power = content.power().map(program -> part(POWER, program));
    this.forces = content.forces().map(values -> part(FORCES, values.program()));
    this.formulas = content.formulas().map(parts -> part(FORMULAS, parts.program()));
  }

  private Part part(MethodSignature head, Program program) {
    return new Part(head, CodeLayout.plan(program, head, form, constants));
  }

  private static MethodSignature ofState(
      String name, String output, boolean returnsResult, boolean isPublic) {
    List<MethodSignature.Argument> arguments =
        List.of(
            new MethodSignature.Argument("t", false, Program.TIME),
            new MethodSignature.Argument("y", true, 0));
    return new MethodSignature(name, arguments, output, returnsResult, isPublic);
  }

  private static MethodSignature ofStateAndRate(ModelClass content, String name) {
    int states = content.description().stateCount();
    List<MethodSignature.Argument> arguments =
        List.of(
            new MethodSignature.Argument("t", false, Program.TIME),
            new MethodSignature.Argument("y", true, 0),
            new MethodSignature.Argument("yDot", true, states));
    return new MethodSignature(name, arguments, name, true, true);
  }

  /** Plans a model's class. */
  public static ModelPlan of(ModelClass content, CodeForm form) {
    return new ModelPlan(content, form);
  }

  /** Returns the program that writes the states that are not zero at the start. */
  private static Program startOf(ModelClass content) {
    double[] y = new double[content.description().stateCount()];
    content.mechanism().initialState(y);
    Program program = new Program();
    for (int i = 0; i < y.length; i++) {
      if (i % SECTION_OF_START == 0) {
        program.section("", "start");
      }
      if (y[i] != 0) {
        program.output(i, program.expressions().constant(y[i]));
      }
    }
    return program;
  }

  @Override
  public String simpleName() {
    return content.simpleName();
  }

  @Override
  public String source() {
    return new ModelSourceWriter(this).text();
  }

  @Override
  public byte[] classFile() {
    return new ModelBytesWriter(this).bytes();
  }

  @Override
  public String code() {
    return code(programs);
  }

  /** Returns the description of programs. */
  static String code(List<Part> parts) {
    List<String> forms = new ArrayList<>();
    for (boolean shared : new boolean[] {true, false}) {
      List<String> summaries = new ArrayList<>();
      for (Part part : parts) {
        if (part.plan().isShared() == shared) {
          summaries.add(part.plan().summary(part.head().name()));
        }
      }
      if (!summaries.isEmpty()) {
        String form = shared ? "shared kernels: " : "straight line: ";
        forms.add(form + String.join(", ", summaries));
      }
    }
    return String.join("; ", forms);
  }

  /** Returns the table of constants. */
  ConstantTable constants() {
    return constants;
  }

  ModelClass content() {
    return content;
  }

  /** Returns the program of the initial state. */
  Part start() {
    return start;
  }

  /** Returns the programs of the equations and of the energies. */
  List<Part> programs() {
    return programs;
  }

  /** Returns the program of the bodies' poses, if they are requested. */
  Optional<Part> poses() {
    return poses;
  }

  /** Returns the program of the power of forces without potential energy, if there are any. */
  Optional<Part> power() {
    return power;
  }

  /** Returns the program of the values of forces, if they are requested. */
  Optional<Part> forces() {
    return forces;
  }

  /** Returns the program of the parts of forces' formulas, if any can be without a value. */
  Optional<Part> formulas() {
    return formulas;
  }

  private List<Part> all() {
    List<Part> all = new ArrayList<>(programs);
    for (Optional<Part> part : List.of(poses, power, forces, formulas)) {
      if (part.isPresent()) {
        all.add(part.get());
      }
    }
    return all;
  }

  /** Returns the length of workspace the class needs. */
  int slots() {
    int slots = 0;
    for (Part part : all()) {
      slots = Math.max(slots, part.plan().slots());
    }
    return slots;
  }

  /**
   * The superclass.
   *
   * @param type the class
   * @param arguments texts for its constructor
   */
  record Base(Class<?> type, List<String> arguments) {}

  /** Returns the superclass. */
  Base base() {
    if (content.derivatives().isEmpty()) {
      return new Base(Object.class, List.of());
    }
    ResidualDerivatives.Derived derived = content.derivatives().get();
    List<String> arguments = new ArrayList<>();
    arguments.addAll(List.of(jointTypes(), derived.tree(), derived.coupled()));
    int further = content.description().furtherStates().size();
    if (further > 0) {
      arguments.add(Integer.toString(further));
    }
    return new Base(TreeStepModel.class, arguments);
  }

  @Override
  public long plannedValues() {
    return plannedValues(all());
  }

  /** Returns the number of values in the plans of programs. */
  static long plannedValues(List<Part> parts) {
    return parts.stream()
        .map(part -> part.plan().program().expressions())
        .distinct()
        .mapToLong(Expressions::size)
        .sum();
  }

  @Override
  public boolean takesNumbers() {
    return content.hasUserForces() || readNumbers(all());
  }

  /** Returns whether programs read parameters or loads that their class receives. */
  static boolean readNumbers(List<Part> parts) {
    return parts.stream().anyMatch(part -> part.plan().readsModelParameters());
  }

  /** Returns the interfaces the class implements beyond those of its base, in order. */
  List<Class<?>> interfaces() {
    List<Class<?>> interfaces = new ArrayList<>();
    if (content.derivatives().isEmpty()) {
      interfaces.add(content.residual().isPresent() ? ResidualModel.class : ExplicitModel.class);
    }
    interfaces.add(Energies.class);
    addIf(poses.isPresent(), BodyPoses.class, interfaces);
    addIf(power.isPresent(), PowerInput.class, interfaces);
    addIf(forces.isPresent(), ResultColumns.class, interfaces);
    addIf(directedForces().isPresent(), DirectedForces.class, interfaces);
    addIf(formulas.isPresent(), WrittenFormulas.class, interfaces);
    return interfaces;
  }

  private static void addIf(boolean implemented, Class<?> type, List<Class<?>> interfaces) {
    if (implemented) {
      interfaces.add(type);
    }
  }

  /** Returns the number of columns of forces. */
  int forceCount() {
    return content.forces().map(values -> values.columns().size()).orElse(0);
  }

  /** Returns names of the columns of forces, one a line. */
  String forceNames() {
    return columns(Variable::name);
  }

  /** Returns their units, one a line. */
  String forceUnits() {
    return columns(Variable::unit);
  }

  private String columns(Function<Variable, String> what) {
    List<String> texts = new ArrayList<>();
    content
        .forces()
        .ifPresent(values -> values.columns().forEach(column -> texts.add(what.apply(column))));
    return String.join("\n", texts);
  }

  /** Returns the solver's classes whose functions are called, internal names in order. */
  SortedSet<String> functionOwners() {
    return functionOwners(all());
  }

  /** Returns the internal names of solver classes whose functions programs call. */
  static SortedSet<String> functionOwners(List<Part> parts) {
    SortedSet<String> owners = new TreeSet<>();
    for (Part part : parts) {
      int[] uses = part.plan().program().uses();
      for (int id = 0; id < uses.length; id++) {
        Scalar node = part.plan().program().expressions().node(id);
        if (uses[id] > 0
            && node.operation() == ScalarOperation.FUNCTION
            && !node.function().owner().startsWith("java/lang/")) {
          owners.add(node.function().owner());
        }
      }
    }
    return owners;
  }

  /** Returns the names of the forces that can lose their direction, a line for each force. */
  Optional<String> directedForces() {
    List<ForceElement> forces = content.mechanism().forces();
    String[] names = new String[forces.size()];
    Arrays.fill(names, "");
    boolean any = false;
    for (Program.Section section : content.derivative().sections()) {
      for (Program.Guard guard : section.guards()) {
        if (guard.result() <= DirectedForces.FIRST) {
          int force = DirectedForces.force(guard.result());
          names[force] = forces.get(force).name();
          any = true;
        }
      }
    }
    return any ? Optional.of(String.join("\n", names)) : Optional.empty();
  }

  /** Returns the names of the joints, as the description takes them. */
  String jointNames() {
    List<String> names = new ArrayList<>();
    for (JointVariables joint : content.description().joints()) {
      names.add(joint.name());
    }
    return String.join("\n", names);
  }

  /** Returns the types of the joints, as the description takes them. */
  String jointTypes() {
    List<String> types = new ArrayList<>();
    for (JointVariables joint : content.description().joints()) {
      types.add(joint.type().name());
    }
    return String.join(" ", types);
  }

  /** Returns names, units and tolerances of the further states, as the description takes them. */
  List<String> furtherStates() {
    List<StateVariable> states = content.description().furtherStates();
    return states.isEmpty()
        ? List.of()
        : List.of(
            lines(states, StateVariable::name),
            lines(states, StateVariable::unit),
            lines(states, state -> Double.toString(state.absoluteTolerance())));
  }

  private static String lines(List<StateVariable> states, Function<StateVariable, String> what) {
    return states.stream().map(what).collect(Collectors.joining("\n"));
  }

  /** Returns the names of the bodies, one a line. */
  String bodyNames() {
    List<String> names = new ArrayList<>();
    for (Body body : content.mechanism().bodies()) {
      names.add(body.name());
    }
    return String.join("\n", names);
  }

  /** Returns whether the settings have one absolute tolerance for all states. */
  boolean hasOneTolerance() {
    return content.description().defaults().hasOneTolerance();
  }

  /** Returns whether the settings have the standard accuracy. */
  boolean isStandardAccuracy() {
    return content.description().defaults().accuracy() == Accuracy.STANDARD;
  }

  /**
   * Returns whether the settings need the long constructor: bounds of step size or order, or
   * several tolerances.
   */
  boolean boundsSteps() {
    RunSettings settings = content.description().defaults();
    RunSettings automatic =
        new RunSettings(
            settings.tStart(),
            settings.tEnd(),
            settings.tStep(),
            settings.integrator(),
            settings.relativeTolerance(),
            settings.absoluteTolerance());
    return settings.maxStep() != automatic.maxStep()
        || settings.initialStep() != automatic.initialStep()
        || settings.maxOrder() != automatic.maxOrder()
        || settings.angleTolerance() != automatic.angleTolerance()
        || settings.velocityTolerance() != automatic.velocityTolerance()
        || settings.angularVelocityTolerance() != automatic.angularVelocityTolerance();
  }
}
