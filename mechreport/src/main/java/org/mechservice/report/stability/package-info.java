/** The suite of stiff and extreme scenes: every case meets its bound or ends with a message. */
@NullMarked
package org.mechservice.report.stability;

import org.jspecify.annotations.NullMarked;
