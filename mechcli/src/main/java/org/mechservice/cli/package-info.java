/**
 * The {@code mech} command line: one main class, {@link org.mechservice.cli.Mech}, and one class
 * per command.
 *
 * <p>{@code Mech} reads the first word, prepares the command of that name alone, and hands the rest
 * to picocli. The commands lie in packages by what they are about:
 *
 * <ul>
 *   <li>{@code model}: check, import, build and verify a model
 *   <li>{@code simulate}: run it once, or fetch the results of a run
 *   <li>{@code sweep}: run it with many values of its parameters
 *   <li>{@code service}: server, simulation host, certificates
 *   <li>{@code admin}: look after servers that run
 *   <li>{@code shell}: what all commands share: exit status, messages, files, the connection to a
 *       service
 * </ul>
 *
 * <p>The two commands that only hand over to {@code mechreport}, {@link
 * org.mechservice.cli.ReportCommand} and {@link org.mechservice.cli.StabilityCommand}, lie here.
 * Options are picocli mixins; only {@link org.mechservice.client.SimulationOptions} leaves this
 * module. This module depends on every other one, and no module depends on it.
 */
@NullMarked
package org.mechservice.cli;

import org.jspecify.annotations.NullMarked;
