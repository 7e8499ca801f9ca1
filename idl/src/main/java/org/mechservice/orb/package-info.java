/**
 * Starts an ORB safely for clients, servers and hosts; contains no service logic.
 *
 * <p>{@link org.mechservice.orb.ServiceOrb} is the entry: it makes an ORB for one of the three
 * roles, publishes objects under the names of {@link org.mechservice.orb.ServiceKey}, connects to
 * servers that a {@code ServiceUrl} locates, and closes everything. {@link
 * org.mechservice.orb.GuardedServant} stands between the ORB and each servant, so that unexpected
 * exceptions reach the log and not the caller. {@code OrbProperties} lists the ORB's properties
 * with their reasons. Errors for users are {@link org.mechservice.orb.ServiceUnreachableException}
 * and {@link org.mechservice.orb.PortInUseException}.
 *
 * <p>Depends on {@link org.mechservice.orb.connection} for sockets and memory limits, on {@link
 * org.mechservice.orb.tls} for identities, and on JacORB 3.9.
 */
@NullMarked
package org.mechservice.orb;

import org.jspecify.annotations.NullMarked;
