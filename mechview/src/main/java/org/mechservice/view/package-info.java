/**
 * Pictures of results and mechanisms: curves, drawings, the player. The command line and the web
 * client stand on the same pieces.
 *
 * <p>{@code drawing} holds what a picture consists of and writes it as SVG or PNG. {@code plot}
 * draws curves and compares results. {@code scene} describes a mechanism as pictures need it:
 * poses, joints, forces, names; {@code model} makes such a scene from a model, {@code sketch} draws
 * it at rest, {@code mesh} reads the shapes of its bodies, {@code player} writes the page, or the
 * animated scene for other programs, that moves them. {@code web} serves the page for users.
 *
 * <p>All of them read results and models through the client and the files that it wrote; none
 * computes motion itself.
 */
@NullMarked
package org.mechservice.view;

import org.jspecify.annotations.NullMarked;
