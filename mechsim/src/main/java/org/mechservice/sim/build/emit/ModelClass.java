package org.mechservice.sim.build.emit;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import org.mechservice.sim.symbolic.Program;
import org.mechservice.solver.api.BodyPoses;
import org.mechservice.solver.api.JointVariables;
import org.mechservice.solver.api.ModelDescription;
import org.mechservice.solver.api.RunSettings;
import org.mechservice.solver.mechanism.Body;
import org.mechservice.solver.mechanism.Joint;
import org.mechservice.solver.mechanism.Mechanism;

/**
 * Writes the class of a model.
 *
 * <p>The class is written to be read: values carry the names of mechanics, every stretch says which
 * body and joint it is about and which equation it evaluates. It is also written to be small: no
 * method, array or constant that the scene does not need.
 *
 * @param mechanism the model
 * @param description what it says of itself
 * @param derivative program from [q; v] to [q'; v']
 * @param energy program from [q; v] to kinetic and potential energy
 * @param poses program from [q; v] to the poses of the bodies, if they are asked for
 * @param notes further paragraphs of the class comment, for people
 */
public record ModelClass(
    Mechanism mechanism,
    ModelDescription description,
    Program derivative,
    Program energy,
    Optional<Program> poses,
    List<String> notes) {
  /** The package of generated models. */
  public static final String PACKAGE = "org.mechservice.model";

  private static final String LEGEND =
      "Names: omega, alpha, a: angular velocity, angular acceleration and acceleration of the origin"
          + " of a body's computing frame; W: alpha x + omega x omega x; f, n: force and moment the"
          + " body needs, all while no joint accelerates. J, H, M: articulated inertia; D, kn, kf: its"
          + " element on the joint's axis and its column there over D; u: joint force less f, n along"
          + " the axis; dalpha, da: what joint accelerations add. The origin of a computing frame is"
          + " the joint's point on the body, its z axis lies along the joint; R, X take it to the"
          + " parent's, where the joint is at r.";

  /** Returns the class's simple name. */
  public String simpleName() {
    return JavaText.className(description.name());
  }

  /** Returns the formatted source. */
  public String source() {
    ProgramPlan derivativePlan = Planner.plan(derivative);
    ProgramPlan energyPlan = Planner.plan(energy);
    Optional<ProgramPlan> posesPlan = poses.map(Planner::plan);
    int slots = Math.max(derivativePlan.slots(), energyPlan.slots());
    slots = Math.max(slots, posesPlan.map(ProgramPlan::slots).orElse(0));
    SourceLines source = new SourceLines();
    header(source, slots > 0);
    if (slots > 0) {
      source.line("private final double[] w = new double[" + slots + "];");
    }
    describe(source);
    initialState(source);
    new ProgramPrinter(source, "derivative", "yDot", derivativePlan).method(List.of());
    new ProgramPrinter(source, "energy", "energy", energyPlan).method(List.of());
    posesPlan.ifPresent(plan -> poses(source, plan));
    return source.close().toString();
  }

  private void header(SourceLines source, boolean angles) {
    source.line("package " + PACKAGE + ";").blank();
    List<String> imports = new ArrayList<>();
    imports.add("java.util.Arrays");
    imports.add("org.mechservice.solver.api.Energies");
    imports.add("org.mechservice.solver.api.ExplicitModel");
    imports.add("org.mechservice.solver.api.ModelDescription");
    imports.add("org.mechservice.solver.api.RunSettings");
    if (angles) {
      imports.add("org.mechservice.solver.spatial.SinCos");
    }
    if (poses.isPresent()) {
      imports.add("java.util.List");
      imports.add("org.mechservice.solver.api.BodyPoses");
    }
    imports.stream().sorted().forEach(name -> source.line("import " + name + ";"));
    source.blank().documentation(documentation());
    source.open(
        "public final class "
            + simpleName()
            + " implements ExplicitModel, Energies"
            + (poses.isPresent() ? ", BodyPoses" : ""));
  }

  private List<String> documentation() {
    List<String> lines = new ArrayList<>();
    lines.add(
        JavaText.comment(
            "Equations of motion of model \"" + description.name() + "\", generated."));
    for (String note : notes) {
      lines.add("");
      lines.add("<p>" + JavaText.comment(note));
    }
    lines.add("");
    lines.add("<p>" + LEGEND);
    lines.add("");
    lines.add("<p>State y = [q; v]:");
    lines.add("");
    lines.add("<ul>");
    int n = description.joints().size();
    for (int i = 0; i < n; i++) {
      JointVariables joint = description.joints().get(i);
      String units = joint.type().positionUnit(0) + ", " + joint.type().velocityUnit(0);
      lines.add(
          JavaText.comment(
                  "  [li]y[%d], y[%d]: joint %s (%s), %s"
                      .formatted(i, n + i, joint.name(), joint.type(), units))
              .replace("[li]", "<li>"));
    }
    lines.add("</ul>");
    return lines;
  }

  private void describe(SourceLines source) {
    String types =
        description.joints().stream()
            .map(joint -> joint.type().name())
            .collect(Collectors.joining(" "));
    String names =
        description.joints().stream().map(JointVariables::name).collect(Collectors.joining("\n"));
    source.blank().line("@Override").open("public ModelDescription description()");
    source.line("return ModelDescription.of(");
    source.line("    " + JavaText.literal(description.name()) + ",");
    source.line("    " + JavaText.literal(description.formulation()) + ",");
    source.line("    " + JavaText.literal(types) + ",");
    source.line("    " + JavaText.literal(names) + ",");
    source.line("    new RunSettings(" + settings(description.defaults()) + "));");
    source.close();
  }

  private static String settings(RunSettings settings) {
    List<String> values = new ArrayList<>();
    values.add(number(settings.tStart()));
    values.add(number(settings.tEnd()));
    values.add(number(settings.tStep()));
    values.add(JavaText.literal(settings.integrator()));
    values.add(number(settings.relativeTolerance()));
    values.add(number(settings.absoluteTolerance()));
    RunSettings automatic =
        new RunSettings(
            settings.tStart(),
            settings.tEnd(),
            settings.tStep(),
            settings.integrator(),
            settings.relativeTolerance(),
            settings.absoluteTolerance());
    if (!settings.equals(automatic)) {
      values.add(number(settings.maxStep()));
      values.add(number(settings.initialStep()));
      values.add(Integer.toString(settings.maxOrder()));
    }
    return String.join(", ", values);
  }

  private static String number(double value) {
    return Double.isInfinite(value) ? "Double.POSITIVE_INFINITY" : new NumberText().of(value);
  }

  private void initialState(SourceLines source) {
    double[] y = new double[description.stateCount()];
    mechanism.initialState(y);
    source.blank().line("@Override").open("public void initialState(double[] y)");
    source.line("Arrays.fill(y, 0.0);");
    for (int i = 0; i < y.length; i++) {
      if (y[i] != 0) {
        source.line("y[" + i + "] = " + new NumberText().of(y[i]) + ";");
      }
    }
    source.close();
  }

  private void poses(SourceLines source, ProgramPlan plan) {
    String names = mechanism.bodies().stream().map(Body::name).collect(Collectors.joining("\n"));
    source.blank().line("@Override").open("public List<String> bodies()");
    source.line("return List.of((" + JavaText.literal(names) + ").split(\"\\n\", -1));");
    source.close();
    int perBody = BodyPoses.NUMBERS_PER_BODY;
    new ProgramPrinter(source, "poses", "poses", plan)
        .method(
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

  /** Returns the joints of a mechanism as the description lists them. */
  public static List<JointVariables> joints(Mechanism mechanism) {
    return mechanism.joints().stream().map(ModelClass::variables).toList();
  }

  private static JointVariables variables(Joint joint) {
    return new JointVariables(joint.name(), joint.type());
  }
}
