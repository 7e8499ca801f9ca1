/**
 * Models of closed loops as an integrator sees them, one class per formulation and closure.
 *
 * <p>{@link org.mechservice.solver.closure.model.ProjectionModel} integrates independent
 * coordinates (second velocity transformation); {@link
 * org.mechservice.solver.closure.model.Partition} chooses them, {@link
 * org.mechservice.solver.closure.model.Completion} computes the dependent ones, and {@link
 * org.mechservice.solver.closure.model.SingularityMonitor} monitors the rank during the run. {@link
 * org.mechservice.solver.closure.model.PenaltyModel} integrates all tree coordinates with the
 * augmented Lagrangian and projects at accepted steps. Both have a residual form for ode15sR with
 * difference quotients (RR) and one with analytic derivatives (RR-JF).
 *
 * <p>Sources: Rodríguez et al. 2003, section 3; García de Jalón and Bayo, <i>Kinematic and Dynamic
 * Simulation of Multibody Systems</i>, 1994, chapters 5 and 6.
 */
package org.mechservice.solver.closure.model;
