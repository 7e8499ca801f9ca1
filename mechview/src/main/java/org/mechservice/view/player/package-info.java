/**
 * Moving pictures of a run: a page for browsers, and a file for programs that show scenes.
 *
 * <p>A {@link org.mechservice.view.player.Recording} takes the rows of a run, from a service or
 * from a file, and keeps as many frames as a picture needs. A {@link
 * org.mechservice.view.player.Stage} gives every body of a {@link
 * org.mechservice.view.scene.SceneDescription} its shapes: those of its geometry file, of its
 * looks, of its solids ({@link org.mechservice.view.player.BodySurfaces}), or a skeleton of its
 * joints and its centre of mass; joints get the symbol of their type. {@link
 * org.mechservice.view.player.PlayerPage} writes both as one HTML page that needs no network,
 * {@link org.mechservice.view.player.AnimatedScene} as animated glTF 2.0; a {@link
 * org.mechservice.view.player.Film} is taken of the page by the browser of the machine.
 *
 * <p>The page's own program lies beside this package as ES modules, which are put into the page one
 * after the other, behind three.js ({@link org.mechservice.view.player.ThreeLibrary}): all names of
 * the modules are in one scope. The scene module draws a mechanism in any position and knows
 * nothing of time, so that the page for users draws by it too. Numbers travel as base64 of
 * little-endian floats. Everything that comes from a model is data in it: names are put in as text
 * only, and the page's content policy names its one script by its hash, so that nothing else can
 * run and nothing can be fetched.
 */
@NullMarked
package org.mechservice.view.player;

import org.jspecify.annotations.NullMarked;
