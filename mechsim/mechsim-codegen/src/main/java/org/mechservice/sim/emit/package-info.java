/**
 * The classes of a model, planned and written as Java source or as a class file.
 *
 * <p>{@link org.mechservice.sim.emit.GeneratedClass} is the main type: one class of a model, ready
 * to be written in either form. {@link org.mechservice.sim.emit.ModelPlan} is the class of an open
 * chain, made from the programs of a {@link org.mechservice.sim.emit.ModelClass}; {@link
 * org.mechservice.sim.emit.TermsPlan} makes the class of the terms of a model with loops, and
 * {@link org.mechservice.sim.emit.ValuesPlan} the class of triggers and assignments of events and
 * of outputs; {@link org.mechservice.sim.emit.CompactClass} holds the mechanism as data. {@link
 * org.mechservice.sim.emit.MainClass} is the main class of a standalone JAR.
 *
 * <p>A program passes through the subpackages: {@code plan} divides it into methods and gives every
 * value a location; {@code method} holds such planned methods and measures their length; {@code
 * source} prints them as Java, {@code bytes} as byte code. Both printers follow one plan and write
 * the same operations in the same order, so their results have the same bits.
 *
 * <p>Depends on symbolic programs and ASM. This package receives the mechanics as programs; only
 * the layout of the Jacobian comes from {@code equations.derivatives}. See
 * docs/theory/formulations.md#generated-code.
 */
@NullMarked
package org.mechservice.sim.emit;

import org.jspecify.annotations.NullMarked;
