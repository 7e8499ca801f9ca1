/**
 * Equations of motion of open chains, driven by the data of a {@link
 * org.mechservice.solver.mechanism.Mechanism}.
 *
 * <p>One class per formulation: {@link org.mechservice.solver.dynamics.OpenTreeModel} holds the
 * common part (state, loads, poses, energies), {@link
 * org.mechservice.solver.dynamics.DataDrivenModel} is DTR, {@link
 * org.mechservice.solver.dynamics.SemiRecursiveModel} DSR, {@link
 * org.mechservice.solver.dynamics.RecursiveResidualModel} RR and {@link
 * org.mechservice.solver.dynamics.LinearisedResidualModel} RR-JF. Generated model classes are
 * specialised forms of these and are tested against them. {@code UserForced...} classes add user
 * force classes to a generated model.
 *
 * <p>The recursions are in {@code dynamics.recursion}, sparse linear algebra in {@code
 * dynamics.tree}, derivatives in {@code dynamics.derivative}, events in {@code dynamics.event}. The
 * mechanism is immutable and shared; each run has its own workspace.
 *
 * <p>Source: Rodríguez et al. 2003, section 3; Featherstone 2008.
 */
package org.mechservice.solver.dynamics;
