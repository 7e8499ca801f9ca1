package org.mechservice.solver.closure;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.mechservice.solver.api.JointType;
import org.mechservice.solver.api.run.Failure;
import org.mechservice.solver.api.run.Outcome;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.expression.JointCoordinate;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.PrescribedMotion;
import org.mechservice.solver.mechanism.closure.CoordinateClosure;
import org.mechservice.solver.symbol.MathFunction;
import org.mechservice.solver.text.Origin;

/** A motion of time, the root of 1 − t, whose velocity has no bound near t = 1 s. */
class PrescribedMotionsTest {
  private static final Expression ROOT =
      new Expression.Call(
          MathFunction.SQRT,
          List.of(
              new Expression.Sum(
                  Expression.of(1), new Expression.Negation(new Expression.Time()))));

  @ParameterizedTest
  @CsvSource({
    "DSR, ode113",
    "DSR, ode15s",
    "RR-JF, ode15sR",
    "DSR penalty, ode113",
    "DSR penalty, ode15s",
    "RR-JF penalty, ode15sR"
  })
  void relationThatBreaksOffIsNamedAndNotTheStateThatFollowsIt(
      String formulation, String integrator) {
    Expression angle = new Expression.CoordinatePosition(new JointCoordinate(0, 0));
    Expression relation = new Expression.Sum(angle, new Expression.Negation(ROOT));
    Mechanism pendulums =
        Linkages.twoPendulums(List.of(new CoordinateClosure("retreat", relation, Origin.NONE)));
    Failure failure = failure(pendulums, formulation, integrator);
    assertThat(failure.part()).startsWith("constraint \"retreat\"");
  }

  @ParameterizedTest
  @CsvSource({"DSR, ode113", "RR-JF, ode15sR", "DSR penalty, ode113", "RR penalty, ode15sR"})
  void driveThatBreaksOffIsNamedAndNotTheStateThatFollowsIt(String formulation, String integrator) {
    Mechanism free =
        Linkages.fourBar(List.of(JointType.R, JointType.R, JointType.S, JointType.C), 3);
    Expression turn = new Expression.Product(Expression.of(0.3), ROOT);
    Expression fromStart = new Expression.Sum(turn, Expression.of(-0.3));
    Mechanism driven =
        new Mechanism(
                "driven four-bar",
                Linkages.GROUND,
                free.gravity(),
                free.bodies(),
                free.joints(),
                List.of(new PrescribedMotion(0, List.of(fromStart))),
                free.startRoles(),
                free.closures(),
                List.of(),
                List.of())
            .withArmatures(free.armatures());
    Failure failure = failure(driven, formulation, integrator);
    assertThat(failure.part()).isEqualTo("drive of joint \"A\"");
  }

  private static Failure failure(Mechanism mechanism, String formulation, String integrator) {
    SceneRun run =
        LoopModels.run(mechanism, formulation, SceneRun.settings(1.5, 0.1, integrator, 1e-6));
    Failure failure = ((Outcome.Failed) run.report.outcome()).failure();
    assertThat(failure.code()).isEqualTo(MessageCode.STEP_TOO_SMALL);
    assertThat(failure.cause()).contains("no bound near t = 1.00000 s");
    return failure;
  }
}
