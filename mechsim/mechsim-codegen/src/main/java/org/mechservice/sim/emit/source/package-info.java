/**
 * Planned programs as Java source for people to read.
 *
 * <p>{@link org.mechservice.sim.emit.source.ProgramPrinter} is the main type: it prints the methods
 * of a {@link org.mechservice.sim.emit.plan.ProgramPlan}. {@code ExpressionPrinter} writes a value
 * as an expression with no more parentheses than needed, and {@code LocalNames} gives variables the
 * names of mechanics.
 *
 * <p>{@link org.mechservice.sim.emit.source.SourceLines} collects the text, indented and at most
 * 100 columns wide. {@link org.mechservice.sim.emit.source.JavaText} makes any text from a model
 * file safe inside literals and comments.
 *
 * <p>The text is a second form of what {@code emit.bytes} writes: compiled, it computes the same
 * bits. Depends on {@code emit.method} and {@code emit.plan}.
 */
@NullMarked
package org.mechservice.sim.emit.source;

import org.jspecify.annotations.NullMarked;
