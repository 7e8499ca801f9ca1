/**
 * Models of closed loops as an integrator sees them, one class per formulation and closure.
 *
 * <p>{@link org.mechservice.solver.closure.model.ProjectionModel} integrates independent
 * coordinates (second velocity transformation); {@link
 * org.mechservice.solver.closure.model.Partition} chooses them, {@link
 * org.mechservice.solver.closure.model.Completion} finds the dependent ones, and {@link
 * org.mechservice.solver.closure.model.SingularityMonitor} watches the rank on the way. {@link
 * org.mechservice.solver.closure.model.PenaltyModel} integrates all tree coordinates with the
 * augmented Lagrangian and projects at accepted steps. Each has a residual form for ode15sR, and
 * the projection one a form with analytic derivatives.
 *
 * <p>Sources: Rodríguez et al. 2003, section 3; García de Jalón and Bayo, <i>Kinematic and Dynamic
 * Simulation of Multibody Systems</i>, 1994, chapters 5 and 6.
 */
package org.mechservice.solver.closure.model;
