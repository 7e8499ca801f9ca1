/**
 * Discontinuities of the motion of an open tree: events of the model file with their changes of
 * state, and jumps of prescribed motions.
 *
 * <p>{@link org.mechservice.solver.dynamics.event.StateEvents} evaluates the event expressions and
 * applies the changes. {@link org.mechservice.solver.dynamics.event.DrivenJumps} applies a jump of
 * a prescribed velocity to the free joints by the impulse equations M_ff Δv_f = −M_fd Δv_d, so that
 * the momentum of the free directions is conserved. {@link
 * org.mechservice.solver.dynamics.event.WrittenValues} is the interface to generated code that
 * evaluates the expressions of events and outputs.
 *
 * <p>An integrator sees both kinds as event functions, whose zeros it locates; the state is changed
 * there and the integration restarts.
 */
package org.mechservice.solver.dynamics.event;
