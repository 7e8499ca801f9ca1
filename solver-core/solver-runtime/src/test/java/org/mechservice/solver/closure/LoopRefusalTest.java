package org.mechservice.solver.closure;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;
import static org.mechservice.solver.api.JointType.C;
import static org.mechservice.solver.api.JointType.R;
import static org.mechservice.solver.api.JointType.S;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.solver.api.run.Failure;
import org.mechservice.solver.api.run.Outcome;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.closure.assembly.LoopFinding;
import org.mechservice.solver.expression.BodyPoint;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.expression.JointCoordinate;
import org.mechservice.solver.force.user.UserForceSource;
import org.mechservice.solver.mechanism.Body;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.closure.DistanceClosure;
import org.mechservice.solver.mechanism.closure.LoopClosure;
import org.mechservice.solver.mechanism.force.JointForce;
import org.mechservice.solver.mechanism.joint.Joint;
import org.mechservice.solver.mechanism.joint.StartRole;
import org.mechservice.solver.spatial.InertiaTensor;
import org.mechservice.solver.spatial.Vector3;
import org.mechservice.solver.symbol.MathFunction;
import org.mechservice.solver.text.Origin;

/** Loops that cannot be simulated end in a message that names what is wrong, never in a NaN. */
class LoopRefusalTest {
  private static final RunSettings SETTINGS = SceneRun.settings(1, 0.1, "ode113", 1e-6);
  private static final Mechanism FOUR_BAR = Linkages.fourBar(List.of(R, R, S, C), 3);

  private static Mechanism with(List<LoopClosure> more, StartRole role) {
    List<LoopClosure> closures = new ArrayList<>(FOUR_BAR.closures());
    closures.addAll(more);
    return new Mechanism(
        "refused",
        FOUR_BAR.root(),
        FOUR_BAR.gravity(),
        FOUR_BAR.bodies(),
        FOUR_BAR.joints(),
        List.of(),
        Collections.nCopies(FOUR_BAR.joints().size(), role),
        closures,
        List.of(),
        List.of());
  }

  private static LoopClosure rod(double length) {
    return new DistanceClosure(
        "strut",
        new BodyPoint(BodyPoint.ROOT, new Vector3(1.5, 0, 0)),
        new BodyPoint(0, new Vector3(0.3, 0, 0.4)),
        length,
        0,
        Origin.NONE);
  }

  @Test
  void aLinkageThatCannotMoveStaysWhereItIs() {
    Mechanism braced = with(List.of(rod(Math.hypot(1.2, 0.4))), StartRole.PREFERRED);
    ClosedMechanism closed = new ClosedMechanism(braced, "DSR", SETTINGS);
    assertThat(closed.freedom()).isZero();
    for (String formulation : List.of("DSR", "DSR penalty")) {
      SceneRun run = LoopModels.run(braced, formulation, SETTINGS);
      assertThat(run.report.outcome()).isInstanceOf(Outcome.Completed.class);
      for (double[] row : run.rows) {
        for (int i = 1; i < row.length; i++) {
          assertThat(row[i]).isCloseTo(run.rows.get(0)[i], within(1e-11));
        }
      }
    }
  }

  /** Rods across the plane in which two bars side by side swing: at the start they hold nothing. */
  private static Mechanism barsHeldAcrossTheirPlane() {
    Body left = bar("left");
    Body right = bar("right");
    List<Joint> hinges =
        List.of(
            new Linkages.Hinge("a", R, BodyPoint.ROOT, 0, Vector3.ZERO, Linkages.Y).joint(),
            new Linkages.Hinge("b", R, BodyPoint.ROOT, 1, Linkages.Y.times(3), Linkages.Y).joint());
    List<LoopClosure> rods = new ArrayList<>();
    for (double along : new double[] {0.5, 1}) {
      rods.add(
          new DistanceClosure(
              "rod at " + along,
              new BodyPoint(0, Linkages.X.times(along)),
              new BodyPoint(1, new Vector3(along, 3, 0)),
              3,
              0,
              Origin.NONE));
    }
    return Linkages.mechanism("across", List.of(left, right), hinges, rods);
  }

  private static Body bar(String name) {
    return new Body(name, 1, Linkages.X, InertiaTensor.ZERO, Origin.NONE);
  }

  @ParameterizedTest
  @ValueSource(strings = {"DSR", "RR", "RR-JF"})
  void aStartThatHidesAllEquationsIsRefusedByProjectionWithWhatHelps(String formulation) {
    Mechanism across = barsHeldAcrossTheirPlane();
    String integrator = formulation.equals("DSR") ? "ode113" : "ode15sR";
    RunSettings settings = SceneRun.settings(1, 0.1, integrator, 1e-6);
    assertThat(new ClosedMechanism(across, formulation, settings).start().againstProjection())
        .isPresent();
    Outcome outcome = LoopModels.run(across, formulation, settings).report.outcome();
    assertThat(outcome).isInstanceOf(Outcome.Failed.class);
    Failure failure = ((Outcome.Failed) outcome).failure();
    assertThat(failure.code()).isEqualTo(MessageCode.SINGULAR_POSITION);
    assertThat(failure.message()).contains("rod at", "start in a singular position", "penalty");
  }

  @Test
  void constraintsThatContradictEachOtherAreNamedWithWhatIsLeftOpen() {
    Mechanism torn = with(List.of(rod(3)), StartRole.PREFERRED);
    ClosedMechanism closed = new ClosedMechanism(torn, "DSR", SETTINGS);
    assertThat(closed.start().isAssembled()).isFalse();
    LoopFinding finding = closed.start().findings().get(closed.start().findings().size() - 1);
    assertThat(finding.kind()).isEqualTo(LoopFinding.Kind.NOT_CLOSED);
    assertThat(finding.part()).startsWith("constraint \"");
    assertThat(Math.abs(finding.amount())).isGreaterThan(0.1);
    assertThatIllegalArgumentException().isThrownBy(() -> LoopModels.of(torn, "DSR", SETTINGS));
  }

  @Test
  void jointsFixedAtTheStartAreNotMovedToCloseALoop() {
    Mechanism fixed = with(List.of(rod(1.2)), StartRole.FIXED);
    ClosedMechanism closed = new ClosedMechanism(fixed, "DSR", SETTINGS);
    assertThat(closed.start().isAssembled()).isFalse();
    double[] given = new double[fixed.positionCount() + fixed.velocityCount()];
    fixed.initialState(given);
    assertThat(closed.start().state()).containsExactly(given);
    assertThat(closed.start().findings().get(0).part()).startsWith("constraint \"strut\"");
  }

  /** What is too little for a warning would stay in the equations of penalty closure. */
  @Test
  void aStartThatIsGivenToRoundingOnlyIsClosedAllTheSame() {
    Mechanism exact = Linkages.slidingPendulum(0);
    LoopClosure rod =
        new DistanceClosure(
            "rod",
            new BodyPoint(BodyPoint.ROOT, Vector3.ZERO),
            new BodyPoint(1, Vector3.ZERO),
            1 + 1e-11,
            0,
            Origin.NONE);
    Mechanism almost = Linkages.mechanism("almost", exact.bodies(), exact.joints(), List.of(rod));
    ClosedMechanism closed = new ClosedMechanism(almost, "DSR", SETTINGS);
    assertThat(closed.start().findings()).isEmpty();
    ClosedTree work = new ClosedTree(closed.tree(), UserForceSource.NONE);
    work.place(0, closed.start().state());
    assertThat(work.loops.largestResidual()).isLessThan(1e-13);
  }

  @Test
  void aStartThatClosesTheLoopsStaysAsItIsToTheBit() {
    Mechanism moving = Linkages.slidingPendulum(0);
    double[] given = new double[4];
    moving.initialState(given);
    assertThat(new ClosedMechanism(moving, "DSR", SETTINGS).start().state()).containsExactly(given);
  }

  @ParameterizedTest
  @ValueSource(doubles = {0, -1, Double.NaN, Double.POSITIVE_INFINITY})
  void aDistanceThatIsNotPositiveIsRefusedByName(double length) {
    assertThatIllegalArgumentException()
        .isThrownBy(() -> rod(length))
        .withMessageContaining("strut");
  }

  @ParameterizedTest
  @ValueSource(strings = {"DSR", "DSR penalty"})
  void aLoopWithoutMassNamesAJoint(String formulation) {
    List<Body> massless =
        FOUR_BAR.bodies().stream()
            .map(body -> new Body(body.name(), 0, Vector3.ZERO, InertiaTensor.ZERO, Origin.NONE))
            .toList();
    Mechanism empty =
        Linkages.mechanism("massless", massless, FOUR_BAR.joints(), FOUR_BAR.closures());
    SceneRun run = LoopModels.run(empty, formulation, SETTINGS);
    Failure failure = ((Outcome.Failed) run.report.outcome()).failure();
    assertThat(failure.code()).isEqualTo(MessageCode.SINGULAR_INERTIA);
    assertThat(failure.part()).startsWith("joint \"");
  }

  @ParameterizedTest
  @ValueSource(strings = {"DSR", "RR", "RR-JF", "DSR penalty", "RR penalty", "RR-JF penalty"})
  void aForceThatIsNotFiniteIsNamedWithItsTime(String formulation) {
    Expression angle = new Expression.CoordinatePosition(new JointCoordinate(0, 0));
    Expression breaking =
        new Expression.Call(
            MathFunction.SQRT, List.of(new Expression.Sum(Expression.of(0.2), angle)));
    Expression other = new Expression.Negation(breaking);
    Mechanism pushed =
        new Mechanism(
                "pushed",
                FOUR_BAR.root(),
                FOUR_BAR.gravity(),
                FOUR_BAR.bodies(),
                FOUR_BAR.joints(),
                List.of(),
                FOUR_BAR.startRoles(),
                FOUR_BAR.closures(),
                List.of(
                    new JointForce("breaking", new JointCoordinate(0, 0), breaking, Origin.NONE),
                    new JointForce("balance", new JointCoordinate(0, 0), other, Origin.NONE)),
                List.of())
            .withArmatures(FOUR_BAR.armatures());
    String integrator = formulation.startsWith("RR") ? "ode15sR" : "ode113";
    RunSettings settings = SceneRun.settings(3, 0.1, integrator, 1e-6);
    SceneRun run = LoopModels.run(pushed, formulation, settings);
    Failure failure = ((Outcome.Failed) run.report.outcome()).failure();
    assertThat(failure.code()).isEqualTo(MessageCode.FORCE_NOT_FINITE);
    assertThat(failure.part()).contains("breaking");
    assertThat(failure.time()).isPositive();
    assertThat(run.rows).allMatch(row -> Arrays.stream(row).allMatch(Double::isFinite));
  }
}
