/**
 * Result files in the formats that other programs read: CSV, TSV, MAT, JSON and Parquet; and the
 * comparison of two results.
 *
 * <p>{@link org.mechservice.result.ResultFormat} lists the formats, finds the one of a file name
 * and opens its writer for a {@link org.mechservice.solver.text.ResultFile}, which gives the file
 * its name when it is complete. Every format holds the same columns, in the same order, with the
 * same units and the same bits of every number. Writers use bounded memory: a row is in the file,
 * in a scratch file beside it, or in a block of fixed size.
 *
 * <p>{@link org.mechservice.result.SignalTable} reads a file of any of these formats, whole, into
 * memory. {@link org.mechservice.result.ResultComparison} compares two tables signal by signal.
 *
 * <p>The package needs the solver's interfaces only, so that clients, the command line and the
 * library in process can all use it. MAT files are written by mfl-core. Parquet files hold nothing
 * but 64-bit numbers here; their small subset of the format is written by this package, since the
 * published writers for Java 17 need the classes of Hadoop.
 */
@NullMarked
package org.mechservice.result;

import org.jspecify.annotations.NullMarked;
