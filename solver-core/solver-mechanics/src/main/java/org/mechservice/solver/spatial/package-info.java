/** Vectors, rotations and inertias in three-dimensional space. */
package org.mechservice.solver.spatial;
