/**
 * JAR files of models and of the solver.
 *
 * <p>{@link org.mechservice.sim.packaging.ModelJars} makes the JARs of a compiled model: one
 * without a solver, which runs beside the runtime JAR, and a standalone one with the solver classes
 * that the model reaches. {@link org.mechservice.sim.packaging.RuntimeJar} is the solver as one
 * JAR, made by the build. Both return a {@link org.mechservice.sim.packaging.JarImage}: the bytes
 * with their SHA-256 and manifest.
 *
 * <p>{@code ReproducibleJar} writes an ordinary JAR with {@code java.util.jar}; the same content
 * gives the same bytes. {@code ModelDescriptionXml} writes {@code META-INF/modelDescription.xml},
 * the list of a model's variables, units and start values. {@code ChosenClasses} names the solver
 * classes that only some models need.
 *
 * <p>Depends on {@code sim.model} and {@code sim.compile}; nothing of code generation depends on
 * it. Sources: PKWARE APPNOTE 6.3 (ZIP) and the JAR File Specification of Java 17.
 */
@NullMarked
package org.mechservice.sim.packaging;

import org.jspecify.annotations.NullMarked;
