package org.mechservice.solver.closure;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Collections;
import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.mechservice.solver.api.JointType;
import org.mechservice.solver.api.run.Outcome;
import org.mechservice.solver.closure.Linkages.Hinge;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.mechanism.Body;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.PrescribedMotion;
import org.mechservice.solver.mechanism.closure.JointClosure;
import org.mechservice.solver.mechanism.closure.LoopClosure;
import org.mechservice.solver.mechanism.joint.Joint;
import org.mechservice.solver.mechanism.joint.StartRole;
import org.mechservice.solver.spatial.Vector3;

/**
 * A crank that turns at constant speed moves a slider by a rod, over many turns and both dead
 * points; it starts stretched along the slide.
 *
 * <pre>
 *        o
 *       / `--.__
 *      /        `--.__
 *     O               [ ]---> x
 * </pre>
 */
class DrivenSliderTest {
  private static final double CRANK = 0.3;
  private static final double ROD = 0.8;
  private static final double SPEED = 5;
  private static final double END = 4;

  private static final Vector3 PIN = new Vector3(CRANK, 0, 0);
  private static final Vector3 SLIDER = new Vector3(CRANK + ROD, 0, 0);
  private static final List<Body> BODIES =
      List.of(
          Linkages.bar("crank", Vector3.ZERO, PIN, 1),
          Linkages.bar("rod", PIN, SLIDER, 0.7),
          Linkages.bar("slider", SLIDER, SLIDER.plus(Linkages.Z.times(0.1)), 0.5));
  private static final Expression ANGLE =
      new Expression.Product(Expression.of(SPEED), new Expression.Time());

  private static Joint hinge(String name, JointType type, int from, int to, Vector3 at) {
    return new Hinge(name, type, from, to, at, Linkages.Y).joint();
  }

  private static Joint slide() {
    return new Hinge("slide", JointType.P, -1, 2, SLIDER, Linkages.X).joint();
  }

  private static Mechanism mechanism(
      List<Joint> joints, List<PrescribedMotion> motions, LoopClosure closure) {
    return new Mechanism(
        "driven slider",
        Linkages.GROUND,
        Linkages.Z.times(-9.81),
        BODIES,
        joints,
        motions,
        Collections.nCopies(joints.size(), StartRole.PREFERRED),
        List.of(closure),
        List.of(),
        List.of());
  }

  /** Crank, driven, and rod in the tree; cut where the rod takes the slider along. */
  private static Mechanism drivenInTheTree(JointType cut) {
    return mechanism(
        List.of(
            hinge("crank", JointType.R, -1, 0, Vector3.ZERO),
            hinge("pin", JointType.R, 0, 1, PIN),
            slide()),
        List.of(new PrescribedMotion(0, List.of(ANGLE))),
        new JointClosure(hinge("end", cut, 1, 2, SLIDER)));
  }

  /** Slider, rod and crank in the tree; cut, and driven, where the crank stands on ground. */
  private static Mechanism drivenAtTheCut() {
    return mechanism(
        List.of(
            slide(), hinge("end", JointType.R, 2, 1, SLIDER), hinge("pin", JointType.R, 1, 0, PIN)),
        List.of(),
        new JointClosure(
            hinge("crank", JointType.R, -1, 0, Vector3.ZERO), StartRole.PREFERRED, List.of(ANGLE)));
  }

  /** Way of the slider from where it starts, m: r cos θ + √(l² − r² sin² θ) − (r + l). */
  private static double way(double t) {
    double rise = CRANK * Math.sin(SPEED * t);
    return CRANK * Math.cos(SPEED * t) + Math.sqrt(ROD * ROD - rise * rise) - CRANK - ROD;
  }

  /** Its derivative, m/s. */
  private static double speed(double t) {
    double sin = Math.sin(SPEED * t);
    double cos = Math.cos(SPEED * t);
    double level = Math.sqrt(ROD * ROD - CRANK * CRANK * sin * sin);
    return -SPEED * CRANK * sin * (1 + CRANK * cos / level);
  }

  @CsvSource({
    "S, DSR, ode113, 1e-10, 1e-9",
    "R, DSR, ode113, 1e-10, 1e-9",
    "R, DSR, ode113, 1e-4, 1e-9",
    "R, DSR, DE, 1e-10, 1e-9",
    "R, DSR, ode15s, 1e-6, 1e-9",
    "R, RR, ode15sR, 1e-6, 1e-9",
    "R, RR-JF, ode15sR, 1e-6, 1e-9",
    "R, DSR penalty, ode113, 1e-11, 1e-9"
  })
  @ParameterizedTest
  void sliderIsWhereTheClosedFormSays(
      JointType cut, String formulation, String integrator, double tolerance, double bound) {
    assertFollows(drivenInTheTree(cut), 2, formulation, integrator, tolerance, bound);
  }

  @CsvSource({
    "DSR, ode113, 1e-10, 1e-9",
    "RR, ode15sR, 1e-6, 1e-9",
    "RR-JF, ode15sR, 1e-6, 1e-9",
    "DSR penalty, ode113, 1e-11, 1e-9"
  })
  @ParameterizedTest
  void sliderIsWhereTheClosedFormSaysIfTheDrivenJointIsCut(
      String formulation, String integrator, double tolerance, double bound) {
    assertFollows(drivenAtTheCut(), 0, formulation, integrator, tolerance, bound);
  }

  private static void assertFollows(
      Mechanism mechanism,
      int slide,
      String formulation,
      String integrator,
      double tolerance,
      double bound) {
    SceneRun run =
        LoopModels.run(mechanism, formulation, SceneRun.settings(END, 0.1, integrator, tolerance));
    assertThat(run.report.outcome()).isInstanceOf(Outcome.Completed.class);
    int q = 1 + mechanism.positionOffset(slide);
    int v = 1 + mechanism.positionCount() + mechanism.velocityOffset(slide);
    for (double[] row : run.rows) {
      assertThat(row[q]).as("way at %s s", row[0]).isCloseTo(way(row[0]), within(bound));
      assertThat(row[v])
          .as("speed at %s s", row[0])
          .isCloseTo(speed(row[0]), within(SPEED * bound));
    }
  }
}
