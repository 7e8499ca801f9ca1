/**
 * Columns of results beside the state: reactions and multipliers, forces, drives, momenta,
 * constraint residuals, outputs of the model file.
 *
 * <p>{@link org.mechservice.solver.analysis.column.FurtherColumns} composes the groups that a run
 * asks for. Each kind is a class of its own behind {@code ColumnValues}, so that a standalone JAR
 * carries only the columns of its scene. A kind names its columns with their units once, and writes
 * their values in a given state into the row of the run.
 *
 * <p>Generated models compute outputs themselves ({@code WrittenOutputs}); all other columns are
 * computed from the equations of {@code analysis.equation}.
 */
package org.mechservice.solver.analysis.column;
