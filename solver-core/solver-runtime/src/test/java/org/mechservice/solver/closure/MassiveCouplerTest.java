package org.mechservice.solver.closure;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.solver.api.JointType;
import org.mechservice.solver.api.run.Outcome;
import org.mechservice.solver.closure.Linkages.Hinge;
import org.mechservice.solver.expression.BodyPoint;
import org.mechservice.solver.mechanism.Body;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.closure.DistanceClosure;
import org.mechservice.solver.mechanism.closure.JointClosure;
import org.mechservice.solver.mechanism.joint.Attachment;
import org.mechservice.solver.mechanism.joint.Joint;
import org.mechservice.solver.mechanism.joint.JointStart;
import org.mechservice.solver.mechanism.joint.Universal;
import org.mechservice.solver.spatial.InertiaTensor;
import org.mechservice.solver.spatial.Rotation;
import org.mechservice.solver.spatial.Vector3;
import org.mechservice.solver.text.Origin;

/** A rod with mass that closes a loop is a slender body between two ball joints. */
class MassiveCouplerTest {
  private static final double ROD_MASS = 2;
  private static final double END = 2;

  /** Where crank, coupler and rocker are joined at the start, and what the outer two turn about. */
  record FourBar(Vector3 b, Vector3 c, Vector3 d, Vector3 crankAxis, Vector3 rockerAxis) {
    static FourBar named(String name) {
      return switch (name) {
        case "planar" ->
            new FourBar(
                new Vector3(0.3, 0, 0.4),
                new Vector3(1.3, 0, 0.7),
                new Vector3(1.5, 0, 0),
                Linkages.Y,
                Linkages.Y);
        case "spatial" ->
            new FourBar(
                new Vector3(0.3, 0.2, 0.1),
                new Vector3(1.1, 0.9, 0.7),
                new Vector3(1.2, 0, 0),
                new Vector3(0, 0.6, 0.8),
                Linkages.Y);
        default -> throw new IllegalArgumentException(name);
      };
    }

    private List<Body> cranks() {
      return List.of(Linkages.bar("crank", Vector3.ZERO, b, 1), Linkages.bar("rocker", c, d, 1.5));
    }

    private List<Joint> hinges() {
      return List.of(
          new Hinge("A", JointType.R, -1, 0, Vector3.ZERO, crankAxis).joint(),
          new Hinge("D", JointType.R, -1, 1, d, rockerAxis).joint());
    }

    /** Crank and rocker, and a rod between their ends that is no body. */
    Mechanism withRod() {
      DistanceClosure rod =
          new DistanceClosure(
              "rod",
              new BodyPoint(0, b),
              new BodyPoint(1, c),
              c.minus(b).norm(),
              ROD_MASS,
              Origin.NONE);
      return Linkages.mechanism("with rod", cranks(), hinges(), List.of(rod));
    }

    /** The same with a body on a Hooke joint, which cannot spin, and a ball joint at its end. */
    Mechanism withBody() {
      Vector3 along = c.minus(b).normalized();
      Vector3 across = along.cross(Linkages.Y).normalized();
      Joint hooke =
          new Universal(
              "B",
              new Attachment(0, b, 2, b, Rotation.IDENTITY),
              along.cross(across),
              across,
              JointStart.atZero(JointType.U),
              false,
              Origin.NONE);
      Joint ball = new Hinge("C", JointType.S, 2, 1, c, Linkages.Y).joint();
      List<Joint> hinges = hinges();
      return Linkages.mechanism(
          "with body",
          List.of(cranks().get(0), cranks().get(1), slender(b, c)),
          List.of(hinges.get(0), hinges.get(1), hooke),
          List.of(new JointClosure(ball)));
    }
  }

  /** m/12 (|w|² 1 − w wᵀ) for a uniform rod along w, which resists no spin about itself. */
  private static Body slender(Vector3 from, Vector3 to) {
    Vector3 w = to.minus(from);
    double k = ROD_MASS / 12;
    InertiaTensor inertia =
        new InertiaTensor(
            k * (w.y() * w.y() + w.z() * w.z()),
            k * (w.x() * w.x() + w.z() * w.z()),
            k * (w.x() * w.x() + w.y() * w.y()),
            -k * w.x() * w.y(),
            -k * w.x() * w.z(),
            -k * w.y() * w.z());
    return new Body("coupler", ROD_MASS, from.plus(to).times(0.5), inertia, Origin.NONE);
  }

  private static SceneRun run(
      Mechanism mechanism, String formulation, String integrator, double tolerance) {
    SceneRun run =
        LoopModels.run(mechanism, formulation, SceneRun.settings(END, 0.1, integrator, tolerance));
    assertThat(run.report.outcome()).isInstanceOf(Outcome.Completed.class);
    return run;
  }

  @CsvSource({
    "planar, DSR, ode113, 1e-12, 1e-9",
    "spatial, DSR, ode113, 1e-12, 1e-9",
    "planar, DSR penalty, ode113, 1e-12, 1e-9",
    "spatial, DSR penalty, ode113, 1e-12, 1e-9",
    "spatial, RR-JF, ode15sR, 1e-8, 1e-5",
    "spatial, RR, ode15sR, 1e-8, 1e-5"
  })
  @ParameterizedTest
  void aRodMovesCrankAndRockerAsASlenderBodyDoes(
      FourBar fourBar, String formulation, String integrator, double tolerance, double bound) {
    SceneRun body = run(fourBar.withBody(), "DSR", "ode113", 1e-12);
    SceneRun rod = run(fourBar.withRod(), formulation, integrator, tolerance);
    assertThat(rod.rows).hasSameSizeAs(body.rows);
    for (int row = 0; row < body.rows.size(); row++) {
      for (int i = 1; i <= 2; i++) {
        double expected = body.rows.get(row)[i];
        assertThat(rod.rows.get(row)[i])
            .as("row %s, angle %s", row, i)
            .isCloseTo(expected, within(bound * (1 + Math.abs(expected))));
      }
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"planar", "spatial"})
  void accelerationsAreThoseOfMaximalCoordinates(FourBar fourBar) {
    for (Mechanism mechanism : List.of(fourBar.withRod(), fourBar.withBody())) {
      LoopComparison compared = LoopComparison.of(mechanism);
      assertThat(compared.freedom()).isEqualTo(1);
      compared
          .forward()
          .forEach(
              (formulation, error) ->
                  assertThat(error).as(formulation).isLessThan(compared.forwardBound()));
    }
  }
}
