/**
 * A simulation host: the servant that opens sessions, and the process around it.
 *
 * <p>{@link org.mechservice.sim.host.SimHost} is the servant of MechSimHost: it opens sessions in a
 * {@code SessionTable}, reports its load and events, and is drained, limited and stopped by
 * operators. A server has one in its own process. {@link org.mechservice.sim.host.SimHostProcess}
 * is the process behind {@code mech simhost}: it opens a port from {@link
 * org.mechservice.sim.host.HostSettings} and registers at its servers; one {@code
 * ServerRegistration} per server renews the registration until the process is closed.
 *
 * <p>Depends on the packages below {@code sim.service} and on the ORB.
 */
@NullMarked
package org.mechservice.sim.host;

import org.jspecify.annotations.NullMarked;
