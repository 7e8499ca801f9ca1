package org.mechservice.solver.closure.equations;

import java.util.BitSet;
import java.util.Optional;
import org.mechservice.solver.force.applied.Couplings;
import org.mechservice.solver.force.applied.ForceJacobian;
import org.mechservice.solver.kinematics.TreeGeometry;
import org.mechservice.solver.kinematics.TreeMotion;
import org.mechservice.solver.kinematics.pair.RelativeMotion;
import org.mechservice.solver.mechanism.closure.LoopClosure;

/**
 * The equations of one closure: Φ(q, t) = 0, and rows J of Φ' = J v + Φ_t. Workspace of one thread.
 * The order of calls is {@link #place}, {@link #move}, {@link #accelerate}, each after the
 * corresponding sweep of the motion.
 */
abstract class ClosureRows {
  private final LoopClosure closure;

  ClosureRows(LoopClosure closure) {
    this.closure = closure;
  }

  final LoopClosure closure() {
    return closure;
  }

  /** Returns the number of equations. */
  abstract int count();

  /** Returns the direction that an equation constrains, for messages. */
  abstract String label(int row);

  /** Returns whether an equation restricts positions; otherwise only velocities, and Φ = 0. */
  boolean isHolonomic(int row) {
    return true;
  }

  /** Returns the size of what an equation measures after {@link #place}: m, or 1 rad. */
  abstract double size(int row);

  /** Sets the size of what an equation measures, if it changes. */
  void measure(double size) {}

  /** Returns the SI unit of what an equation measures, after {@link #place}. */
  abstract String unit(int row);

  /** Evaluates values and gradients. */
  abstract void place(TreeMotion motion, double t);

  /**
   * As {@link #place}, with values and gradients that are of use however far the positions are from
   * closing the loops.
   *
   * @see org.mechservice.solver.kinematics.pair.PairFunction#evaluateFar
   */
  abstract void placeFar(TreeMotion motion, double t);

  /** Evaluates rates. */
  abstract void move(TreeMotion motion, double t);

  /** Evaluates second derivatives, with the accelerations of the last sweep. */
  abstract void accelerate(TreeMotion motion, double t);

  /** Returns Φ. */
  abstract double value(int row);

  /** Returns Φ' = J v + Φ_t. */
  abstract double rate(int row);

  /** Returns Φ'' for the accelerations of the last sweep: γ if those of the state are zero. */
  abstract double acceleration(int row);

  /**
   * Adds a row of J.
   *
   * @param rows one number per extended velocity from {@code at}; added to
   */
  abstract void addJacobian(TreeMotion motion, int row, double[] rows, int at);

  /** Adds upper bounds of the elements of a row of J, free of cancellation. */
  abstract void addBounds(TreeMotion motion, int row, double[] bounds, int at);

  /**
   * Adds the forces of a multiplier, λ times the row of J.
   *
   * @param wrench [moment; force], 6 per link, in link axes at the reference points; added to
   * @param tau one number per extended velocity; added to
   */
  abstract void addForces(int row, double multiplier, double[] wrench, double[] tau);

  /** Returns the two bodies between which all equations act, if they act on nothing else. */
  Optional<RelativeMotion> pair() {
    return Optional.empty();
  }

  /**
   * Writes the wrenches of a unit multiplier on the two bodies of {@link #pair}.
   *
   * @param onA [moment; force] in link axes at the reference point; overwritten
   * @param onB likewise
   */
  void wrenches(int row, double[] onA, double[] onB) {
    throw new IllegalStateException("the equations are not between two bodies alone");
  }

  /**
   * Adds the derivatives of the multipliers' forces by poses of links and by coordinates.
   *
   * @param multipliers one per equation of all closures; this closure's from {@code at}
   * @param factor factor of the multipliers
   */
  abstract void linearise(double[] multipliers, int at, double factor, ForceJacobian sink);

  /**
   * Adds the structure of the equations.
   *
   * @param ways links whose joints they depend on; added to
   * @param loaded links on which {@link #addForces} exerts wrenches; added to
   * @param velocities extended velocities on which it exerts forces; added to
   */
  abstract void addSupport(BitSet ways, BitSet loaded, BitSet velocities);

  /** Adds the pairs of links that {@link #linearise} couples. */
  abstract void couplings(Couplings couplings);

  /** Stores the unwrapped angles after an accepted step. */
  abstract void accepted();

  /**
   * Returns whether the derivatives of its forces are by the motion of the links that they act on,
   * or of those next to them, alone.
   */
  boolean isLocal(TreeGeometry tree) {
    return false;
  }
}
