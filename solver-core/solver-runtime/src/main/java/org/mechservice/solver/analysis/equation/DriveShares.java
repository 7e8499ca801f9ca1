package org.mechservice.solver.analysis.equation;

import java.util.Arrays;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.mechservice.solver.closure.assembly.ScaledJacobian;
import org.mechservice.solver.linear.SparseMatrix;
import org.mechservice.solver.linear.spectrum.SingularValues;

/**
 * The forces of drives that prescribe what others, or the loops, prescribe too. Balanced equations
 * leave a choice there: multipliers λ + n with Jᵀ n = 0 balance the motion as well. Of all choices
 * the forces of the drives are those of least norm, and of those that are left the multipliers of
 * least norm. Forces are multiplied by the mechanism's length to compare them with moments.
 *
 * <p>The force of drive i is linear in the multipliers, xᵢ + gᵢᵀ n, where only the part pᵢ of gᵢ
 * outside the range of J matters: gᵢ less its best approximation by columns of J. Hence n is the
 * smallest solution of P n = −x in the sense of least squares. Which joints are cut makes no
 * difference.
 *
 * <p>Workspace of one thread.
 */
public final class DriveShares {
  /** Part of gᵢ outside the range of J below which it is rounding. */
  private static final double ROUNDING = 1e-9;

  /** Singular values of P, as fractions of one, below which they are zero. */
  private static final double NEGLIGIBLE = 1e-8;

  /**
   * Most equations of loops whose redundant drives are looked for: their singular values take a
   * fraction of a second.
   */
  private static final int MOST_ROWS = 400;

  private final EquationsOfMotion equations;
  private final Drives drives;
  private final int rows;

  /** Singular values of J, if the mechanism is so large that its multipliers need none. */
  private final Optional<SingularValues> ofJacobian;

  /** Whether no drive was redundant at the first state of a large mechanism. */
  private boolean never;

  /** P, one row per drive and one column per equation. */
  private final double[] parts;

  private final SingularValues singular;
  private final double[] forces;
  private final double[] further;

  public DriveShares(EquationsOfMotion equations) {
    this.equations = equations;
    drives = new Drives(equations);
    rows = equations.lambda.length;
    never = rows == 0 || rows > MOST_ROWS || drives.count() == 0;
    ofJacobian =
        never || !equations.loops.isLarge()
            ? Optional.empty()
            : Optional.of(new SingularValues(rows, equations.nv));
    parts = new double[drives.count() * rows];
    singular = new SingularValues(drives.count(), rows);
    forces = new double[drives.count()];
    further = new double[rows];
  }

  /** Names the joints at the placed state whose driving forces the motion does not determine. */
  public Optional<String> redundant() {
    equations.jacobian.decompose();
    if (!decompose()) {
      return Optional.empty();
    }
    String names =
        IntStream.range(0, drives.count())
            .filter(i -> IntStream.range(i * rows, (i + 1) * rows).anyMatch(k -> parts[k] != 0))
            .mapToObj(i -> '"' + drives.joint(i) + '"')
            .distinct()
            .collect(Collectors.joining(", "));
    return Optional.of(names);
  }

  /** Shares the forces of balanced equations. */
  public void share() {
    if (!decompose()) {
      return;
    }
    for (int i = 0; i < forces.length; i++) {
      forces[i] = -drives.forceOf(i) * unit(i);
    }
    int rank = 0;
    while (rank < Math.min(forces.length, rows) && singular.value(rank) > NEGLIGIBLE) {
      rank++;
    }
    singular.solve(rank, forces, further);
    for (int row = 0; row < rows; row++) {
      further[row] /= equations.loops.size(row);
      equations.lambda[row] += further[row];
    }
    equations.addMultipliers(further);
  }

  private double unit(int i) {
    return drives.isDisplacement(i) ? equations.loops.length() : 1;
  }

  /** Forms and decomposes P; returns whether anything is redundant. */
  private boolean decompose() {
    if (never || isIndependent()) {
      return false;
    }
    ofJacobian.ifPresent(values -> values.decompose(equations.jacobian.elements()));
    boolean any = false;
    for (int i = 0; i < drives.count(); i++) {
      any |= project(i);
    }
    if (any) {
      singular.decompose(parts);
    }
    never = !any && ofJacobian.isPresent();
    return any;
  }

  /** Returns whether no equation of the loops follows from others. */
  private boolean isIndependent() {
    return ofJacobian.isEmpty() && equations.rank() == rows;
  }

  /** Writes pᵢ; returns whether it is more than rounding. */
  private boolean project(int i) {
    int at = i * rows;
    SparseMatrix jacobian = equations.loops.jacobian;
    double square = 0;
    for (int row = 0; row < rows; row++) {
      double size = equations.loops.size(row);
      double g =
          drives.isInTree(i)
              ? jacobian.get(row, equations.nv + i) * unit(i) / size
              : row == drives.row(i) ? -unit(i) / size : 0;
      parts[at + row] = g;
      square += g * g;
    }
    double left = removeRange(at);
    boolean outside = left > ROUNDING * ROUNDING * square;
    if (!outside) {
      Arrays.fill(parts, at, at + rows, 0);
    }
    return outside;
  }

  private int rank(SingularValues values) {
    int rank = 0;
    while (rank < Math.min(rows, equations.nv)
        && values.value(rank) > ScaledJacobian.NEGLIGIBLE * values.value(0)) {
      rank++;
    }
    return rank;
  }

  /** Removes the part in the range of J; returns the square of the rest. */
  private double removeRange(int at) {
    if (ofJacobian.isPresent()) {
      System.arraycopy(parts, at, further, 0, rows);
      ofJacobian.get().solve(rank(ofJacobian.get()), further, equations.step);
      for (int j = 0; j < equations.nv; j++) {
        equations.step[j] *= equations.unit[j];
      }
    } else {
      for (int row = 0; row < rows; row++) {
        further[row] = -parts[at + row] * equations.loops.size(row);
      }
      equations.solveLeastAsDecomposed(further);
    }
    double square = 0;
    for (int row = 0; row < rows; row++) {
      double size = equations.loops.size(row);
      SparseMatrix jacobian = equations.loops.jacobian;
      double sum = 0;
      for (int e = jacobian.start[row]; e < jacobian.start[row + 1]; e++) {
        int j = jacobian.column[e];
        sum += j < equations.nv ? jacobian.value[e] * equations.step[j] : 0;
      }
      parts[at + row] -= sum / size;
      square += parts[at + row] * parts[at + row];
    }
    return square;
  }
}
