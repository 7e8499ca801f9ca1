package org.mechservice.solver.closure.equations;

import java.util.Arrays;
import java.util.BitSet;
import java.util.stream.IntStream;
import org.mechservice.solver.force.applied.ForceJacobian;
import org.mechservice.solver.kinematics.CountedPositions;
import org.mechservice.solver.kinematics.TreeGeometry;
import org.mechservice.solver.kinematics.TreeMotion;
import org.mechservice.solver.kinematics.pair.CutJoint;
import org.mechservice.solver.kinematics.pair.PairFunction;
import org.mechservice.solver.kinematics.pair.PairLinearisation;
import org.mechservice.solver.kinematics.pair.PointCoordinate;
import org.mechservice.solver.kinematics.pair.RelativeMotion;

/**
 * A function of the pose of one body relative to another: a position of a cut joint, whose angles
 * are unwrapped, or a world coordinate of a point.
 */
final class PairLeaf extends CouplingLeaf {
  /** Reference of what is never unwrapped. */
  private static final int NOT_COUNTED = -1;

  final RelativeMotion relative;
  private final PairFunction function;
  private final double size;
  final double[] wrenchA = new double[6];
  final double[] wrenchB = new double[6];
  private final double[] gradient = new double[6];
  private final double[] curvature = new double[36];
  private final PairLinearisation linearisation = new PairLinearisation();

  /**
   * Unwrapped values at the last accepted step; an angle is taken on the whole turn nearest to it.
   */
  private final CountedPositions counted;

  private final int reference;

  private double value;

  PairLeaf(PointCoordinate point, double length, CountedPositions counted) {
    this.counted = counted;
    relative = point.relative();
    function = point.function();
    reference = NOT_COUNTED;
    size = length;
  }

  PairLeaf(CutJoint cut, int component, double length, CountedPositions counted) {
    this.counted = counted;
    relative = cut.relative();
    function = cut.coordinate(component);
    double[] start = new double[cut.joint().type().positionCount()];
    cut.joint().initialPositions(start, 0);
    reference = counted.add(start[component]);
    size = cut.joint().type().positionUnit(component).equals("m") ? length : 1;
  }

  @Override
  double value(TreeMotion motion, double t) {
    relative.place(motion);
    return counted(function.evaluate(relative));
  }

  @Override
  double valueFar(TreeMotion motion, double t) {
    relative.place(motion);
    return counted(function.evaluateFar(relative));
  }

  private double counted(double found) {
    if (reference == NOT_COUNTED) {
      return found;
    }
    double before = counted.get(reference);
    value = before + function.difference(found, before);
    return value;
  }

  @Override
  double rate(TreeMotion motion) {
    relative.move(motion);
    return function.rate(relative);
  }

  @Override
  double acceleration(TreeMotion motion) {
    relative.accelerate(motion);
    return function.acceleration(relative);
  }

  @Override
  double size() {
    return size;
  }

  @Override
  int[] links() {
    return IntStream.of(relative.linkA(), relative.linkB())
        .filter(link -> link != TreeGeometry.ROOT)
        .toArray();
  }

  @Override
  void addSupport(BitSet ways, BitSet loaded, BitSet velocities) {
    relative.addWays(ways);
    for (int link : links()) {
      loaded.set(link);
    }
  }

  @Override
  void addRow(TreeMotion motion, double factor, double[] rows, int at) {
    relative.addRow(motion, function.gradient, factor, rows, at);
  }

  @Override
  void addForce(double force, double[] wrench, double[] tau) {
    relative.addWrenches(function.gradient, force, wrench);
  }

  /**
   * Forms the wrenches of a unit force, which are also the gradient of the coordinate by link
   * motions.
   */
  void formWrenches() {
    relative.wrenches(function.gradient, wrenchA, wrenchB);
  }

  @Override
  void linearise(double force, ForceJacobian sink) {
    Arrays.fill(curvature, 0);
    function.addCurvature(relative, force, curvature);
    for (int i = 0; i < 6; i++) {
      gradient[i] = force * function.gradient[i];
    }
    linearisation.blocks(
        relative,
        gradient,
        curvature,
        (on, by, byPlace) -> sink.wrenchByLink(on, by, byPlace, NO_RATES));
  }

  @Override
  void byCoordinate(double stiffness, int by, ForceJacobian sink) {
    formWrenches();
    if (relative.linkA() != TreeGeometry.ROOT) {
      sink.wrenchByCoordinate(relative.linkA(), by, scaled(stiffness, wrenchA), NO_RATES);
    }
    if (relative.linkB() != TreeGeometry.ROOT) {
      sink.wrenchByCoordinate(relative.linkB(), by, scaled(stiffness, wrenchB), NO_RATES);
    }
  }

  @Override
  void byLink(double stiffness, int link, double[] by, ForceJacobian sink) {
    if (link == TreeGeometry.ROOT) {
      return;
    }
    formWrenches();
    outer(stiffness, relative.linkA(), wrenchA, link, by, sink);
    outer(stiffness, relative.linkB(), wrenchB, link, by, sink);
  }

  private void outer(
      double stiffness, int on, double[] wrench, int link, double[] by, ForceJacobian sink) {
    if (on == TreeGeometry.ROOT) {
      return;
    }
    for (int i = 0; i < 36; i++) {
      curvature[i] = stiffness * wrench[i / 6] * by[i % 6];
    }
    sink.wrenchByLink(on, link, curvature, NO_RATES);
  }

  @Override
  void accepted() {
    if (reference != NOT_COUNTED) {
      counted.set(reference, value);
    }
  }
}
