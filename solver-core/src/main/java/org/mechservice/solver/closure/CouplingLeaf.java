package org.mechservice.solver.closure;

import org.mechservice.solver.expression.ClosureCoordinate;
import org.mechservice.solver.expression.Coordinate;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.expression.JointCoordinate;
import org.mechservice.solver.kinematics.LinkKind;
import org.mechservice.solver.kinematics.TreeGeometry;
import org.mechservice.solver.kinematics.TreeMotion;
import org.mechservice.solver.kinematics.pair.CutJoint;
import org.mechservice.solver.kinematics.pair.PairFunction;
import org.mechservice.solver.mechanism.closure.JointClosure;
import org.mechservice.solver.mechanism.closure.LoopClosure;

/** What a relation between coordinates depends on. Workspace of one thread. */
abstract class CouplingLeaf {
  /** Returns the value; of a cut joint's coordinate this places it as well. */
  abstract double value(TreeMotion motion, double t);

  abstract double rate(TreeMotion motion);

  abstract double acceleration(TreeMotion motion);

  /** Returns the size of what it measures: m, or 1 rad; 0 of what does not move. */
  abstract double size();

  abstract void addRow(TreeMotion motion, double factor, double[] rows, int at);

  abstract void addForce(double force, double[] wrench, double[] tau);

  void accepted() {}

  /**
   * @throws IllegalArgumentException if a relation must not depend on this
   */
  static CouplingLeaf of(
      Expression leaf, String closure, TreeGeometry tree, double[] parameters, double length) {
    if (leaf instanceof Expression.Time) {
      return new Given(-1, parameters);
    }
    if (leaf instanceof Expression.ParameterValue parameter) {
      return new Given(parameter.index(), parameters);
    }
    if (leaf instanceof Expression.CoordinatePosition position) {
      return of(position.coordinate(), closure, tree, length);
    }
    throw new IllegalArgumentException(
        "constraint " + closure + " relates joint positions; it must not contain " + leaf);
  }

  private static CouplingLeaf of(
      Coordinate coordinate, String closure, TreeGeometry tree, double length) {
    if (coordinate instanceof JointCoordinate joint) {
      return new OfTree(joint, closure, tree, length);
    }
    ClosureCoordinate cut = (ClosureCoordinate) coordinate;
    LoopClosure named = tree.mechanism().closures().get(cut.closure());
    if (named instanceof JointClosure joint && !joint.joint().type().hasEulerParameters()) {
      return new OfCut(new CutJoint(tree, joint.joint()), cut.component(), length);
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

  /** A position of a joint of the tree, driven or not. */
  private static final class OfTree extends CouplingLeaf {
    private final int position;
    private final int velocity;
    private final double size;

    OfTree(JointCoordinate coordinate, String closure, TreeGeometry tree, double length) {
      int first = Integer.MAX_VALUE;
      for (int link = 0; link < tree.linkCount; link++) {
        if (tree.joint[link] == coordinate.joint() && tree.kind[link] != LinkKind.FIXED) {
          first = Math.min(first, tree.positionAt[link]);
        }
      }
      position = first + coordinate.component();
      int found = -1;
      for (int link = 0; link < tree.linkCount; link++) {
        boolean simple = tree.kind[link] != LinkKind.FIXED && tree.kind[link] != LinkKind.BALL;
        if (simple && tree.joint[link] == coordinate.joint() && tree.positionAt[link] == position) {
          found = link;
        }
      }
      if (found < 0) {
        throw new IllegalArgumentException(
            "constraint " + closure + " cannot relate Euler parameters");
      }
      velocity = tree.velocityAt[found];
      size = tree.kind[found] == LinkKind.SLIDE ? length : 1;
    }

    @Override
    double value(TreeMotion motion, double t) {
      return motion.q[position];
    }

    @Override
    double rate(TreeMotion motion) {
      return motion.v[velocity];
    }

    @Override
    double acceleration(TreeMotion motion) {
      return motion.a[velocity];
    }

    @Override
    double size() {
      return size;
    }

    @Override
    void addRow(TreeMotion motion, double factor, double[] rows, int at) {
      rows[at + velocity] += factor;
    }

    @Override
    void addForce(double force, double[] wrench, double[] tau) {
      tau[velocity] += force;
    }
  }

  /** A position of a cut joint; an angle goes on counting when it has made half a turn. */
  private static final class OfCut extends CouplingLeaf {
    private final CutJoint cut;
    private final PairFunction function;
    private final double size;

    /** Value at the last accepted step: the nearest whole turn to it is meant. */
    private double reference;

    private double value;

    OfCut(CutJoint cut, int component, double length) {
      this.cut = cut;
      function = cut.coordinate(component);
      double[] start = new double[cut.joint().type().positionCount()];
      cut.joint().initialPositions(start, 0);
      reference = start[component];
      size = cut.joint().type().positionUnit(component).equals("m") ? length : 1;
    }

    @Override
    double value(TreeMotion motion, double t) {
      cut.relative().place(motion);
      double found = function.evaluate(cut.relative());
      value = reference + function.difference(found, reference);
      return value;
    }

    @Override
    double rate(TreeMotion motion) {
      cut.relative().move(motion);
      return function.rate(cut.relative());
    }

    @Override
    double acceleration(TreeMotion motion) {
      cut.relative().accelerate(motion);
      return function.acceleration(cut.relative());
    }

    @Override
    double size() {
      return size;
    }

    @Override
    void addRow(TreeMotion motion, double factor, double[] rows, int at) {
      cut.relative().addRow(motion, function.gradient, factor, rows, at);
    }

    @Override
    void addForce(double force, double[] wrench, double[] tau) {
      cut.relative().addWrenches(function.gradient, force, wrench);
    }

    @Override
    void accepted() {
      reference = value;
    }
  }
}
