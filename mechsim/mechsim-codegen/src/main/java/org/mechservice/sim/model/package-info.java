/**
 * From a mechanism to a compiled model.
 *
 * <p>{@link org.mechservice.sim.model.ModelFactory} is the way in. The request is a {@link
 * org.mechservice.mechml.MechmlModel} with {@link org.mechservice.sim.model.BuildOptions}
 * (formulation, closure, columns, settings); the result is a {@link
 * org.mechservice.sim.model.CompiledModel}, which makes instances for runs. Between the two stands
 * a {@link org.mechservice.sim.model.GeneratedModel}: planned, and ready to be written as Java
 * source or as class files. {@link org.mechservice.sim.model.CodeForecast} tells what would be
 * generated without writing it.
 *
 * <p>{@code ModelAssembly} decides part by part between code and data: {@code TreeClass} derives
 * the class of an open chain, {@code LoopTermsClass} the terms of a model with loops, {@code
 * ValuesClass} what events watch and assign and the outputs. {@code ModelColumns} decides which
 * groups of columns come from data beside the code. {@link
 * org.mechservice.sim.model.GeneratedFacts} and {@link org.mechservice.sim.model.Omission} are the
 * facts that travel with a model: formulation, reason, operations, what was left out and why.
 *
 * <p>Depends on {@code sim.scene} (choices), {@code sim.equations} (programs) and {@code sim.emit}
 * (classes). JAR files are made by {@code sim.packaging}.
 */
@NullMarked
package org.mechservice.sim.model;

import org.jspecify.annotations.NullMarked;
