package org.mechservice.solver.step;

import org.mechservice.solver.symbol.Scalar;
import org.mechservice.solver.symbol.ScalarMatrix;
import org.mechservice.solver.symbol.ScalarVector;

/**
 * Articulated inertia of a body and all bodies beyond it: an acceleration of the body's computing
 * frame requires the moment n = J α + H a about the origin and the force f = Hᵀ α + M a.
 *
 * @param rotational J, symmetric, kg·m²
 * @param coupling H, kg·m
 * @param translational M, symmetric, kg
 */
public record ArticulatedInertia(
    ScalarMatrix rotational, ScalarMatrix coupling, ScalarMatrix translational)
    implements Moved<ArticulatedInertia> {

  public ArticulatedInertia plus(ArticulatedInertia other) {
    return new ArticulatedInertia(
        rotational.plus(other.rotational),
        coupling.plus(other.coupling),
        translational.plus(other.translational));
  }

  /** Returns I + k sᵀ for parallel wrenches k and s. */
  public ArticulatedInertia plusProduct(Wrench k, Wrench s) {
    return new ArticulatedInertia(
        ScalarMatrix.symmetric(
            (i, j) -> rotational.at(i, j).plus(s.moment().at(i).times(k.moment().at(j)))),
        ScalarMatrix.of((i, j) -> coupling.at(i, j).plus(s.moment().at(i).times(k.force().at(j)))),
        ScalarMatrix.symmetric(
            (i, j) -> translational.at(i, j).plus(s.force().at(i).times(k.force().at(j)))));
  }

  /** Returns the column of a degree of freedom: the moment and force of a unit acceleration. */
  public Wrench along(DegreeOfFreedom freedom) {
    int axis = freedom.axis();
    Wrench turning = new Wrench(rotational.column(axis), coupling.row(axis));
    if (!freedom.slides()) {
      return turning;
    }
    Wrench moving =
        new Wrench(coupling.column(axis), translational.column(axis)).times(freedom.way());
    return freedom.turns() ? turning.plus(moving) : moving;
  }

  /**
   * Returns I − U Uᵀ / D, the inertia after the elimination of a degree of freedom. The row and
   * column of a plain degree of freedom are zero.
   *
   * @param column U
   * @param share U / D
   */
  ArticulatedInertia projected(DegreeOfFreedom freedom, Wrench column, Wrench share) {
    Scalar zero = rotational.at(0, 0).expressions().zero();
    int axis = freedom.axis();
    boolean turned = freedom.isPlain() && freedom.turns();
    boolean moved = freedom.isPlain() && !freedom.turns();
    ScalarVector n = column.moment();
    ScalarVector f = column.force();
    ScalarVector kn = share.moment();
    ScalarVector kf = share.force();
    return new ArticulatedInertia(
        ScalarMatrix.symmetric(
            (i, j) ->
                turned && (i == axis || j == axis)
                    ? zero
                    : rotational.at(i, j).minus(kn.at(i).times(n.at(j)))),
        ScalarMatrix.of(
            (i, j) ->
                (turned && i == axis) || (moved && j == axis)
                    ? zero
                    : coupling.at(i, j).minus(kn.at(i).times(f.at(j)))),
        ScalarMatrix.symmetric(
            (i, j) ->
                moved && (i == axis || j == axis)
                    ? zero
                    : translational.at(i, j).minus(kf.at(i).times(f.at(j)))));
  }

  @Override
  public ArticulatedInertia in(ScalarMatrix rotation) {
    return new ArticulatedInertia(
        rotational.in(rotation), coupling.in(rotation), translational.in(rotation));
  }

  @Override
  public ArticulatedInertia turned(int axis, Scalar cosine, Scalar sine) {
    return new ArticulatedInertia(
        rotational.turned(axis, cosine, sine),
        coupling.turned(axis, cosine, sine),
        translational.turned(axis, cosine, sine));
  }

  /** {@inheritDoc} H' = H + [r]× M and J' = J + [r]× H'ᵀ + ([r]× Hᵀ)ᵀ. */
  @Override
  public ArticulatedInertia shifted(ScalarVector r) {
    ScalarMatrix h = coupling;
    ScalarMatrix moved = h.plus(ScalarMatrix.cross(r).times(translational));
    ScalarMatrix j =
        ScalarMatrix.symmetric(
            (row, column) ->
                row == column ? moment(r, moved, row) : product(r, moved, row, column));
    return new ArticulatedInertia(j, moved, translational);
  }

  /** J'ii = Jii + rj (H'ik + Hik) − rk (H'ij + Hij) with i, j, k cyclic. */
  private Scalar moment(ScalarVector r, ScalarMatrix moved, int i) {
    int j = (i + 1) % 3;
    int k = (i + 2) % 3;
    Scalar first = r.at(j).times(moved.at(i, k).plus(coupling.at(i, k)));
    Scalar second = r.at(k).times(moved.at(i, j).plus(coupling.at(i, j)));
    return rotational.at(i, i).plus(first.minus(second));
  }

  /** J'ij = Jij + rj H'jk − ri Hik + rk (Hii − H'jj) with i, j, k cyclic. */
  private Scalar product(ScalarVector r, ScalarMatrix moved, int row, int column) {
    boolean cyclic = (row + 1) % 3 == column;
    int i = cyclic ? row : column;
    int j = cyclic ? column : row;
    int k = 3 - i - j;
    Scalar across = r.at(j).times(moved.at(j, k)).minus(r.at(i).times(coupling.at(i, k)));
    Scalar along = r.at(k).times(coupling.at(i, i).minus(moved.at(j, j)));
    return rotational.at(i, j).plus(across.plus(along));
  }
}
