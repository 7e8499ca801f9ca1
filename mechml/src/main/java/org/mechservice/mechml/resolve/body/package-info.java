/**
 * Bodies and the root of a mechanism.
 *
 * <p>{@link org.mechservice.mechml.resolve.body.BodyReader} reads a body with its points, vectors,
 * mass and inertia into a {@link org.mechservice.mechml.resolve.body.BodyDefinition}. {@link
 * org.mechservice.mechml.resolve.body.InertiaReader} checks the principal moments of the tensor,
 * which {@link org.mechservice.mechml.resolve.body.PrincipalMoments} computes by Jacobi's method.
 * {@link org.mechservice.mechml.resolve.body.ShapeReader} computes mass and inertia of solids, and
 * {@link org.mechservice.mechml.resolve.body.MassProperties} adds them. {@link
 * org.mechservice.mechml.resolve.body.BodyIndex} numbers the moving bodies in file order. {@link
 * org.mechservice.mechml.resolve.body.RootReader} reads the pose of the root in the world.
 *
 * <p>{@link org.mechservice.mechml.resolve.body.BodyEnd} is what a joint, a constraint or a force
 * names in one body, and {@link org.mechservice.mechml.resolve.body.AlignmentRotation} computes the
 * rotations that such named directions define.
 */
@NullMarked
package org.mechservice.mechml.resolve.body;

import org.jspecify.annotations.NullMarked;
