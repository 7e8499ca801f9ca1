/**
 * Studies of stability: one property of the methods each, with page, diagram and figures as CSV.
 *
 * <p>A {@link org.mechservice.benchmarks.study.MethodStudy} measures on the scenes of a {@link
 * org.mechservice.benchmarks.study.StudyContext} and writes a {@link
 * org.mechservice.benchmarks.study.StudyPage}. The studies are growth per period, drift over many
 * periods, noise in forces, stiffness and damping, singular positions, inconsistent starts,
 * condition of the mass matrix, Newton's iteration, the automatic choice, and equality of remote
 * and local runs. {@link org.mechservice.benchmarks.study.ChainWithLoop}, {@link
 * org.mechservice.benchmarks.study.StepsOfChains} and {@link
 * org.mechservice.benchmarks.study.WarmLoops} print figures for the page on loops at scale. Scenes
 * made for studies are {@link org.mechservice.benchmarks.study.BarChain}, {@link
 * org.mechservice.benchmarks.study.FourBarInLine}, {@link
 * org.mechservice.benchmarks.study.Oscillator} and {@link
 * org.mechservice.benchmarks.study.TransientStiffness}.
 */
@NullMarked
package org.mechservice.benchmarks.study;

import org.jspecify.annotations.NullMarked;
