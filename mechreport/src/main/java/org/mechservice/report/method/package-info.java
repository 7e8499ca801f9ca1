/** The methods a scene can be run with, as the service builds them. */
@NullMarked
package org.mechservice.report.method;

import org.jspecify.annotations.NullMarked;
