/**
 * Studies on a cluster that runs Apache Spark.
 *
 * <p>{@link org.mechservice.spark.SparkStudy} is the program that {@code spark-submit} starts, or a
 * plain Java process with Spark on its class path. Its driver reads the study and divides the
 * points into chunks of about a second, which {@link org.mechservice.spark.SparkEngine} gives to
 * the executors in waves: each wave is as large as the runs of the wave before were fast.
 *
 * <p>The files of the study are broadcast, and each executor reads them and generates the model
 * once. An executor writes the rows of a chunk to a file of its own in the job's file system
 * ({@link org.mechservice.spark.RowFiles}), which may be any that Hadoop has a connector for. A
 * chunk whose executor is lost is computed again. The driver joins the files to the table that a
 * single process would have written, byte by byte. Files of a driver that has ended are used by the
 * next one.
 */
@NullMarked
package org.mechservice.spark;

import org.jspecify.annotations.NullMarked;
