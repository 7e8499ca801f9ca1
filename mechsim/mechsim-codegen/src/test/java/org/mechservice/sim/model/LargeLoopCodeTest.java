package org.mechservice.sim.model;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Named;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.mechservice.solver.api.capability.BodyPoses;
import org.mechservice.solver.api.capability.ExplicitModel;
import org.mechservice.solver.closure.ClosedMechanism;
import org.mechservice.solver.closure.ClosedTree;
import org.mechservice.solver.closure.equations.LoopTerms;
import org.mechservice.solver.closure.model.ProjectionModel;
import org.mechservice.solver.expression.BodyPoint;
import org.mechservice.solver.force.user.UserForceSource;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.closure.LoopClosure;
import org.mechservice.solver.mechanism.closure.PointOnPlaneClosure;
import org.mechservice.solver.spatial.Vector3;
import org.mechservice.solver.text.Origin;

/** Code for large mechanisms with few loops, against recursions over the data. */
@Tag("slow")
class LargeLoopCodeTest {
  private static final int BODIES = 70;
  private static final List<Named<Mechanism>> MECHANISMS = drawn();

  /**
   * Trees of random joints with a closure of each kind; the first seeds for which there is code.
   */
  static Stream<Named<Mechanism>> mechanisms() {
    return MECHANISMS.stream();
  }

  private static List<Named<Mechanism>> drawn() {
    return Stream.of(
            RandomMechmlLoops.Kind.CUT,
            RandomMechmlLoops.Kind.ROD,
            RandomMechmlLoops.Kind.PLANE,
            RandomMechmlLoops.Kind.LINE)
        .flatMap(
            kind ->
                IntStream.range(1, 40)
                    .mapToObj(seed -> Named.of(kind + " seed " + seed, loops(kind, seed)))
                    .filter(scene -> isCode(scene.getPayload()))
                    .limit(1))
        .toList();
  }

  private static Mechanism loops(RandomMechmlLoops.Kind kind, int seed) {
    Mechanism tree =
        seed % 2 == 0
            ? RandomMechmlTrees.driven(seed, BODIES)
            : RandomMechmlTrees.ofAllJoints(seed, BODIES);
    Mechanism forced = seed % 4 < 2 ? RandomMechmlForces.on(tree, seed) : tree;
    return RandomMechmlLoops.closedBy(kind, forced, seed);
  }

  private static boolean isCode(Mechanism mechanism) {
    return LoopAgreement.closes(mechanism) && reason(mechanism).endsWith("asked for");
  }

  private static String reason(Mechanism mechanism) {
    return ModelFactory.generate(
            Scenes.model(mechanism), LoopAgreement.options("DSR", "projection", false))
        .formulationReason();
  }

  @ParameterizedTest
  @MethodSource("mechanisms")
  void completedStatesAndAccelerationsAreThoseOfTheData(Mechanism mechanism) {
    ProjectionModel code =
        LoopAgreement.code(mechanism, "DSR", "projection", ProjectionModel.class);
    ProjectionModel data =
        LoopAgreement.data(mechanism, "DSR", "projection", ProjectionModel.class);
    double[] y = new double[data.description().stateCount()];
    data.initialState(y);
    Random random = new Random(5);
    for (int i = 0; i < y.length; i++) {
      y[i] += data.independent(i) ? 1e-5 * random.nextGaussian() : 0;
    }
    double[] byCode = y.clone();
    assertThat(data.complete(0.01, y)).isTrue();
    assertThat(code.complete(0.01, byCode)).isTrue();
    // Newton's method ends at rounding in both, times the condition of the dependent coordinates.
    assertThat(byCode).containsExactly(y, within(1e-9));
    double[] expected = new double[y.length];
    double[] actual = new double[y.length];
    assertThat(data.derivative(0.01, y, expected)).isEqualTo(ExplicitModel.REGULAR);
    assertThat(code.derivative(0.01, y, actual)).isEqualTo(ExplicitModel.REGULAR);
    double size = 1;
    for (double rate : expected) {
      size = Math.max(size, Math.abs(rate));
    }
    assertThat(actual).containsExactly(expected, within(LoopAgreement.PROJECTION * size));
    assertThat(code.work.accelerations(0.01, y, actual, 0)).isTrue();
  }

  @Test
  void otherPlacementsInBetweenDoNotChangeTheAccelerations() {
    Mechanism mechanism = mechanisms().findFirst().orElseThrow().getPayload();
    ProjectionModel model =
        LoopAgreement.code(mechanism, "DSR", "projection", ProjectionModel.class);
    double[] y = new double[model.description().stateCount()];
    model.initialState(y);
    assertThat(model.complete(0, y)).isTrue();
    double[] rates = new double[y.length];
    model.derivative(0, y, rates);
    double[] moved = y.clone();
    moved[0] += 0.1;
    model.poses(0, moved, new double[BodyPoses.NUMBERS_PER_BODY * mechanism.bodies().size()]);
    model.work.power(0, moved, new double[2]);
    double[] again = new double[y.length];
    model.derivative(0, y, again);
    assertThat(again).containsExactly(rates);
  }

  @Test
  void theDataEvaluateWhatTheCodeHasNoValueFor() {
    Mechanism mechanism = mechanisms().findFirst().orElseThrow().getPayload();
    ClosedMechanism closed = new ClosedMechanism(mechanism, "DSR", Scenes.SETTINGS);
    ProjectionModel data = new ProjectionModel(closed, UserForceSource.NONE);
    ProjectionModel refused =
        new ProjectionModel(closed.evaluatedBy(new WithoutValues(closed)), UserForceSource.NONE);
    double[] y = new double[data.description().stateCount()];
    data.initialState(y);
    double[] expected = new double[y.length];
    double[] actual = new double[y.length];
    data.derivative(0, y, expected);
    refused.derivative(0, y, actual);
    assertThat(actual).containsExactly(expected);
  }

  /** Code of the loops alone. */
  private static final class WithoutValues implements LoopTerms.Recursive {
    private final ClosedTree data;

    WithoutValues(ClosedMechanism closed) {
      data = closed.newEquations(UserForceSource.NONE);
    }

    @Override
    public void loops(double t, double[] y, double[] terms) {
      data.placeData(t, y);
      int m = data.loops.count();
      double[] elements = data.loops.jacobian.value;
      System.arraycopy(data.loops.value, 0, terms, 0, m);
      System.arraycopy(data.loops.rate, 0, terms, m, m);
      System.arraycopy(elements, 0, terms, LoopTerms.Recursive.elementAt(m), elements.length);
    }

    @Override
    public int equations(double t, double[] y, double[] accelerations) {
      return 0;
    }

    @Override
    public void energy(double t, double[] y, double[] energy) {}

    @Override
    public void power(double t, double[] y, double[] power) {}
  }

  @Test
  void otherMethodsAndDependentEquationsHaveTheirReasons() {
    Mechanism mechanism = mechanisms().findFirst().orElseThrow().getPayload();
    assertThat(
            ModelFactory.generate(
                    Scenes.model(mechanism), LoopAgreement.options("DSR", "penalty", false))
                .formulationReason())
        .contains("by another method than DSR with projection");
    assertThat(reason(twice(mechanism))).contains("of whose equations some follow from the others");
  }

  /** Adds a plane through a point of the root that is always in it. */
  private static Mechanism twice(Mechanism mechanism) {
    BodyPoint point = new BodyPoint(BodyPoint.ROOT, Vector3.ZERO);
    List<LoopClosure> closures = new ArrayList<>(mechanism.closures());
    closures.add(
        new PointOnPlaneClosure("always", point, point, new Vector3(0, 0, 1), Origin.NONE));
    return new Mechanism(
            mechanism.name(),
            mechanism.root(),
            mechanism.gravity(),
            mechanism.bodies(),
            mechanism.joints(),
            mechanism.motions(),
            mechanism.startRoles(),
            closures,
            mechanism.forces(),
            mechanism.parameters())
        .withArmatures(mechanism.armatures());
  }
}
