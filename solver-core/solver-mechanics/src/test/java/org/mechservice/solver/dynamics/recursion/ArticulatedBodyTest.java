package org.mechservice.solver.dynamics.recursion;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import org.apache.commons.math3.linear.MatrixUtils;
import org.apache.commons.math3.linear.RealMatrix;
import org.apache.commons.math3.linear.SingularValueDecomposition;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.solver.api.JointType;
import org.mechservice.solver.api.capability.Defects;
import org.mechservice.solver.api.capability.ExplicitModel;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.dynamics.DataDrivenModel;
import org.mechservice.solver.dynamics.PublishedChain;
import org.mechservice.solver.dynamics.WorldMotion;
import org.mechservice.solver.kinematics.TreeGeometry;
import org.mechservice.solver.kinematics.TreeMotion;
import org.mechservice.solver.mechanism.Body;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.RandomTrees;
import org.mechservice.solver.mechanism.Root;
import org.mechservice.solver.mechanism.joint.Attachment;
import org.mechservice.solver.mechanism.joint.Joint;
import org.mechservice.solver.mechanism.joint.JointStart;
import org.mechservice.solver.mechanism.joint.Revolute;
import org.mechservice.solver.mechanism.joint.Spherical;
import org.mechservice.solver.spatial.InertiaTensor;
import org.mechservice.solver.spatial.Rotation;
import org.mechservice.solver.spatial.Vector3;
import org.mechservice.solver.text.Origin;

class ArticulatedBodyTest {
  private static final RunSettings SETTINGS = new RunSettings(0, 1, 0.1, "DE", 1e-6, 1e-6);

  /**
   * Bounds: rounding of one recursion times its depth, as measured for body frames (relative 1e-15
   * … 1e-14).
   */
  @CsvSource({"pend5, 1e-14", "pend5s, 1e-14", "driver41, 1e-13", "chain200, 1e-12"})
  @ParameterizedTest
  void agreesWithPinocchio(String name, double bound) {
    PublishedChain chain = PublishedChain.read(name);
    double[] a = accelerations(chain.mechanism(), chain.y(), chain.jointForces());
    double[] expected = chain.expected();
    double largest = largest(expected);
    for (int i = 0; i < a.length; i++) {
      assertThat(a[i]).as("joint %d", i).isCloseTo(expected[i], within(bound * largest));
    }
  }

  /** The mass matrix comes from kinetic energies alone, which know nothing of the recursion. */
  @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20})
  @ParameterizedTest
  void massMatrixTimesAccelerationIsTheJointForce(long seed) {
    Mechanism tree = RandomTrees.tree(seed, 1 + (int) seed % 15);
    double[] y = initialState(tree);
    RealMatrix m = massMatrix(tree, y);
    double[] tau = new Random(seed).doubles(tree.velocityCount(), -5, 5).toArray();
    double[] loaded = accelerations(tree, y, tau);
    double[] free = accelerations(tree, y, new double[tau.length]);
    double[] difference = new double[tau.length];
    for (int i = 0; i < tau.length; i++) {
      difference[i] = loaded[i] - free[i];
    }
    double[] force = m.operate(difference);
    // Polarised energies lose a digit, the solution loses what the condition of M takes.
    double condition = new SingularValueDecomposition(m).getConditionNumber();
    double bound = 100 * Math.ulp(1.0) * condition * Math.max(1, largest(tau));
    for (int i = 0; i < tau.length; i++) {
      assertThat(force[i]).as("joint %d", i).isCloseTo(tau[i], within(bound));
    }
  }

  /**
   * The power of the joint forces is the rate of the energy; the rate is a difference along the
   * motion, exact to about 1e-9.
   */
  @ValueSource(longs = {21, 22, 23, 24, 25, 26, 27, 28, 29, 30, 31, 32, 33, 34, 35, 36})
  @ParameterizedTest
  void powerOfJointForcesIsTheRateOfEnergy(long seed) {
    Mechanism tree = RandomTrees.tree(seed, 1 + (int) seed % 12);
    int n = tree.velocityCount();
    double[] y = initialState(tree);
    double[] tau = new Random(seed).doubles(n, -5, 5).toArray();
    double[] a = accelerations(tree, y, tau);
    double power = 0;
    for (int i = 0; i < n; i++) {
      power += tau[i] * y[n + i];
    }
    double coarse = energyRate(tree, y, a, 2e-4);
    double fine = energyRate(tree, y, a, 1e-4);
    double rate = fine + (fine - coarse) / 3;
    double scale = Math.abs(totalEnergy(tree, y)) + Math.abs(power) + largest(a);
    assertThat(rate).isCloseTo(power, within(1e-8 * scale));
  }

  @Test
  void moreDistantRootLeavesTheBitsAlone() {
    Mechanism near = RandomTrees.tree(40, 9);
    Root moved = new Root("ground", new Vector3(1e6, -1e6, 1e6), near.root().orientation());
    Mechanism far =
        new Mechanism("far", moved, near.gravity(), near.bodies(), near.joints())
            .withArmatures(near.armatures());
    double[] y = initialState(near);
    double[] tau = new double[near.velocityCount()];
    assertThat(accelerations(far, y, tau)).containsExactly(accelerations(near, y, tau));
  }

  @Test
  void reversingAJointTwiceGivesTheSameMotion() {
    Mechanism tree = RandomTrees.tree(41, 8);
    List<Joint> twice = new ArrayList<>();
    for (Joint joint : tree.joints()) {
      twice.add(joint.reversed().reversed());
    }
    Mechanism same =
        new Mechanism("same", tree.root(), tree.gravity(), tree.bodies(), twice)
            .withArmatures(tree.armatures());
    double[] y = initialState(tree);
    double[] tau = new double[tree.velocityCount()];
    double[] expected = accelerations(tree, y, tau);
    double[] a = accelerations(same, y, tau);
    for (int i = 0; i < a.length; i++) {
      assertThat(a[i]).isCloseTo(expected[i], within(1e-12 * largest(expected)));
    }
  }

  @Test
  void masslessEndOfAChainIsNamed() {
    Mechanism chain = chain(Vector3.ZERO, new Body[] {bar("bar"), massless("hand")});
    assertThat(singularJoint(chain)).isEqualTo(1);
  }

  @Test
  void masslessBodyBetweenTwoAxesThatCoincideIsNamed() {
    Mechanism chain = chain(Vector3.ZERO, new Body[] {massless("link"), bar("bar")});
    assertThat(singularJoints(chain)).isEqualTo("joint \"j0\" and joint \"j1\"");
  }

  @Test
  void masslessBodyBetweenTwoParallelAxesIsRegular() {
    Mechanism chain = chain(new Vector3(0.3, 0, 0), new Body[] {massless("link"), bar("bar")});
    assertThat(singularJoint(chain)).isEqualTo(ExplicitModel.REGULAR);
  }

  /**
   * Three turning joints about x, y, x with massless bodies between them; at a middle angle of 0
   * the outer axes coincide.
   */
  @Test
  void gimbalLockIsNamed() {
    assertThat(singularJoints(gimbal(0))).isEqualTo("joint \"j0\" and joint \"j2\"");
    assertThat(singularJoints(gimbal(1e-9))).isEqualTo("joint \"j0\" and joint \"j2\"");
    assertThat(singularJoint(gimbal(1e-3))).isEqualTo(ExplicitModel.REGULAR);
  }

  @Test
  void nearGimbalLockIsNotedWithTheDigitsItCosts() {
    Mechanism near = gimbal(1e-6 / 3);
    double[] y = initialState(near);
    DataDrivenModel model = new DataDrivenModel(near, SETTINGS);
    assertThat(model.derivative(0.25, y, new double[y.length])).isEqualTo(ExplicitModel.REGULAR);
    assertThat(model.notes()).hasSize(1);
    assertThat(model.notes().get(0).message())
        .startsWith("N-008 t=0.25 s: The inertia at joint \"j0\" is nearly singular")
        .contains("about 2 digits");
  }

  /** A point mass on a ball joint: it does not resist turning about the line to the joint. */
  @Test
  void directionThatNothingResistsIsNamed() {
    Attachment attachment = new Attachment(-1, Vector3.ZERO, 0, Vector3.ZERO, Rotation.IDENTITY);
    Body point = new Body("point", 1, new Vector3(0, 0, 1), InertiaTensor.ZERO, Origin.NONE);
    JointStart start = JointStart.atZero(JointType.S);
    Joint ball = new Spherical("ball", attachment, start, false, Origin.NONE);
    Root root = new Root("ground", Vector3.ZERO, Rotation.IDENTITY);
    Mechanism pendulum =
        new Mechanism("m", root, new Vector3(0, 0, -9.81), List.of(point), List.of(ball));
    assertThat(singularJoints(pendulum)).isEqualTo("joint \"ball\", velocity ball.v[2]");
  }

  private static String singularJoints(Mechanism mechanism) {
    double[] y = initialState(mechanism);
    DataDrivenModel model = new DataDrivenModel(mechanism, SETTINGS);
    assertThat(model.derivative(0, y, new double[y.length])).isEqualTo(Defects.DEFECT);
    return model.lastDefect().part();
  }

  private static Mechanism gimbal(double middle) {
    Vector3[] axes = {new Vector3(1, 0, 0), new Vector3(0, 1, 0), new Vector3(1, 0, 0)};
    Body[] bodies = {massless("outer"), massless("inner"), bar("rotor")};
    double[] q = {0.7, middle, -0.4};
    List<Joint> joints = new ArrayList<>();
    for (int i = 0; i < 3; i++) {
      Attachment attachment =
          new Attachment(i - 1, Vector3.ZERO, i, Vector3.ZERO, Rotation.IDENTITY);
      joints.add(new Revolute("j" + i, attachment, axes[i], q[i], 0, Origin.NONE));
    }
    Root root = new Root("ground", Vector3.ZERO, Rotation.IDENTITY);
    return new Mechanism("gimbal", root, new Vector3(0, 0, -9.81), List.of(bodies), joints);
  }

  @Test
  void evaluationAllocatesNothing() {
    Mechanism tree = RandomTrees.tree(50, 20);
    DataDrivenModel model = new DataDrivenModel(tree, SETTINGS);
    double[] y = initialState(tree);
    double[] yDot = new double[y.length];
    ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
    long thread = Thread.currentThread().getId();
    for (int i = 0; i < 1000; i++) {
      model.derivative(0, y, yDot);
    }
    long before = threads.getThreadAllocatedBytes(thread);
    for (int i = 0; i < 1000; i++) {
      model.derivative(0, y, yDot);
    }
    // The measurement itself may allocate a little; one object per evaluation would be 16 000
    // bytes.
    assertThat(threads.getThreadAllocatedBytes(thread) - before).isLessThan(1000);
  }

  /** Two bodies on turning joints about y; the second hangs at {@code offset} on the first. */
  private static Mechanism chain(Vector3 offset, Body[] bodies) {
    List<Joint> joints = new ArrayList<>();
    for (int i = 0; i < bodies.length; i++) {
      Attachment attachment =
          new Attachment(i - 1, i == 0 ? Vector3.ZERO : offset, i, Vector3.ZERO, Rotation.IDENTITY);
      joints.add(new Revolute("j" + i, attachment, new Vector3(0, 1, 0), 0.3, 0, Origin.NONE));
    }
    Root root = new Root("ground", Vector3.ZERO, Rotation.IDENTITY);
    return new Mechanism("chain", root, new Vector3(0, 0, -9.81), List.of(bodies), joints);
  }

  private static Body bar(String name) {
    return new Body(
        name, 1, new Vector3(0.5, 0, 0), new InertiaTensor(0.02, 0.1, 0.1, 0, 0, 0), Origin.NONE);
  }

  private static Body massless(String name) {
    return new Body(name, 0, Vector3.ZERO, InertiaTensor.ZERO, Origin.NONE);
  }

  private static int singularJoint(Mechanism mechanism) {
    double[] y = initialState(mechanism);
    return new DataDrivenModel(mechanism, SETTINGS).derivative(0, y, new double[y.length]);
  }

  private static double[] initialState(Mechanism mechanism) {
    double[] y = new double[mechanism.positionCount() + mechanism.velocityCount()];
    mechanism.initialState(y);
    return y;
  }

  private static double[] accelerations(Mechanism mechanism, double[] y, double[] tau) {
    TreeMotion motion = new TreeMotion(new TreeGeometry(mechanism));
    motion.sweepRelative(0, y);
    double[] noWrenches = {};
    double[] byBodies = new double[tau.length];
    ArticulatedBody bodies = new ArticulatedBody(motion.tree());
    assertThat(bodies.accelerations(bodies.newWorkspace(motion), noWrenches, tau, byBodies, 0))
        .isEqualTo(ExplicitModel.REGULAR);
    double[] a = new double[tau.length];
    assertThat(new TreeSteps(motion).accelerations(noWrenches, tau, a, 0))
        .isEqualTo(ExplicitModel.REGULAR);
    double size = 1 + Arrays.stream(a).map(Math::abs).max().orElse(0);
    for (int i = 0; i < a.length; i++) {
      assertThat(a[i]).isCloseTo(byBodies[i], within(1e-12 * size));
    }
    return a;
  }

  /** M_ij = T(e_i + e_j) − T(e_i) − T(e_j), M_ii = 2 T(e_i), with T quadratic in v. */
  private static RealMatrix massMatrix(Mechanism mechanism, double[] y) {
    int n = mechanism.velocityCount();
    RealMatrix m = MatrixUtils.createRealMatrix(n, n);
    for (int i = 0; i < n; i++) {
      for (int j = 0; j <= i; j++) {
        double[] v = new double[n];
        v[i] += 1;
        v[j] += 1;
        double both = kineticEnergy(mechanism, y, v);
        double[] ei = new double[n];
        ei[i] = 1;
        double[] ej = new double[n];
        ej[j] = 1;
        double mij =
            i == j
                ? both / 2
                : both - kineticEnergy(mechanism, y, ei) - kineticEnergy(mechanism, y, ej);
        m.setEntry(i, j, mij);
        m.setEntry(j, i, mij);
      }
    }
    return m;
  }

  private static double kineticEnergy(Mechanism mechanism, double[] y, double[] v) {
    double[] state = y.clone();
    System.arraycopy(v, 0, state, v.length, v.length);
    return world(mechanism, state).kineticEnergy();
  }

  private static WorldMotion world(Mechanism mechanism, double[] y) {
    TreeMotion motion = new TreeMotion(new TreeGeometry(mechanism));
    motion.sweep(0, y);
    return new WorldMotion(motion);
  }

  private static double totalEnergy(Mechanism mechanism, double[] y) {
    WorldMotion world = world(mechanism, y);
    return world.kineticEnergy() + world.potentialEnergy();
  }

  private static double energyRate(Mechanism mechanism, double[] y, double[] a, double h) {
    return (totalEnergy(mechanism, along(y, a, h)) - totalEnergy(mechanism, along(y, a, -h)))
        / (2 * h);
  }

  private static double[] along(double[] y, double[] a, double h) {
    int n = a.length;
    double[] moved = y.clone();
    for (int i = 0; i < n; i++) {
      moved[i] += h * y[n + i];
      moved[n + i] += h * a[i];
    }
    return moved;
  }

  private static double largest(double[] values) {
    double largest = 0;
    for (double value : values) {
      largest = Math.max(largest, Math.abs(value));
    }
    return largest;
  }
}
