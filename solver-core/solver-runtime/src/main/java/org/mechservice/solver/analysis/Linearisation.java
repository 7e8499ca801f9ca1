package org.mechservice.solver.analysis;

import java.util.ArrayList;
import java.util.List;
import org.mechservice.solver.api.capability.Defects.Defect;
import org.mechservice.solver.dynamics.derivative.FurtherDerivatives;
import org.mechservice.solver.dynamics.derivative.ResidualJacobian;
import org.mechservice.solver.dynamics.recursion.MassiveRods;
import org.mechservice.solver.dynamics.tree.TreePattern;
import org.mechservice.solver.force.ForceSet;
import org.mechservice.solver.force.formula.FurtherRates;
import org.mechservice.solver.linear.DenseLu;
import org.mechservice.solver.linear.LinearSolver;
import org.mechservice.solver.mechanism.FurtherState;

/**
 * Small motions about a state, in the free directions of the loops:
 *
 * <pre>
 * M z'' + C z' + K z = 0,  ξ = R z
 * K = Rᵀ (∂F/∂q R + ∂F/∂v V + M A_q),  C = Rᵀ (∂F/∂v R + M A_v),  F = M v' + b − τ + Jᵀ λ
 * </pre>
 *
 * <p>ξ is a small displacement of each velocity's coordinate: a rotation in the axes of body 1 for
 * Euler parameters. The derivatives of F are analytic, with constant λ; V, A_q and A_v are those of
 * {@link LoopVariations}. With further states s there are f + ns equations,
 *
 * <pre>M z'' + C z' + K z + B s = 0,  s' + C_s z' + K_s z + D s = 0</pre>
 *
 * <p>At an equilibrium the equations describe the motions near it; at another state they describe
 * the differences between neighbouring motions at that time.
 */
final class Linearisation {
  private final EquationsOfMotion equations;
  private final FreeDirections free;
  private final int n;
  private final int f;

  /** M, C and K, f × f row by row. */
  final double[] mass;

  final double[] damping;
  final double[] stiffness;

  /** Turning of small rotations with the angular velocity of Euler parameters, f × f. */
  private final double[] turning;

  /** Change of the velocities by displacements z with constant independent velocities, n × f. */
  private final double[] velocityByPlace;

  /** Number of further states. */
  private final int ns;

  /** B, f × ns. */
  final double[] byState;

  /** C_s and K_s, ns × f, and D, ns × ns: what follows from the derivatives of the states. */
  final double[] rateDamping;

  final double[] rateStiffness;
  final double[] rateByState;

  /**
   * Linearises.
   *
   * @param equations placed by this constructor
   * @param t time, s
   * @param y state that closes the loops; not modified
   * @param a accelerations that fit the state; not modified
   * @throws NotLinearised if a force has no derivative there
   */
  Linearisation(EquationsOfMotion equations, double t, double[] y, double[] a)
      throws NotLinearised {
    this.equations = equations;
    n = equations.nv;
    equations.place(t, y);
    free = new FreeDirections(equations);
    f = free.freedom();
    LoopVariations loops = new LoopVariations(equations, free, t, y, a);
    velocityByPlace = loops.velocityByPlace;
    equations.place(t, y);
    require(equations.applyForces(t));
    equations.formResidual(a, 0);
    equations.balance();
    ResidualJacobian jacobian =
        new ResidualJacobian(equations.motion, new TreePattern(equations.tree, couplings()));
    jacobian.evaluate(equations.loadedWrench);
    require(equations.forces.linearise(t, jacobian.forces()) == ForceSet.REGULAR);
    equations.loops.linearise(equations.lambda, -1, jacobian.forces());
    jacobian.finish();
    double[] m = new double[n * n];
    double[] c = new double[n * n];
    double[] k = new double[n * n];
    jacobian.mass().toDense(m);
    jacobian.byVelocity().toDense(c);
    jacobian.byPosition().toDense(k);
    mass = free.reduce(m, free.r);
    damping = sum(free.reduce(c, free.r), free.reduce(m, loops.accelerationByVelocity));
    stiffness =
        sum(
            sum(free.reduce(k, free.r), free.reduce(c, loops.velocityByPlace)),
            free.reduce(m, loops.accelerationByPlace));
    ns = equations.tree.mechanism().furtherStates().size();
    byState = new double[f * ns];
    rateDamping = new double[ns * f];
    rateStiffness = new double[ns * f];
    rateByState = new double[ns * ns];
    if (ns > 0) {
      lineariseFurther(t, y, loops);
    }
    turning = turning();
  }

  /** Reduces the derivatives that further states add to the free directions. */
  private void lineariseFurther(double t, double[] y, LoopVariations loops) {
    FurtherDerivatives further = new FurtherDerivatives(equations.nq, n, ns);
    further.evaluate(
        equations.motion,
        equations.forces,
        new FurtherRates(equations.motion),
        equations.coordinates,
        t,
        y);
    double[] column = new double[n];
    double[] reduced = new double[f];
    for (int k = 0; k < ns; k++) {
      for (int i = 0; i < n; i++) {
        column[i] = further.forces[i * ns + k];
      }
      free.project(column, reduced);
      for (int j = 0; j < f; j++) {
        byState[j * ns + k] = reduced[j];
        double damping = 0;
        double stiffness = 0;
        for (int i = 0; i < n; i++) {
          double direction = free.r[i * f + j];
          damping -= further.byVelocity[k * n + i] * direction;
          stiffness -= further.byPlace[k * n + i] * direction;
          stiffness -= further.byVelocity[k * n + i] * loops.velocityByPlace[i * f + j];
        }
        rateDamping[k * f + j] = damping;
        rateStiffness[k * f + j] = stiffness;
      }
      for (int l = 0; l < ns; l++) {
        rateByState[k * ns + l] = -further.byState[k * ns + l];
      }
    }
  }

  private void require(boolean fine) throws NotLinearised {
    if (!fine) {
      throw new NotLinearised(equations.defect());
    }
  }

  /** Thrown if a force has no value or derivative at the state. */
  static final class NotLinearised extends Exception {
    private static final long serialVersionUID = 1L;

    private final transient Defect defect;

    NotLinearised(Defect defect) {
      super(defect.cause());
      this.defect = defect;
    }

    Defect defect() {
      return defect;
    }
  }

  private int[] couplings() {
    List<Integer> links = new ArrayList<>();
    equations.forces.couplings(
        (on, by) -> {
          links.add(on);
          links.add(by);
        });
    equations.loops.couplings(
        (on, by) -> {
          links.add(on);
          links.add(by);
        });
    for (int link : new MassiveRods(equations.tree).pairs()) {
      links.add(link);
    }
    return links.stream().mapToInt(Integer::intValue).toArray();
  }

  private static double[] sum(double[] a, double[] b) {
    for (int i = 0; i < a.length; i++) {
      a[i] += b[i];
    }
    return a;
  }

  /** Returns the independent part of G R: ξ' = δv + ω × ξ for rotations. */
  private double[] turning() {
    double[] rows = new double[f * f];
    for (int ball = 0; ball < equations.coordinates.ballCount(); ball++) {
      int at = equations.coordinates.ballVelocity(ball);
      for (int i = 0; i < f; i++) {
        int axis = free.independent[i] - at;
        if (axis >= 0 && axis < 3) {
          int next = (axis + 1) % 3;
          int last = (axis + 2) % 3;
          for (int j = 0; j < f; j++) {
            rows[i * f + j] =
                equations.motion.v[at + next] * free.r[(at + last) * f + j]
                    - equations.motion.v[at + last] * free.r[(at + next) * f + j];
          }
        }
      }
    }
    return rows;
  }

  /** Returns the number of freedoms f. */
  int freedom() {
    return f;
  }

  /** Returns the velocities of the state that are independent, one per freedom. */
  int[] independent() {
    return free.independent;
  }

  /** Writes ξ = R z. */
  void expand(double[] z, double[] xi) {
    free.expand(z, xi);
  }

  /** Writes Rᵀ x. */
  void project(double[] x, double[] reduced) {
    free.project(x, reduced);
  }

  /** Writes the change of the velocities by a displacement with constant independent velocities. */
  void velocityByPlace(int freedom, double[] change) {
    for (int i = 0; i < n; i++) {
      change[i] = velocityByPlace[i * f + freedom];
    }
  }

  /** Returns the number of further states. */
  int furtherCount() {
    return ns;
  }

  /** Returns the number of further states that change, which are those that are not held. */
  int changingCount() {
    int count = 0;
    for (FurtherState state : equations.tree.mechanism().furtherStates()) {
      count += state.role() == FurtherState.Role.INTEGRATED ? 1 : 0;
    }
    return count;
  }

  /**
   * Returns the part of a system that changes, without the further states that are held.
   *
   * @param system as {@link #system} returned it, not empty; not modified
   */
  double[] changing(double[] system) {
    int all = 2 * f + ns;
    int size = 2 * f + changingCount();
    int[] kept = new int[size];
    int next = 0;
    for (int i = 0; i < all; i++) {
      if (i < 2 * f
          || equations.tree.mechanism().furtherStates().get(i - 2 * f).role()
              == FurtherState.Role.INTEGRATED) {
        kept[next++] = i;
      }
    }
    double[] part = new double[size * size];
    for (int i = 0; i < size; i++) {
      for (int j = 0; j < size; j++) {
        part[i * size + j] = system[kept[i] * all + kept[j]];
      }
    }
    return part;
  }

  /** Returns A of [z; v_I; s]' = A [z; v_I; s], square and row by row; empty if M is singular. */
  double[] system() {
    DenseLu lu = new DenseLu(f);
    if (lu.factor(mass) != LinearSolver.NONSINGULAR) {
      return new double[0];
    }
    int size = 2 * f + ns;
    double[] a = new double[size * size];
    double[] column = new double[f];
    for (int j = 0; j < 2 * f; j++) {
      double[] source = j < f ? stiffness : damping;
      for (int i = 0; i < f; i++) {
        column[i] = -source[i * f + j % f];
        a[i * size + j] = j < f ? turning[i * f + j] : i == j - f ? 1 : 0;
      }
      lu.solve(column);
      for (int i = 0; i < f; i++) {
        a[(f + i) * size + j] = column[i];
      }
      for (int k = 0; k < ns; k++) {
        a[(2 * f + k) * size + j] = -(j < f ? rateStiffness : rateDamping)[k * f + j % f];
      }
    }
    for (int k = 0; k < ns; k++) {
      for (int i = 0; i < f; i++) {
        column[i] = -byState[i * ns + k];
      }
      lu.solve(column);
      for (int i = 0; i < f; i++) {
        a[(f + i) * size + 2 * f + k] = column[i];
      }
      for (int l = 0; l < ns; l++) {
        a[(2 * f + l) * size + 2 * f + k] = -rateByState[l * ns + k];
      }
    }
    return a;
  }
}
