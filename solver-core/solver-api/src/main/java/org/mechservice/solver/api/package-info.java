/**
 * What a generated model and whoever runs it share: the model's equations, the settings of a run,
 * its control, its rows and its report.
 *
 * <p>Only types of java.base occur here. A model JAR is compiled against this package alone, and in
 * local mode it is, with the form in which fetched classes are packed, what the client and the
 * fetched solver have in common, so {@link Model#API_VERSION} names the state of both: a JAR built
 * for another version is refused before it is unpacked.
 */
package org.mechservice.solver.api;
