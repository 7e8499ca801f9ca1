package org.mechservice.sim.emit.c;

import java.util.List;
import java.util.Optional;
import org.mechservice.solver.closure.PenaltySettings;
import org.mechservice.solver.symbol.Program;

/**
 * The terms of a mechanism with closed loops, M v' + b + Jᵀ λ = τ and Φ(q, t) = 0, and the layout
 * in which {@code mech_loops.c} solves them. Inputs of all programs are [q; v; s] and, behind it,
 * the unwrapped angles of cut joints; terms are laid out as in {@code
 * org.mechservice.solver.closure.equations.LoopTerms}.
 *
 * @param loops program to Φ, Φ', J and the sizes of the equations
 * @param equations program to all terms
 * @param mass program to M alone
 * @param further program to the derivatives of the further states, if there are any
 * @param angles program to the unwrapped angles, if there are any, each on the turn nearest to its
 *     input
 * @param angleStarts the angles at the start, rad
 * @param rowStart where each row of the pattern of J begins, one number more than equations
 * @param column columns of the pattern: velocities of the state, ascending in each row
 * @param size of what each equation measures, m or 1 rad
 * @param placeRounding rounding error of places relative to the mechanism, for each equation
 * @param unit unit of each velocity, a length of the mechanism or 1
 * @param penalty α, Ω and μ
 * @param rank number of independent equations
 * @param isHolonomic whether all equations restrict positions
 */
public record CLoops(
    Program loops,
    Program equations,
    Program mass,
    Optional<Program> further,
    Optional<Program> angles,
    List<Double> angleStarts,
    List<Integer> rowStart,
    List<Integer> column,
    List<Double> size,
    List<Double> placeRounding,
    List<Double> unit,
    PenaltySettings penalty,
    int rank,
    boolean isHolonomic)
    implements CMotion {

  public CLoops {
    angleStarts = List.copyOf(angleStarts);
    rowStart = List.copyOf(rowStart);
    column = List.copyOf(column);
    size = List.copyOf(size);
    placeRounding = List.copyOf(placeRounding);
    unit = List.copyOf(unit);
  }

  /** Returns the number of equations. */
  int rows() {
    return rowStart.size() - 1;
  }
}
