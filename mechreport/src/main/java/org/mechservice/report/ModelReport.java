package org.mechservice.report;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.mechservice.report.measure.Campaign;
import org.mechservice.report.measure.ColdRunTimes;
import org.mechservice.report.measure.ColdRunTiming;
import org.mechservice.report.measure.Effort;
import org.mechservice.report.measure.LoopForces;
import org.mechservice.report.measure.MeasuredRun;
import org.mechservice.report.measure.MeasurementFile;
import org.mechservice.report.measure.MethodRunner;
import org.mechservice.report.measure.Point;
import org.mechservice.report.measure.ReportBudget;
import org.mechservice.report.measure.ReportProgress;
import org.mechservice.report.measure.ReportedScene;
import org.mechservice.report.measure.SceneFindings;
import org.mechservice.report.measure.Spectrum;
import org.mechservice.report.measure.TimeShares;
import org.mechservice.report.method.Candidate;
import org.mechservice.report.method.MethodBuilds;
import org.mechservice.report.method.MethodList;
import org.mechservice.report.method.ModelProblem;
import org.mechservice.report.method.SimulationMethod;
import org.mechservice.report.page.ScenePage;
import org.mechservice.report.solution.Judge;
import org.mechservice.report.solution.PublishedReference;
import org.mechservice.report.solution.Reference;
import org.mechservice.report.solution.ReferenceFile;
import org.mechservice.report.solution.ReferenceMaker;
import org.mechservice.report.solution.RunGrid;
import org.mechservice.report.solution.StateDistance;
import org.mechservice.solver.api.capability.ExplicitModel;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.api.run.Stiffness;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.catalogue.MethodNames;

/** Error against run time of one model: measures it and writes its page. */
public final class ModelReport {
  private static final int OUTPUT_INTERVALS = 50;

  /** Part of the time for the report: one solution of the reference. */
  private static final double OF_REFERENCE = 0.15;

  /** Part of the time that is left: all solutions of the reference of a large mechanism. */
  private static final double OF_LARGE_REFERENCE = 0.3;

  /** What they may take at most, in times of one of a small mechanism, and least for that, s. */
  private static final double LARGE_SOLUTIONS = 4;

  private static final double LARGE_SECONDS = 60;

  /** Part of the time that is left: looks at the loops in the first runs of all points. */
  private static final double OF_LOOPS = 0.1;

  /** Part of the time left for the report that eigenvalues may take. */
  private static final double OF_SPECTRUM = 0.15;

  private final MethodBuilds builds;
  private final Path folder;
  private final Effort effort;
  private final ReportProgress progress;

  /**
   * @param builds builds the model
   * @param folder for the pages
   */
  public ModelReport(MethodBuilds builds, Path folder, Effort effort, ReportProgress progress) {
    this.builds = builds;
    this.folder = folder;
    this.effort = effort;
    this.progress = progress;
  }

  /**
   * Measures the model and writes its page and the data behind it. Throws what the builder refuses
   * the model with if it cannot be built.
   *
   * @param file the model's file, for its name
   * @return the page
   * @throws IOException if the page cannot be written
   * @throws InterruptedException if interrupted; what was measured is kept and taken up again
   */
  public Path write(Path file) throws IOException, InterruptedException {
    Files.createDirectories(folder);
    try {
      return measureAndWrite(file);
    } catch (FileSystemException e) {
      throw e;
    } catch (IOException e) {
      // such as a full disk, of which Java does not say where
      throw new IOException(
          MessageCode.FILE_UNUSABLE + " cannot write in folder " + folder + ": " + e.getMessage(),
          e);
    }
  }

  private Path measureAndWrite(Path file) throws IOException, InterruptedException {
    SceneFindings found = measure(String.valueOf(file.getFileName()));
    Path page = folder.resolve(ReportedScene.named(found.scene().file(), ".html"));
    Files.writeString(page, ScenePage.of(found), StandardCharsets.UTF_8);
    Path diagram = folder.resolve(ReportedScene.named(found.scene().file(), ".svg"));
    Files.writeString(diagram, ScenePage.diagram(found), StandardCharsets.UTF_8);
    return page;
  }

  private SceneFindings measure(String file) throws IOException, InterruptedException {
    ReportBudget budget = new ReportBudget(effort.budgetSeconds());
    progress.at("building the model in every formulation", 0, Double.NaN);
    MethodList methods = MethodList.of(builds);
    List<Candidate> candidates = methods.candidates();
    ExplicitModel model = candidates.get(0).equations();
    RunSettings settings = model.description().defaults();
    ModelProblem problem = new ModelProblem(model);
    ReportedScene scene =
        new ReportedScene(
            model.description().name(), file, freedoms(problem, model), settings.tEnd());
    StateDistance distance = new StateDistance(model.description());
    progress.at("making the reference", 0, Double.NaN);
    ReferenceFile kept =
        new ReferenceFile(folder.resolve(scene.reference()), purpose(file), model.description());
    Judge judge = judge(candidates, model, settings, distance, kept, budget);
    Optional<Spectrum> spectrum = spectrum(judge, model, budget);
    Map<String, TimeShares> shares = new LinkedHashMap<>();
    List<Point> points = List.of();
    if (judge.reference().isPresent()) {
      Reference reference = judge.reference().get();
      try (MeasurementFile journal =
              MeasurementFile.open(
                  folder.resolve(scene.runs()), purpose(file) + "; " + code(candidates.get(0)));
          MethodRunner runner =
              new MethodRunner(
                  reference, distance, judge.grid(), loops(candidates, reference, budget))) {
        List<MeasuredRun> leftOut =
            new Campaign(runner, journal, effort, budget, progress).run(candidates);
        points = Point.of(Stream.concat(journal.runs().stream(), leftOut.stream()).toList());
        shares.putAll(shares(candidates, points, runner, budget));
      }
    }
    Map<String, ColdRunTimes> fresh = freshStarts(candidates, points, judge, budget);
    return new SceneFindings(
        scene,
        candidates.stream().map(Candidate::method).toList(),
        methods.leftOut(),
        judge,
        points,
        spectrum,
        shares,
        fresh,
        effort,
        Machine.facts(),
        budget.savings());
  }

  /**
   * Residuals and multipliers of the scene's loops, at as many times as the report's time allows;
   * empty for an open chain, and where it allows none.
   */
  private Optional<LoopForces> loops(
      List<Candidate> candidates, Reference reference, ReportBudget budget) {
    SimulationMethod first = candidates.get(0).method();
    if (first.closure().equals(MethodNames.NONE)) {
      return Optional.empty();
    }
    int points = candidates.size() * effort.tolerances().length;
    return LoopForces.of(builds.withConstraints(first))
        .flatMap(loops -> loops.within(reference, points, OF_LOOPS * budget.left(), budget));
  }

  private static int freedoms(ModelProblem problem, ExplicitModel model) {
    int positions = model.description().positionCount();
    return (int)
        IntStream.range(positions, problem.dimension()).filter(problem::independent).count();
  }

  private Judge judge(
      List<Candidate> candidates,
      ExplicitModel model,
      RunSettings settings,
      StateDistance distance,
      ReferenceFile file,
      ReportBudget budget)
      throws IOException {
    RunGrid uniform = RunGrid.uniform(settings.tStart(), settings.tEnd(), OUTPUT_INTERVALS);
    List<ReferenceMaker.Source> sources = sources(candidates);
    double seconds = effort.referenceSeconds();
    double ofBudget = OF_REFERENCE * effort.budgetSeconds();
    ReferenceMaker maker =
        new ReferenceMaker(
            distance,
            Math.min(seconds, ofBudget),
            Math.min(
                LARGE_SOLUTIONS * Math.max(seconds, LARGE_SECONDS),
                OF_LARGE_REFERENCE * budget.left()));
    Optional<PublishedReference> published =
        PublishedReference.of(
            model.description().name(), candidates.get(0).problem(), settings.tEnd(), distance);
    Optional<ReferenceFile.Kept> kept = file.read();
    RunGrid grid = kept.map(ReferenceFile.Kept::grid).orElse(uniform);
    Optional<Reference> made = kept.map(ReferenceFile.Kept::reference);
    if (made.isEmpty()) {
      ReferenceMaker.Extent extent = maker.extent(sources.get(0), uniform);
      grid = extent.grid();
      made =
          maker
              .make(sources, times(published, sources.get(0), grid))
              .map(reference -> reference.saying(extent.why()));
      if (made.isPresent()) {
        file.write(made.get(), grid);
      } else if (ofBudget < seconds) {
        budget.saves(
            "A code had "
                + ReportBudget.inWords(ofBudget)
                + " in place of "
                + ReportBudget.inWords(seconds)
                + " to make the reference. Without one nothing was measured.");
      }
    }
    return Judge.of(published, made, distance, grid);
  }

  /** Times of the product's own reference, if it has one. */
  private static double[] times(
      Optional<PublishedReference> published, ReferenceMaker.Source source, RunGrid grid) {
    double[] all = Judge.times(published, grid);
    return published.isPresent() ? all : ReferenceMaker.times(source, all);
  }

  /** One model per formulation and closure: the first two differ in their equations. */
  private static List<ReferenceMaker.Source> sources(List<Candidate> candidates) {
    Map<String, ReferenceMaker.Source> sources = new LinkedHashMap<>();
    for (Candidate candidate : candidates) {
      SimulationMethod method = candidate.method();
      String name = new SimulationMethod(method.formulation(), method.closure(), "").name().strip();
      sources.putIfAbsent(name, new ReferenceMaker.Source(name, candidate::problem));
    }
    return List.copyOf(sources.values());
  }

  private static Optional<Spectrum> spectrum(
      Judge judge, ExplicitModel model, ReportBudget budget) {
    if (judge.reference().isEmpty()) {
      return Optional.empty();
    }
    Reference reference = judge.reference().get();
    ModelProblem problem = new ModelProblem(model);
    double one = Spectrum.forecast(reference, problem);
    int samples = (int) Math.min(Stiffness.USUAL_TIMES, OF_SPECTRUM * budget.left() / one);
    if (samples < Stiffness.USUAL_TIMES) {
      budget.saves(
          String.format(
              Locale.ROOT,
              "Eigenvalues were computed at %s times in place of %d, since they take about %s at"
                  + " one time.",
              samples == 0 ? "no" : Integer.toString(samples),
              Stiffness.USUAL_TIMES,
              ReportBudget.inWords(one)));
    }
    return Optional.of(Spectrum.along(reference, problem, samples))
        .filter(found -> !found.samples().isEmpty());
  }

  /** A reference is taken up again only if it was made for the same model, effort and version. */
  private String purpose(String file) {
    return String.join(
        "; ", "mech report", file, builds.identity(), effort.name(), Machine.solverVersion());
  }

  /**
   * A journal is taken up again only if, besides, it was made with the same code: counts and times
   * are those of one solver and one generator, which a version does not tell while it is made.
   */
  private String code(Candidate candidate) {
    return "code " + builds.code(candidate.method());
  }

  private Map<String, TimeShares> shares(
      List<Candidate> candidates, List<Point> points, MethodRunner runner, ReportBudget budget) {
    Map<String, TimeShares> shares = new LinkedHashMap<>();
    double tolerance = effort.typicalTolerance();
    double after = budget.left() / 2;
    List<Candidate> done = fastestFirst(candidates, points, tolerance);
    List<String> leftOut = new ArrayList<>();
    for (int i = 0; i < done.size(); i++) {
      String name = done.get(i).method().name();
      double left = (budget.left() - after) / (done.size() - i);
      if (seconds(points, name, tolerance) > left) {
        leftOut.add(name);
        continue;
      }
      progress.at("shares of time: " + name, 0.96, Double.NaN);
      double limit = Math.min(5 * effort.limitSeconds(), left);
      shares.put(name, TimeShares.of(runner, done.get(i), tolerance, limit));
    }
    if (!leftOut.isEmpty()) {
      budget.saves("Where the time goes was not measured of " + String.join(", ", leftOut) + ".");
    }
    return shares;
  }

  /** The methods that reach the end at a tolerance, the fastest first. */
  private static List<Candidate> fastestFirst(
      List<Candidate> candidates, List<Point> points, double tolerance) {
    return candidates.stream()
        .filter(method -> Double.isFinite(seconds(points, method.method().name(), tolerance)))
        .sorted(
            Comparator.comparingDouble(
                method -> seconds(points, method.method().name(), tolerance)))
        .toList();
  }

  /** Time of a method's run at a tolerance, s; infinite if it does not reach the end. */
  private static double seconds(List<Point> points, String method, double tolerance) {
    return points.stream()
        .filter(point -> point.first().method().equals(method))
        .filter(point -> point.tolerance() == tolerance && point.completed())
        .mapToDouble(Point::seconds)
        .findFirst()
        .orElse(Double.POSITIVE_INFINITY);
  }

  private Map<String, ColdRunTimes> freshStarts(
      List<Candidate> candidates, List<Point> points, Judge judge, ReportBudget budget)
      throws IOException, InterruptedException {
    if (builds.hasUserClasses()) {
      budget.saves(
          "First runs in a fresh JVM were left out: there, nothing would confine the classes of"
              + " the model's forces.");
      return Map.of();
    }
    double end = judge.grid().start() + judge.grid().step() * (judge.grid().rows() - 1);
    try (ColdRunTiming fresh = new ColdRunTiming()) {
      double after = budget.left() / 2;
      List<String> leftOut = new ArrayList<>();
      for (Candidate candidate : fastestFirst(candidates, points, effort.typicalTolerance())) {
        String name = candidate.method().name();
        if (budget.left() > after) {
          fresh.add(name, builds.standalone(candidate.method()));
        } else {
          leftOut.add(name);
        }
      }
      if (!leftOut.isEmpty()) {
        budget.saves(
            "First runs in a fresh JVM were left out of " + String.join(", ", leftOut) + ".");
      }
      return fresh.run(
          effort.typicalTolerance(),
          end,
          effort.freshStarts(),
          10 * effort.limitSeconds(),
          budget,
          progress);
    }
  }
}
