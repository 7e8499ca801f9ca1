/** JARs with reproducible bytes, and what goes into them. */
@NullMarked
package org.mechservice.sim.jar;

import org.jspecify.annotations.NullMarked;
