/**
 * Diagrams of results: {@code mech plot}.
 *
 * <p>{@link org.mechservice.view.plot.StoredResult} reads result files with the units beside them.
 * {@link org.mechservice.view.plot.PlotRequest} chooses columns by name, by wildcard or by itself,
 * and reads them in one pass; {@code ThinnedRows} keeps the extreme rows of a file of any length,
 * so that peaks stay. The outcome is a {@link org.mechservice.view.plot.Plot}: panels, one for each
 * unit, over a common horizontal axis.
 *
 * <p>{@link org.mechservice.view.plot.PlotPicture} draws it with ticks of {@code Ticks}; {@link
 * org.mechservice.view.plot.PlotPage} puts it into a page of its own, with zoom and values at the
 * cursor by uPlot, which the page contains.
 *
 * <p>{@link org.mechservice.view.plot.DifferencePlot} makes the diagram of a comparison: {@code
 * mech compare -o}.
 */
@NullMarked
package org.mechservice.view.plot;

import org.jspecify.annotations.NullMarked;
