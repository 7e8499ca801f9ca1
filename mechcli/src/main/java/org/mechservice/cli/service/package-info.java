/**
 * Commands of an operator who sets up a service: {@code mech server}, {@code mech simhost} and
 * {@code mech keys}.
 *
 * <p>{@link org.mechservice.cli.service.ServerCommand} starts a server that also simulates, {@link
 * org.mechservice.cli.service.SimhostCommand} a host that registers with a server. Both take their
 * limits, spool folder and permission for user code from {@link
 * org.mechservice.cli.service.HostingOptions} and their address from {@link
 * org.mechservice.cli.service.ListenOptions}, and stay in {@link
 * org.mechservice.cli.service.ServingProcess} until a signal ends them. {@link
 * org.mechservice.cli.service.KeysCommand} makes the certificates of a TLS set-up.
 */
@NullMarked
package org.mechservice.cli.service;

import org.jspecify.annotations.NullMarked;
