/**
 * Location of events: changes of sign of functions of the solution, in the steps of any method.
 *
 * <p>{@link EventIntegration} drives an integrator from event to event and lets the state or the
 * equations be changed there. {@link EventFunctions} is what the problem provides. {@link
 * EventValues} evaluates the functions on the interpolated solution, {@link EventSigns} keeps the
 * sign on each side, so that an event found once is not found again, and {@link EventSearch}
 * brackets the first change of sign in a step. {@link TurnSearch} looks for functions that come to
 * zero and turn back between two points of the search, and {@link NoEventLog} keeps the places that
 * look like events and are none. {@link AccumulationMonitor} notices events that follow each other
 * at ever shorter distances, such as the bounces of a ball (Zeno behaviour).
 *
 * <p>The package depends on {@code ode} and {@code ode.step}, on no method. Source: L. F. Shampine
 * and S. Thompson, <i>Event location for ordinary differential equations</i>, Comput. Math. Appl.
 * 39 (2000) 43.
 */
package org.mechservice.solver.ode.events;
