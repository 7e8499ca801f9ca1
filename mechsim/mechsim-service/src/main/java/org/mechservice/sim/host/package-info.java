/** A simulation host: the place MechSims live in, and its process. */
@NullMarked
package org.mechservice.sim.host;

import org.jspecify.annotations.NullMarked;
