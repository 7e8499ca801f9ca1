/**
 * The interface between a generated model and the solver that runs it.
 *
 * <p>{@link Model} is the main type. A model supplies its equations in explicit or residual form.
 * The other types describe the settings of a run, its control, its rows, its notes and its report.
 *
 * <p>The package uses only types of java.base. A model JAR is compiled against this package alone.
 * In local mode the client and the fetched solver share this package and the form in which the
 * fetched classes are packed. {@link Model#API_VERSION} is the version of both: a JAR built for
 * another version is refused before it is unpacked.
 */
package org.mechservice.solver.api;
