/**
 * The paper's tables, measured again: Rodríguez et al., Multibody System Dynamics 10 (2003).
 *
 * <p>{@link org.mechservice.benchmarks.paper.PaperReport} measures set-up times, sizes and run
 * times of the paper's scenes, the ratio of explicit to implicit cost at equal error ({@link
 * org.mechservice.benchmarks.paper.EqualErrors}), and the damping from which the implicit method
 * wins. {@link org.mechservice.benchmarks.paper.PaperFigures} holds the printed figures, and {@link
 * org.mechservice.benchmarks.paper.PaperPage} writes both side by side.
 *
 * <p>The paper's machine was a Pentium of 400 to 500 MHz: its times are a floor, its sizes and the
 * ratios between its methods are what ours are compared with. Our times are medians of several runs
 * whose rows go nowhere ({@link org.mechservice.benchmarks.paper.DiscardedRows}).
 */
@NullMarked
package org.mechservice.benchmarks.paper;

import org.jspecify.annotations.NullMarked;
