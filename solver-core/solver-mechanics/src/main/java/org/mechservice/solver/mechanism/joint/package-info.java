/**
 * The joints of a mechanism: one immutable record for each type, with its definition.
 *
 * <p>{@link org.mechservice.solver.mechanism.joint.Joint} is a sealed family, so the compiler names
 * every {@code switch} that lacks a new type. The documentation of each record defines the joint:
 * the order, sign and unit of its coordinates q and velocities v, and the pose at zero. An {@link
 * org.mechservice.solver.mechanism.joint.Attachment} names the two bodies, the two points and the
 * relative rotation at zero coordinates. {@link org.mechservice.solver.mechanism.joint.JointStart}
 * holds the start values, each with its {@link org.mechservice.solver.mechanism.joint.StartRole}:
 * exact, or a first guess for the assembly of closed loops.
 *
 * <p>Package {@code solver.kinematics} takes each joint apart into elementary links, from which all
 * formulations and the generated code follow. Joints that close loops are the same records inside a
 * {@code mechanism.closure.JointClosure}. The package knows nothing of the mechanism around it.
 *
 * <p>The definitions are those of docs/mechml.md#joints.
 */
package org.mechservice.solver.mechanism.joint;
