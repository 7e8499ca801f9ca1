package org.mechservice.library;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Optional;
import java.util.function.Consumer;
import org.mechservice.guard.UserCode;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.mechml.document.Document;
import org.mechservice.mechml.document.DocumentWriter;
import org.mechservice.mechml.document.Vocabulary;

/**
 * Builds a model in code. What arises is a MechML document: the same names, units, defaults and
 * messages as in a file, and {@link #mechml} is that file.
 *
 * <pre>{@code
 * MechanismBuilder arm = MechanismBuilder.of("Arm");
 * arm.parameter("stiffness", 20, "N/m");
 * arm.root("ground").point("anchor", 0.5, 0, 0);
 * arm.body("bar").point("tip", 0, 0, -1).cylinder(0.02, "0;0;0", "tip").set("mass", 1);
 * arm.joint("hinge", "R").between("ground", "bar").at(0, 0, 0).axis(0, 1, 0);
 * arm.springDamper("spring").between("ground", "anchor", "bar", "tip").set("k", "stiffness");
 * arm.gravity(0, 0, -9.81);
 * arm.start("hinge", 0.3, 0);
 * arm.dynamic(5, 0.01).integrator("auto", 1e-8, 1e-10);
 * MechModel model = arm.model();
 * double[] angle = model.simulate().column("hinge.q");
 * }</pre>
 *
 * <p>Elements may be added in any order. A name or value that the grammar or the list of units does
 * not have is refused at once ({@link IllegalArgumentException}); names of bodies, points and so
 * on, expressions and what is missing are checked when the model is whole, by {@link #mechml} and
 * {@link #model}. Each method adds an element or sets its attributes, and {@link #element} adds any
 * other. Numbers are in the units of the model, as in a file; {@code set} takes a unit beside a
 * value.
 *
 * <p>For one thread. A model that was returned does not change any more.
 */
public final class MechanismBuilder extends BuiltElement<MechanismBuilder> {
  private final OtherElement document;

  private MechanismBuilder(OtherElement document) {
    super("MBSmodel", Optional.of(document));
    this.document = document;
  }

  /** Begins a model in kg, m, rad and N. */
  public static MechanismBuilder of(String name) {
    return of(name, "kg", "m");
  }

  /**
   * Begins a model in other units; {@code set("angleUnits", "deg")} and {@code set("forceUnits",
   * "kN")} change two more.
   *
   * @param massUnits kg, g, t, lb or slug
   * @param lengthUnits m, cm, mm, in or ft
   */
  public static MechanismBuilder of(String name, String massUnits, String lengthUnits) {
    OtherElement document = new OtherElement("MechML");
    return document.add(
        new MechanismBuilder(document),
        model -> model.setAll("name", name, "massUnits", massUnits, "lengthUnits", lengthUnits));
  }

  @Override
  MechanismBuilder self() {
    return this;
  }

  /**
   * {@inheritDoc} One that belongs into {@code Bodies}, {@code Forces} or another part of the model
   * is added there.
   */
  @Override
  public OtherElement element(String element, String... attributes) {
    return add(element, child -> child.setAll(attributes));
  }

  /** Returns the part of the model that holds an element; the model itself if no part does. */
  private BuiltElement<?> home(String element) {
    return Vocabulary.children(name()).contains(element) ? this : home(this, element).orElse(this);
  }

  /** Searches the parts that have no attributes: they only hold others. */
  private static Optional<BuiltElement<?>> home(BuiltElement<?> around, String element) {
    for (String part : Vocabulary.children(around.name())) {
      if (Vocabulary.attributes(part).isEmpty()) {
        if (Vocabulary.children(part).contains(element)) {
          return Optional.of(around.section(part));
        }
        if (holds(part, element)) {
          return home(around.section(part), element);
        }
      }
    }
    return Optional.empty();
  }

  private static boolean holds(String part, String element) {
    return Vocabulary.children(part).stream()
        .filter(inner -> Vocabulary.attributes(inner).isEmpty())
        .anyMatch(inner -> Vocabulary.children(inner).contains(element) || holds(inner, element));
  }

  private ConnectionElement connection(String element, String... attributes) {
    return connection(element, child -> child.setAll(attributes));
  }

  private ConnectionElement connection(String element, Consumer<ConnectionElement> values) {
    BuiltElement<?> home = home(element);
    return home.add(new ConnectionElement(element, home), values);
  }

  private OtherElement add(String element, Consumer<OtherElement> values) {
    BuiltElement<?> home = home(element);
    return home.add(new OtherElement(element, home), values);
  }

  /** Adds a number for use in expressions, without unit. */
  public MechanismBuilder parameter(String name, double value) {
    add("parameter", it -> it.set("name", name).set("value", value));
    return this;
  }

  /** Adds a number for use in expressions. */
  public MechanismBuilder parameter(String name, double value, String unit) {
    add("parameter", it -> it.set("name", name).set("value", value, unit));
    return this;
  }

  /** Adds a function of one argument through points, for use in expressions. */
  public OtherElement table(String name, double[] x, double[] y) {
    return add("table", it -> it.set("name", name).set("x", x).set("y", y));
  }

  /**
   * Adds a function of two arguments on a grid, for use in expressions.
   *
   * @param x first arguments, ascending
   * @param y second arguments, ascending
   * @param z value z[i][j] at x[i] and y[j]
   */
  public OtherElement map(String name, double[] x, double[] y, double[][] z) {
    double[] values = Arrays.stream(z).flatMapToDouble(Arrays::stream).toArray();
    return add("map", it -> it.set("name", name).set("x", x).set("y", y).set("z", values));
  }

  /** Adds a body. */
  public BodyElement body(String name) {
    BuiltElement<?> home = home("body");
    return home.add(new BodyElement(home), body -> body.set("name", name));
  }

  /** Adds the body at rest, to which all others are connected. */
  public BodyElement root(String name) {
    element("root", "name", name);
    return body(name);
  }

  /**
   * Adds a joint.
   *
   * @param type R, P, C, U, S, PL, H, F or W
   */
  public ConnectionElement joint(String name, String type) {
    return connection("joint", "name", name, "type", type);
  }

  /** Adds a constraint that keeps two points at a distance. */
  public ConnectionElement distance(String name, double distance) {
    return connection("DISTConstraint", it -> it.set("name", name).set("dist", distance));
  }

  /** Adds a constraint by which an expression of joint coordinates is zero. */
  public MechanismBuilder coordinateConstraint(String name, String expression) {
    element("CoordConstraint", "name", name, "expression", expression);
    return this;
  }

  /**
   * Adds a rope of constant length; its {@code plane}, {@code via}s, {@code pulley}s and {@code
   * term}s are elements of it.
   */
  public OtherElement rope(String name, double length) {
    return add("Rope", it -> it.set("name", name).set("length", length));
  }

  /** Adds a constraint that keeps a point of body 2 on a plane of body 1. */
  public ConnectionElement pointOnPlane(String name) {
    return connection("PointOnPlane", "name", name);
  }

  /** Adds a constraint that keeps a point of body 2 on a line of body 1. */
  public ConnectionElement pointOnLine(String name) {
    return connection("PointOnLine", "name", name);
  }

  /** Adds a wheel or ball that rolls on a plane of body 1. */
  public ConnectionElement rolling(String name, double radius) {
    return connection("Rolling", it -> it.set("name", name).set("radius", radius));
  }

  /** Adds a knife edge. */
  public ConnectionElement knifeEdge(String name) {
    return connection("KnifeEdge", "name", name);
  }

  /** Adds the equations of a joint, without coordinates of its own. */
  public ConnectionElement jointConstraint(String name, String type) {
    return connection("JointConstraint", "name", name, "type", type);
  }

  /** Adds a state with its derivative, an expression. */
  public OtherElement state(String name, String derivative) {
    return element("state", "name", name, "derivative", derivative);
  }

  /** Adds a signal from outside, which {@link SteppedModel#input} sets. */
  public OtherElement input(String name) {
    return element("input", "name", name);
  }

  /** Adds a controller of a measured value, an expression; its name is its output. */
  public OtherElement pid(String name, String measured) {
    return element("pid", "name", name, "measured", measured);
  }

  /** Adds a transfer function num(s)/den(s) of an input, highest powers first. */
  public OtherElement transferFunction(String name, String input, double[] num, double[] den) {
    return add(
        "transferFunction",
        it -> it.set("name", name).set("input", input).set("num", num).set("den", den));
  }

  /** Adds a value that is taken once in a period, s, and constant in between. */
  public OtherElement sampled(String name, String value, double period) {
    return add("sampled", it -> it.set("name", name).set("value", value).set("period", period));
  }

  /** Adds gravity. */
  public MechanismBuilder gravity(double gx, double gy, double gz) {
    add("gravity", it -> it.set("gx", gx).set("gy", gy).set("gz", gz));
    return this;
  }

  /** Adds a spring and damper between two points; {@code k}, {@code c} etc. are to be set. */
  public ConnectionElement springDamper(String name) {
    return connection("springDamper", "name", name);
  }

  /** Adds a spring and damper at an angle of a joint. */
  public OtherElement torsionSpringDamper(String name, String joint) {
    return element("torsionSpringDamper", "name", name, "joint", joint);
  }

  /**
   * Adds a spring and damper along an expression of positions; {@code k}, {@code c}, {@code
   * backlash} and so on are to be set.
   */
  public OtherElement couplingSpringDamper(String name, String expression) {
    return element("couplingSpringDamper", "name", name, "expression", expression);
  }

  /** Adds a rope that only pulls, with its stiffness and its length without load. */
  public OtherElement elasticRope(String name, double k, double length0) {
    return add("elasticRope", it -> it.set("name", name).set("k", k).set("length0", length0));
  }

  /** Adds a bushing between two frames. */
  public ConnectionElement bushing(String name) {
    return connection("bushing", "name", name);
  }

  /** Adds a contact of a point or sphere of body 2 with a plane of body 1. */
  public ConnectionElement contact(String name, double stiffness) {
    return connection("contact", it -> it.set("name", name).set("stiffness", stiffness));
  }

  /**
   * Adds a contact of a sphere of body 2 with a sphere, capsule or box of body 1, whose sizes are
   * to be set.
   */
  public ConnectionElement sphereContact(String name, double radius2, double stiffness) {
    return connection(
        "sphereContact",
        it -> it.set("name", name).set("radius2", radius2).set("stiffness", stiffness));
  }

  /** Adds a contact of the edge of a disc of body 2 with a plane of body 1. */
  public ConnectionElement discContact(String name, double radius, double stiffness) {
    return connection(
        "discContact",
        it -> it.set("name", name).set("radius", radius).set("stiffness", stiffness));
  }

  /** Adds a contact of the corners of a box of body 2, given by its edges, with a plane. */
  public ConnectionElement boxContact(String name, String box, double stiffness) {
    return connection(
        "boxContact", it -> it.set("name", name).set("box", box).set("stiffness", stiffness));
  }

  /**
   * Adds a tyre between a wheel, body 2, and a road of body 1; {@code load}, {@code longitudinal}
   * and {@code lateral} are to be set.
   */
  public ConnectionElement tyre(String name, double radius, double stiffness) {
    return connection(
        "tyre", it -> it.set("name", name).set("radius", radius).set("stiffness", stiffness));
  }

  /** Adds friction in a joint. */
  public OtherElement friction(String name, String joint) {
    return element("friction", "name", name, "joint", joint);
  }

  /** Adds a force and a torque at a point; {@code fx} to {@code tz} are expressions to be set. */
  public OtherElement forceTorque(String name, String body, String point) {
    return element("forceTorque", "name", name, "body", body, "point", point);
  }

  /** Adds the force of a joint along its coordinate, an expression. */
  public OtherElement jointForce(String name, String joint, String expression) {
    return element("jointForce", "name", name, "joint", joint, "expression", expression);
  }

  /** Adds a column of results, an expression. */
  public OtherElement output(String name, String expression) {
    return element("output", "name", name, "expression", expression);
  }

  /** Starts a joint with one coordinate at a position and a velocity. */
  public OtherElement start(String joint, double position, double velocity) {
    return start(joint).set("posVals", position).set("velVals", velocity);
  }

  /**
   * Returns the start of a joint, whose {@code posVals}, {@code velVals} and so on are to be set;
   * always the same one.
   */
  public OtherElement start(String joint) {
    BuiltElement<?> starts = section("topology").section("relCoorVals");
    for (BuiltElement<?> child : starts.children()) {
      if (child instanceof OtherElement start
          && start.attribute("name").equals(Optional.of(joint))) {
        return start;
      }
    }
    return starts.element("jointVal", "name", joint);
  }

  /**
   * Prescribes the motion of a joint: an expression of the time {@code t} for each coordinate,
   * separated by semicolons; with the value {@code rotation} three angles in place of Euler
   * parameters.
   */
  public OtherElement drive(String joint, String motion) {
    return start(joint).set("driven", motion);
  }

  /** Adds a simulation of the motion from t = 0. */
  public SimulationElement dynamic(double tEnd, double tStep) {
    return simulation("dynamic").time(0, tEnd, tStep);
  }

  /** Adds a simulation of driven coordinates without forces, from t = 0. */
  public SimulationElement kinematic(double tEnd, double tStep) {
    return simulation("kinematic").time(0, tEnd, tStep);
  }

  /** Adds a computation of the forces that produce a prescribed motion, from t = 0. */
  public SimulationElement inverseDynamic(double tEnd, double tStep) {
    return simulation("inverseDynamic").time(0, tEnd, tStep);
  }

  /**
   * Adds a simulation.
   *
   * @param task {@code dynamic}, {@code kinematic}, {@code static}, {@code inverseDynamic} or
   *     {@code linearize}
   */
  public SimulationElement simulation(String task) {
    OtherElement simulation = new OtherElement("MBSsimulation", document);
    SimulationElement element =
        simulation.add(new SimulationElement(task, simulation), child -> {});
    document.add(simulation, child -> {});
    return element;
  }

  /**
   * Returns the model as canonical MechML text.
   *
   * @throws MechmlException if it is not whole or not right; the lines in it are those of {@link
   *     #toString}
   */
  public String mechml() throws MechmlException {
    model();
    return toString();
  }

  /**
   * Writes the model to a file as canonical MechML text and reads it from there: files that it
   * names, with a table or a mesh, are sought beside it.
   *
   * @return the model
   * @throws IOException if the file cannot be written, or another one not be read
   * @throws MechmlException if the model is not whole or not right; the file is there, for its
   *     lines
   */
  public MechModel writeMechml(Path file) throws IOException, MechmlException {
    return writeMechml(file, UserCode.NONE);
  }

  /**
   * Writes the model to a file as canonical MechML text and reads it from there, with classes of
   * forces.
   *
   * @param consent the folders whose classes of forces may run
   * @return the model
   * @throws IOException if the file cannot be written, or another one not be read
   * @throws MechmlException if the model is not whole or not right; the file is there, for its
   *     lines
   */
  public MechModel writeMechml(Path file, UserCode consent) throws IOException, MechmlException {
    Files.writeString(file, toString());
    return MechModel.read(file, consent);
  }

  /**
   * Returns the model. One that names other files takes {@link #writeMechml}.
   *
   * @throws MechmlException if it is not whole or not right; the lines in it are those of {@link
   *     #toString}
   */
  public MechModel model() throws MechmlException {
    return MechModel.of(attribute("name").orElse(""), toString());
  }

  /** Returns the document as it stands, perhaps not whole yet. */
  @Override
  public String toString() {
    return DocumentWriter.write(Document.of(document.built()));
  }
}
