/**
 * The administration console: reads servers over CORBA and acts on them.
 *
 * <p>{@link org.mechservice.admin.AdminConsole} connects to one or several servers and returns a
 * {@link org.mechservice.admin.ServerReading} of each: its hosts, sessions and simulations, or why
 * there is none. {@link org.mechservice.admin.ServerCalls} makes each call in a thread of its own,
 * so that a server that hangs delays no other. {@link org.mechservice.admin.AdminAction} is a
 * change, such as drain or cancel, and {@link org.mechservice.admin.AdminTarget} the server or host
 * that it concerns. {@link org.mechservice.admin.AdminFailure} is the only exception.
 *
 * <p>The same readings are printed as text ({@link org.mechservice.admin.StatusText}, {@link
 * org.mechservice.admin.DetailText}) and as JSON ({@link org.mechservice.admin.AdminJson}, {@link
 * org.mechservice.admin.DetailJson}). The live view of all servers is in {@code live}, the table in
 * the terminal in {@code watch}, the web page in {@code web}. This module depends on the CORBA
 * contract alone.
 */
@NullMarked
package org.mechservice.admin;

import org.jspecify.annotations.NullMarked;
