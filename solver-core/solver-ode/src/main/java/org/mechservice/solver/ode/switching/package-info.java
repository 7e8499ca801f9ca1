/**
 * A method that changes between {@code ode113} and {@code ode15s} as stiffness comes and goes.
 *
 * <p>{@link Switching} runs one of the two and hands over. {@link StiffnessEvidence} decides when
 * an implicit method is to take over, {@link StiffPhaseCost} when it is to be left. {@link
 * StepForecast} estimates from the {@link SampledHistory} of an Adams method how long steps of a
 * backward formula would be; {@link StepCosts} is the model of what steps cost, the same on every
 * machine; {@link StiffPhaseCost} compares what an implicit phase has spent with what an Adams
 * method would have. {@link MethodChanges} keeps the first changes for the report of a run.
 *
 * <p>The package depends on {@code ode.adams} and {@code ode.stiff}; neither knows it, so that a
 * JAR with one method does not carry the other. Source: L. R. Petzold, <i>Automatic selection of
 * methods for solving stiff and nonstiff systems of ordinary differential equations</i>, SIAM J.
 * Sci. Stat. Comput. 4 (1983) 136; the criteria are our own.
 */
package org.mechservice.solver.ode.switching;
