/**
 * Reports on the methods for a scene: which method, which tolerance, and how reliable the answer
 * is.
 *
 * <p>{@link org.mechservice.report.ModelReport} makes the page of {@code mech report}. It has the
 * model built with every method that fits ({@code method}; by the library in process or by a
 * server), makes a reference ({@code reference}), runs every method at every tolerance in this
 * process and times it ({@code measure}), and writes the page ({@code page}) from the {@link
 * org.mechservice.report.measure.SceneFindings}. The suite of stiff and extreme scenes behind
 * {@code mech stability} is in {@code stability}.
 */
@NullMarked
package org.mechservice.report;

import org.jspecify.annotations.NullMarked;
