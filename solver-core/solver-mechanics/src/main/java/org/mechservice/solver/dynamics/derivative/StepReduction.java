package org.mechservice.solver.dynamics.derivative;

import java.util.List;
import org.mechservice.solver.api.run.RunNotes;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.kinematics.StateCoordinates;
import org.mechservice.solver.spatial.EulerParameters;

/**
 * The linear equations of an implicit step on F = [q' − N(q) v; M v' + b − τ], reduced from [q; v]
 * to v (docs/theory/formulations.md#rr-jf-the-jacobian-by-recursion). Workspace of one thread.
 *
 * <p>With K, C, M the derivatives of the second part, G = ∂(N v)/∂q and hγ from the integrator:
 *
 * <pre>
 * (M + hγ C + hγ² K (1 − hγ G)⁻¹ N) Δv = r_v − hγ K (1 − hγ G)⁻¹ r_q
 * Δq = (1 − hγ G)⁻¹ (r_q + hγ N Δv)
 * </pre>
 *
 * <p>G is zero but for Euler parameters, where G² = −¼|ω|² 1: there, along the tangent, the columns
 * of K become K (hγ² 1 + ½ hγ³ [ω]×) / (1 + ¼ hγ² |ω|²), exactly. Subclasses keep the derivatives
 * and factor the matrix of the n equations.
 */
public abstract class StepReduction {
  final StateCoordinates coordinates;

  /** State of the derivatives. */
  final double[] q;

  final double[] v;

  /** (1 − hγ G)⁻¹ r_q along the tangent, and the right-hand side; nv numbers. */
  private final double[] tangent;

  private final double[] rightSide;
  private final double[] product = new double[4];
  private final double[] turned = new double[4];
  double hGamma;

  StepReduction(StateCoordinates coordinates) {
    this.coordinates = coordinates;
    q = new double[coordinates.positionCount()];
    v = new double[coordinates.velocityCount()];
    tangent = new double[v.length];
    rightSide = new double[v.length];
  }

  /** Sets the state of the derivatives: y = [q; v], not modified. */
  public void setState(double[] y) {
    System.arraycopy(y, 0, q, 0, q.length);
    System.arraycopy(y, q.length, v, 0, v.length);
  }

  /**
   * Forms and factors the n × n matrix.
   *
   * @param step hγ, s
   * @return whether it is regular
   */
  public abstract boolean factor(double step);

  /** Returns the unknown whose column had no pivot in the last, failed factorisation. */
  public abstract int singularUnknown();

  /** Returns notes on the factorisations so far. */
  public final List<RunNotes.Note> notes() {
    long dense = denseFactorizations();
    String text =
        dense
            + " iteration matrices lost digits when eliminated along the tree and were factored"
            + " with interchanges instead.";
    return dense == 0
        ? List.of()
        : List.of(new RunNotes.Note(MessageCode.DENSE_FACTORISATION, 0, false, text));
  }

  /** Returns how often a matrix was factored as a dense one. */
  abstract long denseFactorizations();

  /** Solves the n equations in place with the last factors. */
  public abstract void solveReduced(double[] b);

  /** Adds factor · K x to a vector, both of nv numbers. */
  abstract void addByPosition(double factor, double[] x, double[] sum);

  /**
   * Solves M x = b in place; the factors of the last matrix stay.
   *
   * @return false, with b as it was, if M is singular
   */
  abstract boolean solveInertia(double[] b);

  /** 1 / (1 + ¼ hγ² |ω|²). */
  final double shrunk(int k) {
    double square = v[k] * v[k] + v[k + 1] * v[k + 1] + v[k + 2] * v[k + 2];
    return 1 / (1 + 0.25 * hGamma * hGamma * square);
  }

  /**
   * Solves for [Δq; Δv] with the last factors.
   *
   * @param r [r_q; r_v] at entry, [Δq; Δv] at return
   */
  public final void solve(double[] r) {
    solveReduced(reduce(r));
    expand(r);
  }

  /**
   * Solves ∂F/∂y' [Δq'; Δv'] = r, that is M Δv' = r_v; the factors of the last matrix stay.
   *
   * @param r right-hand side at entry, solution at return
   * @return false, with r as it was, if M is singular
   */
  public final boolean solveForDerivative(double[] r) {
    System.arraycopy(r, q.length, rightSide, 0, v.length);
    boolean regular = solveInertia(rightSide);
    if (regular) {
      System.arraycopy(rightSide, 0, r, q.length, v.length);
    }
    return regular;
  }

  /**
   * Reduces the right-hand side to that of the n equations.
   *
   * @param r [r_q; r_v]; r_q overwritten, to be given to {@link #expand}
   * @return n numbers, which the solution Δv is to overwrite
   */
  public final double[] reduce(double[] r) {
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
    addByPosition(-hGamma, tangent, rightSide);
    return rightSide;
  }

  /** Returns (1 − hγ G)⁻¹ r_q along the tangent as {@link #reduce} formed it, nv numbers. */
  public final double[] tangent() {
    return tangent;
  }

  /**
   * Completes the solution.
   *
   * @param r as {@link #reduce} left it at entry, [Δq; Δv] at return
   */
  public final void expand(double[] r) {
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
