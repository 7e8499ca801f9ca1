/**
 * Drawings of mechanisms in their initial position: {@code mech show}.
 *
 * <p>{@link org.mechservice.view.sketch.MechanismPicture} lays out the drawing: bodies as bars or
 * areas between their points, joints, constraints and forces by their textbook symbols, names where
 * they cover nothing, gravity, world axes, a scale and a caption with what {@code mech check} says.
 * {@code Projection} is the direction of view, along the axes of a planar mechanism if none is
 * demanded. {@code JointSymbols} and {@code ForceSymbols} draw single symbols, {@code NamePlaces}
 * collects names, which leave each other out where there are too many.
 *
 * <p>The input is a {@link org.mechservice.view.scene.SceneDescription}, the output a {@link
 * org.mechservice.view.drawing.Canvas}.
 */
@NullMarked
package org.mechservice.view.sketch;

import org.jspecify.annotations.NullMarked;
