package org.mechservice.solver.closure;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.mechservice.solver.api.run.Failure;
import org.mechservice.solver.api.run.Outcome;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.expression.BodyPoint;
import org.mechservice.solver.mechanism.Body;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.closure.DistanceClosure;
import org.mechservice.solver.mechanism.closure.LoopClosure;
import org.mechservice.solver.mechanism.joint.Attachment;
import org.mechservice.solver.mechanism.joint.Joint;
import org.mechservice.solver.mechanism.joint.Revolute;
import org.mechservice.solver.spatial.Rotation;
import org.mechservice.solver.spatial.Vector3;
import org.mechservice.solver.text.Origin;

/** Loops among numbers so large, or speeds so small, that rounding errors are all that is left. */
class RoundedPlacesTest {
  private static final int POSITION = 1;
  private static final int VELOCITY = 3;

  /** Two bars of 1 and 2 m on hinges 3 m apart, their tips held by a rod. */
  private static Mechanism fourBar(double distance, double turned) {
    List<Body> bodies =
        List.of(
            Linkages.bar("left", Vector3.ZERO, Linkages.X, 1),
            Linkages.bar("right", Vector3.ZERO, Linkages.X.times(2), 1));
    Vector3 ground = new Vector3(distance, 0, 0);
    List<Joint> joints =
        List.of(
            hinge(0, ground, turned - 1), hinge(1, new Vector3(distance + 3, 0, 0), turned - 1.2));
    Vector3 leftTip = new Vector3(Math.cos(1), 0, Math.sin(1));
    Vector3 rightTip = new Vector3(3 + 2 * Math.cos(1.2), 0, 2 * Math.sin(1.2));
    return Linkages.mechanism(
        "four-bar",
        bodies,
        joints,
        List.of(rod(new BodyPoint(0, Linkages.X), 2, rightTip.minus(leftTip).norm())));
  }

  private static Revolute hinge(int body, Vector3 at, double angle) {
    Attachment place = new Attachment(BodyPoint.ROOT, at, body, Vector3.ZERO, Rotation.IDENTITY);
    return new Revolute("hinge" + body, place, Linkages.Y, angle, 0, Origin.NONE);
  }

  private static LoopClosure rod(BodyPoint from, double reach, double length) {
    BodyPoint to = new BodyPoint(1, Linkages.X.times(reach));
    return new DistanceClosure("rod", from, to, length, 0, Origin.NONE);
  }

  private static List<double[]> motion(
      Mechanism mechanism, double turned, String formulation, RunSettings settings) {
    SceneRun run = LoopModels.run(mechanism, formulation, settings);
    assertThat(run.report.outcome()).isInstanceOf(Outcome.Completed.class);
    List<double[]> rows = new ArrayList<>(run.rows);
    rows.forEach(row -> row[POSITION] -= turned);
    return rows;
  }

  /**
   * After a million turns an angle is rounded to 1e-9 rad, and rates are by as much: where all of
   * them are in the error test of a high order, with the loops, 1e-6 is the best there is.
   */
  @ParameterizedTest
  @CsvSource({
    "DSR, ode113, 1e-8",
    "DSR, ode15s, 1e-8",
    "DSR penalty, ode113, 1e-8",
    "DSR penalty, DE, 1e-8",
    "DSR penalty, ode15s, 1e-8",
    "RR, ode15sR, 1e-8",
    "RR-JF, ode15sR, 1e-8",
    "RR penalty, ode15sR, 1e-6",
    "RR-JF penalty, ode15sR, 1e-6"
  })
  void linkageMovesTheSameFarFromTheOriginAndAfterManyTurns(
      String formulation, String integrator, double tolerance) {
    RunSettings settings = SceneRun.settings(1, 0.1, integrator, tolerance);
    List<double[]> near = motion(fourBar(0, 0), 0, formulation, settings);
    for (double[] place : new double[][] {{1e6, 0}, {0, 1e4}, {0, 1e6}, {1e6, 1e6}}) {
      double turned = place[1] * 2 * Math.PI;
      List<double[]> far = motion(fourBar(place[0], turned), turned, formulation, settings);
      for (int row = 0; row < near.size(); row++) {
        double allowed = 100 * tolerance;
        assertThat(far.get(row)[POSITION]).isCloseTo(near.get(row)[POSITION], within(allowed));
        assertThat(far.get(row)[VELOCITY]).isCloseTo(near.get(row)[VELOCITY], within(10 * allowed));
      }
    }
  }

  /** As far as the moon numbers lie 6e-8 m apart: all that a start can close. */
  @Test
  void startThatClosesAsFarAsNumbersCanIsTakenAsItIs() {
    RunSettings settings = SceneRun.settings(1, 0.1, "ode113", 1e-6);
    Mechanism far = fourBar(4e8, 0);
    ClosedMechanism closed = new ClosedMechanism(far, "DSR", settings);
    double[] start = new double[closed.start().state().length];
    far.initialState(start);
    assertThat(closed.start().isAssembled()).isTrue();
    assertThat(closed.start().state()).containsExactly(start);
  }

  /**
   * Cranks of 1 and 2 m, 6 m apart and stretched towards a rod of 3 m: all that their gradients are
   * made of is the rounding of π.
   */
  @ParameterizedTest
  @CsvSource({
    "DSR, ode113",
    "DSR, ode15s",
    "RR-JF, ode15sR",
    "DSR penalty, switching",
    "DSR penalty, ode113",
    "DSR penalty, DE",
    "DSR penalty, ode15s",
    "RR penalty, ode15sR",
    "RR-JF penalty, ode15sR"
  })
  void stretchedLinkageEndsWithTheNameOfItsConstraint(String formulation, String integrator) {
    Mechanism stretched =
        Linkages.mechanism(
            "stretched",
            List.of(
                Linkages.bar("left", Vector3.ZERO, Linkages.X, 1),
                Linkages.bar("right", Vector3.ZERO, Linkages.X.times(2), 1)),
            List.of(hinge(0, Vector3.ZERO, 0), hinge(1, new Vector3(6, 0, 0), Math.PI)),
            List.of(rod(new BodyPoint(0, Linkages.X), 2, 3)));
    RunSettings settings = SceneRun.settings(1, 0.1, integrator, 1e-8);
    Outcome outcome = LoopModels.run(stretched, formulation, settings).report.outcome();
    Failure failure = ((Outcome.Failed) outcome).failure();
    assertThat(failure.code()).isEqualTo(MessageCode.SINGULAR_POSITION);
    assertThat(failure.part()).contains("rod");
  }

  @Test
  void structureThatCannotMoveRests() {
    Vector3 tip = new Vector3(2 * Math.cos(1), 0, 2 * Math.sin(1));
    Mechanism strut =
        Linkages.mechanism(
            "strut",
            List.of(Linkages.bar("bar", Vector3.ZERO, Linkages.X.times(2), 1)),
            List.of(hinge(0, Vector3.ZERO, -1)),
            List.of(
                new DistanceClosure(
                    "strut",
                    new BodyPoint(BodyPoint.ROOT, new Vector3(3, 0, 0)),
                    new BodyPoint(0, Linkages.X.times(2)),
                    tip.minus(new Vector3(3, 0, 0)).norm(),
                    0,
                    Origin.NONE)));
    for (double[] row : motion(strut, 0, "DSR", SceneRun.settings(1, 0.1, "ode113", 1e-8))) {
      assertThat(row[POSITION]).isCloseTo(-1, within(1e-12));
    }
  }
}
