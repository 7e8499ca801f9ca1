/** Tests of hosts. */
@NullMarked
package org.mechservice.sim.host;

import org.jspecify.annotations.NullMarked;
