package org.mechservice.solver.dynamics.derivative;

import org.mechservice.solver.dynamics.tree.BallColumns;
import org.mechservice.solver.dynamics.tree.TreeElements;
import org.mechservice.solver.dynamics.tree.TreeLu;
import org.mechservice.solver.dynamics.tree.TreePattern;
import org.mechservice.solver.dynamics.tree.TreeSquare;
import org.mechservice.solver.kinematics.StateCoordinates;
import org.mechservice.solver.kinematics.TreeGeometry;

/**
 * The equations of an implicit step with their matrix formed, element by element, in the sparsity
 * of the tree, and factored along it. Workspace of one thread.
 */
public final class TreeIteration extends StepReduction {
  private final TreeElements mass;
  private final TreeSquare byVelocity;
  private final TreeSquare byPosition;
  private final BallColumns balls;
  private final TreeSquare matrix;
  private final TreeLu lu;

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
    super(coordinates);
    this.mass = mass;
    this.byVelocity = byVelocity;
    this.byPosition = byPosition;
    balls = BallColumns.all(coordinates, pattern);
    matrix = new TreeSquare(pattern);
    lu = new TreeLu(pattern);
    inertia = new TreeSquare(pattern);
    ofInertia = new TreeLu(pattern);
  }

  @Override
  public void setState(double[] y) {
    super.setState(y);
    inertiaFactored = false;
  }

  @Override
  long denseFactorizations() {
    return lu.denseFactorizations();
  }

  /** Returns the n × n matrix formed last. */
  public TreeSquare matrix() {
    return matrix;
  }

  @Override
  public boolean factor(double step) {
    form(step);
    singular = lu.factor(matrix);
    return singular == TreeLu.NONSINGULAR;
  }

  @Override
  public int singularUnknown() {
    return q.length + singular;
  }

  /**
   * Forms the n × n matrix without factoring it, for callers that project it first.
   *
   * @param step hγ, s
   */
  public void form(double step) {
    hGamma = step;
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

  @Override
  public void solveReduced(double[] b) {
    lu.solve(b);
  }

  @Override
  void addByPosition(double factor, double[] x, double[] sum) {
    byPosition.addProduct(factor, x, 0, sum, 0);
  }

  @Override
  boolean solveInertia(double[] b) {
    if (!inertiaFactored) {
      System.arraycopy(mass.diagonal(), 0, inertia.diagonal, 0, inertia.diagonal.length);
      System.arraycopy(mass.lower(), 0, inertia.lower, 0, inertia.lower.length);
      System.arraycopy(mass.upper(), 0, inertia.upper, 0, inertia.upper.length);
      inertiaRegular = ofInertia.factor(inertia) == TreeLu.NONSINGULAR;
      inertiaFactored = true;
    }
    if (inertiaRegular) {
      ofInertia.solve(b);
    }
    return inertiaRegular;
  }
}
