package org.mechservice.sim.equations.links;

import java.util.ArrayList;
import java.util.List;
import org.mechservice.solver.spatial.Rotation;
import org.mechservice.solver.spatial.Vector3;
import org.mechservice.solver.symbol.Expressions;
import org.mechservice.solver.symbol.Scalar;
import org.mechservice.solver.symbol.ScalarMatrix;
import org.mechservice.solver.symbol.ScalarVector;

/**
 * A constant rotation from child to parent axes, factored for few operations: a signed permutation
 * of the axes, which needs no operation, followed by rotations about coordinate axes. One such
 * rotation suffices for a rotation about a coordinate axis, three for any rotation.
 *
 * @param permuted signed permutation from child axes to the first intermediate axes
 * @param turns the rotations that follow, in order
 */
public record AxesChange(Rotation permuted, List<Turn> turns) {
  /**
   * A rotation about a coordinate axis.
   *
   * @param axis 0, 1, 2 for x, y, z
   * @param cosine of its angle
   * @param sine of its angle
   */
  record Turn(int axis, double cosine, double sine) {
    boolean isNone() {
      return cosine > 0 && Math.abs(sine) <= Axes.ROUNDING;
    }
  }

  /** Factors a rotation; elements that differ from 0 or ±1 only by rounding become exact. */
  static AxesChange of(Rotation childToParent) {
    Rotation rotation = Axes.snapped(childToParent);
    for (Rotation permutation : Axes.permutations()) {
      if (Axes.isSame(permutation, rotation)) {
        return new AxesChange(permutation, List.of());
      }
    }
    if (!hasCoordinateAxis(rotation)) {
      return new AxesChange(Rotation.IDENTITY, eulerTurns(rotation));
    }
    for (Rotation permutation : Axes.permutations()) {
      double[][] turned = Axes.elements(rotation.times(permutation.transposed()));
      for (int axis = 0; axis < 3; axis++) {
        if (keeps(turned, axis)) {
          int i = (axis + 1) % 3;
          Turn turn = new Turn(axis, turned[i][i], turned[(axis + 2) % 3][i]);
          return new AxesChange(permutation, turn.isNone() ? List.of() : List.of(turn));
        }
      }
    }
    return new AxesChange(Rotation.IDENTITY, eulerTurns(rotation));
  }

  /** Returns whether a rotation maps a coordinate axis to a coordinate axis. */
  private static boolean hasCoordinateAxis(Rotation rotation) {
    for (double[] row : Axes.elements(rotation)) {
      for (double element : row) {
        if (Math.abs(element) == 1) {
          return true;
        }
      }
    }
    return false;
  }

  /** Returns whether a rotation turns about a coordinate axis. */
  private static boolean keeps(double[][] r, int axis) {
    int i = (axis + 1) % 3;
    int j = (axis + 2) % 3;
    double across = Math.abs(r[axis][i]) + Math.abs(r[axis][j]);
    double down = Math.abs(r[i][axis]) + Math.abs(r[j][axis]);
    return r[axis][axis] > 0 && across + down <= 4 * Axes.ROUNDING;
  }

  /**
   * Returns the factors R = Rot(z, a) Rot(x, b) Rot(z, c), with c computed first and a from the
   * remainder, so that their sum is accurate for small b; rotations by zero are omitted.
   */
  private static List<Turn> eulerTurns(Rotation rotation) {
    double[][] r = Axes.elements(rotation);
    double sinB = Math.hypot(r[2][0], r[2][1]);
    Turn first = new Turn(2, r[2][1] / sinB, r[2][0] / sinB);
    Rotation back = Axes.turn(2, first.cosine(), -first.sine());
    double[][] rest = Axes.elements(rotation.times(back));
    double norm = Math.hypot(rest[0][0], rest[1][0]);
    Turn second = new Turn(0, r[2][2], sinB);
    Turn third = new Turn(2, rest[0][0] / norm, rest[1][0] / norm);
    List<Turn> turns = new ArrayList<>();
    for (Turn turn : List.of(first, second, third)) {
      if (!turn.isNone()) {
        turns.add(turn);
      }
    }
    return turns;
  }

  /** Returns parent components of a vector given in child components. */
  public ScalarVector toParent(ScalarVector v) {
    ScalarVector turned = permutation(v.x().expressions()).times(v);
    for (Turn turn : turns) {
      turned = turned.turned(turn.axis(), constant(v, turn.cosine()), constant(v, turn.sine()));
    }
    return turned;
  }

  /** Returns child components of a vector given in parent components. */
  public ScalarVector toChild(ScalarVector v) {
    ScalarVector turned = v;
    for (int i = turns.size() - 1; i >= 0; i--) {
      Turn turn = turns.get(i);
      turned = turned.turned(turn.axis(), constant(v, turn.cosine()), constant(v, -turn.sine()));
    }
    return matrix(v.x().expressions(), permuted.transposed()).times(turned);
  }

  /** Returns R · m · Rᵀ. */
  public ScalarMatrix toParent(ScalarMatrix m) {
    Expressions expressions = m.at(0, 0).expressions();
    ScalarMatrix permutation = permutation(expressions);
    ScalarMatrix back = matrix(expressions, permuted.transposed());
    ScalarMatrix turned = permutation.times(m).times(back);
    for (Turn turn : turns) {
      turned =
          turned.turned(
              turn.axis(), expressions.constant(turn.cosine()), expressions.constant(turn.sine()));
    }
    return turned;
  }

  /** Returns the rotation as a matrix. */
  public Rotation rotation() {
    Rotation rotation = permuted;
    for (Turn turn : turns) {
      rotation = Axes.turn(turn.axis(), turn.cosine(), turn.sine()).times(rotation);
    }
    return rotation;
  }

  private ScalarMatrix permutation(Expressions expressions) {
    return matrix(expressions, permuted);
  }

  private static ScalarMatrix matrix(Expressions expressions, Rotation r) {
    ScalarVector x = ScalarVector.of(expressions, new Vector3(r.xx(), r.xy(), r.xz()));
    ScalarVector y = ScalarVector.of(expressions, new Vector3(r.yx(), r.yy(), r.yz()));
    ScalarVector z = ScalarVector.of(expressions, new Vector3(r.zx(), r.zy(), r.zz()));
    return new ScalarMatrix(List.of(x.x(), x.y(), x.z(), y.x(), y.y(), y.z(), z.x(), z.y(), z.z()));
  }

  private static Scalar constant(ScalarVector v, double value) {
    return v.x().expressions().constant(value);
  }
}
