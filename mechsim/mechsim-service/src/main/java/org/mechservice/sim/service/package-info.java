/**
 * The servants behind MechSim, IMechSimRemote and ResultCursor.
 *
 * <p>{@link org.mechservice.sim.service.SessionTable} is the way in: it opens sessions, and ends
 * those that nobody renews. A session owns its simulations, a simulation its rows and the cursors
 * over them. {@link org.mechservice.sim.service.Refusal} makes the contract's exceptions.
 */
@NullMarked
package org.mechservice.sim.service;

import org.jspecify.annotations.NullMarked;
