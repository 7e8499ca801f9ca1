/**
 * Many runs of one model: the points at which it runs, what is kept of each run, and the table of
 * all of them.
 *
 * <p>{@link org.mechservice.study.PointModel} is a model that runs with many values of its
 * parameters: its code is generated once, each thread works on an instance of its own, and of each
 * run only {@link org.mechservice.study.Reduction}s of its columns remain, such as a last value or
 * a mean.
 */
@NullMarked
package org.mechservice.study;

import org.jspecify.annotations.NullMarked;
