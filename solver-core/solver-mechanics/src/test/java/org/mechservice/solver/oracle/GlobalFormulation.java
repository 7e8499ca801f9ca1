package org.mechservice.solver.oracle;

import java.util.ArrayList;
import java.util.List;
import java.util.function.IntFunction;
import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.apache.commons.math3.linear.ArrayRealVector;
import org.apache.commons.math3.linear.DecompositionSolver;
import org.apache.commons.math3.linear.DiagonalMatrix;
import org.apache.commons.math3.linear.RealMatrix;
import org.apache.commons.math3.linear.RealVector;
import org.apache.commons.math3.linear.SingularValueDecomposition;
import org.mechservice.solver.expression.BodyPoint;
import org.mechservice.solver.mechanism.Armature;
import org.mechservice.solver.mechanism.Body;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.PrescribedMotion;
import org.mechservice.solver.mechanism.closure.CoordinateClosure;
import org.mechservice.solver.mechanism.closure.DistanceClosure;
import org.mechservice.solver.mechanism.closure.LoopClosure;
import org.mechservice.solver.mechanism.joint.Joint;
import org.mechservice.solver.spatial.InertiaTensor;
import org.mechservice.solver.spatial.Rotation;
import org.mechservice.solver.spatial.Vector3;

/**
 * Joint accelerations from the Newton-Euler equations of all bodies, six unknowns each, under the
 * acceleration-level equations G A = −γ of all joints and closures:
 *
 * <pre>A = −G⁺γ + Z z,  (Zᵀ M Z) z = Zᵀ (F + M G⁺γ),  Z = null space of G</pre>
 *
 * <p>G and γ are Taylor coefficients of the equations along motions of the bodies, so redundant
 * rows do no harm and nothing is differentiated by hand. Armatures are masses of joint
 * accelerations. A rod is three masses: a sixth at either end and two thirds in the middle.
 */
public final class GlobalFormulation {
  /** Singular values of G below this part of the largest belong to redundant equations. */
  private static final double REDUNDANT = 1e-9;

  private final Mechanism mechanism;
  private final List<OracleForce> forces;

  /**
   * @param forces everything besides gravity
   */
  public GlobalFormulation(Mechanism mechanism, List<OracleForce> forces) {
    this.mechanism = mechanism;
    this.forces = forces;
  }

  private TaylorPose root() {
    return root(mechanism);
  }

  /** Returns the pose of the root, which rests. */
  public static TaylorPose root(Mechanism mechanism) {
    return new TaylorPose(
        TaylorVector.of(mechanism.root().position()),
        TaylorRotation.of(mechanism.root().orientation()));
  }

  /** Returns pose and motion of every body when the joints have the accelerations a. */
  public TaylorPose[] poses(double t, double[] q, double[] v, double[] a) {
    TaylorPose[] poses = new TaylorPose[mechanism.bodies().size()];
    for (int j : mechanism.outward()) {
      Joint joint = mechanism.joints().get(j);
      JointSide side = JointSide.of(joint);
      TaylorPose relative = JointEquations.pose(joint, coordinates(j, t, q, v, a));
      int parent = joint.attachment().parent();
      TaylorPose from = parent == BodyPoint.ROOT ? root() : poses[parent];
      boolean outwards = side.body1() == parent;
      TaylorPose jointOnParent =
          new TaylorPose(from.at(outwards ? side.point1() : side.point2()), from.rotation());
      TaylorPose jointOnChild = jointOnParent.times(outwards ? relative : relative.inverse());
      Vector3 childPoint = outwards ? side.point2() : side.point1();
      poses[joint.attachment().child()] =
          new TaylorPose(jointOnChild.at(childPoint.negated()), jointOnChild.rotation());
    }
    return poses;
  }

  private Taylor[] coordinates(int j, double t, double[] q, double[] v, double[] a) {
    if (mechanism.isDriven(j)) {
      return driven(j, new Taylor(t, 1, 0));
    }
    return JointEquations.coordinates(
        mechanism.joints().get(j),
        q,
        mechanism.positionOffset(j),
        v,
        a,
        mechanism.velocityOffset(j));
  }

  private Taylor[] driven(int j, Taylor time) {
    PrescribedMotion motion =
        mechanism.motions().stream().filter(m -> m.joint() == j).findFirst().orElseThrow();
    return motion.coordinates().stream()
        .map(coordinate -> TimeFunction.of(coordinate, time))
        .toArray(Taylor[]::new);
  }

  private IntFunction<TaylorPose> lookup(TaylorPose[] poses) {
    TaylorPose root = root();
    return body -> body == BodyPoint.ROOT ? root : poses[body];
  }

  /** Returns the left sides of all closures' equations along the motion of the joints. */
  public List<double[]> closureResiduals(double t, double[] q, double[] v) {
    TaylorPose[] poses = poses(t, q, v, new double[mechanism.velocityCount()]);
    List<double[]> residuals = new ArrayList<>();
    for (LoopClosure closure : mechanism.closures()) {
      for (Taylor value : ClosureEquations.conditions(closure, lookup(poses))) {
        residuals.add(new double[] {value.x(), value.d()});
      }
    }
    return residuals;
  }

  /** Returns the joint accelerations, in the order of v. */
  public double[] accelerations(double t, double[] q, double[] v) {
    TaylorPose[] motion = poses(t, q, v, new double[mechanism.velocityCount()]);
    double[] bodyAccelerations = bodyAccelerations(t, q, v, motion);
    TaylorPose[] accelerated = new TaylorPose[motion.length];
    for (int b = 0; b < motion.length; b++) {
      accelerated[b] = moving(b, motion[b], true, bodyAccelerations, 6 * b);
    }
    return jointAccelerations(t, q, v, accelerated);
  }

  /**
   * Returns a body at its place with its velocities, or at rest, and with the given accelerations
   * of its centre of mass and of its rotation.
   */
  private TaylorPose moving(
      int body, TaylorPose now, boolean withVelocity, double[] acceleration, int at) {
    Vector3 center = mechanism.bodies().get(body).centerOfMass();
    Rotation axes = now.rotation().value();
    Vector3 omega = withVelocity ? now.rotation().angularVelocity() : Vector3.ZERO;
    TaylorVector place = now.at(center);
    Vector3 linear = new Vector3(acceleration[at], acceleration[at + 1], acceleration[at + 2]);
    Vector3 angular = new Vector3(acceleration[at + 3], acceleration[at + 4], acceleration[at + 5]);
    TaylorPose ofCenter =
        new TaylorPose(
            TaylorVector.of(place.value(), withVelocity ? place.rate() : Vector3.ZERO, linear),
            TaylorRotation.of(axes, omega, angular));
    return new TaylorPose(ofCenter.at(center.negated()), ofCenter.rotation());
  }

  private List<Condition> conditions() {
    List<Condition> all = new ArrayList<>();
    for (int j = 0; j < mechanism.joints().size(); j++) {
      Joint joint = mechanism.joints().get(j);
      int index = j;
      JointSide side = JointSide.of(joint);
      List<Integer> bodies = new ArrayList<>(List.of(side.body1(), side.body2()));
      bodies.removeIf(body -> body == BodyPoint.ROOT);
      all.add(
          new Condition(
              bodies,
              (pose, time) -> {
                TaylorPose relative =
                    side.relative(pose.apply(side.body1()), pose.apply(side.body2()));
                return mechanism.isDriven(index)
                    ? JointEquations.differences(
                        relative, JointEquations.pose(joint, driven(index, time)))
                    : JointEquations.conditions(joint, relative);
              }));
    }
    for (LoopClosure closure : mechanism.closures()) {
      if (closure instanceof CoordinateClosure relation) {
        all.add(new CouplingEquation(mechanism, relation).condition());
        continue;
      }
      all.add(
          new Condition(
              ClosureEquations.bodies(closure),
              (pose, time) -> ClosureEquations.conditions(closure, pose)));
    }
    return all;
  }

  /**
   * Returns what is missing to move every body as given, forces at and moments about the centres of
   * mass in world axes, six numbers per body: zero if the forces are all there are.
   */
  public double[] missing(double t, double[] q, double[] v, double[] a) {
    TaylorPose[] motion = poses(t, q, v, a);
    double[] wanted = new double[6 * motion.length];
    for (int b = 0; b < motion.length; b++) {
      put(wanted, 6 * b, motion[b].at(mechanism.bodies().get(b).centerOfMass()).acceleration());
      put(wanted, 6 * b + 3, motion[b].rotation().angularAcceleration());
    }
    RealMatrix mass = new Array2DRowRealMatrix(wanted.length, wanted.length);
    double[] loads = loads(t, motion, mass);
    double[] missing = mass.operate(wanted);
    for (int i = 0; i < missing.length; i++) {
      missing[i] -= loads[i];
    }
    return missing;
  }

  private static void put(double[] target, int at, Vector3 v) {
    target[at] = v.x();
    target[at + 1] = v.y();
    target[at + 2] = v.z();
  }

  /** Returns the loads on the bodies, and adds their masses and those of rods. */
  private double[] loads(double t, TaylorPose[] motion, RealMatrix mass) {
    BodyLoads loads = new BodyLoads(mechanism, lookup(motion));
    addBodies(motion, mass, loads);
    addRods(motion, mass, loads);
    for (OracleForce force : forces) {
      force.apply(t, lookup(motion), loads);
    }
    return loads.sum;
  }

  private double[] bodyAccelerations(double t, double[] q, double[] v, TaylorPose[] motion) {
    int n = 6 * motion.length;
    RealMatrix mass = new Array2DRowRealMatrix(n, n);
    double[] loads = loads(t, motion, mass);
    if (!mechanism.armatures().isEmpty()) {
      addArmatures(t, q, v, motion, mass, loads);
    }
    List<double[]> rows = new ArrayList<>();
    List<Double> gamma = new ArrayList<>();
    addConditions(t, motion, rows, gamma);
    return constrained(mass, loads, rows, gamma);
  }

  /** With joint accelerations a = P A + p: mass Pᵀ I P, load −Pᵀ I p for the armatures I. */
  private void addArmatures(
      double t, double[] q, double[] v, TaylorPose[] motion, RealMatrix mass, double[] loads) {
    double[] none = new double[6];
    TaylorPose[] coasting = new TaylorPose[motion.length];
    for (int b = 0; b < motion.length; b++) {
      coasting[b] = moving(b, motion[b], true, none, 0);
    }
    double[] p = jointAccelerations(t, q, v, coasting);
    RealMatrix columns = new Array2DRowRealMatrix(p.length, loads.length);
    for (int i = 0; i < loads.length; i++) {
      double[] unit = new double[6];
      unit[i % 6] = 1;
      TaylorPose[] moved = coasting.clone();
      moved[i / 6] = moving(i / 6, motion[i / 6], true, unit, 0);
      double[] with = jointAccelerations(t, q, v, moved);
      columns.setColumnVector(i, new ArrayRealVector(with).subtract(new ArrayRealVector(p)));
    }
    double[] inertia = new double[p.length];
    for (Armature armature : mechanism.armatures()) {
      for (int k = 0;
          k < armature.inertias().size() && !mechanism.isDriven(armature.joint());
          k++) {
        inertia[mechanism.velocityOffset(armature.joint()) + k] = armature.inertias().get(k);
      }
    }
    RealMatrix weighted = new DiagonalMatrix(inertia).multiply(columns);
    mass.setSubMatrix(mass.add(columns.transpose().multiply(weighted)).getData(), 0, 0);
    double[] felt = weighted.transpose().operate(p);
    for (int i = 0; i < felt.length; i++) {
      loads[i] -= felt[i];
    }
  }

  private void addBodies(TaylorPose[] motion, RealMatrix mass, BodyLoads loads) {
    for (int b = 0; b < motion.length; b++) {
      Body body = mechanism.bodies().get(b);
      InertiaTensor inertia = body.inertia().in(motion[b].rotation().value());
      double[][] tensor = {
        {inertia.xx(), inertia.xy(), inertia.xz()},
        {inertia.xy(), inertia.yy(), inertia.yz()},
        {inertia.xz(), inertia.yz(), inertia.zz()}
      };
      for (int i = 0; i < 3; i++) {
        mass.addToEntry(6 * b + i, 6 * b + i, body.mass());
        for (int k = 0; k < 3; k++) {
          mass.addToEntry(6 * b + 3 + i, 6 * b + 3 + k, tensor[i][k]);
        }
      }
      Vector3 omega = motion[b].rotation().angularVelocity();
      loads.force(new BodyPoint(b, body.centerOfMass()), mechanism.gravity().times(body.mass()));
      loads.moment(b, omega.cross(inertia.times(omega)).negated());
    }
  }

  private void addRods(TaylorPose[] motion, RealMatrix mass, BodyLoads loads) {
    for (LoopClosure closure : mechanism.closures()) {
      if (closure instanceof DistanceClosure rod && rod.hasRod()) {
        BodyPoint[] both = {rod.point1(), rod.point2()};
        addPointMass(both, new double[] {1, 0}, rod.rodMass() / 6, motion, mass, loads);
        addPointMass(both, new double[] {0, 1}, rod.rodMass() / 6, motion, mass, loads);
        addPointMass(both, new double[] {0.5, 0.5}, rod.rodMass() * 2 / 3, motion, mass, loads);
      }
    }
  }

  /** A mass at Σ share · point: rows J of its acceleration, J ᵀ m (g − what J does not give). */
  private void addPointMass(
      BodyPoint[] points,
      double[] share,
      double m,
      TaylorPose[] motion,
      RealMatrix mass,
      BodyLoads loads) {
    RealMatrix jacobian = new Array2DRowRealMatrix(3, mass.getRowDimension());
    Vector3 given = Vector3.ZERO;
    double[] none = new double[6];
    for (int p = 0; p < points.length; p++) {
      int b = points[p].body();
      if (b == BodyPoint.ROOT) {
        continue;
      }
      TaylorPose still = moving(b, motion[b], true, none, 0);
      given = given.plus(still.at(points[p].position()).acceleration().times(share[p]));
      for (int k = 0; k < 6; k++) {
        double[] unit = new double[6];
        unit[k] = 1;
        Vector3 column =
            moving(b, motion[b], false, unit, 0).at(points[p].position()).acceleration();
        jacobian.addToEntry(0, 6 * b + k, share[p] * column.x());
        jacobian.addToEntry(1, 6 * b + k, share[p] * column.y());
        jacobian.addToEntry(2, 6 * b + k, share[p] * column.z());
      }
    }
    RealMatrix added = jacobian.transpose().multiply(jacobian).scalarMultiply(m);
    mass.setSubMatrix(mass.add(added).getData(), 0, 0);
    Vector3 load = mechanism.gravity().minus(given).times(m);
    double[] onBodies = jacobian.transpose().operate(new double[] {load.x(), load.y(), load.z()});
    for (int i = 0; i < onBodies.length; i++) {
      loads.sum[i] += onBodies[i];
    }
  }

  /** γ: second derivative of the equations without accelerations; G: with unit ones, at rest. */
  private void addConditions(
      double t, TaylorPose[] motion, List<double[]> rows, List<Double> gamma) {
    TaylorPose[] still = new TaylorPose[motion.length];
    TaylorPose[] coasting = new TaylorPose[motion.length];
    double[] none = new double[6];
    for (int b = 0; b < motion.length; b++) {
      still[b] = moving(b, motion[b], false, none, 0);
      coasting[b] = moving(b, motion[b], true, none, 0);
    }
    for (Condition condition : conditions()) {
      int first = rows.size();
      for (Taylor value : condition.equations().at(lookup(coasting), new Taylor(t, 1, 0))) {
        rows.add(new double[6 * motion.length]);
        gamma.add(value.dd());
      }
      for (int b : condition.bodies()) {
        for (int k = 0; k < 6; k++) {
          double[] unit = new double[6];
          unit[k] = 1;
          TaylorPose[] moved = still.clone();
          moved[b] = moving(b, motion[b], false, unit, 0);
          List<Taylor> values = condition.equations().at(lookup(moved), Taylor.of(t));
          for (int i = 0; i < values.size(); i++) {
            rows.get(first + i)[6 * b + k] = values.get(i).dd();
          }
        }
      }
    }
  }

  private static double[] constrained(
      RealMatrix mass, double[] load, List<double[]> rows, List<Double> gamma) {
    int n = load.length;
    int m = rows.size();
    // square, so that V of the decomposition spans all of space
    RealMatrix g = new Array2DRowRealMatrix(Math.max(m, n), n);
    RealVector right = new ArrayRealVector(Math.max(m, n));
    for (int i = 0; i < m; i++) {
      g.setRow(i, rows.get(i));
      right.setEntry(i, -gamma.get(i));
    }
    SingularValueDecomposition svd = new SingularValueDecomposition(g);
    double[] sigma = svd.getSingularValues();
    int rank = 0;
    while (rank < sigma.length && sigma[rank] > REDUNDANT * sigma[0]) {
      rank++;
    }
    RealVector particular = new ArrayRealVector(n);
    for (int k = 0; k < rank; k++) {
      double part = svd.getU().getColumnVector(k).dotProduct(right) / sigma[k];
      particular = particular.add(svd.getV().getColumnVector(k).mapMultiply(part));
    }
    if (rank == n) {
      return particular.toArray();
    }
    RealMatrix free = svd.getV().getSubMatrix(0, n - 1, rank, n - 1);
    RealMatrix reduced = free.transpose().multiply(mass).multiply(free);
    RealVector force =
        free.transpose().operate(new ArrayRealVector(load).subtract(mass.operate(particular)));
    RealVector z = new SingularValueDecomposition(reduced).getSolver().solve(force);
    return particular.add(free.operate(z)).toArray();
  }

  /** Accelerations of joints from those of bodies, joint by joint, by least squares. */
  private double[] jointAccelerations(double t, double[] q, double[] v, TaylorPose[] accelerated) {
    double[] a = new double[mechanism.velocityCount()];
    for (int j = 0; j < mechanism.joints().size(); j++) {
      Joint joint = mechanism.joints().get(j);
      int count = joint.type().velocityCount();
      if (count == 0 || mechanism.isDriven(j)) {
        continue;
      }
      JointSide side = JointSide.of(joint);
      IntFunction<TaylorPose> pose = lookup(accelerated);
      double[] wanted =
          accelerations(side.relative(pose.apply(side.body1()), pose.apply(side.body2())));
      double[] none = accelerations(JointEquations.pose(joint, coordinates(j, t, q, v, a)));
      RealMatrix columns = new Array2DRowRealMatrix(6, count);
      for (int k = 0; k < count; k++) {
        double[] unit = new double[a.length];
        unit[mechanism.velocityOffset(j) + k] = 1;
        double[] with = accelerations(JointEquations.pose(joint, coordinates(j, t, q, v, unit)));
        columns.setColumnVector(k, new ArrayRealVector(with).subtract(new ArrayRealVector(none)));
      }
      DecompositionSolver solver = new SingularValueDecomposition(columns).getSolver();
      double[] found =
          solver.solve(new ArrayRealVector(wanted).subtract(new ArrayRealVector(none))).toArray();
      System.arraycopy(found, 0, a, mechanism.velocityOffset(j), count);
    }
    return a;
  }

  private static double[] accelerations(TaylorPose relative) {
    Vector3 linear = relative.position().acceleration();
    Vector3 angular = relative.rotation().angularAcceleration();
    return new double[] {linear.x(), linear.y(), linear.z(), angular.x(), angular.y(), angular.z()};
  }
}
