/**
 * The interface between a generated model, the forces that users write, and the solver that runs
 * both.
 *
 * <p>{@link Model} is the main type: a name, a description and an initial state. {@link
 * ModelSource} creates models from values of tunable parameters, and {@link Solver} runs one. A
 * model implements the interfaces of {@code api.capability} for everything else that it can
 * compute. The types of {@code api.run} request, control and report a run; those of {@code
 * api.result} describe its rows.
 *
 * <p>Users implement {@link UserForce} for a force of their own, with {@link ForceDeclaration},
 * {@link ForceState}, {@link ForceLoads} and {@link ForceBlocks}. Their sources are compiled
 * against this package only.
 *
 * <p>The packages below {@code solver.api} use only types of java.base and of {@code
 * solver.catalogue}. A model JAR is compiled against them. In local mode the client and the fetched
 * solver share them. {@link Model#API_VERSION} is their version: a JAR that was built for another
 * version is refused.
 */
package org.mechservice.solver.api;
