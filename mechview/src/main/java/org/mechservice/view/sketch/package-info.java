/**
 * Drawings of mechanisms in their initial position: {@code mech show}.
 *
 * <p>{@link org.mechservice.view.sketch.MechanismPicture} draws bodies as bars or areas between
 * their points, joints by their textbook symbols, and names where they cover nothing. {@code
 * InteractionSketch} draws constraints and forces, {@code PictureSheet} what is written around the
 * mechanism: gravity, world axes, a scale, a legend and a caption with what {@code mech check}
 * says. {@code SceneLayout} says where points of the scene are on the sheet; {@code Projection} is
 * the direction of view, along the axes of a planar mechanism if none is demanded. {@code
 * JointSymbols} and {@code ForceSymbols} draw single symbols, {@code NamePlaces} collects names,
 * which leave each other out where there are too many.
 *
 * <p>The input is a {@link org.mechservice.view.scene.SceneDescription}, the output a {@link
 * org.mechservice.view.drawing.Canvas}.
 */
@NullMarked
package org.mechservice.view.sketch;

import org.jspecify.annotations.NullMarked;
