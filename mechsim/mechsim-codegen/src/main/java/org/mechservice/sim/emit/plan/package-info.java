/**
 * The division of a program into methods.
 *
 * <p>{@link org.mechservice.sim.emit.plan.CodeLayout} is the entry point. It plans a program in the
 * form that {@link org.mechservice.sim.emit.plan.CodeForm} asks for, or chooses the shorter one,
 * and returns a {@link org.mechservice.sim.emit.plan.ProgramPlan}: the methods, the order of their
 * calls, and the length of the workspace.
 *
 * <p>{@code StraightLinePlanner} puts sections into methods in their order, as many as the compiler
 * of the virtual machine handles well. {@code KernelPlanner} finds sections that compute the same
 * operations in the same order and makes them one method, a {@code Kernel}; {@code KernelBody}
 * compares them over numbered operands. {@code SectionSplitter} divides sections that are too long
 * for a method, {@code MethodPlanner} writes the statements of each method, and {@code
 * WorkspaceSlots} gives values that cross methods an element of the workspace.
 *
 * <p>No plan changes the order of operations, so all layouts compute the same bits. Depends on
 * {@code emit.method}. docs/theory/formulations.md#methods has the reasons,
 * docs/reports/generated-code.md the measurements.
 */
@NullMarked
package org.mechservice.sim.emit.plan;

import org.jspecify.annotations.NullMarked;
