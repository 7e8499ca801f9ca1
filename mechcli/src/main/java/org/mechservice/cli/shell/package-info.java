/**
 * What all commands share towards the shell and towards the service.
 *
 * <p>{@link org.mechservice.cli.shell.ExitStatus} lists the exit statuses. {@link
 * org.mechservice.cli.shell.UsageReport} reports a command line that picocli cannot read, {@link
 * org.mechservice.cli.shell.FailureReport} turns an exception into one message with a code and an
 * exit status; commands throw {@link org.mechservice.cli.shell.UsageException} for options that
 * make no sense together. {@link org.mechservice.cli.shell.StandardOutput} remembers that standard
 * output could not be written, {@link org.mechservice.cli.shell.OutputFile} writes a file
 * completely or not at all, {@link org.mechservice.cli.shell.LogSetup} configures logback.
 *
 * <p>{@link org.mechservice.cli.shell.ServiceConnection} connects to the server that {@link
 * org.mechservice.cli.shell.ServerOption} names, or starts one within this process.
 */
@NullMarked
package org.mechservice.cli.shell;

import org.jspecify.annotations.NullMarked;
