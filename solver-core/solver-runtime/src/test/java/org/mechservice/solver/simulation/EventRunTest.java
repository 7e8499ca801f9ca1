package org.mechservice.solver.simulation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Collections;
import java.util.EnumSet;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.solver.api.Model;
import org.mechservice.solver.api.capability.ModelEvents.Action;
import org.mechservice.solver.api.capability.ModelEvents.Direction;
import org.mechservice.solver.api.result.ColumnGroup;
import org.mechservice.solver.api.run.Checkpoints;
import org.mechservice.solver.api.run.Failure;
import org.mechservice.solver.api.run.Outcome;
import org.mechservice.solver.api.run.RunControl;
import org.mechservice.solver.api.run.RunNotes.Note;
import org.mechservice.solver.api.run.RunReport;
import org.mechservice.solver.api.run.RunRequest;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.compact.CompactModel;
import org.mechservice.solver.compact.DataDriven;
import org.mechservice.solver.expression.BodyPoint;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.expression.Expression.Call;
import org.mechservice.solver.expression.Expression.CoordinatePosition;
import org.mechservice.solver.expression.Expression.CoordinateVelocity;
import org.mechservice.solver.expression.Expression.Power;
import org.mechservice.solver.expression.Expression.Product;
import org.mechservice.solver.expression.Expression.Sum;
import org.mechservice.solver.expression.Expression.Time;
import org.mechservice.solver.expression.JointCoordinate;
import org.mechservice.solver.force.user.UserForceSource;
import org.mechservice.solver.mechanism.Body;
import org.mechservice.solver.mechanism.Event;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.Root;
import org.mechservice.solver.mechanism.StateChange;
import org.mechservice.solver.mechanism.closure.DistanceClosure;
import org.mechservice.solver.mechanism.closure.LoopClosure;
import org.mechservice.solver.mechanism.force.ForceElement;
import org.mechservice.solver.mechanism.force.JointForce;
import org.mechservice.solver.mechanism.joint.Attachment;
import org.mechservice.solver.mechanism.joint.Joint;
import org.mechservice.solver.mechanism.joint.Prismatic;
import org.mechservice.solver.mechanism.joint.StartRole;
import org.mechservice.solver.spatial.InertiaTensor;
import org.mechservice.solver.spatial.Rotation;
import org.mechservice.solver.spatial.Vector3;
import org.mechservice.solver.symbol.MathFunction;
import org.mechservice.solver.text.Origin;

/** What a model's events do to a run of it, in every form of its equations. */
class EventRunTest {
  private static final double GRAVITY = 9.81;
  private static final double RESTITUTION = 0.8;
  private static final double HEIGHT = 10;
  private static final Vector3 X = new Vector3(1, 0, 0);
  private static final Vector3 Z = new Vector3(0, 0, 1);

  private final RecordedRows rows = new RecordedRows();

  /** A mass of 1 kg on a slide, upwards. */
  private static Mechanism ball(List<ForceElement> forces, Event... events) {
    Body mass = new Body("ball", 1, Vector3.ZERO, InertiaTensor.ZERO, Origin.NONE);
    Joint slide = new Prismatic("z", on(-1, 0), Z, HEIGHT, 0, Origin.NONE);
    return mechanism("Ball", List.of(mass), List.of(slide), List.of(), forces, events);
  }

  /** A point mass on two crossed slides, held at a distance of 1 m from the origin. */
  private static Mechanism slidingPendulum(Event... events) {
    List<Body> bodies =
        List.of(
            new Body("slide", 0, Vector3.ZERO, InertiaTensor.ZERO, Origin.NONE),
            new Body("mass", 1, Vector3.ZERO, InertiaTensor.ZERO, Origin.NONE));
    List<Joint> joints =
        List.of(
            new Prismatic("x", on(-1, 0), X, 1, 0, Origin.NONE),
            new Prismatic("z", on(0, 1), Z, 0, 0, Origin.NONE));
    LoopClosure rod =
        new DistanceClosure(
            "rod",
            new BodyPoint(BodyPoint.ROOT, Vector3.ZERO),
            new BodyPoint(1, Vector3.ZERO),
            1,
            0,
            Origin.NONE);
    return mechanism("Sliding", bodies, joints, List.of(rod), List.of(), events);
  }

  private static Attachment on(int parent, int child) {
    return new Attachment(parent, Vector3.ZERO, child, Vector3.ZERO, Rotation.IDENTITY);
  }

  private static Mechanism mechanism(
      String name,
      List<Body> bodies,
      List<Joint> joints,
      List<LoopClosure> closures,
      List<ForceElement> forces,
      Event... events) {
    return new Mechanism(
            name,
            new Root("ground", Vector3.ZERO, Rotation.IDENTITY),
            Z.times(-GRAVITY),
            bodies,
            joints,
            List.of(),
            Collections.nCopies(joints.size(), StartRole.PREFERRED),
            closures,
            forces,
            List.of())
        .withEvents(List.of(events));
  }

  private static Expression q(int joint) {
    return new CoordinatePosition(new JointCoordinate(joint, 0));
  }

  private static Expression v(int joint) {
    return new CoordinateVelocity(new JointCoordinate(joint, 0));
  }

  private static Expression times(double factor, Expression of) {
    return new Product(Expression.of(factor), of);
  }

  private static Expression minus(Expression a, double b) {
    return new Sum(a, Expression.of(-b));
  }

  private static Event event(
      String name, Expression g, Direction direction, Action action, StateChange... changes) {
    return new Event(name, g, direction, action, List.of(changes), Origin.NONE);
  }

  private static Event bounce() {
    StateChange back = new StateChange(0, List.of(), List.of(times(-RESTITUTION, v(0))));
    return event("bounce", q(0), Direction.FALLING, Action.SET, back);
  }

  private static Model model(Mechanism mechanism, String formulation) {
    return model(mechanism, formulation, mechanism.closures().isEmpty() ? "none" : "projection");
  }

  private static Model model(Mechanism mechanism, String formulation, String closure) {
    RunSettings settings = new RunSettings(0, 1, 0.1, "ode113", 1e-6, 1e-6);
    CompactModel written = new CompactModel(mechanism, formulation, closure, settings);
    return DataDriven.model(CompactModel.of(written.texts()), UserForceSource.NONE);
  }

  private RunReport run(Model model, String integrator, double tEnd) throws IOException {
    return run(model, integrator, tEnd, Checkpoints.NONE);
  }

  private RunReport run(Model model, String integrator, double tEnd, Checkpoints checkpoints)
      throws IOException {
    RunSettings settings = new RunSettings(0, tEnd, 0.25, integrator, 1e-10, 1e-10);
    return new RuntimeSolver()
        .run(
            model,
            new RunRequest(settings, EnumSet.of(ColumnGroup.ENERGY)),
            rows,
            new RunControl(),
            checkpoints);
  }

  private static List<Double> times(RunReport report) {
    return report.notes().stream()
        .filter(n -> n.code() == MessageCode.EVENT_OCCURRED)
        .map(Note::time)
        .toList();
  }

  /** Fall from the height, then flights of 2 v/g, each slower by the restitution. */
  private static List<Double> bounceTimes(double tEnd) {
    List<Double> times = new ArrayList<>();
    double speed = Math.sqrt(2 * GRAVITY * HEIGHT);
    for (double t = speed / GRAVITY; t < tEnd; t += 2 * speed / GRAVITY) {
      times.add(t);
      speed *= RESTITUTION;
    }
    return times;
  }

  @ParameterizedTest
  @CsvSource({
    "DTR, ode113",
    "DTR, DE",
    "DTR, ode15s",
    "DSR, ode113",
    "RR, ode15sR",
    "RR-JF, ode15sR"
  })
  void ballBouncesWhenItShould(String formulation, String integrator) throws IOException {
    RunReport report = run(model(ball(List.of(), bounce()), formulation), integrator, 12);

    assertThat(report.outcome()).isEqualTo(new Outcome.Completed());
    List<Double> expected = bounceTimes(12);
    List<Double> actual = times(report);
    assertThat(actual).hasSameSizeAs(expected).hasSize(12);
    for (int i = 0; i < expected.size(); i++) {
      // Ten times the tolerance per step, for what errors of velocity become in flight.
      assertThat(actual.get(i)).isCloseTo(expected.get(i), within(1e-8));
    }
    assertThat(report.notes().get(0).text()).contains("bounce");
    for (double[] row : rows.rows) {
      assertThat(row[1]).isGreaterThan(-1e-8);
    }
  }

  @Test
  void whatABounceTakesIsWorkAndNoDriftOfTheEnergy() throws IOException {
    RunReport report = run(model(ball(List.of(), bounce()), "DTR"), "ode113", 6);

    double[] last = rows.rows.get(rows.rows.size() - 1);
    double left = GRAVITY * HEIGHT * StrictMath.pow(RESTITUTION, 2 * 3);
    assertThat(last[3] + last[4]).isCloseTo(left, within(1e-6));
    assertThat(last[5]).isCloseTo(left - GRAVITY * HEIGHT, within(1e-6));
    assertThat(report.energyDrift().orElseThrow()).isLessThan(1e-6);
  }

  @Test
  void recordedEventIsARowOfItsOwn() throws IOException {
    Event half = event("half", minus(q(0), HEIGHT / 2), Direction.FALLING, Action.RECORD);
    RunReport report = run(model(ball(List.of(), half), "DTR"), "ode113", 1.25);

    double expected = Math.sqrt(HEIGHT / GRAVITY);
    assertThat(times(report)).hasSize(1);
    assertThat(times(report).get(0)).isCloseTo(expected, within(1e-9));
    assertThat(rows.rows).hasSize(7);
    assertThat(rows.rows.stream().map(row -> row[0])).isSorted().contains(times(report).get(0));
  }

  @Test
  void runEndsAtAStopWithARow() throws IOException {
    Event ground = event("ground", q(0), Direction.BOTH, Action.STOP);
    RunReport report = run(model(ball(List.of(), ground), "DTR"), "ode113", 5);

    double expected = Math.sqrt(2 * HEIGHT / GRAVITY);
    assertThat(report.outcome()).isEqualTo(new Outcome.Completed());
    assertThat(report.timeReached()).isCloseTo(expected, within(1e-9));
    double[] last = rows.rows.get(rows.rows.size() - 1);
    assertThat(last[0]).isEqualTo(report.timeReached());
    assertThat(last[1]).isCloseTo(0, within(1e-8));
    assertThat(report.notes().get(0).text()).contains("ground").contains("ends the run");
  }

  @Test
  void eventsAtOnceAllSeeTheStateBefore() throws IOException {
    StateChange up = new StateChange(0, List.of(Expression.of(HEIGHT)), List.of());
    Event lift = event("lift", q(0), Direction.FALLING, Action.SET, up);
    StateChange slow = new StateChange(0, List.of(), List.of(q(0)));
    Event halt = event("halt", q(0), Direction.FALLING, Action.SET, slow);
    RunReport report = run(model(ball(List.of(), lift, halt), "DTR"), "ode113", 2);

    double fall = Math.sqrt(2 * HEIGHT / GRAVITY);
    assertThat(times(report)).hasSize(2);
    double flight = 2 - fall;
    double[] last = rows.rows.get(rows.rows.size() - 1);
    // The velocity became the height before, 0, not the one set.
    assertThat(last[1]).isCloseTo(HEIGHT - GRAVITY * flight * flight / 2, within(1e-7));
  }

  @Test
  void eventThatIsZeroAtTheStartIsReportedAndDoesNotHappenThere() throws IOException {
    Event halfway = event("halfway", minus(q(0), HEIGHT), Direction.FALLING, Action.RECORD);
    Event back = event("back", minus(q(0), HEIGHT), Direction.RISING, Action.RECORD);
    RunReport report = run(model(ball(List.of(), halfway, back), "DTR"), "ode113", 1);

    assertThat(times(report)).isEmpty();
    assertThat(
            report.notes().stream()
                .filter(note -> note.code() == MessageCode.EVENT_NOT_COUNTED)
                .map(Note::text))
        .hasSize(1)
        .allMatch(text -> text.contains("\"halfway\""));
  }

  @Test
  void eventOfAnExpressionThatIsFlatZeroBeforeItRisesHappens() throws IOException {
    Expression depth =
        new Call(MathFunction.MAX, List.of(Expression.of(0), times(-1, minus(q(0), 1))));
    Event touch = event("touch", depth, Direction.RISING, Action.STOP);
    RunReport report = run(model(ball(List.of(), touch), "DTR"), "ode113", 4);

    assertThat(times(report)).hasSize(1);
    assertThat(times(report).get(0)).isCloseTo(Math.sqrt(2 * (HEIGHT - 1) / GRAVITY), within(1e-7));
    assertThat(notCounted(report)).isEmpty();
  }

  @Test
  void whatLooksLikeAnEventAndIsNoneIsReported() throws IOException {
    Expression away = minus(q(0), 0.7 * HEIGHT);
    Event limit = event("limit", minus(q(0), -99), Direction.RISING, Action.STOP);
    Event pole = event("pole", new Power(away, Expression.of(-1)), Direction.BOTH, Action.STOP);
    Event touch =
        event("touch", new Call(MathFunction.ABS, List.of(away)), Direction.BOTH, Action.STOP);
    RunReport report = run(model(ball(List.of(), limit, pole, touch), "DTR"), "ode113", 1);

    assertThat(times(report)).isEmpty();
    List<Note> notes = notCounted(report);
    assertThat(notes.stream().map(Note::text))
        .satisfiesExactly(
            text -> assertThat(text).contains("\"limit\" is 109.0 at the start"),
            text -> assertThat(text).contains("\"pole\" changes its sign through infinity"),
            text -> assertThat(text).contains("\"touch\" comes to zero").contains("turns back"));
    double passed = Math.sqrt(2 * 0.3 * HEIGHT / GRAVITY);
    assertThat(notes.get(1).time()).isCloseTo(passed, within(1e-7));
    assertThat(notes.get(2).time()).isCloseTo(passed, within(1e-7));
  }

  @Test
  void limitPassedAtTheStartIsNotReportedIfItsEventHappensLater() throws IOException {
    Event top = event("up", v(0), Direction.FALLING, Action.RECORD);
    Event fast = event("fast", minus(v(0), -1), Direction.RISING, Action.RECORD);
    RunReport report = run(model(ball(List.of(), bounce(), top, fast), "DTR"), "ode113", 4);

    assertThat(times(report)).hasSizeGreaterThan(2);
    assertThat(notCounted(report)).extracting(Note::text).noneMatch(t -> t.contains("\"fast\""));
  }

  private static List<Note> notCounted(RunReport report) {
    return report.notes().stream()
        .filter(note -> note.code() == MessageCode.EVENT_NOT_COUNTED)
        .toList();
  }

  @Test
  void bouncesThatNeverEndAreNamed() throws IOException {
    RunReport report = run(model(ball(List.of(), bounce()), "DTR"), "ode113", 20);

    Failure failure = ((Outcome.Failed) report.outcome()).failure();
    assertThat(failure.code()).isEqualTo(MessageCode.EVENTS_ACCUMULATE);
    assertThat(failure.part()).contains("bounce");
    double rest = Math.sqrt(2 * HEIGHT / GRAVITY) * (1 + RESTITUTION) / (1 - RESTITUTION);
    assertThat(failure.time()).isCloseTo(rest, within(1e-3));
    assertThat(report.notes().size()).isLessThanOrEqualTo(201);
  }

  @Test
  void valueThatIsNoNumberIsRefusedWithEventAndState() throws IOException {
    Expression root = new Call(MathFunction.SQRT, List.of(v(0)));
    StateChange wrong = new StateChange(0, List.of(), List.of(root));
    Event event = event("broken", q(0), Direction.FALLING, Action.SET, wrong);
    RunReport report = run(model(ball(List.of(), event), "DTR"), "ode113", 5);

    Failure failure = ((Outcome.Failed) report.outcome()).failure();
    assertThat(failure.code()).isEqualTo(MessageCode.EVENT_VALUE_NOT_FINITE);
    assertThat(failure.message()).contains("broken").contains("z.v");
  }

  @Test
  void triggerThatIsNoNumberIsNamed() throws IOException {
    Expression root = new Power(q(0), Expression.of(0.5));
    Event event = event("rooted", root, Direction.FALLING, Action.RECORD);
    RunReport report = run(model(ball(List.of(), event), "DTR"), "ode113", 5);

    Failure failure = ((Outcome.Failed) report.outcome()).failure();
    assertThat(failure.code()).isEqualTo(MessageCode.EVENT_FUNCTION_NOT_FINITE);
    assertThat(failure.part()).contains("rooted");
  }

  @ParameterizedTest
  @CsvSource({
    "DSR, projection, ode113",
    "DSR, projection, ode15s",
    "RR, projection, ode15sR",
    "RR-JF, projection, ode15sR",
    "DSR, penalty, ode113",
    "RR-JF, penalty, ode15sR"
  })
  void pendulumInALoopTurnsRoundAtItsLowestPoint(
      String formulation, String closure, String integrator) throws IOException {
    StateChange backX = new StateChange(0, List.of(), List.of(times(-1, v(0))));
    StateChange backZ = new StateChange(1, List.of(), List.of(times(-1, v(1))));
    Event wall = event("wall", q(0), Direction.FALLING, Action.SET, backX, backZ);
    RunReport report = run(model(slidingPendulum(wall), formulation, closure), integrator, 6);

    assertThat(report.outcome()).isEqualTo(new Outcome.Completed());
    // A quarter of the period from horizontal rest, √(l/g) K(sin²(π/4)); then there and back.
    double quarter = 1.8540746773013719 / Math.sqrt(GRAVITY);
    List<Double> actual = times(report);
    for (int i = 0; i < actual.size(); i++) {
      assertThat(actual.get(i)).isCloseTo((2 * i + 1) * quarter, within(1e-7));
    }
    assertThat(actual).hasSize(5);
    for (double[] row : rows.rows) {
      assertThat(Math.hypot(row[1], row[2])).isCloseTo(1, within(1e-9));
      assertThat(row[1]).isGreaterThan(-1e-8);
    }
  }

  /**
   * The mass comes to rest on a wall that its weight presses it against: the bounces accumulate,
   * and no way of writing the equations may let it slip through the wall instead.
   */
  @ParameterizedTest
  @CsvSource({
    "DSR, projection, ode113",
    "DSR, projection, DE",
    "DSR, projection, ode15s",
    "DSR, projection, switching",
    "RR, projection, ode15sR",
    "RR-JF, projection, ode15sR",
    "DSR, penalty, ode113",
    "RR-JF, penalty, ode15sR"
  })
  void massInALoopThatComesToRestOnAWallStaysOnItsSide(
      String formulation, String closure, String integrator) throws IOException {
    for (double tolerance : new double[] {1e-5, 1e-6, 1e-7}) {
      for (double restitution : new double[] {0.2, 0.5}) {
        rows.rows.clear();
        StateChange back = new StateChange(0, List.of(), List.of(times(-restitution, v(0))));
        Event wall = event("wall", minus(q(0), 0.5), Direction.FALLING, Action.SET, back);
        RunSettings settings = new RunSettings(0, 6, 0.05, integrator, tolerance, tolerance);
        RunReport report =
            new RuntimeSolver()
                .run(
                    model(slidingPendulum(wall), formulation, closure),
                    new RunRequest(settings, EnumSet.of(ColumnGroup.ENERGY)),
                    rows,
                    new RunControl(),
                    Checkpoints.NONE);

        String which = "tolerance " + tolerance + ", restitution " + restitution;
        double lowest = rows.rows.stream().mapToDouble(row -> row[1]).min().orElseThrow();
        assertThat(report.outcome()).as(which).isInstanceOf(Outcome.Failed.class);
        assertThat(((Outcome.Failed) report.outcome()).failure().code())
            .as(which)
            .isEqualTo(MessageCode.EVENTS_ACCUMULATE);
        assertThat(lowest).as(which).isGreaterThan(0.5 - 1e-8);
      }
    }
  }

  /** At 60 degrees the slide is stopped: the mass loses all of its energy of motion. */
  @Test
  void energyThatAnEventTakesIsTold() throws IOException {
    StateChange halt = new StateChange(0, List.of(), List.of(Expression.of(0)));
    Event stop = event("halt", minus(q(0), 0.5), Direction.FALLING, Action.SET, halt);
    RunReport report = run(model(slidingPendulum(stop), "DSR"), "ode113", 0.6);

    double taken = GRAVITY * Math.sqrt(0.75);
    assertThat(report.energyDrift().orElseThrow()).isLessThan(1e-8 * taken);
    assertThat(
            report.notes().stream()
                .filter(note -> note.code() == MessageCode.EVENT_OCCURRED)
                .findFirst())
        .get()
        .extracting(Note::text)
        .asString()
        .contains("the energy changes by -8.496 J")
        .contains("when the loops are closed again");
  }

  @Test
  void eventThatContradictsALoopIsNamed() throws IOException {
    StateChange away = new StateChange(1, List.of(Expression.of(3)), List.of());
    StateChange stay = new StateChange(0, List.of(Expression.of(3)), List.of());
    Event tear = event("tear", q(0), Direction.FALLING, Action.SET, away, stay);
    RunReport report = run(model(slidingPendulum(tear), "DSR"), "ode113", 6);

    Failure failure = ((Outcome.Failed) report.outcome()).failure();
    assertThat(failure.code()).as(failure.message()).isEqualTo(MessageCode.EVENT_BREAKS_LOOPS);
    assertThat(failure.part()).contains("tear");
  }

  @ValueSource(strings = {"ode113", "DE", "ode15s"})
  @ParameterizedTest
  void forceThatJumpsAtAKnownTimeCostsNoRejectedStep(String integrator) throws IOException {
    // Held up from 0.3 s on: free fall, then uniform motion.
    Expression push = times(GRAVITY, new Call(MathFunction.STEP, List.of(minus(new Time(), 0.3))));
    JointForce hold = new JointForce("hold", new JointCoordinate(0, 0), push, Origin.NONE);
    RunReport report = run(model(ball(List.of(hold)), "DTR"), integrator, 1);

    assertThat(report.rejectedSteps()).isZero();
    double speed = GRAVITY * 0.3;
    double[] last = rows.rows.get(rows.rows.size() - 1);
    assertThat(last[1]).isCloseTo(HEIGHT - speed * 0.15 - speed * 0.7, within(1e-8));
    assertThat(last[2]).isCloseTo(-speed, within(1e-8));
  }

  @CsvSource({"DTR, ode113", "RR-JF, ode15sR"})
  @ParameterizedTest
  void runTakenUpBetweenBouncesHasTheSameRowsAndEvents(String formulation, String integrator)
      throws IOException {
    Mechanism mechanism = ball(List.of(), bounce());
    Kept kept = new Kept(0, Optional.empty());
    RunReport whole = run(model(mechanism, formulation), integrator, 8, kept);
    List<double[]> all = List.copyOf(rows.rows);

    assertThat(kept.checkpoints).hasSizeGreaterThan(3 + 11);
    for (int i = 3; i < kept.checkpoints.size(); i += 11) {
      rows.rows.clear();
      Kept from = new Kept(Double.POSITIVE_INFINITY, Optional.of(kept.checkpoints.get(i)));
      RunReport rest = run(model(mechanism, formulation), integrator, 8, from);
      assertThat(rest.notes()).isEqualTo(whole.notes());
      assertThat(rest.steps()).isEqualTo(whole.steps());
      int missing = all.size() - rows.rows.size();
      for (int row = 0; row < rows.rows.size(); row++) {
        assertThat(rows.rows.get(row)).isEqualTo(all.get(missing + row));
      }
    }
  }

  /** Keeps every checkpoint in memory. */
  private static final class Kept implements Checkpoints {
    final List<byte[]> checkpoints = new ArrayList<>();
    private final double secondsBetween;
    private final Optional<byte[]> saved;

    Kept(double secondsBetween, Optional<byte[]> saved) {
      this.secondsBetween = secondsBetween;
      this.saved = saved;
    }

    @Override
    public String modelHash() {
      return "cafe";
    }

    @Override
    public double secondsBetween() {
      return secondsBetween;
    }

    @Override
    public Optional<byte[]> saved() {
      return saved;
    }

    @Override
    public void keep(byte[] checkpoint) {
      checkpoints.add(checkpoint);
    }
  }
}
