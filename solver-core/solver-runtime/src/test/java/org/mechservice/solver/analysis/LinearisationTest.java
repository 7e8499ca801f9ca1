package org.mechservice.solver.analysis;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.solver.analysis.equation.EquationsOfMotion;
import org.mechservice.solver.analysis.equation.Linearisation;
import org.mechservice.solver.api.Model;
import org.mechservice.solver.api.capability.DependentStates;
import org.mechservice.solver.api.capability.ExplicitModel;
import org.mechservice.solver.api.capability.ModelParts;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.compact.CompactModel;
import org.mechservice.solver.compact.DataDriven;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.expression.JointCoordinate;
import org.mechservice.solver.force.law.Side;
import org.mechservice.solver.force.user.UserForceSource;
import org.mechservice.solver.kinematics.StateCoordinates;
import org.mechservice.solver.mechanism.Body;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.RandomTrees;
import org.mechservice.solver.mechanism.Root;
import org.mechservice.solver.mechanism.force.ForceElement;
import org.mechservice.solver.mechanism.force.JointSpringDamper;
import org.mechservice.solver.mechanism.joint.Attachment;
import org.mechservice.solver.mechanism.joint.Joint;
import org.mechservice.solver.mechanism.joint.Prismatic;
import org.mechservice.solver.mechanism.joint.Revolute;
import org.mechservice.solver.scenes.SharedScene;
import org.mechservice.solver.spatial.InertiaTensor;
import org.mechservice.solver.spatial.Rotation;
import org.mechservice.solver.spatial.Vector3;
import org.mechservice.solver.text.Origin;

/** Linear equations against differences of the nonlinear model, modes against closed forms. */
class LinearisationTest {
  private static final RunSettings SETTINGS = new RunSettings(0, 1, 0.1, "ode113", 1e-8, 1e-10);
  private static final double STEP = 2e-3;

  /** A linearised mechanism and the model it is compared with. */
  private static final class Point {
    final ExplicitModel model;
    final EquationsOfMotion equations;
    final Linearisation linear;
    final double[] y;
    final int nq;
    final int nv;
    private final StateCoordinates coordinates;

    Point(Mechanism mechanism, double[] start) throws Linearisation.NotLinearised {
      boolean open = mechanism.closures().isEmpty();
      CompactModel data =
          new CompactModel(mechanism, "DSR", open ? "none" : "projection", SETTINGS);
      Model made = DataDriven.model(data, UserForceSource.NONE);
      model = (ExplicitModel) ModelParts.of(made).equations();
      nq = mechanism.positionCount();
      nv = mechanism.velocityCount();
      coordinates = new StateCoordinates(mechanism);
      y = start.length > 0 ? start : new double[nq + nv];
      if (start.length == 0) {
        model.initialState(y);
      }
      double[] yDot = new double[nq + nv];
      assertThat(model.derivative(0, y, yDot)).isEqualTo(ExplicitModel.REGULAR);
      equations = new EquationsOfMotion(mechanism, UserForceSource.NONE);
      linear = new Linearisation(equations, 0, y, Arrays.copyOfRange(yDot, nq, nq + nv));
    }

    Point(Mechanism mechanism) throws Linearisation.NotLinearised {
      this(mechanism, new double[0]);
    }

    /** Returns v' of the independent velocities after a small move of independent coordinates. */
    private double[] accelerations(int k, double h) {
      int f = linear.freedom();
      double[] moved = y.clone();
      if (k < f) {
        double[] z = new double[f];
        double[] xi = new double[nv];
        z[k] = 1;
        linear.expand(z, xi);
        coordinates.move(moved, 0, xi, 0, h);
      } else {
        moved[nq + linear.independent()[k - f]] += h;
      }
      if (model instanceof DependentStates loops) {
        assertThat(loops.complete(0, moved)).isTrue();
      }
      double[] yDot = new double[y.length];
      assertThat(model.derivative(0, moved, yDot)).isEqualTo(ExplicitModel.REGULAR);
      double[] a = new double[f];
      for (int i = 0; i < f; i++) {
        a[i] = yDot[nq + linear.independent()[i]];
      }
      return a;
    }

    /** Central differences of three steps, extrapolated. */
    double[] difference(int k) {
      double[][] central = new double[3][];
      for (int s = 0; s < 3; s++) {
        double h = STEP / (1 << s);
        central[s] = accelerations(k, h);
        double[] minus = accelerations(k, -h);
        for (int i = 0; i < minus.length; i++) {
          central[s][i] = (central[s][i] - minus[i]) / (2 * h);
        }
      }
      for (int i = 0; i < central[0].length; i++) {
        double first = central[1][i] + (central[1][i] - central[0][i]) / 3;
        double second = central[2][i] + (central[2][i] - central[1][i]) / 3;
        central[2][i] = second + (second - first) / 15;
      }
      return central[2];
    }

    void requireDifferences(double tolerance) {
      int f = linear.freedom();
      double[] system = linear.system();
      for (int k = 0; k < 2 * f; k++) {
        double[] expected = difference(k);
        double scale = 1 + Arrays.stream(expected).map(Math::abs).max().orElse(0);
        for (int i = 0; i < f; i++) {
          assertThat(system[(f + i) * 2 * f + k])
              .as("row " + i + ", column " + k)
              .isCloseTo(expected[i], within(tolerance * scale));
        }
      }
    }

    Modes modes() {
      return new Modes(linear, linear.system());
    }
  }

  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3, 4, 5, 6})
  void equationsOfTreesAreDerivativesOfTheModel(long seed) throws Exception {
    // rounding of the differences times the condition of trees of this size
    new Point(RandomTrees.ofAllJoints(seed, 6)).requireDifferences(1e-8);
  }

  @ParameterizedTest
  @CsvSource({"0, false", "1, false", "2, false", "3, false", "0, true", "3, true"})
  void equationsOfMovingLoopAreDerivativesOfTheModel(int cut, boolean sliding) throws Exception {
    Mechanism loop = SpatialLoop.cutAt(cut, sliding, List.of());
    ColumnsAt columns = new ColumnsAt(loop);
    double[] y = columns.start();
    DependentStates loops = (DependentStates) columns.model;
    for (int i = loop.positionCount(); i < y.length; i++) {
      y[i] = loops.independent(i) ? 0.7 : 0;
    }
    loops.complete(0, y);
    Point point = new Point(loop, y);
    int independent = point.linear.independent()[0];
    assertThat(((DependentStates) point.model).independent(point.nq + independent)).isTrue();
    point.requireDifferences(1e-8);
  }

  /** Eigenvalues of the suspension at its start, from the README.md beside the scenes. */
  @Test
  void eigenvaluesOfSuspensionAreThePublishedOnes() throws Exception {
    Modes modes = new Point(SharedScene.named("fps").mechanism()).modes();
    List<double[]> found = new ArrayList<>();
    for (int k = 0; k < modes.count(); k++) {
      found.add(new double[] {modes.growth(k), modes.angularFrequency(k)});
    }
    found.sort(Comparator.comparingDouble(e -> e[0]));
    assertThat(found.get(0)).containsExactly(new double[] {-163.9, 0}, within(0.05));
    assertThat(found.get(1)).containsExactly(new double[] {-29.5, 86.1}, within(0.05));
    assertThat(found.get(2)).containsExactly(new double[] {-21.9, 28.9}, within(0.05));
  }

  /** The driver's fastest decay and oscillation, from the README.md beside the scenes. */
  @ParameterizedTest
  @CsvSource({"driver_C0, -123, 1493, 1", "driver_CK100, -22400, 96, 50"})
  void eigenvaluesOfDriverAreThePublishedOnes(
      String scene, double fastestDecay, double fastestOscillation, double rounding)
      throws Exception {
    Modes modes = new Point(SharedScene.named(scene).mechanism()).modes();
    double decay = 0;
    double oscillation = 0;
    for (int k = 0; k < modes.count(); k++) {
      decay = Math.min(decay, modes.growth(k));
      oscillation = Math.max(oscillation, modes.angularFrequency(k));
    }
    assertThat(decay).isCloseTo(fastestDecay, within(rounding));
    assertThat(oscillation).isCloseTo(fastestOscillation, within(1.0));
  }

  private static final Root GROUND = new Root("ground", Vector3.ZERO, Rotation.IDENTITY);
  private static final Vector3 Y = new Vector3(0, 1, 0);

  /** Two point masses of 1 kg on massless rods of 1 m, hanging. */
  @Test
  void modesOfDoublePendulumAreTheClosedForm() throws Exception {
    List<Body> bodies = new ArrayList<>();
    List<Joint> joints = new ArrayList<>();
    for (int i = 0; i < 2; i++) {
      bodies.add(new Body("b" + i, 1, new Vector3(0, 0, -1), InertiaTensor.ZERO, Origin.NONE));
      Vector3 onParent = i == 0 ? Vector3.ZERO : new Vector3(0, 0, -1);
      Attachment at = new Attachment(i - 1, onParent, i, Vector3.ZERO, Rotation.IDENTITY);
      joints.add(new Revolute("j" + i, at, Y, 0, 0, Origin.NONE));
    }
    Mechanism pendulum = new Mechanism("double", GROUND, new Vector3(0, 0, -9.81), bodies, joints);
    Point point = new Point(pendulum);
    Modes modes = point.modes();
    double[] re = new double[2];
    double[] im = new double[2];
    for (int k = 0; k < 2; k++) {
      // ω² = (2 ∓ √2) g/l; absolute angles in the ratio 1 : ±√2, relative ones 1 : ±√2 − 1
      double sign = k == 0 ? 1 : -1;
      assertThat(modes.angularFrequency(k))
          .isCloseTo(Math.sqrt((2 - sign * Math.sqrt(2)) * 9.81), within(1e-13));
      assertThat(modes.dampingRatio(k)).isCloseTo(0, within(1e-14));
      modes.shape(k, new double[] {1, 1}, re, im);
      assertThat(re[1] / re[0]).isCloseTo(sign * Math.sqrt(2) - 1, within(1e-13));
      assertThat(im).containsExactly(new double[] {0, 0}, within(1e-13));
    }
  }

  /** n sliding masses between n springs: ω_k = 2 √(k/m) sin((2k − 1) π / (4n + 2)). */
  @Test
  void modesOfSpringMassChainAreTheClosedForm() throws Exception {
    int n = 12;
    Point point = new Point(chain(n, 100, 0.2, 0));
    Modes modes = point.modes();
    assertThat(modes.count()).isEqualTo(n);
    for (int k = 0; k < n; k++) {
      double omega = 2 * Math.sqrt(100 / 0.2) * Math.sin((2 * k + 1) * Math.PI / (4 * n + 2));
      assertThat(2 * Math.PI * modes.frequency(k)).isCloseTo(omega, within(1e-11 * omega));
    }
  }

  /** Damping proportional to stiffness: ζ = ω c / 2 k; beyond 1 two real eigenvalues. */
  @ParameterizedTest
  @CsvSource({"0.1", "3"})
  void dampingRatiosAreThoseOfProportionalDamping(double damping) throws Exception {
    Point point = new Point(chain(1, 4, 1, damping));
    Modes modes = point.modes();
    double ratio = damping / 4;
    if (ratio < 0.5) {
      assertThat(modes.count()).isOne();
      assertThat(modes.dampingRatio(0)).isCloseTo(ratio, within(1e-14));
      assertThat(modes.frequency(0)).isCloseTo(2 / (2 * Math.PI), within(1e-14));
    } else {
      assertThat(modes.dampingRatio(0)).isCloseTo(ratio, within(1e-14));
    }
  }

  @Test
  void overdampedMotionHasTwoRealModes() throws Exception {
    Modes modes = new Point(chain(1, 4, 1, 5)).modes();
    assertThat(modes.count()).isEqualTo(2);
    // λ² + 5 λ + 4
    assertThat(modes.growth(0)).isCloseTo(-1, within(1e-14));
    assertThat(modes.growth(1)).isCloseTo(-4, within(1e-14));
    assertThat(modes.dampingRatio(0)).isEqualTo(1);
    assertThat(modes.angularFrequency(0)).isZero();
  }

  /** Two equal oscillators on one root: the frequency is there twice, with two shapes. */
  @Test
  void repeatedModesHaveIndependentShapes() throws Exception {
    List<Body> bodies = new ArrayList<>();
    List<Joint> joints = new ArrayList<>();
    List<ForceElement> springs = new ArrayList<>();
    for (int i = 0; i < 2; i++) {
      bodies.add(new Body("m" + i, 1, Vector3.ZERO, InertiaTensor.ZERO, Origin.NONE));
      joints.add(slide(i, -1));
      springs.add(spring(i, 9, 0));
    }
    Point point = new Point(withForces(bodies, joints, springs));
    Modes modes = point.modes();
    double[][] shape = new double[2][2];
    for (int k = 0; k < 2; k++) {
      assertThat(modes.angularFrequency(k)).isCloseTo(3, within(1e-14));
      modes.shape(k, point.equations.unit, shape[k], new double[2]);
    }
    double determinant = shape[0][0] * shape[1][1] - shape[0][1] * shape[1][0];
    assertThat(Math.abs(determinant)).isGreaterThan(0.5);
  }

  /** Two masses joined by a spring alone: one mode, and free flight with two zero eigenvalues. */
  @Test
  void freeFlightGivesZeroModes() throws Exception {
    Mechanism chain = chain(2, 50, 1, 0);
    Mechanism free = withForces(chain.bodies(), chain.joints(), List.of(chain.forces().get(1)));
    Modes modes = new Point(free).modes();
    int zeros = 0;
    for (int k = 0; k < modes.count(); k++) {
      zeros += modes.frequency(k) == 0 ? 1 : 0;
    }
    assertThat(zeros).isEqualTo(modes.count() - 1);
    assertThat(modes.angularFrequency(modes.count() - 1)).isCloseTo(10, within(1e-12));
  }

  /** About an equilibrium the eigenvalues do not depend on the joint that is cut. */
  @Test
  void modesAboutEquilibriumAreTheSameWhicheverJointIsCut() throws Exception {
    double[][] all = new double[SpatialLoop.JOINTS][];
    for (int cut = 0; cut < SpatialLoop.JOINTS; cut++) {
      Mechanism loop = SpatialLoop.cutAt(cut, false, List.of());
      StaticEquilibrium equilibrium = new StaticEquilibrium(loop, UserForceSource.NONE, 1e-13, 200);
      assertThat(equilibrium.find(0)).isTrue();
      Modes modes = new Point(loop, equilibrium.state()).modes();
      all[cut] = new double[] {modes.growth(0), modes.angularFrequency(0)};
    }
    for (double[] eigenvalue : all) {
      assertThat(eigenvalue[0]).isCloseTo(all[0][0], within(1e-10));
      assertThat(eigenvalue[1]).isCloseTo(all[0][1], within(1e-10 * all[0][1]));
    }
    assertThat(all[0][1]).isGreaterThan(1);
  }

  private static Joint slide(int i, int parent) {
    Attachment at = new Attachment(parent, Vector3.ZERO, i, Vector3.ZERO, Rotation.IDENTITY);
    return new Prismatic("s" + i, at, new Vector3(1, 0, 0), 0, 0, Origin.NONE);
  }

  private static ForceElement spring(int joint, double stiffness, double damping) {
    return new JointSpringDamper(
        "k" + joint,
        new JointCoordinate(joint, 0),
        Expression.of(stiffness),
        Expression.of(damping),
        Expression.ZERO,
        Expression.ZERO,
        Side.BOTH,
        Expression.ZERO,
        Origin.NONE);
  }

  private static Mechanism chain(int n, double stiffness, double mass, double damping) {
    List<Body> bodies = new ArrayList<>();
    List<Joint> joints = new ArrayList<>();
    List<ForceElement> springs = new ArrayList<>();
    for (int i = 0; i < n; i++) {
      bodies.add(new Body("m" + i, mass, Vector3.ZERO, InertiaTensor.ZERO, Origin.NONE));
      joints.add(slide(i, i - 1));
      springs.add(spring(i, stiffness, damping));
    }
    return withForces(bodies, joints, springs);
  }

  private static Mechanism withForces(
      List<Body> bodies, List<Joint> joints, List<ForceElement> forces) {
    Mechanism tree = new Mechanism("chain", GROUND, Vector3.ZERO, bodies, joints);
    return new Mechanism(
        tree.name(),
        tree.root(),
        tree.gravity(),
        bodies,
        joints,
        List.of(),
        tree.startRoles(),
        List.of(),
        forces,
        List.of());
  }
}
