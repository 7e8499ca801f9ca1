package org.mechservice.solver.dynamics;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.solver.api.capability.BodyPoses;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.mechanism.FiveBarPendulum;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.RandomTrees;

class DataDrivenModelTest {
  private static final RunSettings SETTINGS = new RunSettings(0, 1, 0.1, "DE", 1e-6, 1e-6);

  /** States of a 128-bit reference solution: t, q, v, a, kinetic and potential energy. */
  static List<double[]> referenceStates() {
    return PublishedChain.lines("pendulum5.states.csv").stream()
        .skip(1)
        .map(line -> Arrays.stream(line.split(",", -1)).mapToDouble(Double::parseDouble).toArray())
        .toList();
  }

  /** Accelerations are given to 15 digits; 1e-11 is the bound every formulation must meet. */
  @MethodSource("referenceStates")
  @ParameterizedTest
  void acceleratesThePendulumAsTheReferenceDoes(double[] reference) {
    DataDrivenModel model = new DataDrivenModel(FiveBarPendulum.mechanism(), SETTINGS);
    double[] yDot = new double[10];
    model.derivative(reference[0], Arrays.copyOfRange(reference, 1, 11), yDot);
    for (int i = 0; i < 5; i++) {
      double expected = reference[11 + i];
      assertThat(yDot[5 + i]).isCloseTo(expected, within(1e-11 * Math.max(1, Math.abs(expected))));
    }
  }

  /** Energies of up to 120 J, evaluated from states rounded to double. */
  @MethodSource("referenceStates")
  @ParameterizedTest
  void energiesAreThoseOfTheReference(double[] reference) {
    DataDrivenModel model = new DataDrivenModel(FiveBarPendulum.mechanism(), SETTINGS);
    double[] energy = new double[2];
    model.energy(reference[0], Arrays.copyOfRange(reference, 1, 11), energy);
    assertThat(energy[0]).isCloseTo(reference[16], within(1e-12));
    assertThat(energy[1]).isCloseTo(reference[17], within(1e-12));
  }

  /** Differences of positions with Richardson's correction are exact to about 1e-9 at this size. */
  @ValueSource(longs = {1, 2, 3, 4, 5, 6})
  @ParameterizedTest
  void velocitiesOfTheBodiesAreTheRatesOfTheirPoses(long seed) {
    Mechanism tree = RandomTrees.tree(seed, 6);
    DataDrivenModel model = new DataDrivenModel(tree, SETTINGS);
    double[] y = new double[2 * tree.velocityCount()];
    model.initialState(y);
    double[] now = poses(model, y);
    double[] coarse = rates(model, y, 2e-3);
    double[] fine = rates(model, y, 1e-3);
    for (int body = 0; body < tree.bodies().size(); body++) {
      int at = body * BodyPoses.NUMBERS_PER_BODY;
      double[] rate = new double[7];
      for (int i = 0; i < 7; i++) {
        rate[i] = fine[at + i] + (fine[at + i] - coarse[at + i]) / 3;
      }
      for (int i = 0; i < 3; i++) {
        assertThat(now[at + 7 + i]).isCloseTo(rate[i], within(1e-8));
        assertThat(now[at + 10 + i])
            .isCloseTo(worldAngularVelocity(now, at + 3, rate, i), within(1e-8));
      }
    }
  }

  @Test
  void poseOfABodyAtRestIsThatOfTheFile() {
    double[] y = new double[10];
    DataDrivenModel model = new DataDrivenModel(FiveBarPendulum.mechanism(), SETTINGS);
    double[] third = Arrays.copyOfRange(poses(model, y), 26, 39);
    assertThat(third).containsExactly(2, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0);
  }

  private static double[] poses(DataDrivenModel model, double[] y) {
    double[] poses = new double[model.bodies().size() * BodyPoses.NUMBERS_PER_BODY];
    model.poses(0, y, poses);
    return poses;
  }

  private static double[] rates(DataDrivenModel model, double[] y, double h) {
    int n = y.length / 2;
    double[] ahead = y.clone();
    double[] behind = y.clone();
    for (int i = 0; i < n; i++) {
      ahead[i] += h * y[n + i];
      behind[i] -= h * y[n + i];
    }
    double[] rates = poses(model, ahead);
    double[] back = poses(model, behind);
    for (int i = 0; i < rates.length; i++) {
      rates[i] = (rates[i] - back[i]) / (2 * h);
    }
    return rates;
  }

  /** ω = 2 (−e0' e + e0 e' + e × e'), component i, with e the vector part (world axes). */
  private static double worldAngularVelocity(double[] pose, int e, double[] rate, int i) {
    int j = (i + 1) % 3;
    int k = (i + 2) % 3;
    double e0 = pose[e];
    double e0Rate = rate[3];
    return 2
        * (e0 * rate[4 + i]
            - e0Rate * pose[e + 1 + i]
            + pose[e + 1 + j] * rate[4 + k]
            - pose[e + 1 + k] * rate[4 + j]);
  }
}
