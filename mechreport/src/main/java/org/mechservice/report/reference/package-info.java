/** Codes of high order that make reference solutions, independent of the product's integrators. */
@NullMarked
package org.mechservice.report.reference;

import org.jspecify.annotations.NullMarked;
