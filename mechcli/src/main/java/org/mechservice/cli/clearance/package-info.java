/**
 * {@code mech clearance}: how near bodies come to each other over a run, with proved bounds.
 *
 * <p>{@link org.mechservice.cli.clearance.ClearanceCommand} takes the shapes of bodies from {@code
 * BodyParts} and their poses from {@code BodyMotion}; the distances are those of {@code
 * org.mechservice.solver.distance}.
 */
package org.mechservice.cli.clearance;
