package org.mechservice.solver.dynamics.derivative;

import java.util.List;
import org.mechservice.solver.api.run.RunNotes;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.dynamics.tree.BallColumns;
import org.mechservice.solver.dynamics.tree.TreeElements;
import org.mechservice.solver.dynamics.tree.TreeLu;
import org.mechservice.solver.dynamics.tree.TreePattern;
import org.mechservice.solver.dynamics.tree.TreeSquare;
import org.mechservice.solver.kinematics.StateCoordinates;
import org.mechservice.solver.kinematics.TreeGeometry;
import org.mechservice.solver.spatial.EulerParameters;

/**
 * The linear equations of an implicit step on F = [q' − N(q) v; M v' + b − τ], reduced from [q; v]
 * to v (NUMERICS §2). Workspace of one thread.
 *
 * <p>With K, C, M the derivatives of the second part, G = ∂(N v)/∂q and hγ from the integrator:
 *
 * <pre>
 * (M + hγ C + hγ² K (1 − hγ G)⁻¹ N) Δv = r_v − hγ K (1 − hγ G)⁻¹ r_q
 * Δq = (1 − hγ G)⁻¹ (r_q + hγ N Δv)
 * </pre>
 *
 * <p>G is zero but for Euler parameters, where G² = −¼|ω|² 1: there, along the tangent, the columns
 * of K become K (hγ² 1 + ½ hγ³ [ω]×) / (1 + ¼ hγ² |ω|²), exactly.
 */
public final class TreeIteration {
  private final StateCoordinates coordinates;
  private final TreeElements mass;
  private final TreeSquare byVelocity;
  private final TreeSquare byPosition;
  private final BallColumns balls;
  private final TreeSquare matrix;
  private final TreeLu lu;

  /** State of the derivatives. */
  private final double[] q;

  private final double[] v;

  /** (1 − hγ G)⁻¹ r_q along the tangent, and the right-hand side; nv numbers. */
  private final double[] tangent;

  private final double[] rightSide;
  private final double[] product = new double[4];
  private final double[] turned = new double[4];
  private double hGamma;

  /** M, and its factors, formed on first use after new derivatives. */
  private final TreeSquare inertia;

  private final TreeLu ofInertia;
  private boolean inertiaFactored;
  private boolean inertiaRegular;

  /** Velocity whose column had no pivot in the last factorisation. */
  private int singular;

  /** Makes a workspace for derivatives that are evaluated elsewhere. */
  public TreeIteration(TreeGeometry tree, TreePattern pattern, ResidualJacobian jacobian) {
    this(
        new StateCoordinates(tree.mechanism()),
        pattern,
        jacobian.mass(),
        jacobian.byVelocity(),
        jacobian.byPosition());
  }

  /**
   * Makes a workspace.
   *
   * @param mass M, evaluated elsewhere like the others
   * @param byVelocity C
   * @param byPosition K
   */
  public TreeIteration(
      StateCoordinates coordinates,
      TreePattern pattern,
      TreeElements mass,
      TreeSquare byVelocity,
      TreeSquare byPosition) {
    this.coordinates = coordinates;
    this.mass = mass;
    this.byVelocity = byVelocity;
    this.byPosition = byPosition;
    balls = BallColumns.all(coordinates, pattern);
    matrix = new TreeSquare(pattern);
    lu = new TreeLu(pattern);
    inertia = new TreeSquare(pattern);
    ofInertia = new TreeLu(pattern);
    q = new double[coordinates.positionCount()];
    v = new double[coordinates.velocityCount()];
    tangent = new double[v.length];
    rightSide = new double[v.length];
  }

  /** Sets the state of the derivatives: y = [q; v], not modified. */
  public void setState(double[] y) {
    System.arraycopy(y, 0, q, 0, q.length);
    System.arraycopy(y, q.length, v, 0, v.length);
    inertiaFactored = false;
  }

  /** Returns notes on the factorisations so far. */
  public List<RunNotes.Note> notes() {
    long dense = lu.denseFactorizations();
    String text =
        dense
            + " iteration matrices lost digits when eliminated along the tree and were factored"
            + " with interchanges instead.";
    return dense == 0
        ? List.of()
        : List.of(new RunNotes.Note(MessageCode.DENSE_FACTORISATION, 0, false, text));
  }

  /** Returns the n × n matrix formed last. */
  public TreeSquare matrix() {
    return matrix;
  }

  /**
   * Forms and factors the n × n matrix.
   *
   * @param hGamma hγ, s
   * @return whether it is regular
   */
  public boolean factor(double hGamma) {
    form(hGamma);
    singular = lu.factor(matrix);
    return singular == TreeLu.NONSINGULAR;
  }

  /** Returns the unknown whose column had no pivot in the last, failed factorisation. */
  public int singularUnknown() {
    return q.length + singular;
  }

  /**
   * Forms the n × n matrix without factoring it, for callers that project it first.
   *
   * @param hGamma hγ, s
   */
  public void form(double hGamma) {
    this.hGamma = hGamma;
    combine(matrix.diagonal, mass.diagonal(), byVelocity.diagonal, byPosition.diagonal);
    combine(matrix.lower, mass.lower(), byVelocity.lower, byPosition.lower);
    combine(matrix.upper, mass.upper(), byVelocity.upper, byPosition.upper);
    for (int ball = 0; ball < balls.count(); ball++) {
      int k = balls.velocity(ball);
      double shrunk = shrunk(k);
      double square = hGamma * hGamma;
      balls.add(
          ball, matrix, byPosition, square * (shrunk - 1), 0.5 * square * hGamma * shrunk, v, k);
    }
  }

  /** M + hγ C + hγ² K. */
  private void combine(double[] sum, double[] m, double[] c, double[] k) {
    for (int i = 0; i < sum.length; i++) {
      sum[i] = m[i] + hGamma * (c[i] + hGamma * k[i]);
    }
  }

  /** 1 / (1 + ¼ hγ² |ω|²). */
  private double shrunk(int k) {
    double square = v[k] * v[k] + v[k + 1] * v[k + 1] + v[k + 2] * v[k + 2];
    return 1 / (1 + 0.25 * hGamma * hGamma * square);
  }

  /**
   * Solves for [Δq; Δv] with the last factors.
   *
   * @param r [r_q; r_v] at entry, [Δq; Δv] at return
   */
  public void solve(double[] r) {
    lu.solve(reduce(r));
    expand(r);
  }

  /**
   * Solves ∂F/∂y' [Δq'; Δv'] = r, that is M Δv' = r_v; the factors of the last matrix stay.
   *
   * @param r right-hand side at entry, solution at return
   * @return false, with r as it was, if M is singular
   */
  public boolean solveForDerivative(double[] r) {
    if (!inertiaFactored) {
      System.arraycopy(mass.diagonal(), 0, inertia.diagonal, 0, inertia.diagonal.length);
      System.arraycopy(mass.lower(), 0, inertia.lower, 0, inertia.lower.length);
      System.arraycopy(mass.upper(), 0, inertia.upper, 0, inertia.upper.length);
      inertiaRegular = ofInertia.factor(inertia) == TreeLu.NONSINGULAR;
      inertiaFactored = true;
    }
    if (inertiaRegular) {
      System.arraycopy(r, q.length, rightSide, 0, v.length);
      ofInertia.solve(rightSide);
      System.arraycopy(rightSide, 0, r, q.length, v.length);
    }
    return inertiaRegular;
  }

  /**
   * Reduces the right-hand side to that of the n equations.
   *
   * @param r [r_q; r_v]; r_q overwritten, to be given to {@link #expand}
   * @return n numbers, which the solution Δv is to overwrite
   */
  public double[] reduce(double[] r) {
    int nq = q.length;
    for (int ball = 0; ball < coordinates.ballCount(); ball++) {
      turnBack(r, coordinates.ballPosition(ball), coordinates.ballVelocity(ball));
    }
    for (int i = 0; i < nq; i++) {
      int k = coordinates.velocityOf(i);
      if (k >= 0) {
        tangent[k] = r[i];
      }
    }
    System.arraycopy(r, nq, rightSide, 0, v.length);
    byPosition.addProduct(-hGamma, tangent, 0, rightSide, 0);
    return rightSide;
  }

  /** Returns (1 − hγ G)⁻¹ r_q along the tangent as {@link #reduce} formed it, nv numbers. */
  public double[] tangent() {
    return tangent;
  }

  /**
   * Completes the solution.
   *
   * @param r as {@link #reduce} left it at entry, [Δq; Δv] at return
   */
  public void expand(double[] r) {
    int nq = q.length;
    System.arraycopy(rightSide, 0, r, nq, v.length);
    for (int i = 0; i < nq; i++) {
      int k = coordinates.velocityOf(i);
      if (k >= 0) {
        r[i] += hGamma * rightSide[k];
      }
    }
    for (int ball = 0; ball < coordinates.ballCount(); ball++) {
      addTurn(r, coordinates.ballPosition(ball), coordinates.ballVelocity(ball));
    }
  }

  /**
   * Overwrites the residual of four Euler parameters by (1 − hγ G)⁻¹ of it, and writes the small
   * rotation that it is along the tangent, 2 vec(r ∘ e⁻¹).
   */
  private void turnBack(double[] r, int at, int k) {
    applyInverse(r, at, k);
    EulerParameters.rotation(q, at, r, tangent, k);
  }

  /** r ← (1 + hγ G) r / (1 + ¼ hγ² |ω|²), with G r = ½ (0, ω) ∘ r. */
  private void applyInverse(double[] r, int at, int k) {
    EulerParameters.rate(r, at, v, k, product, 0);
    double shrunk = shrunk(k);
    for (int i = 0; i < 4; i++) {
      r[at + i] = shrunk * (r[at + i] + hGamma * product[i]);
    }
  }

  /** Adds hγ (1 − hγ G)⁻¹ N Δω. */
  private void addTurn(double[] r, int at, int k) {
    EulerParameters.rate(q, at, rightSide, k, turned, 0);
    applyInverse(turned, 0, k);
    for (int i = 0; i < 4; i++) {
      r[at + i] += hGamma * turned[i];
    }
  }
}
