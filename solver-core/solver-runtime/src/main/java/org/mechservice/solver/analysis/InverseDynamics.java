package org.mechservice.solver.analysis;

import java.util.Arrays;
import java.util.Optional;
import org.mechservice.solver.api.capability.Defects.Defect;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.force.user.UserForceSource;
import org.mechservice.solver.linear.SingularValues;
import org.mechservice.solver.mechanism.Mechanism;

/**
 * Joint forces that a motion takes beyond those applied: Rᵀ τ = Rᵀ (M a + b − τ_applied), R the
 * directions that loops leave free. On a tree there is one answer; on loops, the forces of least
 * norm among those that act in the coordinates given, forces being counted times the mechanism's
 * length. Workspace of one thread.
 */
public final class InverseDynamics {
  /** Singular values below this part of the largest are not divided by. */
  private static final double NEGLIGIBLE = 1e-10;

  private final EquationsOfMotion equations;

  /**
   * @param userForces makes the forces that users have written
   */
  public InverseDynamics(Mechanism mechanism, UserForceSource userForces) {
    equations = new EquationsOfMotion(mechanism, userForces);
  }

  /**
   * Finds the forces.
   *
   * @param t time, s
   * @param y state [q; v] that closes the loops; not modified
   * @param a accelerations that fit it, nv numbers, rad/s² or m/s²; not modified
   * @param at velocities of the state in whose coordinates forces act; not modified
   * @param tau nv numbers, N·m or N, zero where no force acts; overwritten
   * @return why there are none: a force has no value there, or those coordinates cannot drive the
   *     mechanism as wanted; empty if they were found
   */
  public Optional<Defect> forces(double t, double[] y, double[] a, int[] at, double[] tau) {
    equations.place(t, y);
    if (!equations.applyForces(t)) {
      return Optional.of(equations.defect());
    }
    equations.formResidual(a, 0);
    FreeDirections free = new FreeDirections(equations);
    int f = free.freedom();
    double[] wanted = new double[f];
    free.project(equations.residual, wanted);
    double[] matrix = new double[f * at.length];
    for (int i = 0; i < f; i++) {
      for (int j = 0; j < at.length; j++) {
        matrix[i * at.length + j] = free.r[at[j] * f + i] / equations.unit[at[j]];
      }
    }
    SingularValues singular = new SingularValues(f, at.length);
    singular.decompose(matrix);
    int rank = 0;
    while (rank < Math.min(f, at.length) && singular.value(rank) > NEGLIGIBLE * singular.value(0)) {
      rank++;
    }
    if (rank < f) {
      return Optional.of(tooFew(rank, f));
    }
    double[] found = new double[at.length];
    singular.solve(rank, wanted, found);
    Arrays.fill(tau, 0);
    for (int j = 0; j < at.length; j++) {
      tau[at[j]] = found[j] / equations.unit[at[j]];
    }
    return Optional.empty();
  }

  private static Defect tooFew(int rank, int freedom) {
    return new Defect(
        MessageCode.FORCES_CANNOT_DRIVE,
        "",
        "Forces in these coordinates drive " + rank + " of " + freedom + " degrees of freedom.",
        "Let forces act in further coordinates.");
  }
}
