/**
 * The reference of all commands, written from the commands themselves: {@code mech reference}.
 *
 * <p>{@link org.mechservice.cli.reference.CommandText} takes a command apart into the texts that a
 * reader needs: usage, arguments, options, examples, exit statuses. {@link
 * org.mechservice.cli.reference.CommandsPage} makes {@code docs/reference/commands.md} of them, one
 * section a command, and {@link org.mechservice.cli.reference.ManPage} a manual page for each
 * command, for the release archive. Both come from picocli's model of the command line, so that an
 * option cannot be missing there; a test compares the committed page with what this package writes.
 * {@link org.mechservice.cli.reference.ReferenceCommand} is for those who build the program, and
 * help does not list it.
 */
@NullMarked
package org.mechservice.cli.reference;

import org.jspecify.annotations.NullMarked;
