package org.mechservice.solver.analysis;

import java.util.Arrays;
import java.util.Optional;
import org.mechservice.solver.analysis.equation.EquationsOfMotion;
import org.mechservice.solver.analysis.equation.FreeDirections;
import org.mechservice.solver.api.capability.Defects.Defect;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.force.user.UserForceSource;
import org.mechservice.solver.linear.spectrum.SingularValues;
import org.mechservice.solver.mechanism.Mechanism;

/**
 * Joint forces of a given motion in addition to the applied ones: Rᵀ τ = Rᵀ (M a + b − τ_applied),
 * with R the free directions of the loops. They are unique for a tree; with loops they are those of
 * least norm in the given coordinates, with forces multiplied by the mechanism's length. Workspace
 * of one thread.
 */
public final class InverseDynamics {
  /** Singular values below this fraction of the largest are taken as zero. */
  private static final double NEGLIGIBLE = 1e-10;

  private final EquationsOfMotion equations;

  /**
   * @param userForces creates the user forces
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
   * @return the reason of a failure: a force has no value, or forces in these coordinates cannot
   *     produce the motion; empty if the forces were found
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
