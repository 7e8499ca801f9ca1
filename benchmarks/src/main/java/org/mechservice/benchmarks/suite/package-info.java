/** The integrators alone, on problems with verified solutions, with peers in the same run. */
@NullMarked
package org.mechservice.benchmarks.suite;

import org.jspecify.annotations.NullMarked;
