/**
 * Planned programs as byte code, without source and without a compiler.
 *
 * <p>{@link org.mechservice.sim.emit.bytes.ProgramBytes} is the main type: it writes the methods of
 * a {@link org.mechservice.sim.emit.plan.ProgramPlan} into a class file. {@code MethodBytes} writes
 * the body of one method, instruction by instruction as {@link
 * org.mechservice.sim.emit.method.StackCode} walks it; {@code CountingLoop} writes loops, {@link
 * org.mechservice.sim.emit.bytes.NumberInstructions} pushes numbers by the shortest instruction,
 * {@link org.mechservice.sim.emit.bytes.TextInstructions} texts of any length, and {@link
 * org.mechservice.sim.emit.bytes.ClassMethods} begins and ends methods.
 *
 * <p>{@link org.mechservice.sim.emit.bytes.MethodSizes} reads the lengths of methods from a
 * finished class file, to refuse a class that the virtual machine would not load (JVMS §4.7.3).
 *
 * <p>Depends on {@code emit.method}, {@code emit.plan} and ASM.
 */
@NullMarked
package org.mechservice.sim.emit.bytes;

import org.jspecify.annotations.NullMarked;
