package org.mechservice.solver.dynamics;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.mechservice.solver.dynamics.Evaluation.largest;
import static org.mechservice.solver.dynamics.Evaluation.norm;

import java.util.Random;
import java.util.stream.LongStream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.RandomTrees;
import org.mechservice.solver.spatial.Vector3;

/** Laws of mechanics on seeded trees of all nine joints. */
class OpenTreeLawsTest {
  static LongStream seeds() {
    return LongStream.rangeClosed(1, 24);
  }

  private static Mechanism tree(long seed) {
    return RandomTrees.ofAllJoints(seed, 1 + (int) (7 * seed % 20));
  }

  /** Half of the trees with rods, which only some formulations take. */
  private static Mechanism treeWithRods(long seed) {
    return RandomTrees.withRods(seed, 1 + (int) (7 * seed % 20), (int) (seed % 4));
  }

  /** Sums over up to 20 bodies, of terms no larger than the largest force. */
  @MethodSource("seeds")
  @ParameterizedTest
  void massMatrixTimesAccelerationAndBiasIsTheInverseDynamics(long seed) {
    Evaluation at = new Evaluation(treeWithRods(seed)).loaded(seed);
    SemiRecursive w = at.semiRecursive();
    double[] a = new Random(seed).doubles(at.nv, -5, 5).toArray();
    double[] force = new double[at.nv];
    w.massMatrix().multiply(a, 0, force, 0);
    double[] expected = at.residual(a);
    double scale = 1 + largest(force) + largest(w.bias());
    for (int i = 0; i < at.nv; i++) {
      assertThat(force[i] + w.bias()[i]).isCloseTo(expected[i], within(1e-13 * scale));
    }
  }

  @MethodSource("seeds")
  @ParameterizedTest
  void kineticEnergyIsHalfOfVMv(long seed) {
    Evaluation at = new Evaluation(treeWithRods(seed));
    double[] momentum = new double[at.nv];
    at.semiRecursive().massMatrix().multiply(at.y, at.nq, momentum, 0);
    double twice = 0;
    for (int i = 0; i < at.nv; i++) {
      twice += at.y[at.nq + i] * momentum[i];
    }
    assertThat(twice / 2).isCloseTo(at.kineticEnergy(), within(1e-13 * (1 + at.kineticEnergy())));
  }

  /** ½ vᵀ M' v = vᵀ b without gravity and forces; M' by differences along the motion. */
  @MethodSource("seeds")
  @ParameterizedTest
  void powerOfTheVelocityForcesIsThatOfTheChangingInertia(long seed) {
    Mechanism tree = treeWithRods(seed);
    Mechanism weightless =
        new Mechanism("weightless", tree.root(), Vector3.ZERO, tree.bodies(), tree.joints());
    Evaluation at = new Evaluation(weightless);
    double[] none = new double[at.nv];
    double power = 0;
    double[] bias = at.residual(none);
    for (int i = 0; i < at.nv; i++) {
      power += at.y[at.nq + i] * bias[i];
    }
    double coarse = energyDifference(at, none, 2e-4);
    double fine = energyDifference(at, none, 1e-4);
    double rate = fine + (fine - coarse) / 3;
    double scale = 1 + at.kineticEnergy() + norm(bias);
    assertThat(rate).isCloseTo(power, within(1e-7 * scale));
  }

  /** The power of joint forces and wrenches is the rate of the energy along the motion. */
  @MethodSource("seeds")
  @ParameterizedTest
  void powerOfForcesIsTheRateOfEnergy(long seed) {
    Evaluation at = new Evaluation(tree(seed)).loaded(seed);
    double[] a = at.byArticulatedBodies();
    double power = 0;
    for (int k = 0; k < at.nv; k++) {
      power += at.tau[k] * at.y[at.nq + k];
    }
    for (int i = 0; i < at.tree.linkCount; i++) {
      for (int k = 0; k < 3; k++) {
        power += at.wrench[6 * i + k] * at.motion.angularVelocity[3 * i + k];
        power += at.wrench[6 * i + 3 + k] * at.motion.linearVelocity[3 * i + k];
      }
    }
    double scale = 1 + at.kineticEnergy() + Math.abs(at.potentialEnergy()) + largest(a);
    double coarse = totalDifference(at, a, 2e-4);
    double fine = totalDifference(at, a, 1e-4);
    assertThat(fine + (fine - coarse) / 3).isCloseTo(power, within(1e-7 * scale));
  }

  /**
   * Forces between the bodies of a system that touches nothing leave its momentum to gravity: Σ m
   * a_c = Σ m g, and the moment of momentum about the world's origin changes by Σ c × m g.
   */
  @MethodSource("seeds")
  @ParameterizedTest
  void momentumOfAFloatingSystemChangesByItsWeightAlone(long seed) {
    Mechanism floating = RandomTrees.floating(seed, 1 + (int) (7 * seed % 20));
    Evaluation at = new Evaluation(floating);
    double[] internal = new Random(seed).doubles(at.nv, -5, 5).toArray();
    System.arraycopy(internal, 6, at.tau, 6, at.nv - 6);
    at.motion.accelerationSweep(at.byArticulatedBodies());
    MomentumRate rate = new MomentumRate(at.motion);
    for (int i = 0; i < 6; i++) {
      assertThat(rate.ofMotion()[i]).isCloseTo(rate.ofWeight()[i], within(1e-12 * rate.scale()));
    }
  }

  private static double energyDifference(Evaluation at, double[] a, double h) {
    return (kinetic(at, at.along(a, h)) - kinetic(at, at.along(a, -h))) / (2 * h);
  }

  private static double kinetic(Evaluation at, double[] y) {
    Evaluation moved = new Evaluation(at.mechanism);
    moved.motion.sweep(0, y);
    return moved.kineticEnergy();
  }

  private static double totalDifference(Evaluation at, double[] a, double h) {
    return (total(at, at.along(a, h)) - total(at, at.along(a, -h))) / (2 * h);
  }

  private static double total(Evaluation at, double[] y) {
    Evaluation moved = new Evaluation(at.mechanism);
    moved.motion.sweep(0, y);
    return moved.kineticEnergy() + moved.potentialEnergy();
  }

  /** The bounds of docs/theory/formulations.md#agreement. */
  @MethodSource("seeds")
  @ParameterizedTest
  void formulationsAgreeWithEachOtherAndWithMaximalCoordinates(long seed) {
    TreeComparison compared = TreeComparison.of(tree(seed), seed, true);
    compared
        .backward()
        .forEach((name, error) -> assertThat(error).as(name).isLessThan(TreeComparison.BACKWARD));
    compared
        .forward()
        .forEach((name, error) -> assertThat(error).as(name).isLessThan(compared.forwardBound()));
  }
}
