/**
 * Places at which the motion of an open tree is not smooth: events of the model file with their
 * changes of state, and jumps of prescribed motions.
 *
 * <p>{@link org.mechservice.solver.dynamics.event.StateEvents} evaluates the event expressions and
 * applies the changes. {@link org.mechservice.solver.dynamics.event.DrivenJumps} carries a jump of
 * a prescribed velocity to the free joints by the impulse equations, so that momentum along free
 * directions is kept. {@link org.mechservice.solver.dynamics.event.WrittenValues} checks what a
 * change of state may write.
 */
package org.mechservice.solver.dynamics.event;
