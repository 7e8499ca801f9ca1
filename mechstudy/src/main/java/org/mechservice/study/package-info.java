/**
 * Many runs of one model: the points at which it runs, what is kept of each run, and the table of
 * all of them.
 *
 * <p>{@link org.mechservice.study.PointModel} is a model that runs with many values of its
 * parameters: its code is generated once, each thread works on an instance of its own, and of each
 * run only {@link org.mechservice.study.Reduction}s of its columns remain, such as a last value or
 * a mean.
 *
 * <p>{@code design} reads a study and places its points, {@code run} runs them on threads, hosts or
 * in parts and writes the table, {@code gradient} computes derivatives of what remains, {@code
 * optimise} and {@code identify} search for the best point. A {@link
 * org.mechservice.study.PointEvaluation} is all that a search knows of a model.
 */
@NullMarked
package org.mechservice.study;

import org.jspecify.annotations.NullMarked;
