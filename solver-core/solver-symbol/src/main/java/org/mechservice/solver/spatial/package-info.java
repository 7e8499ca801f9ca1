/**
 * Vectors, rotations, poses and inertias in three-dimensional space.
 *
 * <p>Values ({@link org.mechservice.solver.spatial.Vector3}, {@link
 * org.mechservice.solver.spatial.Rotation}, {@link org.mechservice.solver.spatial.InertiaTensor})
 * are immutable and serve descriptions; recursions work on plain arrays with the static routines of
 * this package, which write into the array they are given and do not allocate. A rotation is an
 * orthonormal 3×3 matrix or Euler parameters e0, e1, e2, e3 with unit norm; a moment of inertia is
 * in kg·m², about a point and in axes that the caller states.
 *
 * <p>{@link org.mechservice.solver.spatial.SinCos} gives sine and cosine, {@link
 * org.mechservice.solver.spatial.Powers} powers, with the same bits on every machine. The package
 * does not depend on joints or trees. Sources: Featherstone 2008, chapter 2; Shepperd 1978 for
 * Euler parameters.
 */
package org.mechservice.solver.spatial;
