/**
 * From a mechanism to a compiled model.
 *
 * <p>{@link org.mechservice.sim.model.ModelFactory} is the entry point. The request is a {@link
 * org.mechservice.mechml.MechmlModel} with {@link org.mechservice.sim.model.BuildOptions}
 * (formulation, closure, columns, settings); the result is a {@link
 * org.mechservice.sim.model.CompiledModel}, which makes instances for runs. The intermediate
 * product is a {@link org.mechservice.sim.model.GeneratedModel}: planned, and ready to be written
 * as Java source or as class files. {@link org.mechservice.sim.model.CodeForecast} describes the
 * code without writing it.
 *
 * <p>{@code ModelAssembly} decides part by part between code and data: {@code TreeClass} derives
 * the class of an open chain, {@code LoopTermsClass} the terms of a model with loops, {@code
 * ValuesClass} the triggers and assignments of events and the outputs. {@code ModelColumns} decides
 * which groups of columns come from data. {@link org.mechservice.sim.model.GeneratedFacts} and
 * {@link org.mechservice.sim.model.Omission} are the facts stored with a model: formulation,
 * reason, number of operations, omitted parts and their reasons.
 *
 * <p>Depends on {@code sim.scene} (choices), {@code sim.equations} (programs) and {@code sim.emit}
 * (classes). JAR files are made by {@code sim.packaging}.
 */
@NullMarked
package org.mechservice.sim.model;

import org.jspecify.annotations.NullMarked;
