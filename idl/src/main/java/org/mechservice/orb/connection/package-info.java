/**
 * The connections of an ORB: which are allowed, how much memory they use, how they are closed.
 *
 * <p>{@link org.mechservice.orb.connection.OutboundAllowList} lists the addresses that an ORB may
 * connect to; {@link org.mechservice.orb.connection.InboundConnections} closes the connections that
 * others have opened. {@link org.mechservice.orb.connection.LimitedBuffers} bounds one message,
 * {@code RequestMemory} all messages that arrive, and {@link
 * org.mechservice.orb.connection.ReplyMemory} all replies that are not read yet: {@code
 * RequestStream} and {@code ReplyQueue} watch single connections.
 *
 * <p>{@code ConnectionTable} and {@code CallConnection} replace classes of JacORB that deadlock or
 * lose calls when both ends close at once; {@link org.mechservice.orb.connection.OrbField} reaches
 * the fields that JacORB has no setting for. The socket factories are made by the ORB from class
 * names in its properties.
 *
 * <p>Depends on JacORB alone. Message headers: OMG, CORBA 3.0, section 15.4.1.
 */
@NullMarked
package org.mechservice.orb.connection;

import org.jspecify.annotations.NullMarked;
