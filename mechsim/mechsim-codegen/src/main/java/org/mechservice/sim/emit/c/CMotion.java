package org.mechservice.sim.emit.c;

import org.mechservice.solver.symbol.Program;

/** The functions that give the derivative of the state of a model in C. */
public sealed interface CMotion permits CMotion.Tree, CLoops {
  /**
   * An open chain.
   *
   * @param derivative program from [q; v; s] to its derivative
   */
  record Tree(Program derivative) implements CMotion {}
}
