/**
 * Pictures of models and of their runs in the program that reads and runs them.
 *
 * <p>{@link org.mechservice.view.model.ModelScene} turns a model into the scene that drawings and
 * the player show: the poses of its bodies at the start with closed loops, and what joins, closes
 * and moves them, with {@link org.mechservice.view.model.SceneParts} for the parts. {@link
 * org.mechservice.view.model.ModelPictures} makes from a model of the library in process its
 * drawing, and from a model and a trajectory the page of the player; notebooks show both.
 *
 * <p>This is the only package of the pictures that knows mechanisms. The others see the scene
 * alone, which may also come from a server.
 */
@NullMarked
package org.mechservice.view.model;

import org.jspecify.annotations.NullMarked;
