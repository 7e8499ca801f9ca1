/** What a mechanism is, seen before anything is generated from it: topology, freedoms, findings. */
@NullMarked
package org.mechservice.sim.scene;

import org.jspecify.annotations.NullMarked;
