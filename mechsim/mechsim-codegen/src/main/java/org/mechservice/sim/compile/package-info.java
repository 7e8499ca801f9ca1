/** From the source of a model to its class file, in memory. */
@NullMarked
package org.mechservice.sim.compile;

import org.jspecify.annotations.NullMarked;
