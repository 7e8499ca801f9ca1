package org.mechservice.mechml.resolve;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.mechservice.mechml.Look;
import org.mechservice.mechml.ReadOptions;
import org.mechservice.mechml.Scenery;
import org.mechservice.mechml.SimulationSettings;
import org.mechservice.mechml.SimulationTask;
import org.mechservice.mechml.Solid;
import org.mechservice.mechml.diagnosis.Diagnostics;
import org.mechservice.mechml.diagnosis.Phrase;
import org.mechservice.mechml.document.Element;
import org.mechservice.mechml.document.Limits;
import org.mechservice.mechml.resolve.body.BodyDefinition;
import org.mechservice.mechml.resolve.body.BodyIndex;
import org.mechservice.mechml.resolve.body.BodyReader;
import org.mechservice.mechml.resolve.body.RootReader;
import org.mechservice.mechml.resolve.force.ForcesReader;
import org.mechservice.mechml.resolve.force.GravityReader;
import org.mechservice.mechml.resolve.force.JointAttributesReader;
import org.mechservice.mechml.resolve.formula.FormulaReader;
import org.mechservice.mechml.resolve.formula.MechanismNames;
import org.mechservice.mechml.resolve.formula.ResolvedJoint;
import org.mechservice.mechml.resolve.formula.RopeReader;
import org.mechservice.mechml.resolve.joint.ArmatureReader;
import org.mechservice.mechml.resolve.joint.ConstraintsReader;
import org.mechservice.mechml.resolve.joint.DriveReader;
import org.mechservice.mechml.resolve.joint.JointLink;
import org.mechservice.mechml.resolve.joint.JointTree;
import org.mechservice.mechml.resolve.joint.JointsReader;
import org.mechservice.mechml.resolve.joint.MotionCheck;
import org.mechservice.mechml.resolve.value.NameRule;
import org.mechservice.mechml.resolve.value.NameTable;
import org.mechservice.mechml.resolve.value.ResolvedParameter;
import org.mechservice.mechml.resolve.value.ValueReader;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.mechanism.Armature;
import org.mechservice.solver.mechanism.Body;
import org.mechservice.solver.mechanism.FurtherState;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.Output;
import org.mechservice.solver.mechanism.Parameter;
import org.mechservice.solver.mechanism.PrescribedMotion;
import org.mechservice.solver.mechanism.Root;
import org.mechservice.solver.mechanism.closure.JointClosure;
import org.mechservice.solver.mechanism.closure.LoopClosure;
import org.mechservice.solver.mechanism.force.ForceElement;
import org.mechservice.solver.mechanism.joint.Joint;
import org.mechservice.solver.mechanism.joint.StartRole;
import org.mechservice.solver.spatial.Vector3;

/**
 * Reads {@code MBSmodel} in two steps: first bodies, root and joints, so that every name is known;
 * then the elements that refer to these names.
 */
final class MechanismReader {
  private final Element model;
  private final ValueReader values;
  private final Diagnostics diagnostics;
  private final Optional<Root> root;
  private final BodyIndex index;
  private final JointsReader jointsReader;
  private final List<JointLink> links;
  private final JointTree tree;
  private final MechanismNames names;
  private final FormulaReader formulas;
  private final StatesReader states;

  private MechanismReader(
      Element model,
      ValueReader values,
      Diagnostics diagnostics,
      NameTable<BodyDefinition> bodies,
      Optional<Root> root,
      BodyIndex index,
      ReadOptions.Inputs inputs) {
    this.model = model;
    this.values = values;
    this.diagnostics = diagnostics;
    this.root = root;
    this.index = index;
    this.jointsReader = new JointsReader(values, bodies, index, diagnostics);
    List<JointLink> read = jointsReader.read(joints(), jointVals());
    this.links =
        root.map(pose -> jointsReader.placed(read, new JointTree(read, index), pose)).orElse(read);
    this.tree = new JointTree(links, index);
    this.names = new MechanismNames(bodies, index, diagnostics);
    this.formulas = new FormulaReader(values, names, diagnostics);
    TablesReader.read(model, values, names, diagnostics);
    this.states = StatesReader.begin(model, values, names, inputs, diagnostics);
    checkTree();
    placeJoints();
  }

  /**
   * Returns a reader that knows the names; empty if there is no root or a limit is exceeded.
   *
   * @param inputs what becomes of inputs
   */
  static Optional<MechanismReader> begin(
      Element model, ValueReader values, ReadOptions.Inputs inputs, Diagnostics diagnostics) {
    NameRule.check(model, diagnostics);
    Element rootElement = model.requiredChild("topology").requiredChild("root");
    NameTable<BodyDefinition> names = new NameTable<>("body", "does not exist", diagnostics);
    List<BodyDefinition> bodies = bodies(model, names, values, diagnostics);
    Optional<BodyDefinition> rootBody = names.find(rootElement, rootElement.required("name"));
    if (rootBody.isEmpty() || bodies.size() > Limits.BODIES) {
      return Optional.empty();
    }
    Optional<Root> root = new RootReader(values, diagnostics).read(rootElement, rootBody.get());
    return Optional.of(
        new MechanismReader(
            model,
            values,
            diagnostics,
            names,
            root,
            new BodyIndex(bodies, rootBody.get()),
            inputs));
  }

  /** Returns what the file says for the eye; to be called for a file without errors. */
  Scenery scenery() {
    Map<String, List<Solid>> solids = new HashMap<>();
    Map<String, List<Look>> looks = new HashMap<>();
    for (BodyDefinition body : names.bodies()) {
      if (!body.solids().isEmpty()) {
        solids.put(body.name(), body.solids());
      }
      if (!body.looks().isEmpty()) {
        looks.put(body.name(), body.looks());
      }
    }
    return new Scenery(
        solids,
        looks,
        new RopeReader(values, formulas, names, diagnostics).routes(model),
        ForcesReader.roads(model, values, formulas, names, diagnostics));
  }

  private static List<BodyDefinition> bodies(
      Element model, NameTable<BodyDefinition> names, ValueReader values, Diagnostics diagnostics) {
    List<Element> elements = model.requiredChild("Bodies").children("body");
    if (elements.size() > Limits.BODIES) {
      diagnostics.error(
          MessageCode.MODEL_FILE_TOO_LARGE,
          model.position(),
          Phrase.of("the model has %d bodies; %d are allowed", elements.size(), Limits.BODIES));
    }
    BodyReader reader = new BodyReader(values, diagnostics);
    List<BodyDefinition> bodies = new ArrayList<>();
    // of too many, one more than allowed is read: so much, and no more, is the error
    int read = Math.min(elements.size(), Limits.BODIES + 1);
    for (Element element : elements.subList(0, read)) {
      BodyDefinition parts = reader.read(element);
      names.add(element, Optional.of(parts));
      bodies.add(parts);
    }
    return bodies;
  }

  /**
   * Checks connection only if all bodies of joints are known: a missing joint would make bodies
   * look unconnected.
   */
  private void checkTree() {
    tree.checkBodies(diagnostics);
    if (links.size() == joints().size()) {
      tree.checkConnection(diagnostics);
    }
    if (index.moving().isEmpty()) {
      diagnostics.error(
          MessageCode.NOTHING_MOVES,
          model.requiredChild("Bodies").position(),
          Phrase.of(
              "%s is the only body, and it is the root: add a body that moves",
              index.root().element().label()));
    }
  }

  private void placeJoints() {
    int inTree = 0;
    int closures = 0;
    for (int j = 0; j < links.size(); j++) {
      JointLink link = links.get(j);
      boolean cut = tree.isCut(j);
      names.add(
          new ResolvedJoint(
              link.element(), link.type(), cut, link.isDriven(), cut ? closures++ : inTree++));
    }
  }

  /** Returns the joints in file order. */
  List<JointLink> links() {
    return links;
  }

  /** Returns the names of bodies, points and joints. */
  MechanismNames names() {
    return names;
  }

  /** Returns the reader of expressions with these names. */
  FormulaReader formulas() {
    return formulas;
  }

  /** Returns the outputs in file order. */
  List<Output> outputs() {
    return new OutputsReader(values, formulas, names, diagnostics).read(model);
  }

  /** Returns the mechanism; empty after a reported error. */
  Optional<Mechanism> mechanism() {
    GravityReader gravities = new GravityReader(values, formulas, names, diagnostics);
    Optional<Vector3> gravity = gravities.constant(model);
    DriveReader drives = new DriveReader(values, formulas, diagnostics);
    List<PrescribedMotion> motions = new ArrayList<>();
    List<StartRole> roles = new ArrayList<>();
    List<LoopClosure> closures = new ArrayList<>();
    ArmatureReader armatureReader = new ArmatureReader(values, diagnostics);
    List<Armature> armatures = new ArrayList<>();
    for (int j = 0; j < links.size(); j++) {
      JointLink link = links.get(j);
      List<Expression> motion = drives.motion(link, tree.isCut(j));
      StartRole role = DriveReader.role(link);
      armatureReader.read(link, tree.isCut(j), roles.size()).ifPresent(armatures::add);
      if (tree.isCut(j)) {
        link.joint().ifPresent(joint -> closures.add(new JointClosure(joint, role, motion)));
        continue;
      }
      if (!motion.isEmpty()) {
        motions.add(new PrescribedMotion(roles.size(), motion));
      }
      roles.add(role);
    }
    closures.addAll(
        new ConstraintsReader(values, formulas, jointsReader, names, diagnostics).read(model));
    List<FurtherState> further = states.read(formulas);
    List<Body> bodies =
        index.moving().stream().map(BodyDefinition::body).flatMap(Optional<Body>::stream).toList();
    List<ForceElement> forces = forces(further);
    forces.addAll(gravities.overTime(model, bodies, closures));
    if (diagnostics.hasErrors()) {
      return Optional.empty();
    }
    return Optional.of(
        new Mechanism(
                model.required("name"),
                root.orElseThrow(),
                gravity.orElseThrow(),
                bodies,
                tree.outward(),
                motions,
                roles,
                closures,
                forces,
                parameters())
            .withFurtherStates(further)
            .withSamplings(states.samplings())
            .withArmatures(armatures));
  }

  /** Reports prescribed motions that no mechanism can follow. */
  void checkMotions(Mechanism mechanism, SimulationSettings settings) {
    boolean moves =
        settings.task() instanceof SimulationTask.Dynamic
            || settings.task() instanceof SimulationTask.InverseDynamic;
    MotionCheck.of(links, mechanism, settings.run(), moves, diagnostics);
  }

  /** Reports states in a simulation that does not integrate them. */
  void checkStates(Mechanism mechanism, SimulationSettings settings) {
    boolean integrates =
        settings.task() instanceof SimulationTask.Dynamic
            || settings.task() instanceof SimulationTask.Linearization;
    // At rest the rates of integrated states are zero; samples depend on the time before.
    FurtherState.Role most =
        settings.task() instanceof SimulationTask.StaticEquilibrium
            ? FurtherState.Role.SAMPLED
            : FurtherState.Role.INTEGRATED;
    boolean changing =
        mechanism.furtherStates().stream()
            .anyMatch(s -> s.role() == FurtherState.Role.SAMPLED || s.role() == most);
    if (!integrates && changing) {
      Element first = states.firstChanging().orElseGet(() -> carrier(mechanism));
      diagnostics.error(
          MessageCode.STATE_NOT_INTEGRATED,
          first.position(),
          Phrase.of(
              "%s: its value follows from integration in time, and <%s> does not integrate;"
                  + " simulate with <dynamic>, or leave the states out of this model",
              first.label(), settings.task().element()));
    }
  }

  /** Returns the force that brings the first state. */
  private Element carrier(Mechanism mechanism) {
    String state = mechanism.furtherStates().get(0).name();
    return model.requiredChild("Forces").children().stream()
        .filter(force -> force.attribute("name").filter(n -> state.startsWith(n + ".")).isPresent())
        .findFirst()
        .orElse(model);
  }

  /**
   * @param further the states of the file; those of forces are added
   */
  private List<ForceElement> forces(List<FurtherState> further) {
    JointAttributesReader attributes = new JointAttributesReader(formulas, names, diagnostics);
    List<ForceElement> forces = new ArrayList<>();
    for (JointLink link : links) {
      names
          .joint(link.element().required("name"))
          .ifPresent(
              joint -> forces.addAll(attributes.read(joint, link.joint().map(Joint::attachment))));
    }
    forces.addAll(new ForcesReader(values, formulas, names, further, diagnostics).read(model));
    return forces;
  }

  private List<Parameter> parameters() {
    List<Parameter> parameters = new ArrayList<>();
    for (ResolvedParameter tunable : values.parameters().tunable()) {
      parameters.add(
          new Parameter(
              tunable.name(),
              tunable.unit().toSi(tunable.value()),
              tunable.unit().dimension().siSymbol(),
              tunable.unitSymbol(),
              tunable.unit().numerator(),
              tunable.unit().denominator()));
    }
    parameters.addAll(states.inputParameters());
    return parameters;
  }

  /** Returns the number of parameters that are inputs. */
  int inputCount() {
    return states.inputParameters().size();
  }

  private List<Element> joints() {
    return model.child("Joints").map(j -> j.children("joint")).orElse(List.of());
  }

  private List<Element> jointVals() {
    return model
        .requiredChild("topology")
        .child("relCoorVals")
        .map(r -> r.children("jointVal"))
        .orElse(List.of());
  }
}
