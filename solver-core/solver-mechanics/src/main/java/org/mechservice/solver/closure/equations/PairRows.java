package org.mechservice.solver.closure.equations;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import java.util.Optional;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.force.applied.Couplings;
import org.mechservice.solver.force.applied.ForceJacobian;
import org.mechservice.solver.kinematics.TreeGeometry;
import org.mechservice.solver.kinematics.TreeMotion;
import org.mechservice.solver.kinematics.pair.CutJoint;
import org.mechservice.solver.kinematics.pair.PairFunction;
import org.mechservice.solver.kinematics.pair.PairLinearisation;
import org.mechservice.solver.kinematics.pair.RelativeMotion;
import org.mechservice.solver.kinematics.pair.RollingShape;
import org.mechservice.solver.mechanism.closure.DistanceClosure;
import org.mechservice.solver.mechanism.closure.JointClosure;
import org.mechservice.solver.mechanism.closure.KnifeEdgeClosure;
import org.mechservice.solver.mechanism.closure.LoopClosure;
import org.mechservice.solver.mechanism.closure.PointOnLineClosure;
import org.mechservice.solver.mechanism.closure.PointOnPlaneClosure;
import org.mechservice.solver.mechanism.closure.RollingClosure;
import org.mechservice.solver.mechanism.joint.Joint;

/**
 * Equations between two bodies: functions of their relative pose that are zero, and coordinates of
 * a cut joint with prescribed motions.
 */
final class PairRows extends ClosureRows {
  private static final double[] NO_RATES = new double[36];
  private static final long NOWHERE = -1;

  private final RelativeMotion relative;
  private final PairFunction[] functions;
  private final double[] value;

  /** Values before the prescribed motions are subtracted, and where they were evaluated. */
  private final double[] measured;

  private Object placedIn = this;
  private long placement = NOWHERE;
  private final double[] gradient = new double[6];
  private final double[] curvature = new double[36];
  private final PairLinearisation linearisation = new PairLinearisation();
  private final double length;

  /** Number of leading functions that are zero; the others follow the prescribed motion. */
  private final int vanishing;

  private final PrescribedPairMotion driven;

  /** Whether the equations hold start values, with time counted from zero. */
  private final boolean atStart;

  private PairRows(
      LoopClosure closure,
      RelativeMotion relative,
      List<PairFunction> functions,
      PrescribedPairMotion driven,
      double length,
      boolean atStart) {
    super(closure);
    this.atStart = atStart;
    this.relative = relative;
    this.functions = functions.toArray(PairFunction[]::new);
    this.driven = driven;
    this.length = length;
    vanishing = functions.size() - driven.count();
    value = new double[functions.size()];
    measured = new double[functions.size()];
  }

  private PairRows(
      LoopClosure closure, RelativeMotion relative, List<PairFunction> functions, double length) {
    this(
        closure,
        relative,
        functions,
        new PrescribedPairMotion(List.of(), new double[0]),
        length,
        false);
  }

  /** Constraints and prescribed coordinates of a cut joint. */
  static PairRows of(JointClosure closure, TreeGeometry tree, double[] parameters, double length) {
    CutJoint cut = new CutJoint(tree, closure.joint());
    List<PairFunction> functions = new ArrayList<>(cut.forbidden());
    for (int k = 0; k < closure.motion().size(); k++) {
      functions.add(cut.coordinate(k));
    }
    PrescribedPairMotion driven = new PrescribedPairMotion(closure.motion(), parameters);
    return new PairRows(closure, cut.relative(), functions, driven, length, false);
  }

  /** Two points at a constant distance. */
  static PairRows of(DistanceClosure closure, TreeGeometry tree, double length) {
    RelativeMotion relative = new RelativeMotion(tree, closure.point1(), closure.point2());
    return new PairRows(
        closure, relative, List.of(PairFunction.distance(closure.distance())), length);
  }

  /** A point in a plane. */
  static PairRows of(PointOnPlaneClosure closure, TreeGeometry tree, double length) {
    RelativeMotion relative = new RelativeMotion(tree, closure.plane(), closure.point());
    PairFunction offPlane =
        PairFunction.displacement("displacement off the plane", closure.normal());
    return new PairRows(closure, relative, List.of(offPlane), length);
  }

  /** A point on a line. */
  static PairRows of(PointOnLineClosure closure, TreeGeometry tree, double length) {
    RelativeMotion relative = new RelativeMotion(tree, closure.line(), closure.point());
    return new PairRows(closure, relative, PairFunction.offLine(closure.direction()), length);
  }

  /** A wheel or ball that rolls on a plane. */
  static PairRows of(RollingClosure closure, TreeGeometry tree, double length) {
    RelativeMotion relative = new RelativeMotion(tree, closure.plane(), closure.centre());
    RollingShape shape =
        new RollingShape(closure.normal(), closure.axle(), closure.radius(), closure.tube());
    return new PairRows(closure, relative, PairFunction.rolling(shape), length);
  }

  /** An edge that does not slip sideways. */
  static PairRows of(KnifeEdgeClosure closure, TreeGeometry tree, double length) {
    RelativeMotion relative = new RelativeMotion(tree, closure.ground(), closure.point());
    return new PairRows(
        closure, relative, List.of(PairFunction.edgeVelocity(closure.side())), length);
  }

  /**
   * Coordinates and velocities of a cut joint with given start values; equations for assembly only.
   */
  static PairRows ofStart(JointClosure closure, TreeGeometry tree, double length) {
    Joint joint = closure.joint();
    CutJoint cut = new CutJoint(tree, joint);
    double[] q = new double[joint.type().positionCount()];
    double[] v = new double[joint.type().velocityCount()];
    joint.initialPositions(q, 0);
    joint.initialVelocities(v, 0);
    int turning = joint.type().hasEulerParameters() ? 3 : 0;
    List<PairFunction> functions = new ArrayList<>();
    List<Expression> kept = new ArrayList<>();
    if (turning > 0) {
      functions.addAll(cut.rotationsFrom(q, 0));
    }
    for (int k = 0; k < v.length; k++) {
      double start = k < turning ? 0 : q[k + q.length - v.length];
      kept.add(
          new Expression.Sum(
              Expression.of(start),
              new Expression.Product(Expression.of(v[k]), new Expression.Time())));
      if (k >= turning) {
        functions.add(cut.coordinate(k));
      }
    }
    PrescribedPairMotion motion = new PrescribedPairMotion(kept, new double[0]);
    return new PairRows(closure, cut.relative(), functions, motion, length, true);
  }

  @Override
  int count() {
    return functions.length;
  }

  @Override
  String label(int row) {
    return functions[row].label();
  }

  @Override
  boolean isHolonomic(int row) {
    return functions[row].isHolonomic();
  }

  @Override
  double size(int row) {
    return functions[row].isLength() ? length : 1;
  }

  @Override
  String unit(int row) {
    return functions[row].isLength() ? "m" : "rad";
  }

  @Override
  void place(TreeMotion motion, double t) {
    if (placedIn != motion || placement != motion.placement()) {
      relative.place(motion);
      for (int i = 0; i < functions.length; i++) {
        measured[i] = functions[i].evaluate(relative);
      }
      placement = motion.placement();
      placedIn = motion;
    }
    subtractDriven(t);
  }

  @Override
  void placeFar(TreeMotion motion, double t) {
    placement = NOWHERE;
    relative.place(motion);
    for (int i = 0; i < functions.length; i++) {
      measured[i] = functions[i].evaluateFar(relative);
    }
    subtractDriven(t);
  }

  private void subtractDriven(double t) {
    System.arraycopy(measured, 0, value, 0, value.length);
    if (vanishing == functions.length) {
      return;
    }
    driven.evaluate(atStart ? 0 : t);
    for (int i = vanishing; i < functions.length; i++) {
      value[i] = functions[i].difference(value[i], driven.value(i - vanishing));
    }
  }

  @Override
  void move(TreeMotion motion, double t) {
    relative.move(motion);
  }

  @Override
  void accelerate(TreeMotion motion, double t) {
    relative.accelerate(motion);
  }

  @Override
  double value(int row) {
    return value[row];
  }

  @Override
  double rate(int row) {
    double rate = functions[row].rate(relative);
    return row < vanishing ? rate : rate - driven.rate(row - vanishing);
  }

  @Override
  double acceleration(int row) {
    double acceleration = functions[row].acceleration(relative);
    return row < vanishing ? acceleration : acceleration - driven.acceleration(row - vanishing);
  }

  @Override
  void addJacobian(TreeMotion motion, int row, double[] rows, int at) {
    relative.addRow(motion, functions[row].gradient, 1, rows, at);
  }

  @Override
  void addBounds(TreeMotion motion, int row, double[] bounds, int at) {
    relative.addRowBounds(motion, functions[row].gradient, bounds, at);
  }

  @Override
  void addForces(int row, double multiplier, double[] wrench, double[] tau) {
    relative.addWrenches(functions[row].gradient, multiplier, wrench);
  }

  @Override
  Optional<RelativeMotion> pair() {
    return Optional.of(relative);
  }

  @Override
  void wrenches(int row, double[] onA, double[] onB) {
    relative.wrenches(functions[row].gradient, onA, onB);
  }

  @Override
  void linearise(double[] multipliers, int at, double factor, ForceJacobian sink) {
    Arrays.fill(gradient, 0);
    Arrays.fill(curvature, 0);
    for (int row = 0; row < functions.length; row++) {
      double force = factor * multipliers[at + row];
      if (force != 0) {
        for (int i = 0; i < 6; i++) {
          gradient[i] += force * functions[row].gradient[i];
        }
        functions[row].addCurvature(relative, force, curvature);
      }
    }
    linearisation.blocks(
        relative,
        gradient,
        curvature,
        (on, by, byPlace) -> sink.wrenchByLink(on, by, byPlace, NO_RATES));
  }

  @Override
  void addSupport(BitSet ways, BitSet loaded, BitSet velocities) {
    relative.addWays(ways);
    if (relative.linkA() != TreeGeometry.ROOT) {
      loaded.set(relative.linkA());
    }
    if (relative.linkB() != TreeGeometry.ROOT) {
      loaded.set(relative.linkB());
    }
  }

  @Override
  void couplings(Couplings couplings) {
    if (relative.linkA() != TreeGeometry.ROOT && relative.linkB() != TreeGeometry.ROOT) {
      couplings.couple(relative.linkA(), relative.linkB());
    }
  }

  @Override
  boolean isLocal(TreeGeometry tree) {
    return tree.areNeighbours(relative.linkA(), relative.linkB());
  }

  @Override
  void accepted() {}
}
