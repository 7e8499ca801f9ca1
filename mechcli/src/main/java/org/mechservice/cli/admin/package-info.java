/**
 * {@code mech admin}: status, control, a live table and a web page of running servers.
 *
 * <p>{@link org.mechservice.cli.admin.AdminCommand} is the command with its subcommands that only
 * read; {@link org.mechservice.cli.admin.AdminActions} adds those that change something, such as
 * stop, drain and cancel. {@link org.mechservice.cli.admin.AdminWatchCommand} opens the live table
 * in the terminal, {@link org.mechservice.cli.admin.AdminWebCommand} serves the page.
 *
 * <p>The classes here read options and choose the output form, text or JSON. Everything else is
 * done by module {@code mechadmin}.
 */
@NullMarked
package org.mechservice.cli.admin;

import org.jspecify.annotations.NullMarked;
