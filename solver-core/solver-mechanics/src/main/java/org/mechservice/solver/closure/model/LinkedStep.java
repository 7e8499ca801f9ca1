package org.mechservice.solver.closure.model;

import java.util.function.DoubleToIntFunction;
import org.mechservice.solver.closure.ArticulatedAugmentedEquations;
import org.mechservice.solver.closure.AugmentedEquations;
import org.mechservice.solver.closure.ClosedTree;
import org.mechservice.solver.closure.LinkedAugmentedEquations;
import org.mechservice.solver.dynamics.derivative.ArticulatedIteration;
import org.mechservice.solver.dynamics.derivative.LinkJacobian;
import org.mechservice.solver.dynamics.derivative.LoopWrenches;
import org.mechservice.solver.linear.SparseMatrix;

/**
 * The equations of an implicit step kept by links, without a matrix over the velocities: few loops
 * of neighbours beside equations that are eliminated from link to link, or all in one sparse
 * system.
 *
 * @param jacobian derivatives that A is made of
 * @param iteration keeps A
 * @param equations those of A with the loops
 * @param factors factors them for a step hγ; a negative number, or the velocity without a pivot
 */
record LinkedStep(
    LinkJacobian jacobian,
    ArticulatedIteration iteration,
    AugmentedEquations equations,
    DoubleToIntFunction factors) {
  /**
   * Makes workspaces.
   *
   * @param rows J with scaled rows, to be written before each linearisation
   * @param stiffness α of a row, as a multiple of the inertia that it moves
   */
  static LinkedStep of(ClosedTree work, SparseMatrix rows, double stiffness) {
    double[] units = work.units.velocities;
    if (work.hasFewLocalLoops()) {
      LinkJacobian jacobian = new LinkJacobian(work.motion);
      ArticulatedIteration iteration = new ArticulatedIteration(jacobian);
      ArticulatedAugmentedEquations few = new ArticulatedAugmentedEquations(rows, units, iteration);
      return new LinkedStep(jacobian, iteration, few, step -> few.factor(step, stiffness));
    }
    LoopWrenches ofLinks = LinkedAugmentedEquations.rowsOf(work.loops, work.tree);
    LinkJacobian jacobian = new LinkJacobian(work.motion, work.coupledLinks());
    ArticulatedIteration iteration = new ArticulatedIteration(jacobian, ofLinks);
    LinkedAugmentedEquations all =
        new LinkedAugmentedEquations(rows, units, work.loops, work.tree, ofLinks, iteration);
    return new LinkedStep(jacobian, iteration, all, step -> all.factor(step, stiffness));
  }
}
