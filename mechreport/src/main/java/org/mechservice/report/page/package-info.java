/**
 * The HTML page of a report.
 *
 * <p>{@link org.mechservice.report.page.ScenePage} puts the page together from the findings: the
 * recommendation and the verdict on stiffness ({@link org.mechservice.report.page.Advice}), the
 * warnings ({@link org.mechservice.report.page.ReliabilityWarnings}), the diagrams ({@link
 * org.mechservice.report.page.LogLogChart}), the tables per method ({@link
 * org.mechservice.report.page.MethodTables}, {@link org.mechservice.report.page.ToleranceTable},
 * {@link org.mechservice.report.page.LimitsTable}, {@link
 * org.mechservice.report.page.SpectrumTable}), and the conditions of the measurement ({@link
 * org.mechservice.report.page.HowMeasured}). {@link org.mechservice.report.page.PageFrame} is the
 * frame of every page, with style and script inside the file; {@link
 * org.mechservice.report.page.SolverChart} is a diagram for pages that are not about one scene.
 */
@NullMarked
package org.mechservice.report.page;

import org.jspecify.annotations.NullMarked;
