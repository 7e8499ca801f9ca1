/**
 * Which method, which tolerance, how sure: error against run time of a model, and the suite of
 * stiff and extreme scenes.
 *
 * <p>The service builds the models; they run here, for timing. {@link
 * org.mechservice.report.ModelReport} is the way in.
 */
@NullMarked
package org.mechservice.report;

import org.jspecify.annotations.NullMarked;
