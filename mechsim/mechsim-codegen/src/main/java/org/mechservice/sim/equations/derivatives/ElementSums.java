package org.mechservice.sim.equations.derivatives;

import org.mechservice.solver.symbol.Program;
import org.mechservice.solver.symbol.Scalar;

/** Outputs the elements of M, ∂F/∂v and ∂F/∂q, each with the terms of forces and rods. */
final class ElementSums {
  private final Program program;
  private final TreeOrder places;
  private final ElementLayout at;
  private final ForceSlopes slopes;
  private final Scalar[][] massOfRods;

  /**
   * @param massOfRods terms of rods between bodies in M, by velocities of the state, the larger
   *     first; not copied
   */
  ElementSums(
      Program program,
      TreeOrder places,
      ElementLayout at,
      ForceSlopes slopes,
      Scalar[][] massOfRods) {
    this.program = program;
    this.places = places;
    this.at = at;
    this.slopes = slopes;
    this.massOfRods = massOfRods;
  }

  /** Outputs the elements between bodies of which neither is an ancestor of the other. */
  void putOutBetweenBranches() {
    program.section("Derivatives of forces between branches.", "forces");
    Scalar zero = program.expressions().zero();
    for (int i = 0; i < places.size(); i++) {
      for (int j = 0; j < places.size(); j++) {
        if (!places.isOnWay(j, i) && !places.isOnWay(i, j)) {
          putOutByVelocity(i, j, zero);
          putOutByPosition(i, j, zero);
          if (i > j) {
            putOutMass(i, j, zero);
          }
        }
      }
    }
  }

  /** Outputs an element of M whose row is not less than its column. */
  void putOutMass(int row, int column, Scalar mass) {
    int i = places.get(row).velocity();
    int j = places.get(column).velocity();
    putOut(at.mass(row, column), mass.plus(massOfRods[Math.max(i, j)][Math.min(i, j)]));
  }

  /** Outputs an element of ∂F/∂v. */
  void putOutByVelocity(int row, int column, Scalar element) {
    putOut(at.byVelocity(row, column), element.plus(slopes.byVelocity(row, column)));
  }

  /** Outputs an element of ∂F/∂q. */
  void putOutByPosition(int row, int column, Scalar element) {
    putOut(at.byPosition(row, column), element.plus(slopes.byPosition(row, column)));
  }

  private void putOut(int index, Scalar element) {
    if (!element.isZero()) {
      program.output(index, element);
    }
  }
}
