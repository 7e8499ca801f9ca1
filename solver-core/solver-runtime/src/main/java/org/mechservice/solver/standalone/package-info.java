/**
 * The command line of a model in a JAR, for machines that have Java and nothing else.
 *
 * <p>{@link org.mechservice.solver.standalone.Standalone} runs one model once: it reads the
 * options, writes the results as CSV and the report as text or JSON. It has two entry points. The
 * main class generated into a standalone JAR joins one model with one integrator, so that the JAR
 * contains only the classes that these reach. {@link org.mechservice.solver.standalone.RunModel}
 * runs a model JAR on a class path with the runtime JAR; it finds the model by the JAR's manifest
 * and can use every integrator.
 *
 * <p>The client and the {@code mech} command write their files with the same classes of {@code
 * solver.text}, so the results have the same bytes in all modes of execution.
 *
 * <p>The package depends on {@code solver.api}, {@code solver.simulation} and {@code solver.text}.
 */
package org.mechservice.solver.standalone;
