/**
 * The interface between a generated model, the forces that users write, and the solver that runs
 * both.
 *
 * <p>{@link Model} is the main type: a name, a description and an initial state. {@link
 * ModelSource} makes models from values of tunable parameters, and {@link Solver} runs one. What a
 * model can compute beyond that, it says by the interfaces of {@code api.capability}. A run is
 * requested, steered and reported by the types of {@code api.run}; its rows are described by those
 * of {@code api.result}.
 *
 * <p>{@link UserForce} is what users implement for a force of their own, with {@link
 * ForceDeclaration}, {@link ForceState}, {@link ForceLoads} and {@link ForceBlocks}. Their sources
 * are compiled against this package alone.
 *
 * <p>The packages below {@code solver.api} use only types of java.base and of {@code
 * solver.catalogue}. A model JAR is compiled against them. In local mode the client and the fetched
 * solver share them. {@link Model#API_VERSION} is their version: a JAR that was built for another
 * version is refused.
 */
package org.mechservice.solver.api;
