package org.mechservice.solver.analysis.equation;

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
 * <p>Non-holonomic equations leave more freedoms to positions, ξ = R_q ζ, than to velocities, v = R
 * w + V ζ. The equations are then of first order in ζ:
 *
 * <pre>M w' + C w + K_q ζ = 0,  ζ' = [R w + V ζ] of the independent positions</pre>
 *
 * <p>with K_q as K, but with R_q in place of the right R. {@link #stiffness} remains that along the
 * free directions of velocities, in which a mechanism moves from rest.
 *
 * <p>At an equilibrium the equations describe the motions near it; at another state they describe
 * the differences between neighbouring motions at that time.
 */
public final class Linearisation {
  private final EquationsOfMotion equations;
  private final FreeDirections free;

  /** Directions of positions; those of velocities if all equations are holonomic. */
  private final FreeDirections places;

  private final LoopVariations loops;
  private final int n;
  private final int f;

  /** Number of freedoms of positions. */
  private final int fq;

  /** M, C and K, f × f row by row. */
  public final double[] mass;

  public final double[] damping;
  public final double[] stiffness;

  /** K_q, f × fq row by row. */
  public final double[] stiffnessOfPlaces;

  /** Turning of small rotations with the angular velocity of Euler parameters, fq × fq. */
  private final double[] turning;

  /** Number of further states. */
  private final int ns;

  /** B, f × ns. */
  public final double[] byState;

  /** C_s, ns × f, K_s, ns × fq, and D, ns × ns: what follows from the derivatives of the states. */
  public final double[] rateDamping;

  public final double[] rateStiffness;
  public final double[] rateByState;

  /**
   * Linearises.
   *
   * @param equations placed by this constructor
   * @param t time, s
   * @param y state that closes the loops; not modified
   * @param a accelerations that fit the state; not modified
   * @throws NotLinearised if a force has no derivative there
   */
  public Linearisation(EquationsOfMotion equations, double t, double[] y, double[] a)
      throws NotLinearised {
    this.equations = equations;
    n = equations.nv;
    equations.place(t, y);
    free = new FreeDirections(equations);
    f = free.freedom();
    places = equations.loops.isHolonomic() ? free : FreeDirections.ofPositions(equations);
    fq = places.freedom();
    loops = new LoopVariations(equations, free, places, t, y, a);
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
    mass = free.reduce(m, free);
    damping = free.reduce(c, free);
    stiffnessOfPlaces = free.reduce(k, places);
    if (loops.isMoving()) {
      add(damping, free.reduce(m, loops.accelerationByVelocity, f));
      add(stiffnessOfPlaces, free.reduce(c, loops.velocityByPlace, fq));
      add(stiffnessOfPlaces, free.reduce(m, loops.accelerationByPlace, fq));
    }
    stiffness = places == free ? stiffnessOfPlaces : free.reduce(k, free);
    ns = equations.tree.mechanism().furtherStates().size();
    byState = new double[f * ns];
    rateDamping = new double[ns * f];
    rateStiffness = new double[ns * fq];
    rateByState = new double[ns * ns];
    if (ns > 0) {
      lineariseFurther(t, y);
    }
    turning = turning();
  }

  /** Reduces the derivatives that further states add to the free directions. */
  private void lineariseFurther(double t, double[] y) {
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
        for (int i = 0; i < n; i++) {
          damping -= further.byVelocity[k * n + i] * free.r[i * f + j];
        }
        rateDamping[k * f + j] = damping;
      }
      for (int j = 0; j < fq; j++) {
        double stiffness = 0;
        for (int i = 0; i < n; i++) {
          stiffness -= further.byPlace[k * n + i] * places.r[i * fq + j];
          stiffness -= further.byVelocity[k * n + i] * loops.velocityByPlace[i * fq + j];
        }
        rateStiffness[k * fq + j] = stiffness;
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
  public static final class NotLinearised extends Exception {
    private static final long serialVersionUID = 1L;

    private final transient Defect defect;

    NotLinearised(Defect defect) {
      super(defect.cause());
      this.defect = defect;
    }

    public Defect defect() {
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

  private static void add(double[] sum, double[] further) {
    for (int i = 0; i < sum.length; i++) {
      sum[i] += further[i];
    }
  }

  /** Returns the independent part of G R: ξ' = δv + ω × ξ for rotations. */
  private double[] turning() {
    double[] rows = new double[fq * fq];
    for (int ball = 0; ball < equations.coordinates.ballCount(); ball++) {
      int at = equations.coordinates.ballVelocity(ball);
      for (int i = 0; i < fq; i++) {
        int axis = places.independent[i] - at;
        if (axis >= 0 && axis < 3) {
          int next = (axis + 1) % 3;
          int last = (axis + 2) % 3;
          for (int j = 0; j < fq; j++) {
            rows[i * fq + j] =
                equations.motion.v[at + next] * places.r[(at + last) * fq + j]
                    - equations.motion.v[at + last] * places.r[(at + next) * fq + j];
          }
        }
      }
    }
    return rows;
  }

  /** Returns the number of freedoms of velocities f. */
  public int freedom() {
    return f;
  }

  /** Returns the number of freedoms of positions, f if all equations of loops are holonomic. */
  public int placeFreedom() {
    return fq;
  }

  /** Returns the coordinates that are independent as positions, by their velocities. */
  public int[] independentPlaces() {
    return places.independent;
  }

  /** Writes the small displacements ξ = R_q ζ. */
  public void expandPlaces(double[] zeta, double[] xi) {
    places.expand(zeta, xi);
  }

  /** Returns the velocities of the state that are independent, one per freedom. */
  public int[] independent() {
    return free.independent;
  }

  /** Writes ξ = R z. */
  public void expand(double[] z, double[] xi) {
    free.expand(z, xi);
  }

  /** Writes Rᵀ x. */
  public void project(double[] x, double[] reduced) {
    free.project(x, reduced);
  }

  /** Writes the change of the velocities by a displacement with constant independent velocities. */
  public void velocityByPlace(int freedom, double[] change) {
    for (int i = 0; i < n; i++) {
      change[i] = loops.velocityByPlace[i * fq + freedom];
    }
  }

  /** Returns the number of further states. */
  public int furtherCount() {
    return ns;
  }

  /** Returns the number of further states that change, which are those that are not held. */
  public int changingCount() {
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
  public double[] changing(double[] system) {
    int all = order();
    int ofMotion = fq + f;
    int size = ofMotion + changingCount();
    int[] kept = new int[size];
    int next = 0;
    for (int i = 0; i < all; i++) {
      if (i < ofMotion
          || equations.tree.mechanism().furtherStates().get(i - ofMotion).role()
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

  /** Returns the number of rows of {@link #system}. */
  public int order() {
    return fq + f + ns;
  }

  /** Returns the number of freedoms of positions. */
  public int placeCount() {
    return fq;
  }

  /** Returns A of [ζ; w; s]' = A [ζ; w; s], square and row by row; empty if M is singular. */
  public double[] system() {
    DenseLu lu = new DenseLu(f);
    if (lu.factor(mass) != LinearSolver.NONSINGULAR) {
      return new double[0];
    }
    int size = order();
    double[] a = new double[size * size];
    double[] column = new double[f];
    for (int j = 0; j < fq + f; j++) {
      boolean ofPlace = j < fq;
      int at = ofPlace ? j : j - fq;
      int width = ofPlace ? fq : f;
      for (int i = 0; i < fq; i++) {
        int position = places.independent[i] * width + at;
        a[i * size + j] =
            ofPlace ? turning[i * fq + j] + loops.velocityByPlace[position] : free.r[position];
      }
      for (int i = 0; i < f; i++) {
        column[i] = -(ofPlace ? stiffnessOfPlaces : damping)[i * width + at];
      }
      lu.solve(column);
      for (int i = 0; i < f; i++) {
        a[(fq + i) * size + j] = column[i];
      }
      for (int k = 0; k < ns; k++) {
        a[(fq + f + k) * size + j] = -(ofPlace ? rateStiffness : rateDamping)[k * width + at];
      }
    }
    for (int k = 0; k < ns; k++) {
      for (int i = 0; i < f; i++) {
        column[i] = -byState[i * ns + k];
      }
      lu.solve(column);
      for (int i = 0; i < f; i++) {
        a[(fq + i) * size + fq + f + k] = column[i];
      }
      for (int l = 0; l < ns; l++) {
        a[(fq + f + l) * size + fq + f + k] = -rateByState[l * ns + k];
      }
    }
    return a;
  }
}
