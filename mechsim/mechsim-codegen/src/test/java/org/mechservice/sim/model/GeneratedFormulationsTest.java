package org.mechservice.sim.model;

import static org.assertj.core.api.Assertions.assertThat;
import static org.mechservice.sim.model.ModelAgreement.assertClose;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.util.Arrays;
import java.util.EnumSet;
import java.util.List;
import java.util.Objects;
import java.util.Random;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Named;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.mechml.SimulationSettings;
import org.mechservice.sim.check.CheckReport;
import org.mechservice.sim.emit.bytes.MethodSizes;
import org.mechservice.sim.equations.CompositeInertiaEquations;
import org.mechservice.solver.api.Model;
import org.mechservice.solver.api.capability.ExplicitModel;
import org.mechservice.solver.api.capability.ModelParts;
import org.mechservice.solver.api.capability.ResidualModel;
import org.mechservice.solver.api.result.ColumnGroup;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.dynamics.RecursiveResidualModel;
import org.mechservice.solver.dynamics.SemiRecursiveModel;
import org.mechservice.solver.force.user.UserForceSource;
import org.mechservice.solver.links.Links;
import org.mechservice.solver.mechanism.Mechanism;

/** The formulations DSR and RR of open chains in generated code, against those driven by data. */
class GeneratedFormulationsTest {
  private static final double TIME = 0.4;

  private static BuildOptions options(String formulation) {
    String integrator = formulation.equals("RR") ? "ode15sR" : "DE";
    RunSettings settings = new RunSettings(0, 3, 0.01, integrator, 1e-5, 1e-5);
    return new BuildOptions(formulation, EnumSet.of(ColumnGroup.ENERGY), settings);
  }

  private static GeneratedModel generated(String formulation, Mechanism mechanism) {
    GeneratedModel generated = ModelFactory.generate(Scenes.model(mechanism), options(formulation));
    assertThat(generated.formulationReason()).doesNotContain("compact form");
    return generated;
  }

  private static Model model(String formulation, Mechanism mechanism) {
    MechmlModel file = Scenes.model(mechanism);
    return ModelFactory.compile(file, options(formulation), generated(formulation, mechanism))
        .newInstance();
  }

  static Stream<Named<Mechanism>> scenes() {
    return IntStream.rangeClosed(1, 12).mapToObj(GeneratedFormulationsTest::scene);
  }

  static Stream<Named<Mechanism>> manyScenes() {
    return IntStream.rangeClosed(13, 500).mapToObj(GeneratedFormulationsTest::scene);
  }

  private static Named<Mechanism> scene(int seed) {
    Mechanism tree = RandomMechmlTrees.anyKind(seed);
    return Named.of("seed " + seed, seed % 2 == 0 ? tree : RandomMechmlForces.on(tree, seed));
  }

  @ParameterizedTest
  @MethodSource("scenes")
  void accelerationsAndResidualsAgreeWithTheDataDrivenOnes(Mechanism mechanism) {
    assertAgreement(mechanism);
  }

  @Tag("soak")
  @ParameterizedTest
  @MethodSource("manyScenes")
  void accelerationsAndResidualsOfManyScenesAgreeWithTheDataDrivenOnes(Mechanism mechanism) {
    assertAgreement(mechanism);
  }

  private static void assertAgreement(Mechanism mechanism) {
    double[] y = RandomMechmlTrees.state(3, mechanism);
    double[] expected = new double[y.length];
    RunSettings settings = Scenes.SETTINGS;
    SemiRecursiveModel reference =
        new SemiRecursiveModel(mechanism, settings, UserForceSource.NONE);
    assertThat(reference.derivative(TIME, y, expected)).isEqualTo(ExplicitModel.REGULAR);
    double[] actual = new double[y.length];
    assertThat(
            ((ExplicitModel) ModelParts.of(model("DSR", mechanism)).equations())
                .derivative(TIME, y, actual))
        .isEqualTo(ExplicitModel.REGULAR);
    // Other operations in another order: rounding times depth and condition.
    assertClose(actual, expected, 1e-10);
    double[] yDot = new Random(7).doubles(y.length, -2, 2).toArray();
    ResidualModel residual = (ResidualModel) ModelParts.of(model("RR", mechanism)).equations();
    residual.residual(TIME, y, yDot, actual);
    new RecursiveResidualModel(mechanism, settings, UserForceSource.NONE)
        .residual(TIME, y, yDot, expected);
    // Nothing is solved for: rounding times depth.
    assertClose(actual, expected, 1e-12);
  }

  @ParameterizedTest
  @MethodSource("scenes")
  void theResidualOfTheDerivativeVanishes(Mechanism mechanism) {
    ResidualModel model = (ResidualModel) ModelParts.of(model("RR", mechanism)).equations();
    double[] y = RandomMechmlTrees.state(5, mechanism);
    double[] yDot = new double[y.length];
    assertThat(model.derivative(TIME, y, yDot)).isEqualTo(ExplicitModel.REGULAR);
    double[] residual = new double[y.length];
    double[] without = new double[y.length];
    model.residual(TIME, y, yDot, residual);
    double[] onlyRates = yDot.clone();
    Arrays.fill(onlyRates, model.description().positionCount(), y.length, 0);
    model.residual(TIME, y, onlyRates, without);
    double scale = Arrays.stream(without).map(Math::abs).max().orElse(0);
    for (double component : residual) {
      // The forces of a chain at rest cancel to rounding times condition.
      assertThat(Math.abs(component)).isLessThanOrEqualTo(1e-10 * scale);
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"DSR", "RR"})
  void theClassFileHasTheBitsOfTheCompiledSource(String formulation) {
    for (int seed = 3; seed <= 5; seed++) {
      Mechanism mechanism = scene(seed).getPayload();
      MechmlModel file = Scenes.model(mechanism);
      GeneratedModel generated = generated(formulation, mechanism);
      BuildOptions options = options(formulation);
      Model direct = ModelFactory.compile(file, options, generated).newInstance();
      Model compiled = ModelFactory.compileSource(file, options, generated).newInstance();
      double[] y = RandomMechmlTrees.state(seed, mechanism);
      assertThat(everything(direct, y)).containsExactly(everything(compiled, y));
    }
  }

  private static double[] everything(Model model, double[] y) {
    double[] all = new double[2 * y.length];
    double[] yDot = new double[y.length];
    ((ExplicitModel) ModelParts.of(model).equations()).derivative(TIME, y, yDot);
    System.arraycopy(yDot, 0, all, 0, y.length);
    if (model instanceof ResidualModel residual) {
      double[] out = new double[y.length];
      double[] rates = new Random(1).doubles(y.length, -1, 1).toArray();
      residual.residual(TIME, y, rates, out);
      System.arraycopy(out, 0, all, y.length, y.length);
    }
    return all;
  }

  /** As long as code is generated for: 26 234 operations in some 30 methods. */
  @Test
  void aLongChainHasShortMethodsAndTheBitsOfItsEquations() {
    Mechanism chain = RandomMechmlTrees.tree(1, 40);
    GeneratedModel generated = generated("DSR", chain);
    byte[] file = Objects.requireNonNull(generated.classFiles().get(generated.className()));
    assertThat(MethodSizes.longest(file)).isLessThan(8000);
    ExplicitModel model = (ExplicitModel) ModelParts.of(model("DSR", chain)).equations();
    double[] y = RandomMechmlTrees.state(1, chain);
    double[] actual = new double[y.length];
    double[] expected = new double[y.length];
    assertThat(model.derivative(TIME, y, actual)).isEqualTo(ExplicitModel.REGULAR);
    CompositeInertiaEquations.derive(Links.of(chain)).evaluate(TIME, y, expected);
    assertThat(actual).containsExactly(expected);
  }

  @Test
  void compositeInertiasThatDataEvaluateAsFastAreLeftToThem() {
    Mechanism chain = RandomMechmlTrees.ofAllJoints(1, 40);
    GeneratedModel generated = ModelFactory.generate(Scenes.model(chain), options("DSR"));
    assertThat(generated.formulationReason())
        .contains("compact form")
        .contains("DSR of more than 30000 operations (its factors alone take 62382)");
    Model model =
        ModelFactory.compile(Scenes.model(chain), options("DSR"), generated).newInstance();
    double[] y = RandomMechmlTrees.state(1, chain);
    double[] actual = new double[y.length];
    double[] expected = new double[y.length];
    ((ExplicitModel) ModelParts.of(model).equations()).derivative(TIME, y, actual);
    new SemiRecursiveModel(chain, Scenes.SETTINGS, UserForceSource.NONE)
        .derivative(TIME, y, expected);
    assertThat(actual).containsExactly(expected);
    SimulationSettings settings = new SimulationSettings(Scenes.SETTINGS, "DSR");
    assertThat(CheckReport.of(new MechmlModel(chain, settings, List.of())).text())
        .contains("code of its own: none is generated yet for DSR of more than 30000 operations");
  }

  @Test
  void aChainTooLongForCodeByCompositeInertiasIsGeneratedByArticulatedBodies() {
    assertThat(generated("DTR", RandomMechmlTrees.ofAllJoints(1, 40)).operations())
        .isLessThan(30_000);
  }

  @Test
  void anEvaluationAllocatesNothing() {
    Mechanism driver = Scenes.timingModel("driver41").mechanism();
    ResidualModel model = (ResidualModel) ModelParts.of(model("RR", driver)).equations();
    ExplicitModel explicit = (ExplicitModel) ModelParts.of(model("DSR", driver)).equations();
    double[] y = RandomMechmlTrees.state(2, driver);
    double[] yDot = new double[y.length];
    double[] residual = new double[y.length];
    ThreadMXBean thread = (ThreadMXBean) ManagementFactory.getThreadMXBean();
    long least = Long.MAX_VALUE;
    // The virtual machine itself may allocate while it compiles: the least of several counts.
    for (int round = 0; round < 5; round++) {
      long before = thread.getCurrentThreadAllocatedBytes();
      for (int i = 0; i < 50; i++) {
        explicit.derivative(TIME, y, yDot);
        model.residual(TIME, y, yDot, residual);
      }
      least = Math.min(least, thread.getCurrentThreadAllocatedBytes() - before);
    }
    assertThat(least).isZero();
  }
}
