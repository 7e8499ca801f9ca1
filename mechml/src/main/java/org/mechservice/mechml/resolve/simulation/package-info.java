/**
 * Simulation blocks: what to compute, over which interval, by which method.
 *
 * <p>{@link org.mechservice.mechml.resolve.simulation.SimulationsReader} reads all blocks of a file
 * and chooses the one that the user names. {@link
 * org.mechservice.mechml.resolve.simulation.SimulationReader} reads one block; it passes the time
 * set to {@link org.mechservice.mechml.resolve.simulation.TimeSetReader}, the integrator with its
 * tolerances to {@link org.mechservice.mechml.resolve.simulation.IntegratorReader}, and the events
 * to {@link org.mechservice.mechml.resolve.simulation.EventsReader}.
 *
 * <p>The result is a {@link org.mechservice.mechml.SimulationSettings}. A task that is not
 * integrated over time, such as a static equilibrium, gets the instant 0 and default tolerances.
 */
@NullMarked
package org.mechservice.mechml.resolve.simulation;

import org.jspecify.annotations.NullMarked;
