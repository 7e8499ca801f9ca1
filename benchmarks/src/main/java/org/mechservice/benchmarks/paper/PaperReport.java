package org.mechservice.benchmarks.paper;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.Supplier;
import org.mechservice.client.MechSession;
import org.mechservice.client.SessionBuilds;
import org.mechservice.client.SimulationOptions;
import org.mechservice.client.jar.LocalModel;
import org.mechservice.client.run.LocalRun;
import org.mechservice.client.run.RemoteRun;
import org.mechservice.report.measure.MeasuredRun;
import org.mechservice.report.measure.MethodRunner;
import org.mechservice.report.measure.Quantiles;
import org.mechservice.report.measure.ReportProgress;
import org.mechservice.report.measure.WarmUpRounds;
import org.mechservice.report.method.Candidate;
import org.mechservice.report.method.SimulationMethod;
import org.mechservice.report.solution.Judge;
import org.mechservice.report.solution.PublishedReference;
import org.mechservice.report.solution.Reference;
import org.mechservice.report.solution.RunGrid;
import org.mechservice.report.solution.StateDistance;
import org.mechservice.solver.api.capability.ExplicitModel;
import org.mechservice.solver.catalogue.MethodNames;

/** Measures the paper's tables again. */
public final class PaperReport {
  /** The paper's methods, as our services build them. */
  private static final SimulationMethod EXPLICIT =
      new SimulationMethod("DTR", MethodNames.NONE, "DE");

  private static final SimulationMethod IMPLICIT =
      new SimulationMethod("RR-JF", MethodNames.NONE, "ode15sR");

  private static final double TOLERANCE = 1e-5;
  private static final int REPEATS = 11;

  /** Blocks of runs, s, that are compared before any run is counted, to see whether all is warm. */
  static final double WARM_SECONDS = 3;

  /** Set-ups of every scene that count, and those before them. */
  static final int SET_UPS = 7;

  static final int WARM_SET_UPS = 3;

  private static final double LIMIT_SECONDS = 60;

  private static final double[] ABSOLUTE_PARTS = {
    EqualErrors.AS_JUDGED, MethodRunner.ABSOLUTE_PART
  };

  private static final double[] DAMPING = {0, 1e-5, 3e-5, 1e-4, 3e-4, 1e-3, 3e-3, 1e-2, 3e-2};

  private final Supplier<MechSession> sessions;
  private final Path examples;
  private final ReportProgress progress;

  /**
   * @param sessions opens one per model
   * @param examples folder with the scenes that come with the product
   */
  public PaperReport(Supplier<MechSession> sessions, Path examples, ReportProgress progress) {
    this.sessions = sessions;
    this.examples = examples;
    this.progress = progress;
  }

  /**
   * Measures, and writes the page.
   *
   * @throws IOException if a scene cannot be read or the page not written
   */
  public Path write(Path folder) throws IOException {
    Files.createDirectories(folder);
    Map<PaperFigures.Scene, Map<String, Double>> setUp = new LinkedHashMap<>();
    Map<PaperFigures.Scene, RunPair> runs = new LinkedHashMap<>();
    for (PaperFigures.Scene scene : PaperFigures.Scene.values()) {
      progress.at(
          "the paper's " + scene.label,
          0.1 * scene.compareTo(PaperFigures.Scene.PENDULUM),
          Double.NaN);
      if (scene != PaperFigures.Scene.DAMPED_DRIVER) {
        setUp.put(scene, setUp(scene));
      }
      if (scene != PaperFigures.Scene.SUSPENSION) {
        runs.put(scene, runs(text(scene), scene.label));
      }
    }
    List<DampingPoint> sweep = sweep();
    Path page = folder.resolve("paper.html");
    Files.writeString(page, PaperPage.of(setUp, runs, sweep), StandardCharsets.UTF_8);
    return page;
  }

  private String text(PaperFigures.Scene scene) throws IOException {
    return Files.readString(examples.resolve(scene.file), StandardCharsets.UTF_8);
  }

  /**
   * Medians of several set-ups of a warm service. Each has a remark of its own behind the model, so
   * that nothing is taken from what the service keeps of models it has met.
   */
  private Map<String, Double> setUp(PaperFigures.Scene scene) throws IOException {
    String text = text(scene);
    Map<String, List<Double>> all = new LinkedHashMap<>();
    for (int i = 0; i < WARM_SET_UPS + SET_UPS; i++) {
      Map<String, Double> figures = new LinkedHashMap<>();
      try (MechSession session = session(text, 2 * i);
          RemoteRun remote = session.prepareRemoteRun(SimulationOptions.asInFile())) {
        addNumbers(remote.toEnd(new DiscardedRows()).report(), figures);
      }
      // A session of its own: code generated for the remote run would not be timed again.
      try (MechSession session = session(text, 2 * i + 1);
          LocalRun local = session.prepareLocalRun(SimulationOptions.asInFile())) {
        addNumbers(local.toEnd(new DiscardedRows()).report(), figures);
      }
      if (i >= WARM_SET_UPS) {
        figures.forEach((key, v) -> all.computeIfAbsent(key, k -> new ArrayList<>()).add(v));
      }
    }
    Map<String, Double> medians = new LinkedHashMap<>();
    all.forEach(
        (key, v) ->
            medians.put(
                key, Quantiles.median(v.stream().mapToDouble(Double::doubleValue).toArray())));
    medians.put("mechmlBytes", (double) text.getBytes(StandardCharsets.UTF_8).length);
    return medians;
  }

  private MechSession session(String text, int number) throws IOException {
    MechSession session = sessions.get();
    String remark = String.format(Locale.ROOT, "<!-- set-up %d -->%n", number);
    session.loadModel("model.xml", (text + remark).getBytes(StandardCharsets.UTF_8));
    return session;
  }

  private static void addNumbers(Map<String, Object> report, Map<String, Double> to) {
    report.forEach(
        (key, value) -> {
          if (value instanceof Number number) {
            to.put(key, number.doubleValue());
          }
        });
  }

  /**
   * The two methods on one scene.
   *
   * @param explicit DTR with DE
   * @param implicit RR-JF with ode15sR
   * @param equalErrors ratios of their costs by how the tolerances weigh; none where no error is
   *     known
   */
  record RunPair(Timed explicit, Timed implicit, List<EqualErrors> equalErrors) {
    RunPair {
      equalErrors = List.copyOf(equalErrors);
    }
  }

  /**
   * A method's runs.
   *
   * @param seconds median, s
   * @param low lower quartile, s
   * @param high upper quartile, s
   * @param run counts and errors
   */
  record Timed(double seconds, double low, double high, MeasuredRun run) {}

  /**
   * Both methods at a damping.
   *
   * @param ratio C/K, s
   */
  record DampingPoint(double ratio, RunPair runs) {}

  private RunPair runs(String text, String label) {
    try (MechSession session = sessions.get()) {
      session.loadModel("model.xml", text.getBytes(StandardCharsets.UTF_8));
      Candidate explicit = candidate(session, EXPLICIT);
      Candidate implicit = candidate(session, IMPLICIT);
      RunPair pair;
      try (MethodRunner runner = runner(explicit, MethodRunner.ABSOLUTE_PART)) {
        progress.at("runs of the " + label, 0.4, Double.NaN);
        pair = interleaved(runner, explicit, implicit);
      }
      progress.at("equal errors of the " + label, 0.45, Double.NaN);
      List<EqualErrors> equal = new ArrayList<>();
      for (double part : ABSOLUTE_PARTS) {
        try (MethodRunner runner = runner(explicit, part)) {
          equal.add(EqualErrors.of(part, runner, explicit, implicit, LIMIT_SECONDS));
        }
      }
      return new RunPair(pair.explicit(), pair.implicit(), equal);
    }
  }

  private static Candidate candidate(MechSession session, SimulationMethod method) {
    LocalModel model = session.fetchModel(SessionBuilds.options(method));
    return new Candidate(method, model::newModel, model.solver());
  }

  private static MethodRunner runner(Candidate candidate, double absolutePart) {
    ExplicitModel model = candidate.equations();
    StateDistance distance = new StateDistance(model.description());
    double[] start = new double[model.description().stateCount()];
    model.initialState(start);
    double end = model.description().defaults().tEnd();
    PublishedReference published =
        PublishedReference.of(model.description().name(), start, end, distance).orElseThrow();
    Judge judge = Judge.trusting(published);
    return new MethodRunner(judge.reference().orElseThrow(), distance, judge.grid(), absolutePart);
  }

  private static RunPair interleaved(MethodRunner runner, Candidate explicit, Candidate implicit) {
    List<MeasuredRun> first = new ArrayList<>();
    List<MeasuredRun> second = new ArrayList<>();
    WarmUpRounds.until(
        () ->
            runner.run(explicit, TOLERANCE, 0, LIMIT_SECONDS).seconds()
                + runner.run(implicit, TOLERANCE, 0, LIMIT_SECONDS).seconds(),
        WARM_SECONDS,
        ReportProgress.SILENT,
        0);
    for (int round = 0; round < REPEATS; round++) {
      first.add(runner.run(explicit, TOLERANCE, round, LIMIT_SECONDS));
      second.add(runner.run(implicit, TOLERANCE, round, LIMIT_SECONDS));
    }
    return new RunPair(timed(first), timed(second), List.of());
  }

  private static Timed timed(List<MeasuredRun> runs) {
    double[] seconds = runs.stream().mapToDouble(MeasuredRun::seconds).toArray();
    return new Timed(
        Quantiles.median(seconds),
        Quantiles.of(seconds, 0.25),
        Quantiles.of(seconds, 0.75),
        runs.get(runs.size() - 1));
  }

  /** The driver with other dampings: at which one the implicit method begins to win. */
  private List<DampingPoint> sweep() throws IOException {
    String driver =
        Files.readString(examples.resolve("driver/driver-free-c0.xml"), StandardCharsets.UTF_8);
    List<DampingPoint> points = new ArrayList<>();
    for (double ratio : DAMPING) {
      String damped =
          driver.replaceFirst(
              "(name=\"dampingRatio\" value=\")[^\"]*", "$1" + Double.toString(ratio));
      points.add(new DampingPoint(ratio, sweepRuns(damped, ratio)));
    }
    return points;
  }

  private RunPair sweepRuns(String text, double ratio) {
    try (MechSession session = sessions.get()) {
      progress.at("damping C/K = " + ratio + " s", 0.5 + 0.5 * Math.min(1, ratio), Double.NaN);
      session.loadModel("model.xml", text.getBytes(StandardCharsets.UTF_8));
      Candidate explicit = candidate(session, EXPLICIT);
      Candidate implicit = candidate(session, IMPLICIT);
      ExplicitModel model = explicit.equations();
      double end = model.description().defaults().tEnd();
      double[] times = {0, end};
      double[] start = new double[model.description().stateCount()];
      double[][] unknown = {start, start};
      double[] none = new double[2];
      Reference reference =
          new Reference(times, unknown, none, none, java.util.Optional.empty(), List.of());
      StateDistance distance = new StateDistance(model.description());
      try (MethodRunner runner =
          new MethodRunner(reference, distance, RunGrid.uniform(0, end, 10))) {
        return interleaved(runner, explicit, implicit);
      }
    }
  }
}
