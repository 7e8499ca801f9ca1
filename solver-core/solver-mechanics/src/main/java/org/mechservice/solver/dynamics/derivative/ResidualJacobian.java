package org.mechservice.solver.dynamics.derivative;

import static org.mechservice.solver.spatial.Blocks.addCross;
import static org.mechservice.solver.spatial.Blocks.apply;
import static org.mechservice.solver.spatial.Blocks.dot;

import java.util.Arrays;
import org.mechservice.solver.dynamics.recursion.CompositeInertias;
import org.mechservice.solver.dynamics.recursion.LinkDerivatives;
import org.mechservice.solver.dynamics.recursion.LinkInertias;
import org.mechservice.solver.dynamics.recursion.MassiveRods;
import org.mechservice.solver.dynamics.recursion.NewtonEuler;
import org.mechservice.solver.dynamics.recursion.RodDerivatives;
import org.mechservice.solver.dynamics.tree.BallColumns;
import org.mechservice.solver.dynamics.tree.TreeMatrix;
import org.mechservice.solver.dynamics.tree.TreePattern;
import org.mechservice.solver.dynamics.tree.TreeSquare;
import org.mechservice.solver.force.applied.ForceJacobian;
import org.mechservice.solver.kinematics.TreeGeometry;
import org.mechservice.solver.kinematics.TreeMotion;

/**
 * RR-JF: the derivatives of the residual M(q) a + b(q, v) − τ − Jᵀ w by a, v and q, each between a
 * joint and its ancestors, O(n · depth).
 *
 * <p>With ψ' = V_p × S, ψ'' = A_p × S + V_p × ψ' and S' = V × S of each velocity's column (V_p, A_p
 * velocity and acceleration of the parent, gravity included), and Iᶜ, 2Bᶜ, fᶜ the inertia, its
 * derivative by velocity and the force of a link with all beyond it, for j on the way from k to the
 * root (Singh, Russell and Wensing 2022; Carpentier and Mansard 2018):
 *
 * <pre>
 * M_jk = S_jᵀ Iᶜ S_k
 * ∂F_j/∂v_k = S_jᵀ (2Bᶜ S_k + Iᶜ (ψ'_k + S'_k))      ∂F_k/∂v_j = S_kᵀ (2Bᶜ S_j + Iᶜ (ψ'_j + S'_j))
 * ∂F_j/∂q_k = S_jᵀ (2Bᶜ ψ'_k + Iᶜ ψ''_k + S_k ×* fᶜ)  ∂F_k/∂q_j = S_kᵀ (2Bᶜ ψ'_j + Iᶜ ψ''_j)
 * </pre>
 *
 * with Iᶜ, 2Bᶜ and fᶜ of the link of k. These hold for columns fixed in the moving link. The
 * angular velocity of a ball is given in the axes of the file's body 1; where that is the parent,
 * the columns do not turn with the link, and ∂F/∂q of its three columns gets ∂F/∂v [ω]× + M [ω']×,
 * its own rows less [Sᵀ fᶜ]×. ∂/∂q by Euler parameters is meant along the tangent: by a small
 * rotation in the axes of body 1 (docs/theory/motion.md#positions).
 *
 * <p>External wrenches are held constant in the axes of their links, and joint forces constant; the
 * caller adds their derivatives through {@link #forces}. Workspace of one thread.
 */
public final class ResidualJacobian implements StepDerivatives {
  private final TreeGeometry tree;
  private final TreePattern pattern;
  private final TreeMotion motion;
  private final CompositeInertias composites;
  private final VelocityDerivatives changes;
  private final NewtonEuler newtonEuler;
  private final BallColumns balls;
  private final MassiveRods rods;
  private final RodDerivatives rodEnds;
  private final LinkDerivatives links;
  private final ForceDerivatives forces;

  /** External wrenches and those of rods, 6 per link. */
  private final double[] loads;

  private final TreeMatrix mass;
  private final TreeSquare byVelocity;
  private final TreeSquare byPosition;
  private final double[] residual;
  private final double[] noForces;

  private final MotionColumns columns;
  private final double[] first;
  private final double[] second;
  private final double[] both;

  /** Values carried towards the root: Iᶜ S, the wrenches of ∂/∂v and ∂/∂q, and (2Bᶜ)ᵀ S. */
  private final double[] inertiaWrench = new double[6];

  private final double[] velocityWrench = new double[6];
  private final double[] positionWrench = new double[6];
  private final double[] changeMoment = new double[3];
  private final double[] work = new double[6];

  /** Whether the last evaluation included all derivatives. */
  private boolean full;

  /**
   * Makes a workspace.
   *
   * @param motion swept by the caller, with accelerations, before each evaluation
   * @param pattern of the same tree, with room for its rods and forces
   */
  public ResidualJacobian(TreeMotion motion, TreePattern pattern) {
    this.motion = motion;
    this.pattern = pattern;
    tree = motion.tree();
    LinkInertias inertias = new LinkInertias(tree);
    composites = new CompositeInertias(motion, inertias);
    changes = new VelocityDerivatives(motion, inertias);
    newtonEuler = new NewtonEuler(motion, inertias);
    balls = BallColumns.inParentAxes(tree, pattern);
    mass = new TreeMatrix(pattern);
    byVelocity = new TreeSquare(pattern);
    byPosition = new TreeSquare(pattern);
    residual = new double[tree.velocityCount];
    noForces = new double[tree.velocityCount];
    columns = new MotionColumns(motion, newtonEuler);
    first = columns.first;
    second = columns.second;
    both = columns.both;
    rods = new MassiveRods(tree);
    loads = new double[6 * tree.linkCount];
    rodEnds = new RodDerivatives(motion, newtonEuler);
    links = new LinkDerivatives(motion, byPosition, byVelocity, first, second, both);
    forces = new ForceDerivatives(links, tree.stateVelocityCount);
  }

  /**
   * Returns the sink for the derivatives of applied forces, for use between {@link #evaluate} or
   * {@link #evaluateMass} and {@link #finish}.
   */
  @Override
  public ForceJacobian forces() {
    return forces;
  }

  /** Returns M as evaluated last. */
  public TreeMatrix mass() {
    return mass;
  }

  /** Returns ∂F/∂v as evaluated last. */
  public TreeSquare byVelocity() {
    return byVelocity;
  }

  /** Returns ∂F/∂q along the tangent as evaluated last. */
  public TreeSquare byPosition() {
    return byPosition;
  }

  /**
   * Evaluates M alone and sets the other derivatives to zero, for the mode in which only forces
   * contribute to the Jacobian.
   */
  public void evaluateMass() {
    evaluateNothing();
    composites.formMass(pattern, mass);
    rods.addMass(motion, mass);
  }

  /**
   * Sets all derivatives and M to zero, for the derivatives of forces alone. Accelerations need not
   * be swept.
   */
  public void evaluateNothing() {
    clear();
    full = false;
    for (int link = 0; link < tree.linkCount; link++) {
      columns.form(link);
    }
  }

  private void setMass(int place, int j) {
    double value = dot6(motion.subspace, 6 * j, inertiaWrench);
    int other = pattern.placeOf[j];
    if (other == place) {
      mass.setDiagonal(place, value + tree.armature[j]);
    } else {
      mass.setElement(pattern.find(place, other), value);
    }
  }

  private void clear() {
    mass.clear();
    byVelocity.clear();
    byPosition.clear();
  }

  /**
   * Evaluates all three derivatives for the motion of the last sweeps, without those of forces;
   * {@link #finish} completes them.
   *
   * @param wrench external wrenches, 6 per link, or empty; not modified
   */
  @Override
  public void evaluate(double[] wrench) {
    composites.compose();
    changes.compose();
    Arrays.fill(loads, 0);
    System.arraycopy(wrench, 0, loads, 0, wrench.length);
    rods.addForces(motion, loads);
    newtonEuler.evaluate(loads, noForces, residual);
    clear();
    full = true;
    for (int link = 0; link < tree.linkCount; link++) {
      columns.form(link);
    }
    for (int place = 0; place < pattern.size; place++) {
      formRowAndColumn(place);
    }
    rods.addMass(motion, mass);
    rods.addDerivatives(rodEnds, links);
  }

  /**
   * Completes ∂F/∂q for balls whose velocities are given in the axes of the parent, after
   * everything else has been added to the derivatives.
   */
  @Override
  public void finish() {
    for (int ball = 0; ball < balls.count(); ball++) {
      int k = balls.velocity(ball);
      balls.add(ball, byPosition, byVelocity, 0, 1, motion.v, k);
      if (full) {
        balls.add(ball, byPosition, mass, 0, 1, motion.a, k);
        turnForce(k);
      }
    }
  }

  /** Adds −[F]×: element (c+1, c+2) of [F]× is −F_c. */
  private void turnForce(int k) {
    for (int c = 0; c < 3; c++) {
      int next = k + (c + 1) % 3;
      int last = k + (c + 2) % 3;
      byPosition.add(next, last, residual[k + c]);
      byPosition.add(last, next, -residual[k + c]);
    }
  }

  /**
   * Copies complete derivatives from generated code.
   *
   * @param dense M, of which the lower triangle and the diagonal are read, ∂F/∂v and ∂F/∂q, each
   *     row by row in the order of the state; not modified
   */
  public void take(double[] dense) {
    int square = pattern.size * pattern.size;
    mass.take(dense, 0);
    byVelocity.take(dense, square);
    byPosition.take(dense, 2 * square);
  }

  /** Returns whether all derivatives are finite. */
  @Override
  public boolean isFinite() {
    return byPosition.isFinite() && byVelocity.isFinite();
  }

  private void formRowAndColumn(int place) {
    int k = pattern.velocityAt[place];
    int link = tree.linkOfVelocity[k];
    double[] s = motion.subspace;
    composites.applyTo(link, s, 6 * k, inertiaWrench, 0);
    composites.applyTo(link, both, 6 * k, velocityWrench, 0);
    changes.addApplied(link, s, 6 * k, velocityWrench, 0);
    composites.applyTo(link, second, 6 * k, positionWrench, 0);
    changes.addApplied(link, first, 6 * k, positionWrench, 0);
    changes.applyTransposedTo(link, s, 6 * k, changeMoment, 0);
    formInLink(place, k, link);
    addForceTurned(s, 6 * k, newtonEuler.force, 6 * link, positionWrench, 0);
    for (int i = link; tree.parent[i] != TreeGeometry.ROOT; i = tree.parent[i]) {
      motion.wrenches.toParent(i, inertiaWrench, 0);
      motion.wrenches.toParent(i, velocityWrench, 0);
      motion.wrenches.toParent(i, positionWrench, 0);
      apply(motion.rotation, 9 * i, changeMoment, 0, work, 0);
      System.arraycopy(work, 0, changeMoment, 0, 3);
      if (!tree.driven[tree.parent[i]]) {
        formWithAncestor(place, tree.parent[i]);
      }
    }
  }

  /** The velocities of one link move together with it. */
  private void formInLink(int place, int k, int link) {
    int end = tree.velocityAt[link] + tree.kind[link].velocityCount();
    for (int j = tree.velocityAt[link]; j < end; j++) {
      if (j <= k) {
        setMass(place, j);
      }
      byVelocity.add(j, k, dot6(motion.subspace, 6 * j, velocityWrench));
      byPosition.add(j, k, dot6(motion.subspace, 6 * j, positionWrench));
    }
  }

  private void formWithAncestor(int place, int ancestor) {
    double[] s = motion.subspace;
    int end = tree.velocityAt[ancestor] + tree.kind[ancestor].velocityCount();
    for (int j = tree.velocityAt[ancestor]; j < end; j++) {
      int e = pattern.find(place, pattern.placeOf[j]);
      mass.setElement(e, dot6(s, 6 * j, inertiaWrench));
      byVelocity.upper[e] = dot6(s, 6 * j, velocityWrench);
      byVelocity.lower[e] = dot6(both, 6 * j, inertiaWrench) + dot(s, 6 * j, changeMoment, 0);
      byPosition.upper[e] = dot6(s, 6 * j, positionWrench);
      byPosition.lower[e] = dot6(second, 6 * j, inertiaWrench) + dot(first, 6 * j, changeMoment, 0);
    }
  }

  /** out += S ×* f = [ω × n + u × l; ω × l]. */
  static void addForceTurned(double[] s, int is, double[] f, int at, double[] out, int to) {
    addCross(s, is, f, at, out, to);
    addCross(s, is + 3, f, at + 3, out, to);
    addCross(s, is, f, at + 3, out, to + 3);
  }

  private static double dot6(double[] columns, int at, double[] wrench) {
    return dot(columns, at, wrench, 0) + dot(columns, at + 3, wrench, 3);
  }
}
