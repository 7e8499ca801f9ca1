package org.mechservice.sim.equations.coordinates;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Named;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.sim.equations.loop.GeneratedLoopsTest;
import org.mechservice.sim.model.BuildOptions;
import org.mechservice.sim.model.CutUses;
import org.mechservice.sim.model.GeneratedModel;
import org.mechservice.sim.model.LoopAgreement;
import org.mechservice.sim.model.ModelFactory;
import org.mechservice.sim.model.Scenes;
import org.mechservice.solver.api.Model;
import org.mechservice.solver.api.capability.DependentStates;
import org.mechservice.solver.api.capability.ExplicitModel;
import org.mechservice.solver.api.capability.ModelState;
import org.mechservice.solver.api.capability.ProjectedStates;
import org.mechservice.solver.closure.ClosedMechanism;
import org.mechservice.solver.closure.model.PenaltyModel;
import org.mechservice.solver.expression.ClosureCoordinate;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.expression.JointCoordinate;
import org.mechservice.solver.force.law.Side;
import org.mechservice.solver.mechanism.Body;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.Root;
import org.mechservice.solver.mechanism.closure.CoordinateClosure;
import org.mechservice.solver.mechanism.closure.JointClosure;
import org.mechservice.solver.mechanism.closure.LoopClosure;
import org.mechservice.solver.mechanism.force.ForceElement;
import org.mechservice.solver.mechanism.force.JointSpringDamper;
import org.mechservice.solver.mechanism.joint.Attachment;
import org.mechservice.solver.mechanism.joint.Joint;
import org.mechservice.solver.mechanism.joint.StartRole;
import org.mechservice.solver.spatial.InertiaTensor;
import org.mechservice.solver.spatial.Rotation;
import org.mechservice.solver.spatial.Vector3;
import org.mechservice.solver.text.Origin;

/** Code for forces and relations that depend on coordinates of cut joints. */
@Tag("slow")
public class GeneratedCutCoordinatesTest {
  private static final Vector3 X = new Vector3(1, 0, 0);
  private static final Vector3 Y = new Vector3(0, 1, 0);
  private static final Vector3 Z = new Vector3(0, 0, 1);

  private static Stream<Named<Mechanism>> all() {
    return IntStream.iterate(1, seed -> seed + 1)
        .filter(seed -> hasMovingCuts(LoopAgreement.scene(seed)))
        .mapToObj(seed -> Named.of("seed " + seed, CutUses.in(LoopAgreement.scene(seed), seed)))
        .filter(scene -> closes(scene.getPayload()));
  }

  private static boolean hasMovingCuts(Mechanism loops) {
    return loops.closures().stream()
        .anyMatch(
            closure ->
                closure instanceof JointClosure cut && cut.joint().type().velocityCount() > 0);
  }

  private static boolean closes(Mechanism mechanism) {
    return new ClosedMechanism(mechanism, "DSR", Scenes.SETTINGS).start().isAssembled();
  }

  static Stream<Named<Mechanism>> scenes() {
    return all().limit(8);
  }

  static Stream<Named<Mechanism>> manyScenes() {
    return all().skip(8).limit(150);
  }

  @ParameterizedTest
  @MethodSource("scenes")
  void equationsAgreeWithThoseDrivenByData(Mechanism mechanism) {
    LoopAgreement.of(mechanism).assertWithinBounds();
  }

  @Tag("soak")
  @ParameterizedTest
  @MethodSource("manyScenes")
  void equationsOfManyScenesAgreeWithThoseDrivenByData(Mechanism mechanism) {
    LoopAgreement.of(mechanism).assertWithinBounds();
  }

  @Test
  void theClassFileHasTheBitsOfTheCompiledSource() {
    MechmlModel file = Scenes.model(wheels(List.of(gear()), List.of(spring())));
    BuildOptions options = LoopAgreement.options("RR-JF", "penalty", false);
    GeneratedModel generated = LoopAgreement.withDerivatives(file, options);
    Model direct = ModelFactory.compile(file, options, generated).newInstance();
    Model compiled = ModelFactory.compileSource(file, options, generated).newInstance();
    assertThat(GeneratedLoopsTest.everything(direct))
        .containsExactly(GeneratedLoopsTest.everything(compiled));
  }

  /** The wheel of inertia 1 on a spring of 2 N·m/rad: φ'' = −2 φ, however often it has turned. */
  @ParameterizedTest
  @ValueSource(strings = {"projection", "penalty"})
  void aSpringOnAnAngleCountsWholeTurns(String closure) {
    ExplicitModel model =
        LoopAgreement.code(
            wheels(List.of(), List.of(spring())), "DSR", closure, ExplicitModel.class);
    for (int step = 0; step <= 40; step++) {
      double[] y = turned(0.5 * step);
      assertThat(accelerations(model, y)[2]).isCloseTo(-step, within(1e-9 * (1 + step)));
      accept(model, y);
    }
  }

  /** The second wheel turns by a third of the first one's angle: nothing pulls them apart. */
  @ParameterizedTest
  @ValueSource(strings = {"projection", "penalty"})
  void aRelationOfAnAngleHoldsOverWholeTurns(String closure) {
    ExplicitModel model =
        LoopAgreement.code(wheels(List.of(gear()), List.of()), "DSR", closure, ExplicitModel.class);
    for (int step = 0; step <= 40; step++) {
      double[] y = turned(0.5 * step);
      for (double acceleration : accelerations(model, y)) {
        assertThat(acceleration).isCloseTo(0, within(1e-6));
      }
      accept(model, y);
    }
  }

  /** Multipliers come from data that are told how often the code has seen the wheel turn. */
  @Test
  void whatTheDataAreAskedForCountsTheSameTurns() {
    PenaltyModel model =
        LoopAgreement.code(
            wheels(List.of(gear()), List.of(spring())), "DSR", "penalty", PenaltyModel.class);
    model.react(0, turned(0));
    for (int step = 0; step <= 20; step++) {
      accept(model, turned(step));
    }
    model.react(0, turned(20));
    double[] multipliers = model.reactions().multipliers;
    // λ = −I₂ φ'' / 3 by the row [1, −3] of the gear; 40 N·m turn the wheels of 1 + 1/9 kg·m²
    assertThat(Math.abs(multipliers[multipliers.length - 1])).isCloseTo(4, within(1e-6));
  }

  @ParameterizedTest
  @ValueSource(strings = {"projection", "penalty"})
  void aRunTakenUpGoesOnCounting(String closure) {
    Mechanism wheels = wheels(List.of(gear()), List.of(spring()));
    ExplicitModel first = LoopAgreement.code(wheels, "DSR", closure, ExplicitModel.class);
    for (int step = 0; step <= 20; step++) {
      accept(first, turned(step));
    }
    double[] saved = new double[((ModelState) first).stateLength()];
    ((ModelState) first).saveState(saved);
    ExplicitModel second = LoopAgreement.code(wheels, "DSR", closure, ExplicitModel.class);
    ((ModelState) second).restoreState(saved);
    assertThat(accelerations(second, turned(20.5)))
        .containsExactly(accelerations(first, turned(20.5)));
    assertThat(accelerations(second, turned(20.5))[2]).isCloseTo(-36.9, within(1e-5));
  }

  private static void accept(ExplicitModel model, double[] y) {
    if (model instanceof DependentStates dependent) {
      dependent.accepted(0, y);
    } else {
      ((ProjectedStates) model).accepted(0, y);
    }
  }

  private static double[] accelerations(ExplicitModel model, double[] y) {
    double[] rates = new double[y.length];
    assertThat(model.derivative(0, y, rates)).isEqualTo(ExplicitModel.REGULAR);
    return Arrays.copyOfRange(rates, y.length / 2, y.length);
  }

  /** Returns the state at rest where the first wheel has turned by an angle, rad. */
  private static double[] turned(double angle) {
    return new double[] {0, 0, angle, angle / 3, 0, 0, 0, 0};
  }

  private static ClosureCoordinate angle() {
    return new ClosureCoordinate(0, 0);
  }

  private static LoopClosure gear() {
    Expression second = new Expression.CoordinatePosition(new JointCoordinate(3, 0));
    Expression thrice = new Expression.Product(Expression.of(-3), second);
    Expression first = new Expression.CoordinatePosition(angle());
    return new CoordinateClosure("gear", new Expression.Sum(first, thrice), Origin.NONE);
  }

  private static ForceElement spring() {
    Expression none = Expression.ZERO;
    return new JointSpringDamper(
        "spring", angle(), Expression.of(2), none, none, none, Side.BOTH, none, Origin.NONE);
  }

  /**
   * A wheel on two slides, which a cut joint holds at the origin, and one that turns in the ground.
   */
  public static Mechanism wheels(List<LoopClosure> relations, List<ForceElement> forces) {
    List<Joint> joints =
        List.of(
            Scenes.joint("x", "P", between(Mechanism.ROOT, 0), X, 0, 0),
            Scenes.joint("y", "P", between(0, 1), Y, 0, 0),
            Scenes.joint("z", "R", between(1, 2), Z, 0, 0),
            Scenes.joint("second", "R", between(Mechanism.ROOT, 3), Z, 0, 0));
    Joint axle = Scenes.joint("axle", "R", between(Mechanism.ROOT, 2), Z, 0, 0);
    List<LoopClosure> closures = new ArrayList<>(List.of(new JointClosure(axle)));
    closures.addAll(relations);
    InertiaTensor inertia = new InertiaTensor(1, 1, 1, 0, 0, 0);
    Mechanism tree =
        new Mechanism(
            "wheels",
            new Root("ground", Vector3.ZERO, Rotation.IDENTITY),
            Vector3.ZERO,
            Stream.of("a", "b", "wheel", "other")
                .map(name -> new Body(name, 1, Vector3.ZERO, inertia, Origin.NONE))
                .toList(),
            joints);
    return new Mechanism(
        tree.name(),
        tree.root(),
        tree.gravity(),
        tree.bodies(),
        tree.joints(),
        tree.motions(),
        joints.stream().map(joint -> StartRole.PREFERRED).toList(),
        closures,
        forces,
        tree.parameters());
  }

  private static Attachment between(int parent, int child) {
    return new Attachment(parent, Vector3.ZERO, child, Vector3.ZERO, Rotation.IDENTITY);
  }
}
