/**
 * MechServer: where clients connect, where hosts register, what administrators ask.
 *
 * <p>{@link org.mechservice.server.MechServerProcess} is the way in.
 */
@NullMarked
package org.mechservice.server;

import org.jspecify.annotations.NullMarked;
