/**
 * Analyses of a mechanism beside the integration of its motion.
 *
 * <p>The package contains static equilibrium ({@code StaticEquilibrium}), inverse dynamics and
 * prescribed motion ({@link org.mechservice.solver.analysis.InverseDynamics}, {@code
 * PrescribedModel}) and small motions about a state ({@code Linearisation}, {@code Modes}). The
 * models of these analyses compute each state from algebraic equations; their common base is {@code
 * AnalysisModel}.
 *
 * <p>The classes whose names end in {@code Columns} compute further columns of the results in a
 * given state: reactions and multipliers, forces, drives, momenta, constraint residuals. Each kind
 * is a class of its own, so that a standalone JAR carries only the columns of its scene.
 *
 * <p>The package depends on {@code solver.api} and on the mechanics of the model.
 */
package org.mechservice.solver.analysis;
