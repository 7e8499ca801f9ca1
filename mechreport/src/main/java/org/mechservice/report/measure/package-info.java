/** Error, cost and spectrum of runs, measured. */
@NullMarked
package org.mechservice.report.measure;

import org.jspecify.annotations.NullMarked;
