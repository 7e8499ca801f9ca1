/**
 * Analyses of a mechanism beside the integration of its motion.
 *
 * <p>The package contains static equilibrium ({@code StaticEquilibrium}), inverse dynamics and
 * prescribed motion ({@link org.mechservice.solver.analysis.InverseDynamics}, {@code
 * PrescribedModel}) and small motions about a state ({@code Linearisation}, {@code Modes}). Whether
 * an equilibrium is stable, {@code EquilibriumStability} finds out. The models of these analyses
 * compute each state from algebraic equations; their common base is {@code AnalysisModel}.
 *
 * <p>The equations that they share are in {@code analysis.equation}, the columns of results that
 * need them in {@code analysis.column}.
 *
 * <p>The package depends on {@code solver.api} and on the mechanics of the model.
 */
package org.mechservice.solver.analysis;
