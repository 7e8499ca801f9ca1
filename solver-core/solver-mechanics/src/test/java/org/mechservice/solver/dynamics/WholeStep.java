package org.mechservice.solver.dynamics;

import org.apache.commons.math3.linear.LUDecomposition;
import org.apache.commons.math3.linear.MatrixUtils;
import org.apache.commons.math3.linear.RealMatrix;
import org.mechservice.solver.kinematics.StateCoordinates;
import org.mechservice.solver.spatial.EulerParameters;

/**
 * The whole matrix hγ ∂F/∂y + ∂F/∂y' of an implicit step on F = [q' − N(q) v; M v' + b − τ] in one
 * state y = [q; v], written down without any reduction.
 */
public final class WholeStep {
  private final StateCoordinates coordinates;
  private final double[] y;
  private final int nq;
  private final int nv;

  /** Takes the state at which the derivatives were taken. */
  public WholeStep(StateCoordinates coordinates, double[] y) {
    this.coordinates = coordinates;
    this.y = y;
    nq = coordinates.positionCount();
    nv = coordinates.velocityCount();
  }

  /** Returns a square matrix of the elements, row by row. */
  public static RealMatrix square(double[] elements, int n) {
    RealMatrix m = MatrixUtils.createRealMatrix(Math.max(1, n), Math.max(1, n));
    for (int i = 0; i < n; i++) {
      for (int j = 0; j < n; j++) {
        m.setEntry(i, j, elements[n * i + j]);
      }
    }
    return m;
  }

  /**
   * Returns the whole matrix.
   *
   * @param byVelocity C, n × n
   * @param byTangent K, by small moves along the tangent, n × n
   */
  public RealMatrix matrix(
      RealMatrix mass, RealMatrix byVelocity, RealMatrix byTangent, double hGamma) {
    RealMatrix a = MatrixUtils.createRealMatrix(Math.max(1, nq + nv), Math.max(1, nq + nv));
    RealMatrix k = byTangent.multiply(tangentOfPositions());
    for (int i = 0; i < nv; i++) {
      for (int j = 0; j < nq; j++) {
        a.setEntry(nq + i, j, hGamma * k.getEntry(i, j));
      }
      for (int j = 0; j < nv; j++) {
        a.setEntry(nq + i, nq + j, mass.getEntry(i, j) + hGamma * byVelocity.getEntry(i, j));
      }
    }
    RealMatrix g = rates(false);
    RealMatrix n = rates(true);
    for (int i = 0; i < nq; i++) {
      for (int j = 0; j < nq; j++) {
        a.setEntry(i, j, (i == j ? 1 : 0) - hGamma * g.getEntry(i, j));
      }
      for (int j = 0; j < nv; j++) {
        a.setEntry(i, nq + j, -hGamma * n.getEntry(i, j));
      }
    }
    return a;
  }

  /** Returns what is left for v of a matrix in [q; v] when q is eliminated. */
  public static RealMatrix schurComplement(RealMatrix whole, int nq) {
    int last = whole.getRowDimension() - 1;
    RealMatrix kqq = whole.getSubMatrix(0, nq - 1, 0, nq - 1);
    RealMatrix kqv = whole.getSubMatrix(0, nq - 1, nq, last);
    RealMatrix kvq = whole.getSubMatrix(nq, last, 0, nq - 1);
    RealMatrix kvv = whole.getSubMatrix(nq, last, nq, last);
    return kvv.subtract(kvq.multiply(new LUDecomposition(kqq).getSolver().solve(kqv)));
  }

  /** ∂(N v)/∂q, or N: both linear, so columns are images of unit vectors. */
  private RealMatrix rates(boolean byVelocity) {
    int columns = byVelocity ? nv : nq;
    RealMatrix m = MatrixUtils.createRealMatrix(Math.max(1, nq), Math.max(1, columns));
    double[] rate = new double[nq];
    double[] unit = new double[columns];
    for (int j = 0; j < columns; j++) {
      unit[j] = 1;
      if (byVelocity) {
        coordinates.rates(y, 0, unit, 0, rate, 0);
      } else {
        coordinates.rates(unit, 0, y, nq, rate, 0);
      }
      for (int i = 0; i < nq; i++) {
        boolean ofVelocity = coordinates.velocityOf(i) >= 0;
        m.setEntry(i, j, ofVelocity && !byVelocity ? 0 : rate[i]);
      }
      unit[j] = 0;
    }
    return m;
  }

  /** The small rotation that a change of Euler parameters is: 2 vec(de ∘ e⁻¹). */
  private RealMatrix tangentOfPositions() {
    RealMatrix t = MatrixUtils.createRealMatrix(Math.max(1, nv), Math.max(1, nq));
    for (int i = 0; i < nq; i++) {
      if (coordinates.velocityOf(i) >= 0) {
        t.setEntry(coordinates.velocityOf(i), i, 1);
      }
    }
    for (int ball = 0; ball < coordinates.ballCount(); ball++) {
      int p = coordinates.ballPosition(ball);
      int k = coordinates.ballVelocity(ball);
      double square = Math.pow(EulerParameters.norm(y, p), 2);
      // 4 Nᵀ / |e|², since N has orthogonal columns of length |e| / 2
      double[] rate = new double[4];
      for (int c = 0; c < 3; c++) {
        double[] unit = new double[3];
        unit[c] = 1;
        EulerParameters.rate(y, p, unit, 0, rate, 0);
        for (int i = 0; i < 4; i++) {
          t.setEntry(k + c, p + i, 4 * rate[i] / square);
        }
      }
    }
    return t;
  }
}
