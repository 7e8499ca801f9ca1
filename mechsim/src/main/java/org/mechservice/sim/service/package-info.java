/** The servants behind MechSim, IMechSimRemote and ResultCursor. */
@NullMarked
package org.mechservice.sim.service;

import org.jspecify.annotations.NullMarked;
