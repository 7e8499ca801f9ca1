/** The integrators alone, on problems with verified solutions. */
@NullMarked
package org.mechservice.report.suite;

import org.jspecify.annotations.NullMarked;
