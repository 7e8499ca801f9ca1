package org.mechservice.solver.links;

import java.util.ArrayList;
import java.util.List;
import org.mechservice.solver.spatial.Rotation;
import org.mechservice.solver.spatial.Vector3;

/** Rotations between coordinate axes, with exact zeros and ones. */
public final class Axes {
  /**
   * Largest deviation of a direction cosine from 0 or ±1 that is removed: the rounding error of a
   * few products of rotations. The axes change by at most this angle, rad.
   */
  static final double ROUNDING = 1e-15;

  private static final List<Rotation> PERMUTATIONS = allPermutations();

  private Axes() {}

  /** Returns the 24 rotations that map coordinate axes to coordinate axes, the identity first. */
  static List<Rotation> permutations() {
    return PERMUTATIONS;
  }

  private static List<Rotation> allPermutations() {
    List<Rotation> all = new ArrayList<>();
    List<Vector3> directions = new ArrayList<>();
    for (double sign : new double[] {1, -1}) {
      directions.add(new Vector3(sign, 0, 0));
      directions.add(new Vector3(0, sign, 0));
      directions.add(new Vector3(0, 0, sign));
    }
    for (Vector3 x : directions) {
      for (Vector3 y : directions) {
        if (x.dot(y) == 0) {
          all.add(withoutNegativeZeros(Rotation.ofColumns(x, y, x.cross(y))));
        }
      }
    }
    return List.copyOf(all);
  }

  /** Returns the three cyclic changes of the axes, the identity first. */
  static List<Rotation> cyclicPermutations() {
    return List.of(
        Rotation.IDENTITY,
        new Rotation(0, 0, 1, 1, 0, 0, 0, 1, 0),
        new Rotation(0, 1, 0, 0, 0, 1, 1, 0, 0));
  }

  /** Returns Rot(axis, angle). */
  static Rotation turn(int axis, double cosine, double sine) {
    double[][] r = new double[3][3];
    int i = (axis + 1) % 3;
    int j = (axis + 2) % 3;
    r[axis][axis] = 1;
    r[i][i] = cosine;
    r[j][j] = cosine;
    r[i][j] = -sine;
    r[j][i] = sine;
    return of(r);
  }

  /**
   * Returns a rotation that maps a unit vector to the z axis, of at most two rotations about
   * coordinate axes.
   */
  static Rotation toZ(Vector3 direction) {
    Vector3 d = snapped(direction);
    double rho = Math.hypot(d.x(), d.y());
    if (rho == 0) {
      return d.z() > 0 ? Rotation.IDENTITY : turn(0, -1, 0);
    }
    double norm = Math.hypot(rho, d.z());
    Rotation intoXz = turn(2, d.x() / rho, -d.y() / rho);
    return turn(1, d.z() / norm, -rho / norm).times(intoXz);
  }

  /** Returns the vector with components replaced by 0 or ±1 if they differ only by rounding. */
  public static Vector3 snapped(Vector3 unit) {
    return new Vector3(snapped(unit.x()), snapped(unit.y()), snapped(unit.z()));
  }

  /** Returns the rotation with elements replaced by 0 or ±1 if they differ only by rounding. */
  public static Rotation snapped(Rotation r) {
    return new Rotation(
        snapped(r.xx()),
        snapped(r.xy()),
        snapped(r.xz()),
        snapped(r.yx()),
        snapped(r.yy()),
        snapped(r.yz()),
        snapped(r.zx()),
        snapped(r.zy()),
        snapped(r.zz()));
  }

  private static double snapped(double cosine) {
    double nearest = Math.rint(cosine);
    return Math.abs(cosine - nearest) <= ROUNDING ? nearest + 0.0 : cosine;
  }

  private static Rotation withoutNegativeZeros(Rotation r) {
    return snapped(r);
  }

  /**
   * Returns whether two rotations have the same elements. (Building a record's own {@code equals}
   * costs a fresh virtual machine more than all of this package's work on a small model.)
   */
  static boolean isSame(Rotation a, Rotation b) {
    return a.xx() == b.xx()
        && a.xy() == b.xy()
        && a.xz() == b.xz()
        && a.yx() == b.yx()
        && a.yy() == b.yy()
        && a.yz() == b.yz()
        && a.zx() == b.zx()
        && a.zy() == b.zy()
        && a.zz() == b.zz();
  }

  /** Returns the matrix of a rotation, row by row. */
  public static double[][] elements(Rotation r) {
    return new double[][] {
      {r.xx(), r.xy(), r.xz()}, {r.yx(), r.yy(), r.yz()}, {r.zx(), r.zy(), r.zz()}
    };
  }

  /** Returns the rotation of a matrix given row by row. */
  static Rotation of(double[][] r) {
    return new Rotation(
        r[0][0], r[0][1], r[0][2], r[1][0], r[1][1], r[1][2], r[2][0], r[2][1], r[2][2]);
  }
}
