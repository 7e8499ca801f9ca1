/**
 * The one gate for code that a user brings: every class of a user that runs anywhere passes through
 * here, and none is loaded in the process of its caller.
 *
 * <p>{@link org.mechservice.guard.UserCode} is the consent of the person or program: the folders
 * whose code may run, and whether it may run on a machine that cannot confine it. {@link
 * org.mechservice.guard.BytecodeVerifier} is the first wall, an allow-list of bytecode with the
 * members in {@code AllowedJava}. {@link org.mechservice.guard.Confinement} is the second one, of
 * the operating system: bubblewrap, which shows a process the {@code JavaFiles} alone, and a {@code
 * SystemCallFilter}. A wall counts only after {@code ConfinementProbe} has tried in vain to get out
 * of it. {@link org.mechservice.guard.UserCodePolicy} says what a host does without one, and {@link
 * org.mechservice.guard.WorkerBounds} what a process may use.
 *
 * <p>A whole run computes behind the walls where a host runs it, or a client what a server has
 * generated (package {@code guard.worker}). A program that runs a model in its own process has a
 * {@link org.mechservice.guard.ForceRelay}: in place of each class of a user the model gets a class
 * of the same name that hands every call on to a confined process, where {@code RelayMain} calls
 * the user's class. The numbers travel as they are, so the results have the same bits. {@link
 * org.mechservice.guard.Patience} ends a process that does not come back.
 */
@NullMarked
package org.mechservice.guard;

import org.jspecify.annotations.NullMarked;
