package org.mechservice.benchmarks.study;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.mechservice.client.MechSession;
import org.mechservice.report.measure.MeasuredRun;
import org.mechservice.report.measure.MethodRunner;
import org.mechservice.report.method.Candidate;
import org.mechservice.report.page.SolverChart;
import org.mechservice.report.solution.Reference;
import org.mechservice.report.solution.RunGrid;
import org.mechservice.report.solution.StateDistance;
import org.mechservice.solver.api.capability.ExplicitModel;

/** Error against the distance at which a singular position is passed, for each closure. */
final class SingularStudy implements MethodStudy {
  private static final double[] DISTANCES = {1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8};
  private static final double TOLERANCE = 1e-8;

  /** The bars lie in line at 0.457 s, s. */
  private static final double PASSED = 0.5;

  private final StudyContext context;
  private final double limit;
  private final double referenceLimit;

  SingularStudy(StudyContext context) {
    this.context = context;
    limit = context.quick() ? 2 : 20;
    referenceLimit = context.quick() ? 3 : 120;
  }

  @Override
  public String name() {
    return "singular";
  }

  @Override
  public void measure(StudyPage page) {
    page.title("Error against the distance to a singular position");
    page.notes(
        "A four-bar that falls through the position in which all its bars lie in line; its coupler"
            + " is longer than the gap by the distance. 2 s, tolerance %.0e; error against a"
            + " reference made for every distance, whose floor is shown: the motion along the curve"
            + " of positions, by two codes, without equations of loops. An ending with a message is"
            + " an honest one.",
        TOLERANCE);
    StudyPage.Table table =
        page.table(
            "Passages",
            "distance, m",
            "method",
            "error",
            "reference known to",
            "judged until, s",
            "energy drift",
            "steps",
            "rejected",
            "ended");
    Map<String, List<SolverChart.Value>> curves = new LinkedHashMap<>();
    Map<String, Double> last = new LinkedHashMap<>();
    for (double distance : DISTANCES) {
      context.at("distance " + StudyContext.number(distance), -Math.log10(distance) / 8);
      String text =
          StudyContext.replaced(
              StudyContext.scene("line_with_1e-12_to_spare.xml"), "3+1e-12", "3+" + distance);
      context.with(text, session -> passage(session, distance, table, curves, last));
    }
    SolverChart chart = new SolverChart("distance, m", "largest error over time");
    curves.forEach(chart::add);
    page.shows("Error against distance", chart);
    last.forEach(
        (method, distance) ->
            page.finds(
                "%s: passed with an error below 1e-4, or below what the reference is known to, down"
                    + " to a distance of %s m.",
                method, StudyContext.number(distance)));
    StudyContext.WITH_LOOPS.stream()
        .filter(method -> !last.containsKey(method.name()))
        .forEach(method -> page.finds("%s: at no distance looked at.", method.name()));
  }

  private Boolean passage(
      MechSession session,
      double distance,
      StudyPage.Table table,
      Map<String, List<SolverChart.Value>> curves,
      Map<String, Double> last) {
    List<Candidate> candidates =
        StudyContext.WITH_LOOPS.stream()
            .map(method -> StudyContext.compact(session, method))
            .toList();
    ExplicitModel model = candidates.get(0).equations();
    StateDistance measure = new StateDistance(model.description());
    RunGrid grid = RunGrid.uniform(0, model.description().defaults().tEnd(), 20);
    double[] start = new double[model.description().stateCount()];
    model.initialState(start);
    Optional<Reference> made =
        FourBarInLine.reference(distance, start, grid.times(), measure, referenceLimit);
    if (made.isEmpty()) {
      table.row(
          distance,
          "none",
          Double.NaN,
          Double.NaN,
          Double.NaN,
          Double.NaN,
          0,
          0,
          "no reference within its time");
      return false;
    }
    Reference reference = made.get();
    double floor = reference.worstFloor();
    try (MethodRunner runner = new MethodRunner(reference, measure, grid)) {
      for (Candidate candidate : candidates) {
        MeasuredRun run = runner.run(candidate, TOLERANCE, 0, limit);
        String name = candidate.method().name();
        double error = run.errors().largest();
        table.row(
            distance,
            name,
            error,
            floor,
            reference.end(),
            run.energyDrift(),
            run.steps(),
            run.rejected(),
            run.completed() ? "yes" : run.cause());
        if (run.completed() && error > 0) {
          curves
              .computeIfAbsent(name, key -> new ArrayList<>())
              .add(new SolverChart.Value(distance, error, name + ": " + StudyPage.shown(error)));
        }
        boolean passed = reference.end() > PASSED;
        if (run.completed() && passed && error < Math.max(1e-4, 2 * floor)) {
          last.put(name, distance);
        }
      }
    }
    return true;
  }
}
