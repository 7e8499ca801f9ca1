package org.mechservice.solver.closure.equations;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;
import org.mechservice.solver.expression.ClosureCoordinate;
import org.mechservice.solver.expression.Coordinate;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.expression.Tape;
import org.mechservice.solver.kinematics.TreeGeometry;
import org.mechservice.solver.kinematics.TreeMotion;
import org.mechservice.solver.kinematics.pair.CutJoint;
import org.mechservice.solver.kinematics.pair.PairFunction;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.closure.CoordinateClosure;
import org.mechservice.solver.mechanism.closure.JointClosure;
import org.mechservice.solver.mechanism.closure.LoopClosure;
import org.mechservice.solver.mechanism.force.ForceElement;
import org.mechservice.solver.mechanism.force.JointSpringDamper;
import org.mechservice.solver.mechanism.joint.Joint;

/**
 * The angles of cut joints on which forces and couplings of a mechanism depend, rad. They are not
 * states: generated code computes them up to a whole turn and takes the turn nearest to the value
 * at the last accepted step. Workspace of one thread.
 */
public final class UnwrappedAngles {
  private final CutJoint[] joints;
  private final PairFunction[] functions;
  private final double[] starts;

  public UnwrappedAngles(TreeGeometry tree) {
    List<ClosureCoordinate> angles = of(tree.mechanism());
    joints = new CutJoint[angles.size()];
    functions = new PairFunction[angles.size()];
    starts = new double[angles.size()];
    for (int i = 0; i < angles.size(); i++) {
      int position = angles.get(i).component();
      Joint joint = joint(tree.mechanism(), angles.get(i));
      double[] start = new double[joint.type().positionCount()];
      joint.initialPositions(start, 0);
      joints[i] = new CutJoint(tree, joint);
      functions[i] = joints[i].coordinate(velocityOf(tree.mechanism(), angles.get(i)).component());
      starts[i] = start[position];
    }
  }

  /** Returns the positions that are such angles, in the order of the code's argument. */
  public static List<ClosureCoordinate> of(Mechanism mechanism) {
    List<Coordinate> positions = new ArrayList<>();
    List<Expression> formulas = new ArrayList<>();
    for (LoopClosure closure : mechanism.closures()) {
      if (closure instanceof CoordinateClosure relation) {
        formulas.add(relation.relation());
      }
    }
    for (ForceElement force : mechanism.forces()) {
      force.formulas().forEach(formula -> formulas.add(formula.expression()));
      if (force instanceof JointSpringDamper spring) {
        positions.add(spring.coordinate());
      }
    }
    mechanism.furtherStates().forEach(state -> formulas.add(state.derivative()));
    for (Expression leaf : new Tape(formulas).leaves()) {
      if (leaf instanceof Expression.CoordinatePosition position) {
        positions.add(position.coordinate());
      }
    }
    return positions.stream()
        .flatMap(
            position -> position instanceof ClosureCoordinate cut ? Stream.of(cut) : Stream.empty())
        .filter(cut -> isAngle(mechanism, cut))
        .distinct()
        .toList();
  }

  /** Returns whether a position of a cut joint is an angle, which is unwrapped. */
  public static boolean isAngle(Mechanism mechanism, ClosureCoordinate position) {
    return joint(mechanism, position).type().positionUnit(position.component()).equals("rad");
  }

  /** Returns the velocity of a position of a cut joint that is not an Euler parameter. */
  public static ClosureCoordinate velocityOf(Mechanism mechanism, ClosureCoordinate position) {
    Joint joint = joint(mechanism, position);
    int surplus = joint.type().positionCount() - joint.type().velocityCount();
    return new ClosureCoordinate(position.closure(), position.component() - surplus);
  }

  /**
   * Returns the cut joint that a coordinate belongs to.
   *
   * @throws IllegalArgumentException if the closure is no joint
   */
  public static Joint joint(Mechanism mechanism, ClosureCoordinate coordinate) {
    LoopClosure closure = mechanism.closures().get(coordinate.closure());
    if (closure instanceof JointClosure cut) {
      return cut.joint();
    }
    throw new IllegalArgumentException(closure.name() + " is no joint and has no coordinates");
  }

  public int count() {
    return joints.length;
  }

  /** Returns an array of a state followed by the start values of the angles. */
  public double[] behind(double[] state) {
    double[] all = Arrays.copyOf(state, state.length + starts.length);
    System.arraycopy(starts, 0, all, state.length, starts.length);
    return all;
  }

  /** Updates the angles, from an index of an array, to the last sweep. */
  public void follow(TreeMotion motion, double[] angles, int at) {
    for (int i = 0; i < joints.length; i++) {
      joints[i].relative().place(motion);
      double found = functions[i].evaluate(joints[i].relative());
      angles[at + i] += functions[i].difference(found, angles[at + i]);
    }
  }
}
