/**
 * Forces.
 *
 * <p>{@link org.mechservice.mechml.resolve.force.ForcesReader} reads the block {@code Forces} and
 * passes each element to the reader of its kind: springs, bushings, forces and torques, contacts,
 * forces on joint coordinates. It reads user forces itself, since the file holds only a class name.
 * {@link org.mechservice.mechml.resolve.force.JointAttributesReader} reads the springs, dampers,
 * friction and stops that joints carry as attributes.
 *
 * <p>Coefficients become expressions of the tunable parameters; all other parameters are folded to
 * numbers in SI units. {@link org.mechservice.mechml.resolve.force.ProfileReader} turns the
 * stations of a contact's profile into one expression of the arc length.
 *
 * <p>Contacts of shapes and tyres are {@code PairForce}s: {@link
 * org.mechservice.mechml.resolve.force.ShapeContactReader} and {@link
 * org.mechservice.mechml.resolve.force.TyreReader} write their geometry and their laws as formulas
 * of the relative motion of two frames, with the arithmetic of {@link
 * org.mechservice.mechml.resolve.force.ExpressionAlgebra}. Friction that sticks and tyres that
 * deflect bring further states, which stand behind those of the file.
 *
 * <p>The force elements themselves are those of {@code org.mechservice.solver.force}.
 */
@NullMarked
package org.mechservice.mechml.resolve.force;

import org.jspecify.annotations.NullMarked;
