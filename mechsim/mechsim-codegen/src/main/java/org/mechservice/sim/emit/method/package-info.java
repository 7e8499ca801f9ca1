/**
 * Planned methods as values, and their size in bytes.
 *
 * <p>{@link org.mechservice.sim.emit.method.MethodPlan} is the main type: the {@link
 * org.mechservice.sim.emit.method.Statement}s of one method, and the {@link
 * org.mechservice.sim.emit.method.ValueLocation} of each value in it. {@link
 * org.mechservice.sim.emit.method.MethodSignature} names the method that runs a program, {@link
 * org.mechservice.sim.emit.method.CallSequence} calls its parts, and {@link
 * org.mechservice.sim.emit.method.AngleGroup} is a run of sines and cosines computed in one loop.
 * {@link org.mechservice.sim.emit.method.ValueUsage} decides which values of a program get a
 * variable of their own.
 *
 * <p>{@link org.mechservice.sim.emit.method.StackCode} translates a planned method to instructions
 * of a stack machine. {@link org.mechservice.sim.emit.method.CodeSize} counts bytes with it, since
 * the virtual machine compiles no method above 8 000 bytes; the printer of byte code uses the same
 * walk, so the count is exact. {@link org.mechservice.sim.emit.method.TextPieces} cuts texts that
 * are longer than a constant.
 *
 * <p>Depends on symbolic programs only. The planners of {@code emit.plan} create these values; the
 * printers read them.
 */
@NullMarked
package org.mechservice.sim.emit.method;

import org.jspecify.annotations.NullMarked;
