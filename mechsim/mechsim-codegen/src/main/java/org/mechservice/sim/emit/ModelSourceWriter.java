package org.mechservice.sim.emit;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import org.mechservice.sim.emit.method.ConstantTable;
import org.mechservice.sim.emit.method.NumberText;
import org.mechservice.sim.emit.source.JavaText;
import org.mechservice.sim.emit.source.ProgramPrinter;
import org.mechservice.sim.emit.source.SourceLines;
import org.mechservice.solver.api.JointVariables;
import org.mechservice.solver.api.ModelDescription;
import org.mechservice.solver.api.StateVariable;
import org.mechservice.solver.api.capability.BodyPoses;
import org.mechservice.solver.api.run.RunSettings;

/**
 * Writes the class of a model as Java source.
 *
 * <p>The class is readable: values have the names of mechanics, and a comment before every section
 * names its body, its joint and the equation it evaluates. It is also small: it has no method,
 * array or constant that the scene does not need.
 */
final class ModelSourceWriter {
  static final String LEGEND =
      "Names: omega, alpha, a: angular velocity, angular acceleration and acceleration of the"
          + " origin of a body's computing frame; W: alpha x + omega x omega x; f, n: force and"
          + " moment the body needs, all while no joint accelerates. J, H, M: articulated inertia;"
          + " D, kn, kf: its element on the joint's axis and its column there over D; u: joint"
          + " force less f, n along the axis; dalpha, da: what joint accelerations add. The origin"
          + " of a computing frame is the joint's point on the body, its z axis lies along the"
          + " joint; R, X take it to the parent's, where the joint is at r. q, v of a"
          + " joint: coordinate and rate. T, U: kinetic and potential energy of the bodies so far;"
          + " v, g of a body: velocity of the origin and gravity in the frame's axes, fall: gravity"
          + " times the way to it. SI units: kg, m, s, rad, N, J.";

  private final ModelPlan plan;
  private final SourceLines source = new SourceLines();

  ModelSourceWriter(ModelPlan plan) {
    this.plan = plan;
  }

  /** Returns the formatted source. */
  String text() {
    int slots = plan.slots();
    header(slots > 0);
    if (!plan.constants().isEmpty()) {
      ProgramPrinter.constants(source, plan.constants());
    }
    if (slots > 0) {
      source.line("private final double[] w = new double[" + slots + "];");
    }
    if (plan.takesNumbers()) {
      source.line("private final double[] p;");
    }
    plan.forces()
        .ifPresent(
            p ->
                source.line(
                    "private final double[] forces = new double[" + plan.forceCount() + "];"));
    construct();
    describe();
    method(plan.start(), List.of("Arrays.fill(y, 0.0);"), List.of());
    plan.programs().forEach(part -> method(part, List.of(), List.of()));
    plan.poses().ifPresent(this::poses);
    plan.power().ifPresent(part -> method(part, List.of(), List.of()));
    plan.forces().ifPresent(this::forces);
    plan.directedForces().ifPresent(this::directedForce);
    plan.formulas().ifPresent(this::formulas);
    return source.close().toString();
  }

  private void construct() {
    List<String> arguments = plan.base().arguments();
    if (!arguments.isEmpty() || plan.takesNumbers()) {
      String given = plan.takesNumbers() ? "double[] p" : "";
      source.blank().open("public " + plan.simpleName() + "(" + given + ")");
    }
    if (!arguments.isEmpty()) {
      source.line(
          arguments.stream()
              .map(JavaText::literal)
              .collect(Collectors.joining(", ", "super(", ");")));
    }
    if (plan.takesNumbers()) {
      source.line("this.p = p;");
    }
    if (!arguments.isEmpty() || plan.takesNumbers()) {
      source.close();
    }
  }

  private void header(boolean angles) {
    source.line("package " + ModelClass.PACKAGE + ";").blank();
    List<String> imports = new ArrayList<>();
    imports.add("java.util.Arrays");
    imports.add("org.mechservice.solver.api.ModelDescription");
    imports.add("org.mechservice.solver.api.run.RunSettings");
    if (!plan.isStandardAccuracy()) {
      imports.add("org.mechservice.solver.catalogue.Accuracy");
    }
    if (angles) {
      imports.add("org.mechservice.solver.spatial.SinCos");
    }
    plan.interfaces().forEach(type -> imports.add(type.getName()));
    if (plan.base().type() != Object.class) {
      imports.add(plan.base().type().getName());
    }
    if (plan.poses().isPresent() || plan.forces().isPresent()) {
      imports.add("java.util.List");
    }
    if (plan.forces().isPresent()) {
      imports.add("java.util.ArrayList");
      imports.add("org.mechservice.solver.api.result.ColumnGroup");
      imports.add("org.mechservice.solver.api.result.Variable");
    }
    if (!plan.constants().isEmpty()) {
      imports.add(ConstantTable.READER.getName());
    }
    plan.functionOwners().forEach(owner -> imports.add(owner.replace('/', '.')));
    imports.stream().sorted().distinct().forEach(name -> source.line("import " + name + ";"));
    source.blank().documentation(documentation());
    source.open(
        "public final class "
            + plan.simpleName()
            + (plan.base().type() == Object.class
                ? ""
                : " extends " + plan.base().type().getSimpleName())
            + " implements "
            + plan.interfaces().stream()
                .map(Class::getSimpleName)
                .collect(Collectors.joining(", ")));
  }

  private List<String> documentation() {
    ModelDescription description = plan.content().description();
    List<String> lines = new ArrayList<>();
    lines.add(
        JavaText.comment(
            "Equations of motion of model \"" + description.name() + "\", generated."));
    for (String note : plan.content().notes()) {
      lines.add("");
      lines.add("<p>" + JavaText.comment(note));
    }
    lines.add("");
    lines.add("<p>" + LEGEND);
    lines.add("");
    lines.add("<p>State y = [q; v]:");
    lines.add("");
    lines.add("<ul>");
    int position = 0;
    int velocity = description.positionCount();
    for (JointVariables joint : description.joints()) {
      lines.add(state(joint, position, velocity));
      position += joint.type().positionCount();
      velocity += joint.type().velocityCount();
    }
    int further = description.positionCount() + description.velocityCount();
    for (StateVariable state : description.furtherStates()) {
      lines.add(
          "  <li>y["
              + further++
              + "]: "
              + JavaText.comment("state " + state.name() + ", " + state.unit()));
    }
    lines.add("</ul>");
    return lines;
  }

  private static String state(JointVariables joint, int position, int velocity) {
    String name = JavaText.comment("joint " + joint.name() + " (" + joint.type() + ")");
    StringBuilder line = new StringBuilder("  <li>");
    if (joint.type().positionCount() == 0) {
      return line.append("none: ").append(name).toString();
    }
    line.append(range(position, joint.type().positionCount())).append(", ");
    line.append(range(velocity, joint.type().velocityCount())).append(": ").append(name);
    for (int i = 0; i < joint.type().positionCount(); i++) {
      line.append(i == 0 ? ", " : " ").append(joint.type().positionUnit(i));
    }
    for (int i = 0; i < joint.type().velocityCount(); i++) {
      line.append(i == 0 ? ", " : " ").append(joint.type().velocityUnit(i));
    }
    return line.toString();
  }

  private static String range(int first, int count) {
    return count == 1 ? "y[" + first + "]" : "y[" + first + "] to y[" + (first + count - 1) + "]";
  }

  private void describe() {
    ModelDescription description = plan.content().description();
    source.blank().line("@Override").open("public ModelDescription description()");
    source.line("return ModelDescription.of(");
    source.line("    " + JavaText.literal(description.name()) + ",");
    source.line("    " + JavaText.literal(description.formulation()) + ",");
    source.line("    " + JavaText.literal(plan.jointTypes()) + ",");
    source.line("    " + JavaText.literal(plan.jointNames()) + ",");
    List<String> further = plan.furtherStates();
    source.line("    " + settings(description.defaults()) + ")" + (further.isEmpty() ? ";" : ""));
    if (!further.isEmpty()) {
      source.line(
          further.stream()
              .map(JavaText::literal)
              .collect(Collectors.joining(", ", "    .withFurtherStates(", ");")));
    }
    source.close();
  }

  private String settings(RunSettings settings) {
    List<String> values = new ArrayList<>();
    values.add(number(settings.tStart()));
    values.add(number(settings.tEnd()));
    values.add(number(settings.tStep()));
    values.add(JavaText.literal(settings.integrator()));
    values.add(number(settings.relativeTolerance()));
    values.add(number(settings.absoluteTolerance()));
    if (plan.boundsSteps()) {
      values.add(number(settings.maxStep()));
      values.add(number(settings.initialStep()));
      values.add(Integer.toString(settings.maxOrder()));
    }
    if (!plan.hasOneTolerance()) {
      values.add(number(settings.angleTolerance()));
      values.add(number(settings.velocityTolerance()));
      values.add(number(settings.angularVelocityTolerance()));
    }
    String accuracy =
        plan.isStandardAccuracy()
            ? ""
            : ".withAccuracy(Accuracy." + settings.accuracy().name() + ")";
    return "new RunSettings(" + String.join(", ", values) + ")" + accuracy;
  }

  private static String number(double value) {
    return Double.isInfinite(value) ? "Double.POSITIVE_INFINITY" : new NumberText().of(value);
  }

  private void poses(ModelPlan.Part poses) {
    source.blank().line("@Override").open("public List<String> bodies()");
    source.line("return List.of((" + JavaText.literal(plan.bodyNames()) + ").split(\"\\n\", -1));");
    source.close();
    int perBody = BodyPoses.NUMBERS_PER_BODY;
    method(
        poses,
        List.of(),
        List.of(
            "// Of the two sets of Euler parameters of an orientation the one with e0 >= 0.",
            "for (int i = 3; i < poses.length; i += " + perBody + ") {",
            "  if (poses[i] < 0) {",
            "    for (int j = i; j < i + 4; j++) {",
            "      poses[j] = 0 - poses[j];",
            "    }",
            "  }",
            "}"));
  }

  private void forces(ModelPlan.Part forces) {
    source.blank().line("@Override").open("public List<Variable> columns(ColumnGroup group)");
    source.line("List<Variable> columns = new ArrayList<>();");
    source.open("if (group == ColumnGroup.FORCES)");
    source.line(
        "String[] names = (" + JavaText.literal(plan.forceNames()) + ").split(\"\\n\", -1);");
    source.line(
        "String[] units = (" + JavaText.literal(plan.forceUnits()) + ").split(\"\\n\", -1);");
    source.open("for (int i = 0; i < names.length; i++)");
    source.line("columns.add(new Variable(names[i], units[i]));");
    source.close().close();
    source.line("return columns;").close();
    source.blank().line("@Override");
    source.open(
        "public void values(ColumnGroup group, double t, double[] y, double[] values, int at)");
    source.open("if (group == ColumnGroup.FORCES)");
    source.line("forces(t, y, forces);");
    source.line("System.arraycopy(forces, 0, values, at, forces.length);");
    source.close().close();
    method(forces, List.of(), List.of());
  }

  private void directedForce(String names) {
    source.blank().line("@Override").open("public String directedForce(int force)");
    source.line("return (" + JavaText.literal(names) + ").split(\"\\n\", -1)[force];");
    source.close();
  }

  private void formulas(ModelPlan.Part part) {
    ModelClass.FormulaParts parts = plan.content().formulas().orElseThrow();
    source.blank().line("@Override").open("public String formulas()");
    source.line("return " + JavaText.literal(parts.lines()) + ";").close();
    source.blank().line("@Override").open("public int formulaCount()");
    source.line("return " + parts.count() + ";").close();
    method(part, List.of(), List.of());
  }

  private void method(ModelPlan.Part part, List<String> first, List<String> last) {
    new ProgramPrinter(source, part.head(), part.plan()).method(first, last);
  }
}
