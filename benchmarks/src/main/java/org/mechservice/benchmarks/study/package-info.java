/** Stability measured: one property a study, each with its page, its diagram and its figures. */
@NullMarked
package org.mechservice.benchmarks.study;

import org.jspecify.annotations.NullMarked;
