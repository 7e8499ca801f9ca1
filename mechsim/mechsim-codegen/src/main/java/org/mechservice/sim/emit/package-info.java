/**
 * From a {@link org.mechservice.sim.symbolic.Program} to Java source and to a class file.
 *
 * <p>A {@link org.mechservice.sim.emit.ModelPlan} says which methods there are, what each computes
 * in which order, and where every value lives; two printers write it down, one as text for people,
 * one as byte code for the virtual machine. Both write the same operations in the same order, so
 * their results have the same bits.
 */
@NullMarked
package org.mechservice.sim.emit;

import org.jspecify.annotations.NullMarked;
