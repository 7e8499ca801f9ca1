package org.mechservice.solver.symbol;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;

/**
 * A 3 × 3 matrix of scalars. A symmetric one has the same node on both sides of its diagonal, so no
 * element is computed twice.
 *
 * @param rows the elements, row by row
 */
public record ScalarMatrix(List<Scalar> rows) {
  /** A function of row and column that returns an element. */
  @FunctionalInterface
  public interface Element {
    /** Returns element (i, j). */
    Scalar at(int i, int j);
  }

  public ScalarMatrix {
    rows = List.copyOf(rows);
  }

  /** Returns the matrix of the given elements. */
  public static ScalarMatrix of(Element element) {
    List<Scalar> rows = new ArrayList<>(9);
    for (int i = 0; i < 3; i++) {
      for (int j = 0; j < 3; j++) {
        rows.add(element.at(i, j));
      }
    }
    return new ScalarMatrix(rows);
  }

  /** Returns the symmetric matrix whose upper triangle holds the given elements. */
  public static ScalarMatrix symmetric(Element upper) {
    List<Scalar> rows = new ArrayList<>(9);
    for (int i = 0; i < 3; i++) {
      for (int j = 0; j < 3; j++) {
        rows.add(j < i ? rows.get(3 * j + i) : upper.at(i, j));
      }
    }
    return new ScalarMatrix(rows);
  }

  /** Returns the matrix with zeros everywhere. */
  public static ScalarMatrix zero(Expressions expressions) {
    return new ScalarMatrix(Collections.nCopies(9, expressions.zero()));
  }

  /** Returns element (i, j). */
  public Scalar at(int i, int j) {
    return rows.get(3 * i + j);
  }

  /** Returns row {@code i}. */
  public ScalarVector row(int i) {
    return new ScalarVector(at(i, 0), at(i, 1), at(i, 2));
  }

  /** Returns column {@code j}. */
  public ScalarVector column(int j) {
    return new ScalarVector(at(0, j), at(1, j), at(2, j));
  }

  /** Returns the transpose. */
  public ScalarMatrix transposed() {
    List<Scalar> columns = new ArrayList<>(9);
    for (int j = 0; j < 3; j++) {
      for (int i = 0; i < 3; i++) {
        columns.add(at(i, j));
      }
    }
    return new ScalarMatrix(columns);
  }

  /** Returns whether opposite elements are the same expressions. */
  private boolean isSymmetric() {
    return at(0, 1) == at(1, 0) && at(0, 2) == at(2, 0) && at(1, 2) == at(2, 1);
  }

  /** Returns r · this · rᵀ; of a symmetric matrix only one side is computed. */
  public ScalarMatrix in(ScalarMatrix r) {
    ScalarMatrix half = r.times(this);
    return isSymmetric()
        ? symmetric((i, j) -> half.row(i).dot(r.row(j)))
        : of((i, j) -> half.row(i).dot(r.row(j)));
  }

  /** Returns this + other. */
  public ScalarMatrix plus(ScalarMatrix other) {
    List<Scalar> sums = new ArrayList<>(9);
    for (int i = 0; i < 9; i++) {
      sums.add(rows.get(i).plus(other.rows.get(i)));
    }
    return new ScalarMatrix(sums);
  }

  /** Returns this · v. */
  public ScalarVector times(ScalarVector v) {
    return new ScalarVector(row(0).dot(v), row(1).dot(v), row(2).dot(v));
  }

  /** Returns [v]×, the matrix whose product with u is v × u. */
  public static ScalarMatrix cross(ScalarVector v) {
    Scalar zero = v.x().expressions().zero();
    return new ScalarMatrix(
        List.of(
            zero,
            v.z().negated(),
            v.y(),
            v.z(),
            zero,
            v.x().negated(),
            v.y().negated(),
            v.x(),
            zero));
  }

  /** Returns this · other. */
  public ScalarMatrix times(ScalarMatrix other) {
    return of((i, j) -> row(i).dot(other.column(j)));
  }

  /**
   * Returns R · this · Rᵀ with R = Rot(axis, angle).
   *
   * <p>The block across the axis turns with four multiplications: with g = s (Hii − Hjj) + c (Hij +
   * Hji) it becomes Hii − s g, Hjj + s g, c g − Hji, c g − Hij.
   *
   * @param axis 0, 1, 2 for x, y, z
   * @param cosine of the angle
   * @param sine of the angle
   */
  public ScalarMatrix turned(int axis, Scalar cosine, Scalar sine) {
    int i = (axis + 1) % 3;
    int j = (axis + 2) % 3;
    Scalar sum =
        at(i, j) == at(j, i)
            ? cosine.times(2).times(at(i, j))
            : cosine.times(at(i, j).plus(at(j, i)));
    Scalar g = sine.times(at(i, i).minus(at(j, j))).plus(sum);
    Scalar sg = sine.times(g);
    Scalar cg = cosine.times(g);
    ScalarVector column = column(axis).turned(axis, cosine, sine);
    ScalarVector row = row(axis).turned(axis, cosine, sine);
    List<Scalar> turned = new ArrayList<>(rows);
    turned.set(3 * i + i, at(i, i).minus(sg));
    turned.set(3 * j + j, at(j, j).plus(sg));
    turned.set(3 * i + j, cg.minus(at(j, i)));
    turned.set(3 * j + i, cg.minus(at(i, j)));
    turned.set(3 * i + axis, column.at(i));
    turned.set(3 * j + axis, column.at(j));
    turned.set(3 * axis + i, row.at(i));
    turned.set(3 * axis + j, row.at(j));
    return new ScalarMatrix(turned);
  }
}
