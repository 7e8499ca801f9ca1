/** Tests of the processes in which models are read and built. */
@NullMarked
package org.mechservice.sim.service.setup;

import org.jspecify.annotations.NullMarked;
