/**
 * What runs a model from its own JAR without any library: the command line, the CSV writer, the
 * report as text and JSON. The client and the command line write the same files with the same
 * classes, so that the bytes agree wherever a run took place.
 */
package org.mechservice.solver.standalone;
