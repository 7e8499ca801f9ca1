package org.mechservice.sim.equations.force;

import static org.assertj.core.api.Assertions.assertThat;
import static org.mechservice.sim.model.ModelAgreement.assertClose;
import static org.mechservice.sim.model.ModelAgreement.assertEnergiesClose;

import java.util.Arrays;
import java.util.EnumSet;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Named;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.sim.model.BuildOptions;
import org.mechservice.sim.model.GeneratedModel;
import org.mechservice.sim.model.ModelFactory;
import org.mechservice.sim.model.RandomMechmlForces;
import org.mechservice.sim.model.RandomMechmlTrees;
import org.mechservice.sim.model.Scenes;
import org.mechservice.solver.api.Model;
import org.mechservice.solver.api.capability.Energies;
import org.mechservice.solver.api.capability.ExplicitModel;
import org.mechservice.solver.api.capability.ModelParts;
import org.mechservice.solver.api.capability.PowerInput;
import org.mechservice.solver.api.capability.ResultColumns;
import org.mechservice.solver.api.result.ColumnGroup;
import org.mechservice.solver.dynamics.DataDrivenModel;
import org.mechservice.solver.mechanism.Mechanism;

/** Forces in generated code against those that data drive. */
class GeneratedForcesTest {
  private static final double TIME = 0.4;

  private static final BuildOptions ALL =
      new BuildOptions("auto", EnumSet.of(ColumnGroup.FORCES, ColumnGroup.ENERGY), Scenes.SETTINGS);

  static Stream<Named<Mechanism>> scenes() {
    return IntStream.rangeClosed(1, 12).mapToObj(GeneratedForcesTest::scene);
  }

  static Stream<Named<Mechanism>> manyScenes() {
    return IntStream.rangeClosed(13, 500).mapToObj(GeneratedForcesTest::scene);
  }

  private static Named<Mechanism> scene(int seed) {
    Mechanism tree = RandomMechmlTrees.anyKind(seed);
    return Named.of("seed " + seed, RandomMechmlForces.on(tree, seed));
  }

  @ParameterizedTest
  @MethodSource("scenes")
  void forcesAgreeWithTheDataDrivenOnes(Mechanism mechanism) {
    assertAgreement(mechanism);
  }

  @Tag("soak")
  @ParameterizedTest
  @MethodSource("manyScenes")
  void forcesOfManyScenesAgreeWithTheDataDrivenOnes(Mechanism mechanism) {
    assertAgreement(mechanism);
  }

  @ParameterizedTest
  @ValueSource(ints = {3, 4, 6})
  void theClassFileHasTheBitsOfTheCompiledSource(int seed) {
    Mechanism mechanism = scene(seed).getPayload();
    MechmlModel file = Scenes.model(mechanism);
    GeneratedModel generated = ModelFactory.generate(file, ALL);
    double[] y = RandomMechmlTrees.state(seed, mechanism);
    Model compiled = ModelFactory.compile(file, ALL, generated).newInstance();
    Model ofSource = ModelFactory.compileSource(file, ALL, generated).newInstance();
    assertThat(everything(compiled, y)).containsExactly(everything(ofSource, y));
  }

  private static double[] everything(Model whole, double[] y) {
    Model model = ModelParts.of(whole).equations();
    double[] yDot = new double[y.length];
    ((ExplicitModel) ModelParts.of(model).equations()).derivative(TIME, y, yDot);
    ResultColumns columns = (ResultColumns) model;
    double[] values = new double[columns.columns(ColumnGroup.FORCES).size()];
    columns.values(ColumnGroup.FORCES, TIME, y, values, 0);
    double[] energy = new double[2];
    ((Energies) ModelParts.of(model).equations()).energy(TIME, y, energy);
    double[] power = new double[2];
    ((PowerInput) ModelParts.of(model).equations()).power(TIME, y, power);
    return Stream.of(yDot, values, energy, power).flatMapToDouble(Arrays::stream).toArray();
  }

  private static void assertAgreement(Mechanism mechanism) {
    MechmlModel file = Scenes.model(mechanism);
    Model whole = ModelFactory.compile(file, ALL, ModelFactory.generate(file, ALL)).newInstance();
    Model model = ModelParts.of(whole).equations();
    DataDrivenModel reference = new DataDrivenModel(mechanism, Scenes.SETTINGS);
    double[] y = RandomMechmlTrees.state(3, mechanism);
    double[] actual = new double[y.length];
    double[] expected = new double[y.length];
    assertThat(reference.derivative(TIME, y, expected)).isEqualTo(ExplicitModel.REGULAR);
    assertThat(((ExplicitModel) ModelParts.of(model).equations()).derivative(TIME, y, actual))
        .isEqualTo(ExplicitModel.REGULAR);
    // Other operations in another order: rounding times depth and condition.
    assertClose(actual, expected, 1e-10);
    assertEnergiesClose(model, reference, TIME, y);
    assertValues(model, reference, y);
  }

  private static void assertValues(Model model, DataDrivenModel reference, double[] y) {
    ResultColumns columns = (ResultColumns) model;
    assertThat(columns.columns(ColumnGroup.FORCES))
        .isEqualTo(reference.columns(ColumnGroup.FORCES));
    int count = reference.columns(ColumnGroup.FORCES).size();
    double[] values = new double[count + 1];
    double[] expected = new double[count + 1];
    columns.values(ColumnGroup.FORCES, TIME, y, values, 1);
    reference.values(ColumnGroup.FORCES, TIME, y, expected, 1);
    assertClose(values, expected, 1e-10);
    assertThat(columns.columns(ColumnGroup.BODIES)).isEmpty();
  }
}
