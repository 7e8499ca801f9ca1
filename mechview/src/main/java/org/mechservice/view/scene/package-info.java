/**
 * A mechanism as pictures need it: where its bodies are at the start, and what joins, closes and
 * moves them.
 *
 * <p>{@link org.mechservice.view.scene.SceneDescription} is the whole. Bodies have a pose in the
 * world at the start. Joints, constraints and forces hold {@link
 * org.mechservice.view.scene.Anchor}s: points fixed in a body, which {@link
 * org.mechservice.view.scene.SceneDescription#world} takes to the world, and directions in the axes
 * of a body. With other poses, such as those of a row of results, the same anchors give the picture
 * at another time.
 *
 * <p>The package knows neither model files nor solvers: who reads a model fills in the records.
 * Lengths are in m, axes are right-handed, rotations are Euler parameters (e0 the scalar part).
 * Body indices count {@link org.mechservice.view.scene.SceneDescription#bodies}; {@link
 * org.mechservice.view.scene.Anchor#ROOT} is the root.
 */
@NullMarked
package org.mechservice.view.scene;

import org.jspecify.annotations.NullMarked;
