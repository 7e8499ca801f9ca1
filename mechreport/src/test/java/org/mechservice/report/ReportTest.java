package org.mechservice.report;

import static org.assertj.core.api.Assertions.assertThat;
import static org.mechservice.report.MeasuredFindings.SHORT;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.report.RungeKuttaSolver.Fault;
import org.mechservice.report.measure.Campaign;
import org.mechservice.report.measure.MeasurementFile;
import org.mechservice.report.measure.MethodRunner;
import org.mechservice.report.measure.Point;
import org.mechservice.report.measure.ReportBudget;
import org.mechservice.report.measure.ReportProgress;
import org.mechservice.report.measure.ReportedScene;
import org.mechservice.report.measure.SceneFindings;
import org.mechservice.report.measure.Spectrum;
import org.mechservice.report.method.Candidate;
import org.mechservice.report.method.ModelProblem;
import org.mechservice.report.method.SimulationMethod;
import org.mechservice.report.page.ReliabilityWarnings;
import org.mechservice.report.page.ScenePage;
import org.mechservice.report.solution.Judge;
import org.mechservice.report.solution.PublishedReference;
import org.mechservice.report.solution.Reference;
import org.mechservice.report.solution.ReferenceMaker;
import org.mechservice.report.solution.RunGrid;
import org.mechservice.report.solution.StateDistance;
import org.mechservice.solver.api.Solver;
import org.mechservice.solver.catalogue.MethodNames;
import org.mechservice.solver.simulation.RuntimeSolver;

class ReportTest {
  private static final ReportedScene SCENE =
      new ReportedScene("PlanarPendulum", "planar.xml", 1, 2);
  private static final RunGrid GRID = RunGrid.uniform(0, 2, 20);
  private static final StateDistance DISTANCE =
      new StateDistance(new PlanarPendulum(0).description());

  @TempDir Path folder;

  private static ReferenceMaker.Source pendulum(double damping) {
    return new ReferenceMaker.Source("DTR", () -> new ModelProblem(new PlanarPendulum(damping)));
  }

  private static Judge judge(ReferenceMaker maker) {
    return Judge.of(Optional.empty(), List.of(pendulum(0)), maker, DISTANCE, GRID);
  }

  private static Judge goodJudge() {
    return judge(new ReferenceMaker(DISTANCE, 20));
  }

  private SceneFindings findings(Judge judge, String integrator, Solver solver, double damping)
      throws IOException {
    SimulationMethod method = new SimulationMethod("DTR", MethodNames.NONE, integrator);
    Candidate candidate = new Candidate(method, () -> new PlanarPendulum(damping), solver);
    ModelProblem problem = new ModelProblem(new PlanarPendulum(damping));
    Spectrum spectrum = Spectrum.along(judge.reference().orElseThrow(), problem, 3);
    return MeasuredFindings.of(SCENE, candidate, judge, DISTANCE, Optional.of(spectrum), folder);
  }

  @Test
  void integratorsOfTheProductRaiseNoDoubt() throws IOException {
    SceneFindings found = findings(goodJudge(), "ode113", new RuntimeSolver(), 0);
    assertThat(ReliabilityWarnings.of(found)).isEmpty();
  }

  @Test
  void rungeKuttaMethodWithItsRightCoefficientsRaisesNoDoubt() throws IOException {
    SceneFindings found = findings(goodJudge(), "RK4", new RungeKuttaSolver(Fault.NONE), 0);
    assertThat(ReliabilityWarnings.of(found)).isEmpty();
  }

  @ParameterizedTest
  @CsvSource({
    "WRONG_WEIGHT, does not converge",
    "WRONG_STAGE, does not converge",
    "WRONG_ERROR_CONSTANT, does not keep its tolerance",
    "LINEAR_DENSE_OUTPUT, is less exact between its steps",
    "WRONG_SLOPES_IN_DENSE_OUTPUT, is less exact between its steps",
  })
  void brokenIntegratorIsExposedByItsFault(Fault fault, String words) throws IOException {
    SceneFindings found = findings(goodJudge(), "RK4", new RungeKuttaSolver(fault), 0);
    assertThat(ReliabilityWarnings.of(found)).first().asString().startsWith("DTR RK4 " + words);
    assertThat(ScenePage.of(found)).contains("class=\"doubt\">DTR RK4 " + words);
  }

  @Test
  void toleranceThatIsNotKeptIsFlaggedInTheTable() throws IOException {
    String honest = ScenePage.of(findings(goodJudge(), "RK4", new RungeKuttaSolver(Fault.NONE), 0));
    String careless =
        ScenePage.of(
            findings(goodJudge(), "RK4c", new RungeKuttaSolver(Fault.WRONG_ERROR_CONSTANT), 0));
    assertThat(honest).contains("All 4 runs").doesNotContain("<td class=\"flag\">");
    assertThat(careless).contains("<b>4 of 4</b> runs", "<td class=\"flag\">");
  }

  @Test
  void reportWithoutTimeNamesWhatItLeavesOut() throws IOException {
    Judge judge = goodJudge();
    SceneFindings measured = findings(judge, "ode113", new RuntimeSolver(), 0);
    SimulationMethod method = new SimulationMethod("DTR", MethodNames.NONE, "DE");
    Candidate candidate = new Candidate(method, () -> new PlanarPendulum(0), new RuntimeSolver());
    Path file = folder.resolve("late.csv");
    List<Point> points = new ArrayList<>(measured.points());
    try (MeasurementFile journal = MeasurementFile.open(file, "test");
        MethodRunner runner =
            new MethodRunner(judge.reference().orElseThrow(), DISTANCE, judge.grid())) {
      points.addAll(
          Point.of(
              new Campaign(runner, journal, SHORT, new ReportBudget(0), ReportProgress.SILENT)
                  .run(List.of(candidate))));
      assertThat(journal.runs()).as("a report with more time measures them").isEmpty();
    }
    String page =
        ScenePage.of(
            MeasuredFindings.with(
                measured,
                List.of(measured.methods().get(0), method),
                points,
                SHORT.withBudget(600),
                List.of("Rounds to warm up were left out.")));

    assertThat(points).hasSize(8);
    assertThat(page)
        .contains("Not measured, to keep the time for the report", "it is not known how long a run")
        .contains("The time for the report, 10 minutes", "Rounds to warm up were left out.")
        .doesNotContain("<h2>Failures");
    assertThat(ScenePage.of(measured)).doesNotContain("time for the report");
  }

  /** One run has no quartiles, and its time none that it could be told apart from. */
  @Test
  void pageOfSingleRunsSaysSoAndShowsNoSpread() throws IOException {
    SceneFindings measured = findings(goodJudge(), "ode113", new RuntimeSolver(), 0);
    List<Point> single = Point.of(measured.points().stream().map(Point::first).toList());
    String page = ScenePage.of(MeasuredFindings.with(measured, measured.methods(), single));

    assertThat(single).isNotEmpty().noneMatch(point -> point.overlaps(point));
    assertThat(page)
        .contains("(a single run)", "how far they scatter is not known")
        .doesNotContain("(quartiles", "Half of a point's times", "Warm-up:");
    assertThat(ScenePage.of(measured)).contains("(quartiles").doesNotContain("(a single run)");
  }

  @Test
  void referenceThatNoMethodConvergesToIsExposedInOneSentence() throws IOException {
    SceneFindings one = findings(goodJudge(), "ode113", new RuntimeSolver(), 1e-3);
    SceneFindings other = findings(goodJudge(), "DE", new RuntimeSolver(), 1e-3);
    List<SimulationMethod> methods = List.of(one.methods().get(0), other.methods().get(0));
    List<Point> points = new ArrayList<>(one.points());
    points.addAll(other.points());
    SceneFindings both = MeasuredFindings.with(one, methods, points);

    assertThat(ReliabilityWarnings.of(both))
        .singleElement()
        .asString()
        .startsWith("No method converges to the reference");
  }

  @Test
  void modelThatDiffersFromItsReferenceIsExposed() throws IOException {
    SceneFindings found = findings(goodJudge(), "ode113", new RuntimeSolver(), 1e-3);
    assertThat(ReliabilityWarnings.of(found))
        .singleElement()
        .asString()
        .contains("does not converge");
  }

  @Test
  void looseReferenceIsExposed() throws IOException {
    // Output times far apart, so that nothing but the tolerance bounds the steps.
    RunGrid coarse = RunGrid.uniform(0, 2, 2);
    ReferenceMaker maker = new ReferenceMaker(DISTANCE, 20, 0.5, 0.1);
    Judge loose = Judge.of(Optional.empty(), List.of(pendulum(0)), maker, DISTANCE, coarse);
    SceneFindings found = findings(loose, "ode113", new RuntimeSolver(), 0);
    assertThat(ReliabilityWarnings.of(found))
        .first()
        .asString()
        .startsWith("The reference is doubtful");
    assertThat(ScenePage.of(found)).contains("class=\"doubt\">The reference is doubtful");
  }

  @ParameterizedTest
  @ValueSource(doubles = {1e-2, 1e-4, 1e-6, 1e-8})
  void floorOfALooseReferenceIsNoSmallerThanItsError(double tolerance) {
    RunGrid coarse = RunGrid.uniform(0, 2, 2);
    ReferenceMaker loose = new ReferenceMaker(DISTANCE, 20, tolerance, tolerance);
    Reference made = loose.make(List.of(pendulum(0)), coarse.times()).orElseThrow();
    Reference exact =
        new ReferenceMaker(DISTANCE, 20).make(List.of(pendulum(0)), coarse.times()).orElseThrow();
    for (int i = 0; i < made.times().length; i++) {
      double error = DISTANCE.of(made.states()[i], exact.states()[i]);
      // Two codes differ by no less than half the worse one's error unless they err alike.
      assertThat(made.floor()[i] + exact.floor()[i]).isGreaterThanOrEqualTo(error / 2);
    }
  }

  @Test
  void oneLooseCodeIsExposedByTheOther() {
    RunGrid coarse = RunGrid.uniform(0, 2, 2);
    ReferenceMaker maker = new ReferenceMaker(DISTANCE, 20, 1e-12, 0.1);
    Judge judge = Judge.of(Optional.empty(), List.of(pendulum(0)), maker, DISTANCE, coarse);
    assertThat(judge.doubt()).startsWith("The reference is doubtful");
  }

  @Test
  void formulationsThatDifferInTheirEquationsMakeADoubtfulReference() {
    Judge judge =
        Judge.of(
            Optional.empty(),
            List.of(pendulum(0), pendulum(1e-3)),
            new ReferenceMaker(DISTANCE, 20),
            DISTANCE,
            GRID);
    assertThat(judge.doubt()).startsWith("The reference is doubtful");
  }

  @Test
  void publishedReferenceOfAnotherSceneIsExposed() {
    double[] times = {0, 1, 2};
    double[][] wrong = {{1, 0}, {0.5, 0.1}, {0.2, 0.3}};
    PublishedReference other = new PublishedReference("By hand", times, wrong, new double[3]);
    Judge judge =
        Judge.of(
            Optional.of(other),
            List.of(pendulum(0)),
            new ReferenceMaker(DISTANCE, 20),
            DISTANCE,
            GRID);
    assertThat(judge.doubtful()).isTrue();
  }

  @Test
  void codesThatCheckEachOtherAgreeToTwelveDigits() {
    Reference reference = goodJudge().reference().orElseThrow();
    // Two codes, each at its limit, on a motion that hardly amplifies.
    assertThat(reference.worstFloor()).isLessThan(1e-12);
  }

  @Test
  void journalIsTakenUpAgainForTheSamePurposeAndNoOther() throws IOException {
    Path file = folder.resolve("kept.csv");
    findings(goodJudge(), "kept", new RungeKuttaSolver(Fault.NONE), 0);
    int runs = MeasurementFile.read(file).size();
    assertThat(runs).isPositive();
    try (MeasurementFile again = MeasurementFile.open(file, "test")) {
      assertThat(again.runs()).hasSize(runs);
    }
    try (MeasurementFile other = MeasurementFile.open(file, "another model")) {
      assertThat(other.runs()).isEmpty();
    }
  }

  @Test
  void pageOfATreeSaysNothingOfLoopsNorOfStiffnessItDoesNotHave() throws IOException {
    String page = ScenePage.of(findings(goodJudge(), "ode113", new RuntimeSolver(), 0));
    assertThat(page).contains("Not stiff").doesNotContain("closed loops", "Eigenvalues along");
  }
}
