package org.mechservice.solver.closure.equations;

import java.util.BitSet;
import org.mechservice.solver.force.applied.Couplings;
import org.mechservice.solver.force.applied.ForceJacobian;
import org.mechservice.solver.kinematics.TreeMotion;
import org.mechservice.solver.mechanism.closure.LoopClosure;

/**
 * The equations of one closure, Φ(q, t) = 0, rows J of Φ' = J v + Φ_t and what they need besides.
 * Workspace of one thread. {@link #place} comes first, then {@link #move}, then {@link
 * #accelerate}; each after the like sweep of the motion.
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

  /** Returns what an equation forbids, for messages. */
  abstract String label(int row);

  /** Returns the size of what an equation measures after {@link #place}: m, or 1 rad. */
  abstract double size(int row);

  /** Takes the size of what an equation measures, unless that does not change. */
  void measure(double size) {}

  /** Returns the SI unit of what an equation measures, after {@link #place}. */
  abstract String unit(int row);

  /** Evaluates values and gradients. */
  abstract void place(TreeMotion motion, double t);

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

  /** Adds bounds of the elements of a row of J, which do not know cancellation. */
  abstract void addBounds(TreeMotion motion, int row, double[] bounds, int at);

  /**
   * Adds the forces of a multiplier, λ times the row of J.
   *
   * @param wrench [moment; force], 6 per link, in link axes at the reference points; added to
   * @param tau one number per extended velocity; added to
   */
  abstract void addForces(int row, double multiplier, double[] wrench, double[] tau);

  /**
   * Gives how the forces of multipliers change with the places of links and coordinates.
   *
   * @param multipliers one per equation of all closures; this one's from {@code at}
   * @param factor what they are multiplied by
   */
  abstract void linearise(double[] multipliers, int at, double factor, ForceJacobian sink);

  /**
   * Adds what the equations depend on.
   *
   * @param ways links whose joints they depend on; added to
   * @param loaded links on which {@link #addForces} puts wrenches; added to
   * @param velocities extended velocities on which it puts forces; added to
   */
  abstract void addSupport(BitSet ways, BitSet loaded, BitSet velocities);

  /** Gives the pairs of links that {@link #linearise} couples. */
  abstract void couplings(Couplings couplings);

  /** Keeps in mind which whole turn angles are on, after an accepted step. */
  abstract void accepted();
}
