/**
 * Java classes that users have written for their forces: checked before anything loads them.
 *
 * <p>{@link org.mechservice.sim.user.UserClasses} is the main type and the only place where such
 * classes are admitted and loaded. {@code admit} takes the files that came with a model: {@code
 * UserClassFiles} reads class files and has sources compiled by {@code SourceCompiler}, {@code
 * NeededClasses} follows references from the forces of the model, and {@code ForceClassCheck}
 * decides whether a class is a force. {@code UserCodeFindings} collects what is wrong, so that a
 * user sees all errors at once.
 *
 * <p>{@code BytecodeVerifier} protects this machine by an allow-list: a class may use its own
 * classes, the force interface and the members that {@code AllowedJava} lists. Everything else is
 * refused. Confinement by the operating system is a second protection, outside this package. {@code
 * IdleForces} replaces user classes in processes that must not load them.
 *
 * <p>Depends on {@code sim.compile} and ASM.
 */
@NullMarked
package org.mechservice.sim.user;

import org.jspecify.annotations.NullMarked;
