/**
 * Starting an ORB safely; no service logic.
 *
 * <p>{@link org.mechservice.orb.ServiceOrb} is the way in for clients, servers and hosts. Errors:
 * {@link org.mechservice.orb.ServiceUnreachableException} and {@link
 * org.mechservice.orb.PortInUseException}, both with one message fit for users.
 */
@NullMarked
package org.mechservice.orb;

import org.jspecify.annotations.NullMarked;
