/**
 * JAR files: their bytes and their content.
 *
 * <p>{@link org.mechservice.sim.jar.ReproducibleJar} writes an ordinary JAR with {@code
 * java.util.jar}; the same content gives the same bytes. {@link
 * org.mechservice.sim.jar.ReachableClasses} follows the names in constant pools from some classes
 * to all that these need, which decides what a standalone JAR carries. {@link
 * org.mechservice.sim.jar.ModelDescriptionXml} writes {@code META-INF/modelDescription.xml}, the
 * list of a model's variables, units and start values.
 *
 * <p>The package knows class files and the solver's description of a model. It does not know scenes
 * or generated code; {@code ModelJars} of package {@code sim.model} joins the two.
 *
 * <p>Sources: PKWARE APPNOTE 6.3 (ZIP), the JAR File Specification of Java 17, and the Java Virtual
 * Machine Specification 17, section 4.4 (constant pool).
 */
@NullMarked
package org.mechservice.sim.jar;

import org.jspecify.annotations.NullMarked;
