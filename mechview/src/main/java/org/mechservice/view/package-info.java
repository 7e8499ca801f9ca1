/**
 * Pictures of results and mechanisms: curves, drawings, the player. The command line and the web
 * client stand on the same pieces.
 *
 * <p>{@code plot} draws curves and compares results, {@code sketch} draws a mechanism at rest,
 * {@code mesh} reads the shapes of bodies, {@code player} writes the page that moves them, and
 * {@code web} serves the page for users. All of them read results and models through the client and
 * the files that it wrote; none computes motion itself.
 */
@NullMarked
package org.mechservice.view;

import org.jspecify.annotations.NullMarked;
