/**
 * {@code mech web}: a page for users. They write or drop a model, see what check says of it and how
 * it looks, run it at a server and watch it move while it runs.
 *
 * <p>{@link org.mechservice.view.web.UserWeb} serves the page on the loopback interface, protected
 * as the administration page is: a token made at each start, which no other site can send, and
 * headers under which no text of a model can become a script. It is a client of the service as
 * every other: models are checked and run over CORBA, each in a session of its own.
 *
 * <p>A {@code UserRun} takes the rows of a run. It keeps at most 1500 frames in memory, evenly
 * spaced over the simulated time, which pages fetch as they come, and writes all rows to files.
 * {@code UserRuns} keeps the latest runs, which outlast the page that started them. {@code
 * DroppedFiles} are what lies beside a model; its text gets what it names of them.
 *
 * <p>{@code Differences} compares two runs. A {@code UserReport} measures a model and keeps its
 * report of error against run time, one at a time. It and the Functional Mock-up Unit are made by a
 * {@link org.mechservice.view.web.ModelExports}, which the command line brings.
 *
 * <p>The scene and curves in the browser are those of {@link org.mechservice.view.player}. Models
 * are read for drawings by a {@link org.mechservice.view.web.ModelReader}, because this module does
 * not read model files.
 */
@NullMarked
package org.mechservice.view.web;

import org.jspecify.annotations.NullMarked;
