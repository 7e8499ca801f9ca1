package org.mechservice.solver.kinematics.pair;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.solver.api.JointType;
import org.mechservice.solver.kinematics.StateCoordinates;
import org.mechservice.solver.kinematics.TreeGeometry;
import org.mechservice.solver.kinematics.TreeMotion;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.RandomJoints;
import org.mechservice.solver.mechanism.RandomTrees;
import org.mechservice.solver.mechanism.joint.Joint;

class CutJointTest {
  private static final String TYPES = "org.mechservice.solver.mechanism.RandomJoints#typesAndSeeds";
  private static final int BODIES = 7;

  /** Products of some ten rotations, and places of some metres. */
  private static final double ROUNDING = 1e-12;

  private static double[] state(Mechanism mechanism) {
    double[] y = new double[mechanism.positionCount() + mechanism.velocityCount()];
    mechanism.initialState(y);
    return y;
  }

  private static double[] numbers(Random random, int count) {
    return random.doubles(count, -1, 1).toArray();
  }

  @ParameterizedTest
  @ValueSource(ints = {1, 2, 3, 4, 5, 6, 7, 8})
  void jointOfTheTreeForbidsNothingThatItDoes(int seed) {
    Mechanism mechanism = RandomTrees.ofAllJoints(seed, BODIES);
    TreeGeometry tree = new TreeGeometry(mechanism);
    TreeMotion motion = new TreeMotion(tree);
    motion.sweep(0, state(mechanism));
    motion.accelerationSweep(numbers(new Random(seed), mechanism.velocityCount()));
    for (Joint joint : mechanism.joints()) {
      CutJoint cut = new CutJoint(tree, joint);
      RelativeMotion relative = moving(cut, motion);
      assertThat(cut.forbidden()).hasSize(6 - joint.type().velocityCount());
      for (PairFunction function : cut.forbidden()) {
        String name = joint.type() + " " + function.label();
        assertThat(function.evaluate(relative)).as(name).isCloseTo(0, within(ROUNDING));
        assertThat(function.rate(relative)).as(name).isCloseTo(0, within(ROUNDING));
        assertThat(function.acceleration(relative)).as(name).isCloseTo(0, within(ROUNDING));
        double[] row = row(tree, motion, relative, function);
        assertThat(row).as(name).containsExactly(new double[row.length], within(ROUNDING));
      }
    }
  }

  @ParameterizedTest
  @ValueSource(ints = {1, 2, 3, 4, 5, 6, 7, 8})
  void jointOfTheTreeMeasuredAsIfItWereCutHasItsOwnCoordinates(int seed) {
    Mechanism mechanism = RandomTrees.ofAllJoints(seed, BODIES);
    TreeGeometry tree = new TreeGeometry(mechanism);
    TreeMotion motion = new TreeMotion(tree);
    double[] y = state(mechanism);
    double[] a = numbers(new Random(seed), mechanism.velocityCount());
    motion.sweep(0, y);
    motion.accelerationSweep(a);
    for (int j = 0; j < mechanism.joints().size(); j++) {
      Joint joint = mechanism.joints().get(j);
      CutJoint cut = new CutJoint(tree, joint);
      RelativeMotion relative = moving(cut, motion);
      int at = mechanism.velocityOffset(j);
      for (int k = 0; k < joint.type().velocityCount(); k++) {
        PairFunction function = cut.coordinate(k);
        function.evaluate(relative);
        double[] row = row(tree, motion, relative, function);
        double[] unit = new double[row.length];
        unit[at + k] = 1;
        assertThat(row).as(joint.type() + " " + k).containsExactly(unit, within(ROUNDING));
        assertThat(function.acceleration(relative)).isCloseTo(a[at + k], within(ROUNDING));
      }
      assertCoordinates(mechanism, j, cut, motion, y);
    }
  }

  private static void assertCoordinates(
      Mechanism mechanism, int j, CutJoint cut, TreeMotion motion, double[] y) {
    JointType type = mechanism.joints().get(j).type();
    double[] q = new double[type.positionCount()];
    double[] v = new double[type.velocityCount()];
    cut.coordinates(motion, q, 0, v, 0);
    int at = mechanism.positionOffset(j);
    double sign = type.hasEulerParameters() && y[at] < 0 ? -1 : 1;
    for (int k = 0; k < q.length; k++) {
      double expected = (k < 4 ? sign : 1) * y[at + k];
      assertThat(q[k]).as(type + " q" + k).isCloseTo(expected, within(ROUNDING));
    }
    for (int k = 0; k < v.length; k++) {
      double expected = y[mechanism.positionCount() + mechanism.velocityOffset(j) + k];
      assertThat(v[k]).as(type + " v" + k).isCloseTo(expected, within(ROUNDING));
    }
  }

  private static RelativeMotion moving(CutJoint cut, TreeMotion motion) {
    cut.relative().place(motion);
    cut.relative().move(motion);
    cut.relative().accelerate(motion);
    return cut.relative();
  }

  private static double[] row(
      TreeGeometry tree, TreeMotion motion, RelativeMotion relative, PairFunction function) {
    double[] row = new double[tree.velocityCount];
    relative.addRow(motion, function.gradient, 1, row, 0);
    return row;
  }

  /** Between bodies that do not obey it, so every term counts. */
  @MethodSource(TYPES)
  @ParameterizedTest
  void ratesAndAccelerationsAreThoseOfTheValues(JointType type, int seed) {
    Mechanism mechanism = RandomTrees.ofAllJoints(seed, BODIES);
    TreeGeometry tree = new TreeGeometry(mechanism);
    TreeMotion motion = new TreeMotion(tree);
    double[] y = state(mechanism);
    CutJoint cut = new CutJoint(tree, RandomJoints.joint(new Random(seed), type, 2, BODIES - 1));
    List<PairFunction> functions = new ArrayList<>(cut.forbidden());
    functions.add(new Distance(0.7));
    for (int k = 0; k < type.velocityCount(); k++) {
      functions.add(cut.coordinate(k));
    }
    motion.sweep(0, y);
    motion.accelerationSweep(new double[mechanism.velocityCount()]);
    for (PairFunction function : functions) {
      RelativeMotion relative = moving(cut, motion);
      boolean hasValue = !Double.isNaN(function.evaluate(relative));
      double rate = function.rate(relative);
      double acceleration = function.acceleration(relative);
      double[] row = row(tree, motion, relative, function);
      double product = 0;
      for (int k = 0; k < mechanism.velocityCount(); k++) {
        product += row[k] * y[mechanism.positionCount() + k];
      }
      double size = 1 + Math.abs(rate) + Math.abs(acceleration);
      assertThat(product).as(function.label()).isCloseTo(rate, within(ROUNDING * size));
      double[] difference = differences(mechanism, cut, function, y);
      // Richardson's correction leaves about h⁴ = 1e-12, and rounding 1e-15 / h.
      double tolerance = 1e-9 * size * size;
      if (hasValue) {
        assertThat(difference[0]).as(function.label()).isCloseTo(rate, within(tolerance));
      }
      assertThat(difference[1]).as(function.label()).isCloseTo(acceleration, within(tolerance));
      motion.sweep(0, y);
      motion.accelerationSweep(new double[mechanism.velocityCount()]);
    }
  }

  /** Derivatives of value and rate along the motion with constant joint velocities. */
  private static double[] differences(
      Mechanism mechanism, CutJoint cut, PairFunction function, double[] y) {
    double[] coarse = centralDifferences(mechanism, cut, function, y, 2e-3);
    double[] fine = centralDifferences(mechanism, cut, function, y, 1e-3);
    return new double[] {fine[0] + (fine[0] - coarse[0]) / 3, fine[1] + (fine[1] - coarse[1]) / 3};
  }

  private static double[] centralDifferences(
      Mechanism mechanism, CutJoint cut, PairFunction function, double[] y, double h) {
    double[] forward = at(mechanism, cut, function, y, h);
    double[] back = at(mechanism, cut, function, y, -h);
    double difference = forward[0] - back[0];
    double whole =
        function instanceof Turn ? 2 * Math.PI * Math.rint(difference / (2 * Math.PI)) : 0;
    return new double[] {(difference - whole) / (2 * h), (forward[1] - back[1]) / (2 * h)};
  }

  private static double[] at(
      Mechanism mechanism, CutJoint cut, PairFunction function, double[] y, double h) {
    double[] moved = y.clone();
    new StateCoordinates(mechanism).move(moved, 0, y, mechanism.positionCount(), h);
    TreeMotion motion = new TreeMotion(new TreeGeometry(mechanism));
    motion.sweep(0, moved);
    cut.relative().place(motion);
    cut.relative().move(motion);
    return new double[] {function.evaluate(cut.relative()), function.rate(cut.relative())};
  }
}
