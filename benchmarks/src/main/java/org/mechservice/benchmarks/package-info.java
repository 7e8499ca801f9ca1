/**
 * Measures what the solver costs: time and memory per step of the integrators beside Hipparchus,
 * and per evaluation of the equations of motion. {@link org.mechservice.benchmarks.Benchmarks} runs
 * all of it.
 */
@NullMarked
package org.mechservice.benchmarks;

import org.jspecify.annotations.NullMarked;
