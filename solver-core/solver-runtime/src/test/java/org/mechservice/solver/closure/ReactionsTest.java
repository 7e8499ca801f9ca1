package org.mechservice.solver.closure;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.mechservice.solver.api.JointType.C;
import static org.mechservice.solver.api.JointType.R;
import static org.mechservice.solver.api.JointType.S;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.IntFunction;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.solver.api.JointType;
import org.mechservice.solver.api.capability.ExplicitModel;
import org.mechservice.solver.closure.equations.LoopEquations;
import org.mechservice.solver.closure.model.LoopModel;
import org.mechservice.solver.closure.model.ProjectionModel;
import org.mechservice.solver.expression.BodyPoint;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.closure.JointClosure;
import org.mechservice.solver.mechanism.closure.LoopClosure;
import org.mechservice.solver.mechanism.joint.Attachment;
import org.mechservice.solver.mechanism.joint.Joint;
import org.mechservice.solver.oracle.ClosureForces;
import org.mechservice.solver.oracle.GlobalFormulation;
import org.mechservice.solver.oracle.OracleForce;
import org.mechservice.solver.oracle.TaylorPose;
import org.mechservice.solver.scenes.SharedScene;
import org.mechservice.solver.scenes.SharedScene.ReferenceState;
import org.mechservice.solver.spatial.Vector3;

class ReactionsTest {
  private static final List<JointType> REDUNDANT = List.of(R, R, R, R);
  private static final List<JointType> EXACT = List.of(R, R, S, C);

  private static LoopModel model(Mechanism mechanism) {
    return LoopModels.of(mechanism, "DSR", SceneRun.settings(1, 0.1, "ode113", 1e-8));
  }

  private static Reactions reactAtStart(LoopModel model) {
    double[] y = model.closed.start().state();
    assertThat(model.react(0, y)).isEqualTo(ExplicitModel.REGULAR);
    return model.reactions();
  }

  private static Vector3 vector(double[] x, int at) {
    return new Vector3(x[at], x[at + 1], x[at + 2]);
  }

  /** Reactions of all joints by name, as exerted on the body of higher index. */
  private static Map<String, double[]> byName(Mechanism mechanism, Reactions reactions) {
    Map<String, double[]> all = new HashMap<>();
    for (int j = 0; j < mechanism.joints().size(); j++) {
      all.put(
          mechanism.joints().get(j).name(),
          oriented(mechanism.joints().get(j), reactions.onJoints, 6 * j));
    }
    for (int j = 0; j < reactions.cutJoints().size(); j++) {
      Joint joint = reactions.cutJoints().get(j).joint();
      all.put(joint.name(), oriented(joint, reactions.onCutJoints, 6 * j));
    }
    return all;
  }

  private static double[] oriented(Joint joint, double[] wrench, int at) {
    double sign = joint.attachment().child() > joint.attachment().parent() ? 1 : -1;
    return Arrays.stream(wrench, at, at + 6).map(x -> sign * x).toArray();
  }

  @ParameterizedTest
  @ValueSource(ints = {0, 1, 2})
  void reactionsDoNotDependOnWhichJointIsCut(int cut) {
    Mechanism reference = Linkages.fourBar(EXACT, 3);
    Mechanism other = Linkages.fourBar(EXACT, cut);
    Map<String, double[]> expected = byName(reference, reactAtStart(model(reference)));
    Map<String, double[]> actual = byName(other, reactAtStart(model(other)));
    assertThat(actual.keySet()).isEqualTo(expected.keySet());
    expected.forEach(
        (name, wrench) ->
            assertThat(actual.get(name)).as(name).containsExactly(wrench, within(1e-11 * 100)));
  }

  @Test
  void reactionsInThePlaneDoNotDependOnRedundantEquations() {
    Mechanism exact = Linkages.fourBar(EXACT, 3);
    Mechanism redundant = Linkages.fourBar(REDUNDANT, 3);
    LoopModel model = model(redundant);
    Reactions reactions = reactAtStart(model);
    assertThat(reactions.areUnique()).isFalse();
    Map<String, double[]> expected = byName(exact, reactAtStart(model(exact)));
    byName(redundant, reactions)
        .forEach(
            (name, wrench) ->
                assertThat(wrench).as(name).containsExactly(expected.get(name), within(1e-9)));
  }

  /** A mass of 1 kg on a circle of 1 m, with 3 m/s. */
  @Test
  void aRodCarriesTheWeightAndTheCentrifugalForce() {
    LoopModel model = model(Linkages.slidingPendulum(0));
    double[] aside = {0.6, -0.8, 3 * 0.8, 3 * 0.6};
    assertThat(model.react(0, aside)).isEqualTo(ExplicitModel.REGULAR);
    assertThat(model.reactions().multipliers[0]).isCloseTo(9.81 * 0.8 + 9, within(1e-13));
  }

  /**
   * A velocity that leaves the circle is an error of the state, which no prescribed motion does.
   */
  @Test
  void aRodThatTimeDoesNotMoveDoesNoWork() {
    LoopModel model = model(Linkages.slidingPendulum(0));
    double[] leaving = {0.6, -0.8, 3 * 0.8 + 0.1, 3 * 0.6};
    assertThat(model.react(0, leaving)).isEqualTo(ExplicitModel.REGULAR);
    double[] power = new double[2];
    model.reactions().addPower(power);
    assertThat(power[0]).isCloseTo(0, within(1e-13));
    assertThat(power[1]).isCloseTo(0, within(1e-13));
  }

  @Test
  void multipliersOfRedundantEquationsAreOfLeastNorm() {
    LoopModel model = model(Linkages.fourBar(REDUNDANT, 3));
    Reactions reactions = reactAtStart(model);
    LoopEquations loops = reactions.equations();
    // what adds nothing to Jᵀ λ: displacement along the axis, and both tilts out of the plane
    int without = 0;
    for (int row = 0; row < loops.count(); row++) {
      boolean moves = false;
      for (int j = 0; j < loops.jacobian.columns(); j++) {
        moves |= Math.abs(loops.jacobian.get(row, j)) > 1e-12;
      }
      if (!moves) {
        assertThat(reactions.multipliers[row]).as(loops.name(row)).isCloseTo(0, within(1e-12));
        without++;
      }
    }
    assertThat(without).isEqualTo(3);
  }

  /** Newton and Euler for each body alone, written a second time by the oracle. */
  @ParameterizedTest
  @ValueSource(strings = {"slider_crank_planar", "fourbar_redundant", "A03_andrews", "fps"})
  void reactionsAndForcesMoveEveryBodyAsItMoves(String name) {
    SharedScene scene = SharedScene.named(name);
    Mechanism mechanism = scene.mechanism();
    LoopModel model = model(mechanism);
    Reactions reactions = model.reactions();
    List<OracleForce> all = new ArrayList<>(scene.forces());
    all.add((t, pose, loads) -> apply(mechanism, reactions, pose, loads));
    GlobalFormulation global = new GlobalFormulation(mechanism, all);
    for (ReferenceState state : scene.reference().subList(0, 3)) {
      double[] y = new double[state.q().length + state.v().length];
      System.arraycopy(state.q(), 0, y, 0, state.q().length);
      System.arraycopy(state.v(), 0, y, state.q().length, state.v().length);
      assertThat(((ProjectionModel) model).complete(state.t(), y)).isTrue();
      double[] yDot = new double[y.length];
      assertThat(model.derivative(state.t(), y, yDot)).isEqualTo(ExplicitModel.REGULAR);
      assertThat(model.react(state.t(), y)).isEqualTo(ExplicitModel.REGULAR);
      double largest = Arrays.stream(reactions.onJoints).map(Math::abs).max().orElse(0);
      double[] v = Arrays.copyOfRange(y, state.q().length, y.length);
      double[] a = Arrays.copyOfRange(yDot, state.q().length, y.length);
      for (double missing : global.missing(state.t(), y, v, a)) {
        assertThat(missing).as("t = %s", state.t()).isCloseTo(0, within(1e-10 * (1 + largest)));
      }
    }
  }

  /** What joints and rods exert, on both of their bodies. */
  static void apply(
      Mechanism mechanism,
      Reactions reactions,
      IntFunction<TaylorPose> pose,
      OracleForce.Loads loads) {
    for (int j = 0; j < mechanism.joints().size(); j++) {
      apply(mechanism.joints().get(j), reactions.onJoints, 6 * j, pose, loads);
    }
    for (int j = 0; j < reactions.cutJoints().size(); j++) {
      apply(reactions.cutJoints().get(j).joint(), reactions.onCutJoints, 6 * j, pose, loads);
    }
    int row = 0;
    for (LoopClosure closure : mechanism.closures()) {
      if (!(closure instanceof JointClosure)) {
        ClosureForces.apply(closure, reactions.multipliers, row, pose, loads);
      }
      while (row < reactions.multipliers.length && reactions.equations().closure(row) == closure) {
        row++;
      }
    }
  }

  private static void apply(
      Joint joint, double[] all, int at, IntFunction<TaylorPose> pose, OracleForce.Loads loads) {
    Attachment bodies = joint.attachment();
    BodyPoint onChild = new BodyPoint(bodies.child(), bodies.childPoint());
    BodyPoint onParent = new BodyPoint(bodies.parent(), bodies.parentPoint());
    ClosureForces.pull(onParent, onChild, vector(all, at).negated(), pose, loads);
    loads.moment(bodies.child(), vector(all, at + 3));
    loads.moment(bodies.parent(), vector(all, at + 3).negated());
  }

  @ParameterizedTest
  @EnumSource(JointType.class)
  void reactionsDoNoWorkOnJointsThatMoveFreely(JointType type) {
    Mechanism mechanism = Linkages.heldByRod(type, 7);
    LoopModel model = model(mechanism);
    Reactions reactions = reactAtStart(model);
    GlobalFormulation global = new GlobalFormulation(mechanism, List.of());
    double[] y = model.closed.start().state();
    Joint joint = mechanism.joints().get(1);
    for (int k = 0; k < type.velocityCount(); k++) {
      double[] v = new double[mechanism.velocityCount()];
      v[mechanism.velocityOffset(1) + k] = 1;
      TaylorPose moving = global.poses(0, y, v, new double[v.length])[joint.attachment().child()];
      double power =
          vector(reactions.onJoints, 6).dot(moving.at(joint.attachment().childPoint()).rate())
              + vector(reactions.onJoints, 9).dot(moving.rotation().angularVelocity());
      double size = 1 + vector(reactions.onJoints, 6).norm() + vector(reactions.onJoints, 9).norm();
      assertThat(power).as("component %s", k).isCloseTo(0, within(1e-12 * size));
    }
  }
}
