/**
 * Sessions of clients and the servants behind MechSim and IMechSimRemote.
 *
 * <p>{@link org.mechservice.sim.service.session.SessionTable} is the entry: it opens sessions, ends
 * those whose lease is over, and runs the host's clock. A {@code Session} owns its simulations and
 * their cursors. {@code MechSimServant} reads models; {@code RunCreation} creates its simulations,
 * which may contain classes of users if {@code UserCodeAdmission} lets them, and {@code SignedJars}
 * makes its JARs. {@code SimulationServant} steers one run; {@code EndedRunServant} reopens a run
 * that has ended. {@code HostServices} lists what the sessions of a host share.
 *
 * <p>{@link org.mechservice.sim.service.session.WarmUp} loads the classes of a host before its
 * first client needs them.
 *
 * <p>Depends on all other packages of the service; only {@code sim.host} depends on this one.
 */
@NullMarked
package org.mechservice.sim.service.session;

import org.jspecify.annotations.NullMarked;
