/**
 * Integration of initial value problems y' = f(t, y), y(t<sub>0</sub>) = y<sub>0</sub>, with step
 * size and order chosen by the integrator. The package knows no mechanics and can be used on its
 * own; once an integration is under way, no step of it allocates memory.
 *
 * <p>{@link org.mechservice.solver.ode.solve.Ode} solves a problem in one call, with dense output,
 * events and options. What follows is for those who take the steps themselves.
 *
 * <h2>In ten lines</h2>
 *
 * The height of a ball thrown upwards at 20 m/s, every half second:
 *
 * <pre>{@code
 * OdeSystem ball = new Ballistics();                      // y = [height, velocity]
 * Integrator integrator = new Ode113(new IntegratorSettings(1e-6, 1e-9));
 * double[] y = new double[2];
 * double[] yDot = new double[2];
 * StepResult result = integrator.start(ball, 0, new double[] {0, 20}, 4);
 * for (double t = 0.5; t <= 4; t += 0.5) {
 *   while (result == StepResult.ADVANCED && integrator.time() < t) result = integrator.step();
 *   if (result == StepResult.FAILED) throw new ArithmeticException("" + integrator.failure());
 *   integrator.interpolate(t, y, yDot);
 *   heights.add(y[0]);
 * }
 * }</pre>
 *
 * with the right-hand side written into the array that is handed in:
 *
 * <pre>{@code
 * final class Ballistics implements OdeSystem {
 *   public int dimension() { return 2; }
 *   public void derivative(double t, double[] y, double[] yDot) {
 *     yDot[0] = y[1];
 *     yDot[1] = -9.81 - 0.01 * y[1] * Math.abs(y[1]);
 *   }
 * }
 * }</pre>
 *
 * <h2>Methods</h2>
 *
 * <table>
 * <caption>Which method for which problem</caption>
 * <tr><th>class</th><th>formulas</th><th>order</th><th>f per step</th><th>local error held to</th>
 * <th>at the end</th><th>when</th></tr>
 * <tr><td>{@link org.mechservice.solver.ode.adams.Ode113}</td><td>Adams predictor-corrector</td>
 * <td>1-13</td><td>2</td><td>max(rtol |y_i|, atol_i), every component</td><td>ends there exactly</td>
 * <td>not stiff; the first choice</td></tr>
 * <tr><td>{@link org.mechservice.solver.ode.adams.De}</td><td>the same</td><td>1-13</td><td>2</td>
 * <td>rtol |y_i| + atol_i, root of the sum of squares</td><td>steps past, interpolates</td><td>to
 * compare with results of the classical program</td></tr>
 * <tr><td>{@link org.mechservice.solver.ode.stiff.Ode15s}</td><td>numerical or backward
 * differentiation, implicit</td><td>1-5</td><td>1-4, and linear equations</td><td>max(rtol |y_i|,
 * atol_i), every component</td><td>ends there exactly</td><td>stiff</td></tr>
 * <tr><td>{@link org.mechservice.solver.ode.stiff.Ode15sR}</td><td>the same, for F(t, y, y') =
 * 0</td><td>1-5</td><td>1-4 of F, and linear equations</td><td>the same, algebraic components not
 * tested</td><td>ends there exactly</td><td>mass matrices, multipliers, implicit equations of index
 * 1</td></tr>
 * <tr><td>{@link org.mechservice.solver.ode.switching.Switching}</td><td>Adams, and differentiation
 * formulas where it gets stiff</td><td>1-13, 1-5</td><td>2, or those of ode15s</td><td>as
 * both</td><td>ends there exactly</td><td>stiffness comes and goes, or nobody knows</td></tr>
 * </table>
 *
 * <p>Adams methods need few evaluations when f is smooth and digits are many, and do worst when f
 * jumps. They are not made for stiff problems, in which some parts of the solution die out much
 * faster than the interesting ones move: there the step stays as small as the fastest part demands
 * although nothing moves that fast, and {@link
 * org.mechservice.solver.ode.IntegrationStatistics#stiffnessSuspected} says so.
 *
 * <p>ode15s takes the steps that the interesting parts ask for, however fast the others die out.
 * Each step solves n equations by some iterations with a matrix that is factored anew in one step
 * out of two to ten, and its orders are low: on a problem that is not stiff it takes three times
 * the steps of ode113 at six digits, six times at nine, each with more work besides f. It needs
 * ∂f/∂y: tell it by {@link org.mechservice.solver.ode.JacobianSystem} or leave it to differences;
 * with many unknowns in a line say so by {@link org.mechservice.solver.ode.BandedSystem}, in parts
 * that do not know each other by {@link org.mechservice.solver.ode.BlockSystem}, with many that
 * know few others by {@link org.mechservice.solver.ode.SparseSystem}. Fast oscillations that are
 * hardly damped hold it up. If neither method is known to suit, let {@link
 * org.mechservice.solver.ode.switching.Switching} find out.
 *
 * <h2>Mathematics of the Adams methods</h2>
 *
 * The solution obeys y(t<sub>n</sub> + h) = y<sub>n</sub> + ∫ f dt over the step. A predictor of
 * order k replaces f by the polynomial through its last k values and gives p; f at p adds one more
 * value; the corrector integrates the polynomial through all k + 1 and gives the new y, at which f
 * is evaluated again for the steps to come. The polynomials are held as divided differences, scaled
 * so that for equal steps they become plain differences; the coefficients follow from the last k
 * step sizes and need no work while the step stays the same. The difference of two correctors of
 * neighbouring order estimates the error of one step, and the same quantities for the orders k − 1,
 * k − 2 and k + 1 tell which order would allow the longest step. The start needs no other method:
 * it is order 1 with a small step, both growing at once.
 *
 * <p>The same polynomial gives the solution everywhere inside the last step, as accurately as at
 * its ends and without a further evaluation.
 *
 * <h2>Mathematics of the stiff method</h2>
 *
 * Here the polynomial goes through the last k values of y and the unknown new one, and its slope at
 * the new point must be f there: (1 − κ) γ (y − y*) + Σ γ<sub>m</sub> ∇<sup>m</sup>y<sub>n</sub> =
 * h f(t, y), with y* the value that the old polynomial extrapolates to. Because f is taken at the
 * new point, a part that dies out fast is damped whatever the step. κ = 0 gives the backward
 * differentiation formulas; the values of the numerical differentiation formulas buy longer steps
 * with some of their stability. The equations are solved by a simplified Newton iteration with I −
 * h γ<sup>−1</sup> J, whose J is kept until the iteration fails with it. y − y* is the next
 * backward difference and estimates the error; the neighbouring differences tell which order would
 * allow the longest step. Since a new step means a new factorisation and rewritten differences, it
 * is taken up only after k + 2 equal ones.
 *
 * <p>A system in residual form, F(t, y, y') = 0, is solved with the same formulas, which give y' at
 * the new point in terms of y: the iteration matrix is h γ<sup>−1</sup> ∂F/∂y + ∂F/∂y', of which
 * both parts are kept. Components whose derivative does not appear in F, such as multipliers, are
 * found with the others but are in no test: they only have to be finite. Such a system starts from
 * values that obey its equations; the derivatives and the algebraic components are corrected until
 * they do, the rest stays as given. What was said of bands and patterns holds here, too, for both
 * parts of the matrix.
 *
 * <h2>Events, jumps, manifolds</h2>
 *
 * {@link org.mechservice.solver.ode.events.EventIntegration} looks for changes of sign of {@link
 * org.mechservice.solver.ode.events.EventFunctions} in the steps of any method, on the interpolated
 * solution, and lets the state or the equations be changed there. A right-hand side that jumps at
 * known places says so by {@link org.mechservice.solver.ode.PiecewiseSystem}: steps end there and
 * nothing is evaluated across. Jumps that are not declared are met by failing error tests; of an f
 * of which only values are known {@link org.mechservice.solver.ode.jumps.UndeclaredJumps}, put
 * around any integrator, searches for jumps, pulses and poles. Components that follow from others
 * ({@link org.mechservice.solver.ode.CompletedSystem}) are in the history but in no test; a
 * solution on a manifold ({@link org.mechservice.solver.ode.ProjectedSystem}) is moved back onto it
 * inside every step.
 *
 * <h2>Saving an integration</h2>
 *
 * Between two steps the whole history can be {@linkplain org.mechservice.solver.ode.Integrator#save
 * saved} as bytes and {@linkplain org.mechservice.solver.ode.Integrator#resume taken up} by a new
 * integrator, which goes on with the same bits. A problem that depends on more than t and y is to
 * be a {@link org.mechservice.solver.ode.SavedSystem}. The polynomial of a step can be {@linkplain
 * org.mechservice.solver.ode.Integrator#keepStep kept} and evaluated later.
 *
 * <h2>Problems in problems</h2>
 *
 * What a problem tells of itself, such as its band or its Jacobian, are {@link
 * org.mechservice.solver.ode.SystemParts parts} that integrators ask for; a class that wraps
 * another problem passes them on.
 *
 * <h2>Modes</h2>
 *
 * The methods are those of known programs; {@link
 * org.mechservice.solver.ode.IntegratorSettings#withMode} says how closely to keep to them.
 *
 * <table>
 * <caption>What each mode does beyond the published program</caption>
 * <tr><th>mode</th><th>Adams methods</th><th>stiff methods</th><th>when</th></tr>
 * <tr><td>faithful</td><td>nothing</td><td>nothing</td><td>to compare counts and steps</td></tr>
 * <tr><td>standard</td><td>nothing</td><td>fewer iterations; shorter steps where nothing is
 * stiff</td><td>the default</td></tr>
 * <tr><td>strict</td><td>a 20th of the tolerances, 1.3 times the evaluations</td><td>the same,
 * 1.4 times the evaluations</td><td>the digits asked for have to arrive</td></tr>
 * </table>
 *
 * <h2>What the tolerance means</h2>
 *
 * The error of each step is held below the tolerance, not the error at the end: what errors become
 * on their way is up to the problem. On the usual test problems the end has one to three digits
 * fewer than asked for; on stable ones none. To judge a result, integrate again with a tenth of the
 * tolerance. Give each component an absolute tolerance at which it is negligible. In the
 * {@linkplain org.mechservice.solver.ode.IntegratorSettings.Mode#STRICT strict mode} a smaller
 * tolerance is used inside, so that as a rule the end has the digits asked for but one: in three
 * runs of four on orbits and oscillations, in nineteen of twenty on stiff problems.
 *
 * <h2>What can go wrong</h2>
 *
 * An integrator never hands out a state that is not finite. Told to stop, it returns {@link
 * org.mechservice.solver.ode.StepResult#STOPPED} within one evaluation, and the next {@code step}
 * goes on from there. When it cannot go on it returns {@link
 * org.mechservice.solver.ode.StepResult#FAILED}, keeps the last accepted step, and {@link
 * org.mechservice.solver.ode.IntegrationFailure} names cause, place, component and the last steps.
 * f says that it is not defined somewhere by a value that is not finite; the step is then tried
 * shorter. A jump of f costs some tens of rejected steps; one that changes little within a step, a
 * pulse shorter than the steps around it, and at loose tolerances a pole can be passed over: bound
 * the step by {@link org.mechservice.solver.ode.IntegratorSettings#maxStep}. An implicit step may
 * have no solution, where f jumps against the motion, or a singular matrix; both are tried with a
 * new Jacobian and shorter steps before they are reported. Wrong use is an exception.
 *
 * <p>A law that changes within less than the tolerance of its argument, such as friction by tanh(v
 * / w) with w below the error allowed of v, is a jump that only looks smooth. Where a block that
 * stuck to a moving belt breaks loose, stiff methods can pass the place with the derivatives of the
 * time when it stuck, or of a step before. What is left of the equations is watched for that: with
 * a search for undeclared jumps, of 3000 random runs each with w from 1e-8 to 1e-4 and tolerances
 * from 1e-11 to 1e-3, up to one in 300 still completed with a wrong state by the standard mode, one
 * in 3000 by the strict one; with steps held equal by a maxStep of a hundredth of the interval up
 * to one in 1000 and none. Of 120 random loops each with such friction in a joint none went wrong
 * with multipliers, up to one in 60 in independent coordinates. Declare sticking and slipping as
 * {@link org.mechservice.solver.ode.events.EventFunctions events}, or integrate again in the strict
 * mode and compare.
 *
 * <p>Results are the same to the bit on every machine if those of f are.
 *
 * <h2>Sources</h2>
 *
 * L. F. Shampine and M. K. Gordon, <i>Computer Solution of Ordinary Differential Equations</i>,
 * 1975; E. Hairer, S. P. Nørsett and G. Wanner, <i>Solving Ordinary Differential Equations I</i>,
 * III.5 and III.7; L. F. Shampine and M. W. Reichelt, <i>The MATLAB ODE Suite</i>, SIAM J. Sci.
 * Comput. 18 (1997) 1; R. W. Klopfenstein, <i>Numerical differentiation formulas for stiff systems
 * of ordinary differential equations</i>, RCA Review 32 (1971) 447; D. E. Salane, <i>Adaptive
 * routines for forming Jacobians numerically</i>, SAND86-1319 (1986).
 */
package org.mechservice.solver.ode;
