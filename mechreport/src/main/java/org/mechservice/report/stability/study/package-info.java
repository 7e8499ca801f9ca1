/** Stability measured: one property a study, each with its page, its diagram and its figures. */
@NullMarked
package org.mechservice.report.stability.study;

import org.jspecify.annotations.NullMarked;
