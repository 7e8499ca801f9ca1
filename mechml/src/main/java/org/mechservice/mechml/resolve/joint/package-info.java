/**
 * Joints and constraints.
 *
 * <p>{@link org.mechservice.mechml.resolve.joint.JointsReader} reads the joints with their starts.
 * {@link org.mechservice.mechml.resolve.joint.JointReader} reads one joint of any type; {@link
 * org.mechservice.mechml.resolve.joint.AxisReader} finds its placement in the two bodies and {@link
 * org.mechservice.mechml.resolve.joint.StartReader} its start. {@link
 * org.mechservice.mechml.resolve.joint.JointTree} chooses the joints of the spanning tree, marks
 * the others as cut, and turns each joint of the tree outwards from the root.
 *
 * <p>A joint may instead be given by a point and an axis in the world at assembly. {@link
 * org.mechservice.mechml.resolve.joint.WorldJoints} places such joints in their bodies after the
 * tree is chosen, from the {@link org.mechservice.mechml.resolve.joint.AssemblyPose}s of the
 * bodies.
 *
 * <p>{@link org.mechservice.mechml.resolve.joint.DriveReader} reads prescribed motions, and {@link
 * org.mechservice.mechml.resolve.joint.MotionCheck} refuses those that jump. {@link
 * org.mechservice.mechml.resolve.joint.ConstraintsReader} reads further loop closures: distances,
 * points on planes and lines, joints as constraints, and couplings of coordinates.
 *
 * <p>docs/mechml.md#joints and docs/mechml.md#constraints define the conventions.
 */
@NullMarked
package org.mechservice.mechml.resolve.joint;

import org.jspecify.annotations.NullMarked;
