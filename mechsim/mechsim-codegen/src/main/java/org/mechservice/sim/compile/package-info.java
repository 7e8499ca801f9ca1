/**
 * Class files in memory: compiling, loading, and following their references.
 *
 * <p>{@link org.mechservice.sim.compile.ModelCompiler} compiles the Java source of a model with the
 * compiler of the running JDK; {@code CompactLocals} packs the local variables of the result.
 * {@link org.mechservice.sim.compile.Compilation} is one run of the compiler over sources in memory
 * and serves user forces too. Models are normally written as class files directly, without this
 * compiler; tests compile the source and compare the bits.
 *
 * <p>{@link org.mechservice.guard.ModelClassLoader} loads the classes of one model; {@link
 * org.mechservice.sim.compile.ReusedCode} those of many that differ in numbers only, once. {@link
 * org.mechservice.guard.SolverClasses} gives the class files of this process's solver and their
 * fingerprint. {@link org.mechservice.sim.compile.ReachableClasses} follows the names in constant
 * pools from given classes to all classes that they need (JVMS §4.4).
 *
 * <p>Depends on {@code javax.tools} and ASM only.
 */
@NullMarked
package org.mechservice.sim.compile;

import org.jspecify.annotations.NullMarked;
