/**
 * Methods that fit a scene, and models built with them.
 *
 * <p>A {@link org.mechservice.report.method.SimulationMethod} names formulation, closure and
 * integrator. {@link org.mechservice.report.method.MethodList} has the scene built with each of
 * them by a {@link org.mechservice.report.method.MethodBuilds}, which the library in process and
 * the client of a server implement: a {@link org.mechservice.report.method.Candidate} is a method
 * with its model and its solver classes, an {@link org.mechservice.report.method.OmittedMethod} one
 * that the builder refused, with the reason. {@link org.mechservice.report.method.ModelProblem}
 * presents a model's equations to the reference codes, and {@link
 * org.mechservice.report.method.ModelPhases} its events and the jumps of its state.
 */
@NullMarked
package org.mechservice.report.method;

import org.jspecify.annotations.NullMarked;
