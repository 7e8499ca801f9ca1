/**
 * The steps of the recursions over a tree of links, each written once over scalars.
 *
 * <p>{@link org.mechservice.solver.step.LinkStep} takes motions, articulated inertias, wrenches and
 * accelerations from a link's parent to the link and back. Its {@link
 * org.mechservice.solver.step.LinkNumbers} are constants where code is written for one mechanism,
 * and inputs in the methods that serve all mechanisms. {@link
 * org.mechservice.solver.step.DegreeOfFreedom} describes the motion of a link by one velocity;
 * {@link org.mechservice.solver.step.Motion}, {@link org.mechservice.solver.step.Twist}, {@link
 * org.mechservice.solver.step.Wrench} and {@link org.mechservice.solver.step.ArticulatedInertia}
 * are the spatial quantities of the equations.
 *
 * <p>Depends on {@code links} and on symbolic scalars. Sources: Featherstone 2008, ch. 2, 5 and 7;
 * docs/theory/formulations.md.
 */
package org.mechservice.solver.step;
