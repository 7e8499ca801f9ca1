/**
 * Commands about a model as a file: {@code new}, {@code examples}, {@code check}, {@code import},
 * {@code build} and {@code verify}.
 *
 * <p>{@link org.mechservice.cli.model.NewCommand} and {@link
 * org.mechservice.cli.model.ExamplesCommand} give a model to begin with; {@link
 * org.mechservice.cli.model.Examples} are those that the program carries. {@link
 * org.mechservice.cli.model.CheckCommand} prints what the service finds in a model, {@link
 * org.mechservice.cli.model.ImportCommand} translates other formats into MechML, {@link
 * org.mechservice.cli.model.BuildCommand} writes the generated JAR and, on request, its Java
 * source, and {@link org.mechservice.cli.model.VerifyCommand} checks the detached signature of a
 * JAR. {@link org.mechservice.cli.model.SceneReader} reads a model as pictures need it.
 *
 * <p>The option groups of every command that builds a model are here as well: {@link
 * org.mechservice.cli.model.ModelOptions} (simulation, method, columns), {@link
 * org.mechservice.cli.model.ParameterOption} ({@code --set}) and {@link
 * org.mechservice.cli.model.UserCodeOption}. Each adds what was given to a {@link
 * org.mechservice.client.SimulationOptions}; the server checks the values.
 */
@NullMarked
package org.mechservice.cli.model;

import org.jspecify.annotations.NullMarked;
