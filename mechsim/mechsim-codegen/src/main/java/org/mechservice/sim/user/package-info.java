/**
 * Java classes that users have written for their forces: checked before anything loads them.
 *
 * <p>{@link org.mechservice.sim.user.UserClasses} is the main type and the only place where such
 * classes are admitted. {@code admit} takes the files that came with a model: {@code
 * UserClassFiles} reads class files and has sources compiled by {@code SourceCompiler}, {@code
 * NeededClasses} follows references from the forces of the model, and {@code ForceClassCheck}
 * decides whether a class is a force. {@code UserCodeFindings} collects what is wrong, so that a
 * user sees all errors at once.
 *
 * <p>What is admitted runs only behind the walls of package {@code guard}: an allow-list of
 * bytecode and confinement by the operating system. {@code IdleForces} replaces user classes in
 * processes that need their names alone.
 *
 * <p>Depends on {@code guard}, {@code sim.compile} and ASM.
 */
@NullMarked
package org.mechservice.sim.user;

import org.jspecify.annotations.NullMarked;
