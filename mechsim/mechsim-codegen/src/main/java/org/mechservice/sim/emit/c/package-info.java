/**
 * Models as C99, the third language of the same plans.
 *
 * <p>{@link org.mechservice.sim.emit.c.CModel} takes the programs of a mechanism and returns the
 * files: a header that documents every array, the code, the elementary functions with the bits of
 * Java's StrictMath ({@code mech_math.c}), and an example that steps the model. {@code CSource}
 * writes the functions that a program calls. {@code CPrograms} plans the programs as for Java and
 * prints them by {@code emit.source.ProgramPrinter} in the syntax of {@code CSyntax}; operations
 * and their order are the same, so with {@code -ffp-contract=off} the results are the same bits.
 *
 * <p>Of closed loops ({@link org.mechservice.sim.emit.c.CLoops}) the programs give the terms, as on
 * the Java machine; {@code mech_loops.c} solves them as {@code solver.closure} does by penalty, in
 * the same order of operations, by the layout that {@code CLoopLayout} writes. {@link
 * org.mechservice.sim.emit.c.CEvents} has events and times of jumps, {@link
 * org.mechservice.sim.emit.c.CInputs} loads that stand for forces written as classes.
 *
 * <p>For units that take steps themselves, {@link org.mechservice.sim.emit.c.CWatch} has what the
 * steps watch: a program of quantities, and the tape that {@code CWatchTape} writes as constant
 * arrays for {@code mech_watch.c} of {@code sim.fmu}.
 *
 * <p>{@code CTangents} differentiates the equations along directions, for Jacobians and the
 * directional derivatives of FMUs.
 *
 * <p>The package knows no files and no compilers; {@code sim.model.ModelFactory} derives the
 * programs and refuses what has no C yet.
 */
package org.mechservice.sim.emit.c;
