/**
 * Linear algebra with the sparsity of a tree of bodies.
 *
 * <p>The mass matrix of a tree has entries only between a joint and its ancestors: {@link
 * org.mechservice.solver.dynamics.tree.TreePattern} holds that structure, {@link
 * org.mechservice.solver.dynamics.tree.TreeMatrix} factors a symmetric matrix L<sup>T</sup>DL along
 * it without fill-in, and {@link org.mechservice.solver.dynamics.tree.TreeLu} factors unsymmetric
 * ones, such as the iteration matrices of implicit methods. {@link
 * org.mechservice.solver.dynamics.tree.PivotCheck} names the joint at which a pivot vanishes: a
 * massless chain or a singular position.
 *
 * <p>Source: Featherstone, <i>Rigid Body Dynamics Algorithms</i>, 2008, section 6.4 and 6.5
 * (branch-induced sparsity).
 */
package org.mechservice.solver.dynamics.tree;
