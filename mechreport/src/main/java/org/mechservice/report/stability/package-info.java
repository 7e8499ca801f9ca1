/** The suite of stiff and extreme scenes. */
@NullMarked
package org.mechservice.report.stability;

import org.jspecify.annotations.NullMarked;
