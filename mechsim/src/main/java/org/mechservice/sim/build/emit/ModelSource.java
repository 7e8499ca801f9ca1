package org.mechservice.sim.build.emit;

import java.util.ArrayList;
import java.util.List;
import org.mechservice.solver.api.BodyPoses;
import org.mechservice.solver.api.JointVariables;
import org.mechservice.solver.api.ModelDescription;
import org.mechservice.solver.api.RunSettings;

/**
 * Writes the class of a model as Java source.
 *
 * <p>The class is written to be read: values carry the names of mechanics, every stretch says which
 * body and joint it is about and which equation it evaluates. It is also written to be small: no
 * method, array or constant that the scene does not need.
 */
final class ModelSource {
  private static final String LEGEND =
      "Names: omega, alpha, a: angular velocity, angular acceleration and acceleration of the origin"
          + " of a body's computing frame; W: alpha x + omega x omega x; f, n: force and moment the"
          + " body needs, all while no joint accelerates. J, H, M: articulated inertia; D, kn, kf: its"
          + " element on the joint's axis and its column there over D; u: joint force less f, n along"
          + " the axis; dalpha, da: what joint accelerations add. The origin of a computing frame is"
          + " the joint's point on the body, its z axis lies along the joint; R, X take it to the"
          + " parent's, where the joint is at r.";

  private final ModelPlan plan;
  private final SourceLines source = new SourceLines();

  ModelSource(ModelPlan plan) {
    this.plan = plan;
  }

  /** Returns the formatted source. */
  String text() {
    int slots = plan.slots();
    header(slots > 0);
    if (slots > 0) {
      source.line("private final double[] w = new double[" + slots + "];");
    }
    describe();
    method(plan.start(), List.of("Arrays.fill(y, 0.0);"), List.of());
    plan.programs().forEach(part -> method(part, List.of(), List.of()));
    plan.poses().ifPresent(this::poses);
    return source.close().toString();
  }

  private void header(boolean angles) {
    source.line("package " + ModelClass.PACKAGE + ";").blank();
    List<String> imports = new ArrayList<>();
    imports.add("java.util.Arrays");
    imports.add("org.mechservice.solver.api.Energies");
    imports.add("org.mechservice.solver.api.ExplicitModel");
    imports.add("org.mechservice.solver.api.ModelDescription");
    imports.add("org.mechservice.solver.api.RunSettings");
    if (angles) {
      imports.add("org.mechservice.solver.spatial.SinCos");
    }
    if (plan.poses().isPresent()) {
      imports.add("java.util.List");
      imports.add("org.mechservice.solver.api.BodyPoses");
    }
    imports.stream().sorted().forEach(name -> source.line("import " + name + ";"));
    source.blank().documentation(documentation());
    source.open(
        "public final class "
            + plan.simpleName()
            + " implements ExplicitModel, Energies"
            + (plan.poses().isPresent() ? ", BodyPoses" : ""));
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

  private void describe() {
    ModelDescription description = plan.content().description();
    source.blank().line("@Override").open("public ModelDescription description()");
    source.line("return ModelDescription.of(");
    source.line("    " + JavaText.literal(description.name()) + ",");
    source.line("    " + JavaText.literal(description.formulation()) + ",");
    source.line("    " + JavaText.literal(plan.jointTypes()) + ",");
    source.line("    " + JavaText.literal(plan.jointNames()) + ",");
    source.line("    new RunSettings(" + settings(description.defaults()) + "));");
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
    return String.join(", ", values);
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

  private void method(ModelPlan.Part part, List<String> first, List<String> last) {
    new ProgramPrinter(source, part.head(), part.plan()).method(first, last);
  }
}
