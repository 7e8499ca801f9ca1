package org.mechservice.solver.closure.equations;

import java.util.BitSet;
import org.mechservice.solver.expression.ClosureCoordinate;
import org.mechservice.solver.expression.Coordinate;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.expression.JointCoordinate;
import org.mechservice.solver.force.applied.ForceJacobian;
import org.mechservice.solver.kinematics.CountedPositions;
import org.mechservice.solver.kinematics.TreeGeometry;
import org.mechservice.solver.kinematics.TreeMotion;
import org.mechservice.solver.kinematics.pair.CutJoint;
import org.mechservice.solver.kinematics.pair.PointCoordinate;
import org.mechservice.solver.mechanism.closure.JointClosure;
import org.mechservice.solver.mechanism.closure.LoopClosure;

/** A variable of a coupling between coordinates. Workspace of one thread. */
abstract class CouplingLeaf {
  static final double[] NO_RATES = new double[36];

  private final double[] scaled = new double[6];

  final double[] scaled(double factor, double[] wrench) {
    for (int i = 0; i < 6; i++) {
      scaled[i] = factor * wrench[i];
    }
    return scaled;
  }

  /** Returns the value; places a cut joint's coordinate as well. */
  abstract double value(TreeMotion motion, double t);

  /** As {@link ClosureRows#placeFar}. */
  double valueFar(TreeMotion motion, double t) {
    return value(motion, t);
  }

  abstract double rate(TreeMotion motion);

  abstract double acceleration(TreeMotion motion);

  /** Returns the size of what it measures: m, or 1 rad; 0 if it is constant. */
  abstract double size();

  /** Returns the links on which it depends, without the root. */
  int[] links() {
    return new int[0];
  }

  /** As {@link ClosureRows#addSupport}. */
  void addSupport(BitSet ways, BitSet loaded, BitSet velocities) {}

  abstract void addRow(TreeMotion motion, double factor, double[] rows, int at);

  abstract void addForce(double force, double[] wrench, double[] tau);

  void accepted() {}

  /**
   * Adds the derivatives, by the poses of bodies, of the loads that a force on this coordinate
   * exerts.
   */
  void linearise(double force, ForceJacobian sink) {}

  /**
   * Adds the derivatives for a force on this coordinate equal to a stiffness times the change of
   * another.
   */
  void linearise(double stiffness, CouplingLeaf by, ForceJacobian sink) {
    if (stiffness == 0 || size() == 0 || by.size() == 0) {
      return;
    }
    if (by instanceof TreeLeaf tree) {
      byCoordinate(stiffness, tree.velocity, sink);
    } else if (by instanceof PairLeaf pair) {
      pair.formWrenches();
      byLink(stiffness, pair.relative.linkA(), pair.wrenchA, sink);
      byLink(stiffness, pair.relative.linkB(), pair.wrenchB, sink);
    }
  }

  void byCoordinate(double stiffness, int velocity, ForceJacobian sink) {}

  void byLink(double stiffness, int link, double[] wrench, ForceJacobian sink) {}

  /**
   * @throws IllegalArgumentException if a coupling must not depend on this variable
   */
  static CouplingLeaf of(
      Expression leaf,
      String closure,
      TreeGeometry tree,
      double[] parameters,
      double length,
      CountedPositions counted) {
    if (leaf instanceof Expression.Time) {
      return new Given(-1, parameters);
    }
    if (leaf instanceof Expression.ParameterValue parameter) {
      return new Given(parameter.index(), parameters);
    }
    if (leaf instanceof Expression.CoordinatePosition position) {
      return of(position.coordinate(), closure, tree, length, counted);
    }
    if (leaf instanceof Expression.PointPosition point) {
      return new PairLeaf(PointCoordinate.of(tree, point), length, counted);
    }
    throw new IllegalArgumentException(
        "constraint " + closure + " relates positions; it must not contain " + leaf);
  }

  private static CouplingLeaf of(
      Coordinate coordinate,
      String closure,
      TreeGeometry tree,
      double length,
      CountedPositions counted) {
    if (coordinate instanceof JointCoordinate joint) {
      return new TreeLeaf(joint, closure, tree, length);
    }
    ClosureCoordinate cut = (ClosureCoordinate) coordinate;
    LoopClosure named = tree.mechanism().closures().get(cut.closure());
    if (named instanceof JointClosure joint && !joint.joint().type().hasEulerParameters()) {
      return new PairLeaf(new CutJoint(tree, joint.joint()), cut.component(), length, counted);
    }
    throw new IllegalArgumentException(
        "constraint " + closure + " cannot relate coordinates of " + named.name());
  }

  /** Time, or a parameter. */
  private static final class Given extends CouplingLeaf {
    private final int parameter;
    private final double[] parameters;

    Given(int parameter, double[] parameters) {
      this.parameter = parameter;
      this.parameters = parameters;
    }

    @Override
    double value(TreeMotion motion, double t) {
      return parameter < 0 ? t : parameters[parameter];
    }

    @Override
    double rate(TreeMotion motion) {
      return parameter < 0 ? 1 : 0;
    }

    @Override
    double acceleration(TreeMotion motion) {
      return 0;
    }

    @Override
    double size() {
      return 0;
    }

    @Override
    void addRow(TreeMotion motion, double factor, double[] rows, int at) {}

    @Override
    void addForce(double force, double[] wrench, double[] tau) {}
  }
}
