/**
 * The library's front: an initial value problem solved in one call.
 *
 * <pre>{@code
 * OdeSolution orbit = Ode.solve(
 *     (t, y, yDot) -> { yDot[0] = y[1]; yDot[1] = -y[0]; }, 0, new double[] {1, 0}, 10);
 * double x = orbit.at(3.5)[0];
 * }</pre>
 *
 * <p>{@link org.mechservice.solver.ode.solve.Ode} takes y' = f(t, y) and M y' = f(t, y), {@link
 * org.mechservice.solver.ode.solve.Dae} takes F(t, y, y') = 0. A lambda is enough; what else is
 * known, bands, patterns, Jacobians or their products with vectors, breakpoints, is added to an
 * {@link org.mechservice.solver.ode.solve.OdeProblem} or {@link
 * org.mechservice.solver.ode.solve.DaeProblem} part by part and stays with it when its function is
 * wrapped. {@link org.mechservice.solver.ode.solve.OdeOptions} says how to integrate and who is
 * told in the course of it: {@link org.mechservice.solver.ode.solve.OdeEvent events}, {@link
 * org.mechservice.solver.ode.solve.StepHandler steps}, {@link
 * org.mechservice.solver.ode.solve.OdeOptions.OutputHandler states at given times}, {@link
 * org.mechservice.solver.ode.solve.OdeCheckpoint checkpoints}. {@link
 * org.mechservice.solver.ode.solve.OdeSolution} is what came of it: a function of t with the
 * accuracy of the steps. An integration that cannot reach its end throws {@link
 * org.mechservice.solver.ode.solve.IntegrationException}, which says where, why, and what to try.
 *
 * <p>Arrays are written in place. A run allocates nothing in its steps but what the solution keeps
 * of them; {@link org.mechservice.solver.ode.solve.OdeOptions#keepSteps} switches that off. Who
 * wants to take each step by hand uses an {@link org.mechservice.solver.ode.Integrator}.
 */
package org.mechservice.solver.ode.solve;
