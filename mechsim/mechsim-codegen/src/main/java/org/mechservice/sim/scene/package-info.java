/**
 * Analysis of a mechanism before anything is generated from it.
 *
 * <p>{@link org.mechservice.sim.scene.SceneAnalysis} describes the tree: where each joint is in the
 * state, the degrees of freedom, and suspicious data such as a joint that moves no mass. {@link
 * org.mechservice.sim.scene.LoopAnalysis} describes the loops: their equations, the rank of these,
 * and how well the start closes them. Each {@link org.mechservice.sim.scene.Finding} has a code of
 * the error catalogue.
 *
 * <p>Three classes decide about {@code auto}: {@link org.mechservice.sim.scene.FormulationChoice}
 * (formulation and closure), {@link org.mechservice.sim.scene.IntegratorSelection} (integrator),
 * and {@link org.mechservice.sim.scene.GenerationLimits} (code or data). {@code FastestMotion}
 * finds the dominant eigenvalues of the linearised equations for two of them, with Commons Math.
 *
 * <p>Depends on the mechanism and the data-driven formulations of solver-mechanics. Independent of
 * equations and code. The mathematics is in docs/theory/motion.md and docs/theory/loops.md.
 */
@NullMarked
package org.mechservice.sim.scene;

import org.jspecify.annotations.NullMarked;
