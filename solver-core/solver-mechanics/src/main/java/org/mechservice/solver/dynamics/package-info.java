/**
 * Equations of motion of open chains, driven by the data of a {@link
 * org.mechservice.solver.mechanism.Mechanism}.
 *
 * <p>Generated model classes are specialised forms of what stands here and are tested against it.
 * Every formulation is a class over the immutable mechanism; what changes during an evaluation
 * lives in a workspace of its own, one per thread.
 */
package org.mechservice.solver.dynamics;
