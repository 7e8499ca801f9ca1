package org.mechservice.sim.equations;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.Random;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.sim.model.Scenes;
import org.mechservice.solver.api.capability.ExplicitModel;
import org.mechservice.solver.dynamics.DataDrivenModel;
import org.mechservice.solver.dynamics.RecursiveResidualModel;
import org.mechservice.solver.force.user.UserForceSource;
import org.mechservice.solver.links.Links;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.RandomTrees;

/** The printed steps of recursions and a mechanism's own program have the same bits. */
class StepBitsTest {
  /** Trees of each set: 500 in all. */
  private static final int TREES = 100;

  @ParameterizedTest
  @ValueSource(ints = {1, 2, 4, 7, 12})
  void accelerationsAndResidualsOfRandomTrees(int bodies) {
    int moved = 0;
    for (int seed = 0; seed < TREES; seed++) {
      Mechanism tree = RandomTrees.ofAllJoints(100L * bodies + seed, bodies);
      moved += assertSameBits(tree, new Random(seed));
    }
    assertThat(moved).isGreaterThan(TREES);
  }

  /** Equations of large trees keep zeros and ones of links that few others have. */
  @ParameterizedTest
  @ValueSource(ints = {101, 150})
  void accelerationsAndResidualsOfLargeTrees(int bodies) {
    for (int seed = 1; seed <= 2; seed++) {
      assertSameBits(RandomTrees.ofAllJoints(seed, bodies), new Random(seed));
      assertSameBits(RandomTrees.tree(seed, bodies), new Random(seed));
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"pend5", "pend5s", "driver41", "chain200"})
  void accelerationsAndResidualsOfTheTimingModels(String name) {
    assertThat(assertSameBits(Scenes.timingModel(name).mechanism(), new Random(1))).isPositive();
  }

  /** Compares at three states; returns the number of velocities. */
  private static int assertSameBits(Mechanism tree, Random random) {
    Links links = Links.of(tree);
    int n = tree.positionCount() + tree.velocityCount();
    DataDrivenModel steps = new DataDrivenModel(tree, Scenes.SETTINGS);
    RecursiveResidualModel residuals =
        new RecursiveResidualModel(tree, Scenes.SETTINGS, UserForceSource.NONE);
    double[] state = new double[2 * n];
    tree.initialState(state);
    for (int trial = 0; trial < 3; trial++) {
      for (int i = 0; i < 2 * n; i++) {
        state[i] += 0.3 * random.nextGaussian();
      }
      double[] y = Arrays.copyOf(state, n);
      double[] yDot = Arrays.copyOfRange(state, n, 2 * n);
      double[] expected = new double[n];
      double[] actual = new double[n];
      assertThat(ArticulatedBodyEquations.derive(links).evaluate(y, expected)).isEqualTo(-1);
      assertThat(steps.derivative(0, y, actual)).isEqualTo(ExplicitModel.REGULAR);
      assertSame(tree.name() + " accelerations", actual, expected);
      assertThat(RecursiveResidualEquations.derive(links).evaluate(state, expected)).isEqualTo(-1);
      residuals.residual(0, y, yDot, actual);
      assertSame(tree.name() + " residual", actual, expected);
    }
    return tree.velocityCount();
  }

  /** A sum of zeros may have either sign. */
  private static void assertSame(String what, double[] actual, double[] expected) {
    for (int i = 0; i < actual.length; i++) {
      assertThat(Double.doubleToLongBits(actual[i] + 0.0))
          .as("%s, number %d: %s and %s", what, i, actual[i], expected[i])
          .isEqualTo(Double.doubleToLongBits(expected[i] + 0.0));
    }
  }
}
