/**
 * The points of a study: which values its factors take.
 *
 * <p>A {@link org.mechservice.study.design.Spread} says what values one factor may take: a range, a
 * list or a distribution, which maps the unit interval to values by the inverse of its cumulative
 * probability. A {@link org.mechservice.study.design.Design} chooses the points: every combination,
 * the lists side by side, Sobol's sequence, a Latin hypercube, or independent draws.
 *
 * <p>Every point is a function of its number and the seed alone, so that a study can be divided,
 * interrupted and continued anywhere with the same points.
 */
@NullMarked
package org.mechservice.study.design;

import org.jspecify.annotations.NullMarked;
