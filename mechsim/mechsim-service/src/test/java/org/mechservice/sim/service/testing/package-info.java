/** Solvers for tests of hosts and servers. */
@NullMarked
package org.mechservice.sim.service.testing;

import org.jspecify.annotations.NullMarked;
