package org.mechservice.sim.equations.loop;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.util.Arrays;
import java.util.List;
import java.util.Objects;
import java.util.Random;
import java.util.Set;
import java.util.stream.Stream;
import org.junit.jupiter.api.Named;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.sim.emit.bytes.MethodSizes;
import org.mechservice.sim.model.BuildOptions;
import org.mechservice.sim.model.GeneratedModel;
import org.mechservice.sim.model.LoopAgreement;
import org.mechservice.sim.model.ModelFactory;
import org.mechservice.sim.model.Omission;
import org.mechservice.sim.model.RandomMechmlLoops;
import org.mechservice.sim.model.RandomMechmlTrees;
import org.mechservice.sim.model.Scenes;
import org.mechservice.solver.api.Model;
import org.mechservice.solver.api.capability.BodyPoses;
import org.mechservice.solver.api.capability.Defects;
import org.mechservice.solver.api.capability.DependentStates;
import org.mechservice.solver.api.capability.Energies;
import org.mechservice.solver.api.capability.ExplicitModel;
import org.mechservice.solver.api.capability.LinearisedModel;
import org.mechservice.solver.api.capability.ModelParts;
import org.mechservice.solver.api.capability.PowerInput;
import org.mechservice.solver.api.capability.ResidualModel;
import org.mechservice.solver.api.result.ColumnGroup;
import org.mechservice.solver.expression.BodyPoint;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.force.law.Side;
import org.mechservice.solver.mechanism.Body;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.Root;
import org.mechservice.solver.mechanism.closure.LoopClosure;
import org.mechservice.solver.mechanism.closure.PointOnPlaneClosure;
import org.mechservice.solver.mechanism.force.ForceElement;
import org.mechservice.solver.mechanism.force.SpringDamper;
import org.mechservice.solver.mechanism.joint.Attachment;
import org.mechservice.solver.mechanism.joint.Joint;
import org.mechservice.solver.mechanism.joint.StartRole;
import org.mechservice.solver.spatial.InertiaTensor;
import org.mechservice.solver.spatial.Rotation;
import org.mechservice.solver.spatial.Vector3;
import org.mechservice.solver.text.Origin;

/** Code for mechanisms with loops, against the same closures driven by data. */
@Tag("slow")
public class GeneratedLoopsTest {
  private static GeneratedModel generated(Mechanism mechanism, String formulation, String closure) {
    GeneratedModel generated =
        ModelFactory.generate(
            Scenes.model(mechanism), LoopAgreement.options(formulation, closure, false));
    assertThat(generated.formulationReason()).doesNotContain("compact form");
    return generated;
  }

  static Stream<Named<Mechanism>> scenes() {
    return LoopAgreement.scenes().limit(12);
  }

  static Stream<Named<Mechanism>> manyScenes() {
    return LoopAgreement.scenes().skip(12).limit(488);
  }

  @ParameterizedTest
  @MethodSource("scenes")
  void equationsAgreeWithThoseDrivenByData(Mechanism mechanism) {
    LoopAgreement.of(mechanism).assertWithinBounds();
  }

  /**
   * RR by penalty takes M from the data: that of the state of the step, not of the state that the
   * data were placed at last. Differences keep half of the digits; 1e-5 leaves three for the
   * condition of the step. With the mass matrix of the start, eleven of the twelve scenes are
   * beyond it.
   */
  @ParameterizedTest
  @MethodSource("scenes")
  void aStepByDifferencesHasTheMassOfItsState(Mechanism mechanism) {
    LinearisedModel data = LoopAgreement.data(mechanism, "RR", "penalty", LinearisedModel.class);
    LinearisedModel code = LoopAgreement.code(mechanism, "RR", "penalty", LinearisedModel.class);
    double[] y = new double[data.unknownCount()];
    double[] moved = RandomMechmlTrees.state(3, mechanism);
    System.arraycopy(moved, 0, y, 0, moved.length);
    assertThat(step(code, y)).containsExactly(step(data, y), within(1e-5 * largest(step(data, y))));
  }

  private static double[] step(LinearisedModel model, double[] y) {
    double[] change = new Random(9).doubles(y.length, -1, 1).toArray();
    assertThat(model.linearise(0.4, y, new double[y.length])).isTrue();
    assertThat(model.factor(1e-2)).isTrue();
    model.solve(change);
    return change;
  }

  private static double largest(double[] values) {
    return Arrays.stream(values).map(Math::abs).max().orElse(0);
  }

  @Tag("soak")
  @ParameterizedTest
  @MethodSource("manyScenes")
  void equationsOfManyScenesAgreeWithThoseDrivenByData(Mechanism mechanism) {
    LoopAgreement.of(mechanism).assertWithinBounds();
  }

  @ParameterizedTest
  @MethodSource("scenes")
  void whatTheDataGiveIsTheSameToTheBit(Mechanism mechanism) {
    Model data = LoopAgreement.data(mechanism, "RR-JF", "projection", LinearisedModel.class);
    Model code = LoopAgreement.code(mechanism, "RR-JF", "projection", LinearisedModel.class);
    double[] y = new double[data.description().stateCount()];
    code.initialState(y);
    double[] expected = new double[BodyPoses.NUMBERS_PER_BODY * mechanism.bodies().size()];
    double[] actual = new double[expected.length];
    ((BodyPoses) ModelParts.of(data).equations()).poses(0, y, expected);
    ((BodyPoses) ModelParts.of(code).equations()).poses(0, y, actual);
    assertThat(actual).containsExactly(expected);
  }

  @ParameterizedTest
  @MethodSource("scenes")
  void posesAskedForAreCodeThatAgreesWithTheData(Mechanism mechanism) {
    BuildOptions options = LoopAgreement.options("DSR", "projection", false);
    BuildOptions withPoses =
        new BuildOptions(
            "DSR", "projection", false, Set.of(ColumnGroup.BODIES), options.settings());
    assertThat(ModelFactory.generate(Scenes.model(mechanism), withPoses).source())
        .contains("LoopTerms.OfPoses");
    BodyPoses code = LoopAgreement.model(Scenes.model(mechanism), withPoses, BodyPoses.class);
    BodyPoses data = LoopAgreement.data(mechanism, "DSR", "projection", BodyPoses.class);
    double[] y = RandomMechmlTrees.state(3, mechanism);
    double[] expected = new double[BodyPoses.NUMBERS_PER_BODY * mechanism.bodies().size()];
    double[] actual = new double[expected.length];
    data.poses(0.4, y, expected);
    code.poses(0.4, y, actual);
    // Other operations in another order: rounding times depth.
    assertThat(actual).containsExactly(expected, within(1e-12));
  }

  @ParameterizedTest
  @ValueSource(ints = {1, 3, 5})
  void theClassFileHasTheBitsOfTheCompiledSource(int seed) {
    Mechanism mechanism = LoopAgreement.scene(seed);
    MechmlModel file = Scenes.model(mechanism);
    GeneratedModel generated =
        LoopAgreement.withDerivatives(file, LoopAgreement.options("RR-JF", "penalty", false));
    BuildOptions options = LoopAgreement.options("RR-JF", "penalty", false);
    Model direct = ModelFactory.compile(file, options, generated).newInstance();
    Model compiled = ModelFactory.compileSource(file, options, generated).newInstance();
    assertThat(everything(direct)).containsExactly(everything(compiled));
  }

  @Test
  void derivativesOfTheResidualAreCode() {
    Mechanism loops = RandomMechmlLoops.on(RandomMechmlTrees.tree(1, 12), 1, 2);
    GeneratedModel generated = generated(loops, "RR-JF", "projection");
    assertThat(generated.source()).contains("implements LoopTerms.OfDerivatives");
    assertThat(generated.fromData()).isEmpty();
  }

  @Test
  void derivativesTooLongToBeFasterAreLeftToTheDataWithTheirReason() {
    Mechanism loops = RandomMechmlLoops.on(RandomMechmlTrees.tree(30, 30), 30, 2);
    GeneratedModel generated = generated(loops, "RR-JF", "penalty");
    assertThat(generated.source()).contains("implements LoopTerms.OfResidual");
    assertThat(generated.fromData())
        .extracting(Omission::what)
        .containsExactly("derivatives of the residual");
  }

  /**
   * Returns y' at the start, a residual there, and the solution of an implicit step if it has one.
   */
  public static double[] everything(Model model) {
    ResidualModel residual = (ResidualModel) ModelParts.of(model).equations();
    double[] y = new double[residual.unknownCount()];
    double[] rates = new Random(1).doubles(y.length, -1, 1).toArray();
    double[] all = new double[3 * y.length + 3];
    double[] out = new double[y.length];
    model.initialState(y);
    residual.derivative(0, y, out);
    System.arraycopy(out, 0, all, 0, y.length);
    residual.residual(0, y, rates, out);
    System.arraycopy(out, 0, all, y.length, y.length);
    double[] energy = new double[3];
    ((PowerInput) ModelParts.of(model).equations()).power(0, y, energy);
    energy[2] = energy[0];
    ((Energies) ModelParts.of(model).equations()).energy(0, y, energy);
    System.arraycopy(energy, 0, all, 3 * y.length, energy.length);
    if (model instanceof LinearisedModel linearised) {
      assertThat(linearised.linearise(0, y, rates) && linearised.factor(0.1)).isTrue();
      linearised.solve(out);
      System.arraycopy(out, 0, all, 2 * y.length, y.length);
    }
    return all;
  }

  @Test
  void theSourceOfAModelNamedLikeWhatItIsCompiles() {
    Mechanism loops = LoopAgreement.scene(1);
    Mechanism named =
        new Mechanism(
                "LoopTerms",
                loops.root(),
                loops.gravity(),
                loops.bodies(),
                loops.joints(),
                loops.motions(),
                loops.startRoles(),
                loops.closures(),
                loops.forces(),
                loops.parameters())
            .withArmatures(loops.armatures());
    MechmlModel file = Scenes.model(named);
    BuildOptions options = LoopAgreement.options("DSR", "penalty", false);
    GeneratedModel generated = ModelFactory.generate(file, options);
    Model model = ModelFactory.compileSource(file, options, generated).newInstance();
    assertThat(model.description().name()).isEqualTo("LoopTerms");
  }

  @Test
  void manyBodiesInLoopsHaveShortMethods() {
    Mechanism loops = RandomMechmlLoops.on(RandomMechmlTrees.tree(1, 40), 1, 6);
    GeneratedModel generated = generated(loops, "RR", "penalty");
    byte[] file = Objects.requireNonNull(generated.classFiles().get(generated.sourceName()));
    assertThat(MethodSizes.longest(file)).isLessThan(8000);
  }

  @ParameterizedTest
  @ValueSource(strings = {"projection", "penalty"})
  void anEvaluationAllocatesNothing(String closure) {
    LinearisedModel model =
        LoopAgreement.code(LoopAgreement.scene(1), "RR-JF", closure, LinearisedModel.class);
    double[] y = new double[model.unknownCount()];
    double[] rates = new double[y.length];
    double[] residual = new double[y.length];
    double[] energy = new double[2];
    model.initialState(y);
    ThreadMXBean thread = (ThreadMXBean) ManagementFactory.getThreadMXBean();
    long least = Long.MAX_VALUE;
    // The virtual machine itself may allocate while it compiles: the least of several counts.
    for (int round = 0; round < 5; round++) {
      long before = thread.getCurrentThreadAllocatedBytes();
      for (int i = 0; i < 50; i++) {
        model.derivative(0, y, rates);
        model.residual(0, y, rates, residual);
        ((Energies) model).energy(0, y, energy);
        ((PowerInput) model).power(0, y, energy);
        model.linearise(0, y, rates);
        model.factor(0.1);
        model.solve(residual);
        if (model instanceof DependentStates dependent) {
          dependent.complete(0, y);
        }
      }
      least = Math.min(least, thread.getCurrentThreadAllocatedBytes() - before);
    }
    assertThat(least).isZero();
  }

  /** A block on the x axis, held in a plane it cannot leave, and a spring to its own place. */
  @ParameterizedTest
  @ValueSource(strings = {"projection", "penalty"})
  void aForceWithoutDirectionIsToldAsByTheData(String closure) {
    Body block = new Body("block", 2, Vector3.ZERO, InertiaTensor.ZERO, Origin.NONE);
    Attachment attachment =
        new Attachment(Mechanism.ROOT, Vector3.ZERO, 0, Vector3.ZERO, Rotation.IDENTITY);
    Joint slide = Scenes.joint("slide", "P", attachment, new Vector3(1, 0, 0), 0, 0);
    BodyPoint ground = new BodyPoint(BodyPoint.ROOT, Vector3.ZERO);
    BodyPoint own = new BodyPoint(0, Vector3.ZERO);
    LoopClosure plane =
        new PointOnPlaneClosure("floor", own, ground, new Vector3(0, 0, 1), Origin.NONE);
    Expression one = Expression.of(1);
    Expression none = Expression.ZERO;
    ForceElement spring =
        new SpringDamper("knot", ground, own, one, one, one, none, Side.BOTH, none, Origin.NONE);
    Mechanism knotted =
        new Mechanism(
            "knotted",
            new Root("ground", Vector3.ZERO, Rotation.IDENTITY),
            Vector3.ZERO,
            List.of(block),
            List.of(slide),
            List.of(),
            List.of(StartRole.PREFERRED),
            List.of(plane),
            List.of(spring),
            List.of());
    ExplicitModel data = LoopAgreement.data(knotted, "DSR", closure, ExplicitModel.class);
    ExplicitModel code = LoopAgreement.code(knotted, "DSR", closure, ExplicitModel.class);
    double[] y = new double[2];
    assertThat(data.derivative(0, y, new double[2])).isEqualTo(Defects.DEFECT);
    assertThat(code.derivative(0, y, new double[2])).isEqualTo(Defects.DEFECT);
    assertThat(((Defects) code).lastDefect()).isEqualTo(((Defects) data).lastDefect());
  }
}
