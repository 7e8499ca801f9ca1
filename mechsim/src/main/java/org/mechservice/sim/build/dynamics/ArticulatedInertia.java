package org.mechservice.sim.build.dynamics;

import org.mechservice.sim.symbolic.Expressions;
import org.mechservice.sim.symbolic.Scalar;
import org.mechservice.sim.symbolic.ScalarMatrix;
import org.mechservice.sim.symbolic.ScalarVector;
import org.mechservice.solver.spatial.InertiaTensor;
import org.mechservice.solver.spatial.Vector3;

/**
 * What a body and all beyond it answer to an acceleration of the body's computing frame: moment n =
 * J α + H a about the origin and force f = Hᵀ α + M a.
 *
 * @param rotational J, symmetric, kg·m²
 * @param coupling H, kg·m
 * @param translational M, symmetric, kg
 */
record ArticulatedInertia(
    ScalarMatrix rotational, ScalarMatrix coupling, ScalarMatrix translational) {

  /** Returns the inertia of a link's own body: J about the origin, H = m [c]×, M = m 1. */
  static ArticulatedInertia of(Expressions expressions, Link link) {
    Vector3 c = link.centerOfMass();
    InertiaTensor own = Links.about(link.mass(), c, link.inertia());
    double[][] j = {
      {own.xx(), own.xy(), own.xz()}, {own.xy(), own.yy(), own.yz()}, {own.xz(), own.yz(), own.zz()}
    };
    return new ArticulatedInertia(
        ScalarMatrix.of((row, column) -> expressions.constant(j[row][column])),
        ScalarMatrix.cross(ScalarVector.of(expressions, c.times(link.mass()))),
        ScalarMatrix.of((row, column) -> expressions.constant(row == column ? link.mass() : 0)));
  }

  ArticulatedInertia plus(ArticulatedInertia other) {
    return new ArticulatedInertia(
        rotational.plus(other.rotational),
        coupling.plus(other.coupling),
        translational.plus(other.translational));
  }

  /** Returns the column along a joint's axis: the moment and force that turn or shift it. */
  Wrench along(boolean turns) {
    return turns
        ? new Wrench(rotational.column(2), coupling.row(2))
        : new Wrench(coupling.column(2), translational.column(2));
  }

  /**
   * Returns what remains when the joint gives way: I − U Uᵀ / D. The row and column along the axis
   * are zero.
   *
   * @param turns whether the joint turns about z or slides along it
   * @param column U
   * @param share U / D
   */
  ArticulatedInertia projected(boolean turns, Wrench column, Wrench share) {
    Scalar zero = rotational.at(0, 0).expressions().zero();
    ScalarVector n = column.moment();
    ScalarVector f = column.force();
    ScalarVector kn = share.moment();
    ScalarVector kf = share.force();
    return new ArticulatedInertia(
        ScalarMatrix.symmetric(
            (i, j) -> turns && j == 2 ? zero : rotational.at(i, j).minus(kn.at(i).times(n.at(j)))),
        ScalarMatrix.of(
            (i, j) ->
                (turns ? i == 2 : j == 2)
                    ? zero
                    : coupling.at(i, j).minus(kn.at(i).times(f.at(j)))),
        ScalarMatrix.symmetric(
            (i, j) ->
                !turns && j == 2 ? zero : translational.at(i, j).minus(kf.at(i).times(f.at(j)))));
  }

  /** Returns the same in axes turned back: R = Rot(axis, angle) takes this frame's axes there. */
  ArticulatedInertia turned(int axis, Scalar cosine, Scalar sine) {
    return new ArticulatedInertia(
        rotational.turned(axis, cosine, sine),
        coupling.turned(axis, cosine, sine),
        translational.turned(axis, cosine, sine));
  }

  /** Returns the same in parent axes. */
  ArticulatedInertia toParent(AxesChange axes) {
    return new ArticulatedInertia(
        axes.toParent(rotational), axes.toParent(coupling), axes.toParent(translational));
  }

  /**
   * Returns the same for a frame from which this one's origin lies at {@code r}: H' = H + [r]× M
   * and J' = J + [r]× H'ᵀ + ([r]× Hᵀ)ᵀ.
   */
  ArticulatedInertia shifted(ScalarVector r) {
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
