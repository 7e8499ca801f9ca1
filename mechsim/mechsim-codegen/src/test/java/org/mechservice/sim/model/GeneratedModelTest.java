package org.mechservice.sim.model;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.mechservice.sim.model.ModelAgreement.assertClose;

import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import java.util.Arrays;
import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import java.util.stream.Stream;
import org.junit.jupiter.api.Named;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.sim.equations.ArticulatedBodyEquations;
import org.mechservice.sim.equations.EnergyEquations;
import org.mechservice.sim.equations.PoseEquations;
import org.mechservice.solver.api.Model;
import org.mechservice.solver.api.capability.BodyPoses;
import org.mechservice.solver.api.capability.Energies;
import org.mechservice.solver.api.capability.ExplicitModel;
import org.mechservice.solver.api.capability.ModelParts;
import org.mechservice.solver.api.result.ColumnGroup;
import org.mechservice.solver.dynamics.DataDrivenModel;
import org.mechservice.solver.links.Links;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.Root;
import org.mechservice.solver.spatial.Rotation;
import org.mechservice.solver.spatial.Vector3;
import org.mechservice.solver.symbol.Program;

/** What the class of a model computes, against the equations it was written from and others. */
class GeneratedModelTest {
  /** When everything is evaluated; what does not depend on time does not show it. */
  private static final double TIME = 0.7;

  private static final BuildOptions ALL =
      new BuildOptions(
          "auto", EnumSet.range(ColumnGroup.JOINTS, ColumnGroup.ENERGY), Scenes.SETTINGS);

  private static ExplicitModel generated(Mechanism mechanism) {
    MechmlModel model = Scenes.model(mechanism);
    GeneratedModel source = ModelFactory.generate(model, ALL);
    return (ExplicitModel)
        ModelParts.of(ModelFactory.compile(model, ALL, source).newInstance()).equations();
  }

  static Stream<Named<Mechanism>> scenes() {
    return Stream.of(
            Stream.of(Scenes.pendulum(), Scenes.timingModel("driver41").mechanism()),
            seeds(8).map(seed -> RandomMechmlTrees.tree(seed, 3 + 2 * seed)),
            seeds(9).map(seed -> RandomMechmlTrees.ofAllJoints(seed, 1 + seed)),
            seeds(5).map(seed -> RandomMechmlTrees.driven(seed, 3 + seed)))
        .flatMap(scenes -> scenes)
        .map(mechanism -> Named.of(mechanism.name(), mechanism));
  }

  /** Scenes without driven joints, which put energy in. */
  static Stream<Named<Mechanism>> freeScenes() {
    return scenes().filter(scene -> scene.getPayload().motions().isEmpty());
  }

  private static Stream<Integer> seeds(int count) {
    return Stream.iterate(1, seed -> seed + 1).limit(count);
  }

  @ParameterizedTest
  @MethodSource("scenes")
  void theClassFileHasTheBitsOfTheCompiledSource(Mechanism mechanism) {
    MechmlModel model = Scenes.model(mechanism);
    GeneratedModel generated = ModelFactory.generate(model, ALL);
    Model direct = ModelFactory.compile(model, ALL, generated).newInstance();
    Model compiled = ModelFactory.compileSource(model, ALL, generated).newInstance();
    assertThat(direct.description()).isEqualTo(compiled.description());
    assertThat(((BodyPoses) ModelParts.of(direct).equations()).bodies())
        .isEqualTo(((BodyPoses) ModelParts.of(compiled).equations()).bodies());
    for (int seed = 1; seed <= 3; seed++) {
      double[] y = RandomMechmlTrees.state(seed, mechanism);
      assertSameBits(everything(direct, y), everything(compiled, y));
    }
  }

  /** Start, derivative, result, energies and poses, one after the other. */
  private static double[] everything(Model model, double[] y) {
    int bodies = ((BodyPoses) ModelParts.of(model).equations()).bodies().size();
    double[] start = new double[y.length];
    Arrays.fill(start, 7);
    double[] yDot = new double[y.length];
    double[] poses = new double[BodyPoses.NUMBERS_PER_BODY * bodies];
    model.initialState(start);
    double[] result = {
      ((ExplicitModel) ModelParts.of(model).equations()).derivative(TIME, y, yDot)
    };
    ((BodyPoses) ModelParts.of(model).equations()).poses(TIME, y, poses);
    return Stream.of(start, yDot, result, energies(model, y), poses)
        .flatMapToDouble(Arrays::stream)
        .toArray();
  }

  @ParameterizedTest
  @MethodSource("scenes")
  void theClassHasTheBitsOfItsEquations(Mechanism mechanism) {
    ExplicitModel model = generated(mechanism);
    Links links = Links.of(mechanism);
    double[] y = RandomMechmlTrees.state(11, mechanism);
    double[] yDot = new double[y.length];
    model.derivative(TIME, y, yDot);
    assertSameBits(yDot, evaluated(ArticulatedBodyEquations.derive(links), y, y.length));
    double[] energy = new double[2];
    ((Energies) ModelParts.of(model).equations()).energy(TIME, y, energy);
    assertSameBits(energy, evaluated(EnergyEquations.derive(links), y, 2));
    double[] poses = new double[BodyPoses.NUMBERS_PER_BODY * mechanism.bodies().size()];
    ((BodyPoses) ModelParts.of(model).equations()).poses(TIME, y, poses);
    double[] expected = evaluated(PoseEquations.derive(links), y, poses.length);
    for (int i = 3; i < expected.length; i += BodyPoses.NUMBERS_PER_BODY) {
      if (expected[i] < 0) {
        for (int j = i; j < i + 4; j++) {
          expected[j] = 0 - expected[j];
        }
      }
    }
    assertSameBits(poses, expected);
  }

  private static double[] evaluated(Program program, double[] y, int length) {
    double[] out = new double[length];
    program.evaluate(TIME, y, out);
    return out;
  }

  private static void assertSameBits(double[] actual, double[] expected) {
    for (int i = 0; i < expected.length; i++) {
      assertThat(Double.doubleToRawLongBits(actual[i]))
          .as("element %s: %s, expected %s", i, actual[i], expected[i])
          .isEqualTo(Double.doubleToRawLongBits(expected[i]));
    }
  }

  @ParameterizedTest
  @MethodSource("scenes")
  void theClassAgreesWithTheDataDrivenFormulation(Mechanism mechanism) {
    ExplicitModel model = generated(mechanism);
    DataDrivenModel reference = new DataDrivenModel(mechanism, Scenes.SETTINGS);
    double[] y = RandomMechmlTrees.state(5, mechanism);
    double[] actual = new double[y.length];
    double[] expected = new double[y.length];
    assertThat(model.derivative(TIME, y, actual)).isEqualTo(ExplicitModel.REGULAR);
    assertThat(reference.derivative(TIME, y, expected)).isEqualTo(ExplicitModel.REGULAR);
    // Other operations in another order: a few units in the last place times depth and condition.
    assertClose(actual, expected, 1e-11);
    assertClose(energies(model, y), energies(reference, y), 1e-13);
    double[] poses = new double[BodyPoses.NUMBERS_PER_BODY * mechanism.bodies().size()];
    double[] referencePoses = new double[poses.length];
    ((BodyPoses) ModelParts.of(model).equations()).poses(TIME, y, poses);
    reference.poses(TIME, y, referencePoses);
    assertClose(poses, referencePoses, 1e-13);
  }

  private static double[] energies(Object model, double[] y) {
    double[] energy = new double[2];
    ((Energies) ModelParts.of((Model) model).equations()).energy(TIME, y, energy);
    return energy;
  }

  @ParameterizedTest
  @MethodSource("freeScenes")
  void energyIsConstantAlongTheMotion(Mechanism mechanism) {
    ExplicitModel model = generated(mechanism);
    double[] y = RandomMechmlTrees.state(9, mechanism);
    double[] yDot = new double[y.length];
    model.derivative(0, y, yDot);
    double speed = 0;
    for (double rate : yDot) {
      speed = Math.max(speed, Math.abs(rate));
    }
    double h = 1e-4 / speed;
    double[] ahead = energies(model, moved(y, yDot, h));
    double[] behind = energies(model, moved(y, yDot, -h));
    double change = ahead[0] + ahead[1] - behind[0] - behind[1];
    double exchanged = Math.abs(ahead[0] - behind[0]) + Math.abs(ahead[1] - behind[1]);
    double[] here = energies(model, y);
    // The central difference leaves terms of third order in 1e-4, and rounding of the energies.
    assertThat(Math.abs(change))
        .isLessThan(1e-6 * exchanged + 1e-11 * (Math.abs(here[0]) + Math.abs(here[1])));
  }

  private static double[] moved(double[] y, double[] yDot, double h) {
    double[] moved = y.clone();
    for (int i = 0; i < y.length; i++) {
      moved[i] += h * yDot[i];
    }
    return moved;
  }

  @Test
  void thePendulumMovesAsItsReferenceSays() {
    ExplicitModel model = generated(Scenes.pendulum());
    for (JsonElement element : Scenes.json("pendulum5.ref.json").getAsJsonArray("out")) {
      JsonObject reference = element.getAsJsonObject();
      double[] y = new double[10];
      System.arraycopy(Scenes.numbers(reference.getAsJsonArray("q")), 0, y, 0, 5);
      System.arraycopy(Scenes.numbers(reference.getAsJsonArray("v")), 0, y, 5, 5);
      double[] yDot = new double[10];
      model.derivative(0, y, yDot);
      double[] a = new double[5];
      System.arraycopy(yDot, 5, a, 0, 5);
      // Accelerations to 1e-11; the references have 15 digits.
      assertClose(a, Scenes.numbers(reference.getAsJsonArray("a")), 1e-11);
      double[] energy = {
        reference.get("kinetic").getAsDouble(), reference.get("potential").getAsDouble()
      };
      double[] actual = energies(model, y);
      assertThat(Math.abs(actual[0] - energy[0])).isLessThan(1e-11 * (1 + energy[0]));
      assertThat(Math.abs(actual[1] - energy[1])).isLessThan(1e-11 * (1 + energy[0]));
    }
  }

  @Test
  void potentialEnergyCountsFromTheWorldOrigin() {
    Mechanism still = Scenes.pendulum();
    Root high = new Root("Ground", new Vector3(1, 2, 3), Rotation.IDENTITY);
    Mechanism moved = new Mechanism("high", high, still.gravity(), still.bodies(), still.joints());
    double[] y = new double[10];
    double lifted = energies(generated(moved), y)[1] - energies(generated(still), y)[1];
    assertThat(lifted).isCloseTo(5 * 9.81 * 3, within(1e-12));
  }

  @Test
  void theStartIsTheMechanisms() {
    Mechanism mechanism = RandomMechmlTrees.tree(4, 9);
    double[] y = new double[18];
    Arrays.fill(y, 7);
    double[] expected = new double[18];
    mechanism.initialState(expected);
    generated(mechanism).initialState(y);
    assertThat(y).containsExactly(expected);
  }

  @Test
  void theDescriptionIsTheMechanisms() {
    Mechanism mechanism = RandomMechmlTrees.tree(4, 9);
    ExplicitModel model = generated(mechanism);
    assertThat(model.description())
        .isEqualTo(new DataDrivenModel(mechanism, Scenes.SETTINGS).description());
    assertThat(((BodyPoses) ModelParts.of(model).equations()).bodies())
        .containsExactlyElementsOf(mechanism.bodies().stream().map(body -> body.name()).toList());
  }

  @Test
  void gimbalLockIsTold() {
    Mechanism gimbal = Scenes.scene("gimbal_q2_1.5707963267948966.json", "gimbal");
    MechmlModel file = Scenes.model(gimbal);
    GeneratedModel generated = ModelFactory.generate(file, ALL);
    for (CompiledModel compiled :
        List.of(
            ModelFactory.compile(file, ALL, generated),
            ModelFactory.compileSource(file, ALL, generated))) {
      ExplicitModel model = (ExplicitModel) ModelParts.of(compiled.newInstance()).equations();
      double[] y = new double[6];
      model.initialState(y);
      assertThat(model.derivative(0, y, new double[6])).isZero();
      y[1] = 0.4;
      assertThat(model.derivative(0, y, new double[6])).isEqualTo(ExplicitModel.REGULAR);
    }
  }

  @Test
  void coaxialJointsWithNothingBetweenAreTold() {
    Mechanism coaxial = Scenes.scene("coaxial_massless.json", "coaxial");
    ExplicitModel model = generated(coaxial);
    assertThat(model.derivative(0, new double[4], new double[4])).isZero();
  }

  @Test
  void anEvaluationAllocatesNothing() {
    com.sun.management.ThreadMXBean threads =
        (com.sun.management.ThreadMXBean) java.lang.management.ManagementFactory.getThreadMXBean();
    Mechanism mechanism = Scenes.timingModel("driver41").mechanism();
    ExplicitModel model = generated(mechanism);
    double[] y = RandomMechmlTrees.state(1, mechanism);
    double[] yDot = new double[y.length];
    double[] energy = new double[2];
    double[] poses = new double[BodyPoses.NUMBERS_PER_BODY * 41];
    long id = Thread.currentThread().getId();
    evaluateAll(model, y, yDot, energy, poses);
    long before = threads.getThreadAllocatedBytes(id);
    for (int i = 0; i < 100; i++) {
      evaluateAll(model, y, yDot, energy, poses);
    }
    long allocated = threads.getThreadAllocatedBytes(id) - before;
    // Asking for the count may itself allocate once.
    assertThat(allocated).isLessThan(100);
  }

  private static void evaluateAll(
      ExplicitModel model, double[] y, double[] yDot, double[] energy, double[] poses) {
    model.derivative(0, y, yDot);
    ((Energies) model).energy(TIME, y, energy);
    ((BodyPoses) model).poses(TIME, y, poses);
  }

  @Test
  void instancesDoNotShareTheirWorkspace() {
    MechmlModel model = Scenes.model(Scenes.pendulum());
    CompiledModel compiled = ModelFactory.compile(model, ALL, ModelFactory.generate(model, ALL));
    assertThat(compiled.newInstance()).isNotSameAs(compiled.newInstance());
    assertThat(compiled.newInstance().getClass()).isSameAs(compiled.newInstance().getClass());
  }

  @Test
  void aModelWithoutPosesDoesNotHaveThem() {
    MechmlModel model = Scenes.model(Scenes.pendulum());
    BuildOptions lean = new BuildOptions("auto", Set.of(), Scenes.SETTINGS);
    CompiledModel compiled = ModelFactory.compile(model, lean, ModelFactory.generate(model, lean));
    assertThat(compiled.newInstance()).isNotInstanceOf(BodyPoses.class);
    assertThat(List.of(compiled.newInstance().getClass().getInterfaces()))
        .containsExactly(ExplicitModel.class, Energies.class);
  }
}
