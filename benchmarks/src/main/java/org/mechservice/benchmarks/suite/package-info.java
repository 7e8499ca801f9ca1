/**
 * The integrators alone, on problems with verified solutions, beside those of other libraries.
 *
 * <p>{@link org.mechservice.benchmarks.suite.ProblemFile} is a problem of {@code problems.json}:
 * expressions ({@link org.mechservice.benchmarks.suite.Formula}), start, and the end to 25 digits.
 * {@link org.mechservice.benchmarks.suite.SuiteRunner} runs our integrators, {@link
 * org.mechservice.benchmarks.suite.HipparchusRunner} those of Hipparchus on the same {@link
 * org.mechservice.benchmarks.suite.SuiteEquations}, and {@link
 * org.mechservice.benchmarks.suite.PythonIntegrators} those of SciPy and SUNDIALS where Python has
 * them. {@link org.mechservice.benchmarks.suite.SuiteReport} writes page and figures, {@link
 * org.mechservice.benchmarks.suite.EqualErrorRatios} those of the stiff methods beside CVODE and
 * IDA, on further problems, too.
 */
@NullMarked
package org.mechservice.benchmarks.suite;

import org.jspecify.annotations.NullMarked;
