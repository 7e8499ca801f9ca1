package org.mechservice.solver.analysis;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.solver.analysis.equation.EquationsOfMotion;
import org.mechservice.solver.api.JointType;
import org.mechservice.solver.api.capability.DependentStates;
import org.mechservice.solver.api.result.ColumnGroup;
import org.mechservice.solver.expression.BodyPoint;
import org.mechservice.solver.expression.ClosureCoordinate;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.expression.JointCoordinate;
import org.mechservice.solver.force.user.UserForceSource;
import org.mechservice.solver.kinematics.TreeGeometry;
import org.mechservice.solver.mechanism.Body;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.PrescribedMotion;
import org.mechservice.solver.mechanism.RandomTrees;
import org.mechservice.solver.mechanism.Root;
import org.mechservice.solver.mechanism.closure.DistanceClosure;
import org.mechservice.solver.mechanism.closure.JointClosure;
import org.mechservice.solver.mechanism.closure.LoopClosure;
import org.mechservice.solver.mechanism.force.ForceElement;
import org.mechservice.solver.mechanism.force.JointForce;
import org.mechservice.solver.mechanism.joint.Attachment;
import org.mechservice.solver.mechanism.joint.Joint;
import org.mechservice.solver.mechanism.joint.JointStart;
import org.mechservice.solver.mechanism.joint.Spherical;
import org.mechservice.solver.scenes.SharedScene;
import org.mechservice.solver.spatial.InertiaTensor;
import org.mechservice.solver.spatial.Rotation;
import org.mechservice.solver.spatial.Vector3;
import org.mechservice.solver.text.Origin;

/** Forces in joints: statics, the balance of every body, the same whichever joint is cut. */
class ReactionTest {
  private static final double G = 9.81;

  /**
   *
   *
   * <pre>ground --S-- 1 kg --S-- 2 kg --S-- 3 kg, hanging at rest</pre>
   */
  @Test
  void jointsOfHangingChainCarryTheWeightsBelow() {
    List<Body> bodies = new ArrayList<>();
    List<Joint> joints = new ArrayList<>();
    for (int i = 0; i < 3; i++) {
      InertiaTensor inertia = new InertiaTensor(0.1, 0.1, 0.01, 0, 0, 0);
      bodies.add(new Body("b" + i, 1 + i, new Vector3(0, 0, -0.5), inertia, Origin.NONE));
      Vector3 onParent = i == 0 ? Vector3.ZERO : new Vector3(0, 0, -1);
      Attachment at = new Attachment(i - 1, onParent, i, Vector3.ZERO, Rotation.IDENTITY);
      JointStart start = JointStart.atZero(JointType.S);
      joints.add(new Spherical("j" + i, at, start, false, Origin.NONE));
    }
    Root root = new Root("ground", Vector3.ZERO, Rotation.IDENTITY);
    Mechanism chain = new Mechanism("chain", root, new Vector3(0, 0, -G), bodies, joints);
    ColumnsAt columns = new ColumnsAt(chain, ColumnGroup.REACTIONS);
    Map<String, Double> found = columns.at(0, columns.start());
    double[] carried = {6 * G, 5 * G, 3 * G};
    for (int i = 0; i < 3; i++) {
      assertThat(ColumnsAt.vector(found, "j" + i, "f")[2])
          .isCloseTo(carried[i], within(1e-13 * 60));
      assertThat(ColumnsAt.vector(found, "j" + i, "f")[0]).isZero();
      assertThat(ColumnsAt.vector(found, "j" + i, "t")).containsExactly(0, 0, 0);
    }
  }

  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8})
  void everyBodyOfTreeIsInBalance(long seed) {
    Mechanism tree = driven(RandomTrees.ofAllJoints(seed, 9), seed);
    ColumnsAt columns = new ColumnsAt(tree, ColumnGroup.REACTIONS, ColumnGroup.FORCES);
    requireBalance(tree, columns, 0.2, columns.start());
  }

  @ParameterizedTest
  @ValueSource(strings = {"fourbar_redundant", "A05_flyball"})
  void everyBodyOfLoopsIsInBalance(String name) {
    SharedScene scene = SharedScene.named(name);
    ColumnsAt columns =
        new ColumnsAt(scene.mechanism(), ColumnGroup.REACTIONS, ColumnGroup.CONSTRAINTS);
    requireBalance(scene.mechanism(), columns, 0, columns.start());
  }

  @ParameterizedTest
  @CsvSource({"0, false", "1, false", "2, false", "3, false", "1, true", "3, true"})
  void everyBodyOfLoopIsInBalanceWhereverItIsCut(int cut, boolean sliding) {
    Mechanism loop = SpatialLoop.cutAt(cut, sliding, List.of());
    ColumnsAt columns = new ColumnsAt(loop, ColumnGroup.REACTIONS);
    requireBalance(loop, columns, 0, moving(columns));
  }

  /** The same loop in the same motion, with a torque in one joint, be it cut or not. */
  @ParameterizedTest
  @ValueSource(booleans = {false, true})
  void reactionsAreTheSameWhicheverJointIsCut(boolean sliding) {
    double[][] all = new double[SpatialLoop.JOINTS][];
    for (int cut = 0; cut < SpatialLoop.JOINTS; cut++) {
      Mechanism loop = SpatialLoop.cutAt(cut, sliding, torqueIn(cut, 3));
      ColumnsAt columns = new ColumnsAt(loop, ColumnGroup.REACTIONS);
      Map<String, Double> found = columns.at(0, columns.start());
      all[cut] = new double[6 * SpatialLoop.JOINTS];
      for (int k = 0; k < SpatialLoop.JOINTS; k++) {
        // joints beyond the cut lead outwards against the file's sense
        double sign = k > cut ? -1 : 1;
        for (int i = 0; i < 3; i++) {
          all[cut][6 * k + i] = sign * ColumnsAt.vector(found, "j" + k, "f")[i];
          all[cut][6 * k + 3 + i] = sign * ColumnsAt.vector(found, "j" + k, "t")[i];
        }
      }
    }
    double largest = Arrays.stream(all[0]).map(Math::abs).max().orElseThrow();
    for (int cut = 1; cut < SpatialLoop.JOINTS; cut++) {
      for (int i = 0; i < all[0].length; i++) {
        // the condition of the loop's equations is some hundreds
        assertThat(all[cut][i])
            .as("cut " + cut + ", " + i)
            .isCloseTo(all[0][i], within(1e-11 * largest));
      }
    }
  }

  private static List<ForceElement> torqueIn(int cut, int joint) {
    var coordinate =
        joint == cut
            ? new ClosureCoordinate(0, 0)
            : new JointCoordinate(joint < cut ? joint : joint - 1, 0);
    return List.of(new JointForce("motor", coordinate, Expression.of(4), Origin.NONE));
  }

  /** Returns the start with a velocity of the independent coordinate. */
  private static double[] moving(ColumnsAt columns) {
    double[] y = columns.start();
    DependentStates loops = (DependentStates) columns.model;
    for (int i = columns.model.description().positionCount(); i < y.length; i++) {
      y[i] = loops.independent(i) ? 0.3 : 0;
    }
    loops.complete(0, y);
    return y;
  }

  private static Mechanism driven(Mechanism free, long seed) {
    Random random = new Random(seed);
    List<PrescribedMotion> motions = new ArrayList<>();
    for (int j = 0; j < free.joints().size(); j++) {
      var type = free.joints().get(j).type();
      if (type.positionCount() == 1 && random.nextBoolean()) {
        Expression t = new Expression.Time();
        motions.add(new PrescribedMotion(j, List.of(new Expression.Product(t, t))));
      }
    }
    return new Mechanism(
            free.name(),
            free.root(),
            free.gravity(),
            free.bodies(),
            free.joints(),
            motions,
            free.startRoles(),
            List.of(),
            List.of(),
            List.of())
        .withArmatures(free.armatures());
  }

  /** m a = m g + loads + Σ joints and d(I ω)/dt = moments about the centre of mass. */
  private static void requireBalance(Mechanism mechanism, ColumnsAt columns, double t, double[] y) {
    Map<String, Double> found = columns.at(t, y);
    EquationsOfMotion at = new EquationsOfMotion(mechanism, UserForceSource.NONE);
    double[] yDot = new double[y.length];
    columns.model.derivative(t, y, yDot);
    at.place(t, y);
    at.applyForces(t);
    at.formResidual(yDot, at.nq);
    at.balance();
    double largest = 1 + found.values().stream().mapToDouble(Math::abs).max().orElse(0);
    for (int body = 0; body < mechanism.bodies().size(); body++) {
      BodyBalance balance = new BodyBalance(at, body);
      for (int j = 0; j < mechanism.joints().size(); j++) {
        take(balance, mechanism.joints().get(j), found);
      }
      for (LoopClosure closure : mechanism.closures()) {
        if (closure instanceof JointClosure cut) {
          take(balance, cut.joint(), found);
        } else if (closure instanceof DistanceClosure rod) {
          balance.addRod(rod, ColumnsAt.value(found, rod.name() + ".lambda"));
        }
      }
      balance.addLoads(at.wrench);
      // reactions come from sums over the whole tree, of the size of the largest of them
      assertThat(balance.largest()).as("body " + body).isLessThan(2e-12 * largest);
    }
  }

  private static void take(BodyBalance balance, Joint joint, Map<String, Double> found) {
    Attachment at = joint.attachment();
    double[] force = ColumnsAt.vector(found, joint.name(), "f");
    double[] moment = ColumnsAt.vector(found, joint.name(), "t");
    balance.add(at.child(), at.child(), at.childPoint(), 1, force, moment);
    balance.add(at.parent(), at.child(), at.childPoint(), -1, force, moment);
  }

  /** What is left of the forces on a body after its inertia has been taken away. */
  private static final class BodyBalance {
    private final EquationsOfMotion at;
    private final int body;
    private final double[] center = new double[3];
    private final double[] force = new double[3];
    private final double[] moment = new double[3];

    BodyBalance(EquationsOfMotion at, int body) {
      this.at = at;
      this.body = body;
      TreeGeometry tree = at.tree;
      Body moved = tree.mechanism().bodies().get(body);
      int link = tree.linkOfBody[body];
      double[] c = Arrays.copyOfRange(tree.centerOfMass, 3 * link, 3 * link + 3);
      at.motion.points.position(link, c, 0, center, 0);
      double[] a = new double[3];
      at.motion.points.acceleration(link, c, 0, a, 0);
      for (int i = 0; i < 3; i++) {
        force[i] = moved.mass() * (tree.gravity[i] - a[i]);
      }
      Vector3 omega = vector(at.motion.angularVelocity, 3 * link);
      Vector3 alpha = vector(at.motion.angularAcceleration, 3 * link);
      Vector3 rate = times(moved.inertia(), alpha).plus(omega.cross(times(moved.inertia(), omega)));
      double[] inBody = {-rate.x(), -rate.y(), -rate.z()};
      at.motion.toWorld(link, inBody, 0, moment, 0);
    }

    private static Vector3 times(InertiaTensor i, Vector3 w) {
      return new Vector3(
          i.xx() * w.x() + i.xy() * w.y() + i.xz() * w.z(),
          i.xy() * w.x() + i.yy() * w.y() + i.yz() * w.z(),
          i.xz() * w.x() + i.yz() * w.y() + i.zz() * w.z());
    }

    private static Vector3 vector(double[] v, int at) {
      return new Vector3(v[at], v[at + 1], v[at + 2]);
    }

    void add(int on, int ofPoint, Vector3 point, int sign, double[] f, double[] m) {
      if (on == body) {
        double[] p = worldPoint(ofPoint, point);
        Vector3 arm = vector(p, 0).minus(vector(center, 0));
        Vector3 turning = arm.cross(vector(f, 0));
        double[] part = {turning.x(), turning.y(), turning.z()};
        for (int i = 0; i < 3; i++) {
          force[i] += sign * f[i];
          moment[i] += sign * (m[i] + part[i]);
        }
      }
    }

    private double[] worldPoint(int ofBody, Vector3 point) {
      double[] r = new double[3];
      double[] p = new double[3];
      at.tree.fromReference(new BodyPoint(ofBody, point), r, 0);
      at.motion.points.position(at.tree.linkOf(ofBody), r, 0, p, 0);
      return p;
    }

    void addRod(DistanceClosure rod, double tension) {
      Vector3 p1 = vector(worldPoint(rod.point1().body(), rod.point1().position()), 0);
      Vector3 p2 = vector(worldPoint(rod.point2().body(), rod.point2().position()), 0);
      Vector3 pull = p2.minus(p1).times(tension / rod.distance());
      double[] f = {pull.x(), pull.y(), pull.z()};
      add(rod.point1().body(), rod.point1().body(), rod.point1().position(), 1, f, new double[3]);
      add(rod.point2().body(), rod.point2().body(), rod.point2().position(), -1, f, new double[3]);
    }

    void addLoads(double[] wrench) {
      int link = at.tree.linkOfBody[body];
      double[] f = new double[3];
      double[] m = new double[3];
      at.motion.toWorld(link, wrench, 6 * link + 3, f, 0);
      at.motion.toWorld(link, wrench, 6 * link, m, 0);
      Vector3 reference =
          at.tree
              .mechanism()
              .joints()
              .get(at.tree.mechanism().jointOf(body))
              .attachment()
              .childPoint();
      add(body, body, reference, 1, f, m);
    }

    double largest() {
      double largest = 0;
      for (int i = 0; i < 3; i++) {
        largest = Math.max(largest, Math.max(Math.abs(force[i]), Math.abs(moment[i])));
      }
      return largest;
    }
  }
}
