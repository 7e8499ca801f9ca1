package org.mechservice.solver.force;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.mechservice.solver.force.RandomForces.Kind;
import org.mechservice.solver.force.applied.NoJacobian;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.RandomTrees;
import org.mechservice.solver.mechanism.force.Bushing;
import org.mechservice.solver.mechanism.force.Contact;
import org.mechservice.solver.mechanism.force.ForceElement;
import org.mechservice.solver.mechanism.force.SpringDamper;

/** What holds for every force, on seeded trees of all joints. */
class ForceLawsTest {
  private static final double TIME = 0.3;

  static Stream<Object[]> kindsAndSeeds() {
    return Stream.of(Kind.values())
        .flatMap(kind -> IntStream.range(1, 9).mapToObj(seed -> new Object[] {kind, seed}));
  }

  private static ForcedTree tree(Kind kind, long seed) {
    Mechanism bare = RandomTrees.ofAllJoints(7 * seed + kind.name().length(), 3 + (int) seed % 4);
    return new ForcedTree(new RandomForces(seed, bare).with(kind), seed);
  }

  /**
   * Bound 1e-9 of the largest entry: Richardson differences of second order with step 1e-3 leave
   * 1e-11, user forces without derivatives are themselves differences, good to 1e-8.
   */
  @MethodSource("kindsAndSeeds")
  @ParameterizedTest
  void jacobianIsTheDifferenceOfForces(Kind kind, long seed) {
    ForcedTree tree = tree(kind, seed);
    double bound = kind == Kind.USER_WITH_DIFFERENCES ? 1e-7 : 1e-9;
    tree.evaluate(TIME);
    for (int k = 0; k < tree.geometry.stateVelocityCount; k++) {
      for (boolean ofVelocity : new boolean[] {false, true}) {
        double[] difference = tree.forceDifference(TIME, k, ofVelocity);
        double[] change = tree.forceChange(TIME, k, ofVelocity);
        double scale = 1 + largest(difference);
        for (int i = 0; i < change.length; i++) {
          assertThat(change[i])
              .as("component %d by %s %d", i, ofVelocity ? "velocity" : "position", k)
              .isCloseTo(difference[i], within(bound * scale));
        }
      }
    }
  }

  /** The rate of the potential energy along the motion is a difference, exact to about 1e-10. */
  @MethodSource("kindsAndSeeds")
  @ParameterizedTest
  void workOfForcesIsLostEnergyAndPower(Kind kind, long seed) {
    ForcedTree tree = tree(kind, seed);
    double[] forces = tree.evaluate(TIME);
    double power = tree.forces.power();
    double work = tree.workRate(forces);
    double energyRate = tree.potentialEnergyRate(TIME);
    assertThat(power - energyRate)
        .isCloseTo(work, within(1e-9 * (1 + Math.abs(work) + Math.abs(energyRate))));
  }

  /** Entries of the Jacobian lie where the couplings say, or on the way to the root of one link. */
  @MethodSource("kindsAndSeeds")
  @ParameterizedTest
  void couplingsNameAllPairsOfTheJacobian(Kind kind, long seed) {
    ForcedTree tree = tree(kind, seed);
    tree.evaluate(TIME);
    DenseForceJacobian jacobian = tree.jacobian(TIME);
    int links = tree.geometry.linkCount;
    boolean[][] named = new boolean[links][links];
    tree.forces.couplings((on, by) -> named[on][by] = true);
    for (int on = 0; on < links; on++) {
      for (int by = 0; by < links; by++) {
        assertThat(!jacobian.couples(on, by) || on == by || named[on][by])
            .as("link %d by link %d", on, by)
            .isTrue();
      }
    }
  }

  @Test
  void evaluationAllocatesNothing() {
    Mechanism bare = RandomTrees.ofAllJoints(5, 6);
    ForcedTree tree = new ForcedTree(new RandomForces(5, bare).withAll(), 5);
    double[] wrench = new double[6 * tree.geometry.linkCount];
    double[] tau = new double[tree.geometry.velocityCount];
    double[] values = new double[tree.forces.columns().size()];
    ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
    tree.evaluate(TIME);
    long least = Long.MAX_VALUE;
    for (int round = 0; round < 30; round++) {
      long before = threads.getCurrentThreadAllocatedBytes();
      for (int i = 0; i < 20; i++) {
        tree.forces.apply(TIME, wrench, tau);
        tree.forces.potentialEnergy();
        tree.forces.power();
        tree.forces.values(values, 0);
      }
      least = Math.min(least, threads.getCurrentThreadAllocatedBytes() - before);
    }
    assertThat(least).isZero();
  }

  @Test
  void derivativesAllocateNothing() {
    Mechanism bare = RandomTrees.ofAllJoints(5, 6);
    RandomForces random = new RandomForces(5, bare);
    Mechanism withAll = random.withAll();
    // the class of the test that gives derivatives allocates its blocks
    ForcedTree tree =
        new ForcedTree(
            random.with(
                withAll.forces().stream()
                    .filter(force -> !force.name().equals(Kind.USER_WITH_DERIVATIVES.name()))
                    .toList()),
            5);
    ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
    tree.evaluate(TIME);
    long least = Long.MAX_VALUE;
    for (int round = 0; round < 30; round++) {
      long before = threads.getCurrentThreadAllocatedBytes();
      for (int i = 0; i < 20; i++) {
        tree.forces.linearise(TIME, NoJacobian.INSTANCE);
      }
      least = Math.min(least, threads.getCurrentThreadAllocatedBytes() - before);
    }
    assertThat(least).isZero();
  }

  @Test
  void sameStateGivesTheSameBits() {
    Mechanism bare = RandomTrees.ofAllJoints(6, 6);
    Mechanism forced = new RandomForces(6, bare).withAll();
    ForcedTree first = new ForcedTree(forced, 6);
    ForcedTree second = new ForcedTree(forced, 6);
    second.evaluate(TIME + 1);
    second.jacobian(TIME + 1);
    assertThat(second.evaluate(TIME)).containsExactly(first.evaluate(TIME));
  }

  private static double largest(double[] x) {
    double largest = 0;
    for (double value : x) {
      largest = Math.max(largest, Math.abs(value));
    }
    return largest;
  }

  /** Forces between moving bodies leave the total momentum and angular momentum alone. */
  @MethodSource("kindsAndSeeds")
  @ParameterizedTest
  void forcesBetweenBodiesAddUpToNothing(Kind kind, long seed) {
    Mechanism bare = RandomTrees.ofAllJoints(7 * seed + kind.name().length(), 5);
    RandomForces random = new RandomForces(seed, bare);
    List<ForceElement> internal =
        random.with(kind).forces().stream().filter(ForceLawsTest::joinsMovingBodies).toList();
    ForcedTree tree = new ForcedTree(random.with(internal), seed);
    double[] forces = tree.evaluate(TIME);
    double[] total = tree.totalInRoot(forces);
    // rounding of sums over a few links with arms of some metres
    double bound = 1e-13 * (1 + largest(forces)) * (1 + tree.geometry.linkCount);
    assertThat(largest(total)).isLessThan(bound);
  }

  private static boolean joinsMovingBodies(ForceElement force) {
    if (force instanceof SpringDamper spring) {
      return spring.point1().body() >= 0 && spring.point2().body() >= 0;
    } else if (force instanceof Bushing bushing) {
      return bushing.frame1().body() >= 0 && bushing.frame2().body() >= 0;
    } else if (force instanceof Contact contact) {
      return contact.center().body() >= 0 && contact.surface().body() >= 0;
    }
    return false;
  }
}
