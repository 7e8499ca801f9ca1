/**
 * The library in process: read, build, simulate and analyse a model without a server. It runs the
 * same generator and the same solver as the service, so that its results are the same bits.
 *
 * <p>{@link org.mechservice.library.MechanismBuilder} builds a model in code: a document whose
 * elements ({@link org.mechservice.library.BuiltElement}) the grammar checks one by one, and which
 * the reader checks as a whole, so that nothing of the language is written twice.
 *
 * <p>Everything else starts at {@link org.mechservice.library.MechModel}: it is read from a file or
 * a text, takes values of its parameters, and gives a run, its rows, an analysis, the report on its
 * methods or the compiled JAR. {@code MechmlFile} keeps what it was read from, with the classes of
 * {@code ForceFiles}; {@code ModelCode} generates and compiles its code. No CORBA class is on the
 * path. A program that is to run on a server instead uses the same verbs of {@code mechclient}.
 */
@NullMarked
package org.mechservice.library;

import org.jspecify.annotations.NullMarked;
