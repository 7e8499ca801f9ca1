package org.mechservice.sim.check;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.mechservice.sim.scene.LoopAnalysis;
import org.mechservice.sim.scene.LoopEntry;
import org.mechservice.sim.scene.RoadmapEntry;
import org.mechservice.sim.scene.SceneAnalysis;
import org.mechservice.solver.mechanism.FurtherState;
import org.mechservice.solver.text.ShortestDecimal;

/** A check's report as text. */
final class CheckText {
  private final CheckReport report;
  private final StringBuilder text = new StringBuilder();

  CheckText(CheckReport report) {
    this.report = report;
  }

  String text() {
    SceneAnalysis scene = report.scene();
    text.append(scene.mechanism().name()).append("\n\n");
    TreeDrawing.of(scene.mechanism()).forEach(line -> text.append("  ").append(line).append('\n'));
    loops();
    text.append('\n').append(freedoms()).append('\n');
    formulation();
    roadmap();
    if (!scene.mechanism().forces().isEmpty()) {
      list("Forces besides gravity", scene.forces());
    }
    if (!report.model().unused().isEmpty()) {
      list("Not used", report.model().unused());
    }
    if (!report.model().dataFiles().isEmpty()) {
      list("Data files", report.model().dataFiles());
    }
    list("Warnings", report.warnings());
    if (!scene.offers().isEmpty()) {
      list("Could be simpler", scene.offers());
    }
    report
        .generation()
        .ifPresent(
            generation ->
                list(
                    "Left out of the generated class",
                    generation.leftOut().stream()
                        .map(omission -> omission.what() + ": " + omission.why())
                        .toList()));
    report.refusal().ifPresent(why -> list(CheckReport.UNUSABLE, List.of(why)));
    return text.toString();
  }

  private void loops() {
    List<LoopEntry> loops = report.loops().loops();
    if (loops.isEmpty()) {
      return;
    }
    List<String> lines = new ArrayList<>();
    for (LoopEntry loop : loops) {
      lines.add(
          String.format(
              Locale.ROOT,
              "%s (%s): %s; %d equation%s; at the start %.1e %s, %.1e %s/s",
              loop.name(),
              loop.kind(),
              closing(loop),
              loop.equations(),
              loop.equations() == 1 ? "" : "s",
              loop.positionResidual(),
              loop.unit(),
              loop.velocityResidual(),
              loop.unit()));
    }
    list("Loops", lines);
  }

  private static String closing(LoopEntry loop) {
    if (loop.bodies().isEmpty()) {
      return "between coordinates";
    }
    return String.join(" - ", loop.bodies())
        + (loop.path().isEmpty() ? "" : ", closing " + String.join(" - ", loop.path()));
  }

  private String freedoms() {
    LoopAnalysis loops = report.loops();
    int massless = report.scene().massless().size();
    double rods = report.scene().rodMass();
    return "Degrees of freedom: "
        + report.degreesOfFreedom()
        + (loops.loops().isEmpty() ? "" : " (" + count(loops) + ")")
        + "; bodies: "
        + report.scene().mechanism().bodies().size()
        + (massless == 0 ? "" : " (" + massless + " massless)")
        + "; mass: "
        + ShortestDecimal.format(report.scene().mass() + rods)
        + " kg"
        + (rods == 0 ? "" : " (rods " + ShortestDecimal.format(rods) + ")")
        + "; loops: "
        + loops.loops().size()
        + "; redundant equations: "
        + (loops.isJudged() ? loops.redundant() : "not judged");
  }

  private String count(LoopAnalysis loops) {
    String tree = report.scene().degreesOfFreedom() + " of the tree less ";
    String equations = loops.equations() + (loops.equations() == 1 ? " equation" : " equations");
    return loops.isJudged()
        ? tree
            + loops.independent()
            + " independent of "
            + equations
            + (loops.redundant() == 0 ? "" : "; by count alone " + report.freedomsByCount())
        : tree + equations + ", by count alone";
  }

  private void formulation() {
    report
        .generation()
        .ifPresentOrElse(
            generation ->
                text.append("Formulation: ")
                    .append(generation.choice().formulation())
                    .append(" (")
                    .append(generation.choice().reason())
                    .append(operations(generation.operations())),
            () -> text.append("Formulation: none: ").append(report.noGeneration()).append('\n'));
  }

  private static String operations(int count) {
    return count == 0 ? ")\n" : "), " + count + " operations per evaluation\n";
  }

  private void roadmap() {
    List<FurtherState> further = report.scene().mechanism().furtherStates();
    text.append(further.isEmpty() ? "\nState y = [q; v]:\n" : "\nState y = [q; v; s]:\n");
    int names = report.roadmap().stream().mapToInt(e -> e.joint().length()).max().orElse(0);
    int places = report.roadmap().stream().mapToInt(e -> place(e).length()).max().orElse(0);
    for (RoadmapEntry entry : report.roadmap()) {
      text.append("  ")
          .append(padded(place(entry), places))
          .append("  ")
          .append(padded(entry.joint(), names))
          .append("  ")
          .append(entry.type())
          .append(entry.positionUnit().isEmpty() ? "" : "  " + entry.positionUnit() + ", ")
          .append(entry.velocityUnit())
          .append(entry.axis().isEmpty() ? "" : "  axis " + entry.axis())
          .append(entry.driven() ? "  driven" : "")
          .append('\n');
    }
    for (int i = 0; i < further.size(); i++) {
      FurtherState state = further.get(i);
      text.append("  s[" + i + "]  " + state.name() + "  " + state.unit() + "  start ")
          .append(ShortestDecimal.format(state.start()))
          .append('\n');
    }
  }

  private static String padded(String word, int width) {
    return word + " ".repeat(width - word.length());
  }

  private static String place(RoadmapEntry entry) {
    return range("q", entry.position(), entry.type().positionCount(), entry.driven())
        + " "
        + range("v", entry.velocity(), entry.type().velocityCount(), entry.driven());
  }

  /** Returns {@code q[3]} or {@code q[3..9]}; {@code q[-]} if the joint has no state. */
  private static String range(String letter, int from, int count, boolean driven) {
    if (driven || count == 0) {
      return letter + "[-]";
    }
    return letter + "[" + from + (count == 1 ? "" : ".." + (from + count - 1)) + "]";
  }

  private void list(String title, List<String> lines) {
    text.append('\n').append(title).append(lines.isEmpty() ? ": none\n" : ":\n");
    lines.forEach(line -> text.append("  ").append(line).append('\n'));
  }
}
