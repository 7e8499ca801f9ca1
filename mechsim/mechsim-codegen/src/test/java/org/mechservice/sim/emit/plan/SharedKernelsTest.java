package org.mechservice.sim.emit.plan;

import static org.assertj.core.api.Assertions.assertThat;

import java.lang.management.ManagementFactory;
import java.util.Arrays;
import java.util.EnumSet;
import java.util.HashMap;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.function.BiFunction;
import java.util.stream.IntStream;
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
import org.mechservice.sim.model.Chains;
import org.mechservice.sim.model.CompiledModel;
import org.mechservice.sim.model.GeneratedModel;
import org.mechservice.sim.model.ModelFactory;
import org.mechservice.sim.model.RandomMechmlForces;
import org.mechservice.sim.model.RandomMechmlLoops;
import org.mechservice.sim.model.RandomMechmlTrees;
import org.mechservice.sim.model.Scenes;
import org.mechservice.sim.packaging.ModelJars;
import org.mechservice.solver.api.Model;
import org.mechservice.solver.api.capability.BodyPoses;
import org.mechservice.solver.api.capability.Energies;
import org.mechservice.solver.api.capability.ExplicitModel;
import org.mechservice.solver.api.capability.ModelParts;
import org.mechservice.solver.api.capability.ResidualModel;
import org.mechservice.solver.api.result.ColumnGroup;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.dynamics.TreeStepModel;
import org.mechservice.solver.mechanism.Mechanism;

/** Code in which bodies that are alike share methods, against the same written out. */
@Tag("slow")
class SharedKernelsTest {
  private static final double TIME = 0.7;

  private static BuildOptions options(String formulation, CodeForm form) {
    Set<ColumnGroup> columns = EnumSet.range(ColumnGroup.JOINTS, ColumnGroup.ENERGY);
    String integrator = formulation.startsWith("RR") ? "ode15sR" : "DE";
    RunSettings settings = new RunSettings(0, 3, 0.01, integrator, 1e-5, 1e-5);
    return new BuildOptions(formulation, columns, settings).in(form);
  }

  private static GeneratedModel generated(Mechanism mechanism, CodeForm form) {
    return ModelFactory.generate(Scenes.model(mechanism), options("DTR", form));
  }

  private static byte[] classFile(GeneratedModel generated) {
    return Objects.requireNonNull(generated.classFiles().get(generated.sourceName()));
  }

  private static final List<Named<Mechanism>> SCENES = madeScenes().toList();

  /**
   * Code of these scenes by formulation, in which bodies share methods: made once for all tests.
   */
  private static final IdentityHashMap<Mechanism, Map<String, GeneratedModel>> SHARED =
      new IdentityHashMap<>();

  private static GeneratedModel shared(Mechanism mechanism, String formulation) {
    return ModelFactory.generate(Scenes.model(mechanism), options(formulation, CodeForm.SHARED));
  }

  private static GeneratedModel sharedOfScene(Mechanism mechanism, String formulation) {
    return SHARED
        .computeIfAbsent(mechanism, each -> new HashMap<>())
        .computeIfAbsent(formulation, each -> shared(mechanism, each));
  }

  static Stream<Named<Mechanism>> scenes() {
    return SCENES.stream();
  }

  private static Stream<Named<Mechanism>> madeScenes() {
    return Stream.of(
            Stream.of(
                Chains.ofEqualLinks(11),
                Chains.ofDifferentLinks(12),
                Scenes.timingModel("driver41").mechanism(),
                Scenes.scene("gimbal_q2_1.5707963267948966.json", "gimbal")),
            seeds(2).map(seed -> RandomMechmlTrees.tree(seed, 8 + seed)),
            seeds(3).map(seed -> RandomMechmlTrees.ofAllJoints(seed, 5 + 2 * seed)),
            seeds(2).map(seed -> RandomMechmlTrees.driven(seed, 6 + seed)),
            seeds(3)
                .map(seed -> RandomMechmlForces.on(RandomMechmlTrees.ofAllJoints(seed, 6), seed)))
        .flatMap(mechanisms -> mechanisms)
        .map(mechanism -> Named.of(mechanism.name(), mechanism));
  }

  private static Stream<Integer> seeds(int count) {
    return IntStream.rangeClosed(1, count).boxed();
  }

  static Stream<Named<Mechanism>> manyScenes() {
    return IntStream.rangeClosed(11, 210).mapToObj(SharedKernelsTest::scene);
  }

  private static Named<Mechanism> scene(int seed) {
    int bodies = 5 + seed % 5;
    Mechanism tree =
        switch (seed % 3) {
          case 0 -> RandomMechmlTrees.tree(seed, bodies);
          case 1 -> RandomMechmlTrees.ofAllJoints(seed, bodies);
          default -> RandomMechmlTrees.driven(seed, bodies);
        };
    return Named.of("seed " + seed, seed % 2 == 0 ? tree : RandomMechmlForces.on(tree, seed));
  }

  @ParameterizedTest
  @MethodSource("scenes")
  void theyHaveTheBitsOfTheStraightLine(Mechanism mechanism) {
    assertBitsOfTheStraightLine(mechanism, SharedKernelsTest::sharedOfScene);
  }

  @Tag("soak")
  @ParameterizedTest
  @MethodSource("manyScenes")
  void theyHaveTheBitsOfTheStraightLineInManyScenes(Mechanism mechanism) {
    assertBitsOfTheStraightLine(mechanism, SharedKernelsTest::shared);
  }

  private static void assertBitsOfTheStraightLine(
      Mechanism mechanism, BiFunction<Mechanism, String, GeneratedModel> generated) {
    MechmlModel file = Scenes.model(mechanism);
    for (String formulation : new String[] {"DTR", "DSR", "RR-JF"}) {
      BuildOptions straight = options(formulation, CodeForm.STRAIGHT);
      BuildOptions shared = options(formulation, CodeForm.SHARED);
      Model one = compiled(file, straight).newInstance();
      Model other =
          ModelFactory.compile(file, shared, generated.apply(mechanism, formulation)).newInstance();
      assertThat(everything(other, mechanism)).containsExactly(everything(one, mechanism));
    }
  }

  private static CompiledModel compiled(MechmlModel file, BuildOptions options) {
    return ModelFactory.compile(file, options, ModelFactory.generate(file, options));
  }

  @ParameterizedTest
  @MethodSource("scenes")
  void theClassFileHasTheBitsOfTheCompiledSource(Mechanism mechanism) {
    MechmlModel file = Scenes.model(mechanism);
    for (String formulation : new String[] {"DTR", "RR-JF"}) {
      BuildOptions options = options(formulation, CodeForm.SHARED);
      GeneratedModel generated = sharedOfScene(mechanism, formulation);
      Model direct = ModelFactory.compile(file, options, generated).newInstance();
      Model source = ModelFactory.compileSource(file, options, generated).newInstance();
      assertThat(everything(source, mechanism)).containsExactly(everything(direct, mechanism));
    }
  }

  /**
   * Start, derivative, result, residual, its derivatives, energies and poses as bits, one after the
   * other.
   */
  private static long[] everything(Model model, Mechanism mechanism) {
    double[] start = new double[model.description().stateCount()];
    model.initialState(start);
    double[] states = RandomMechmlTrees.state(3, mechanism);
    return Stream.of(start, states)
        .flatMap(y -> Stream.of(y, at(model, y, mechanism.bodies().size())))
        .flatMapToDouble(Arrays::stream)
        .mapToLong(Double::doubleToRawLongBits)
        .toArray();
  }

  private static double[] at(Model model, double[] y, int bodies) {
    double[] yDot = new double[y.length];
    double[] residual = new double[y.length];
    double[] energy = new double[2];
    double[] poses = new double[BodyPoses.NUMBERS_PER_BODY * bodies];
    double[] result = {
      ((ExplicitModel) ModelParts.of(model).equations()).derivative(TIME, y, yDot)
    };
    if (model instanceof ResidualModel implicit) {
      implicit.residual(TIME, y, yDot, residual);
    }
    double[] derivatives = new double[3 * y.length * y.length];
    if (model instanceof TreeStepModel steps) {
      steps.derivatives(TIME, y, yDot, derivatives);
    }
    ((Energies) ModelParts.of(model).equations()).energy(TIME, y, energy);
    if (model instanceof BodyPoses places) {
      places.poses(TIME, y, poses);
    }
    return Stream.of(yDot, result, residual, derivatives, energy, poses)
        .flatMapToDouble(Arrays::stream)
        .toArray();
  }

  @ParameterizedTest
  @ValueSource(ints = {1, 2})
  void theTermsOfLoopsHaveTheBitsOfTheStraightLine(int seed) {
    Mechanism mechanism = RandomMechmlLoops.on(RandomMechmlTrees.ofAllJoints(seed, 6), seed, 1);
    MechmlModel file = Scenes.model(mechanism);
    double[] y = RandomMechmlTrees.state(seed, mechanism);
    double[][] found = new double[2][y.length];
    for (CodeForm form : new CodeForm[] {CodeForm.STRAIGHT, CodeForm.SHARED}) {
      BuildOptions options =
          new BuildOptions("DSR", "penalty", false, Set.of(), Scenes.SETTINGS).in(form);
      ExplicitModel model =
          (ExplicitModel) ModelParts.of(compiled(file, options).newInstance()).equations();
      model.derivative(TIME, y, found[form == CodeForm.SHARED ? 1 : 0]);
    }
    assertThat(found[1]).containsExactly(found[0]);
  }

  @Test
  void equalLinksTakeTheSameCodeInAChainOfAnyLength() {
    String code = generated(Chains.ofEqualLinks(60), CodeForm.SHARED).code();
    String longer = generated(Chains.ofEqualLinks(120), CodeForm.SHARED).code();
    assertThat(methods(code)).isEqualTo(methods(longer)).isLessThan(25);
  }

  /** Every step on the way from a link to the root is like those of other links. */
  @Test
  void equalLinksTakeTheSameStepsOfDerivativesInAChainOfAnyLength() {
    assertThat(methodsOfDerivatives(Chains.ofEqualLinks(20)))
        .isEqualTo(methodsOfDerivatives(Chains.ofEqualLinks(30)))
        .isLessThan(70);
  }

  private static int methodsOfDerivatives(Mechanism chain) {
    MechmlModel file = Scenes.model(chain);
    String code = ModelFactory.generate(file, options("RR-JF", CodeForm.SHARED)).code();
    return methods(code.replaceAll(".*derivatives ", "derivative "));
  }

  private static int methods(String code) {
    return Integer.parseInt(code.replaceAll("(?s).*?derivative.*? in (\\d+) methods.*", "$1"));
  }

  @Test
  void aLongChainOfLinksThatAreAlikeSharesThem() {
    assertThat(generated(Chains.ofDifferentLinks(60), CodeForm.AUTO).code())
        .startsWith("shared kernels: derivative")
        .contains("shorter than as a straight line");
  }

  @Test
  void aSmallModelIsWrittenOut() {
    assertThat(generated(Scenes.pendulum(), CodeForm.AUTO).code())
        .startsWith("straight line: derivative")
        .doesNotContain("shared");
  }

  @Test
  void aLargeModelWithoutLinksThatAreAlikeIsWrittenOutAndToldWhy() {
    assertThat(generated(RandomMechmlTrees.tree(1, 40), CodeForm.AUTO).code())
        .startsWith("straight line: derivative")
        .contains("shared kernels would take");
  }

  @Test
  void eitherFormIsHadForTheAsking() {
    Mechanism chain = Chains.ofDifferentLinks(60);
    assertThat(generated(chain, CodeForm.STRAIGHT).code()).startsWith("straight line");
    assertThat(generated(Chains.ofEqualLinks(11), CodeForm.SHARED).code())
        .startsWith("shared kernels");
  }

  @Test
  void theManifestSaysWhichFormAModelHas() {
    MechmlModel file = Scenes.model(Chains.ofDifferentLinks(60));
    CompiledModel model = compiled(file, options("DTR", CodeForm.AUTO));
    assertThat(ModelJars.model(model, "0".repeat(64)).manifest().get("Mech-Code"))
        .isEqualTo(model.generated().code());
  }

  /** Straight lines of so many operations do not fit into a class file. */
  @Test
  void aChainOfAThousandLinksIsOneSmallClass() {
    MechmlModel chain = Scenes.model(Chains.ofEqualLinks(1000));
    BuildOptions options = new BuildOptions("DTR", Set.of(), Scenes.SETTINGS).in(CodeForm.SHARED);
    byte[] file = classFile(ModelFactory.generate(chain, options));
    assertThat(file.length).isLessThan(65_000);
    assertThat(MethodSizes.longest(file)).isLessThan(8000);
  }

  @Test
  void anEvaluationAllocatesNothing() {
    com.sun.management.ThreadMXBean threads =
        (com.sun.management.ThreadMXBean) ManagementFactory.getThreadMXBean();
    Mechanism mechanism = Chains.ofDifferentLinks(12);
    ExplicitModel model =
        (ExplicitModel)
            ModelParts.of(
                    compiled(Scenes.model(mechanism), options("DTR", CodeForm.SHARED))
                        .newInstance())
                .equations();
    double[] y = RandomMechmlTrees.state(1, mechanism);
    double[] yDot = new double[y.length];
    model.derivative(TIME, y, yDot);
    long id = Thread.currentThread().getId();
    long before = threads.getThreadAllocatedBytes(id);
    for (int i = 0; i < 100; i++) {
      model.derivative(TIME, y, yDot);
    }
    // Asking for the count may itself allocate once.
    assertThat(threads.getThreadAllocatedBytes(id) - before).isLessThan(100);
  }
}
