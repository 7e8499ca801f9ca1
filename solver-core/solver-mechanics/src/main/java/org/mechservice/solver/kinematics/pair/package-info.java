/**
 * The motion of two bodies relative to each other, whatever joints lie between them, and functions
 * of it: what a cut joint forbids, its coordinates, distances. Each comes with its gradient and its
 * curvature, so that forces, constraint equations and their derivatives are formed alike.
 */
package org.mechservice.solver.kinematics.pair;
