/**
 * The immutable description of a mechanism: bodies, joints, start values, prescribed motions, loop
 * closures, forces, parameters, events and outputs. SI units throughout.
 *
 * <p>{@link org.mechservice.solver.mechanism.Mechanism} holds all of it except outputs, and checks
 * that the joints form a tree. Each body is the child of one {@link
 * org.mechservice.solver.mechanism.joint.Joint}, a sealed family with one record per joint type,
 * whose documentation defines the joint. An {@link
 * org.mechservice.solver.mechanism.joint.Attachment} names the two bodies and points of a joint. A
 * {@link org.mechservice.solver.mechanism.PrescribedMotion} removes a joint from the state y = [q;
 * v]; an {@link org.mechservice.solver.mechanism.Event} changes the state or ends a run. Closures
 * of loops are in {@code mechanism.closure}, forces in {@code mechanism.force}.
 *
 * <p>The module {@code mechml} reads a mechanism from a model file. The formulations of {@code
 * solver.dynamics} and {@code solver.closure} and the code generator read it. All threads may share
 * a mechanism; each computation has its own workspace.
 *
 * <p>The definitions of joints and constraints are those of docs/mechml.md#joints and
 * docs/mechml.md#constraints.
 */
package org.mechservice.solver.mechanism;
