/**
 * From a {@link org.mechservice.sim.symbolic.Program} to Java source.
 *
 * <p>A {@link org.mechservice.sim.build.emit.ProgramPlan} says which methods there are, what each
 * computes in which order, and where every value lives; a printer only writes it down. So another
 * printer of the same plan gives the same operations in the same order.
 */
@NullMarked
package org.mechservice.sim.build.emit;

import org.jspecify.annotations.NullMarked;
