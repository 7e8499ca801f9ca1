package org.mechservice.solver.force;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.mechservice.solver.api.capability.ExplicitModel;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.dynamics.DataDrivenModel;
import org.mechservice.solver.force.RandomForces.Kind;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.RandomTrees;
import org.mechservice.solver.oracle.GlobalFormulation;

/**
 * Trees under forces between bodies, by the recursion with the laws of the catalogue and by Newton
 * and Euler for every body with the laws written down a second time.
 */
class ForcesInMaximalCoordinatesTest {
  private static final double TIME = 0.3;
  private static final RunSettings SETTINGS = new RunSettings(0, 1, 0.1, "DE", 1e-6, 1e-8);

  static Stream<Object[]> kindsAndSeeds() {
    return Stream.of(
            Kind.SPRING_BOTH,
            Kind.SPRING_ABOVE,
            Kind.SPRING_BELOW,
            Kind.BUSHING_ENERGY,
            Kind.BUSHING_LINEAR,
            Kind.CONTACT_PLANE,
            Kind.LAW)
        .flatMap(kind -> IntStream.rangeClosed(1, 30).mapToObj(seed -> new Object[] {kind, seed}));
  }

  /**
   * Bound 1e-9 of the largest acceleration: rounding times the condition of the mass matrix, below
   * 1e5 for these trees, and some digits that rotation vectors lose by their arc cosine.
   */
  @MethodSource("kindsAndSeeds")
  @ParameterizedTest
  void accelerationsAreThoseOfNewtonAndEuler(Kind kind, int seed) {
    Mechanism bare = RandomTrees.ofAllJoints(11L * seed + kind.name().length(), 3 + seed % 5);
    Mechanism forced = new RandomForces(seed, bare).with(kind);
    ForcedTree tree = new ForcedTree(forced, seed);
    double[] y = Arrays.copyOf(tree.q, tree.q.length + tree.v.length);
    System.arraycopy(tree.v, 0, y, tree.q.length, tree.v.length);
    double[] yDot = new double[y.length];
    DataDrivenModel model = new DataDrivenModel(forced, SETTINGS);
    assertThat(model.derivative(TIME, y, yDot)).isEqualTo(ExplicitModel.REGULAR);
    double[] expected =
        new GlobalFormulation(forced, ForceOracle.of(List.copyOf(forced.forces())))
            .accelerations(TIME, tree.q, tree.v);
    double largest = Arrays.stream(expected).map(Math::abs).max().orElse(0);
    for (int i = 0; i < expected.length; i++) {
      assertThat(yDot[tree.q.length + i])
          .as("acceleration %d", i)
          .isCloseTo(expected[i], within(1e-9 * (1 + largest)));
    }
  }
}
