/**
 * Derivatives of the residual F(t, q, v, v') by q, v and v', for the formulation RR-JF.
 *
 * <p>{@link org.mechservice.sim.equations.derivatives.ResidualDerivatives} is the main type: it
 * records the mass matrix M, ∂F/∂v and ∂F/∂q as one program. {@code LinkRows} derives the rows of a
 * link, moving its columns inwards joint by joint; {@code JointColumns} holds the columns S with
 * their derivatives ψ' and ψ''; {@code ForceSlopes} differentiates the applied forces, one
 * direction at a time.
 *
 * <p>{@code TreeOrder} numbers the velocities from the root outwards, {@code ElementLayout} gives
 * the output index of each element, and {@code ElementSums} adds the contributions of inertia,
 * forces and rods. Elements that are zero in every state are neither computed nor output.
 *
 * <p>Depends on {@code links}, {@code kinematics}, {@code recursion}, {@code force} and {@code
 * loop}. Source: Singh, Russell and Wensing, "Efficient analytical derivatives of rigid-body
 * dynamics using spatial vector algebra", 2022;
 * docs/theory/formulations.md#rr-jf-the-jacobian-by-recursion.
 */
@NullMarked
package org.mechservice.sim.equations.derivatives;

import org.jspecify.annotations.NullMarked;
