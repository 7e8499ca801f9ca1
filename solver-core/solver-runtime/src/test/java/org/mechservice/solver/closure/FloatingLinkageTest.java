package org.mechservice.solver.closure;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.mechservice.solver.api.JointType;
import org.mechservice.solver.api.capability.ExplicitModel;
import org.mechservice.solver.api.run.Outcome;
import org.mechservice.solver.closure.Linkages.Hinge;
import org.mechservice.solver.closure.model.LoopModel;
import org.mechservice.solver.expression.BodyPoint;
import org.mechservice.solver.mechanism.Body;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.closure.JointClosure;
import org.mechservice.solver.mechanism.joint.Attachment;
import org.mechservice.solver.mechanism.joint.Free;
import org.mechservice.solver.mechanism.joint.Joint;
import org.mechservice.solver.mechanism.joint.JointStart;
import org.mechservice.solver.mechanism.joint.Revolute;
import org.mechservice.solver.mechanism.joint.StartRole;
import org.mechservice.solver.oracle.GlobalFormulation;
import org.mechservice.solver.oracle.TaylorPose;
import org.mechservice.solver.oracle.TaylorVector;
import org.mechservice.solver.spatial.InertiaTensor;
import org.mechservice.solver.spatial.Rotation;
import org.mechservice.solver.spatial.Vector3;
import org.mechservice.solver.text.Origin;

/**
 * A four-bar on a body that floats and tumbles without gravity: whatever the loop does, it does
 * within.
 *
 * <pre>
 *      B ------ C
 *     /          \
 *    A== base ====D
 * </pre>
 */
class FloatingLinkageTest {
  private static final double END = 2;

  private static Mechanism floating(JointType cut) {
    Vector3 a = new Vector3(0, 0, 0);
    Vector3 b = new Vector3(0.3, 0, 0.4);
    Vector3 c = new Vector3(1.3, 0, 0.7);
    Vector3 d = new Vector3(1.5, 0, 0);
    InertiaTensor ofBase = new InertiaTensor(0.5, 0.7, 0.6, 0.02, -0.05, 0.03);
    List<Body> bodies =
        List.of(
            new Body("base", 4, new Vector3(0.7, 0.1, -0.2), ofBase, Origin.NONE),
            Linkages.bar("AB", a, b, 1),
            Linkages.bar("BC", b, c, 2),
            Linkages.bar("CD", c, d, 1.5));
    Attachment onBase =
        new Attachment(BodyPoint.ROOT, Vector3.ZERO, 0, Vector3.ZERO, Rotation.IDENTITY);
    JointStart tumbling =
        new JointStart(
            List.of(1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0), List.of(0.3, -0.4, 0.5, 1.0, 0.5, -0.2));
    List<Joint> joints =
        List.of(
            new Free("floats", onBase, tumbling, false, Origin.NONE),
            turning("A", 0, 1, a, 2),
            turning("B", 1, 2, b, 0),
            turning("D", 0, 3, d, 0));
    Joint closing = new Hinge("C", cut, 2, 3, c, Linkages.Y).joint();
    return new Mechanism(
        "floating four-bar",
        Linkages.GROUND,
        Vector3.ZERO,
        bodies,
        joints,
        List.of(),
        Collections.nCopies(joints.size(), StartRole.PREFERRED),
        List.of(new JointClosure(closing)),
        List.of(),
        List.of());
  }

  private static Joint turning(String name, int parent, int child, Vector3 at, double speed) {
    Attachment there = new Attachment(parent, at, child, at, Rotation.IDENTITY);
    return new Revolute(name, there, Linkages.Y, 0, speed, Origin.NONE);
  }

  /**
   * Momentum and moment of momentum about the world's origin, or how they change, by the oracle's
   * motion of the bodies: not by the solver's own.
   *
   * @param linear kg m/s, or N
   * @param angular kg m²/s, or N m
   * @param scale sum of the sizes of what was added up
   */
  private record Momentum(Vector3 linear, Vector3 angular, double scale) {
    private static final Momentum NONE = new Momentum(Vector3.ZERO, Vector3.ZERO, 0);

    private Momentum plus(double mass, Vector3 place, Vector3 moving, Vector3 spin) {
      Vector3 p = moving.times(mass);
      Vector3 l = place.cross(p).plus(spin);
      return new Momentum(linear.plus(p), angular.plus(l), scale + p.norm() + l.norm());
    }

    static Momentum of(Mechanism mechanism, TaylorPose[] poses) {
      Momentum sum = NONE;
      for (int b = 0; b < poses.length; b++) {
        Body body = mechanism.bodies().get(b);
        InertiaTensor inertia = body.inertia().in(poses[b].rotation().value());
        TaylorVector center = poses[b].at(body.centerOfMass());
        Vector3 omega = poses[b].rotation().angularVelocity();
        sum = sum.plus(body.mass(), center.value(), center.rate(), inertia.times(omega));
      }
      return sum;
    }

    /** I α + ω × I ω, and m a. */
    static Momentum rateOf(Mechanism mechanism, TaylorPose[] poses) {
      Momentum sum = NONE;
      for (int b = 0; b < poses.length; b++) {
        Body body = mechanism.bodies().get(b);
        InertiaTensor inertia = body.inertia().in(poses[b].rotation().value());
        TaylorVector center = poses[b].at(body.centerOfMass());
        Vector3 omega = poses[b].rotation().angularVelocity();
        Vector3 spin =
            inertia
                .times(poses[b].rotation().angularAcceleration())
                .plus(omega.cross(inertia.times(omega)));
        sum = sum.plus(body.mass(), center.value(), center.acceleration(), spin);
      }
      return sum;
    }
  }

  private static TaylorPose[] poses(Mechanism mechanism, double[] y, double[] a) {
    double[] v = Arrays.copyOfRange(y, mechanism.positionCount(), y.length);
    return new GlobalFormulation(mechanism, List.of()).poses(0, y, v, a);
  }

  @CsvSource({"R, DSR", "S, DSR", "R, DSR penalty", "S, DSR penalty"})
  @ParameterizedTest
  void noAccelerationChangesTheMomentum(JointType cut, String formulation) {
    Mechanism mechanism = floating(cut);
    LoopModel model =
        LoopModels.of(mechanism, formulation, SceneRun.settings(END, 0.25, "ode113", 1e-6));
    SceneRun run = SceneRun.of(model);
    assertThat(run.report.outcome()).isEqualTo(new Outcome.Completed());
    for (double[] row : run.rows) {
      double[] y = Arrays.copyOfRange(row, 1, 1 + model.description().stateCount());
      double[] yDot = new double[y.length];
      assertThat(model.derivative(row[0], y, yDot)).isEqualTo(ExplicitModel.REGULAR);
      double[] a = Arrays.copyOfRange(yDot, mechanism.positionCount(), y.length);
      Momentum rate = Momentum.rateOf(mechanism, poses(mechanism, y, a));
      assertThat(rate.linear().norm()).isCloseTo(0, within(1e-13 * rate.scale()));
      assertThat(rate.angular().norm()).isCloseTo(0, within(1e-13 * rate.scale()));
    }
  }

  @CsvSource({
    "R, DSR, ode113, 1e-12, 1e-11",
    "S, DSR, ode113, 1e-12, 1e-11",
    "R, DSR penalty, ode113, 1e-12, 1e-11",
    "R, DSR, ode15s, 1e-8, 1e-6",
    "R, RR, ode15sR, 1e-8, 1e-6",
    "R, RR-JF, ode15sR, 1e-8, 1e-6"
  })
  @ParameterizedTest
  void momentumStaysWhatItWas(
      JointType cut, String formulation, String integrator, double tolerance, double bound) {
    Mechanism mechanism = floating(cut);
    SceneRun run =
        LoopModels.run(mechanism, formulation, SceneRun.settings(END, END, integrator, tolerance));
    assertThat(run.report.outcome()).isInstanceOf(Outcome.Completed.class);
    Momentum first = momentum(mechanism, run.at(0));
    Momentum last = momentum(mechanism, run.at(END));
    assertThat(last.linear().minus(first.linear()).norm())
        .isCloseTo(0, within(bound * first.scale()));
    assertThat(last.angular().minus(first.angular()).norm())
        .isCloseTo(0, within(bound * first.scale()));
    // the linkage has moved
    assertThat(run.at(END)[1 + 7]).isNotCloseTo(0, within(0.1));
  }

  private static Momentum momentum(Mechanism mechanism, double[] row) {
    int states = mechanism.positionCount() + mechanism.velocityCount();
    double[] y = Arrays.copyOfRange(row, 1, 1 + states);
    return Momentum.of(mechanism, poses(mechanism, y, new double[mechanism.velocityCount()]));
  }

  @CsvSource({"R", "S"})
  @ParameterizedTest
  void accelerationsAreThoseOfMaximalCoordinates(JointType cut) {
    LoopComparison compared = LoopComparison.of(floating(cut));
    assertThat(compared.freedom()).isEqualTo(7);
    compared
        .forward()
        .forEach(
            (formulation, error) ->
                assertThat(error).as(formulation).isLessThan(compared.forwardBound()));
    assertThat(compared.missing()).isLessThan(LoopComparison.MISSING);
  }
}
