package org.mechservice.solver.closure;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.mechservice.solver.api.JointType;
import org.mechservice.solver.api.run.Outcome;
import org.mechservice.solver.closure.Linkages.Hinge;
import org.mechservice.solver.expression.BodyPoint;
import org.mechservice.solver.mechanism.Body;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.closure.DistanceClosure;
import org.mechservice.solver.mechanism.closure.JointClosure;
import org.mechservice.solver.mechanism.joint.Joint;
import org.mechservice.solver.spatial.InertiaTensor;
import org.mechservice.solver.spatial.Vector3;
import org.mechservice.solver.text.Origin;

/** A body without mass that closes a loop between two hinges is a distance. */
class MasslessCouplerTest {
  private static final Vector3 B = new Vector3(0.3, 0, 0.4);
  private static final Vector3 C = new Vector3(1.3, 0, 0.7);
  private static final Vector3 D = new Vector3(1.5, 0, 0);

  private static Body crank() {
    return Linkages.bar("crank", Vector3.ZERO, B, 1);
  }

  private static Body rocker() {
    return Linkages.bar("rocker", C, D, 1.5);
  }

  private static Joint hinge(String name, int body1, int body2, Vector3 point) {
    return new Hinge(name, JointType.R, body1, body2, point, Linkages.Y).joint();
  }

  private static Mechanism withDistance() {
    DistanceClosure distance =
        new DistanceClosure(
            "distance",
            new BodyPoint(0, B),
            new BodyPoint(1, C),
            C.minus(B).norm(),
            0,
            Origin.NONE);
    return Linkages.mechanism(
        "with distance",
        List.of(crank(), rocker()),
        List.of(hinge("A", -1, 0, Vector3.ZERO), hinge("D", -1, 1, D)),
        List.of(distance));
  }

  private static Mechanism withBody() {
    Body coupler = new Body("coupler", 0, B, InertiaTensor.ZERO, Origin.NONE);
    return Linkages.mechanism(
        "with body",
        List.of(crank(), rocker(), coupler),
        List.of(hinge("A", -1, 0, Vector3.ZERO), hinge("D", -1, 1, D), hinge("B", 0, 2, B)),
        List.of(new JointClosure(hinge("C", 2, 1, C))));
  }

  private static SceneRun run(
      Mechanism mechanism, String formulation, String integrator, double tolerance) {
    SceneRun run =
        LoopModels.run(mechanism, formulation, SceneRun.settings(2, 0.1, integrator, tolerance));
    assertThat(run.report.outcome()).isInstanceOf(Outcome.Completed.class);
    return run;
  }

  @CsvSource({
    "DSR, ode113, 1e-12, 1e-9",
    "DSR penalty, ode113, 1e-12, 1e-6",
    "RR-JF, ode15sR, 1e-9, 1e-5",
    "RR, ode15sR, 1e-9, 1e-5"
  })
  @ParameterizedTest
  void aMasslessCouplerMovesCrankAndRockerAsADistanceDoes(
      String formulation, String integrator, double tolerance, double bound) {
    SceneRun distance = run(withDistance(), "DSR", "ode113", 1e-12);
    SceneRun body = run(withBody(), formulation, integrator, tolerance);
    assertThat(body.rows).hasSameSizeAs(distance.rows);
    for (int row = 0; row < distance.rows.size(); row++) {
      for (int i = 1; i <= 2; i++) {
        double expected = distance.rows.get(row)[i];
        assertThat(body.rows.get(row)[i])
            .as("row %s, angle %s", row, i)
            .isCloseTo(expected, within(bound * (1 + Math.abs(expected))));
      }
    }
  }
}
