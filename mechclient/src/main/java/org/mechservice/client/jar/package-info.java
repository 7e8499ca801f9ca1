/**
 * JARs from the server, and models loaded from them.
 *
 * <p>The interface: {@link org.mechservice.client.jar.BuiltJar} is a JAR with its manifest and
 * hashes, {@link org.mechservice.client.jar.LocalRuns} runs it once, behind the walls of classes of
 * users, {@link org.mechservice.client.jar.LocalModel} is a model with its solver for programs that
 * run it themselves, in their process, {@link org.mechservice.client.jar.JarCache} the folder of
 * fetched runtime JARs.
 *
 * <p>Behind it: {@code JarFetch} fetches the model JAR and, unless the cache has it, the runtime
 * JAR. {@code JarOrigin} checks signatures, {@code BuiltJar} and {@code JarCache} check SHA-256
 * hashes; both happen before a class is loaded, and so does the verification of all classes, whose
 * result is a {@code VerifiedJar}. {@code FetchedJar} holds a checked JAR in memory, so that the
 * bytes that were checked are the bytes that are loaded. {@code FetchedClasses} loads classes from
 * the two JARs; its parent is the platform loader with artifact {@code solver-api} of the client,
 * and nothing else of the client. {@code FetchedModel} finds the model's class by its name and the
 * solver as a service.
 *
 * <p>The package depends on {@code client.run} and {@code client.failure}, the contract, {@code
 * guard} and {@code solver-api}.
 */
@NullMarked
package org.mechservice.client.jar;

import org.jspecify.annotations.NullMarked;
