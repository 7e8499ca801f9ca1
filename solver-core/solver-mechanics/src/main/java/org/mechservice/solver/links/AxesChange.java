package org.mechservice.solver.links;

import java.util.List;
import java.util.Optional;
import org.mechservice.solver.spatial.Rotation;
import org.mechservice.solver.spatial.Vector3;
import org.mechservice.solver.symbol.Expressions;
import org.mechservice.solver.symbol.Scalar;
import org.mechservice.solver.symbol.ScalarMatrix;
import org.mechservice.solver.symbol.ScalarVector;

/**
 * A constant rotation from child to parent axes, in the form that needs fewest operations: a
 * matrix, which needs none where it only exchanges axes, followed by a rotation about a coordinate
 * axis where such a one is the whole rest.
 *
 * @param matrix from child axes to the axes before the turn: a signed permutation if there is a
 *     turn
 * @param turn the rotation that follows, if there is one
 */
public record AxesChange(Rotation matrix, Optional<Turn> turn) {
  /**
   * A rotation about a coordinate axis.
   *
   * @param axis 0, 1, 2 for x, y, z
   * @param cosine of its angle
   * @param sine of its angle
   */
  public record Turn(int axis, double cosine, double sine) {
    boolean isNone() {
      return cosine > 0 && Math.abs(sine) <= Axes.ROUNDING;
    }
  }

  /** Factors a rotation; elements that differ from 0 or ±1 only by rounding become exact. */
  static AxesChange of(Rotation childToParent) {
    Rotation rotation = Axes.snapped(childToParent);
    if (isPermutation(rotation) || !hasCoordinateAxis(rotation)) {
      return new AxesChange(rotation, Optional.empty());
    }
    for (Rotation permutation : Axes.permutations()) {
      double[][] turned = Axes.elements(rotation.times(permutation.transposed()));
      for (int axis = 0; axis < 3; axis++) {
        if (keeps(turned, axis)) {
          int i = (axis + 1) % 3;
          Turn turn = new Turn(axis, turned[i][i], turned[(axis + 2) % 3][i]);
          return new AxesChange(permutation, turn.isNone() ? Optional.empty() : Optional.of(turn));
        }
      }
    }
    return new AxesChange(rotation, Optional.empty());
  }

  /** Returns whether every element of a rotation is 0 or ±1. */
  private static boolean isPermutation(Rotation r) {
    return isAxis(r.xx(), r.xy(), r.xz())
        && isAxis(r.yx(), r.yy(), r.yz())
        && isAxis(r.zx(), r.zy(), r.zz());
  }

  private static boolean isAxis(double x, double y, double z) {
    return isOne(x, y, z) && Math.abs(x) + Math.abs(y) + Math.abs(z) == 1;
  }

  private static boolean isOne(double x, double y, double z) {
    return Math.abs(x) == 1 || Math.abs(y) == 1 || Math.abs(z) == 1;
  }

  /** Returns whether it only exchanges axes, which needs no operation. */
  public boolean isPermutation() {
    return turn.isEmpty() && isPermutation(matrix);
  }

  /** Returns whether a rotation maps a coordinate axis to a coordinate axis. */
  private static boolean hasCoordinateAxis(Rotation r) {
    return isOne(r.xx(), r.xy(), r.xz())
        || isOne(r.yx(), r.yy(), r.yz())
        || isOne(r.zx(), r.zy(), r.zz());
  }

  /** Returns whether a rotation turns about a coordinate axis. */
  private static boolean keeps(double[][] r, int axis) {
    int i = (axis + 1) % 3;
    int j = (axis + 2) % 3;
    double across = Math.abs(r[axis][i]) + Math.abs(r[axis][j]);
    double down = Math.abs(r[i][axis]) + Math.abs(r[j][axis]);
    return r[axis][axis] > 0 && across + down <= 4 * Axes.ROUNDING;
  }

  /** Returns parent components of a vector given in child components. */
  public ScalarVector toParent(ScalarVector v) {
    ScalarVector before = matrix(v.x().expressions(), matrix).times(v);
    return turn.isEmpty() ? before : turned(before, turn.get().sine());
  }

  /** Returns child components of a vector given in parent components. */
  public ScalarVector toChild(ScalarVector v) {
    ScalarVector before = turn.isEmpty() ? v : turned(v, -turn.get().sine());
    return matrix(v.x().expressions(), matrix.transposed()).times(before);
  }

  private ScalarVector turned(ScalarVector v, double sine) {
    Turn by = turn.orElseThrow();
    return v.turned(by.axis(), constant(v, by.cosine()), constant(v, sine));
  }

  /** Returns R · m · Rᵀ. */
  public ScalarMatrix toParent(ScalarMatrix m) {
    Expressions e = m.at(0, 0).expressions();
    ScalarMatrix before = m.in(matrix(e, matrix));
    return turn.isEmpty()
        ? before
        : before.turned(
            turn.get().axis(), e.constant(turn.get().cosine()), e.constant(turn.get().sine()));
  }

  /** Returns the rotation as a matrix. */
  public Rotation rotation() {
    return turn.isEmpty()
        ? matrix
        : Axes.turn(turn.get().axis(), turn.get().cosine(), turn.get().sine()).times(matrix);
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
