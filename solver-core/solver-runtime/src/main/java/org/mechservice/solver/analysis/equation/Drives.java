package org.mechservice.solver.analysis.equation;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import org.mechservice.solver.api.JointType;
import org.mechservice.solver.api.result.Variable;
import org.mechservice.solver.closure.equations.LoopEquations;
import org.mechservice.solver.closure.equations.PrescribedPairMotion;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.Parameter;
import org.mechservice.solver.mechanism.closure.JointClosure;
import org.mechservice.solver.mechanism.joint.Joint;

/**
 * The driven coordinates of a mechanism with their motion and their forces: those of the tree
 * first, then those of cut joints. A coordinate is a velocity with its acceleration and force, and
 * the positions that go with it: one, but all four Euler parameters with the first of the three
 * angular velocities of a ball, and none with the others.
 */
public final class Drives {
  private final EquationsOfMotion equations;
  private final List<Coordinate> coordinates = new ArrayList<>();
  private final List<PrescribedPairMotion> cutMotions = new ArrayList<>();

  /** First of the coordinates that belong to cut joints. */
  private final int inTree;

  /** Number of driven positions of the tree. */
  private int positionsInTree;

  /**
   * A driven coordinate: component {@code index} of {@code count} of a joint.
   *
   * @param place its first position among the driven ones of the tree
   */
  private record Coordinate(Joint joint, int index, int count, int place, Source source) {
    String name(String kind) {
      return joint.name() + kind + (count == 1 ? "" : "[" + index + "]");
    }

    boolean isBall() {
      return joint.type().hasEulerParameters();
    }

    int positions() {
      return isBall() && index < 3 ? (index == 0 ? 4 : 0) : 1;
    }

    /** Component of its first position. */
    int position() {
      return isBall() && index >= 3 ? index + 1 : index;
    }

    String positionName(int k) {
      return joint.name() + ".q" + (count == 1 ? "" : "[" + (position() + k) + "]");
    }
  }

  /**
   * Source of motion and force of a coordinate of a cut joint.
   *
   * @param motion index of its joint's motion
   * @param row equation of the loops whose multiplier is the opposite of its force
   */
  private record Source(int motion, int row) {
    static final Source TREE = new Source(-1, -1);
  }

  public Drives(EquationsOfMotion equations) {
    this.equations = equations;
    Mechanism mechanism = equations.tree.mechanism();
    for (int j = 0; j < mechanism.joints().size(); j++) {
      if (mechanism.isDriven(j)) {
        Joint joint = mechanism.joints().get(j);
        int count = joint.type().velocityCount();
        for (int i = 0; i < count; i++) {
          Coordinate next = new Coordinate(joint, i, count, positionsInTree, Source.TREE);
          coordinates.add(next);
          positionsInTree += next.positions();
        }
      }
    }
    inTree = coordinates.size();
    addCut(mechanism);
  }

  /** The equations of a cut joint's motion are the last of that joint. */
  private void addCut(Mechanism mechanism) {
    LoopEquations loops = equations.loops;
    double[] parameters = mechanism.parameters().stream().mapToDouble(Parameter::value).toArray();
    for (int row = 0; row < loops.count(); row++) {
      boolean last = row + 1 == loops.count() || loops.closure(row + 1) != loops.closure(row);
      if (last && loops.closure(row) instanceof JointClosure cut && cut.isDriven()) {
        int count = cut.motion().size();
        for (int i = 0; i < count; i++) {
          Source source = new Source(cutMotions.size(), row - (count - 1 - i));
          coordinates.add(new Coordinate(cut.joint(), i, count, -1, source));
        }
        cutMotions.add(new PrescribedPairMotion(cut.motion(), parameters));
      }
    }
  }

  /** Returns the number of driven coordinates. */
  public int count() {
    return coordinates.size();
  }

  /** Returns the columns of the positions that go with a coordinate. */
  public List<Variable> positions(int i) {
    Coordinate one = coordinates.get(i);
    return IntStream.range(0, one.positions())
        .mapToObj(k -> new Variable(one.positionName(k), type(i).positionUnit(one.position() + k)))
        .toList();
  }

  /** Returns the number of positions that go with a coordinate. */
  public int positionCount(int i) {
    return coordinates.get(i).positions();
  }

  /** Returns the column of its velocity; the next ones return those of the rest. */
  public Variable velocity(int i) {
    return new Variable(coordinates.get(i).name(".v"), type(i).velocityUnit(index(i)));
  }

  public Variable acceleration(int i) {
    String unit = type(i).velocityUnit(index(i)).replace("/s", "/s^2");
    return new Variable(coordinates.get(i).name(".a"), unit);
  }

  public Variable force(int i) {
    return new Variable(
        coordinates.get(i).name(".drive"), coordinates.get(i).joint().forceUnit(index(i)));
  }

  public Variable power(int i) {
    return new Variable(coordinates.get(i).name(".power"), "W");
  }

  private JointType type(int i) {
    return coordinates.get(i).joint().type();
  }

  private int index(int i) {
    return coordinates.get(i).index();
  }

  /** Returns whether the joint of a coordinate belongs to the tree; otherwise it is cut. */
  boolean isInTree(int i) {
    return i < inTree;
  }

  /** Returns the equation of the loops that moves a coordinate of a cut joint. */
  int row(int i) {
    return coordinates.get(i).source().row();
  }

  /** Returns the joint of a coordinate. */
  String joint(int i) {
    return coordinates.get(i).joint().name();
  }

  /** Returns whether a coordinate is a displacement; otherwise it is an angle. */
  boolean isDisplacement(int i) {
    return type(i).velocityUnit(index(i)).equals("m/s");
  }

  /** Evaluates the motions of cut joints; those of the tree are evaluated with its places. */
  public void evaluate(double t) {
    cutMotions.forEach(motion -> motion.evaluate(t));
  }

  /** Returns position {@code k} of those that go with a coordinate, rad, m or 1. */
  public double positionOf(int i, int k) {
    return i < inTree
        ? equations.motion.q[equations.nq + coordinates.get(i).place() + k]
        : cut(i).value(index(i));
  }

  /** Returns the velocity of a coordinate, rad/s or m/s. */
  public double velocityOf(int i) {
    return i < inTree ? equations.motion.v[equations.nv + i] : cut(i).rate(index(i));
  }

  /** Returns the acceleration of a coordinate, rad/s² or m/s². */
  public double accelerationOf(int i) {
    return i < inTree ? equations.motion.a[equations.nv + i] : cut(i).acceleration(index(i));
  }

  /** Returns the force in a coordinate of balanced equations, N·m or N. */
  public double forceOf(int i) {
    return i < inTree
        ? equations.residual[equations.nv + i]
        : 0 - equations.lambda[coordinates.get(i).source().row()];
  }

  private PrescribedPairMotion cut(int i) {
    return cutMotions.get(coordinates.get(i).source().motion());
  }
}
