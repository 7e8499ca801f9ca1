/**
 * Vectors, rotations, poses and inertias in three-dimensional space.
 *
 * <p>Values ({@link org.mechservice.solver.spatial.Vector3} and its kin) are immutable and serve
 * descriptions; recursions work on plain arrays with the static routines of this package, which
 * write into the array they are given and do not allocate. A rotation is an orthonormal 3×3 matrix
 * or Euler parameters e0, e1, e2, e3 with unit norm; a moment of inertia is in kg·m², about the
 * point that the caller names, in the axes that it names.
 *
 * <p>The package knows no joints and no trees.
 */
package org.mechservice.solver.spatial;
