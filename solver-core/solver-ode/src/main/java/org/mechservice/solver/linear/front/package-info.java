/**
 * Factors of a sparse symmetric matrix that need not be definite, and its inertia, front by front.
 *
 * <p>{@link org.mechservice.solver.linear.front.SymmetricFronts} is what others use. It knows the
 * groups of unknowns in their order, brings the elements of each group and what earlier groups have
 * left into one dense front, and says which later group takes what this one leaves. {@link
 * org.mechservice.solver.linear.front.DenseFront} searches that front for pivots of one or two rows
 * and eliminates them; it alone decides what is a good pivot and what is rounding. What comes of it
 * is a {@link org.mechservice.solver.linear.front.FrontFactor}, which solves, and a {@link
 * org.mechservice.solver.linear.front.FrontRest}, which a later group takes.
 *
 * <p>The equilibria of large mechanisms are found and their stability is told with it. The package
 * does not depend on {@code linear}, and allocates factors each time.
 */
package org.mechservice.solver.linear.front;
