/**
 * Pictures from the command line: {@code mech plot} draws results, {@code mech compare} says and
 * draws what differs between two, {@code mech show} draws a mechanism, {@code mech view} makes a
 * run a moving picture, {@code mech web} serves the page for users.
 *
 * <p>{@link org.mechservice.cli.picture.PlotCommand} and {@link
 * org.mechservice.cli.picture.ShowCommand} read options and files; {@code org.mechservice.view}
 * makes the pictures. {@link org.mechservice.cli.model.SceneReader} turns a model file into the
 * {@link org.mechservice.view.scene.SceneDescription} that every picture of a mechanism is made
 * from, with the loops closed as at the start of a run. It reads the model in this process: a
 * picture needs no service and no code of users; only {@link
 * org.mechservice.cli.picture.ViewCommand} runs the model.
 */
@NullMarked
package org.mechservice.cli.picture;

import org.jspecify.annotations.NullMarked;
