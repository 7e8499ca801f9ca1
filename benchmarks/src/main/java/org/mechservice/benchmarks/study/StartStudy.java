package org.mechservice.benchmarks.study;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import org.mechservice.client.MechSession;
import org.mechservice.client.SessionBuilds;
import org.mechservice.client.failure.ServiceException;
import org.mechservice.report.measure.LoopForces;
import org.mechservice.report.method.Candidate;
import org.mechservice.report.method.SimulationMethod;
import org.mechservice.report.page.SolverChart;
import org.mechservice.report.solution.StateDistance;
import org.mechservice.solver.api.Model;
import org.mechservice.solver.api.result.ColumnGroup;
import org.mechservice.solver.api.run.RunNotes;
import org.mechservice.solver.catalogue.MessageCode;

/**
 * Starts off the constraint manifold: how far the assembly moves them, and the remaining difference
 * at the end.
 */
final class StartStudy implements MethodStudy {
  private static final double[] OFFSETS = {
    1e-12, 1e-11, 1e-10, 1e-9, 1e-8, 1e-7, 1e-6, 1e-5, 1e-4, 1e-3, 1e-2
  };
  private static final double[] QUICK_OFFSETS = {1e-12, 1e-10, 1e-8, 1e-6, 1e-4, 1e-2};
  private static final double TOLERANCE = 1e-9;
  private static final String GIVEN_POSITIONS = "posVals=\"1\" velVals=\"0\"";

  private final StudyContext context;

  StartStudy(StudyContext context) {
    this.context = context;
  }

  @Override
  public String name() {
    return "start";
  }

  @Override
  public void measure(StudyPage page) {
    page.title("Starts off the manifold");
    page.notes(
        "A four-bar whose coupler is too long for the start given, by the offset in m; or whose"
            + " start velocities differ by the offset in rad/s. Moved: by how much the start was"
            + " corrected. Left at the end: difference after 1 s from a run started at the"
            + " corrected values written with 17 digits, tolerance %.0e.",
        TOLERANCE);
    StudyPage.Table table =
        page.table(
            "Starts",
            "off in",
            "offset",
            "method",
            "moved",
            "Φ after",
            "Φ' after",
            "left at the end",
            "what was said");
    SolverChart chart = new SolverChart("offset", "start moved by");
    List<SolverChart.Value> positions = new ArrayList<>();
    List<SolverChart.Value> velocities = new ArrayList<>();
    double worstResidual = 0;
    double worstLeft = 0;
    List<String> failures = new ArrayList<>();
    double firstSaid = Double.POSITIVE_INFINITY;
    double[] offsets = context.quick() ? QUICK_OFFSETS : OFFSETS;
    for (double offset : offsets) {
      context.at("offset " + StudyContext.number(offset), 0.5);
      for (boolean ofPositions : new boolean[] {true, false}) {
        for (SimulationMethod method : StudyContext.WITH_LOOPS) {
          Outcome outcome = outcome(offset, ofPositions, method);
          table.row(
              ofPositions ? "position" : "velocity",
              offset,
              method.name(),
              outcome.moved(),
              outcome.open(),
              outcome.opening(),
              outcome.left(),
              outcome.said());
          worstResidual = Math.max(worstResidual, Math.max(outcome.open(), outcome.opening()));
          if (Double.isNaN(outcome.left())) {
            failures.add(
                method
                    + " with "
                    + (ofPositions ? "positions" : "velocities")
                    + " off by "
                    + StudyContext.number(offset));
          } else {
            worstLeft = Math.max(worstLeft, outcome.left());
          }
          if (outcome.said().contains(MessageCode.START_POSITION_CORRECTED.code())) {
            firstSaid = Math.min(firstSaid, offset);
          }
          if (method.equals(StudyContext.WITH_LOOPS.get(0)) && outcome.moved() > 0) {
            (ofPositions ? positions : velocities)
                .add(
                    new SolverChart.Value(
                        offset, outcome.moved(), StudyPage.shown(outcome.moved())));
          }
        }
      }
    }
    chart.add("positions, rad", positions);
    chart.add("velocities, rad/s", velocities);
    page.shows("What the assembly moves", chart);
    page.finds(
        "After the assembly loops are open by %.1e at most (m, and m/s), whatever the offset.",
        worstResidual);
    page.finds(
        "At the end the run differs by %.1e at most from one started at the corrected values.",
        worstLeft);
    if (!failures.isEmpty()) {
      page.finds("Not run to the end, with a message: %s.", String.join("; ", failures));
    }
    page.finds(
        Double.isInfinite(firstSaid)
            ? "No correction was spoken of."
            : "Corrections are spoken of from an offset of %s on.",
        StudyContext.number(firstSaid));
  }

  private record Outcome(double moved, double open, double opening, double left, String said) {}

  private static String text(double offset, boolean ofPositions) {
    String scene = StudyContext.scene("start_off_1e-6.xml");
    if (ofPositions) {
      return StudyContext.replaced(scene, "3.000001", "3+" + offset);
    }
    String closed = StudyContext.replaced(scene, "3.000001", "3");
    int last = closed.lastIndexOf("velVals=\"0\"");
    return closed.substring(0, last).replace("velVals=\"0\"", "velVals=\"0.5\"")
        + "velVals=\"0.5+"
        + offset
        + closed.substring(last + "velVals=\"0".length());
  }

  private Outcome outcome(double offset, boolean ofPositions, SimulationMethod method) {
    String text = text(offset, ofPositions);
    List<String> said = new ArrayList<>();
    try {
      said.addAll(context.warnings(text));
      return context.with(text, session -> outcome(session, text, ofPositions, method, said));
    } catch (ServiceException e) {
      String why = String.valueOf(e.getMessage());
      return new Outcome(Double.NaN, Double.NaN, Double.NaN, Double.NaN, why);
    }
  }

  private Outcome outcome(
      MechSession session,
      String text,
      boolean ofPositions,
      SimulationMethod method,
      List<String> said) {
    Candidate candidate = StudyContext.compact(session, method);
    Model model = candidate.models().get();
    double[] start = new double[model.description().stateCount()];
    model.initialState(start);
    double[] given = ofPositions ? new double[] {1, 1, 0, 0} : given(text);
    double moved = 0;
    for (int i = 0; i < start.length; i++) {
      moved = Math.max(moved, Math.abs(start[i] - given[i]));
    }
    StudyContext.Ran ran = StudyContext.run(candidate, 1, 1, TOLERANCE, 20);
    ran.report().notes().stream().map(RunNotes.Note::message).forEach(said::add);
    Optional<LoopForces> loops =
        LoopForces.of(
            session
                .fetchModel(
                    SessionBuilds.options(method)
                        .compact()
                        .columns(Set.of(ColumnGroup.CONSTRAINTS)))
                .newModel());
    double open = loops.map(known -> known.residual(0, start)).orElse(Double.NaN);
    double opening = loops.map(known -> known.residualRate(0, start)).orElse(Double.NaN);
    double left = ran.completed() ? left(text, start, method, ran) : Double.NaN;
    String words = String.join(" ", said.stream().distinct().toList());
    return new Outcome(moved, open, opening, left, ran.ending() + words);
  }

  private static double[] given(String text) {
    String value = text.substring(text.lastIndexOf("velVals=\"0.5+") + "velVals=\"0.5+".length());
    double offset = Double.parseDouble(value.substring(0, value.indexOf('"')));
    return new double[] {1, 1, 0.5, 0.5 + offset};
  }

  /** Difference at the end from the same run with the corrected start written out. */
  private double left(String text, double[] start, SimulationMethod method, StudyContext.Ran ran) {
    String exact =
        text.replaceFirst("name=\"j_left\" posVals=\"1\" velVals=\"[^\"]*", left(start, 0))
            .replaceFirst("name=\"j_right\" posVals=\"1\" velVals=\"[^\"]*", left(start, 1));
    if (exact.equals(text) && text.contains(GIVEN_POSITIONS) && start[0] != 1) {
      throw new IllegalStateException("the scene's start cannot be replaced");
    }
    return context.with(
        exact,
        session -> {
          Candidate candidate = StudyContext.compact(session, method);
          StudyContext.Ran again = StudyContext.run(candidate, 1, 1, TOLERANCE, 20);
          if (!again.completed()) {
            return Double.NaN;
          }
          StateDistance distance = new StateDistance(candidate.models().get().description());
          return distance.of(end(ran), end(again));
        });
  }

  private static String left(double[] start, int joint) {
    return String.format(
        Locale.ROOT,
        "name=\"%s\" posVals=\"%s\" velVals=\"%s",
        joint == 0 ? "j_left" : "j_right",
        start[joint],
        start[2 + joint]);
  }

  private static double[] end(StudyContext.Ran ran) {
    double[] row = ran.rows().get(ran.rows().size() - 1);
    return java.util.Arrays.copyOfRange(row, 1, row.length);
  }
}
