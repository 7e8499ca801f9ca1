package org.mechservice.sim.equations.derivatives;

import static org.assertj.core.api.Assertions.assertThat;
import static org.mechservice.sim.model.ModelAgreement.assertClose;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.util.Arrays;
import java.util.Collections;
import java.util.EnumSet;
import java.util.IdentityHashMap;
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
import org.mechservice.mechml.MechmlModel;
import org.mechservice.sim.emit.bytes.MethodSizes;
import org.mechservice.sim.model.BuildOptions;
import org.mechservice.sim.model.CompiledModel;
import org.mechservice.sim.model.GeneratedModel;
import org.mechservice.sim.model.LoopAgreement;
import org.mechservice.sim.model.ModelFactory;
import org.mechservice.sim.model.RandomMechmlForces;
import org.mechservice.sim.model.RandomMechmlTrees;
import org.mechservice.sim.model.Scenes;
import org.mechservice.solver.api.Model;
import org.mechservice.solver.api.capability.ExplicitModel;
import org.mechservice.solver.api.capability.LinearisedModel;
import org.mechservice.solver.api.capability.ModelParts;
import org.mechservice.solver.api.result.ColumnGroup;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.dynamics.LinearisedResidualModel;
import org.mechservice.solver.dynamics.TreeStepModel;
import org.mechservice.solver.expression.BodyFrame;
import org.mechservice.solver.expression.BodyPoint;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.force.user.UserForceSource;
import org.mechservice.solver.links.Links;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.force.Bushing;
import org.mechservice.solver.spatial.Rotation;
import org.mechservice.solver.spatial.Vector3;
import org.mechservice.solver.text.Origin;

/** RR-JF of open chains in generated code, against the one driven by data. */
@Tag("slow")
class GeneratedJacobianTest {
  private static final double TIME = 0.4;

  private static final BuildOptions OPTIONS =
      new BuildOptions(
          "RR-JF",
          EnumSet.of(ColumnGroup.ENERGY),
          new RunSettings(0, 3, 0.01, "ode15sR", 1e-5, 1e-5));

  /** In the last one a force couples some velocities of a ball, not all, with another branch. */
  private static final List<Named<Mechanism>> SCENES =
      IntStream.concat(IntStream.rangeClosed(1, 24), IntStream.of(187))
          .mapToObj(GeneratedJacobianTest::scene)
          .toList();

  /** Code of these scenes, made once for all tests. */
  private static final IdentityHashMap<Mechanism, CompiledModel> CODE = new IdentityHashMap<>();

  static Stream<Named<Mechanism>> scenes() {
    return SCENES.stream();
  }

  static Stream<Named<Mechanism>> manyScenes() {
    return IntStream.rangeClosed(25, 500).mapToObj(GeneratedJacobianTest::scene);
  }

  private static Named<Mechanism> scene(int seed) {
    Mechanism tree = RandomMechmlTrees.anyKind(seed);
    return Named.of("seed " + seed, seed % 2 == 0 ? tree : RandomMechmlForces.on(tree, seed));
  }

  private static TreeStepModel model(Mechanism mechanism) {
    return (TreeStepModel) ModelParts.of(compiled(mechanism).newInstance()).equations();
  }

  private static CompiledModel compiled(Mechanism mechanism) {
    MechmlModel file = Scenes.model(mechanism);
    GeneratedModel generated = ModelFactory.generate(file, OPTIONS);
    assertThat(generated.formulationReason()).doesNotContain("compact form");
    return ModelFactory.compile(file, OPTIONS, generated);
  }

  private static TreeStepModel modelOfScene(Mechanism mechanism) {
    return (TreeStepModel)
        ModelParts.of(
                CODE.computeIfAbsent(mechanism, GeneratedJacobianTest::compiled).newInstance())
            .equations();
  }

  @ParameterizedTest
  @MethodSource("scenes")
  void implicitStepsAreThoseOfTheDataDrivenForm(Mechanism mechanism) {
    assertAgreement(mechanism, modelOfScene(mechanism));
  }

  @Tag("soak")
  @ParameterizedTest
  @MethodSource("manyScenes")
  void implicitStepsOfManyScenesAreThoseOfTheDataDrivenForm(Mechanism mechanism) {
    assertAgreement(mechanism, model(mechanism));
  }

  /** A short step asks for M, a long one for the derivatives by position, others for all three. */
  private static void assertAgreement(Mechanism mechanism, LinearisedModel model) {
    LinearisedModel reference =
        new LinearisedResidualModel(
            mechanism, Scenes.SETTINGS, UserForceSource.NONE, LinearisedResidualModel.Mode.FULL);
    double[] y = RandomMechmlTrees.state(3, mechanism);
    double[] yDot = new Random(7).doubles(y.length, -2, 2).toArray();
    assertThat(reference.linearise(TIME, y, yDot)).isTrue();
    assertThat(model.linearise(TIME, y, yDot)).isTrue();
    for (double hGamma : new double[] {1e-6, 1e-2, 0.3, 10}) {
      assertThat(reference.factor(hGamma)).isTrue();
      assertThat(model.factor(hGamma)).isTrue();
      double[] expected = solution(reference, y.length);
      // Other operations in another order: rounding times depth; what the condition of the matrix
      // makes of it shows where the state is another in its last digit.
      double felt = 0;
      for (int seed = 0; seed < 3; seed++) {
        if (reference.linearise(TIME, LoopAgreement.beside(y, seed), yDot)
            && reference.factor(hGamma)) {
          felt = Math.max(felt, difference(solution(reference, y.length), expected));
        }
      }
      assertThat(reference.linearise(TIME, y, yDot)).isTrue();
      double difference = difference(solution(model, y.length), expected);
      assertThat(difference).as("h gamma %s", hGamma).isLessThanOrEqualTo(1e-8 + 10 * felt);
    }
  }

  private static double[] solution(LinearisedModel model, int states) {
    double[] solution = new Random(9).doubles(states, -1, 1).toArray();
    model.solve(solution);
    return solution;
  }

  /** Returns the largest difference over the largest element. */
  private static double difference(double[] actual, double[] expected) {
    double scale = Arrays.stream(expected).map(Math::abs).max().orElse(1);
    double difference = 0;
    for (int i = 0; i < expected.length; i++) {
      difference = Math.max(difference, Math.abs(actual[i] - expected[i]));
    }
    return difference / scale;
  }

  /** There the angle of the turn has a tip, and the turn itself has not. */
  @Test
  void aBushingThatDoesNotTurnYetHasDerivatives() {
    TreeStepModel model = model(mounted(Scenes.pendulum()));
    double[] y = new double[model.description().stateCount()];
    double[] yDot = new double[y.length];
    assertThat(model.derivative(0, y, yDot)).isEqualTo(ExplicitModel.REGULAR);
    assertThat(model.linearise(0, y, yDot)).isTrue();
    assertThat(model.factor(0.05)).isTrue();
    double[] step = new double[y.length];
    Arrays.fill(step, 1);
    model.solve(step);
    assertThat(step).doesNotContain(Double.NaN);
  }

  private static Mechanism mounted(Mechanism free) {
    Expression[] stiffness = new Expression[36];
    Arrays.fill(stiffness, Expression.ZERO);
    for (int i = 0; i < 6; i++) {
      stiffness[7 * i] = new Expression.Constant(10);
    }
    Bushing mount =
        new Bushing(
            "mount",
            new BodyFrame(BodyPoint.ROOT, Vector3.ZERO, Rotation.IDENTITY),
            new BodyFrame(1, Vector3.ZERO, Rotation.IDENTITY),
            List.of(stiffness),
            Collections.nCopies(36, Expression.ZERO),
            Collections.nCopies(6, Expression.ZERO),
            Bushing.Law.ENERGY,
            Origin.NONE);
    return new Mechanism(
            "mounted",
            free.root(),
            free.gravity(),
            free.bodies(),
            free.joints(),
            free.motions(),
            free.startRoles(),
            List.of(),
            List.of(mount),
            List.of())
        .withArmatures(free.armatures());
  }

  /** Derivatives by difference quotients of the residual itself, of second order. */
  @ParameterizedTest
  @MethodSource("scenes")
  void aSolvedStepRemovesTheResidual(Mechanism mechanism) {
    TreeStepModel model = modelOfScene(mechanism);
    double[] y = RandomMechmlTrees.state(4, mechanism);
    double[] yDot = new double[y.length];
    assertThat(model.derivative(TIME, y, yDot)).isEqualTo(ExplicitModel.REGULAR);
    assertThat(model.linearise(TIME, y, yDot)).isTrue();
    assertThat(model.factor(0.05)).isTrue();
    double[] r = new Random(11).doubles(y.length, -1, 1).toArray();
    double[] d = r.clone();
    model.solve(d);
    double largest = Arrays.stream(d).map(Math::abs).max().orElse(1);
    double step = 1e-6 / Math.max(1, largest);
    double[] above = residualAt(model, y, yDot, d, step);
    double[] below = residualAt(model, y, yDot, d, -step);
    double[] found = new double[r.length];
    for (int i = 0; i < r.length; i++) {
      found[i] = (above[i] - below[i]) / (2 * step);
    }
    // Rounding of residuals of size 1e3 over the step, and its square times third derivatives.
    assertClose(found, r, 1e-3);
  }

  private static double[] residualAt(
      TreeStepModel model, double[] y, double[] yDot, double[] d, double step) {
    double[] moved = y.clone();
    double[] rate = yDot.clone();
    for (int i = 0; i < y.length; i++) {
      moved[i] += step * 0.05 * d[i];
      rate[i] += step * d[i];
    }
    double[] residual = new double[y.length];
    model.residual(TIME, moved, rate, residual);
    return residual;
  }

  @Test
  void theClassFileHasTheBitsOfTheCompiledSourceAndOfTheEquations() {
    for (int seed = 3; seed <= 7; seed++) {
      Mechanism mechanism = scene(seed).getPayload();
      MechmlModel file = Scenes.model(mechanism);
      GeneratedModel generated = ModelFactory.generate(file, OPTIONS);
      ResidualDerivatives.Derived derived = ResidualDerivatives.derive(Links.of(mechanism));
      double[] y = RandomMechmlTrees.state(seed, mechanism);
      double[] direct =
          derivatives(ModelFactory.compile(file, OPTIONS, generated).newInstance(), y);
      assertThat(direct)
          .containsExactly(
              derivatives(ModelFactory.compileSource(file, OPTIONS, generated).newInstance(), y));
      double[] expected = new double[direct.length];
      double[] inputs = Arrays.copyOf(y, 2 * y.length);
      System.arraycopy(rates(y), 0, inputs, y.length, y.length);
      derived.program().evaluate(TIME, inputs, expected);
      assertThat(direct).containsExactly(expected);
    }
  }

  private static double[] rates(double[] y) {
    return new Random(1).doubles(y.length, -1, 1).toArray();
  }

  private static double[] derivatives(Object model, double[] y) {
    double[] values = new double[20 * y.length * y.length];
    ((TreeStepModel) ModelParts.of((Model) model).equations())
        .derivatives(TIME, y, rates(y), values);
    return values;
  }

  @Test
  void theDriverHasShortMethodsAndAStepAllocatesNothing() {
    Mechanism driver = Scenes.timingModel("driver41").mechanism();
    GeneratedModel generated = ModelFactory.generate(Scenes.model(driver), OPTIONS);
    byte[] file = Objects.requireNonNull(generated.classFiles().get(generated.className()));
    assertThat(MethodSizes.longest(file)).isLessThan(8000);
    LinearisedModel model = model(driver);
    double[] y = RandomMechmlTrees.state(2, driver);
    double[] yDot = new double[y.length];
    double[] r = rates(y);
    ThreadMXBean thread = (ThreadMXBean) ManagementFactory.getThreadMXBean();
    long least = Long.MAX_VALUE;
    // The virtual machine itself may allocate while it compiles: the least of several counts.
    for (int round = 0; round < 5; round++) {
      long before = thread.getCurrentThreadAllocatedBytes();
      for (int i = 0; i < 20; i++) {
        model.linearise(TIME, y, yDot);
        model.factor(1e-3);
        model.solve(r);
      }
      least = Math.min(least, thread.getCurrentThreadAllocatedBytes() - before);
    }
    assertThat(least).isZero();
  }
}
