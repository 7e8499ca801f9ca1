/**
 * Identification: the values of parameters for which outputs of a model agree best with measured
 * ones.
 *
 * <p>{@link org.mechservice.study.identify.Measurements} reads a table of measured values with
 * their standard deviations and makes weighted residuals of them and of a model's runs; {@link
 * org.mechservice.study.identify.Identification} fits the parameters by Levenberg-Marquardt and
 * says how well the data determine each: standard deviations, confidence intervals by Student's t,
 * correlations, and in words the combinations that the data do not determine at all.
 */
@NullMarked
package org.mechservice.study.identify;

import org.jspecify.annotations.NullMarked;
