package org.mechservice.sim.model;

import static org.assertj.core.api.Assertions.assertThat;
import static org.mechservice.sim.model.ModelAgreement.assertClose;
import static org.mechservice.sim.model.ModelAgreement.assertEnergiesClose;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.EnumSet;
import java.util.List;
import java.util.Random;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Named;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.guard.ModelClassLoader;
import org.mechservice.sim.compile.ModelCompiler;
import org.mechservice.solver.api.Model;
import org.mechservice.solver.api.ModelSource;
import org.mechservice.solver.api.capability.BodyPoses;
import org.mechservice.solver.api.capability.Defects;
import org.mechservice.solver.api.capability.ExplicitModel;
import org.mechservice.solver.api.capability.LinearisedModel;
import org.mechservice.solver.api.capability.ModelParts;
import org.mechservice.solver.api.capability.ResidualModel;
import org.mechservice.solver.api.result.ColumnGroup;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.dynamics.DataDrivenModel;
import org.mechservice.solver.dynamics.LinearisedResidualModel;
import org.mechservice.solver.dynamics.RecursiveResidualModel;
import org.mechservice.solver.expression.BodyPoint;
import org.mechservice.solver.force.user.UserForceSource;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.force.ForceElement;
import org.mechservice.solver.mechanism.force.NamedPoint;
import org.mechservice.solver.mechanism.force.UserForceElement;
import org.mechservice.solver.spatial.Vector3;
import org.mechservice.solver.text.Origin;

/** Forces that users have written as classes, called by generated code, against the data-driven. */
@Tag("slow")
class GeneratedUserForcesTest {
  private static final double TIME = 0.4;
  static final UserForceSource FORCES = element -> new PullingForce();

  private static BuildOptions options(String formulation) {
    String integrator = formulation.startsWith("RR") ? "ode15sR" : "DE";
    RunSettings settings = new RunSettings(0, 3, 0.01, integrator, 1e-5, 1e-5);
    return new BuildOptions(
        formulation, EnumSet.of(ColumnGroup.ENERGY, ColumnGroup.BODIES), settings);
  }

  static Stream<Named<Mechanism>> scenes() {
    return IntStream.rangeClosed(1, 12).mapToObj(GeneratedUserForcesTest::scene);
  }

  static Stream<Named<Mechanism>> manyScenes() {
    return IntStream.rangeClosed(13, 500).mapToObj(GeneratedUserForcesTest::scene);
  }

  private static Named<Mechanism> scene(int seed) {
    Mechanism tree = RandomMechmlTrees.anyKind(seed);
    return Named.of(
        "seed " + seed, pulled(seed % 2 == 0 ? tree : RandomMechmlForces.on(tree, seed)));
  }

  /** Two classes of users among the other forces, at any points. */
  static Mechanism pulled(Mechanism m) {
    Random random = new Random(m.bodies().size());
    List<NamedPoint> points = new ArrayList<>();
    for (String body : List.of("A", "B", "C")) {
      Vector3 place = new Vector3(random.nextDouble(), random.nextDouble(), random.nextDouble());
      points.add(
          new NamedPoint(body, "p", new BodyPoint(random.nextInt(m.bodies().size()), place)));
    }
    String className = PullingForce.class.getName();
    List<ForceElement> forces = new ArrayList<>(m.forces());
    forces.add(0, new UserForceElement("pull", className, points, Origin.NONE));
    forces.add(new UserForceElement("again", className, points, Origin.NONE));
    return new Mechanism(
            m.name(),
            m.root(),
            m.gravity(),
            m.bodies(),
            m.joints(),
            m.motions(),
            m.startRoles(),
            m.closures(),
            forces,
            m.parameters())
        .withArmatures(m.armatures());
  }

  private static GeneratedModel generated(String formulation, Mechanism mechanism) {
    GeneratedModel generated = ModelFactory.generate(Scenes.model(mechanism), options(formulation));
    assertThat(generated.formulationReason())
        .doesNotContain("compact form")
        .endsWith("every evaluation calls the classes of forces \"pull\", \"again\"");
    return generated;
  }

  private static Model model(String formulation, Mechanism mechanism) {
    return loaded(generated(formulation, mechanism), new TreeMap<>());
  }

  private static Model loaded(GeneratedModel generated, SortedMap<String, byte[]> instead) {
    return loaded(generated, instead, GeneratedUserForcesTest.class.getClassLoader());
  }

  /** Returns an instance of generated classes, some replaced, with a loader of users' classes. */
  static Model loaded(
      GeneratedModel generated, SortedMap<String, byte[]> instead, ClassLoader users) {
    SortedMap<String, byte[]> files = new TreeMap<>(generated.classFiles());
    files.putAll(instead);
    try {
      Class<?> type = new ModelClassLoader(files, users).loadClass(generated.className());
      return ModelSource.from(type.getConstructor().newInstance()).model();
    } catch (ReflectiveOperationException e) {
      throw new LinkageError("the generated class", e);
    }
  }

  @ParameterizedTest
  @MethodSource("scenes")
  void generatedCodeThatCallsThemAgreesWithTheDataDrivenForm(Mechanism mechanism) {
    assertAgreement(mechanism);
  }

  @Tag("soak")
  @ParameterizedTest
  @MethodSource("manyScenes")
  void generatedCodeOfManyScenesAgreesWithTheDataDrivenForm(Mechanism mechanism) {
    assertAgreement(mechanism);
  }

  private static void assertAgreement(Mechanism mechanism) {
    double[] y = RandomMechmlTrees.state(3, mechanism);
    double[] expected = new double[y.length];
    double[] actual = new double[y.length];
    DataDrivenModel reference = new DataDrivenModel(mechanism, Scenes.SETTINGS, FORCES);
    assertThat(reference.derivative(TIME, y, expected)).isEqualTo(ExplicitModel.REGULAR);
    for (String formulation : List.of("DTR", "DSR")) {
      Model model = model(formulation, mechanism);
      assertThat(((ExplicitModel) ModelParts.of(model).equations()).derivative(TIME, y, actual))
          .isEqualTo(ExplicitModel.REGULAR);
      // Other operations in another order: rounding times depth and condition.
      assertClose(actual, expected, 1e-10);
      assertEnergies(model, reference, y);
    }
    double[] yDot = new Random(7).doubles(y.length, -2, 2).toArray();
    ((ResidualModel) ModelParts.of(model("RR", mechanism)).equations())
        .residual(TIME, y, yDot, actual);
    new RecursiveResidualModel(mechanism, Scenes.SETTINGS, FORCES)
        .residual(TIME, y, yDot, expected);
    // Nothing is solved for: rounding times depth.
    assertClose(actual, expected, 1e-12);
  }

  private static void assertEnergies(Model model, DataDrivenModel reference, double[] y) {
    assertEnergiesClose(model, reference, TIME, y);
    double[] poses = new double[13 * reference.bodies().size()];
    double[] expected = poses.clone();
    ((BodyPoses) ModelParts.of(model).equations()).poses(TIME, y, poses);
    reference.poses(TIME, y, expected);
    assertClose(poses, expected, 1e-12);
  }

  /** A short step asks for M, a long one for the derivatives by position, others for all three. */
  @ParameterizedTest
  @MethodSource("scenes")
  void implicitStepsAreThoseOfTheDataDrivenForm(Mechanism mechanism) {
    assertSteps(mechanism);
  }

  @Tag("soak")
  @ParameterizedTest
  @MethodSource("manyScenes")
  void implicitStepsOfManyScenesAreThoseOfTheDataDrivenForm(Mechanism mechanism) {
    assertSteps(mechanism);
  }

  private static void assertSteps(Mechanism mechanism) {
    LinearisedModel reference =
        new LinearisedResidualModel(
            mechanism, Scenes.SETTINGS, FORCES, LinearisedResidualModel.Mode.FULL);
    LinearisedModel model = (LinearisedModel) ModelParts.of(model("RR-JF", mechanism)).equations();
    double[] y = RandomMechmlTrees.state(3, mechanism);
    double[] yDot = new Random(7).doubles(y.length, -2, 2).toArray();
    assertThat(reference.linearise(TIME, y, yDot)).isTrue();
    assertThat(model.linearise(TIME, y, yDot)).isTrue();
    for (double hGamma : new double[] {1e-6, 1e-2, 0.3, 10}) {
      assertThat(reference.factor(hGamma)).isTrue();
      assertThat(model.factor(hGamma)).isTrue();
      double[] expected = new Random(9).doubles(y.length, -1, 1).toArray();
      double[] actual = expected.clone();
      reference.solve(expected);
      model.solve(actual);
      // Other operations in another order: rounding times depth and condition.
      assertClose(actual, expected, 1e-8);
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"DTR", "RR-JF"})
  void theClassFileHasTheBitsOfTheCompiledSource(String formulation) {
    for (int seed = 3; seed <= 5; seed++) {
      Mechanism mechanism = scene(seed).getPayload();
      GeneratedModel generated = generated(formulation, mechanism);
      SortedMap<String, byte[]> compiled =
          ModelCompiler.compile(generated.sourceName(), generated.source(), new TreeMap<>());
      double[] y = RandomMechmlTrees.state(seed, mechanism);
      double[] direct = new double[y.length];
      double[] fromSource = new double[y.length];
      ((ExplicitModel) ModelParts.of(loaded(generated, new TreeMap<>())).equations())
          .derivative(TIME, y, direct);
      ((ExplicitModel) ModelParts.of(loaded(generated, compiled)).equations())
          .derivative(TIME, y, fromSource);
      assertThat(direct).containsExactly(fromSource);
    }
  }

  @Test
  void aForceThatIsNotFiniteEndsTheEvaluationWithItsName() {
    Mechanism mechanism = scene(2).getPayload();
    ExplicitModel model = (ExplicitModel) ModelParts.of(model("DTR", mechanism)).equations();
    double[] y = RandomMechmlTrees.state(3, mechanism);
    Arrays.fill(y, mechanism.positionCount(), y.length, 1e200);
    assertThat(model.derivative(TIME, y, new double[y.length])).isEqualTo(Defects.DEFECT);
    assertThat(((Defects) model).lastDefect().part()).isEqualTo("force pull");
  }
}
