package org.mechservice.solver.ode;

/**
 * A system that falls into parts: ∂f_i/∂y_j vanishes, or may be taken as zero in the matrix of
 * Newton's iteration, unless i and j belong to the same block of components, each as long as the
 * first but for the last. Copies of a system side by side are of this kind, and a system with its
 * sensitivities, of which each has the Jacobian of the system: how they depend on the state needs
 * no place in the matrix (Maly and Petzold, Appl. Numer. Math. 20 (1996) 57). Implemented beside
 * {@link OdeSystem}.
 *
 * <p>Implicit methods then factor and solve block by block, at a cost proportional to their number.
 * Derivatives that are known are written block after block, each row after row.
 */
@FunctionalInterface
public interface BlockSystem {
  /** Returns the components of a block, at least 1. */
  int blockSize();
}
