package org.mechservice.report.stability;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.mechservice.report.measure.MeasuredRun;
import org.mechservice.report.measure.MethodRunner;
import org.mechservice.report.measure.ReportProgress;
import org.mechservice.report.method.BuildRefusedException;
import org.mechservice.report.method.Candidate;
import org.mechservice.report.method.MethodList;
import org.mechservice.report.method.ModelProblem;
import org.mechservice.report.solution.Judge;
import org.mechservice.report.solution.PublishedReference;
import org.mechservice.report.solution.Reference;
import org.mechservice.report.solution.ReferenceMaker;
import org.mechservice.report.solution.RunGrid;
import org.mechservice.report.solution.StateDistance;
import org.mechservice.solver.api.capability.ExplicitModel;
import org.mechservice.solver.api.run.RunSettings;

/** Runs the suite of stiff and extreme scenes with every method that fits, and writes its page. */
public final class StabilityReport {
  private static final int INTERVALS = 4;

  private final SuiteBuilds builds;
  private final SuiteTimeBudget budget;
  private final ReportProgress progress;

  /**
   * @param builds builds the models of the cases
   * @param budget of time, which begins when it is made
   */
  public StabilityReport(SuiteBuilds builds, SuiteTimeBudget budget, ReportProgress progress) {
    this.builds = builds;
    this.budget = budget;
    this.progress = progress;
  }

  /**
   * Runs cases and writes their page.
   *
   * @param suite cases, in the order of the page
   * @return outcomes, in the order of the suite
   * @throws IOException if the page cannot be written
   */
  public List<CaseOutcome> write(Path page, List<ExtremeCase> suite) throws IOException {
    List<CaseOutcome> outcomes = new ArrayList<>();
    for (ExtremeCase wanted : suite) {
      double done = (double) outcomes.size() / suite.size();
      double left = done == 0 ? Double.NaN : budget.elapsed() * (1 - done) / done;
      progress.at(wanted.name(), done, left);
      budget.beginCase(suite.size() - outcomes.size());
      outcomes.add(run(wanted));
    }
    Files.createDirectories(page.toAbsolutePath().getParent());
    Files.writeString(page, StabilityPage.of(outcomes, budget.sentence()), StandardCharsets.UTF_8);
    return outcomes;
  }

  /** Runs one case. */
  public CaseOutcome run(ExtremeCase wanted) {
    SuiteBuilds.Built built;
    try {
      built = builds.build(wanted);
    } catch (BuildRefusedException e) {
      return new CaseOutcome(wanted, List.of(), e.reason(), List.of(), "");
    }
    return run(wanted, built.methods(), built.warnings());
  }

  private CaseOutcome run(ExtremeCase wanted, MethodList methods, List<String> warnings) {
    List<Candidate> candidates = methods.candidates();
    ExplicitModel model = candidates.get(0).equations();
    StateDistance distance = new StateDistance(model.description());
    Judge judge = judge(wanted, candidates, model, distance);
    Reference reference = judge.reference().orElseGet(() -> unknown(model));
    RunGrid grid = judge.reference().isPresent() ? judge.grid() : wholeRun(model);
    List<MethodOutcome> outcomes = new ArrayList<>();
    try (MethodRunner runner = new MethodRunner(reference, distance, grid)) {
      for (Candidate candidate : candidates) {
        double limit = budget.forRun(candidates.size() - outcomes.size());
        MeasuredRun run = runner.run(candidate, wanted.tolerance(), 0, limit);
        if (run.completed() && judge.reference().isEmpty()) {
          run = run.withoutErrors();
        }
        outcomes.add(MethodOutcome.of(candidate.method(), run, wanted));
      }
    }
    String said = (judge.doubt() + " " + String.join(" ", judge.said())).strip();
    return new CaseOutcome(wanted, outcomes, "", warnings, said);
  }

  private static RunGrid wholeRun(ExplicitModel model) {
    RunSettings settings = model.description().defaults();
    double length = settings.tEnd() - settings.tStart();
    return length > 0
        ? RunGrid.uniform(settings.tStart(), settings.tEnd(), INTERVALS)
        : new RunGrid(settings.tStart(), settings.tStep(), 1);
  }

  private Judge judge(
      ExtremeCase wanted, List<Candidate> candidates, ExplicitModel model, StateDistance distance) {
    RunGrid grid = wholeRun(model);
    if (wanted.judge() != ExtremeCase.JudgedBy.REFERENCE) {
      return new Judge(Optional.empty(), grid, List.of(), "");
    }
    Map<String, ReferenceMaker.Source> sources = new LinkedHashMap<>();
    for (Candidate candidate : candidates) {
      String name = candidate.method().formulation();
      sources.putIfAbsent(name, new ReferenceMaker.Source(name, candidate::problem));
    }
    double end = model.description().defaults().tEnd();
    Optional<PublishedReference> published =
        PublishedReference.of(wanted.name(), candidates.get(0).problem(), end, distance);
    if (published.isPresent() && RunGrid.meeting(published.get().times()).isPresent()) {
      RunGrid meeting = RunGrid.meeting(published.get().times()).orElseThrow();
      return Judge.ofBound(Optional.of(Judge.given(published.get())), meeting, wanted.bound());
    }
    double limit = budget.forRun(candidates.size() + 2 * sources.size());
    ReferenceMaker maker = new ReferenceMaker(distance, 2 * limit);
    List<ReferenceMaker.Source> all = List.copyOf(sources.values());
    ReferenceMaker.Extent extent = maker.extent(all.get(0), grid);
    Optional<Reference> made =
        maker.make(all, extent.grid().times()).map(reference -> reference.saying(extent.why()));
    return Judge.ofBound(made, extent.grid(), wanted.bound());
  }

  /** Stands for a reference where there is none: the start, at start and end. */
  private static Reference unknown(ExplicitModel model) {
    RunSettings settings = model.description().defaults();
    double[] start = new ModelProblem(model).start();
    double[] times = {settings.tStart(), settings.tEnd()};
    double[] none = new double[2];
    return new Reference(
        times, new double[][] {start, start}, none, none, Optional.empty(), List.of());
  }
}
