/** JARs with reproducible bytes, and what goes into them. */
@NullMarked
package org.mechservice.sim.build.jar;

import org.jspecify.annotations.NullMarked;
