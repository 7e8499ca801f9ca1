package org.mechservice.solver.simulation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.util.Collections;
import java.util.EnumSet;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.mechservice.solver.api.result.ColumnGroup;
import org.mechservice.solver.api.run.Checkpoints;
import org.mechservice.solver.api.run.Failure;
import org.mechservice.solver.api.run.Outcome;
import org.mechservice.solver.api.run.RunControl;
import org.mechservice.solver.api.run.RunReport;
import org.mechservice.solver.api.run.RunRequest;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.compact.CompactModel;
import org.mechservice.solver.compact.DataDriven;
import org.mechservice.solver.expression.BodyPoint;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.expression.Expression.Call;
import org.mechservice.solver.expression.Expression.Product;
import org.mechservice.solver.expression.Expression.Sum;
import org.mechservice.solver.expression.Expression.Time;
import org.mechservice.solver.force.user.UserForceSource;
import org.mechservice.solver.mechanism.Body;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.PrescribedMotion;
import org.mechservice.solver.mechanism.Root;
import org.mechservice.solver.mechanism.closure.DistanceClosure;
import org.mechservice.solver.mechanism.closure.LoopClosure;
import org.mechservice.solver.mechanism.joint.Attachment;
import org.mechservice.solver.mechanism.joint.Joint;
import org.mechservice.solver.mechanism.joint.Prismatic;
import org.mechservice.solver.mechanism.joint.Revolute;
import org.mechservice.solver.mechanism.joint.StartRole;
import org.mechservice.solver.spatial.InertiaTensor;
import org.mechservice.solver.spatial.Rotation;
import org.mechservice.solver.spatial.Vector3;
import org.mechservice.solver.symbol.MathFunction;
import org.mechservice.solver.text.Origin;

/**
 * A cart that turns round at t = 0.5 s from −1 to 1 m/s, without gravity, and what hangs on it. It
 * moves along until then, so that all that follows is due to the impulse.
 */
class DrivenKinkTest {
  private static final Vector3 X = new Vector3(1, 0, 0);
  private static final Vector3 Y = new Vector3(0, 1, 0);
  private static final Vector3 Z = new Vector3(0, 0, 1);
  private static final double TURN = 0.5;
  private static final double JUMP = 2;
  private static final Expression LATE = new Sum(new Time(), Expression.of(-TURN));

  /** |t − 0.5|, and a formula of the same kind whose kink no line in t tells. */
  private static final Expression KINK = new Call(MathFunction.ABS, List.of(LATE));

  private static final Expression SINE_KINK =
      new Call(MathFunction.ABS, List.of(new Call(MathFunction.SIN, List.of(LATE))));

  private final RecordedRows rows = new RecordedRows();

  private static Body body(String name, double mass, Vector3 center, double inertia) {
    return new Body(
        name, mass, center, new InertiaTensor(inertia, inertia, 0, 0, 0, 0), Origin.NONE);
  }

  private static Attachment on(int parent, int child) {
    return new Attachment(parent, Vector3.ZERO, child, Vector3.ZERO, Rotation.IDENTITY);
  }

  private static Mechanism mechanism(
      Expression motion, List<Body> bodies, List<Joint> joints, List<LoopClosure> closures) {
    return new Mechanism(
        "Cart",
        new Root("ground", Vector3.ZERO, Rotation.IDENTITY),
        Vector3.ZERO,
        bodies,
        joints,
        List.of(new PrescribedMotion(0, List.of(motion))),
        Collections.nCopies(joints.size(), StartRole.PREFERRED),
        closures,
        List.of(),
        List.of());
  }

  /** A thin bar of 1 kg and 1 m that hangs from the cart. */
  private static Mechanism cartAndBar(Expression motion) {
    return mechanism(
        motion,
        List.of(body("cart", 2, Vector3.ZERO, 0), body("bar", 1, Z.times(-0.5), 1.0 / 12)),
        List.of(
            new Prismatic("drive", on(-1, 0), X, 0, 0, Origin.NONE),
            new Revolute("hinge", on(0, 1), Y, 0, 0, Origin.NONE)),
        List.of());
  }

  /**
   * A mass on two slides, held 1 m from the cart in the direction (0.6, 0, −0.8).
   *
   * @param onCart whether the slides stand on the cart, or on the ground
   */
  private static Mechanism cartAndRod(boolean onCart) {
    double start = onCart ? 0.6 : 0.6 + TURN;
    double speed = onCart ? 0 : -1;
    return mechanism(
        KINK,
        List.of(
            body("cart", 2, Vector3.ZERO, 0),
            body("slide", 0, Vector3.ZERO, 0),
            body("mass", 1, Vector3.ZERO, 0)),
        List.of(
            new Prismatic("drive", on(-1, 0), X, 0, 0, Origin.NONE),
            new Prismatic("x", on(onCart ? 0 : -1, 1), X, start, speed, Origin.NONE),
            new Prismatic("z", on(1, 2), Z, -0.8, 0, Origin.NONE)),
        List.of(
            new DistanceClosure(
                "rod",
                new BodyPoint(0, Vector3.ZERO),
                new BodyPoint(2, Vector3.ZERO),
                1,
                0,
                Origin.NONE)));
  }

  private RunReport run(Mechanism mechanism, String formulation, String closure, String integrator)
      throws IOException {
    RunSettings settings = new RunSettings(0, 1, 0.25, integrator, 1e-10, 1e-10);
    CompactModel model = new CompactModel(mechanism, formulation, closure, settings);
    return new RuntimeSolver()
        .run(
            DataDriven.model(model, UserForceSource.NONE),
            new RunRequest(settings, EnumSet.of(ColumnGroup.ENERGY)),
            rows,
            new RunControl(),
            Checkpoints.NONE);
  }

  private double[] end() {
    return rows.rows.get(rows.rows.size() - 1);
  }

  private static void assertToldOnce(RunReport report) {
    assertThat(report.outcome()).isEqualTo(new Outcome.Completed());
    assertThat(report.notes())
        .filteredOn(note -> note.code() == MessageCode.DRIVEN_VELOCITY_JUMPED)
        .singleElement()
        .satisfies(note -> assertThat(note.text()).contains("\"drive\""))
        .satisfies(note -> assertThat(note.time()).isCloseTo(TURN, within(1e-12)));
  }

  /** The impulse at the hinge gives the bar the angular velocity 3/2 Δv / L. */
  @ParameterizedTest
  @CsvSource({
    "DTR, DE",
    "DTR, ode113",
    "DSR, ode113",
    "DTR, ode15s",
    "RR, ode15sR",
    "RR-JF, ode15sR"
  })
  void barOnACartThatTurnsRoundGetsThreeHalvesOfTheJumpOverItsLength(
      String formulation, String integrator) throws IOException {
    RunReport report = run(cartAndBar(KINK), formulation, "none", integrator);

    assertToldOnce(report);
    double spin = 1.5 * JUMP;
    // The sign is that of a turn about y under a cart that is pushed towards x.
    assertThat(end()[2]).isCloseTo(spin, within(1e-9));
    assertThat(end()[1]).isCloseTo(spin * TURN, within(1e-9));
    // A hundred times the tolerance: it is one per step, and there are dozens.
    assertThat(report.energyDrift().orElseThrow()).isLessThan(1e-8);
  }

  @Test
  void kinkIsFoundWhereNoLineInTimeTellsIt() throws IOException {
    RunReport report = run(cartAndBar(SINE_KINK), "DTR", "none", "ode113");

    assertToldOnce(report);
    assertThat(report.energyDrift().orElseThrow()).isLessThan(1e-8);
  }

  /** Along the rod n the mass takes the jump's part: Δv = n (n · Δv e_x); then it turns evenly. */
  @ParameterizedTest
  @CsvSource({
    "true, DSR, projection, ode113",
    "false, DSR, projection, ode113",
    "true, DSR, projection, ode15s",
    "true, RR, projection, ode15sR",
    "false, RR-JF, projection, ode15sR",
    "true, DSR, penalty, ode113"
  })
  void massAtARodTakesThePartOfTheJumpAlongIt(
      boolean onCart, String formulation, String closure, String integrator) throws IOException {
    RunReport report = run(cartAndRod(onCart), formulation, closure, integrator);

    assertToldOnce(report);
    double spin = JUMP * 0.8;
    double angle = StrictMath.atan2(-0.8, 0.6) - spin * TURN;
    double cart = onCart ? 0 : TURN;
    // What the tolerance of a step becomes over half a turn.
    assertThat(end()[1]).isCloseTo(cart + StrictMath.cos(angle), within(1e-7));
    assertThat(end()[2]).isCloseTo(StrictMath.sin(angle), within(1e-7));
  }

  @Test
  void positionThatJumpsEndsTheRunByName() throws IOException {
    Expression step = new Product(Expression.of(0.1), new Call(MathFunction.STEP, List.of(LATE)));
    RunReport report = run(cartAndBar(step), "DTR", "none", "DE");

    Failure failure = ((Outcome.Failed) report.outcome()).failure();
    assertThat(failure.code()).isEqualTo(MessageCode.DRIVEN_POSITION_JUMPS);
    assertThat(failure.part()).isEqualTo("joint \"drive\"");
    assertThat(failure.time()).isCloseTo(TURN, within(1e-12));
    assertThat(rows.rows).hasSize(3);
  }
}
