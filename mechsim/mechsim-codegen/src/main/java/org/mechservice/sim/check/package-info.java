/**
 * The report of {@code mech check}: all facts about a model before it runs.
 *
 * <p>{@link org.mechservice.sim.check.CheckReport} is the main type. It collects the analyses of
 * {@link org.mechservice.sim.scene} (tree, loops, rank, degrees of freedom, forecasts of the run),
 * the warnings of the reader, and the {@link org.mechservice.sim.model.CodeForecast}: formulation,
 * operations per evaluation, and what a generated class leaves out.
 *
 * <p>{@code CheckText} writes the report as text, with the tree of joints drawn by {@code
 * TreeDrawing}; {@code CheckJson} writes the same facts as one JSON object, whose fields are a
 * contract with tools.
 *
 * <p>The package only reports: it refuses nothing and chooses nothing. Depends on {@code
 * sim.scene}, {@code sim.model} and Gson.
 */
@NullMarked
package org.mechservice.sim.check;

import org.jspecify.annotations.NullMarked;
