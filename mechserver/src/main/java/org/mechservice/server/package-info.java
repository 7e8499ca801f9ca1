/**
 * The server process: one port through which clients, hosts and administrators reach a farm of
 * hosts.
 *
 * <p>{@link org.mechservice.server.MechServerProcess} starts it from {@link
 * org.mechservice.server.ServerSettings} and publishes three objects: MechServer for clients,
 * HostRegistry for hosts and MechAdmin for administrators. {@link
 * org.mechservice.server.HostFactory} opens the host inside the server's own process; {@code
 * ServerPublication} writes the server's reference to a file and binds it at a naming service.
 *
 * <p>Depends on {@code server.hosts} (hosts and placement), {@code server.admin} (administration,
 * rights, metrics), mechsim-service and {@link org.mechservice.orb}; {@link
 * org.mechservice.server.keys} stands beside it and makes keys for TLS.
 */
@NullMarked
package org.mechservice.server;

import org.jspecify.annotations.NullMarked;
