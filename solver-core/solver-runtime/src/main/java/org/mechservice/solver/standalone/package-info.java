/**
 * The command line of a model in a JAR, for machines that have Java and nothing else.
 *
 * <p>{@link org.mechservice.solver.standalone.Standalone} runs one model once: it reads the
 * options, writes the results as CSV and the report as text or JSON. There are two ways into it.
 * The main class that is generated into a standalone JAR joins one model with one integrator, so
 * that the JAR carries only what these reach. {@link org.mechservice.solver.standalone.RunModel}
 * serves a model JAR that stands beside the runtime JAR on a class path; it finds the model by the
 * JAR's manifest and has every integrator at hand.
 *
 * <p>The client and the {@code mech} command write their files with the same classes of {@code
 * solver.text}, so the bytes of the results agree wherever a run took place.
 *
 * <p>The package depends on {@code solver.api}, {@code solver.simulation} and {@code solver.text}.
 */
package org.mechservice.solver.standalone;
