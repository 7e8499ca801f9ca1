package org.mechservice.report;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.DoubleFunction;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.mechservice.report.measure.MeasuredRun;
import org.mechservice.report.measure.MethodRunner;
import org.mechservice.report.measure.ReportedScene;
import org.mechservice.report.measure.SceneFindings;
import org.mechservice.report.method.Candidate;
import org.mechservice.report.method.SimulationMethod;
import org.mechservice.report.page.ReliabilityWarnings;
import org.mechservice.report.page.ScenePage;
import org.mechservice.report.solution.Judge;
import org.mechservice.report.solution.Reference;
import org.mechservice.report.solution.ReferenceMaker;
import org.mechservice.report.solution.RunGrid;
import org.mechservice.report.solution.StateDistance;
import org.mechservice.solver.api.Solver;
import org.mechservice.solver.api.capability.ModelEvents.Action;
import org.mechservice.solver.catalogue.MethodNames;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.simulation.RuntimeSolver;

/** Reports on scenes whose state jumps on the way, judged by what their closed forms say. */
class EventReportTest {
  private static final Mechanism BALL = EventScenes.ball(EventScenes.bounce());
  private static final double BALL_END = 12;
  private static final ReportedScene SCENE = new ReportedScene("Ball", "ball.xml", 1, BALL_END);
  private static final int INTERVALS = 50;

  @TempDir Path folder;

  private static StateDistance distance(Mechanism mechanism) {
    return new StateDistance(EventScenes.model(mechanism, "DTR", 1).description());
  }

  private static Judge judge(Mechanism mechanism, double end) {
    return judge(mechanism, RunGrid.uniform(0, end, INTERVALS), end);
  }

  private static Judge judge(Mechanism mechanism, RunGrid grid, double end) {
    StateDistance distance = distance(mechanism);
    ReferenceMaker maker = new ReferenceMaker(distance, 20);
    Optional<Reference> made = maker.make(EventScenes.sources(mechanism, end), grid.times());
    return Judge.of(Optional.empty(), made, distance, grid);
  }

  private static void assertErrorsAreThoseOf(
      DoubleFunction<double[]> form, Mechanism mechanism, double end) {
    Judge judge = judge(mechanism, end);
    StateDistance distance = distance(mechanism);
    Reference made = judge.reference().orElseThrow();
    Reference exact = EventScenes.exact(made, form);
    try (MethodRunner measured = new MethodRunner(made, distance, judge.grid());
        MethodRunner knowing = new MethodRunner(exact, distance, judge.grid())) {
      for (Candidate candidate : EventScenes.candidates(mechanism, end)) {
        for (double tolerance : new double[] {1e-3, 1e-6, 1e-9}) {
          MeasuredRun run = measured.run(candidate, tolerance, 0, 20);
          MeasuredRun known = knowing.run(candidate, tolerance, 0, 20);
          assertThat(run.completed()).as(run.cause()).isTrue();
          // An ulp for the closed form itself, grown as the scene makes errors grow.
          assertThat(run.errors().largest())
              .as("%s at %.0e", candidate.method(), tolerance)
              .isCloseTo(known.errors().largest(), within(made.worstFloor() + 1e-14));
        }
      }
    }
  }

  @Test
  void errorsOfAllMethodsOnTheBouncingBallAreThoseAgainstItsClosedForm() {
    assertErrorsAreThoseOf(EventScenes::ballAt, BALL, BALL_END);
  }

  @Test
  void errorsOfAllMethodsOnTheKinkedDriveAreThoseAgainstItsClosedForm() {
    assertErrorsAreThoseOf(EventScenes::barAt, EventScenes.cartAndBar(), 1);
  }

  @Test
  void referenceOfTheBouncingBallMeetsEveryBounceWithinWhatItSaysOfItself() {
    Judge judge = judge(BALL, BALL_END);
    Reference made = judge.reference().orElseThrow();

    double fall = Math.sqrt(2 * EventScenes.HEIGHT / EventScenes.GRAVITY);
    double bounce = fall;
    assertThat(made.jumps()).hasSize(12);
    for (int i = 0; i < 12; i++) {
      // The second code places them within a tenth of a picosecond.
      assertThat(made.jumps().get(i)).isCloseTo(bounce, within(1e-12));
      fall *= EventScenes.RESTITUTION;
      bounce += 2 * fall;
    }
    assertThat(judge.doubtful()).isFalse();
    assertThat(made.worstFloor()).isLessThan(1e-11);
    assertThat(made.amplification().orElseThrow()[made.times().length - 1]).isGreaterThan(1);
  }

  @Test
  void referenceTakesTheSamplesThatAreDueAtTheStart() {
    Reference made = judge(EventScenes.sampledBall(), 1).reference().orElseThrow();
    assertThat(Arrays.asList(made.states()))
        .allSatisfy(y -> assertThat(y[2]).isEqualTo(EventScenes.HEIGHT));
  }

  @Test
  void noErrorIsTakenNextToAJump() {
    Reference made = judge(BALL, BALL_END).reference().orElseThrow();
    assertThat(made.times().length).isBetween(INTERVALS * 3 / 4, INTERVALS);
    assertThat(made.jumps()).isNotEmpty();
    for (double t : made.times()) {
      // A quarter of an output interval, or of the shortest phase, the last, of 0.196 s.
      assertThat(made.jumps())
          .allSatisfy(jump -> assertThat(Math.abs(jump - t)).isGreaterThan(0.04));
    }
  }

  @Test
  void runThatAnEventStopsIsJudgedUpToThereByEveryMethod() {
    // Half the fall, then the end: 5 m are reached after sqrt(2 · 5 / g) s.
    double stop = Math.sqrt(EventScenes.HEIGHT / EventScenes.GRAVITY);
    Mechanism stopped = EventScenes.ball(EventScenes.passing(5, Action.STOP));
    ReferenceMaker maker = new ReferenceMaker(distance(stopped), 20);
    List<ReferenceMaker.Source> sources = EventScenes.sources(stopped, BALL_END);
    RunGrid whole = RunGrid.uniform(0, BALL_END, INTERVALS);

    ReferenceMaker.Extent extent = maker.extent(sources.get(0), whole);

    double end = extent.grid().times()[extent.grid().rows() - 1];
    assertThat(extent.why()).contains("ends at 1.00964 s", "\"passing\"");
    assertThat(end).isBetween(0.97 * stop, 0.99 * stop);
    assertThat(extent.grid().rows()).isEqualTo(INTERVALS);
    Judge judge = judge(stopped, extent.grid(), BALL_END);
    try (MethodRunner runner =
        new MethodRunner(judge.reference().orElseThrow(), distance(stopped), judge.grid())) {
      assertThat(EventScenes.candidates(stopped, BALL_END))
          .allSatisfy(
              candidate -> {
                MeasuredRun run = runner.run(candidate, 1e-6, 0, 20);
                assertThat(run.completed()).as(run.cause()).isTrue();
                assertThat(run.errors().largest()).isLessThan(1e-4);
              });
    }
  }

  @Test
  void referenceThatEndsBeforeItsLastTimeSaysWhy() {
    Mechanism stopped = EventScenes.ball(EventScenes.passing(5, Action.STOP));
    Judge judge = judge(stopped, RunGrid.uniform(0, 2, 20), 2);
    assertThat(judge.reference().orElseThrow().end()).isEqualTo(1.0);
    assertThat(judge.said()).anyMatch(said -> said.startsWith("The run ends at 1.00964 s"));
  }

  @Test
  void runIsJudgedUpToWhereItsEventsAccumulate() {
    ReferenceMaker maker = new ReferenceMaker(distance(BALL), 20);
    ReferenceMaker.Extent extent =
        maker.extent(EventScenes.sources(BALL, 20).get(0), RunGrid.uniform(0, 20, INTERVALS));
    assertThat(extent.why()).startsWith("Events accumulate at 12.8");
    // sqrt(2 h / g) (1 + e) / (1 - e)
    assertThat(extent.grid().times()[INTERVALS - 1]).isLessThan(12.851);
  }

  @Test
  void methodThatStopsTooEarlyHasFailed() {
    Mechanism early = EventScenes.ball(EventScenes.passing(5, Action.STOP));
    Judge judge = judge(EventScenes.ball(), 2);
    try (MethodRunner runner =
        new MethodRunner(judge.reference().orElseThrow(), distance(early), judge.grid())) {
      MeasuredRun run = runner.run(EventScenes.candidate(early, "DTR", "ode113", 2), 1e-6, 0, 20);
      assertThat(run.cause()).isEqualTo("ended too early: its events stopped it at 1.00964 s");
      assertThat(run.errors().largest()).isNaN();
    }
  }

  @Test
  void whatTwoFormulationsMakeOfAnEventMustAgreeOrTheIntervalEndsBefore() {
    Mechanism lively = EventScenes.ball(EventScenes.bounce(EventScenes.RESTITUTION + 1e-6, 0));
    List<ReferenceMaker.Source> sources =
        List.of(
            EventScenes.sources(BALL, BALL_END).get(0),
            EventScenes.sources(lively, BALL_END).get(1));
    RunGrid grid = RunGrid.uniform(0, BALL_END, INTERVALS);
    StateDistance distance = distance(BALL);

    Judge judge =
        Judge.of(
            Optional.empty(),
            new ReferenceMaker(distance, 20).make(sources, grid.times()),
            distance,
            grid);

    // The first bounce, after which they differ by 1e-6, is at 1.43 s.
    assertThat(judge.reference().orElseThrow().end()).isBetween(1.0, 1.43);
    assertThat(judge.said()).anyMatch(said -> said.startsWith("The interval is cut at 1."));
    assertThat(judge.doubt()).startsWith("The reference is doubtful: its codes differ");
  }

  @Test
  void eventThatIsOnlyRecordedLeavesTheReferenceAsItIs() {
    Mechanism recorded = EventScenes.ball(EventScenes.passing(5, Action.RECORD));

    Reference with = judge(recorded, 2).reference().orElseThrow();
    Reference without = judge(EventScenes.ball(), 2).reference().orElseThrow();

    assertThat(with.jumps()).isEmpty();
    assertThat(with.times()).isEqualTo(without.times());
    assertThat(with.states()).isDeepEqualTo(without.states());
    assertThat(with.sources()).isEqualTo(without.sources());
    assertThat(EventScenes.candidate(recorded, "DTR", "ode113", 2).problem().course())
        .hasValueSatisfying(course -> assertThat(course.isParted()).isFalse());
  }

  @Test
  void rowOfAnEventDoesNotStandForAnOutputTime() {
    // 5 m are passed at 1.00964 s, just behind the row at 1 s.
    Mechanism recorded = EventScenes.ball(EventScenes.passing(5, Action.RECORD));
    Judge judge = judge(recorded, RunGrid.uniform(0, 2, 20), 2);
    try (MethodRunner runner =
        new MethodRunner(judge.reference().orElseThrow(), distance(recorded), judge.grid())) {
      Candidate candidate = EventScenes.candidate(recorded, "DTR", "ode113", 2);
      assertThat(runner.run(candidate, 1e-9, 0, 20).errors().largest()).isLessThan(1e-9);
    }
  }

  private SceneFindings findings(Candidate candidate) throws IOException {
    return MeasuredFindings.of(
        SCENE, candidate, judge(BALL, BALL_END), distance(BALL), Optional.empty(), folder);
  }

  private SceneFindings findings(Mechanism mechanism, Solver solver, String name)
      throws IOException {
    SimulationMethod method = new SimulationMethod("DTR", MethodNames.NONE, name);
    return findings(
        new Candidate(method, () -> EventScenes.model(mechanism, "DTR", BALL_END), solver));
  }

  @Test
  void methodsThatBounceWhereTheyHitRaiseNoDoubt() throws IOException {
    assertThat(ReliabilityWarnings.of(findings(BALL, new RuntimeSolver(), "ode15s"))).isEmpty();
    assertThat(ReliabilityWarnings.of(findings(BALL, new SteppedBall(true), "stepped"))).isEmpty();
  }

  @Test
  void methodThatBouncesAtTheEndsOfItsStepsIsExposed() throws IOException {
    SceneFindings found = findings(BALL, new SteppedBall(false), "late");
    assertThat(ReliabilityWarnings.of(found))
        .singleElement()
        .asString()
        .startsWith("DTR late does not converge");
    assertThat(ScenePage.of(found)).contains("class=\"doubt\">DTR late does not converge");
  }

  @Test
  void methodThatDoesToTheStateWhatTheEventDoesNotSayIsExposed() throws IOException {
    Mechanism lively = EventScenes.ball(EventScenes.bounce(EventScenes.RESTITUTION + 1e-4, 0));
    assertThat(ReliabilityWarnings.of(findings(lively, new RuntimeSolver(), "ode113")))
        .singleElement()
        .asString()
        .startsWith("DTR ode113 does not converge");
  }

  @Test
  void methodThatFindsTheEventInAWrongPlaceIsExposed() throws IOException {
    Mechanism hovering = EventScenes.ball(EventScenes.bounce(EventScenes.RESTITUTION, 1e-4));
    assertThat(ReliabilityWarnings.of(findings(hovering, new RuntimeSolver(), "ode113")))
        .singleElement()
        .asString()
        .startsWith("DTR ode113 does not converge");
  }

  @Test
  void pageSaysThatTheStateJumpsByWhatAndHowThatIsJudged() throws IOException {
    String page = ScenePage.of(findings(BALL, new RuntimeSolver(), "ode113"));
    assertThat(page)
        .contains(
            "the state jumps 12 times",
            "by event &quot;bounce&quot;",
            "No integrator of the product and no search of its takes part",
            "The codes place the jumps within",
            "A method that misses the instant by more is charged the jump",
            "clear of the jumps of the state");
    assertThat(Arrays.stream(page.split("\n", -1))).noneMatch(line -> line.contains("NaN"));
  }
}
