/**
 * The hosts of a server, their runs, and the placement of new sessions.
 *
 * <p>{@link org.mechservice.server.hosts.HostDirectory} lists the hosts as {@link
 * org.mechservice.server.hosts.RegisteredHost}, polls them and drops those that do not answer. All
 * calls to hosts go through {@link org.mechservice.server.hosts.HostCalls}, which bounds the wait
 * for an answer. {@link org.mechservice.server.hosts.RunRegistry} keeps the latest state of all
 * runs, so that administrators see the runs of a host that is silent or lost.
 *
 * <p>{@link org.mechservice.server.hosts.Placement} chooses the host of a session by a {@link
 * org.mechservice.server.hosts.PlacementPolicy}. {@link
 * org.mechservice.server.hosts.MechServerServant} is what clients call, {@link
 * org.mechservice.server.hosts.HostRegistryServant} what hosts call; {@link
 * org.mechservice.server.hosts.FarmLimits} sets limits on all hosts.
 *
 * <p>Depends on mechsim-service's limits and contract types and on the ORB; knows nothing of
 * administration.
 */
@NullMarked
package org.mechservice.server.hosts;

import org.jspecify.annotations.NullMarked;
