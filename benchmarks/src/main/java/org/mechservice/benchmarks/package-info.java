/**
 * Measurements of the product that no user needs.
 *
 * <p>{@link org.mechservice.benchmarks.Benchmarks} runs the JMH benchmarks: time and memory per
 * step of the integrators beside Hipparchus ({@link org.mechservice.benchmarks.StepOverhead},
 * {@link org.mechservice.benchmarks.StepMemory}), and per evaluation of the equations of motion
 * ({@link org.mechservice.benchmarks.Evaluations}, {@link
 * org.mechservice.benchmarks.GeneratedCode}, {@link org.mechservice.benchmarks.ChainGrowth}).
 * {@link org.mechservice.benchmarks.EvaluationCost} and {@link
 * org.mechservice.benchmarks.FirstEvaluations} write pages of docs/reports. {@link
 * org.mechservice.benchmarks.MethodReports} writes the pages that are evidence about the methods;
 * they are made in {@code suite}, {@code paper} and {@code study}. What compares the product with
 * other programs is in {@code peer}, but for {@link org.mechservice.benchmarks.LargeDiffusion},
 * which a script runs beside CVODE.
 */
@NullMarked
package org.mechservice.benchmarks;

import org.jspecify.annotations.NullMarked;
