/**
 * The motion of two bodies relative to each other, for any joints between them, and functions of
 * it: constraints and coordinates of cut joints, distances.
 *
 * <p>{@link org.mechservice.solver.kinematics.pair.RelativeMotion} computes the pose, velocity and
 * acceleration of body B relative to body A from a swept tree. A {@link
 * org.mechservice.solver.kinematics.pair.PairFunction} is a scalar function of that motion with its
 * gradient and its curvature, so that forces, constraint equations and their derivatives all use
 * one scheme: the gradient is the wrench of a unit multiplier, and the curvature its derivative.
 * {@link org.mechservice.solver.kinematics.pair.CutJoint} holds the functions of one cut joint, by
 * the definitions of docs/mechml.md#joints. {@link
 * org.mechservice.solver.kinematics.pair.PairLinearisation} transforms gradient and curvature to
 * derivatives of wrenches on links, and {@link org.mechservice.solver.kinematics.pair.PairForms}
 * gives generated code the same functions in symbolic form.
 *
 * <p>The functions avoid Euler parameters and are smooth; angles are unwrapped by their users. See
 * docs/theory/loops.md#cutting.
 */
package org.mechservice.solver.kinematics.pair;
